// The plane of theta0 and mu0: folds, cusps, the lowest fold, flutter onsets, counts, and the point, to be dragged by mouse, touch and keys.

import uPlot from "uplot";
import { colours } from "./colours.js";
import { degrees, radians, written } from "./numbers.js";
import { createOverlay } from "./overlay.js";

const EDGE = 0.01; // degrees: 0 and 180 themselves are not allowed
const STEPS = { ArrowLeft: [-0.5, 0], ArrowRight: [0.5, 0], ArrowDown: [0, -0.005], ArrowUp: [0, 0.005] };

export function createPlane(box, store) {
  let [top, shapes, colour] = [1, null, colours()];
  const handle = document.createElement("div");
  handle.id = "point";
  handle.tabIndex = 0;
  handle.setAttribute("role", "slider");
  handle.setAttribute("aria-label", "The point in the plane of inclination and friction; arrow keys move it, with Shift in larger steps");

  const plot = new uPlot(
    {
      ...size(box),
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: () => [0, 180] }, y: { range: () => [0, top] } },
      axes: [
        axis("θ₀ in degrees", 34, { splits: () => [0, 30, 60, 90, 120, 150, 180] }),
        axis("friction μ₀", 46),
      ],
      series: [{}, { paths: () => null, points: { show: false } }],
      hooks: { drawAxes: [shade], draw: [curves] },
    },
    [[0, 180], [0, 1]],
    box,
  );
  const glass = createOverlay(plot.over);
  plot.over.append(handle);

  function axis(label, room, more = {}) {
    return {
      label, labelSize: 18, size: room, labelGap: 0, stroke: () => colour.ink, font: "12px system-ui", labelFont: "13px system-ui",
      grid: { stroke: () => colour.line, width: 1 }, ticks: { stroke: () => colour.line }, ...more,
    };
  }

  const px = (theta0, mu0) => [plot.valToPos(degrees(theta0), "x", true), plot.valToPos(mu0, "y", true)];

  function clipped(draw) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    draw(ctx, devicePixelRatio);
    ctx.restore();
  }

  function shade() {
    if (shapes) {
      clipped((ctx) => {
        const width = Math.PI / shapes.strips.columns;
        ctx.fillStyle = colour.three;
        for (const { i, low, high } of shapes.strips.found) {
          const [[left, bottom], [right, above]] = [px(i * width, low), px((i + 1) * width, Math.min(high, top))];
          ctx.fillRect(Math.floor(left), above, Math.ceil(right) - Math.floor(left), bottom - above);
        }
      });
    }
  }

  function line(ctx, { theta0, mu0 }) {
    ctx.beginPath();
    theta0.forEach((value, i) => ctx[i ? "lineTo" : "moveTo"](...px(value, mu0[i])));
    ctx.stroke();
  }

  function curves() {
    if (!shapes) {
      return;
    }
    clipped((ctx, dpr) => {
      ctx.lineWidth = 2 * dpr;
      ctx.strokeStyle = colour.ink;
      shapes.curves.forEach((curve) => line(ctx, curve));
      ctx.setLineDash([7 * dpr, 4 * dpr]);
      ctx.strokeStyle = colour.flutter;
      shapes.flutter.forEach((curve) => line(ctx, curve));
      ctx.setLineDash([]);
      ctx.font = `600 ${13 * dpr}px system-ui`;
      ctx.fillStyle = colour.ink;
      ctx.textAlign = "left";
      for (const { theta0, mu0 } of shapes.cusps.filter((cusp) => cusp.mu0 < top)) {
        const [x, y] = px(theta0, mu0);
        ctx.beginPath();
        ctx.arc(x, y, 4.5 * dpr, 0, 7);
        ctx.fill();
        ctx.fillText("cusp", x + 8 * dpr, y + 4 * dpr);
      }
      lowest(ctx, dpr);
      label(ctx, dpr);
    });
  }

  /** Where the lowest fold is no cusp, a mark of its own. */
  function lowest(ctx, dpr) {
    const { theta0, mu0, kind } = shapes.lowest;
    if (kind && kind !== "cusp" && mu0 < top) {
      const [[x, y], r] = [px(theta0, mu0), 5.5 * dpr];
      ctx.beginPath();
      [[0, -r], [r, 0], [0, r], [-r, 0]].forEach(([a, b], i) => ctx[i ? "lineTo" : "moveTo"](x + a, y + b));
      ctx.closePath();
      ctx.lineWidth = 2 * dpr;
      ctx.strokeStyle = colour.ink;
      ctx.stroke();
      ctx.textBaseline = "top";
      ctx.fillText("lowest fold", x + 4 * dpr, y + 6 * dpr);
      ctx.textBaseline = "alphabetic";
    }
  }

  /** How many equilibria there are, once in each half: in the middle of the columns that have them over most of their height. */
  function label(ctx, dpr) {
    const { columns, found } = shapes.strips;
    ctx.fillStyle = colour.ink;
    ctx.strokeStyle = colour.three;
    ctx.lineWidth = 4 * dpr;
    ctx.lineJoin = "round";
    ctx.font = `${12 * dpr}px system-ui`;
    ctx.textAlign = "center";
    for (const half of [0, 1]) {
      const tall = found.filter(({ i, low, high }) => Math.floor((2 * i) / columns) === half && Math.min(high, top) - low > 0.5 * top);
      if (tall.length > 0.1 * columns) {
        const { i, count } = tall[Math.floor(tall.length / 2)];
        const [text, { left, width }] = [`${count} states`, plot.bbox];
        const [x, y] = px((Math.PI * (i + 0.5)) / columns, 0.3 * top);
        const half_text = ctx.measureText(text).width / 2 + 3 * dpr;
        const kept = Math.min(left + width - half_text, Math.max(left + half_text, x));
        ctx.strokeText(text, kept, y); // a rim: read on a line too
        ctx.fillText(text, kept, y);
      }
    }
    ctx.textAlign = "left";
  }

  /** The path and its jumps, on the glass: the drawing beneath stays as it is while the point is dragged. */
  function trail() {
    const { path } = store.get() ?? { path: [] };
    const near = ({ theta0, mu0 }) => [plot.valToPos(degrees(theta0), "x"), plot.valToPos(mu0, "y")];
    glass((ctx) => {
      ctx.strokeStyle = colour.path;
      ctx.lineWidth = 2;
      ctx.beginPath();
      path.forEach((at, i) => ctx[i ? "lineTo" : "moveTo"](...near(at)));
      ctx.stroke();
      ctx.strokeStyle = colour.jump;
      ctx.lineWidth = 2.5;
      ctx.beginPath();
      for (const at of path.filter(({ jump }) => jump)) {
        const [[x, y], r] = [near(at), 6];
        [[-r, -r, r, r], [-r, r, r, -r]].forEach(([a, b, c, d]) => { ctx.moveTo(x + a, y + b); ctx.lineTo(x + c, y + d); });
      }
      ctx.stroke();
    });
  }

  /** Move the point to a place in the drawing, kept inside it. */
  function go(theta0, mu0) {
    const kept = Math.min(180 - EDGE, Math.max(EDGE, theta0));
    store.move({ theta0: radians(kept), mu0: Math.min(top, Math.max(0, mu0)) });
  }

  let wanted = null;
  function drag(event) {
    const { left, top: above } = plot.over.getBoundingClientRect();
    const first = wanted === null;
    wanted = [plot.posToVal(event.clientX - left, "x"), plot.posToVal(event.clientY - above, "y")];
    if (first) {
      requestAnimationFrame(() => { const [theta0, mu0] = wanted; wanted = null; go(theta0, mu0); });
    }
  }
  plot.over.addEventListener("pointerdown", (event) => {
    plot.over.setPointerCapture(event.pointerId);
    handle.focus({ preventScroll: true });
    drag(event);
    event.preventDefault();
  });
  plot.over.addEventListener("pointermove", (event) => plot.over.hasPointerCapture(event.pointerId) && drag(event));
  handle.addEventListener("keydown", (event) => {
    const step = STEPS[event.key];
    if (step) {
      event.preventDefault();
      const { theta0, mu0 } = store.get().point;
      const factor = event.shiftKey ? 10 : 1;
      go(degrees(theta0) + factor * step[0], mu0 + factor * step[1] * top);
    }
  });

  function draw() {
    const { point, found } = store.get();
    trail();
    handle.style.left = `${plot.valToPos(degrees(point.theta0), "x")}px`;
    handle.style.top = `${plot.valToPos(Math.min(point.mu0, top), "y")}px`;
    const text = `inclination ${written(degrees(point.theta0), 5)} degrees, friction ${written(point.mu0, 4)}, ${found.contact.count} equilibria in contact`;
    handle.setAttribute("aria-valuetext", text);
    handle.setAttribute("aria-valuenow", degrees(point.theta0).toFixed(2));
    handle.setAttribute("aria-valuemin", "0");
    handle.setAttribute("aria-valuemax", "180");
  }

  return {
    draw,
    show: (found) => { shapes = found; plot.redraw(false); },
    reach: (value) => { top = value; plot.redraw(true); },
    resize: () => { plot.setSize(size(box)); draw(); },
    recolour: () => { colour = colours(); plot.redraw(false); draw(); },
  };
}

const KINDS = { cusp: "a cusp", turn: "where the curve of folds turns back", end: "as θ₀ goes to 0" };

/** What the lowest fold means, in a sentence; `shapes` may be null. */
export function lowestFold(shapes) {
  if (!shapes) {
    return "";
  }
  const { theta0, mu0, kind } = shapes.lowest;
  return kind
    ? `Lowest fold that ends the state of small deformation: μ₀ = ${written(mu0, 6)} at θ₀ = ${written(degrees(theta0), 5)}°, ${KINDS[kind]}. Below that friction it jumps at no inclination (in double precision, not proved).`
    : "No fold ends the state of small deformation, at any inclination and friction (in double precision, not proved).";
}

function size(box) {
  return { width: Math.max(260, box.clientWidth), height: Math.max(220, box.clientHeight) };
}
