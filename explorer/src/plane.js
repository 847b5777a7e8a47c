// The plane of two parameters: the number of states, folds where they are known, and the point, which is moved by mouse, touch and keys.

import uPlot from "uplot";
import { colours } from "./colours.js";
import { written } from "./numbers.js";
import { createOverlay } from "./overlay.js";
import { kept, spanOf } from "./spans.js";
import { beside, inward, measured, outward } from "./units.js";

/** Shares of the ranges by which an arrow key moves the point. */
const [ACROSS, UP] = [1 / 360, 1 / 200];
const STEPS = { ArrowLeft: [-ACROSS, 0], ArrowRight: [ACROSS, 0], ArrowDown: [0, -UP], ArrowUp: [0, UP] };
const ANGLES = [0, 30, 60, 90, 120, 150, 180];

/** `axes` are the first two parameters; `turn` changes them, `show` what is drawn over them. */
export function createPlane(box, store, axes) {
  let [spans, shapes, colour] = [[[0, 1], [0, 1]], null, colours()];
  const handle = document.createElement("div");
  handle.id = "point";
  handle.tabIndex = 0;
  handle.setAttribute("role", "slider");
  handle.setAttribute("aria-label", "The point in the plane of two parameters; arrow keys move it, with Shift in larger steps");

  const plot = new uPlot(
    {
      ...size(box),
      legend: { show: false },
      cursor: { show: false },
      scales: { x: { time: false, range: () => spans[0] }, y: { range: () => spans[1] } },
      axes: [axis(0, 34, { splits: (_, __, low, high) => (axes[0].angle ? ANGLES.filter((angle) => low <= angle && angle <= high) : undefined) ?? ticks(low, high) }), axis(1, beside)],
      series: [{}, { paths: () => null, points: { show: false } }],
      hooks: { drawAxes: [shade], draw: [curves, () => store.get() && draw()] },
    },
    [[0, 1], [0, 1]],
    box,
  );
  const glass = createOverlay(plot.over);
  plot.over.append(handle);

  function axis(which, room, more = {}) {
    return {
      label: () => measured(axes[which].symbol, axes[which].unit), labelSize: 18, size: room, labelGap: 0, stroke: () => colour.ink,
      font: "12px system-ui", labelFont: "13px system-ui", grid: { stroke: () => colour.line, width: 1 }, ticks: { stroke: () => colour.line }, ...more,
    };
  }

  const values = (at) => axes.map((field) => outward(field, at[field.name]));
  const pixel = ([x, y], canvas = true) => [plot.valToPos(x, "x", canvas), plot.valToPos(y, "y", canvas)];

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
    clipped((ctx) => {
      for (const { left, right, low, high, count } of shapes?.areas ?? []) {
        const [[a, bottom], [b, above]] = [pixel([outward(axes[0], left), outward(axes[1], low)]), pixel([outward(axes[0], right), Math.min(outward(axes[1], high), spans[1][1])])];
        ctx.fillStyle = count === null ? colour.line : colour.three;
        ctx.fillRect(Math.floor(a), Math.floor(above), Math.ceil(b) - Math.floor(a), Math.ceil(bottom) - Math.floor(above));
      }
    });
  }

  /** Draws a curve, which has a list of values for each parameter. */
  function line(ctx, curve) {
    const [xs, ys] = axes.map(({ name }) => curve[name]);
    ctx.beginPath();
    xs.forEach((x, i) => ctx[i ? "lineTo" : "moveTo"](...pixel([outward(axes[0], x), outward(axes[1], ys[i])])));
    ctx.stroke();
  }

  function curves() {
    if (!shapes?.curves) {
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
      for (const cusp of shapes.cusps.filter((at) => values(at)[1] < spans[1][1])) {
        const [x, y] = pixel(values(cusp));
        ctx.beginPath();
        ctx.arc(x, y, 4.5 * dpr, 0, 7);
        ctx.fill();
        ctx.fillText("cusp", x + 8 * dpr, y + 4 * dpr);
      }
      lowest(ctx, dpr);
      label(ctx, dpr);
    });
  }

  /** Marks where the reference state ends first, if not at a cusp. */
  function lowest(ctx, dpr) {
    const { kind, ...at } = shapes.lowest;
    if (kind && kind !== "cusp" && values(at)[1] < spans[1][1]) {
      const [[x, y], r] = [pixel(values(at)), 5.5 * dpr];
      ctx.beginPath();
      [[0, -r], [r, 0], [0, r], [-r, 0]].forEach(([a, b], i) => ctx[i ? "lineTo" : "moveTo"](x + a, y + b));
      ctx.closePath();
      ctx.lineWidth = 2 * dpr;
      ctx.strokeStyle = colour.ink;
      ctx.stroke();
      ctx.textBaseline = "top";
      ctx.fillText("ends first", x + 4 * dpr, y + 6 * dpr);
      ctx.textBaseline = "alphabetic";
    }
  }

  /** Writes the number of equilibria once in each half: in the middle of the columns whose shaded area takes more than half of the height. */
  function label(ctx, dpr) {
    const [[left, right], [bottom, top]] = spans.map((span, i) => span.map((value) => inward(axes[i], value)));
    ctx.fillStyle = colour.ink;
    ctx.strokeStyle = colour.three;
    ctx.lineWidth = 4 * dpr;
    ctx.lineJoin = "round";
    ctx.font = `${12 * dpr}px system-ui`;
    ctx.textAlign = "center";
    for (const half of [0, 1]) {
      const inside = (at) => Math.floor((2 * (at - left)) / (right - left)) === half;
      const tall = shapes.areas.filter((area) => inside(area.left) && Math.min(area.high, top) - area.low > 0.5 * (top - bottom));
      if (tall.reduce((sum, area) => sum + area.right - area.left, 0) > 0.1 * (right - left)) {
        const { left: at, count } = tall[Math.floor(tall.length / 2)];
        const [text, frame] = [`${count} states`, plot.bbox];
        const [x, y] = pixel([outward(axes[0], at), outward(axes[1], bottom + 0.3 * (top - bottom))]);
        const half_text = ctx.measureText(text).width / 2 + 3 * dpr;
        const kept = Math.min(frame.left + frame.width - half_text, Math.max(frame.left + half_text, x));
        ctx.strokeText(text, kept, y); // a rim: read on a line too
        ctx.fillText(text, kept, y);
      }
    }
    ctx.textAlign = "left";
  }

  /** Draws the path and its jumps on the overlay. */
  function trail() {
    const { path } = store.get() ?? { path: [] };
    glass((ctx) => {
      ctx.strokeStyle = colour.path;
      ctx.lineWidth = 2;
      ctx.beginPath();
      path.forEach(({ point }, i) => ctx[i ? "lineTo" : "moveTo"](...pixel(values(point), false)));
      ctx.stroke();
      ctx.strokeStyle = colour.jump;
      ctx.lineWidth = 2.5;
      ctx.beginPath();
      for (const { point } of path.filter(({ jump }) => jump)) {
        const [[x, y], r] = [pixel(values(point), false), 6];
        [[-r, -r, r, r], [-r, r, r, -r]].forEach(([a, b, c, d]) => { ctx.moveTo(x + a, y + b); ctx.lineTo(x + c, y + d); });
      }
      ctx.stroke();
    });
  }

  /** Move the point to a place in the drawing, kept inside it. */
  function go(place) {
    store.move(Object.fromEntries(axes.map((field, i) => [field.name, inward(field, kept(field, spans[i], place[i]))])));
  }

  let wanted = null;
  function drag(event) {
    const { left, top: above } = plot.over.getBoundingClientRect();
    const first = wanted === null;
    wanted = [plot.posToVal(event.clientX - left, "x"), plot.posToVal(event.clientY - above, "y")];
    if (first) {
      requestAnimationFrame(() => { const place = wanted; wanted = null; go(place); });
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
      const factor = event.shiftKey ? 10 : 1;
      go(values(store.get().point).map((value, i) => value + factor * step[i] * (spans[i][1] - spans[i][0])));
    }
  });

  /** Makes the ranges contain a point; true if they had to change. */
  function reach(point) {
    const next = axes.map((field) => spanOf(field, point[field.name]));
    const other = JSON.stringify(next) !== JSON.stringify(spans);
    spans = next;
    if (other) {
      plot.setData([spans[0], spans[1]]);
    }
    return other;
  }

  function draw() {
    const { point, found } = store.get();
    trail();
    const [x, y] = pixel(values(point), false);
    handle.style.left = `${x}px`;
    handle.style.top = `${y}px`;
    const words = axes.map((field, i) => `${field.meaning} ${written(values(point)[i], 5)}${field.unit && ` ${field.unit}`}`);
    handle.setAttribute("aria-valuetext", `${words.join(", ")}, ${found.states.length} equilibria`);
    handle.setAttribute("aria-valuenow", values(point)[0].toFixed(2));
    handle.setAttribute("aria-valuemin", String(spans[0][0]));
    handle.setAttribute("aria-valuemax", String(spans[0][1]));
  }

  return {
    draw, reach,
    spans: () => spans.map((span, i) => span.map((value) => inward(axes[i], value))),
    axes: () => axes,
    /** Put other parameters on the axes. */
    turn: (fields) => { [axes, shapes] = [fields, null]; spans = [[0, 0], [0, 0]]; },
    /** Draw areas and curves over the plane of the parameters `of`, if these are still on the axes; null for none. */
    show: (found, of) => { if (of.every((name, i) => name === axes[i].name)) { shapes = found; plot.redraw(false); } },
    resize: () => plot.setSize(size(box)),
    recolour: () => { colour = colours(); plot.redraw(false); },
  };
}

/** About five round numbers in a range. */
function ticks(low, high) {
  const rough = (high - low) / 5;
  const unit = 10 ** Math.floor(Math.log10(rough));
  const step = unit * [1, 2, 5, 10].find((factor) => factor * unit >= rough);
  return Array.from({ length: Math.floor(high / step) - Math.ceil(low / step) + 1 }, (_, i) => step * (Math.ceil(low / step) + i));
}

function size(box) {
  return { width: Math.max(260, box.clientWidth), height: Math.max(220, box.clientHeight) };
}
