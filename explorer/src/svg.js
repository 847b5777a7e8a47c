// The parts of a mechanism's drawing in SVG, and how they are dragged.

const SVG = "http://www.w3.org/2000/svg";

export function part(parent, name, attributes = {}) {
  const element = document.createElementNS(SVG, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  parent.append(element);
  return element;
}

/** The points of a spring, a zigzag between two places with straight ends. */
export function coil([x1, y1], [x2, y2], turns = 9, width = 7) {
  const length = Math.hypot(x2 - x1, y2 - y1) || 1;
  const [ux, uy] = [(x2 - x1) / length, (y2 - y1) / length];
  const points = [[x1, y1]];
  for (let i = 0; i < 2 * turns; i++) {
    const [along, across] = [0.15 + (0.7 * (i + 0.5)) / (2 * turns), (i % 2 ? 1 : -1) * width];
    points.push([x1 + along * (x2 - x1) - across * uy, y1 + along * (y2 - y1) + across * ux]);
  }
  points.splice(1, 0, [x1 + 0.15 * (x2 - x1), y1 + 0.15 * (y2 - y1)]);
  points.push([x1 + 0.85 * (x2 - x1), y1 + 0.85 * (y2 - y1)], [x2, y2]);
  return points.map(([x, y]) => `${x.toFixed(1)},${y.toFixed(1)}`).join(" ");
}

/** The empty picture of a mechanism, with the arrow head that forces use. */
export function picture(box, label, attributes) {
  const svg = part(box, "svg", { role: "group", "aria-label": label, ...attributes });
  const tip = part(part(svg, "defs"), "marker", { id: "tip", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto-start-reverse" });
  part(tip, "path", { d: "M0,0 L8,4 L0,8 z", class: "tip" });
  return svg;
}

/** The arrow of a force, with its name. */
export function arrow(svg, name) {
  const [shaft, label] = [part(svg, "path", { class: "force", "marker-end": "url(#tip)" }), part(svg, "text", { class: "force-name" })];
  label.textContent = name;
  return { shaft, label };
}

/** Draws a force's arrow at a point, its length relative to the largest force; very short ones are hidden. */
export function pushed({ shaft, label }, [x, y], [fx, fy], largest) {
  const shown = largest > 0 && Math.hypot(fx, fy) > 0.03 * largest;
  shaft.setAttribute("d", shown ? `M${x},${y} l${(70 * fx) / largest},${(-70 * fy) / largest}` : "");
  label.setAttribute("x", x + (shown ? (84 * fx) / largest : 0) - 6);
  label.setAttribute("y", y - (shown ? (84 * fy) / largest : 0) + 5);
  label.style.display = shown ? "" : "none";
}

/**
 * Makes an element draggable; it keeps its distance from the pointer. `home()` gives its place, `place` turns pixels of the picture into places,
 * `moved(x, y)` is called as it is dragged.
 */
export function dragged(svg, element, { place, home, moved, let_go = () => {} }) {
  let off = [0, 0];
  function at(event) {
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(svg.getScreenCTM().inverse());
    return place([x, y]);
  }
  element.addEventListener("pointerdown", (event) => {
    const [x, y] = at(event);
    off = [home()[0] - x, home()[1] - y];
    element.setPointerCapture(event.pointerId);
    element.focus({ preventScroll: true });
    event.preventDefault();
  });
  element.addEventListener("pointermove", (event) => {
    if (element.hasPointerCapture(event.pointerId)) {
      const [x, y] = at(event);
      moved(x + off[0], y + off[1]);
    }
  });
  ["pointerup", "pointercancel"].forEach((name) => element.addEventListener(name, let_go));
}

/** Makes arrow keys move an element by small steps, and Enter and space let it go: `moved(x, y, done)`. */
export function keyed(element, home, moved) {
  element.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowUp: [0, 0.02], ArrowDown: [0, -0.02] }[event.key];
    if (step || event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      moved(home()[0] + (step?.[0] ?? 0), home()[1] + (step?.[1] ?? 0), !step);
    }
  });
}
