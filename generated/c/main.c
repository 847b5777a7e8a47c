/* Equilibria at the article's base values, their number against theta0, and some steps of the motion. */
#include <stdio.h>

#include "spragsym.h"

static const double pi = 3.14159265358979323846;
static const char *const names[] = {"none", "stable", "divergent", "flutter"};

static int print_equilibria(const spragsym_model *model, spragsym_regime regime) {
    spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
    int count;
    const spragsym_status status = spragsym_equilibria(model, regime, found, &count);
    if (status != SPRAGSYM_OK) {
        return (int)status;
    }
    printf("%s: %d\n", regime == SPRAGSYM_CONTACT ? "contact" : "lift-off", count);
    for (int i = 0; i < count; i++) {
        printf("  theta %.12f  L %.12f  x %+.12f  y %+.12f  error %.0e  %s\n", found[i].theta, found[i].L, found[i].x,
            found[i].y, found[i].error, names[found[i].stability]);
    }
    return 0;
}

/* Where the number of equilibria in contact changes as theta0 goes from 1 to 179 degrees. */
static int print_jumps(spragsym_parameters article) {
    spragsym_parameters given[179];
    spragsym_equilibrium found[179][SPRAGSYM_MAX_EQUILIBRIA];
    int counts[179];
    spragsym_status statuses[179];
    for (int i = 0; i < 179; i++) {
        given[i] = article;
        given[i].theta0 = (i + 1) / 180.0 * pi;
    }
    if (spragsym_equilibria_batch(179, given, SPRAGSYM_CONTACT, found, counts, statuses) > SPRAGSYM_UNCERTAIN) {
        return 1;
    }
    for (int i = 1; i < 179; i++) {
        if (counts[i] != counts[i - 1]) {
            printf("theta0 from %d to %d degrees: %d to %d equilibria\n", i, i + 1, counts[i - 1], counts[i]);
        }
    }
    return 0;
}

int main(void) {
    const spragsym_parameters article = {49.0 / 180.0 * pi, 0.5, 0.007, 0.007, 0.1, 0.0};
    spragsym_model model;
    double state[4] = {0.0, 0.0, 0.0, 0.0};
    if (spragsym_prepare(&article, &model) != SPRAGSYM_OK) {
        return 1;
    }
    if (print_equilibria(&model, SPRAGSYM_CONTACT) || print_equilibria(&model, SPRAGSYM_LIFTOFF) ||
        print_jumps(article)) {
        return 1;
    }
    for (int i = 0; i <= 1000; i++) {
        if (i % 200 == 0) {
            printf("time %5.1f  x %+.9f  y %+.9f\n", 0.05 * i, state[0], state[1]);
        }
        if (spragsym_step(&model, 0.5, 10.0, 0.05, state) != SPRAGSYM_OK) {
            return 1;
        }
    }
    return 0;
}
/* SPDX-License-Identifier: MIT */
