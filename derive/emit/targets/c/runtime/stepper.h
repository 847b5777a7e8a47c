/**
 * A motion. Its steps, by the method of Dormand and Prince, end at every event: where a contact closes or opens, and where frictions
 * begin to hold, to slip or to reverse, all that one instant changes decided together. What holds, holds exactly.
 */
typedef struct {
    double time, state[@states@]; /**< coordinates, then rates; dimensionless */
    /** Of contacts 1 while one is closed, else 0; of frictions the sign of the sliding speed, 0 while one holds; of what follows
     * these, ways of the field. */
    double mode[@modes@];
    /* Of the stepper itself. */
    double parameters[@parameters@ + 1], next[@modes@], unit[@states@], level[@borders@ + 1], second, length, tolerance;
} @library@_motion;

/**
 * Begins a motion at time 0 in a state; the tolerance, in [1e-13, 0.1], is the error of one step beside numbers of size 1. A clock
 * gets its rate. The parameters are
 * @names@.
 */
@library@_status @library@_begin(@library@_motion *motion, const double *parameters, const double *state, double tolerance);

/** Carries a motion on for a time. With @LIBRARY@_OUT_OF_RANGE it has no rates there, or takes too many steps, and is as
 * before. */
@library@_status @library@_advance(@library@_motion *motion, double duration);
