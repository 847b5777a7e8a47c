// The balance of forces of a model from its page, by the exported algebra: what a search and a motion ask for.

/** What is known of a point: arguments of the exported functions, angles as cosine and sine. */
function given(about, point) {
  const values = { ...point };
  for (const [angle, [cosine, sine]] of Object.entries(about.angles)) {
    [values[cosine], values[sine]] = [Math.cos(point[angle]), Math.sin(point[angle])];
  }
  const listed = (kind) => about.arguments[kind].map((name) => values[name]);
  return { statics: listed("statics"), motion: listed("motion") };
}

/** Far away: with springs of this length their directions stay as they are. */
const FAR = 1e300;

/**
 * The functions of a model at one point of its parameters. `q` are coordinates, `contact` says whether the belt pushes.
 * A function without any result, as the geometry of a model without springs, is not exported.
 */
export function balanceAt(algebra, about, point) {
  const { statics, motion } = given(about, point);
  const mu = algebra.friction_at_rest ? algebra.friction_at_rest(...motion) : 0;
  const pushing = (contact) => (contact ? 1 : 0);
  const vectors = (q) => (algebra.geometry ? algebra.geometry(...q, ...statics) : []);

  /** Cosine, sine and length of every spring. */
  function lines(q) {
    return vectors(q).flatMap(([dx, dy]) => {
      const length = Math.hypot(dx, dy);
      return [dx / length, dy / length, length];
    });
  }

  /** The same, and then the least turning of every torsion spring. */
  function directions(q) {
    const along = lines(q);
    const turned = about.torsions ? algebra.turnings(...q, ...along, ...statics) : [];
    return [...along, ...turned.map(([cosine, sine]) => Math.atan2(sine, cosine))];
  }

  const call = (name, q, along, contact) => algebra[name](...q, ...along, ...statics, mu, pushing(contact));
  return {
    vectors, directions, motion,
    forces: (q, contact, along = directions(q)) => call("forces", q, along, contact),
    stiffness: (q, contact, along = directions(q)) => call("forces_jacobian", q, along, contact),
    mass: (q) => algebra.mass_matrix(...q, ...motion),
    damping: (q, contact) => algebra.damping?.(...q, ...lines(q), ...motion, pushing(contact)) ?? q.map(() => q.map(() => 0)),
    gap: (q) => algebra.contact_gap?.(...q, ...statics) ?? -1,
    /** Directions that do not turn: cosine and sine of every spring, by angles; so far away no torque has a force. */
    held: (angles) => [...angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), FAR]), ...Array(about.torsions).fill(0)],
  };
}
