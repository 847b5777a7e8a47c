// The state in the address: what stands after # is all that another reader's page needs.

import { degrees, parsed, radians, typed } from "./numbers.js";

/** The text after #: each value by its name; those that `angles` names are written in degrees, with _deg behind their names. */
export function linked(values, angles) {
  const written = Object.entries(values).filter(([, value]) => value !== null)
    .map(([name, value]) => (angles.includes(name) ? [`${name}_deg`, degrees(value)] : [name, value]));
  return written.map(([name, value]) => `${name}=${typed(value, 15)}`).join("&");
}

/** What a link says of `names`, or null: names that are unknown or no numbers are left out, and so is what is out of its range. */
export function unlinked(hash, names, RANGES, angles) {
  const said = new URLSearchParams(hash.replace(/^#/, ""));
  const found = {};
  for (const [name, text] of said) {
    const value = parsed(text);
    if (Number.isFinite(value)) {
      const angle = angles.find((one) => name === `${one}_deg`);
      found[angle ?? name] = angle ? radians(value) : value;
    }
  }
  const allowed = Object.fromEntries(names.filter((name) => Object.hasOwn(found, name) && inside(found[name], RANGES[name])).map((name) => [name, found[name]]));
  return Object.keys(allowed).length ? allowed : null;
}

function inside(value, { low = -Infinity, high = Infinity, low_open, high_open } = {}) {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

/** Puts a link into the address; the frame of a notebook's cell has none of its own. */
export function addressed(text) {
  try {
    history.replaceState(null, "", text);
  } catch {
    // about:srcdoc
  }
}

/** Puts a link to what stands after # into the address and into the clipboard, and says which of the two it came to. */
export async function copied(after, says) {
  const text = `${location.href.split("#")[0]}#${after}`;
  addressed(text);
  try {
    await navigator.clipboard.writeText(text);
    says.textContent = "The link is copied.";
  } catch {
    says.textContent = "The address now carries the state: copy it from there.";
  }
}
