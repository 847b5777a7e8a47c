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

/** The numbers of the regimes in which something touches: all but the one in which every contact that can open is open. */
export const touchingIn = (about) => about.regimes.flatMap(({ touching }, regime) => (touching.includes(1) ? regime : []));
/** A column's title, followed by the contact's name where there are several contacts. */
const titled = (title, { name }) => (name ? `${title} ${name}` : title);

/** The unit of a rate, if it has one. */
const rate_unit = ({ time: [, unit] }) => unit && `1/${unit}`;

/** Columns of the table: each a title, and a function that gives the cell from a state and the forces `of` it, as `acting` gives them. */
function columns(about, units) {
  const { springs } = about;
  const [[long, length], [strong, force]] = [units.length, units.force];
  const each = Array.from({ length: springs }, (_, i) => i);
  const turned = (state, i) => written(degrees(Math.atan2(state.along[3 * i + 1], state.along[3 * i])), 8);
  return [
    ...each.map((i) => [`${numbered("θ", i, springs)} in °`, (state) => turned(state, i)]),
    ...about.coordinates.map(({ name, angle }, i) => [measured(symbolOf(name), angle ? "°" : length), (state) => written(angle ? degrees(state.q[i]) : long * state.q[i], 8)]),
    ...each.map((i) => [measured(numbered("L", i, springs), length), (state) => written(long * state.along[3 * i + 2], 7)]),
    [measured("growth", rate_unit(units)), (state) => written(state.rate / units.time[0], 3)],
    ["without damping", (state) => `<span title="${ABOUT[state.undamped]}"><i aria-hidden="true">${SIGNS[state.undamped]}</i> ${state.undamped}</span>`],
    ...(about.proved ? [["error bound", (state) => written(state.error, 2)]] : []),
    ...each.map((i) => [measured(numbered("S", i, springs), force), (_, of) => written(strong * of.tensions[i], 5)]),
    ...(about.drawn ? [[measured("other forces", force), (_, of) => written(strong * Math.hypot(...of.vectors.others), 5)]] : []),
    ...about.contacts.map((contact, k) => [measured(titled("normal n", contact), force), (_, of) => written(strong * of.normals[k], 5)]),
    ...(about.frictions.length ? about.frictions : [{ contact: 0 }]).map(({ contact }, j) => [measured(titled("friction μn", about.contacts[contact]), force), (_, of) => written(strong * of.frictions[j], 5)]),
  ];
}

/**
 * Returns what fills a table from the store. `at(point)` gives the balance at a point, `about` the model, with the number of its inclined `springs` and
 * whether its states are `proved`.
 */
export function createStates(table, store, at, about, units) {
  const columned = columns(about, units);
  const titles = ["", "regime", "stability", ...columned.map(([title]) => title)];
  table.innerHTML = `<thead><tr>${titles.map((title) => `<th scope="col">${title}</th>`).join("")}</tr></thead><tbody></tbody>`;

  function row(state, balance, chosen) {
    const acting = balance.acting(state.q, state.regime);
    const line = document.createElement("tr");
    line.className = `${state.undamped}${chosen ? " chosen" : ""}`;
    if (chosen) {
      line.setAttribute("aria-current", "true");
    }
    line.innerHTML = `<td>${chosen ? "<b title='the mass is here'>➤<span class='hidden'> the mass is here</span></b>" : ""}</td><td>${about.regimes[state.regime].says}</td>
      <td>${state.stability}</td>${columned.map(([, say]) => `<td>${say(state, acting)}</td>`).join("")}`;
    return line;
  }

  return () => {
    const now = store.get();
    const [balance, here] = [at(now.point), current(now)];
    table.tBodies[0].replaceChildren(...now.found.states.map((state) => row(state, balance, state === here && now.decided)));
  };
}

/** How many states there are in each regime, in words; with three regimes or more only those that have states. */
export function counted(about, { states, lost }) {
  if (lost) {
    return "undecided";
  }
  const each = about.regimes.map(({ says }, regime) => ({ says, count: states.filter((state) => state.regime === regime).length }));
  return each.filter(({ count }) => count || each.length < 3).map(({ says, count }) => `${count} ${says === "sliding" ? says : `in ${says}`}`).join(", ") || "none";
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
  const grows = state.stability === "unstable" && state.undamped === "stable" ? `, small deviations grow at the rate ${written(state.rate / units.time[0], 2)} ${rate_unit(units)}`.trimEnd() : "";
  const kind = `, ${state.stability}${grows}${without}`;
  const many = now.found.states.filter(({ regime }) => touchingIn(about).includes(regime)).length;
  const side = about.regimes[0].says === "contact" ? " in contact" : "";
  const among = about.regimes.length > 2 ? `, in ${about.regimes[state.regime].says}` : "";
  const directed = state.along.length === 3 ? `θ = ${written(degrees(Math.atan2(state.along[1], state.along[0])), 4)}°, ` : "";
  return `${many} ${many === 1 ? "state" : "states"}${now.found.proved ? "" : " found"}${side}. The mass is at ${directed}${where(state.q)}${among}${kind}.${jump}${more}`;
}
