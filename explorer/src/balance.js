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

  const call = (name, q, along, contact, friction = mu) => algebra[name](...q, ...along, ...statics, friction, pushing(contact));

  /**
   * What acts on the mass at a state: the tension of every spring, the belt's normal force and its friction, and for a mass on a belt
   * these as vectors. The balance is linear in the friction, so that each is a difference of the generated one, with the other sign.
   */
  function acting(q, contact) {
    const along = directions(q);
    const [all, smooth, alone] = [[contact, mu], [contact, 0], [false, 0]].map(([touching, friction]) => call("forces", q, along, touching, friction).slice(0, 2));
    const less = (one, other) => [0, 1].map((k) => (other[k] ?? 0) - (one[k] ?? 0));
    const tensions = algebra.spring_forces?.(...q, ...statics) ?? [];
    const normal = algebra.contact_force?.(...q, ...motion, pushing(contact)) ?? 0;
    const springs = tensions.map((tension, i) => [tension * along[3 * i], tension * along[3 * i + 1]]);
    return {
      tensions, normal, friction: mu * Math.abs(normal),
      vectors: { springs, normal: less(smooth, alone), friction: less(all, smooth), others: less(springs.reduce((sum, one) => sum.map((value, k) => value + one[k]), alone), [0, 0]) },
    };
  }

  return {
    vectors, directions, motion, acting,
    forces: (q, contact, along = directions(q)) => call("forces", q, along, contact),
    stiffness: (q, contact, along = directions(q)) => call("forces_jacobian", q, along, contact),
    mass: (q) => algebra.mass_matrix(...q, ...motion),
    damping: (q, contact) => algebra.damping?.(...q, ...lines(q), ...motion, pushing(contact)) ?? q.map(() => q.map(() => 0)),
    gyroscopic: (q) => algebra.gyroscopic?.(...q, ...motion),
    gap: (q) => algebra.contact_gap?.(...q, ...statics) ?? -1,
    /** Directions that do not turn: cosine and sine of every spring, by angles; so far away no torque has a force. */
    held: (angles) => [...angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), FAR]), ...Array(about.torsions).fill(0)],
  };
}
