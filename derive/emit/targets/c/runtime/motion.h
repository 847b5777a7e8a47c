/*
 * The motion between events: modes in which the field is smooth, the borders at which they end, and steps that end there.
 *
 * All numbers are dimensionless. Tolerances are numbers beside 1, in units of the motion's own:
 * powers of four, 1 between 1/32 and 32, which are taken from the numbers of its start as Python
 * takes them (spragsym.motion.scales).
 *
 * A mode is: for each contact whether it is closed (1, 0), for each friction the sign of its sliding speed (1, -1; 0 while it
 * holds), for each exponential of a friction law whether it is felt (1, 0), for each torsion spring the way on
 * which its turning is counted (1, -1). Each has a border, and the force of friction that holds has two, its limits; the clearance of
 * a border is positive within the mode. A mode is left GAP beyond its border: two crossings are never closer than 2 GAP, so that
 * rounding makes no chatter.
 */
#include <math.h>
#include <string.h>

enum {
    STATES = 2 * COORDINATES,
    EVENTS = LIFTS + SLIDES + 2 * HOLDS, /* borders whose crossings are events */
    INDICATORS = EVENTS + TURNINGS,      /* borders that an importer watches; exponentials are always felt there */
    BORDERS = INDICATORS + LAYERS,
    NEAR = CONTACTS + SIDES, /* the first exponential of a mode */
    WAY = NEAR + LAYERS,     /* and the first torsion spring */
    MODES = WAY + TURNINGS,
    WIDE = STATES + PARAMETERS, /* derivatives of one number by all */
    STAGES = 7,
    DONE = -1,
    STUCK = -2
};

#define GAP 1e-12
/* Minus the exponent beyond which an exponential is left out, and how much sooner it is taken in again. */
#define REACH 36.0
#define WIDTH 5.0
/* Sliding speeds up to this, in units of theirs, are 0 where friction holds. */
#define STILL (2.0 * GAP)
/* The clearance of what is no border of the mode. */
#define FREE 1.0
#define MOST_STEPS 10000000L
/* The least step and the first one, in units of time; which share of a number's unit counts beside
 * its size. */
#define LEAST_STEP 1e-15
#define FIRST_STEP 1e-3
#define BESIDE 1e-3
/* Binary digits between one unit and the next, and beyond which a unit is not 1. */
#define DIGITS 2
#define COMMON 5
#define TURN 6.283185307179586

typedef struct {
    double p[PARAMETERS + 1];
    double mode[MODES];
    int borders; /* how many are watched: all, or those of an importer */
    double tolerance;
    /* units of the state, of time and of the borders' levels */
    double unit[STATES], second, level[BORDERS + 1];
} Motion;

typedef struct {
    double state[STATES];
    double rate[STATES];
    double clearance[BORDERS + 1];
    double change[BORDERS + 1]; /* of the clearances, in time */
} Point;

/* A contact law with a root has no values beyond its border: its mode is left before it. */
static double shift(const Motion *it, int border) { return ROOTED[EVENT_BORDERS[border].place] ? 2.0 * GAP * it->level[border] : 0.0; }

/* Rates of a state; where the mode has no continuation, as beyond a root, those of the field everywhere. Not 0: there are none. */
static int rates(const Motion *it, const double *state, double *rate) {
    for (int i = 0; i < COORDINATES; i++) {
        rate[i] = state[COORDINATES + i];
    }
    return regime_rhs(state, it->p, it->mode, rate + COORDINATES) && rhs(state, it->p, rate + COORDINATES);
}

