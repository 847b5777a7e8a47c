// The balance of forces of a model at a point of its parameters, by the exported functions: what a search and a motion need.

/** The parameters that the exported functions take in statics and in motion, in their order; angles as cosine and sine. */
function given(about, point) {
  const values = { ...point };
  for (const [angle, [cosine, sine]] of Object.entries(about.angles)) {
    [values[cosine], values[sine]] = [Math.cos(point[angle]), Math.sin(point[angle])];
  }
  const listed = (kind) => about.arguments[kind].map((name) => values[name]);
  return { statics: listed("statics"), motion: listed("motion") };
}

/** A length of springs at which their torques have no force on the mass, so that their directions can be held. */
const FAR = 1e300;

/** The exported name of a contact's function: the contact's name is appended where there are several contacts. */
const named = (name, contact) => (contact ? `${name}_${contact}` : name);

/**
 * The functions of a model at one point of its parameters. `q` are coordinates; `regime`, an index into `about.regimes`, says which contacts touch.
 * A function without results, as the geometry of a model without springs, is not exported: it is asked for with `?.` or tested.
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

  /** The same, followed by the angle of every torsion spring, the smallest of those that differ by whole turns. */
  function directions(q) {
    const along = lines(q);
    const turned = about.torsions ? algebra.turnings(...q, ...along, ...statics) : [];
    return [...along, ...turned.map(([cosine, sine]) => Math.atan2(sine, cosine))];
  }

  const call = (name, q, along, touching, friction = mu) => algebra[name](...q, ...along, ...statics, ...friction, ...touching);

  /**
   * The forces at a state: the tension of every spring, the normal force of every contact, every friction force, and for a mass on a belt all
   * of them as vectors. The balance is linear in the friction and in what touches, so each vector is a difference of two balances.
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
    /** The gap of every contact, ≤ 0 where it touches. */
    gaps: (q) => about.contacts.map(({ name }) => algebra[named("contact_gap", name)]?.(...q, ...statics) ?? -1),
    /** Springs held in the given directions, in the form of `directions`: FAR away, so that no torque has a force. */
    held: (angles) => [...angles.flatMap((angle) => [Math.cos(angle), Math.sin(angle), FAR]), ...Array(about.torsions).fill(0)],
  };
}
