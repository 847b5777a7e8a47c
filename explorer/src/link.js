// The state of the page as the part of its address after #, from which another reader's page shows the same.

import { degrees, parsed, radians, typed } from "./numbers.js";

/** The text after #: `name=value`, joined by &; values that `angles` names are in degrees, and their names end with _deg. */
export function linked(values, angles) {
  const written = Object.entries(values).filter(([, value]) => value !== null)
    .map(([name, value]) => (angles.includes(name) ? [`${name}_deg`, degrees(value)] : [name, value]));
  return written.map(([name, value]) => `${name}=${typed(value, 15)}`).join("&");
}

/** The values of `names` in a link, or null if there are none: those that are no numbers or out of their ranges are left out. */
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

/** Puts a link into the address, but for a page in a notebook's cell, which has no address of its own. */
export function addressed(text) {
  try {
    history.replaceState(null, "", text);
  } catch {
    // about:srcdoc
  }
}

/** Puts a link into the address and the clipboard, and tells the reader in `says` which of the two worked. */
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