/* Clearances of a point whose rates are known. */
static int look(const Motion *it, Point *at) {
    const double *mode = it->mode, *acceleration = at->rate + COORDINATES;
    double level[NEAR], change[NEAR];
    int k;
    if (borders(at->state, it->p, level) || border_rates(at->state, acceleration, it->p, change)) {
        return 1;
    }
#if HOLDS
    /* Beyond a root there is no force that holds: there the contact's border is crossed. */
    double margin[2 * HOLDS], slope[3 * HOLDS * WIDE];
    int sticks = 0;
    for (int i = CONTACTS; i < NEAR; i++) {
        sticks |= mode[i] == 0.0;
    }
    sticks = sticks && !grip(at->state, it->p, mode, margin) && !grip_slopes(at->state, it->p, mode, slope);
#endif
    for (k = 0; k < EVENTS; k++) {
        const int kind = EVENT_BORDERS[k].kind, place = EVENT_BORDERS[k].place;
        const double sign = (kind == LIFT) ? 1.0 - 2.0 * mode[place] : mode[place];
        at->clearance[k] = FREE;
        at->change[k] = 0.0;
        if (kind <= SLIP) {
            const double off = (kind == LIFT) ? shift(it, k) : 0.0;
            at->clearance[k] = sign != 0.0 ? sign * (level[place] + off) / it->level[k] + GAP : FREE;
            at->change[k] = sign * change[place] / it->level[k];
        }
#if HOLDS
        if (kind > SLIP && sticks && sign == 0.0) {
            const int row = EVENT_BORDERS[k].row, limit = kind - AHEAD;
            at->clearance[k] = margin[2 * row + limit] / it->level[k] + GAP;
            for (int j = 0; j < STATES; j++) {
                at->change[k] += slope[(3 * row + 1 + limit) * WIDE + j] * at->rate[j] / it->level[k];
            }
        }
#endif
    }
#if TURNINGS
    if (turning_borders(at->state, it->p, mode, at->clearance + k) ||
        turning_rates(at->state, acceleration, it->p, mode, at->change + k)) {
        return 1;
    }
    for (int i = 0; i < TURNINGS; i++) {
        at->clearance[k] = at->clearance[k] / it->level[k] + GAP;
        at->change[k] /= it->level[k];
        k++;
    }
#endif
#if LAYERS
    if (it->borders > k) {
        double depth[LAYERS], deeper[LAYERS];
        if (layers(at->state, it->p, mode, depth) || layer_rates(at->state, acceleration, it->p, mode, deeper)) {
            return 1;
        }
        for (int i = 0; i < LAYERS; i++) {
            const double near = mode[NEAR + i], sign = 1.0 - 2.0 * near;
            at->clearance[k] = sign * (depth[i] - REACH - WIDTH * near);
            at->change[k++] = sign * deeper[i];
        }
    }
#endif
    return 0;
}

#if HOLDS
#ifndef INLINE
#define INLINE static
#endif
// @transition@

/* The largest share of its limit that a friction of some lacks for a mode to agree with its own accelerations. */
static double lacking(const Motion *it, const double *state, const double *mode, const int *some) {
    double margin[2 * HOLDS], pull[COORDINATES], change[NEAR] = {0.0}, largest = 0.0;
    const int none = regime_rhs(state, it->p, mode, pull) || border_rates(state, pull, it->p, change);
    if (grip(state, it->p, mode, margin)) {
        return INFINITY;
    }
    for (int i = 0; i < SIDES; i++) {
        if (some[i]) {
            const double *own = margin + 2 * RUBBING[i].row, rate = none ? 0.0 : change[CONTACTS + i];
            largest = fmax(largest, lacks(mode[CONTACTS + i], own[0], own[1], rate));
        }
    }
    return largest;
}

/* By how much the accelerations of a mode differ from others: D' M D of the difference D. */
static double differs(const Motion *it, const double *state, const double *mode, const double *others) {
    double pull[COORDINATES], mass[COORDINATES * COORDINATES], sum = 0.0;
    if (regime_rhs(state, it->p, mode, pull) || mass_matrix(state, it->p, mass)) {
        return INFINITY;
    }
    for (int i = 0; i < COORDINATES; i++) {
        for (int j = 0; j < COORDINATES; j++) {
            sum += (pull[i] - others[i]) * mass[i * COORDINATES + j] * (pull[j] - others[j]);
        }
    }
    return sum;
}

