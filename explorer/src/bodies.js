// The drawing of a mechanism of any number of bodies, contacts and springs, to scale, from the model's scene and a state; bodies can be
// dragged. Places are in the model's length, y upwards; `pixel` and `path` turn them into pixels.

import { written } from "./numbers.js";
import { arrow, coil, dragged, keyed, part, picture, pushed } from "./svg.js";

/** Pixels of a length 1, and the breadth in pixels beyond which texts grow with the picture. */
const [SCALE, BROAD] = [150, 640];
/** Half the width and height of a body without contacts that tell them, and half the length and thickness of one that only turns. */
const [WIDE, TALL, LONG, THIN] = [0.3, 0.22, 0.6, 0.05];
/** The lengths of a spring along the belt, of one across it and of one at a contact, and a belt's thickness. */
const [WAY, ROOM, FOOT, BELT] = [1.8, 0.9, 0.18, 0.12];
/** No coordinate of a drawn place is beyond this. */
const FAR = 1e3;

const plus = (one, other, times = 1) => one.map((value, k) => value + times * other[k]);
const near = (value) => Math.max(-FAR, Math.min(FAR, value || 0));
const pixel = ([x, y]) => [SCALE * near(x), -SCALE * near(y)];
const turned = ([x, y], angle) => [x * Math.cos(angle) - y * Math.sin(angle), x * Math.sin(angle) + y * Math.cos(angle)];
const path = (points, closed = "") => `M${points.map((point) => pixel(point).map((value) => value.toFixed(2))).join(" L")}${closed}`;
const only = ({ along, across }) => along === undefined && across === undefined;

/** Corners of a body about its centre, unturned: a rectangle that reaches its contacts, or a rod to the first of them if it only turns. */
function outline(body, feet) {
  const reach = (axis) => Math.max(0, ...feet.map((arm) => Math.abs(arm[axis])));
  if (!only(body)) {
    const [wide, tall] = [Math.max(WIDE, 1.15 * reach(0), 0.6 * reach(1)), reach(1) || TALL];
    return { wide, tall, corners: [[-wide, -tall], [wide, -tall], [wide, tall], [-wide, tall]] };
  }
  const tip = feet.find((arm) => Math.hypot(...arm) > 0);
  const [from, to] = tip ? [[0, 0], tip] : [[-LONG, 0], [LONG, 0]];
  const [x, y] = plus(to, from, -1).map((value) => (THIN * value) / Math.hypot(...plus(to, from, -1)));
  return { wide: Math.max(LONG, reach(0)), tall: reach(1) || TALL, tip: to, corners: [[from, 1], [to, 1], [to, -1], [from, -1]].map(([end, side]) => plus(end, [-y, x], side)) };
}

/** The bodies' centres at the origin: below a body that touches it from above, above one to which a spring across ties it, else to the right. */
function homes({ contacts, ties }, shapes, room) {
  const found = [];
  shapes.forEach(({ wide, tall }, b) => {
    const k = contacts.findIndex(({ bodies }) => bodies.indexOf(b) > 0 && found[bodies[0]]);
    const tie = ties.find(({ bodies, kind }) => kind === "across" && bodies.includes(b) && bodies.some((a) => found[a]));
    if (k >= 0) {
      const a = contacts[k].bodies[0];
      found[b] = plus(found[a], [0, -(shapes[a].tall + room[k] + tall)]);
    } else if (tie) {
      const a = tie.bodies.find((one) => found[one]);
      found[b] = plus(found[a], [0, shapes[a].tall + ROOM + tall]);
    } else {
      const edge = Math.max(...found.map(([x], a) => x + shapes[a].wide));
      found[b] = b ? [edge + WAY + wide, tall - shapes[0].tall] : [0, 0];
    }
  });
  return found;
}

