/* Every bit of every result, as text: to compare machines. Each line of stdin has the bits of six parameters. */
#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "spragsym.h"

static void print_bits(double value) {
    uint64_t bits;
    memcpy(&bits, &value, sizeof bits);
    printf("%016" PRIx64 " ", bits);
}

static void print_equilibria(const spragsym_parameters *given, spragsym_regime regime) {
    spragsym_model model;
    spragsym_equilibrium found[SPRAGSYM_MAX_EQUILIBRIA];
    int count = 0;
    spragsym_status status = spragsym_prepare(given, &model);
    if (status == SPRAGSYM_OK) {
        status = spragsym_equilibria(&model, regime, found, &count);
    }
    printf("%d %d ", (int)status, count);
    for (int i = 0; i < count; i++) {
        print_bits(found[i].theta);
        print_bits(found[i].L);
        print_bits(found[i].x);
        print_bits(found[i].y);
        print_bits(found[i].error);
        printf("%d ", (int)found[i].stability);
    }
}

int main(void) {
    uint64_t bits[6];
    double value[6];
    while (scanf("%" SCNx64 "%" SCNx64 "%" SCNx64 "%" SCNx64 "%" SCNx64 "%" SCNx64, &bits[0], &bits[1], &bits[2], &bits[3],
               &bits[4], &bits[5]) == 6) {
        memcpy(value, bits, sizeof value);
        const spragsym_parameters given = {value[0], value[1], value[2], value[3], value[4], value[5]};
        print_equilibria(&given, SPRAGSYM_LIFTOFF);
        print_equilibria(&given, SPRAGSYM_CONTACT);
        printf("\n");
    }
    return 0;
}
