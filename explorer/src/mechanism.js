// The mechanism, drawn to scale from a state: anchor and mass can be dragged.

import { degrees, written } from "./numbers.js";
import { numbered } from "./symbols.js";

const SVG = "http://www.w3.org/2000/svg";
/** Length 1 of the model in the drawing, and where its origin is. */
const [SCALE, LEFT, FLOOR] = [150, 300, 250];
const [WIDTH, HEIGHT] = [64, 44]; // of the mass
/** Names of what acts on the mass, for a number of springs. */
const arrowsOf = (count) => [...Array.from({ length: count }, (_, i) => numbered("S", i, count)), "n", "μn", "P"];

/** The drawing's size, and how much of it is above and below the floor. */
const [BROAD, TALL, TOP] = [640, 300, 20];
/** What lies further away is drawn so far away. */
const FAR = 1e3;
const near = (value) => Math.max(-FAR, Math.min(FAR, value || 0));
const at = (x, y) => [LEFT + SCALE * near(x), FLOOR - SCALE * near(y)];

function part(parent, name, attributes = {}) {
  const element = document.createElementNS(SVG, name);
  Object.entries(attributes).forEach(([key, value]) => element.setAttribute(key, value));
  parent.append(element);
  return element;
}

/** A zigzag between two points. */
function coil([x1, y1], [x2, y2], turns = 9, width = 7) {
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

/** `on.anchor(angle, number)` and `on.mass(x, y, done)` are called as they are dragged; `count` springs lean on the mass. */
export function createMechanism(box, on, count = 1) {
  const svg = part(box, "svg", { viewBox: `0 ${TOP} ${BROAD} ${TALL}`, role: "group", "aria-label": "The mechanism: a mass on a moving belt, leaned on by an inclined spring" });
  const defs = part(svg, "defs");
  const tip = part(defs, "marker", { id: "tip", viewBox: "0 0 8 8", refX: 7, refY: 4, markerWidth: 7, markerHeight: 7, orient: "auto-start-reverse" });
  part(tip, "path", { d: "M0,0 L8,4 L0,8 z", class: "tip" });
  const floor = FLOOR + HEIGHT / 2;
  part(svg, "rect", { x: -BROAD, y: floor, width: 4 * BROAD, height: 18, class: "belt" });
  const marks = part(svg, "path", { class: "marks", d: "" });
  const speed = part(svg, "text", { x: 560, y: floor + 40, class: "note" });
  speed.textContent = "belt →";
  part(svg, "path", { d: `M8,${FLOOR - 40} v80`, class: "wall" });
  const pins = Array.from({ length: count }, () => ({ arc: part(svg, "path", { class: "arc" }), free: part(svg, "path", { class: "free" }) }));
  const tie = part(svg, "polyline", { class: "tie" });
  const upright = part(svg, "polyline", { class: "tie" });
  const ghosts = part(svg, "g");
  pins.forEach((pin) => { pin.spring = part(svg, "polyline", { class: "spring" }); });
  const mass = part(svg, "rect", { width: WIDTH, height: HEIGHT, rx: 4, class: "mass", tabindex: 0, role: "slider", id: "mass",
    "aria-label": "The mass: drag it, or move it with arrow keys, and let go to see it move from there" });
  const hub = part(svg, "circle", { r: 4, class: "hub" });
  const arrows = arrowsOf(count).map((name) => {
    const [arrow, label] = [part(svg, "path", { class: "force", "marker-end": "url(#tip)" }), part(svg, "text", { class: "force-name" })];
    label.textContent = name;
    return { arrow, label };
  });
  pins.forEach((pin, i) => {
    const id = i ? `anchor_${i + 1}` : "anchor";
    pin.anchor = part(svg, "circle", { r: 11, class: "anchor", tabindex: 0, role: "slider", id, "aria-valuemin": 0, "aria-valuemax": 180 });
    pin.text = part(svg, "text", { class: "note" });
  });
  const legend = part(svg, "text", { x: 12, y: 44, class: "note" });

  let now = { x: 0, y: 0, pins: [] };
  let zoom = 1;

  function place(event) {
    const matrix = svg.getScreenCTM().inverse();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix);
    return [(x - LEFT) / SCALE, (FLOOR - y) / SCALE];
  }

  /** The part keeps its distance from the pointer that took it: `home` is where it is. */
  function dragged(element, home, moved, let_go = () => {}) {
    let off = [0, 0];
    element.addEventListener("pointerdown", (event) => {
      const [x, y] = place(event);
      off = [home()[0] - x, home()[1] - y];
      element.setPointerCapture(event.pointerId);
      element.focus({ preventScroll: true });
      event.preventDefault();
    });
    element.addEventListener("pointermove", (event) => {
      if (element.hasPointerCapture(event.pointerId)) {
        const [x, y] = place(event);
        moved(x + off[0], y + off[1]);
      }
    });
    ["pointerup", "pointercancel"].forEach((name) => element.addEventListener(name, let_go));
  }

  pins.forEach(({ anchor }, i) => {
    dragged(anchor, () => now.pins[i].at, (x, y) => now.pins[i].angle !== undefined && on.anchor(Math.atan2(Math.max(y, 1e-4), x - (now.pins[i].from?.[0] ?? 0)), i));
    anchor.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[event.key];
      if (step && now.pins[i].angle !== undefined) {
        event.preventDefault();
        on.anchor(now.pins[i].angle + (step * (event.shiftKey ? 5 : 0.5) * Math.PI) / 180, i);
      }
    });
  });
  dragged(mass, () => [now.x, now.y], (x, y) => on.mass(x, y, false), () => on.mass(now.x, now.y, true));
  mass.addEventListener("keydown", (event) => {
    const step = { ArrowLeft: [-0.02, 0], ArrowRight: [0.02, 0], ArrowUp: [0, 0.02], ArrowDown: [0, -0.02] }[event.key];
    if (step || event.key === "Enter" || event.key === " ") {
      event.preventDefault();
      on.mass(now.x + (step?.[0] ?? 0), now.y + (step?.[1] ?? 0), !step);
    }
  });

  /**
   * Draw the mass at x, y. `to` are the anchors, each `{ at, angle, symbol }`, and `from` where its unloaded spring ends; without an
   * angle it can't be dragged. `ties` says whether springs hold the mass along the belt and across it, `others` are further
   * equilibria, `forces` what acts on the mass, as a balance has it, `note` is a line of text.
   */
  function draw({ to, x, y, ties, others = [], forces = null, note = "", kind = "" }) {
    now = { x, y, pins: to };
    const centre = at(x, y);
    fit(centre, kind === "off" || note.startsWith("in motion") ? zoom : 1);
    to.forEach((pin, i) => anchored(pins[i], pin, centre));
    mass.setAttribute("aria-valuetext", `x ${written(x, 4)}, y ${written(y, 4)}`);
    mass.setAttribute("class", `mass ${kind}`);
    mass.setAttribute("x", centre[0] - WIDTH / 2);
    mass.setAttribute("y", centre[1] - HEIGHT / 2);
    hub.setAttribute("cx", centre[0]);
    hub.setAttribute("cy", centre[1]);
    tie.setAttribute("points", ties[0] ? coil([8, centre[1]], [centre[0] - WIDTH / 2, centre[1]], 12, 4) : "");
    upright.setAttribute("points", ties[1] ? coil([centre[0] + 20, 24], [centre[0] + 20, centre[1] - HEIGHT / 2], 8, 4) : "");
    legend.textContent = note;
    ghosts.replaceChildren();
    others.forEach((state) => {
      const [gx, gy] = at(state.x, state.y);
      part(ghosts, "rect", { x: gx - WIDTH / 2, y: gy - HEIGHT / 2, width: WIDTH, height: HEIGHT, rx: 4, class: `ghost ${state.kind}` });
    });
    push(forces, centre);
  }

  /** Shows more of the surroundings where the mass is beyond them, by no less than `least`; the floor stays at the bottom. */
  function fit([x, y], least) {
    const wanted = Math.max(least, (LEFT + WIDTH - x) / LEFT, (x + WIDTH - LEFT) / (BROAD - LEFT), (FLOOR + HEIGHT - y) / (FLOOR - TOP));
    const next = Number.isFinite(wanted) ? Math.min(20, wanted > 1 ? Math.ceil(4 * wanted) / 4 : 1) : 1;
    if (next !== zoom) {
      zoom = next;
      svg.setAttribute("viewBox", `${LEFT - LEFT * zoom} ${FLOOR + (TALL + TOP - FLOOR) - TALL * zoom} ${BROAD * zoom} ${TALL * zoom}`);
    }
  }

  /** One anchor with its spring, its angle where it has one, and the unloaded spring. */
  function anchored({ arc, free, spring, anchor, text }, { at: place, from = [0, 0], angle, symbol }, centre) {
    const pin = at(...place);
    spring.setAttribute("points", coil(pin, centre));
    anchor.setAttribute("cx", pin[0]);
    anchor.setAttribute("cy", pin[1]);
    free.setAttribute("d", `M${at(...from)} L${pin}`);
    const turned = angle !== undefined;
    anchor.classList.toggle("fixed", !turned);
    anchor.setAttribute("tabindex", turned ? 0 : -1);
    anchor.setAttribute("aria-label", turned ? `Anchor of the spring: its inclination ${symbol} in degrees` : "Anchor of a spring");
    if (turned) {
      anchor.setAttribute("aria-valuenow", degrees(angle).toFixed(2));
      const [radius, [x, y]] = [0.25 * SCALE, at(...from)];
      arc.setAttribute("d", `M${x + radius},${y} A${radius},${radius} 0 0 0 ${x + radius * Math.cos(angle)},${y - radius * Math.sin(angle)}`);
      text.textContent = `${symbol} = ${written(degrees(angle), 4)}°`;
      const sideways = pin[0] > 500 ? -14 : 16;
      text.setAttribute("text-anchor", sideways < 0 ? "end" : "start");
      text.setAttribute("x", pin[0] + sideways);
      text.setAttribute("y", pin[1] - 6);
    }
  }

  /** Arrows of the forces, the longest of a fixed length. */
  function push(forces, [x, y]) {
    const { springs, normal, friction, others } = forces ?? { springs: pins.map(() => [0, 0]), normal: [0, 0], friction: [0, 0], others: [0, 0] };
    const vectors = [...springs, normal, friction, others];
    const largest = Math.max(...vectors.map((vector) => Math.hypot(...vector)));
    vectors.forEach(([fx, fy], i) => {
      const { arrow, label } = arrows[i];
      const shown = largest > 0 && Math.hypot(fx, fy) > 0.03 * largest;
      arrow.setAttribute("d", shown ? `M${x},${y} l${(70 * fx) / largest},${(-70 * fy) / largest}` : "");
      label.setAttribute("x", x + (shown ? (84 * fx) / largest : 0) - 6);
      label.setAttribute("y", y - (shown ? (84 * fy) / largest : 0) + 5);
      label.style.display = shown ? "" : "none";
    });
  }

  /** The belt by how far it has run. */
  function roll(way) {
    const shift = (((way * SCALE) % 32) + 32) % 32;
    marks.setAttribute("d", Array.from({ length: 82 }, (_, i) => `M${i * 32 - BROAD - 32 + shift},${floor + 3} l8,12`).join(" "));
  }
  roll(0);
  return { draw, roll };
}
