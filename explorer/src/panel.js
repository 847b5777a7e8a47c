// The panel of the motion: its start, its buttons and its charts.

import { createCharts } from "./charts.js";
import { wrong } from "./inputs.js";
import { createMotion } from "./motion.js";
import { parsed, typed } from "./numbers.js";

/** The element of the page with an id, but no input of a parameter, which may have the same id. */
const $ = (id) => document.querySelector(`#${id}:not(#parameters #${id})`);
/** The charts are drawn with every second picture, the spectrum with every sixteenth. */
const [EVERY, SPECTRUM] = [2, 16];
/** How the mass moves, by the sign of the sliding speed. */
const PACE = { 1: "slower than the belt", 0: "held by friction", [-1]: "faster than the belt" };
const STOPPED = "The motion can't go on from here: a spring has no length, or the numbers leave double precision. Choose another start.";

/**
 * The first argument describes the model; `coordinates` and `time` are as in createCharts. `on.field()` gives the field at the page's point, `on.state()`
 * the coordinates of the current state, `on.frame(t, state, regime)` draws the mechanism; `on.begun()` is called when a motion begins, `on.rest()` when the
 * mechanism is put back to rest.
 */
export function createPanel({ contacts, frictions }, coordinates, time, on) {
  const charts = createCharts({ trace: $("trace"), phase: $("phase"), spectrum: $("spectrum") }, coordinates, time);
  const starts = [
    ...coordinates.map(({ name, symbol, size, unit }) => ({ id: `${name}0`, symbol, size, unit, meaning: `${name} at the start` })),
    ...coordinates.map(({ name, symbol, rate, rate_unit }) => ({ id: `v${name}0`, symbol: `${symbol}′`, size: rate, unit: rate_unit, meaning: `rate of ${name} at the start` })),
  ];
  let [moving, frames, begun] = [false, 0, false];
  const motion = createMotion({ sample: charts.add, frame: moved, stop: () => { $("motion_says").textContent = STOPPED; buttons(); } });
  starts.forEach(({ id, symbol, meaning, unit }) => {
    const label = document.createElement("label");
    label.innerHTML = `${symbol} <input id="${id}" type="text" inputmode="decimal" autocomplete="off" aria-label="${meaning}"> <span></span>`;
    label.lastElementChild.textContent = unit;
    label.firstElementChild.value = "0";
    $("starts").append(label);
  });

  function moved(t, state, regime) {
    frames += 1;
    on.frame(t, state, regime);
    $("motion_says").textContent = contacts.flatMap(({ name, border }, k) => {
      const paces = frictions.flatMap(({ contact }, j) => (contact === k ? PACE[regime.sides[j]] : []));
      const touches = regime.touching[k] ? ["on the belt", "touches"] : ["off the belt", "is open"];
      const says = paces.length ? `${touches[0]}, ${paces}` : border === null ? "" : touches[1];
      return says ? `${name && `${name}: `}${says}` : [];
    }).join("; ");
    if (frames % EVERY === 0) {
      charts.draw(frames % SPECTRUM === 0);
    }
  }

  function buttons() {
    $("play").textContent = motion.running() ? "Pause" : "Run";
    $("play").setAttribute("aria-pressed", String(motion.running()));
    $("still").disabled = !moving;
  }

  /** The initial state that is typed, or null after showing what is wrong with it. */
  function said() {
    const found = [];
    for (const { id, symbol, size } of starts) {
      const box = $(id);
      const value = parsed(box.value);
      const problem = wrong({ symbol, one: 1 }, value, box.value);
      box.setAttribute("aria-invalid", String(Boolean(problem)));
      if (problem) {
        $("motion_says").textContent = problem;
        return null;
      }
      found.push(value / size);
    }
    return found;
  }

  function begin() {
    const from = said();
    if (!from) {
      return;
    }
    motion.set(on.field());
    charts.clear();
    [moving, begun] = [true, true];
    $("motion_says").textContent = "";
    try {
      motion.start(from);
      motion.play();
    } catch {
      $("motion_says").textContent = STOPPED;
    }
    on.begun();
    buttons();
  }

  function show(state) {
    starts.forEach(({ id, size }, i) => ($(id).value = typed(size * state[i], 8)));
  }

  /** Makes `q`, at rest, the initial state, as a body is held there; let go, the motion begins. */
  function hold(q, let_go) {
    motion.pause();
    moving = true;
    show([...q, ...q.map(() => 0)]);
    if (let_go) {
      begin();
    }
    buttons();
  }

  function still() {
    motion.pause();
    [moving, begun] = [false, false];
    $("motion_says").textContent = "";
    on.rest();
    buttons();
  }

  $("play").onclick = () => {
    if (motion.running()) {
      motion.pause();
    } else if (moving && begun) {
      motion.play();
    } else {
      begin();
    }
    buttons();
  };
  $("restart").onclick = begin;
  $("still").onclick = still;
  $("from_state").onclick = () => {
    const q = on.state();
    if (q) {
      show([q[0] + 0.01, ...q.slice(1), ...q.map(() => 0)]);
      begin();
    }
  };
  $("pace").oninput = () => { motion.pace(Number($("pace").value)); $("pace_says").textContent = time[1] ? `${typed(time[0] * Number($("pace").value), 3)} ${time[1]} of the motion a second` : `${$("pace").value} units of τ a second`; };
  $("pace").oninput();
  buttons();

  return {
    hold, still,
    moving: () => moving,
    /** To be called when the page's point has changed: a running motion goes on under the new forces. */
    changed: () => {
      if (moving) {
        motion.set(on.field());
      }
    },
    resize: charts.resize,
    recolour: charts.recolour,
  };
}
