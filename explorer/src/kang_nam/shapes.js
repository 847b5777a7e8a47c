// The drawings at given kappa, alpha, sigma and beta: curves and areas of three equilibria over theta0 and mu0, and the equilibrium surface.

const COLUMNS = 240;
/** Nodes of the surface along each of its two coordinates, how much denser they are in the middle, and nodes of a ruled line. */
const NODES = 140;
const GRADING = 3.5;
const RULED = 360;
/** Cells over which friction changes by more than this share of its drawn range are cut into this many strips. */
const STEEP = 0.25;
const STRIPS = 10;
/** How far from 0 and pi the surface ends, and how far outside 0 … pi a node may lie to be moved to the edge, radians. */
const EDGE = 1e-3;
const OUTSIDE = 0.2;
/** Directions of the spring at which the bifurcation set is computed; more would show nothing more. */
const FINE = 120;

/** Curves of folds and flutter onsets, cusps, where the reference state ends first, and the areas with several equilibria, for friction up to `top`. */
export function curvesOf(solver, point, top) {
  const { curves, cusps } = solver.bifurcation_set(point, { n: FINE });
  const flutter = solver.flutter_boundary(point, { n: FINE });
  const lowest = solver.critical_friction(point);
  return { curves, cusps, lowest, flutter, areas: strips(solver, point, curves, top) };
}

/** Frictions at which a curve crosses an inclination. */
function crossings({ theta0, mu0 }, at) {
  const found = [];
  for (let i = 1; i < theta0.length; i++) {
    const [a, b] = [theta0[i - 1], theta0[i]];
    if ((a < at) !== (b < at)) {
      found.push(mu0[i - 1] + ((mu0[i] - mu0[i - 1]) * (at - a)) / (b - a));
    }
  }
  return found;
}

/**
 * In every column of the plane the intervals of friction with more than one equilibrium: between neighbouring folds, where the solver finds several in
 * the middle. For drawing only.
 */
function strips(solver, point, curves, top) {
  const found = [];
  for (let i = 0; i < COLUMNS; i++) {
    const theta0 = (Math.PI * (i + 0.5)) / COLUMNS;
    const ends = [0, ...curves.flatMap((curve) => crossings(curve, theta0)).filter((mu0) => mu0 > 0 && mu0 < top).sort((a, b) => a - b), top];
    for (let k = 1; k < ends.length; k++) {
      const { count } = solver.equilibria({ ...point, theta0, mu0: 0.5 * (ends[k - 1] + ends[k]) });
      if (count > 1) {
        found.push({ left: (Math.PI * i) / COLUMNS, right: (Math.PI * (i + 1)) / COLUMNS, low: ends[k - 1], high: ends[k], count });
      }
    }
  }
  return found;
}

const KINDS = { stable: 0, divergent: 1, flutter: 2 };

/** Nodes from −1 to 1, closest in the middle, where the surface is steepest. */
const graded = Array.from({ length: NODES }, (_, i) => Math.sinh(GRADING * ((2 * i) / (NODES - 1) - 1)) / Math.sinh(GRADING));

const kept = (angle) => Math.min(Math.PI - EDGE, Math.max(EDGE, angle));

/**
 * The surface as a grid over theta − theta0 and theta + theta0, since its steep parts run along theta = theta0 and theta = pi − theta0. Nodes a little
 * outside 0 … pi are moved to the edge. Friction is NaN where there is no state. Cells over which friction changes much are cut into strips: `fine` holds
 * the corners of their triangles, `coarse` is 1 for the cells that are whole.
 */
export function surfaceOf(solver, point, top) {
  const size = NODES * NODES;
  const grid = { theta0: new Float32Array(size), theta: new Float32Array(size), mu0: new Float32Array(size), kind: new Uint8Array(size) };
  for (let i = 0; i < NODES; i++) {
    for (let j = 0; j < NODES; j++) {
      const node = nodeOf(solver, point, graded[i], graded[j]);
      Object.keys(grid).forEach((name) => { grid[name][i * NODES + j] = node[name]; });
    }
  }
  const coarse = new Uint8Array(size).fill(1);
  const fine = [];
  for (let at = NODES + 1; at < size; at++) {
    const along = at % NODES ? steepness(grid, at, top) : null;
    if (along) {
      coarse[at] = 0;
      fine.push(...strip(solver, point, Math.floor(at / NODES), at % NODES, along).flatMap((corners) => seen(solver, point, corners, top)));
    }
  }
  const column = (name, Type) => Type.from(fine, (node) => node[name]);
  const corners = { theta0: column("theta0", Float32Array), theta: column("theta", Float32Array), mu0: column("mu0", Float32Array), kind: column("kind", Uint8Array) };
  return { nodes: NODES, ...grid, coarse, fine: corners, rulings: rulings(solver, point) };
}

