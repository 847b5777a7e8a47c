// Colours of the drawings, from the style sheet: one place, and they change with light and dark.

const NAMES = ["ink", "faint", "line", "panel", "stable", "divergent", "flutter", "three", "path", "jump", "accent"];

export function colours() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** Calls back when the reader's preference changes. */
export function whenColoursChange(callback) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", callback);
}
