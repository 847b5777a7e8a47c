// The article's model by its closed forms: states proved by the exported solver, the curves of its plane, and its surface.

import { described } from "../search.js";
import { createAsking } from "./asking.js";
import { follow } from "./follow.js";
import { createSpace } from "./space.js";
import { lowestFold } from "./lowest.js";
import { WAYS, walk } from "./walks.js";
import { radians } from "../numbers.js";

/** The parameters of the plane whose curves are known. */
const AXES = ["theta0", "mu0"];
const SIDES = [["in contact", true], ["in lift-off", false]];
const WHY = {
  uncertain: "double precision can't tell how many states there are here, or of which kind. The rows are a best guess; the Python package decides.",
  out_of_range: "numbers of this size are beyond double precision.",
};

/** What the page of the article's model has that others have not: a source of proved states, drawings of curves and surface, and walks. */
export function createClosed(solver) {
  const statics = (point) => Object.fromEntries(solver.NAMES.map((name) => [name, point[name]]));
  const solve = (point) => solver.equilibria(statics(point), { contact: true });
  const far = ({ x, y }, q) => Math.hypot(x - q[0], y - q[1]);
  const told = (balance, { x, y, theta, L, stability }, regime) => ({ ...described(balance, [x, y], regime, stability), along: [Math.cos(theta), Math.sin(theta), L] });
  const onBelt = (state) => state && { q: [state.x, state.y], regime: 0, undamped: state.stability };

  /** The source of states of a store, see createStore, and `count`, the number of those in contact, null where undecided. `at(point)` gives the balance. */
  function source(at) {
    function look(point) {
      const found = SIDES.map(([, contact]) => solver.equilibria(statics(point), { contact }));
      const states = found.flatMap(({ states: list }, i) => list.map((state) => ({ ...told(at(point), state, i), error: state.error })));
      const undecided = found.flatMap(({ status }, i) => (WHY[status] ? [`Undecided ${SIDES[i][0]}: ${WHY[status]}`] : [])).join(" ");
      return { states, undecided, lost: found[0].status !== "ok", proved: true, status: found.map(({ status }) => status) };
    }

    function begin(point, q) {
      const { samples, decided } = follow(solve, statics(point), statics(point), null);
      const kept = solve(point).states.filter(({ stability }) => stability !== "divergent");
      const nearest = q && kept.sort((a, b) => far(a, q) - far(b, q))[0];
      return { state: onBelt(nearest ?? samples[0]?.state) ?? null, decided };
    }

    function carry(from, to, state) {
      const [cosine, sine] = state ? at(from).directions(state.q) : [NaN, NaN];
      const { samples, decided } = follow(solve, statics(from), statics(to), state && Math.atan2(sine, cosine));
      const whole = samples.map(({ point, state: there, jump }) => ({ point: { ...to, ...point }, q: there ? [there.x, there.y] : undefined, jump }));
      return { state: samples.length ? onBelt(samples.at(-1).state) : state, decided, samples: whole };
    }

    function count(point) {
      const found = solve(point);
      return found.status === "ok" ? found.count : null;
    }

    return { look, begin, carry, count };
  }

  /** The drawings over the plane: `family` computes them anew where a parameter has changed that is not on the plane's axes. */
  function drawings({ element, store, plane }) {
    const ask = createAsking(solver);
    const space = createSpace(element("space"), store);
    let key = "";
    function family(point, top) {
      const { theta0, mu0, ...others } = statics(point);
      const next = JSON.stringify([others, top]);
      if (next === key) {
        return;
      }
      key = next;
      space?.reach(top);
      if (store.get().found.status.includes("out_of_range")) {
        plane.show(null, AXES);
        element("lowest").textContent = "";
        space?.hide();
        element("plane_says").textContent = "Not drawn: numbers of this size are beyond double precision.";
        return;
      }
      ask("curves", statics(point), top, (found, error) => {
        plane.show(found, AXES);
        element("lowest").textContent = lowestFold(found);
        space?.curves(found);
        element("plane_says").textContent = error ?? "";
      });
      if (space) {
        ask("surface", statics(point), top, (found) => (found ? space.show(found) : space.hide()));
      }
    }
    return { family, forget: () => { key = ""; }, draw: () => space?.draw(), resize: () => space?.resize(), recolour: () => space?.recolour() };
  }

  /** Makes the buttons start walks; `begin()` is called before each, and gives the values of the parameters that do not change. Returns what stops a walk. */
  function walks({ store, begin, quick }) {
    let stop = null;
    document.querySelectorAll("[data-walk]").forEach((button) => {
      button.onclick = () => {
        stop?.();
        const base = begin();
        const way = WAYS[button.dataset.walk];
        const on = ["back", "home"].includes(button.dataset.walk); // from where the point is
        if (!on) {
          store.place({ ...base, theta0: radians(way[0][0]), mu0: way[0][1] });
        }
        stop = walk(store, way.slice(on ? 0 : 1), quick(), () => { stop = null; });
      };
    });
    return () => stop?.();
  }

  return { axes: AXES, source, drawings, walks };
}