/* The sides of some frictions that hold, by the rule. Not 0: the mode has no accelerations. */
static int settled(Motion *it, const double *state, const int *some, const double *before) {
    double mode[MODES], found[MODES] = {0.0}, pull[COORDINATES] = {0.0}, lack = INFINITY, change = INFINITY;
    int count = 0, most = 1, fewest = 0;
    for (int i = 0; i < SIDES; i++) {
        count += some[i];
        most *= some[i] ? 3 : 1;
    }
    if (before && regime_rhs(state, it->p, before, pull)) {
        return 1;
    }
    for (int slips = 0; slips <= count && (lack > 0.0 || slips == fewest); slips++) {
        for (int code = 0; code < most; code++) {
            int rest = code, sliding = 0;
            memcpy(mode, it->mode, sizeof mode);
            for (int i = SIDES - 1; i >= 0; i--) {
                if (some[i]) {
                    const int side = rest % 3; /* none, belt ahead, mass ahead */
                    rest /= 3;
                    mode[CONTACTS + i] = (side == 2) ? -1.0 : side;
                    sliding += side > 0;
                }
            }
            if (sliding != slips) {
                continue;
            }
            const double own = lacking(it, state, mode, some), differing = own > 0.0 ? 0.0 : differs(it, state, mode, pull);
            if (displaces(slips, own, differing, fewest, lack, change)) {
                fewest = slips;
                lack = own;
                change = differing;
                memcpy(found, mode, sizeof found);
            }
        }
    }
    if (lack < INFINITY) {
        memcpy(it->mode, found, sizeof found);
        return 0;
    }
    return 1;
}

/* The sides where frictions come to a border: those that stick and those that hardly slide may begin and end to stick with the one
 * that came. */
static int hold(Motion *it, const double *state, int came, const double *before) {
    double level[NEAR];
    int some[SIDES] = {0};
    if (borders(state, it->p, level)) {
        return 1;
    }
    for (int k = 0; k < EVENTS; k++) {
        const int place = EVENT_BORDERS[k].place;
        if (EVENT_BORDERS[k].kind == SLIP && EVENT_BORDERS[k].row >= 0) {
            some[place - CONTACTS] = place == came || it->mode[place] == 0.0 || fabs(level[place]) <= STILL * it->level[k];
        }
    }
    return settled(it, state, some, before);
}
#endif

/* Brings sliding speeds to 0 where friction begins to hold or ceases to: they are off by as much as a border is crossed late. */
static int stop(const Motion *it, const double *sides, double *state) {
#if HOLDS
    double level[NEAR], slope[3 * HOLDS * WIDE];
    int changes = 0;
    for (int i = 0; i < SIDES; i++) {
        const double now = it->mode[CONTACTS + i];
        changes |= now != sides[i] && now * sides[i] == 0.0;
    }
    if (!changes) {
        return 0;
    }
    if (grip_slopes(state, it->p, it->mode, slope)) {
        return 1;
    }
    for (int round = 0; round < SIDES; round++) {
        for (int i = 0; i < SIDES; i++) {
            const double now = it->mode[CONTACTS + i], *own = slope + 3 * RUBBING[i].row * WIDE;
            double size = 0.0;
            if (RUBBING[i].row < 0 || now * sides[i] != 0.0) {
                continue;
            }
            if (borders(state, it->p, level)) {
                return 1;
            }
            for (int j = COORDINATES; j < STATES; j++) {
                size += own[j] * own[j];
            }
            for (int j = COORDINATES; j < STATES; j++) {
                state[j] -= level[CONTACTS + i] * own[j] / size;
            }
        }
    }
#else
    (void)it;
    (void)sides;
    (void)state;
#endif
    return 0;
}

/* Enters the mode on the other side of a border. Not 0: there is none. */
static int cross(Motion *it, double *state, int border) {
    double *const mode = it->mode, before[MODES], *const sides = before + CONTACTS;
    memcpy(before, mode, sizeof before);
    if (border >= INDICATORS) {
        mode[NEAR + border - INDICATORS] = 1.0 - mode[NEAR + border - INDICATORS];
        return 0;
    }
    if (border >= EVENTS) {
        mode[WAY + border - EVENTS] *= -1.0;
#if HOLDS
        return hold(it, state, -1, before) || stop(it, sides, state); /* the torque may jump */
#else
        return 0;
#endif
    }
    const int place = EVENT_BORDERS[border].place;
    if (EVENT_BORDERS[border].kind == LIFT) {
        mode[place] = 1.0 - mode[place];
    } else if (EVENT_BORDERS[border].row < 0) {
        mode[place] *= -1.0;
    }
#if HOLDS
    int came = EVENT_BORDERS[border].row < 0 ? -1 : place;
    for (int i = 0; i < SIDES && EVENT_BORDERS[border].kind == LIFT; i++) {
        came = (RUBBING[i].contact == place && sides[i] == 0.0) ? CONTACTS + i : came;
    }
    if (came >= 0 && hold(it, state, came, before)) {
        return 1;
    }
#endif
    return stop(it, sides, state);
}