/** `on(body, place, done)` is called as a body is dragged, with its index, and its coordinates `along` and `across` or its `angle`. */
export function createBodies(box, scene, on) {
  const svg = picture(box, "The mechanism: its bodies, contacts and springs", {});
  const backdrop = part(svg, "g");
  const masses = scene.bodies.map((_, b) => part(svg, "path", { class: "mass", tabindex: 0, role: "slider", id: `body_${b + 1}`,
    "aria-label": `Body ${b + 1}: drag it, or move it with arrow keys, and let go to see it move from there` }));
  const front = part(svg, "g");
  const arrows = scene.contacts.map(() => ["n", "μn"].map((name) => arrow(svg, name)));
  const legend = part(svg, "text", { class: "note" });

  let [now, frame, ways] = [null, null, []];

  masses.forEach((mass, b) => {
    const body = scene.bodies[b];
    const home = () => (only(body) ? turned(now.shapes[b].tip, now.angles[b]) : plus(now.centres[b], now.homes[b], -1));
    const said = (x, y) => {
      const [dx, dy] = only(body) ? turned([x, y], -Math.atan2(now.shapes[b].tip[1], now.shapes[b].tip[0])) : [x, y];
      return only(body) ? { angle: body.sense * Math.atan2(dy, dx) } : { along: dx, across: dy };
    };
    const place = ([x, y]) => [x / SCALE, -y / SCALE];
    const moved = (x, y, done = false) => on(b, said(x, y), done);
    dragged(svg, mass, { place, home, moved, let_go: () => moved(...home(), true) });
    keyed(mass, home, moved);
  });

  /** The places in the drawing of a state: of bodies, contacts and springs. */
  function posed(q, balance) {
    const rest = q.map(() => 0);
    const arms = balance.places(rest).slice(0, scene.contacts.length);
    const still = balance.gaps(rest);
    // room for the spring of a contact that is deep at the origin
    const room = scene.contacts.map(({ elastic }, k) => (elastic ? FOOT + Math.max(0, -still[k]) : 0));
    const shapes = scene.bodies.map((body, b) => outline(body, arms.filter((_, k) => scene.contacts[k].bodies[0] === b)));
    const at_rest = homes(scene, shapes, room);
    const centres = scene.bodies.map(({ along, across }, b) => plus(at_rest[b], [q[along] ?? 0, q[across] ?? 0]));
    const angles = scene.bodies.map(({ angle, sense }) => sense * (q[angle] ?? 0));
    return { arms, shapes, centres, angles, room, still, homes: at_rest, gaps: balance.gaps(q), ends: balance.places(q).slice(arms.length) };
  }

  const spot = ({ centres, angles }, b, local) => plus(centres[b], turned(local, angles[b]));

  /** A line through points, which the picture will contain. */
  function line(parent, points, style, closed = "") {
    points.forEach((point) => now.taken.push(point));
    return part(parent, "path", { d: path(points, closed), class: style });
  }

  function spring(from, to, style = "spring", turns = 9, width = 7) {
    now.taken.push(from, to);
    part(front, "polyline", { points: coil(pixel(from), pixel(to), turns, width), class: style });
  }

  /** Every contact with its spring, and the belt or wall that it touches. */
  function touched() {
    scene.contacts.forEach(({ bodies: [b, other], outward, elastic }, k) => {
      if (b === undefined) {
        return;
      }
      const arm = now.arms[k].map((value, i) => value || outward[i] * [now.shapes[b].wide, now.shapes[b].tall][i]);
      const local = scene.bodies[b].angle === undefined || outward[0] ? arm : [now.arms[k][0], arm[1]];
      const side = [-outward[1], outward[0]];
      const [point, origin] = [spot(now, b, local), plus(now.homes[b], local)];
      const foot = plus(point, outward, elastic ? now.room[k] + Math.min(0, now.gaps[k]) : 0);
      if (elastic) {
        spring(point, foot, "tie", 4, 5);
        line(front, [plus(foot, side, -0.12), plus(foot, side, 0.12)], "foot");
      }
      now.feet[k] = foot;
      if (other === undefined) {
        const level = plus(origin, outward, elastic ? now.room[k] + now.still[k] : 0);
        const half = outward[1] < 0 ? Math.max(...now.homes.map(([x], a) => Math.abs(x - level[0]) + now.shapes[a].wide)) + WAY : 0.35;
        const [left, right] = [plus(level, side, -half), plus(level, side, half)];
        line(backdrop, [left, right, plus(right, outward, BELT), plus(left, outward, BELT)], "belt", "Z");
        if (ways[k] !== undefined) {
          rolled(left, side, outward, 2 * half, ways[k] * (side[0] + side[1]));
        }
      }
    });
  }

  /** Marks of a belt by how far it has run. */
  function rolled(left, side, outward, length, way) {
    const step = 0.2;
    for (let x = ((way % step) + step) % step; x + 0.05 < length; x += step) {
      part(backdrop, "path", { d: path([plus(plus(left, side, x), outward, 0.02), plus(plus(left, side, x + 0.05), outward, 0.1)]), class: "marks" });
    }
  }

  /** Springs along coordinates: between two bodies, or to a wall, a ceiling or the ground. */
  function tied() {
    const below = (b) => scene.contacts.some(({ bodies }) => bodies.indexOf(b) > 0);
    scene.ties.forEach(({ bodies: [a, b], kind }) => {
      const { wide, tall } = now.shapes[a];
      if (kind === "angle") {
        const curl = Array.from({ length: 40 }, (_, i) => plus(now.centres[a], turned([0.004 * (i + 8), 0], 0.35 * i + now.angles[a])));
        line(front, curl, "tie");
      } else if (b !== undefined) {
        const axis = kind === "along" ? 0 : 1;
        const [low, high] = now.homes[a][axis] < now.homes[b][axis] ? [a, b] : [b, a];
        const edge = (one, way) => spot(now, one, axis ? [0, way * now.shapes[one].tall] : [way * now.shapes[one].wide, 0]);
        spring(edge(low, 1), edge(high, -1));
      } else if (kind === "along") {
        const way = a && now.homes.every(([x]) => x <= now.homes[a][0]) ? 1 : -1;
        const wall = plus(now.homes[a], [way * (wide + WAY), 0]);
        spring(wall, spot(now, a, [way * wide, 0]));
        line(backdrop, [plus(wall, [0, -0.25]), plus(wall, [0, 0.25])], "wall");
      } else {
        const way = below(a) ? -1 : 1;
        const wall = plus(now.homes[a], [0.85 * wide, way * (tall + ROOM)]);
        spring(wall, spot(now, a, [0.85 * wide, way * tall]));
        line(backdrop, [plus(wall, [-0.25, 0]), plus(wall, [0.25, 0])], "wall");
      }
    });
  }

  /** Straight springs, from one body to another or to an anchor. */
  function leaning() {
    scene.springs.forEach((owners, i) => {
      const base = (j) => now.homes[owners[j][0] ?? owners[1 - j][0]] ?? [0, 0];
      const ends = [0, 1].map((j) => plus(now.ends[2 * i + j], base(j)));
      spring(...ends);
      owners.forEach((owner, j) => owner.length || part(front, "circle", { cx: pixel(ends[j])[0], cy: pixel(ends[j])[1], r: 8, class: "anchor fixed" }));
    });
  }

  /** Draw the state `q`; `others` are further equilibria, `forces` what acts, `note` is a line of text. */
  function draw({ q, balance, others = [], forces = null, note = "", kind = "" }) {
    backdrop.replaceChildren();
    front.replaceChildren();
    now = { ...posed(q, balance), taken: [], feet: [] };
    touched();
    tied();
    leaning();
    others.forEach((other) => {
      const there = posed(other.q, balance);
      there.shapes.forEach(({ corners }, b) => part(backdrop, "path", { d: path(corners.map((corner) => spot(there, b, corner)), "Z"), class: `ghost ${other.kind}` }));
    });
    masses.forEach((mass, b) => {
      const corners = now.shapes[b].corners.map((corner) => spot(now, b, corner));
      now.taken.push(...corners);
      mass.setAttribute("d", path(corners, "Z"));
      mass.setAttribute("class", `mass ${kind}`);
      const { angle, along, across } = scene.bodies[b];
      const value = Object.entries({ along, across, angle }).flatMap(([name, k]) => (k === undefined ? [] : `${name} ${written(q[k], 4)}`));
      mass.setAttribute("aria-valuetext", value.join(", "));
    });
    fit(note.startsWith("in motion"), note);
    push(forces);
  }

  /** Chooses the frame: all parts, and in motion also the previous frame; rounded to steps, so that it rarely changes. */
  function fit(moving, note) {
    const ends = [0, 1].map((axis) => now.taken.map((point) => near(point[axis])));
    const room = ends.flatMap((values) => [4 * (Math.min(...values) - 0.15), -4 * (Math.max(...values) + 0.15)]).map((value) => Math.floor(value) / 4);
    frame = room.map((value, k) => (moving && frame ? Math.min(frame[k], value) : value));
    const [left, right, low, high] = frame.map((value, k) => (k % 2 ? -value : value));
    const breadth = SCALE * (right - left);
    const size = Math.max(1, breadth / BROAD);
    svg.setAttribute("viewBox", `${SCALE * left} ${-SCALE * high - 24 * size} ${breadth} ${SCALE * (high - low) + 24 * size}`);
    [legend, ...arrows.flat().map(({ label }) => label)].forEach((text) => { text.style.fontSize = `${14 * size}px`; });
    legend.setAttribute("x", SCALE * left + 8);
    legend.setAttribute("y", -SCALE * high - 6 * size);
    legend.textContent = note;
  }

  /** Arrows of the forces of every contact on its body, the longest of a fixed length. */
  function push(forces) {
    const vectors = scene.contacts.map(({ outward: [x, y] }, k) => {
      const [normal, friction] = [forces?.normals[k] ?? 0, forces?.frictions[scene.contacts[k].friction] ?? 0];
      return [[-x * normal, -y * normal], [Math.abs(y) * friction, Math.abs(x) * friction]];
    });
    const largest = Math.max(0, ...vectors.flat().map((vector) => Math.hypot(...vector)));
    arrows.forEach((pair, k) => pair.forEach((one, i) => pushed(one, pixel(now.feet[k] ?? [0, 0]), vectors[k][i], largest)));
  }

  /** Sets how far the belt of every friction has run. */
  function roll(run) {
    ways = scene.contacts.map(({ friction }) => run[friction]);
  }
  roll([]);
  return { draw, roll };
}
