// The table of all states at the point, and the words about the one that the mass is on.

import { degrees, written } from "./numbers.js";
import { current } from "./store.js";
import { numbered, symbolOf } from "./symbols.js";
import { measured, outward } from "./units.js";

const SIGNS = { stable: "●", divergent: "▲", flutter: "≈" };
const ABOUT = {
  stable: "stable without damping: pushed a little, the mass swings about the state",
  divergent: "unstable (divergence): pushed a little, the mass leaves without swinging",
  flutter: "unstable (flutter): pushed a little, the mass swings more and more",
};

/** What a state of either side of the contact is called. */
export const regimeOf = (about, contact) => (about.apart ? (contact ? "contact" : about.apart) : "sliding");

/** Columns of the table: each a title and what it says of a state, `of` being what acts on it. */
function columns(about, units) {
  const { springs } = about;
  const [[long, length], [strong, force]] = [units.length, units.force];
  const each = Array.from({ length: springs }, (_, i) => i);
  const turned = (state, i) => written(degrees(Math.atan2(state.along[3 * i + 1], state.along[3 * i])), 8);
  return [
    ...each.map((i) => [`${numbered("θ", i, springs)} in °`, (state) => turned(state, i)]),
    ...about.coordinates.map(({ name, angle }, i) => [measured(symbolOf(name), angle ? "°" : length), (state) => written(angle ? degrees(state.q[i]) : long * state.q[i], 8)]),
    ...each.map((i) => [measured(numbered("L", i, springs), length), (state) => written(long * state.along[3 * i + 2], 7)]),
    ["growth", (state) => written(state.rate, 3)],
    ["without damping", (state) => `<span title="${ABOUT[state.undamped]}"><i aria-hidden="true">${SIGNS[state.undamped]}</i> ${state.undamped}</span>`],
    ...(about.proved ? [["error bound", (state) => written(state.error, 2)]] : []),
    ...each.map((i) => [measured(numbered("S", i, springs), force), (_, of) => written(strong * of.tensions[i], 5)]),
    ...(about.drawn ? [[measured("other forces", force), (_, of) => written(strong * Math.hypot(...of.vectors.others), 5)]] : []),
    [measured("normal n", force), (_, of) => written(strong * of.normal, 5)],
    [measured("friction μn", force), (_, of) => written(strong * of.friction, 5)],
  ];
}

/** Fills a table from the store; `at(point)` gives the balance there, `about` says how many inclined springs there are, and whether states are proved. */
export function createStates(table, store, at, about, units) {
  const columned = columns(about, units);
  const titles = ["", "regime", "stability", ...columned.map(([title]) => title)];
  table.innerHTML = `<thead><tr>${titles.map((title) => `<th scope="col">${title}</th>`).join("")}</tr></thead><tbody></tbody>`;

  function row(state, balance, chosen) {
    const acting = balance.acting(state.q, state.contact);
    const line = document.createElement("tr");
    line.className = `${state.undamped}${chosen ? " chosen" : ""}`;
    if (chosen) {
      line.setAttribute("aria-current", "true");
    }
    line.innerHTML = `<td>${chosen ? "<b title='the mass is here'>➤<span class='hidden'> the mass is here</span></b>" : ""}</td><td>${regimeOf(about, state.contact)}</td>
      <td>${state.stability}</td>${columned.map(([, say]) => `<td>${say(state, acting)}</td>`).join("")}`;
    return line;
  }

  return () => {
    const now = store.get();
    const [balance, here] = [at(now.point), current(now)];
    table.tBodies[0].replaceChildren(...now.found.states.map((state) => row(state, balance, state === here && now.decided)));
  };
}

/** How many states there are on each side of the contact, in words. */
export function counted(about, { states, lost }) {
  if (lost) {
    return "undecided";
  }
  const sides = about.apart ? [true, false] : [true];
  return sides.map((contact) => {
    const side = regimeOf(about, contact);
    return `${states.filter((state) => state.contact === contact).length} ${side === "sliding" ? side : `in ${side}`}`;
  }).join(", ");
}

/** What a reader should know now, in a few words; `fields` are the parameters. */
export function story(now, about, fields, units) {
  const [long, length] = units.length;
  const [{ name, angle }] = about.coordinates;
  const where = (q) => `${symbolOf(name)} = ${written(angle ? degrees(q[0]) : long * q[0], 4)}${angle ? "°" : length && ` ${length}`}`;
  if (!now.decided || now.found.lost) {
    return `Undecided here: the states can't be told apart, as on a fold.${now.state ? ` The mass stays at its last decided state, ${where(now.state.q)}.` : ""}`;
  }
  const placed = (at) => fields.filter((field) => field.name in at).map((field) => `${field.symbol} = ${written(outward(field, at[field.name]), 4)}${field.angle ? "°" : field.unit && ` ${field.unit}`}`).join(", ");
  const { last, jumps } = now;
  const jump = last ? ` It jumped from ${where(last.from)}${last.to ? ` to ${where(last.to)}` : ""} when its state ended at ${placed(last.at)}.` : "";
  const more = jumps > 1 ? ` ${jumps} jumps on this path.` : "";
  const state = current(now);
  if (!state) {
    return `No state ${now.found.proved ? "in contact with the belt" : "was found that the mass could keep"}: see the motion below.${jump}${more}`;
  }
  const without = state.undamped === state.stability ? "" : state.undamped === "flutter" ? "; it flutters, so the motion below swings up" : `; ${state.undamped} without damping`;
  const grows = state.stability === "unstable" && state.undamped === "stable" ? `, small deviations grow at the rate ${written(state.rate, 2)}` : "";
  const kind = `, ${state.stability}${grows}${without}`;
  const many = now.found.states.filter(({ contact }) => contact).length;
  const side = regimeOf(about, true) === "contact" ? " in contact" : "";
  const directed = state.along.length === 3 ? `θ = ${written(degrees(Math.atan2(state.along[1], state.along[0])), 4)}°, ` : "";
  return `${many} ${many === 1 ? "state" : "states"}${now.found.proved ? "" : " found"}${side}. The mass is at ${directed}${where(state.q)}${kind}.${jump}${more}`;
}