/* The mode of a state, which on a border may be on either side. */
static int mode_of(Motion *it, const double *state) {
    double level[NEAR];
    int some[SIDES] = {0}, still = 0;
    if (borders(state, it->p, level)) {
        return 1;
    }
    for (int i = 0; i < MODES; i++) {
        it->mode[i] = 1.0;
    }
    for (int k = 0; k < EVENTS; k++) {
        const int place = EVENT_BORDERS[k].place;
        if (EVENT_BORDERS[k].kind == LIFT) {
            it->mode[place] = (level[place] <= -shift(it, k)) ? 1.0 : 0.0;
        } else if (EVENT_BORDERS[k].kind == SLIP) {
            it->mode[place] = (level[place] >= 0.0) ? 1.0 : -1.0;
            some[place - CONTACTS] = EVENT_BORDERS[k].row >= 0 && fabs(level[place]) <= STILL * it->level[k];
            still |= some[place - CONTACTS];
        }
    }
#if TURNINGS
    double forward[TURNINGS], backward[TURNINGS], ways[MODES];
    for (int i = 0; i < MODES; i++) {
        ways[i] = -1.0;
    }
    if (turning_borders(state, it->p, it->mode, forward) || turning_borders(state, it->p, ways, backward)) {
        return 1;
    }
    for (int i = 0; i < TURNINGS; i++) {
        it->mode[WAY + i] = (forward[i] >= backward[i]) ? 1.0 : -1.0;
    }
#endif
#if LAYERS
    if (it->borders > INDICATORS) {
        double depth[LAYERS];
        if (layers(state, it->p, it->mode, depth)) {
            return 1;
        }
        for (int i = 0; i < LAYERS; i++) {
            it->mode[NEAR + i] = (depth[i] <= REACH) ? 1.0 : 0.0;
        }
    }
#endif
#if HOLDS
    return still && settled(it, state, some, NULL);
#else
    (void)still;
    return 0;
#endif
}

static double unit_near(double value) {
    if (!(value > 0.0 && isfinite(value)) || fabs(log2(value)) <= COMMON) {
        return 1.0;
    }
    return ldexp(1.0, DIGITS * (int)floor(log2(value) / DIGITS + 0.5));
}

/* The unit of time, and how far each coordinate goes in it: by its place, its rate, its
 * accelerations, and the way on which friction is used up. */
