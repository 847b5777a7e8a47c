/*
 * @header@
 *
 * What the motion and the functions of FMI know of the model.
 */
#include "@library@.h"

#include <math.h>

#define TOKEN "@token@"
#define UNITS @units@         /* of measure: quantities that are 1 inside */
#define OUTPUTS @outputs@       /* forces, energy and power */

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

/* The powers of outputs. */
static const double OUTPUT_POWERS[][3] = {@output_powers@};

// @tables@
// @adapters@
