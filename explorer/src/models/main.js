// The page of a model that has no proved solver in JavaScript: its states are searched, and it says so.

import { SIGNS } from "../words.js";
import { whenColoursChange } from "../colours.js";
import { besides, createInputs } from "../inputs.js";
import { copied, linked, unlinked } from "../link.js";
import { createMechanism } from "../mechanism.js";
import { degrees, radians, written } from "../numbers.js";
import { createPanel } from "../panel.js";
import { createAlong } from "./along.js";
import { balanceAt } from "./balance.js";
import { carry, landing } from "./carry.js";
import { fieldOf } from "./field.js";
import { search } from "./search.js";
import { symbolOf } from "./symbols.js";

const $ = (id) => document.getElementById(id);
/** An angle of a spring is an anchor's if their directions agree to this. */
const SAME = 1e-9;

export function start({ algebra }) {
  const { model: about, presets, units } = JSON.parse($("data").textContent);
  const fields = about.parameters.map((entry) => ({ ...entry, symbol: symbolOf(entry.name) }));
  const ranges = Object.fromEntries(fields.map(({ name, range }) => [name, range]));
  const spans = Object.fromEntries(fields.map(({ name, angle, low, high }) => [name, (angle ? radians(1) : 1) * (high - low)]));
  const at = (point) => balanceAt(algebra, about, point);
  const names = about.coordinates.map(({ name }) => name);
  let now = null; // point, state that the mass is on, all states found, jumps

  // ------------------------------------------------------------------------------------------------ the state

  const listeners = [];
  function set(next) {
    now = { ...next, states: search(at(next.point), about) };
    const held = now.state && !now.states.undecided && !now.states.some((one) => one.contact === now.state.contact && near(one.q, now.state.q));
    now.states.push(...(held ? [now.state] : [])); // carried along, and not found anew
    listeners.forEach((listener) => listener());
  }

  const near = (a, b) => Math.max(...a.map((value, i) => Math.abs(value - b[i]))) < 1e-6;

  /** Without a way there: on the state nearest to `q`. */
  function place(point, q = names.map(() => 0)) {
    set({ point, state: landing(search(at(point), about), q), jumps: [] });
  }

  const store = {
    get: () => now,
    /** Move slowly on a straight way; the state follows. `base` is an earlier state of the page to start from instead. */
    move(change, base = now) {
      const point = { ...now.point, ...change };
      const way = carry(at, about, base.point, point, base.state, spans);
      set({ point, state: way.state, jumps: [...base.jumps, ...way.jumps] });
    },
  };

  // --------------------------------------------------------------------------------------------- what is drawn

  const rest = names.map(() => 0);
  const angles = fields.filter(({ angle }) => angle);
  const count = at(presets[0].point).vectors(rest).length;
  const mechanism = !about.drawn ? shownAsWritten() : createMechanism($("mechanism"), {
    anchor: (angle, i) => now && pinned(now.point, names.map(() => 0))[i].name && store.move({ [pinned(now.point, rest)[i].name]: Math.min(Math.PI - 1e-4, Math.max(1e-4, angle)) }),
    mass: thrown,
  }, count);

  /** Of a mechanism that is no mass on a belt: the drawing of its page, which stands still. */
  function shownAsWritten() {
    $("mechanism").className = "drawing";
    $("mechanism").append(document.querySelector("#space_part .drawing svg"));
    $("mechanism_note").textContent = "As its page draws it, not to scale. Its states and its motion are below, in numbers.";
    return { draw() {}, roll() {} };
  }

  /** Anchors of the springs as they are drawn, with the parameter that turns each, if there is one. */
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
    if (!about.drawn) {
      return;
    }
    const [x, y] = position(q);
    const others = now.states.filter((one) => one !== now.state && one.contact).map((one) => ({ x: position(one.q)[0], y: position(one.q)[1], word: one.word }));
    mechanism.draw({ to: pinned(now.point, q), x, y, ties: ties(now.point), others, ...more });
  }

  function still() {
    draw(now.state?.q ?? rest, { kind: now.state?.word ?? "", note: now.state ? "at rest on the sliding belt; pale: the other states" : "no state was found" });
  }

  const inputs = createInputs($("parameters"), store, fields, ranges, besides(units));
  const panel = createPanel(names, [], units ?? undefined, {
    field: () => fieldOf(algebra, about, at(now.point)),
    state: () => now.state?.q,
    frame: moved,
    rest: () => { mechanism.roll(0); if (now) { still(); } },
    begun: () => {},
  });

  function moved(t, state, { contact }) {
    mechanism.roll(t * (now.point[about.belt] ?? 0));
    draw(state.slice(0, names.length), { kind: contact ? "" : "off", note: `in motion, τ = ${t.toFixed(0)}; pale: the states` });
  }

  function thrown(x, y, let_go) {
    const q = [x, y, ...(now.state?.q.slice(2) ?? rest.slice(2))].slice(0, names.length);
    draw(q, { note: "let go, and it moves from here at rest" });
    panel.hold(q, let_go);
  }

  // ------------------------------------------------------------------------------------------ states in words

  const [length, length_name] = units?.length ?? [1, ""];
  const directed = Array.from({ length: count }, (_, i) => (count > 1 ? `θ${symbolOf(`x${i + 1}`).slice(1)} in °` : "θ in °"));
  const titles = ["", "regime", "stability", ...directed, ...names.map((name) => symbolOf(name) + (length_name && ` in ${length_name}`)), "growth", "undamped"];
  $("states").innerHTML = `<thead><tr>${titles.map((title) => `<th scope="col">${title}</th>`).join("")}</tr></thead><tbody></tbody>`;

  function row(state) {
    const line = document.createElement("tr");
    const chosen = state === now.state || (now.state && state.contact === now.state.contact && near(state.q, now.state.q));
    line.className = `${state.word}${chosen ? " chosen" : ""}`;
    if (chosen) {
      line.setAttribute("aria-current", "true");
    }
    const turned = Array.from({ length: count }, (_, i) => degrees(Math.atan2(state.along[3 * i + 1], state.along[3 * i])));
    const values = [...turned.map((value) => written(value, 8)), ...state.q.map((value) => written(length * value, 8)), written(state.rate, 3), state.stability];
    line.innerHTML = `<td>${chosen ? "<b title='the mass is here'>➤<span class='hidden'> the mass is here</span></b>" : ""}</td>
      <td>${about.unilateral ? (state.contact ? "contact" : "lift-off") : "sliding"}</td>
      <td><i aria-hidden="true">${SIGNS[state.word]}</i> ${state.word}</td>${values.map((value) => `<td>${value}</td>`).join("")}`;
    return line;
  }

  function say() {
    const many = now.states.length;
    const undecided = now.states.undecided;
    $("count").textContent = undecided ? "undecided" : `${many} found`;
    $("states").tBodies[0].replaceChildren(...now.states.map(row));
    const last = now.jumps.at(-1);
    const where = (q) => `${symbolOf(names[0])} = ${written(q[0], 4)}`;
    const jump = last ? ` Its last state ended${last.to ? `, and it jumped from ${where(last.from)} to ${where(last.to)}` : ""}.` : "";
    $("story").textContent = undecided ? "Undecided here: the search can't tell the states apart. The command below the table may." : now.state
      ? `${many} ${many === 1 ? "state was" : "states were"} found. The mass is at ${where(now.state.q)}, ${now.state.word}.${jump}`
      : `No state was found that the mass could keep.${jump} See the motion below.`;
    $("proof").textContent = command();
  }

  /** What proves the states of now. */
  function command() {
    const options = fields.filter(({ role }) => role !== "motion")
      .map(({ name, angle, flag }) => `${flag} ${Number((angle ? degrees(now.point[name]) : now.point[name]).toPrecision(12))}`);
    return `spragsym equilibria --model ${about.where} ${options.join(" ")}`;
  }

  // ------------------------------------------------------------------------------------------ along a parameter

  const choice = $("vary");
  fields.filter(({ role }) => role !== "motion").forEach(({ name, symbol, meaning }) => choice.append(new Option(`${symbol}, ${meaning}`, name)));
  const varied = () => fields.find(({ name }) => name === choice.value);
  const along = createAlong($("along"), {
    field: varied,
    search: (value) => search(at({ ...now.point, [choice.value]: value }), about),
    shown: () => now && [now.point[choice.value], now.state?.q[0] ?? null],
    go: (value) => store.move({ [choice.value]: value }),
  }, symbolOf(names[0]));
  let family = "";
  function renewed() {
    const { [choice.value]: _, ...others } = now.point;
    const key = JSON.stringify([choice.value, others]);
    if (key !== family) {
      family = key;
      along.renew();
    }
    along.draw();
  }
  choice.onchange = renewed;

  // ------------------------------------------------------------------------------------------------- the page

  let pending = false;
  listeners.push(() => {
    inputs(false);
    say();
    if (!pending) {
      pending = true;
      requestAnimationFrame(() => {
        pending = false;
        if (!panel.moving()) {
          still();
        }
        panel.changed();
        renewed();
        remember();
      });
    }
  });

  const link = () => {
    const q = Object.fromEntries((now.state?.q ?? []).map((value, i) => [`at_${names[i]}`, value]));
    return linked({ ...now.point, ...q }, angles.map(({ name }) => name));
  };
  let later = 0;
  function remember() {
    clearTimeout(later);
    later = setTimeout(() => history.replaceState(null, "", `#${link()}`), 250);
  }

  $("link").onclick = () => copied(link(), $("link_says"));

  presets.forEach(({ name }, i) => $("preset").append(new Option(name, i)));
  $("preset").onchange = () => { panel.still(); place({ ...presets[Number($("preset").value)].point }); inputs(true); };

  function open() {
    const marks = names.map((name) => `at_${name}`);
    const said = unlinked(location.hash, [...fields.map(({ name }) => name), ...marks], ranges) ?? {};
    const q = marks.map((mark, i) => said[mark] ?? rest[i]);
    panel.still();
    place({ ...presets[0].point, ...Object.fromEntries(Object.entries(said).filter(([name]) => !marks.includes(name))) }, q);
    inputs(true);
  }

  window.spragsym = Object.freeze({
    /** The states that the page finds at a point, searched and not proved. */
    equilibria: ({ contact = true, ...point }) => {
      const found = search(at({ ...presets[0].point, ...point }), about);
      const states = found.filter((state) => state.contact === contact);
      return { status: found.undecided ? "uncertain" : "searched", count: states.length, states: states.map(({ q, stability }) => ({ ...Object.fromEntries(q.map((value, i) => [names[i], value])), stability })) };
    },
    /** The motion at a point: `regime(state)` and `step(state, h)`. */
    motion: (point) => { const whole = { ...presets[0].point, ...point }; return fieldOf(algebra, about, at(whole)); },
  });
  const redraw = () => { along.resize(); panel.resize(); };
  new ResizeObserver(redraw).observe($("page"));
  whenColoursChange(() => { along.recolour(); panel.recolour(); });
  window.addEventListener("hashchange", open);
  open();
}
