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

/** A function of one contact by its name; that of the only contact has none behind it. */
const named = (name, contact) => (contact ? `${name}_${contact}` : name);

/**
 * The functions of a model at one point of its parameters. `q` are coordinates, `regime` is the number of the one that says which contacts touch.
 * A function without any result, as the geometry of a model without springs, is not exported.
 */
export function balanceAt(algebra, about, point) {
  const { statics, motion } = given(about, point);
  const mu = about.frictions.length ? about.frictions.map(({ contact }) => algebra[named("friction_at_rest", about.contacts[contact].name)](...motion)) : [0];
  const pushing = (regime) => about.regimes[regime].touching;
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

  const call = (name, q, along, touching, friction = mu) => algebra[name](...q, ...along, ...statics, ...friction, ...touching);

  /**
   * What acts on the mass at a state: the tension of every spring, the normal force of every contact and every friction, and for a mass on
   * a belt these as vectors. The balance is linear in the friction, so that each is a difference of the generated one, with the other sign.
   */
  function acting(q, regime) {
    const along = directions(q);
    const [touching, none] = [pushing(regime), mu.map(() => 0)];
    const [all, smooth, alone] = [[touching, mu], [touching, none], [touching.map(() => 0), none]].map((pair) => call("forces", q, along, ...pair).slice(0, 2));
    const less = (one, other) => [0, 1].map((k) => (other[k] ?? 0) - (one[k] ?? 0));
    const tensions = algebra.spring_forces?.(...q, ...statics) ?? [];
    const normals = about.contacts.map(({ name }, k) => algebra[named("contact_force", name)]?.(...q, ...motion, touching[k]) ?? 0);
    const frictions = mu.map((value, j) => value * Math.abs(normals[about.frictions[j]?.contact ?? 0]));
    const springs = tensions.map((tension, i) => [tension * along[3 * i], tension * along[3 * i + 1]]);
    return {
      tensions, normals, frictions,
      vectors: { springs, normal: less(smooth, alone), friction: less(all, smooth), others: less(springs.reduce((sum, one) => sum.map((value, k) => value + one[k]), alone), [0, 0]) },
    };
  }

  return {
    vectors, directions, motion, acting,
    forces: (q, regime, along = directions(q)) => call("forces", q, along, pushing(regime)),
    stiffness: (q, regime, along = directions(q)) => call("forces_jacobian", q, along, pushing(regime)),
    places: (q) => algebra.places(...q, ...motion),
    mass: (q) => algebra.mass_matrix(...q, ...motion),
    damping: (q, regime) => algebra.damping?.(...q, ...lines(q), ...motion, ...pushing(regime)) ?? q.map(() => q.map(() => 0)),
    gyroscopic: (q) => algebra.gyroscopic?.(...q, ...motion),
    /** Of every contact: not positive where it touches. */
    gaps: (q) => about.contacts.map(({ name }) => algebra[named("contact_gap", name)]?.(...q, ...statics) ?? -1),
    /** Directions that do not turn: cosine and sine of every spring, by angles; so far away no torque has a force. */
    held: (angles) => [...angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), FAR]), ...Array(about.torsions).fill(0)],
  };
}
