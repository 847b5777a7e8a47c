// The table of all states at the point, and the words about the one that the mass is on.

import { forces } from "./forces.js";
import { degrees, written } from "./numbers.js";
import { current } from "./store.js";
import { SIGNS, worded } from "./words.js";

const LENGTHS = ["x", "y", "L"];
const FORCES = ["spring S", "other springs", "normal n", "friction μ₀n"];
const columns = (length, force) => ["", "regime", "stability", "θ in °", ...LENGTHS.map((name) => name + length), "growth", "undamped (27)", "error bound", ...FORCES.map((name) => name + force)];
const ABOUT = {
  stable: "stable: pushed a little, the mass comes back",
  divergent: "unstable (divergence): pushed a little, the mass leaves without swinging",
  flutter: "unstable (flutter): pushed a little, the mass swings more and more",
  marginal: "marginal: nothing grows or dies out that double precision could see",
};

/** What status says, in a sentence; empty where double precision vouches. */
export function undecided({ contact, liftoff }) {
  const words = [["in contact", contact], ["in lift-off", liftoff]].flatMap(([where, { status }]) => {
    if (status === "uncertain") {
      return `Undecided ${where}: double precision can't tell how many states there are here, or of which kind. The rows are a best guess; the Python package decides.`;
    }
    return status === "out_of_range" ? `Undecided ${where}: numbers of this size are beyond double precision.` : [];
  });
  return words.join(" ");
}

export function createStates(table, store, algebra, drive, units = { length: [1, ""], force: [1, ""] }) {
  const [[long, length], [strong, force]] = [units.length, units.force];
  const named = columns(length && ` in ${length}`, force && ` in ${force}`);
  table.innerHTML = `<thead><tr>${named.map((name) => `<th scope="col">${name}</th>`).join("")}</tr></thead><tbody></tbody>`;
  const body = table.tBodies[0];

  function row(state, regime, point, chosen) {
    const of = forces(algebra, point, state, regime === "contact");
    const { word, rate } = worded(algebra, point, state, regime === "contact", drive);
    const values = [written(degrees(state.theta), 8), ...LENGTHS.map((name) => written(long * state[name], 7)), written(rate, 2), state.stability, written(state.error, 2),
      ...[Math.hypot(...of.spring), Math.hypot(...of.ties), of.normal[1], of.friction[0]].map((value) => written(strong * value, 5))];
    const line = document.createElement("tr");
    line.className = `${word}${chosen ? " chosen" : ""}`;
    if (chosen) {
      line.setAttribute("aria-current", "true");
    }
    line.innerHTML = `<td>${chosen ? "<b title='the mass is here'>➤<span class='hidden'> the mass is here</span></b>" : ""}</td><td>${regime}</td>
      <td title="${ABOUT[word]}"><i aria-hidden="true">${SIGNS[word]}</i> ${word}</td>${values.map((value) => `<td>${value}</td>`).join("")}`;
    return line;
  }

  return () => {
    const now = store.get();
    const [at, { contact, liftoff }] = [current(now), now.found];
    body.replaceChildren(
      ...contact.states.map((state) => row(state, "contact", now.point, state === at && now.decided)),
      ...liftoff.states.map((state) => row(state, "lift-off", now.point, false)),
    );
  };
}

const SYMBOLS = { theta0: "θ₀", mu0: "μ₀", kappa: "κ", alpha: "α", sigma: "σ", beta: "β" };

/** Parameters with their values, as words. */
function placed(fold) {
  return Object.entries(fold).map(([name, value]) => `${SYMBOLS[name]} = ${name === "theta0" ? `${written(degrees(value), 4)}°` : written(value, 4)}`).join(", ");
}

/** What a reader should know now, in a few words. */
export function story({ point, theta, decided, found, last, jumps }, algebra, drive, [long, length] = [1, ""]) {
  const state = current({ found, theta });
  if (!decided) {
    const last = theta === null ? "" : ` The mass stays at its last decided state, θ = ${written(degrees(theta), 4)}°.`;
    return `Undecided here: double precision can't tell the states apart, as on a fold.${last}`;
  }
  if (!state) {
    return "No state in contact with the belt: see the motion below.";
  }
  const where = Math.abs(state.theta - point.theta0) < 0.35 ? "hardly moved" : "swept along by the belt";
  const { word, rate } = worded(algebra, point, state, true, drive);
  const slowly = state.stability === "stable" ? `, at the rate ${written(rate, 2)}: without friction's own damping nothing would grow` : "";
  const kind = word === "flutter" ? `; it flutters, so the motion below swings up${slowly}` : "";
  const jump = last
    ? ` It jumped from θ = ${written(degrees(last.from), 4)}° to ${written(degrees(last.to), 4)}° when the point crossed the fold at ${placed(last.fold)}.`
    : "";
  const more = jumps > 1 ? ` ${jumps} jumps on this path.` : "";
  return `${found.contact.count} ${found.contact.count === 1 ? "state" : "states"} in contact. The mass is ${where}: θ = ${written(degrees(state.theta), 4)}°, x = ${written(long * state.x, 4)}${length && ` ${length}`}${kind}.${jump}${more}`;
}
