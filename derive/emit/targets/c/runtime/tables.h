#define COORDINATES @coordinates@
#define PARAMETERS @parameters@
#define CONTACTS @contacts@
#define SIDES @sides@         /* frictions; one without any */
#define LIFTS @lifts@         /* contacts that open */
#define SLIDES @slides@        /* frictions */
#define HOLDS @holds@         /* frictions that hold where nothing slides */
#define LAYERS @layers@        /* exponentials of the friction laws */
#define TURNINGS @turnings@      /* torsion springs whose turning is counted */
#define CLOCK @clock@         /* whether the last coordinate is the phase of a clock, whose rate is given */
#define SPRINGS @springs@       /* along lines */

/* Whether a coordinate is an angle. */
static const int ANGLES[] = {@angles@};

/* Of each contact whether its law has no values beyond its border, and whether it goes with the place of a state at rest. */
static const int ROOTED[] = {@rooted@}, OF_PLACE[] = {@of_place@};

/* Of each friction its contact, and its number among those that hold; -1 of one that doesn't. */
static const struct {
    int contact, row;
} RUBBING[] = {@rubbing@};

/* Borders that are events: the number of a mode that each changes, and of friction that holds its number among these. */
enum { LIFT, SLIP, AHEAD, BEHIND };
static const struct {
    int kind, place, row;
    const char *contact;
} EVENT_BORDERS[] = {@event_borders@};

/* Functions of the library, given the state, accelerations, parameters and numbers of the mode. Not 0: they have no result there. */

@adapters@