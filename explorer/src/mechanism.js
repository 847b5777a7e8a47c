// The drawing of one mass on a belt, to scale, from a state; anchors and mass can be dragged.

import { degrees, written } from "./numbers.js";
import { arrow, coil, dragged, keyed, part, picture, pushed } from "./svg.js";
import { numbered } from "./symbols.js";

/** Pixels of a length 1 of the model, and the place of its origin. */
const [SCALE, LEFT, FLOOR] = [150, 300, 250];
const [WIDTH, HEIGHT] = [64, 44]; // of the mass
/** Names of the forces on the mass, for a number of springs. */
const arrowsOf = (count) => [...Array.from({ length: count }, (_, i) => numbered("S", i, count)), "n", "μn", "P"];

/** Width and height of the picture, and its upper edge. */
const [BROAD, TALL, TOP] = [640, 300, 20];
/** No coordinate of a drawn place is beyond this. */
const FAR = 1e3;
const near = (value) => Math.max(-FAR, Math.min(FAR, value || 0));
const at = (x, y) => [LEFT + SCALE * near(x), FLOOR - SCALE * near(y)];

/** `on.anchor(angle, index)` and `on.mass(x, y, done)` are called as anchors and mass are dragged; `count` inclined springs are tied to the mass. */
export function createMechanism(box, on, count = 1) {
  const svg = picture(box, "The mechanism: a mass on a moving belt, leaned on by an inclined spring", { viewBox: `0 ${TOP} ${BROAD} ${TALL}` });
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
  const arrows = arrowsOf(count).map((name) => arrow(svg, name));
  pins.forEach((pin, i) => {
    const id = i ? `anchor_${i + 1}` : "anchor";
    pin.anchor = part(svg, "circle", { r: 11, class: "anchor", tabindex: 0, role: "slider", id, "aria-valuemin": 0, "aria-valuemax": 180 });
    pin.text = part(svg, "text", { class: "note" });
  });
  const legend = part(svg, "text", { x: 12, y: 44, class: "note" });

  let now = { x: 0, y: 0, pins: [] };
  let zoom = 1;

  const place = ([x, y]) => [(x - LEFT) / SCALE, (FLOOR - y) / SCALE];

  pins.forEach(({ anchor }, i) => {
    const moved = (x, y) => now.pins[i].angle !== undefined && on.anchor(Math.atan2(Math.max(y, 1e-4), x - (now.pins[i].from?.[0] ?? 0)), i);
    dragged(svg, anchor, { place, home: () => now.pins[i].at, moved });
    anchor.addEventListener("keydown", (event) => {
      const step = { ArrowLeft: 1, ArrowUp: 1, ArrowRight: -1, ArrowDown: -1 }[event.key];
      if (step && now.pins[i].angle !== undefined) {
        event.preventDefault();
        on.anchor(now.pins[i].angle + (step * (event.shiftKey ? 5 : 0.5) * Math.PI) / 180, i);
      }
    });
  });
  const home = () => [now.x, now.y];
  dragged(svg, mass, { place, home, moved: (x, y) => on.mass(x, y, false), let_go: () => on.mass(now.x, now.y, true) });
  keyed(mass, home, on.mass);

  /**
   * Draw the mass at x, y. `to` are the anchors, each `{ at, from, angle, symbol }`, where `from` is the end of the unloaded spring; an anchor without
   * an angle can't be dragged. `ties` says whether springs hold the mass along the belt and across it, `others` are further equilibria, `forces` are as
   * the balance's `acting` gives them, `note` is a line of text.
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

  /** Zooms out until the mass is in the picture, by the factor `least` or more; the floor stays at the bottom. */
  function fit([x, y], least) {
    const wanted = Math.max(least, (LEFT + WIDTH - x) / LEFT, (x + WIDTH - LEFT) / (BROAD - LEFT), (FLOOR + HEIGHT - y) / (FLOOR - TOP));
    const next = Number.isFinite(wanted) ? Math.min(20, wanted > 1 ? Math.ceil(4 * wanted) / 4 : 1) : 1;
    if (next !== zoom) {
      zoom = next;
      svg.setAttribute("viewBox", `${LEFT - LEFT * zoom} ${FLOOR + (TALL + TOP - FLOOR) - TALL * zoom} ${BROAD * zoom} ${TALL * zoom}`);
    }
  }

  /** Draws one anchor with its spring, the unloaded spring, and its angle if it has one. */
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
    const { springs, normal, friction, others } = forces?.vectors ?? { springs: pins.map(() => [0, 0]), normal: [0, 0], friction: [0, 0], others: [0, 0] };
    const vectors = [...springs, normal, friction, others];
    const largest = Math.max(...vectors.map((vector) => Math.hypot(...vector)));
    vectors.forEach((vector, i) => pushed(arrows[i], [x, y], vector, largest));
  }

  /** Draws the belt's marks where the belt has run to. */
  function roll([way = 0]) {
    const shift = (((way * SCALE) % 32) + 32) % 32;
    marks.setAttribute("d", Array.from({ length: 82 }, (_, i) => `M${i * 32 - BROAD - 32 + shift},${floor + 3} l8,12`).join(" "));
  }
  roll([]);
  return { draw, roll };
}
