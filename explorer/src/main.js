// The page: parts made, and told of changes. `start` is called by the page with everything that the exported module offers.

import { createAsking } from "./asking.js";
import { whenColoursChange } from "./colours.js";
import { forces } from "./forces.js";
import { besides, createInputs } from "./inputs.js";
import { copied, linked, unlinked } from "./link.js";
import { createMechanism } from "./mechanism.js";
import { radians } from "./numbers.js";
import { createPanel } from "./panel.js";
import { createPlane, lowestFold } from "./plane.js";
import { createSpace } from "./space.js";
import { createStates, story, undecided } from "./states.js";
import { createStore, current } from "./store.js";
import { WAYS, walk } from "./walks.js";
import { worded } from "./words.js";

const $ = (id) => document.getElementById(id);
const still = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
/** How long the drawing of a jump takes, milliseconds. */
const FLIGHT = 450;
/** What the parameters mean, and what their sliders span; a number may be anything that is allowed. */
const FIELDS = [
  ["theta0", "θ₀", "inclination of the spring", 0.5, 179.5],
  ["mu0", "μ₀", "friction coefficient", 0, 1],
  ["kappa", "κ", "preload", 0.001, 0.05],
  ["alpha", "α", "stiffness along the belt", 0, 1],
  ["sigma", "σ", "stiffness of the inclined spring", 0.02, 1],
  ["beta", "β", "stiffness across the belt", 0, 3],
].map(([name, symbol, meaning, low, high]) => ({ name, symbol, meaning, low, high, angle: name === "theta0" }));

