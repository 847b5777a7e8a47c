/* Everything that the C target offers, called over arrays: for the tests, which make calls.h from the header. */
#include <stdio.h>
#include "spragsym.h"
#include "calls.h"
void equilibria(long points, const spragsym_parameters *in, int regime, spragsym_equilibrium *out,
    int *counts, int *status);
void equilibria(long points, const spragsym_parameters *in, int regime, spragsym_equilibrium *out,
    int *counts, int *status) {
    for (long i = 0; i < points; i++) {
        spragsym_model model;
        status[i] = (int)spragsym_prepare(&in[i], &model);
        if (status[i] == SPRAGSYM_OK) {
            status[i] = (int)spragsym_equilibria(&model, (spragsym_regime)regime, out + 4 * i, &counts[i]);
        }
    }
}

int batch(long points, const spragsym_parameters *in, int regime, spragsym_equilibrium *out, int *counts, int *status);
int batch(long points, const spragsym_parameters *in, int regime, spragsym_equilibrium *out, int *counts, int *status) {
    spragsym_status all[BATCH] = {SPRAGSYM_OK};
    const spragsym_status worst = spragsym_equilibria_batch((size_t)points, in, (spragsym_regime)regime,
        (spragsym_equilibrium(*)[4])out, counts, all);
    for (long i = 0; i < points; i++) {
        status[i] = (int)all[i];
    }
    return (int)worst;
}

int steps(const spragsym_parameters *in, double V, double d, double h, long count, double *state);
int steps(const spragsym_parameters *in, double V, double d, double h, long count, double *state) {
    spragsym_model model;
    int status = (int)spragsym_prepare(in, &model);
    for (long i = 0; i < count && status == SPRAGSYM_OK; i++) {
        status = (int)spragsym_step(&model, V, d, h, state);
    }
    return status;
}

void lowest(long points, const spragsym_parameters *in, spragsym_critical_load *out, int *status);
void lowest(long points, const spragsym_parameters *in, spragsym_critical_load *out, int *status) {
    for (long i = 0; i < points; i++) {
        status[i] = (int)spragsym_critical_friction(&in[i], &out[i]);
    }
}

/* The parameters on stdin, through everything; for the sanitizers, which can't be loaded into Python. */
int main(void) {
    static spragsym_parameters many[BATCH];
    static spragsym_equilibrium solved[4 * BATCH];
    static int counts[BATCH];
    static int statuses[BATCH];
    spragsym_parameters one;
    spragsym_critical_load fold;
    double numbers[16] = {0.0};
    double results[16];
    long read = 0;
    while (fread(&one, sizeof one, 1, stdin) == 1) {
        many[read++] = one;
        spragsym_equilibrium found[4];
        int count = 0;
        int status = 0;
        double state[4] = {0.1, -0.01, 0.0, 0.0};
        equilibria(1, &one, 0, found, &count, &status);
        equilibria(1, &one, 1, found, &count, &status);
        lowest(1, &one, &fold, &status);
        steps(&one, 0.5, 10.0, 0.1, 20, state);
        for (int i = 0; i < 16; i++) {
            numbers[i] = (&one.theta0)[0] * (i % 5 - 2) + one.kappa;
        }
        call_all(numbers, results, &status);
    }
    batch(read, many, 0, solved, counts, statuses);
    batch(read, many, 1, solved, counts, statuses);
    return 0;
}