/** The surface at a node by its two grid coordinates, each in −1 … 1. */
function nodeOf(solver, point, u, v) {
  const [minus, plus] = [Math.PI * u, Math.PI * (1 + v)];
  const [theta0, theta] = [(plus - minus) / 2, (plus + minus) / 2];
  const outside = Math.max(Math.abs(theta0 - kept(theta0)), Math.abs(theta - kept(theta)));
  const found = outside < OUTSIDE ? solver.surface(point, kept(theta), kept(theta0)) : null;
  return { theta0: kept(theta0), theta: kept(theta), mu0: found ? found.mu0 : NaN, kind: found ? KINDS[found.stability] : 0 };
}

/**
 * Along which coordinate, "u" or "v", the cell that ends at a node is to be cut: if it is visible, and friction changes too much over it or its corners
 * are of different kinds; else null.
 */
function steepness({ mu0, kind }, at, top) {
  const nodes = [at - NODES - 1, at - NODES, at - 1, at];
  const [a, b, c, d] = nodes.map((node) => mu0[node]);
  const [low, high] = [Math.min(a, b, c, d), Math.max(a, b, c, d)];
  const mixed = nodes.some((node) => kind[node] !== kind[at]);
  if (!(high > 0 && low < top && (mixed || high - low > STEEP * top))) {
    return null;
  }
  return Math.abs(c - a) + Math.abs(d - b) > Math.abs(b - a) + Math.abs(d - c) ? "u" : "v";
}

/** Triangles of a cell that is cut along one coordinate. */
function strip(solver, point, i, j, along) {
  const [k, fixed] = along === "u" ? [i, [graded[j - 1], graded[j]]] : [j, [graded[i - 1], graded[i]]];
  const rows = Array.from({ length: STRIPS + 1 }, (_, n) => {
    const w = graded[k - 1] + ((graded[k] - graded[k - 1]) * n) / STRIPS;
    return fixed.map((other) => (along === "u" ? nodeOf(solver, point, w, other) : nodeOf(solver, point, other, w)));
  });
  return rows.slice(1).flatMap(([c, d], n) => {
    const [a, b] = rows[n];
    return [[a, b, c], [b, d, c]].filter((corners) => corners.every((node) => !Number.isNaN(node.mu0)));
  });
}

/** The corners of a triangle, those outside the drawing with the kind of its visible part. */
function seen(solver, point, corners, top) {
  const outside = ({ mu0 }) => mu0 < 0 || mu0 > top;
  if (!corners.some(outside)) {
    return corners;
  }
  const kind = corners.find((node) => !outside(node))?.kind ?? kindAmid(solver, point, corners, top);
  return corners.map((node) => (outside(node) ? { ...node, kind } : node));
}

/** The kind of a triangle that crosses the drawing without a corner in it: that of the state in its middle, at half of the drawn friction. */
function kindAmid(solver, point, corners, top) {
  const mean = (name) => corners.reduce((sum, node) => sum + node[name], 0) / 3;
  const { states } = solver.equilibria({ ...point, theta0: mean("theta0"), mu0: top / 2 });
  const far = ({ theta }) => Math.abs(theta - mean("theta"));
  const nearest = states.reduce((best, state) => (best && far(best) <= far(state) ? best : state), null);
  return nearest ? KINDS[nearest.stability] : corners[0].kind;
}

/** Lines of equal inclination on the surface, which show its shape without colour: lists of [theta0, mu0, theta]. */
function rulings(solver, point) {
  const lines = [];
  for (let theta0 = 15; theta0 < 180; theta0 += 15) {
    let run = [];
    for (let j = 1; j < RULED; j++) {
      const [at, theta] = [(Math.PI * theta0) / 180, (Math.PI * j) / RULED];
      const found = solver.surface(point, theta, at);
      if (found) {
        run.push([at, found.mu0, theta]);
      } else if (run.length) {
        lines.push(run);
        run = [];
      }
    }
    lines.push(run);
  }
  return lines;
}

/** Both, as a message asks for them. */
export function answer(solver, { id, point, top, what }) {
  try {
    return { id, what, value: what === "curves" ? curvesOf(solver, point, top) : surfaceOf(solver, point, top) };
  } catch (error) {
    return { id, what, error: String(error.message ?? error) };
  }
}
