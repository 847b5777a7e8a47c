// How many states there are over a plane, where no curve tells: sampled on a grid that becomes finer, a few cells between two pictures.

/** Cells across and up; what a picture may wait for, and all of it may take, milliseconds. */
const GRIDS = [[10, 8], [20, 16], [40, 32]];
const [BUDGET, PATIENCE] = [8, 15_000];

/** `count(x, y)` is how many states there are, null where that is undecided; `show(areas)` draws the cells with more than one. */
export function createCounts(count, show) {
  let asked = 0;

  /** Over two ranges, anew, or over nothing; what is older is given up. */
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
