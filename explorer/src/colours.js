// Colours of the drawings, read from the style sheet, which has them for light and for dark pages.

const NAMES = ["ink", "faint", "line", "panel", "stable", "divergent", "flutter", "three", "path", "jump", "accent"];

export function colours() {
  const style = getComputedStyle(document.documentElement);
  return Object.fromEntries(NAMES.map((name) => [name, style.getPropertyValue(`--${name}`).trim()]));
}

/** Calls back when the reader's preference for light or dark changes. */
export function whenColoursChange(callback) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", callback);
}
