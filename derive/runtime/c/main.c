/* A motion of @library@ from rest at its base values: coordinates, rates and energy, and whether the contact is closed. */
#include <stdio.h>

#include "@library@.h"

enum { COORDINATES = @count@ };

/* @names@ */
static const double parameters[] = {@values@};

static int accelerations(const double *state, double *result) {
    const double *p = parameters;
    return @library@_rhs(@state@, @given@, result) != @LIBRARY@_OK;
}

/* One step of the classical Runge-Kutta method; across a kink of the contact or of friction it is of first order. */
static int step(double h, double *state) {
    static const double share[4] = {0.0, 0.5, 0.5, 1.0}, weight[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    double next[2 * COORDINATES], slope[2 * COORDINATES] = {0.0};
    for (int i = 0; i < 2 * COORDINATES; i++) {
        next[i] = state[i];
    }
    for (int stage = 0; stage < 4; stage++) {
        double at[2 * COORDINATES];
        for (int i = 0; i < 2 * COORDINATES; i++) {
            at[i] = state[i] + share[stage] * h * slope[i];
        }
        for (int i = 0; i < COORDINATES; i++) {
            slope[i] = at[COORDINATES + i];
        }
        if (accelerations(at, slope + COORDINATES)) {
            return 1;
        }
        for (int i = 0; i < 2 * COORDINATES; i++) {
            next[i] += weight[stage] * h * slope[i];
        }
    }
    for (int i = 0; i < 2 * COORDINATES; i++) {
        state[i] = next[i];
    }
    return 0;
}

static int print_state(double time, const double *state) {
    const double *p = parameters;
    double border[@borders@], energy;
    if (@library@_borders(@state@, @given@, border) != @LIBRARY@_OK) {
        return 1;
    }
    if (@library@_energy(@state@, @given@, @pushing@, &energy) != @LIBRARY@_OK) {
        return 1;
    }
    printf("time %5.1f  @shown@  energy %+.9f  @texts@\n", time, @state@, energy, @touching@);
    return 0;
}

int main(void) {
    double state[2 * COORDINATES] = {@start@};
    const double h = 0.005;
    for (int i = 0; i <= 4000; i++) {
        if (i % 800 == 0 && print_state(h * i, state)) {
            return 1;
        }
        if (step(h, state)) {
            return 1;
        }
    }
    return 0;
}