static double distances(const Motion *it, const double *state, double *ways) {
    double stiff = 0.0, damped = 0.0, fastest = 0.0, pull[COORDINATES] = {0.0}, rate, most = 0.0;
    for (int first = 0; first < 2; first++) {
        Motion one = *it;
        double moved[STATES], slope[COORDINATES * STATES];
        for (int i = 0; first && i < WAY; i++) {
            one.mode[i] = (i < CONTACTS && OF_PLACE[i]) ? one.mode[i] : 1.0; /* at rest */
        }
        if (rates(&one, state, moved) || regime_jacobian(state, it->p, one.mode, slope)) {
            continue;
        }
        for (int i = 0; i < COORDINATES; i++) {
            pull[i] = fmax(pull[i], fabs(moved[COORDINATES + i]));
            most = fmax(most, pull[i]);
            fastest = fmax(fastest, fabs(state[COORDINATES + i]));
            for (int j = 0; j < COORDINATES; j++) {
                if (ANGLES[i] == ANGLES[j]) {
                    stiff = fmax(stiff, fabs(slope[i * STATES + j]));
                    damped = fmax(damped, fabs(slope[i * STATES + COORDINATES + j]));
                }
            }
        }
    }
    rate = (stiff > 0.0) ? sqrt(stiff) : (damped > 0.0) ? damped :
        (fastest > 0.0)                                 ? most / fastest :
                                                          0.0;
    if (!(rate > 0.0 && isfinite(rate))) {
        rate = 1.0;
    }
    for (int i = 0; i < COORDINATES; i++) {
        ways[i] = fmax(fabs(state[i]), fmax(fabs(state[COORDINATES + i]) / rate, pull[i] / (rate * rate)));
    }
#if HOLDS
    for (int k = 0; k < EVENTS; k++) {
        Motion held = *it;
        double margins[2 * HOLDS], slopes[3 * HOLDS * WIDE];
        const int row = EVENT_BORDERS[k].row, limit = EVENT_BORDERS[k].kind - AHEAD;
        for (int i = 0; i < WAY; i++) {
            held.mode[i] = (i == EVENT_BORDERS[k].place) ? 0.0 : 1.0;
        }
        if (limit < 0 || grip(state, it->p, held.mode, margins) || grip_slopes(state, it->p, held.mode, slopes)) {
            continue;
        }
        const double margin = fabs(margins[2 * row + limit]), *slope = slopes + (3 * row + 1 + limit) * WIDE;
        for (int angle = 1; angle >= 0; angle--) {
            double steepest = 0.0;
            for (int i = 0; i < COORDINATES; i++) {
                steepest = (ANGLES[i] == angle) ? fmax(steepest, fabs(slope[i])) : steepest;
            }
            for (int i = 0; steepest > 0.0 && i < COORDINATES; i++) {
                ways[i] = (ANGLES[i] == angle) ? fmax(ways[i], margin / steepest) : ways[i];
            }
            if (angle && steepest * TURN > margin) {
                break; /* within a turn an angle uses it up, however far the others would have to go */
            }
        }
    }
#endif
    return 1.0 / rate;
}

/* Units of the motion from a state whose mode is known. */
static void measure(Motion *it, const double *state) {
    double ways[COORDINATES], largest = 0.0;
    it->second = unit_near(distances(it, state, ways));
#if SPRINGS
    double line[3 * SPRINGS];
    for (int i = 0; !geometry(state, it->p, line) && i < SPRINGS; i++) {
        largest = fmax(largest, line[3 * i + 2]); /* undeformed */
    }
#endif
    const int given = largest > 0.0;
    for (int i = 0; i < COORDINATES; i++) {
        largest = (given || ANGLES[i]) ? largest : fmax(largest, ways[i]);
    }
    for (int i = 0; i < COORDINATES; i++) {
        it->unit[i] = ANGLES[i] ? 1.0 : unit_near(largest);
        it->unit[COORDINATES + i] = it->unit[i] / it->second;
    }
    double size[BORDERS + 1] = {0.0};
    for (int trial = 0; trial < 2 * (SIDES + 1) * COORDINATES; trial++) {
        Motion one = *it;
        Point at;
        const int moved = trial % COORDINATES, held = trial / COORDINATES % (SIDES + 1), aside = trial / COORDINATES / (SIDES + 1);
        memset(&at, 0, sizeof at);
        for (int i = 0; i < COORDINATES; i++) {
            at.state[i] = state[i] + aside * it->unit[i];
        }
        at.state[COORDINATES + moved] = at.rate[moved] = it->unit[COORDINATES + moved];
        at.rate[COORDINATES + moved] = it->unit[COORDINATES + moved] / it->second;
        for (int i = 0; i < SIDES; i++) {
            one.mode[CONTACTS + i] = (held == i + 1) ? 0.0 : 1.0;
        }
        if ((held && RUBBING[held - 1].row < 0) || look(&one, &at)) {
            continue;
        }
        for (int k = 0; k < INDICATORS && k < one.borders; k++) {
            size[k] = fmax(size[k], fabs(at.change[k]) * it->second);
        }
    }
    for (int k = 0; k < INDICATORS; k++) {
        it->level[k] = unit_near(size[k]);
    }
}

/* Mode and units of a state from which a motion begins. */
static int begin(Motion *it, const double *state) {
    for (int i = 0; i < STATES; i++) {
        it->unit[i] = 1.0;
    }
    for (int k = 0; k <= BORDERS; k++) {
        it->level[k] = 1.0;
    }
    it->second = 1.0;
    if (mode_of(it, state)) {
        return 1;
    }
    measure(it, state);
    return mode_of(it, state);
}