export function start(solver) {
  const data = JSON.parse($("data").textContent);
  window.spragsym = Object.freeze({ equilibria: ({ contact = true, ...point }) => solver.equilibria(point, { contact }) });
  const store = createStore(solver);
  const drive = { ...data.drive };
  const ask = createAsking(solver);
  const anchor = (theta0) => store.move({ theta0: Math.min(Math.PI - 1e-4, Math.max(1e-4, theta0)) });
  const mechanism = createMechanism($("mechanism"), { anchor, mass: thrown });
  const plane = createPlane($("plane"), store);
  const space = createSpace($("space"), store);
  const inputs = createInputs($("parameters"), store, FIELDS, solver.RANGES, besides(data.units));
  const table = createStates($("states"), store, solver.algebra, drive, data.units ?? undefined);
  const assumed = [["V", "speed of the belt"], ["d", "steepness of the friction law"]]
    .map(([id, meaning]) => ({ id, symbol: id, meaning, value: drive[id], range: solver.RANGES[id] }));
  const panel = createPanel(["x", "y"], assumed, data.units ?? undefined, {
    beside: besides(data.units),
    field: (numbers) => fieldOf(solver.motion, store.get().point, numbers),
    state: () => { const state = current(store.get()); return state && [state.x, state.y]; },
    frame: moved,
    rest: () => { mechanism.roll(0); if (store.get()) { rest(store.get()); } },
    begun: (numbers) => { flight = null; Object.assign(drive, numbers); remember(); },
  });
  ["V", "d"].forEach((name) => ($(name).onchange = () => { const said = panel.numbersOf(); if (said) { Object.assign(drive, said); remember(); if (store.get()) { table(); say(store.get()); } } }));

  let [top, flight] = [1, null];

  // ------------------------------------------------------------------------------------------------ the state

  function rest(now, x, y) {
    const state = current(now);
    const drawn = state ? { x: x ?? state.x, y: y ?? state.y } : { x: 0, y: 0 };
    mechanism.draw({
      ...held(now.point), ...drawn, others: now.found.contact.states.filter((other) => other !== state).map((other) => ({ ...other, word: wordAt(other) })), kind: state ? wordAt(state) : "",
      forces: state && x === undefined ? forces(solver.algebra, now.point, state, true) : null,
      note: state ? "at rest on the sliding belt; pale: the other states" : "no state in contact",
    });
  }

  const wordAt = (state) => worded(solver.algebra, store.get().point, state, true, drive).word;

  /** What holds the mass, as it is drawn. */
  function held({ theta0, alpha, beta }) {
    return { to: [{ at: [Math.cos(theta0), Math.sin(theta0)], angle: theta0, symbol: "θ₀" }], ties: [alpha > 0, beta > 0] };
  }

  /** A jump is drawn as a short flight between the two states. */
  function fly(now) {
    const [from, to] = [now.last.from, current(now)];
    const before = flight?.at ?? placeOf(from, now.point);
    const begun = performance.now();
    const mine = (flight = { at: before });
    const frame = (time) => {
      const share = Math.min(1, (time - begun) / FLIGHT);
      if (flight !== mine || panel.moving()) {
        return;
      }
      const [x, y] = [0, 1].map((k) => before[k] + (1 - (1 - share) ** 3) * ([to.x, to.y][k] - before[k]));
      mine.at = [x, y];
      if (share < 1) {
        rest(store.get(), x, y);
        requestAnimationFrame(frame);
      } else {
        flight = null;
        rest(store.get());
      }
    };
    requestAnimationFrame(frame);
  }

  function placeOf(theta, point) {
    const { theta0, kappa, sigma, beta } = point;
    const [, x, y] = solver.algebra.state(Math.cos(theta), Math.sin(theta), Math.cos(theta0), Math.sin(theta0), kappa, sigma, beta, 1);
    return [x, y];
  }

  let pending = false;
  const kindsPending = new Set();
  store.listen((now, kinds) => {
    kinds.forEach((kind) => kindsPending.add(kind));
    table();
    inputs(kinds.has("place"));
    say(now);
    if (!pending) {
      pending = true;
      requestAnimationFrame(() => { pending = false; drawn(new Set(kindsPending)); kindsPending.clear(); });
    }
  });

  let quiet = 0;
  function say(now) {
    $("status").textContent = undecided(now.found);
    $("count").textContent = now.found.contact.status === "ok" ? `${now.found.contact.count} in contact, ${now.found.liftoff.count} in lift-off` : "undecided";
    $("story").textContent = story(now, solver.algebra, drive, data.units?.length);
    clearTimeout(quiet);
    quiet = setTimeout(() => ($("spoken").textContent = $("story").textContent), 700); // a reader hears where it ends, not all of the way
  }

  function drawn(kinds) {
    const now = store.get();
    const wanted = now.point.mu0 <= 0.999 ? 1 : 2 ** Math.ceil(Math.log2(1.05 * now.point.mu0));
    if (wanted !== top) {
      top = wanted;
      plane.reach(top);
      space?.reach(top);
      kinds.add("family");
    }
    if (kinds.has("family")) {
      shapes(now.point);
    }
    if (kinds.has("jump") && now.last && current(now) && !still() && !panel.moving()) {
      fly(now);
    } else if (!panel.moving() && !flight) {
      rest(now);
    }
    plane.draw();
    space?.draw();
    panel.changed();
    remember();
  }

  let family = "";
  function shapes({ theta0, mu0, ...point }) { // drawings are of all theta0 and mu0
    const key = JSON.stringify([point, top]);
    if (key === family) {
      return;
    }
    family = key;
    const { contact, liftoff } = store.get().found;
    if ([contact, liftoff].some(({ status }) => status === "out_of_range")) {
      plane.show(null);
      $("lowest").textContent = "";
      space?.hide();
      $("plane_says").textContent = "Not drawn: numbers of this size are beyond double precision.";
      return;
    }
    ask("curves", point, top, (found, error) => { plane.show(found); $("lowest").textContent = lowestFold(found); space?.curves(found); $("plane_says").textContent = error ?? ""; });
    if (space) {
      ask("surface", point, top, (found) => (found ? space.show(found) : space.hide()));
    }
  }

  const link = () => linked({ ...store.get().point, theta: store.get().theta, ...drive }, ["theta0", "theta"]);
  let later = 0;
  function remember() {
    clearTimeout(later);
    later = setTimeout(() => history.replaceState(null, "", `#${link()}`), 250);
  }

  // ----------------------------------------------------------------------------------------------- the motion

  function moved(t, [x, y], { contact }) {
    const now = store.get();
    mechanism.roll(t * drive.V);
    mechanism.draw({ ...held(now.point), x, y, others: now.found.contact.states, kind: contact ? "" : "off", note: `in motion, τ = ${t.toFixed(0)}; pale: the states` });
  }

  /** The mass as it is dragged, and let go. */
  function thrown(x, y, let_go) {
    const at = [Math.max(-1.7, Math.min(2, x)), Math.max(-0.1, Math.min(1.4, y))];
    const now = store.get();
    mechanism.draw({ ...held(now.point), x: at[0], y: at[1], others: now.found.contact.states, note: "let go, and it moves from here at rest" });
    panel.hold(at, let_go);
  }

  // --------------------------------------------------------------------------------------------- presets, walks

  const choice = $("preset");
  data.presets.forEach(({ name }, i) => choice.append(new Option(name, i)));
  choice.onchange = () => {
    const { point, theta } = data.presets[Number(choice.value)];
    panel.still();
    store.place(point, theta ?? null);
    choice.blur();
  };

  let stop = null;
  document.querySelectorAll("[data-walk]").forEach((button) => {
    button.onclick = () => {
      stop?.();
      panel.still();
      const way = WAYS[button.dataset.walk];
      const on = ["back", "home"].includes(button.dataset.walk); // from where the point is
      if (!on) {
        store.place({ ...data.presets[0].point, theta0: radians(way[0][0]), mu0: way[0][1] });
      }
      stop = walk(store, way.slice(on ? 0 : 1), still(), () => { stop = null; });
    };
  });
  $("plane").addEventListener("pointerdown", () => stop?.());
  $("forget").onclick = () => store.forget();
  $("link").onclick = () => copied(link(), $("link_says"));

  // ----------------------------------------------------------------------------------------------------- begin

  function open() {
    const said = unlinked(location.hash, [...solver.NAMES, "theta", "V", "d"], solver.RANGES);
    const { V = drive.V, d = drive.d, theta = null, ...point } = said ?? {};
    Object.assign(drive, { V, d });
    panel.put(drive);
    panel.still();
    store.place({ ...data.presets[0].point, ...point }, theta);
  }

  const redraw = () => { plane.resize(); space?.resize(); panel.resize(); };
  new ResizeObserver(redraw).observe($("page"));
  whenColoursChange(() => { plane.recolour(); space?.recolour(); panel.recolour(); });
  window.addEventListener("hashchange", open);
  open();
}

/** Stiff supports and steep creep need short steps: a share of the shortest period or time constant that they may give. */
function fieldOf(motion, point, drive) {
  const { alpha, beta, sigma, mu0, kappa } = point;
  const fastest = Math.max(Math.sqrt(Math.max(1, alpha + sigma, 1 + beta + sigma)), 0.02 * mu0 * drive.d * Math.max(kappa, 0.02));
  return { ...motion(point, drive), pieces: (state, time, longest) => Math.min(1000, Math.ceil((time / longest) * fastest)) };
}
