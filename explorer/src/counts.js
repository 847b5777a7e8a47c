// The number of states over a plane whose folds are not known: sampled on finer and finer grids, a few cells before each picture.

/** Cells across and up of each grid; how long cells may delay a picture, and how long all may take, milliseconds. */
const GRIDS = [[10, 8], [20, 16], [40, 32]];
const [BUDGET, PATIENCE] = [8, 15_000];

/** `count(x, y)` gives the number of states, null where that is undecided; `show(areas)` draws the cells with more than one or an undecided number. */
export function createCounts(count, show) {
  let asked = 0;

  /** Begin anew over two ranges, or only stop: a count that is still running is given up. */
  return function renew(ranges) {
    asked += 1;
    if (!ranges) {
      return;
    }
    const [[left, right], [low, high]] = ranges;
    const mine = asked;
    let [level, at, areas, spent] = [0, 0, [], 0];
    const more = () => {
      if (mine !== asked) {
        return;
      }
      const begun = performance.now();
      while (level < GRIDS.length && performance.now() - begun < BUDGET) {
        const [across, up] = GRIDS[level];
        const [i, k] = [at % across, Math.floor(at / across)];
        const place = (u, v) => [left + ((right - left) * u) / across, low + ((high - low) * v) / up];
        const many = count(...place(i + 0.5, k + 0.5));
        if (many === null || many > 1) {
          const [[a, b], [c, d]] = [place(i, k), place(i + 1, k + 1)];
          areas.push({ left: a, low: b, right: c, high: d, count: many });
        }
        at += 1;
        if (at === across * up) {
          show(areas);
          [level, at, areas] = [level + 1, 0, []];
        }
      }
      spent += performance.now() - begun;
      if (level < GRIDS.length && spent < PATIENCE) {
        requestAnimationFrame(more);
      }
    };
    requestAnimationFrame(more);
  };
}
