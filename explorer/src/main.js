// The page: parts made, and told of changes. `start` is called by the page with everything that the exported module offers.

import { createAsking } from "./asking.js";
import { createCharts } from "./charts.js";
import { whenColoursChange } from "./colours.js";
import { forces } from "./forces.js";
import { createInputs, wrong } from "./inputs.js";
import { linked, unlinked } from "./link.js";
import { createMechanism } from "./mechanism.js";
import { createMotion } from "./motion.js";
import { degrees, parsed, radians, typed, written } from "./numbers.js";
import { createPlane } from "./plane.js";
import { createSpace } from "./space.js";
import { createStates, story, undecided } from "./states.js";
import { createStore, current } from "./store.js";
import { WAYS, walk } from "./walks.js";

const $ = (id) => document.getElementById(id);
const still = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
/** How long the drawing of a jump takes, milliseconds. */
const FLIGHT = 450;

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
  const inputs = createInputs($("parameters"), store, solver.RANGES);
  const table = createStates($("states"), store, solver.algebra);
  const charts = createCharts({ trace: $("trace"), phase: $("phase"), spectrum: $("spectrum") });

  let [moving, top, frames, belt, flight] = [false, 1, 0, 0, null];
  const motion = createMotion(solver.motion, { sample: charts.add, frame: moved, stop: (message) => { $("motion_says").textContent = message; buttons(); } });

  // ------------------------------------------------------------------------------------------------ the state

  function rest(now, x, y) {
    const state = current(now);
    const drawn = state ? { x: x ?? state.x, y: y ?? state.y } : { x: 0, y: 0 };
    mechanism.draw({
      ...now.point, ...drawn, others: now.found.contact.states.filter((other) => other !== state), kind: state?.stability ?? "",
      forces: state && x === undefined ? forces(solver.algebra, now.point, state, true) : null,
      note: state ? "at rest on the sliding belt; pale: the other states" : "no state in contact",
    });
  }

  /** A jump is drawn as a short flight between the two states. */
  function fly(now) {
    const [from, to] = [now.last.from, current(now)];
    const before = flight?.at ?? placeOf(from, now.point);
    const begun = performance.now();
    const mine = (flight = { at: before });
    const frame = (time) => {
      const share = Math.min(1, (time - begun) / FLIGHT);
      if (flight !== mine || moving) {
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
    $("story").textContent = story(now);
    clearTimeout(quiet);
    quiet = setTimeout(() => ($("spoken").textContent = story(now)), 700); // a reader hears where it ends, not all of the way
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
    if (kinds.has("jump") && now.last && current(now) && !still() && !moving) {
      fly(now);
    } else if (!moving && !flight) {
      rest(now);
    }
    plane.draw();
    space?.draw();
    if (moving) {
      motion.set(now.point, drive);
    }
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
      space?.hide();
      $("plane_says").textContent = "Not drawn: numbers of this size are beyond double precision.";
      return;
    }
    ask("curves", point, top, (found, error) => { plane.show(found); space?.curves(found); $("plane_says").textContent = error ?? ""; });
    if (space) {
      ask("surface", point, top, (found) => (found ? space.show(found) : space.hide()));
    }
  }

  let later = 0;
  function remember() {
    clearTimeout(later);
    later = setTimeout(() => history.replaceState(null, "", `#${linked(store.get(), drive)}`), 250);
  }

  // ----------------------------------------------------------------------------------------------- the motion

  function moved(t, state) {
    const [x, y, vx] = state;
    const now = store.get();
    frames += 1;
    belt = t * drive.V;
    mechanism.roll(belt);
    const off = y >= 0;
    mechanism.draw({ ...now.point, x, y, others: now.found.contact.states, kind: off ? "off" : "", note: `in motion, τ = ${t.toFixed(0)}; pale: the states` });
    $("motion_says").textContent = `${off ? "off the belt" : "on the belt"}, ${vx > drive.V ? "faster than the belt" : "slower than the belt"}`;
    if (frames % 2 === 0) {
      charts.draw(frames % 16 === 0);
    }
  }

  function launch(from) {
    const now = store.get();
    motion.set(now.point, drive);
    charts.clear();
    moving = true;
    flight = null;
    motion.start(from);
    motion.play();
    buttons();
  }

  /** The mass as it is dragged, and let go. */
  function thrown(x, y, let_go) {
    const [kept_x, kept_y] = [Math.max(-1.7, Math.min(2, x)), Math.max(-0.1, Math.min(1.4, y))];
    motion.pause();
    moving = true;
    ["x0", "y0", "vx0", "vy0"].forEach((name, i) => ($(name).value = typed([kept_x, kept_y, 0, 0][i], 5)));
    const now = store.get();
    mechanism.draw({ ...now.point, x: kept_x, y: kept_y, others: now.found.contact.states, note: "let go, and it moves from here at rest" });
    if (let_go) {
      launch([kept_x, kept_y, 0, 0]);
    }
    buttons();
  }

  function buttons() {
    $("play").textContent = motion.running() ? "Pause" : "Run";
    $("play").setAttribute("aria-pressed", String(motion.running()));
    $("still").disabled = !moving;
  }

  function numbersOf(names) {
    const found = {};
    for (const name of names) {
      const box = $(name);
      const value = parsed(box.value);
      const problem = wrong(solver.RANGES[name] ? name : "x", name, value, box.value, solver.RANGES);
      box.setAttribute("aria-invalid", String(Boolean(problem)));
      if (problem) {
        $("motion_says").textContent = problem;
        return null;
      }
      found[name] = value;
    }
    return found;
  }

  function begin() {
    const from = numbersOf(["x0", "y0", "vx0", "vy0", "V", "d"]);
    if (from) {
      [drive.V, drive.d] = [from.V, from.d];
      launch([from.x0, from.y0, from.vx0, from.vy0]);
      remember();
    }
  }

  $("play").onclick = () => {
    if (motion.running()) {
      motion.pause();
    } else if (moving && charts_have_begun) {
      motion.play();
    } else {
      begin();
    }
    charts_have_begun = true;
    buttons();
  };
  let charts_have_begun = false;
  $("restart").onclick = () => { charts_have_begun = true; begin(); };
  $("still").onclick = () => { motion.pause(); moving = false; charts_have_begun = false; $("motion_says").textContent = ""; mechanism.roll(0); if (store.get()) { rest(store.get()); } buttons(); };
  $("from_state").onclick = () => {
    const state = current(store.get());
    if (state) {
      [["x0", state.x + 0.01], ["y0", state.y], ["vx0", 0], ["vy0", 0]].forEach(([name, value]) => ($(name).value = typed(value, 8)));
      charts_have_begun = true;
      begin();
    }
  };
  $("pace").oninput = () => { motion.pace(Number($("pace").value)); $("pace_says").textContent = `${$("pace").value} units of τ a second`; };
  ["V", "d"].forEach((name) => ($(name).onchange = () => { const said = numbersOf(["V", "d"]); if (said) { Object.assign(drive, said); remember(); } }));

  // --------------------------------------------------------------------------------------------- presets, walks

  const choice = $("preset");
  data.presets.forEach(({ name }, i) => choice.append(new Option(name, i)));
  choice.onchange = () => {
    const { point, theta } = data.presets[Number(choice.value)];
    $("still").onclick();
    store.place(point, theta ?? null);
    choice.blur();
  };

  let stop = null;
  document.querySelectorAll("[data-walk]").forEach((button) => {
    button.onclick = () => {
      stop?.();
      $("still").onclick();
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
  $("link").onclick = async () => {
    const text = `${location.href.split("#")[0]}#${linked(store.get(), drive)}`;
    history.replaceState(null, "", text);
    try {
      await navigator.clipboard.writeText(text);
      $("link_says").textContent = "The link is copied.";
    } catch {
      $("link_says").textContent = "The address now carries the state: copy it from there.";
    }
  };

  // ----------------------------------------------------------------------------------------------------- begin

  function open() {
    const said = unlinked(location.hash, solver.NAMES, solver.RANGES);
    const { V = drive.V, d = drive.d, theta = null, ...point } = said ?? {};
    Object.assign(drive, { V, d });
    Object.entries(drive).forEach(([name, value]) => ($(name).value = typed(value)));
    $("still").onclick();
    store.place({ ...data.presets[0].point, ...point }, theta);
  }

  const redraw = () => { plane.resize(); space?.resize(); charts.resize(); };
  new ResizeObserver(redraw).observe($("page"));
  whenColoursChange(() => { plane.recolour(); space?.recolour(); charts.recolour(); });
  window.addEventListener("hashchange", open);
  $("pace").oninput();
  buttons();
  open();
}
