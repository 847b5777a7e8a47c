/* --------------------------------------------------------------------------------------------- the kernel */

#define CUBE_ROOT_STEPS 3

/* Cube root of x > 0, 0 of 0: a third of the exponent by the bits, which is good to a few percent, then Halley's method. */
INLINE double cube_root(double x) {
    union {
        double number;
        uint64_t bits;
    } start;
    start.number = x;
    uint64_t third = start.bits >> 2;
    third += third >> 2;
    third += third >> 4;
    third += third >> 8;
    start.bits = third + UINT64_C(3071306043645493248);
    double root = start.number;
    for (int i = 0; i < CUBE_ROOT_STEPS; i++) {
        const double cube = root * root * root;
        root *= (cube + 2.0 * x) / (2.0 * cube + x);
    }
    return (x > 0.0) ? root : 0.0;
}
