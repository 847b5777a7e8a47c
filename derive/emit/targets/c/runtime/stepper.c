
/* ------------------------------------------------------------------------------------------- the motion, as a library has it */

static Motion within(const @library@_motion *it) {
    Motion motion;
    memset(&motion, 0, sizeof motion);
    memcpy(motion.p, it->parameters, sizeof motion.p);
    memcpy(motion.mode, it->mode, sizeof motion.mode);
    memcpy(motion.unit, it->unit, sizeof motion.unit);
    memcpy(motion.level, it->level, sizeof motion.level);
    motion.second = it->second;
    motion.tolerance = it->tolerance;
    motion.borders = BORDERS;
    return motion;
}

/* Enters the next mode, and that beyond every border that the state has reached. Not 0: the motion has no rates. */
static int enter(Motion *it, const double *next, double *state) {
    double sides[SIDES];
    Point at;
    memcpy(sides, it->mode + CONTACTS, sizeof sides);
    memcpy(it->mode, next, sizeof it->mode);
    memcpy(at.state, state, sizeof at.state);
    if (stop(it, sides, at.state) || settle(it, &at)) {
        return 1;
    }
    memcpy(state, at.state, sizeof at.state);
    return 0;
}

@library@_status @library@_begin(@library@_motion *motion, const double *parameters, const double *state, double tolerance) {
    @library@_motion to;
    memset(&to, 0, sizeof to);
    if (!motion || !state || (PARAMETERS && !parameters) || !(tolerance >= 1e-13 && tolerance <= 0.1) ||
        !finite_all(STATES, state) || !finite_all(PARAMETERS, parameters)) {
        return @LIBRARY@_BAD_INPUT;
    }
    for (int i = 0; i < PARAMETERS; i++) {
        to.parameters[i] = parameters[i];
    }
    memcpy(to.state, state, sizeof to.state);
    to.tolerance = tolerance;
    Motion own = within(&to);
#if CLOCK
    if (clock(own.p, to.state + STATES - 1)) {
        return @LIBRARY@_OUT_OF_RANGE;
    }
#endif
    if (begin(&own, to.state)) {
        return @LIBRARY@_OUT_OF_RANGE;
    }
    memcpy(to.mode, own.mode, sizeof to.mode);
    memcpy(to.next, own.mode, sizeof to.next);
    memcpy(to.unit, own.unit, sizeof to.unit);
    memcpy(to.level, own.level, sizeof to.level);
    to.second = own.second;
    to.length = FIRST_STEP * own.second;
    *motion = to;
    return @LIBRARY@_OK;
}

@library@_status @library@_advance(@library@_motion *motion, double duration) {
    if (!motion || !(duration >= 0.0 && isfinite(duration))) {
        return @LIBRARY@_BAD_INPUT;
    }
    @library@_motion to = *motion;
    Motion own = within(&to);
    for (double done = 0.0; done < duration;) {
        double elapsed = 0.0;
        const int border = enter(&own, to.next, to.state) ? STUCK : carry(&own, to.state, duration - done, &to.length, &elapsed, to.next);
        if (border == STUCK) {
            return @LIBRARY@_OUT_OF_RANGE;
        }
        done = (border == DONE) ? duration : done + elapsed;
    }
    memcpy(to.mode, own.mode, sizeof to.mode);
    to.time += duration;
    *motion = to;
    return @LIBRARY@_OK;
}
