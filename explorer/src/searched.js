// States by search: the source of a model without closed forms. It has `look`, `begin` and `carry`, as createStore takes them, and `count`,
// the number of states in which something touches, null where that is undecided.

import { carry, landing } from "./carry.js";
import { search } from "./search.js";
import { touchingIn } from "./states.js";

/** `at(point)` gives the balance at a point, `about` describes the model, `spans` are the lengths of the parameters' sliders. */
export function searched(at, about, spans) {
  const rest = about.coordinates.map(() => 0);
  const look = (point) => {
    const states = search(at(point), about);
    const undecided = states.undecided ? "Undecided here: the search can't tell the states apart. The command below the table may." : "";
    return { states, undecided, lost: Boolean(undecided), proved: false };
  };
  return {
    look,
    count: (point) => { const states = search(at(point), about, touchingIn(about)); return states.undecided ? null : states.length; },
    begin: (point, q) => ({ state: landing(look(point).states, q ?? rest), decided: true }),
    carry: (from, to, state) => carry(at, about, from, to, state, spans),
  };
}
