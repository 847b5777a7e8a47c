// Walks over the plane, started by buttons, that show what a cusp does.

import { degrees, radians } from "../numbers.js";

const PACE = 14; // degrees a second
const PER_DEGREE = 0.012; // change of friction that takes as long as a degree

/** The corners of each walk, inclination in degrees and friction, by the name of its button; chosen for the article's base parameters. */
export const WAYS = {
  across: [[30, 0.5], [60, 0.5]],
  back: [[60, 0.5], [30, 0.5]],
  home: [[30, 0.5], [30, 0.05], [60, 0.05], [30, 0.5]],
  around: [[30, 0.5], [30, 0.1], [90, 0.1], [90, 0.5], [60, 0.5]],
};

const length = ([a, b], [c, d]) => Math.hypot(c - a, (d - b) / PER_DEGREE);

/** Moves the point from where it is along the corners, at once if `quick`; returns a function that stops it. */
export function walk(store, corners, quick, done) {
  const { theta0, mu0 } = store.get().point;
  const way = [[degrees(theta0), mu0], ...corners];
  let [leg, share, last, going] = [1, 0, performance.now(), true];
  function frame(now) {
    if (!going) {
      return;
    }
    const [from, to] = [way[leg - 1], way[leg]];
    share = quick ? 1 : Math.min(1, share + (PACE * Math.min(now - last, 100)) / 1000 / Math.max(length(from, to), 1e-9));
    last = now;
    const [angle, friction] = [0, 1].map((k) => (share === 1 ? to[k] : from[k] + share * (to[k] - from[k])));
    store.move({ theta0: radians(angle), mu0: friction });
    if (share === 1) {
      [leg, share] = [leg + 1, 0];
    }
    if (leg < way.length) {
      requestAnimationFrame(frame);
    } else {
      going = false;
      done();
    }
  }
  requestAnimationFrame(frame);
  return () => { going = false; done(); };
}
