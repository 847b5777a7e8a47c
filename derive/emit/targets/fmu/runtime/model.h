/*
 * @header@
 *
 * What the motion and the functions of FMI know of the model.
 */
#include "@library@.h"

#include <math.h>

#define TOKEN "@token@"
#define COORDINATES @coordinates@
#define PARAMETERS @parameters@
#define UNITS @units@         /* of measure: quantities that are 1 inside */
#define LIFTS @lifts@         /* whether the contact opens */
#define SLIDES @slides@        /* whether there is friction */
#define HOLDS @holds@         /* whether friction holds the mass where nothing slides */
#define LAYERS @layers@        /* exponentials of the friction law */
#define TURNINGS @turnings@      /* torsion springs whose turning is counted */
#define CLOCK @clock@         /* whether the last coordinate is the phase of a clock, whose rate is given */
#define ROOTED @rooted@        /* whether the contact law has no values beyond its border */
#define OUTPUTS @outputs@       /* forces, energy and power */
#define SPRINGS @springs@       /* along lines */

/* Parameters, then units of measure, as they are given; inside, a number is divided by powers of the units of measure. */
struct quantity {
    const char *name;
    double start, low, high;
    int flows; /* whether it may change within a step of Model Exchange */
    double factor; /* one of its unit in SI */
    double powers[3];
};

static const struct quantity QUANTITIES[] = {
    @quantities@,
};

/* The powers of coordinates, and of time. */
static const double POWERS[][3] = {@powers@};

/* Whether a coordinate is an angle. */
static const int ANGLES[] = {@angles@};

/* The powers of outputs. */
static const double OUTPUT_POWERS[][3] = {@output_powers@};

/* Functions of the library, given the state, accelerations, parameters and numbers of the mode. Not 0: they have no result there. */

@adapters@