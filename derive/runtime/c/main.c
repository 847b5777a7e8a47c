/* A motion of @library@ from rest at its base values: coordinates, rates and energy, and whether the contact is closed. */
#include <stdio.h>

#include "@library@.h"

/* @names@ */
static const double parameters[] = {@values@};

static int print_state(const @library@_motion *motion) {
    const double *p = parameters, *state = motion->state;
    double border[@borders@], energy;
    if (@library@_borders(@state@, @given@, border) != @LIBRARY@_OK) {
        return 1;
    }
    if (@library@_energy(@state@, @given@, @pushing@, &energy) != @LIBRARY@_OK) {
        return 1;
    }
    printf("time %5.1f  @shown@  energy %+.9f  @texts@\n", motion->time, @state@, energy, @touching@);
    return 0;
}

int main(void) {
    const double start[] = {@start@};
    @library@_motion motion;
    if (@library@_begin(&motion, parameters, start, 1e-10) != @LIBRARY@_OK) {
        return 1;
    }
    for (int i = 0; i <= 5; i++) {
        if (print_state(&motion) || @library@_advance(&motion, 4.0) != @LIBRARY@_OK) {
            return 1;
        }
    }
    return 0;
}
