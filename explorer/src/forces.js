// Forces on the mass at a state. The balance is linear in the stiffnesses, the preload and the contact, so that each force is the
// generated balance with all others switched off, with the other sign: F_x and F_y stand on the left of x'' + F_x = 0.

export function forces(algebra, point, state, contact) {
  const { theta0, mu0, kappa, alpha, sigma, beta } = point;
  const nbar = contact ? 1 : 0;
  const of = (k, a, s, b, n) => {
    const [fx, fy] = algebra.residuals(
      Math.cos(state.theta), Math.sin(state.theta), state.L, Math.cos(theta0), Math.sin(theta0), mu0, k, a, s, b, n,
    );
    return [0 - fx, 0 - fy];
  };
  const touch = of(0, 0, 0, 0, nbar);
  return {
    spring: of(0, 0, sigma, 0, 0),
    ties: of(0, alpha, 0, beta, 0),
    preload: of(kappa, 0, 0, 0, 0),
    normal: [0, touch[1]],
    friction: [touch[0], 0],
  };
}
