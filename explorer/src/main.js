// The page of a model: makes its parts, and tells them of changes. The page calls `start` with the model's exported algebra, and for
// a model of closed forms with what createClosed gives.

import { createAlong } from "./along.js";
import { balanceAt } from "./balance.js";
import { createBodies } from "./bodies.js";
import { whenColoursChange } from "./colours.js";
import { createCounts } from "./counts.js";
import { fieldOf } from "./field.js";
import { createInputs } from "./inputs.js";
import { addressed, copied, linked, unlinked } from "./link.js";
import { createMechanism } from "./mechanism.js";
import { degrees, typed } from "./numbers.js";
import { createPanel } from "./panel.js";
import { createPlane } from "./plane.js";
import { searched } from "./searched.js";
import { spanOf } from "./spans.js";
import { counted, createStates, story } from "./states.js";
import { createStore, current } from "./store.js";
import { coordinatesIn, OWN, parametersIn } from "./units.js";

/** The element of the page with an id, but no input of a parameter, which may have the same id. */
const $ = (id) => document.querySelector(`#${id}:not(#parameters #${id})`);
const quick = () => matchMedia("(prefers-reduced-motion: reduce)").matches;
/** How long the drawing of a jump takes, milliseconds. */
const FLIGHT = 450;
/** A parameter is the inclination of a spring if it agrees with the spring's direction to this, radians. */
const SAME = 1e-9;
/** How far a body can be dragged from its origin, in the model's length. */
const REACH = 4;
/** An anchor is dragged no closer to an inclination of 0 or π than this, radians. */
const EDGE = 1e-4;

export { balanceAt, fieldOf };