/* One step by the method of Dormand and Prince, of fifth order, and its error in tolerances by the embedded one of fourth. */
static int step(const Motion *it, const Point *from, double h, Point *to, double *error) {
    static const double share[STAGES][STAGES - 1] = {
        {0.0},
        {1.0 / 5},
        {3.0 / 40, 9.0 / 40},
        {44.0 / 45, -56.0 / 15, 32.0 / 9},
        {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
        {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
        {35.0 / 384, 0.0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84},
    };
    static const double off[STAGES] = {
        71.0 / 57600,
        0.0,
        -71.0 / 16695,
        71.0 / 1920,
        -17253.0 / 339200,
        22.0 / 525,
        -1.0 / 40,
    };
    double slope[STAGES][STATES], sum = 0.0;
    memcpy(slope[0], from->rate, sizeof slope[0]);
    for (int stage = 1; stage < STAGES; stage++) {
        for (int i = 0; i < STATES; i++) {
            double moved = 0.0;
            for (int j = 0; j < stage; j++) {
                moved += share[stage][j] * slope[j][i];
            }
            to->state[i] = from->state[i] + h * moved;
        }
        if (rates(it, to->state, slope[stage])) {
            return 1;
        }
    }
    memcpy(to->rate, slope[STAGES - 1], sizeof to->rate);
    for (int i = 0; i < STATES; i++) {
        double wrong = 0.0;
        for (int j = 0; j < STAGES; j++) {
            wrong += off[j] * slope[j][i];
        }
        wrong *= h / (it->tolerance * (BESIDE * it->unit[i] + fmax(fabs(from->state[i]), fabs(to->state[i]))));
        sum += wrong * wrong;
    }
    *error = sqrt(sum / STATES);
    return !isfinite(*error) || look(it, to);
}

/* The least clearance of the borders that are watched. */
static double nearest(const Motion *it, const Point *at, int *border) {
    int found = 0;
    for (int k = 1; k < it->borders; k++) {
        if (at->clearance[k] < at->clearance[found]) {
            found = k;
        }
    }
    *border = found;
    return it->borders ? at->clearance[found] : 1.0;
}

/* How long ago a border was met where the field jumps; it is noticed GAP behind. 0 where that is not told. */
static double lateness(const Motion *it, const Point *at, int border) {
    const double late = (GAP - at->clearance[border]) / -at->change[border];
    const int holds = border < EVENTS && EVENT_BORDERS[border].kind != LIFT && EVENT_BORDERS[border].row >= 0;
    return (holds && late > 0.0 && late < it->second) ? late : 0.0;
}

/* Passes a border, on the other side of which the mode is told: where friction begins to hold or ceases to, from where the border
 * was met, which is GAP ahead. */
static int pass(Motion *it, Point *at, int border) {
    const double late = lateness(it, at, border);
    double error, sides[SIDES];
    Point met, behind;
    const int back = late > 0.0 && !step(it, at, -late, &met, &error);
    memcpy(sides, it->mode + CONTACTS, sizeof sides);
    if (cross(it, at->state, border)) {
        return 1;
    }
    if (back && memcmp(sides, it->mode + CONTACTS, sizeof sides) != 0) {
        if (stop(it, sides, met.state) || rates(it, met.state, met.rate) || step(it, &met, late, &behind, &error)) {
            return 1;
        }
        memcpy(at->state, behind.state, sizeof at->state);
    }
    return 0;
}

/* Leaves every mode whose border the point has reached, but for rounding, and gives the point its rates and clearances. */
static int settle(Motion *it, Point *at) {
    for (int round = 0; round <= 2 * BORDERS; round++) {
        int left = 0;
        if (rates(it, at->state, at->rate) || look(it, at)) {
            return 1;
        }
        for (int k = 0; k < it->borders; k++) {
            if (at->clearance[k] <= 0.1 * GAP) {
                if (pass(it, at, k)) {
                    return 1;
                }
                left = 1;
            }
        }
        if (!left) {
            return 0;
        }
    }
    return 0;
}

/* Shortens a step that ends beyond a border to where it first meets one: by steps of its own, which are as accurate as any. */
static int shorten(const Motion *it, const Point *from, double *h, Point *to) {
    int border, side = 0;
    double near = 0.0, far = *h, inside = nearest(it, from, &border), beyond = nearest(it, to, &border);
    for (int i = 0; i < 100 && nearest(it, to, &border) < -1e-3 * GAP; i++) {
        const double middle = near + 0.5 * (far - near), secant = near + (far - near) * inside / (inside - beyond);
        const double trial = (i % 4 == 3 || !(secant > near && secant < far)) ? middle : secant;
        Point at;
        double error, clear;
        if (trial <= near || trial >= far) {
            break;
        }
        if (step(it, from, trial, &at, &error)) {
            return 1;
        }
        clear = nearest(it, &at, &border);
        if (clear > 0.0) {
            near = trial;
            inside = clear;
            beyond *= (side > 0) ? 0.5 : 1.0;
            side = 1;
        } else {
            far = trial;
            beyond = clear;
            inside *= (side < 0) ? 0.5 : 1.0;
            side = -1;
            *to = at;
        }
    }
    *h = far;
    return 0;
}

/* Whether a step dips below a border between its ends, by the extremum of the clearance; then it is shortened to there. */
static int dips(const Motion *it, const Point *from, double *h, Point *to) {
    for (int k = 0; k < it->borders; k++) {
        double near = 0.0, far = *h, falling = from->change[k], rising = to->change[k];
        const double depth = 0.5 * falling * falling / (rising - falling) * *h;
        if (!(falling < 0.0 && rising > 0.0 && from->clearance[k] < 2.0 * depth)) {
            continue;
        }
        for (int i = 0; i < 8; i++) {
            const double lowest = near + (far - near) * falling / (falling - rising);
            Point at;
            double error;
            if (!(lowest > near && lowest < far) || step(it, from, lowest, &at, &error)) {
                break;
            }
            if (at.clearance[k] <= 0.0) {
                *h = lowest;
                *to = at;
                return 1;
            }
            if (at.change[k] < 0.0) {
                near = lowest;
                falling = at.change[k];
            } else {
                far = lowest;
                rising = at.change[k];
            }
        }
    }
    return 0;
}

/* Carries a state on for a while, or to the first event: DONE, the border that it has reached, or STUCK. An event is where its
 * border was met, or at the start; the mode behind it, which is told where it is noticed, is the next one. */
static int carry(Motion *it, double *state, double duration, double *length, double *elapsed, double *next_mode) {
    Point from, to;
    double error, t = 0.0;
    int border = DONE;
    memcpy(from.state, state, sizeof from.state);
    if (settle(it, &from)) {
        return STUCK;
    }
    for (long steps = 0; t < duration; steps++) {
        double h = *length, next;
        const int last = t + h >= duration;
        if (last) {
            h = duration - t;
        }
        if (steps >= MOST_STEPS) {
            return STUCK;
        }
        const double whole = h;
        const int none = step(it, &from, h, &to, &error);
        if (none || error > 1.0) {
            *length = h * (none ? 0.25 : fmax(0.2, 0.9 * pow(error, -0.2)));
            if (*length < LEAST_STEP * it->second) {
                return STUCK;
            }
            continue;
        }
        next = h * fmin(5.0, 0.9 * pow(fmax(error, 1e-10), -0.2));
        *length = last ? fmax(*length, next) : next;
        if ((nearest(it, &to, &border) <= 0.0 || dips(it, &from, &h, &to)) && shorten(it, &from, &h, &to)) {
            *length = 0.25 * whole;
            continue;
        }
        t = (last && h == whole) ? duration : t + h;
        from = to;
        if (nearest(it, &from, &border) <= 0.0) {
            if (border < EVENTS) {
                memcpy(next_mode, it->mode, sizeof it->mode);
                const double back = fmin(lateness(it, &from, border), t);
                Motion behind = *it;
                if (back > 0.0 && !step(it, &from, -back, &to, &error) && !cross(&behind, from.state, border)) {
                    memcpy(next_mode, behind.mode, sizeof behind.mode);
                    from = to;
                    t -= back;
                }
                break;
            }
            if (settle(it, &from)) {
                return STUCK;
            }
        }
        border = DONE;
    }
    if (border == DONE) {
        memcpy(next_mode, it->mode, sizeof it->mode);
    }
    memcpy(state, from.state, sizeof from.state);
    *elapsed = t;
    return border;
}
