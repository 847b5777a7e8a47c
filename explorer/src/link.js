// The state in the address: what stands after # is all that another reader's page needs.

import { degrees, parsed, radians, typed } from "./numbers.js";

/** The text after # for a point, the direction of its state, and the drive of the motion. */
export function linked({ point, theta }, drive) {
  const { theta0, ...rest } = point;
  const values = { theta0_deg: degrees(theta0), ...rest, ...(theta === null ? {} : { theta_deg: degrees(theta) }), ...drive };
  return Object.entries(values).map(([name, value]) => `${name}=${typed(value, 15)}`).join("&");
}

/** What a link says, or null: names that are unknown or no numbers are left out, and so is what is out of its range. */
export function unlinked(hash, names, RANGES) {
  const said = new URLSearchParams(hash.replace(/^#/, ""));
  const found = {};
  for (const [name, text] of said) {
    const value = parsed(text);
    if (Number.isFinite(value)) {
      found[name.endsWith("_deg") ? name.slice(0, -4) : name] = name.endsWith("_deg") ? radians(value) : value;
    }
  }
  const allowed = Object.fromEntries([...names, "V", "d", "theta"].filter((name) => name in found && inside(found[name], RANGES[name])).map((name) => [name, found[name]]));
  return Object.keys(allowed).length ? allowed : null;
}

function inside(value, { low = -Infinity, high = Infinity, low_open, high_open } = {}) {
  return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}