export function start({ algebra, transition, closed = null }) {
  const { model: about, presets, units: own } = JSON.parse($("data").textContent);
  const units = own ?? OWN;
  const fields = parametersIn(units, about.parameters);
  const coordinates = coordinatesIn(units, about.coordinates);
  const named = (name) => fields.find((field) => field.name === name);
  const ranges = Object.fromEntries(fields.map(({ name, range }) => [name, range]));
  const at = (point) => balanceAt(algebra, about, point);
  const names = about.coordinates.map(({ name }) => name);
  const rest = names.map(() => 0);
  const count = at(presets[0].point).vectors(rest).length;
  const spans = Object.fromEntries(fields.map(({ name, one, low, high }) => [name, one * (high - low)]));
  const source = closed ? closed.source(at) : searched(at, about, spans);
  const store = createStore(source);
  const inputs = createInputs($("parameters"), store, fields, ranges);
  const table = createStates($("states"), store, at, { ...about, springs: count, proved: Boolean(closed) }, units);

  // -------------------------------------------------------------------------------------------- the mechanism

  const angles = fields.filter(({ angle }) => angle);
  const mechanism = about.scene ? createBodies($("mechanism"), about.scene, carried) : createMechanism($("mechanism"), {
    anchor: (angle, i) => store.get() && pinned(store.get().point, rest)[i].name && store.move({ [pinned(store.get().point, rest)[i].name]: Math.min(Math.PI - EDGE, Math.max(EDGE, angle)) }),
    mass: thrown,
  }, count);
  if (about.scene) {
    $("mechanism_note").textContent = "To scale, drawn from what the page says of bodies, contacts and springs. Drag a body and let go to see it move. Arrows: forces n and μn of the contacts.";
  }

  /** For every spring its anchor `at`, the end `from` of the unloaded spring, and the parameter that is its inclination, if one is. */
  function pinned(point, q) {
    const balance = at(point);
    const place = position(q);
    const unloaded = balance.vectors(rest);
    return balance.vectors(q).map(([dx, dy], i) => {
      const direction = Math.atan2(unloaded[i][1], unloaded[i][0]);
      const turner = angles.find(({ name }) => Math.abs(point[name] - direction) < SAME);
      const end = [place[0] + dx, place[1] + dy];
      const from = [end[0] - unloaded[i][0], end[1] - unloaded[i][1]];
      return { at: end, from, ...(turner ? { angle: point[turner.name], symbol: turner.symbol, name: turner.name } : {}) };
    });
  }

  /** Where the mass is drawn: at its first two coordinates, the second of which may be missing. */
  const position = (q) => [q[0], q[1] ?? 0];
  const ties = (point) => about.ties.map((ones) => ones.some((name) => name === "1" || point[name] > 0));

  function draw(q, more) {
    const now = store.get();
    const others = now.found.states.filter((one) => one !== current(now) && one.regime === 0);
    if (about.scene) {
      mechanism.draw({ q, balance: at(now.point), others: others.map((one) => ({ q: one.q, kind: one.undamped })), ...more });
      return;
    }
    const [x, y] = position(q);
    const pale = others.map((one) => ({ x: position(one.q)[0], y: position(one.q)[1], kind: one.undamped }));
    mechanism.draw({ to: pinned(now.point, q), x, y, ties: ties(now.point), others: pale, ...more });
  }

  /** Draws the mechanism at rest: in the current state, or at `q` on the way to it. */
  function still(now, q = null) {
    const state = current(now);
    draw(q ?? state?.q ?? rest, {
      kind: state?.undamped ?? "", note: state ? "at rest on the sliding belt; pale: the other states" : "no state in contact",
      forces: state && !q ? at(now.point).acting(state.q, state.regime) : null,
    });
  }

  let flight = null;
  /** Draws a jump as a short flight between the two states. */
  function fly(now) {
    const [from, to] = [flight?.q ?? now.last.from, now.last.to];
    const begun = performance.now();
    const mine = (flight = { q: from });
    const frame = (time) => {
      const share = Math.min(1, (time - begun) / FLIGHT);
      if (flight !== mine || panel.moving()) {
        return;
      }
      mine.q = from.map((value, k) => value + (1 - (1 - share) ** 3) * (to[k] - value));
      if (share < 1) {
        still(store.get(), mine.q);
        requestAnimationFrame(frame);
      } else {
        flight = null;
        still(store.get());
      }
    };
    requestAnimationFrame(frame);
  }

  // ----------------------------------------------------------------------------------------------- the motion

  const panel = createPanel(about, coordinates, units.time, {
    field: () => fieldOf(algebra, transition, about, at(store.get().point)),
    state: () => current(store.get())?.q,
    frame: moved,
    rest: () => { mechanism.roll([]); if (store.get()) { still(store.get()); } },
    begun: () => { flight = null; },
  });

  function moved(t, state, { touching }) {
    mechanism.roll(about.frictions.map(({ belt }) => t * (store.get().point[belt] ?? 0)));
    draw(state.slice(0, names.length), { kind: touching.every(Boolean) ? "" : "off", note: `in motion, ${units.time[1] ? `at ${typed(units.time[0] * t, 3)} ${units.time[1]}` : `τ = ${t.toFixed(0)}`}; pale: the states` });
  }

  /** Draws the mass where it is dragged to; let go, it moves from there. */
  function thrown(x, y, let_go) {
    const place = [Math.max(-1.7, Math.min(2, x)), Math.max(-0.1, Math.min(1.4, y))];
    const q = [...place, ...(current(store.get())?.q.slice(2) ?? rest.slice(2))].slice(0, names.length);
    draw(q, { note: "let go, and it moves from here at rest" });
    panel.hold(q, let_go);
  }

  /** Draws body `b` where it is dragged to, the others where they are; let go, all move from there. */
  function carried(b, place, let_go) {
    const q = [...(current(store.get())?.q ?? rest)];
    Object.entries(place).forEach(([kind, value]) => {
      if (about.scene.bodies[b][kind] !== undefined) {
        q[about.scene.bodies[b][kind]] = Math.max(-REACH, Math.min(REACH, value));
      }
    });
    draw(q, { note: "let go, and it moves from here at rest" });
    panel.hold(q, let_go);
  }

  // -------------------------------------------------------------------------------------------- the two drawings

  const balanced = fields.filter(({ role }) => role !== "motion");
  const plane = about.axes.length > 1 ? createPlane($("plane"), store, about.axes.map(named)) : null;
  const counts = plane && createCounts((...place) => {
    const there = Object.fromEntries(plane.axes().map(({ name }, i) => [name, place[i]]));
    return source.count({ ...store.get().point, ...there });
  }, (areas) => plane.show({ areas }, plane.axes().map(({ name }) => name)));
  const drawings = plane && closed?.drawings({ element: $, store, plane });
  const known = () => closed && plane.axes().every(({ name }, i) => name === closed.axes[i]);
  const chosen = ["across", "upward"].map($);
  if (plane) {
    chosen.forEach((choice, i) => {
      balanced.forEach(({ name, symbol, meaning }) => choice.append(new Option(`${symbol}, ${meaning}`, name)));
      choice.value = about.axes[i];
      choice.onchange = () => {
        const [one, other] = plane.axes().map(({ name }) => name);
        if (chosen[i].value === [other, one][i]) {
          chosen[1 - i].value = [one, other][i]; // they change places
        }
        sampled = "";
        counts(null);
        plane.turn(chosen.map(({ value }) => named(value)));
        drawings?.forget();
        renewed();
      };
    });
  } else {
    $("plane_part").hidden = true;
  }

  const choice = $("vary");
  balanced.forEach(({ name, symbol, meaning }) => choice.append(new Option(`${symbol}, ${meaning}`, name)));
  choice.value = about.axes[0];
  choice.onchange = () => renewed();
  const along = createAlong($("along"), {
    field: () => named(choice.value),
    span: () => spanOf(named(choice.value), (store.get() ?? presets[0]).point[choice.value]),
    states: (value) => source.look({ ...store.get().point, [choice.value]: value }).states,
    shown: () => store.get() && [store.get().point[choice.value], current(store.get())?.q[0] ?? null],
    go: (value) => store.move({ [choice.value]: value }),
  }, coordinates[0]);

  let [sampled, searched_along] = ["", ""];
  /** Draws plane and curve along a parameter, computed anew where a parameter has changed that is not on their axes. */
  function renewed() {
    const { point } = store.get();
    const without = (...left_out) => JSON.stringify(Object.entries(point).filter(([name]) => !left_out.includes(name)));
    if (plane) {
      plane.reach(point);
      const [across, upward] = plane.spans();
      const key = `${plane.axes().map(({ name }) => name)} ${without(...plane.axes().map(({ name }) => name))} ${across} ${upward}`;
      $("plane_says").textContent = "";
      $("sampled").hidden = Boolean(known());
      if (known()) {
        drawings.family(point, upward[1]);
      } else if (key !== sampled) {
        plane.show(null, plane.axes().map(({ name }) => name));
        counts([across, upward]);
      }
      sampled = key;
      plane.draw();
      drawings?.draw();
    }
    const key = `${choice.value} ${without(choice.value)} ${spanOf(named(choice.value), point[choice.value])}`;
    if (key !== searched_along) {
      searched_along = key;
      along.renew();
    }
    along.draw();
  }

  // ------------------------------------------------------------------------------------------------- in words

  /** The command with which the Python package computes the states at a point. */
  function command(point) {
    const options = balanced.map(({ name, angle, flag }) => `${flag} ${Number((angle ? degrees(point[name]) : point[name]).toPrecision(12))}`);
    return `spragsym equilibria --model ${about.quoted} ${options.join(" ")}`;
  }

  let quiet = 0;
  function say(now) {
    $("status").textContent = now.found.undecided;
    $("count").textContent = counted(about, now.found);
    $("story").textContent = story(now, about, fields, units);
    $("proof").textContent = command(now.point);
    clearTimeout(quiet);
    quiet = setTimeout(() => ($("spoken").textContent = $("story").textContent), 700); // a reader hears where it ends, not all of the way
  }

  let pending = false;
  let jumped = false;
  store.listen((now, happened) => {
    jumped ||= happened.jumped;
    table();
    inputs(happened.placed);
    say(now);
    if (!pending) {
      pending = true;
      requestAnimationFrame(() => { pending = false; drawn(); jumped = false; });
    }
  });

  function drawn() {
    const now = store.get();
    if (jumped && now.last?.to && current(now) && !quick() && !panel.moving()) {
      fly(now);
    } else if (!panel.moving() && !flight) {
      still(now);
    }
    panel.changed();
    renewed();
    remember();
  }

  // --------------------------------------------------------------------------------------- links, presets, walks

  const link = () => {
    const { point, state } = store.get();
    return linked({ ...point, ...Object.fromEntries((state?.q ?? []).map((value, i) => [`at_${names[i]}`, value])) }, angles.map(({ name }) => name));
  };
  let later = 0;
  function remember() {
    clearTimeout(later);
    later = setTimeout(() => addressed(`#${link()}`), 250);
  }

  presets.forEach(({ name }, i) => $("preset").append(new Option(name, i)));
  $("preset").onchange = () => {
    panel.still();
    store.place(presets[Number($("preset").value)].point);
    $("preset").blur();
  };
  const stop = closed?.walks({ store, quick, begin: () => { panel.still(); return presets[0].point; } }) ?? (() => {});
  $("plane").addEventListener("pointerdown", stop);
  $("forget").onclick = () => store.forget();
  $("link").onclick = () => copied(link(), $("link_says"));

  function open() {
    const marks = names.map((name) => `at_${name}`);
    const said = unlinked(location.hash, [...fields.map(({ name }) => name), ...marks], ranges, angles.map(({ name }) => name)) ?? {};
    const q = marks.some((mark) => mark in said) ? marks.map((mark, i) => said[mark] ?? rest[i]) : null;
    panel.still();
    store.place({ ...presets[0].point, ...Object.fromEntries(Object.entries(said).filter(([name]) => !marks.includes(name))) }, q);
  }

  /** A state as scripts read it: coordinates, direction and length of every spring, stability. */
  function told({ q, along: lines, stability, undamped, error }) {
    const directed = Array.from({ length: count }, (_, i) => {
      const name = count > 1 ? `_${i + 1}` : "";
      return [[`theta${name}`, Math.atan2(lines[3 * i + 1], lines[3 * i])], [`L${name}`, lines[3 * i + 2]]];
    });
    return { ...Object.fromEntries([...names.map((name, i) => [name, q[i]]), ...directed.flat()]), stability, undamped, error };
  }

  window.spragsym = Object.freeze({
    /** The states at a point: `status` is "ok" where they are proved, "searched" where they are searched, else the reason why nothing is decided. */
    equilibria: ({ contact = true, ...point }) => {
      const found = source.look({ ...presets[0].point, ...point });
      const regime = about.regimes.findIndex((one) => String(one.contact) === String(contact));
      const states = found.states.filter((state) => state.regime === regime).map(told);
      return { status: found.status?.[regime] ?? (found.lost ? "uncertain" : "searched"), count: states.length, states };
    },
    /** The motion at a point: `regime(state)` and `step(state, h)`. */
    motion: (point) => fieldOf(algebra, transition, about, at({ ...presets[0].point, ...point })),
  });
  const redraw = () => { [plane, along, drawings, panel].forEach((part) => part?.resize()); };
  new ResizeObserver(redraw).observe($("page"));
  const recolour = () => { [plane, along, drawings, panel].forEach((part) => part?.recolour()); };
  whenColoursChange(recolour);
  ["beforeprint", "afterprint"].forEach((turn) => window.addEventListener(turn, () => {
    const printed = document.documentElement.classList.toggle("printed", turn === "beforeprint");
    const { style, scrollWidth, parentNode: { clientWidth } } = $("states");
    style.zoom = printed ? Math.min(1, clientWidth / scrollWidth) : 1; // no column is cut
    recolour();
    redraw();
  }));
  window.addEventListener("hashchange", open);
  open();
}
