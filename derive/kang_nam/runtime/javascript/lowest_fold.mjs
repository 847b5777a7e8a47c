// ------------------------------------------------------------------------------------------------- the critical friction

/**
 * The friction below which the reference state, followed from mu0 = 0, jumps at no inclination: the lowest fold with
 * f'' < 0 and 0 < theta0 < pi/2. It is a cusp, a point where the curve of folds turns back in mu0, or at the end theta0 = 0.
 *
 * @param {object} parameters kappa, alpha, sigma and beta; theta0 and mu0 are not used
 * @returns {object} mu0, theta0 and kind, "cusp", "turn" or "end"; Infinity, NaN and "" where no fold ends that state
 */
export function critical_friction(parameters) {
  const given = fold_parameters(parameters, ["theta0", "mu0"]);
  const curves = given.alpha > 0 ? curves_of(FOLDS, directions_for(DIRECTIONS, given), given) : [];
  const points = [
    ...cusps_on(curves, given).filter(({ theta0 }) => theta0 < 0.5 * TURN).map((at) => ({ ...at, kind: "cusp" })),
    ...curves.flatMap((curve) => changes(curve, (at) => tilt(at, given), given)).map((at) => ({ ...at, kind: "turn" })),
    ...folds_in("mu0", { ...given, theta0: 0 }).map(([theta, mu0]) => ({ theta0: 0, mu0, theta, kind: "end" })),
  ];
  const found = points.filter((at) => at.mu0 >= 0 && (at.kind === "cusp" || (at.theta0 < 0.5 * TURN && bend(at, given) < 0)));
  return found.reduce(
    (least, { mu0, theta0, kind }) => (mu0 < least.mu0 ? { mu0, theta0, kind } : least), { mu0: Infinity, theta0: NaN, kind: "" },
  );
}

/** The derivative of f by theta0 at a fold. */
function tilt({ theta, theta0, mu0 }, given) {
  return algebra.f(...turned(theta), ...change_at({ ...given, theta0, mu0 }, "theta0"));
}
