// The chart of the states along one parameter, searched at many of its values, a few before each picture.

import uPlot from "uplot";
import { colours } from "./colours.js";
import { createOverlay } from "./overlay.js";
import { kept } from "./spans.js";
import { beside, inward, measured, outward } from "./units.js";

const COLUMNS = 161;
/** How long a search may delay a picture, milliseconds. */
const BUDGET = 8;
/** The mark of each kind, told apart by shape as well as by colour. */
const MARKS = {
  stable: (ctx, x, y, r) => ctx.arc(x, y, r, 0, 7),
  divergent: (ctx, x, y, r) => { ctx.moveTo(x - r, y + r); ctx.lineTo(x, y - r); ctx.lineTo(x + r, y + r); ctx.closePath(); },
  flutter: (ctx, x, y, r) => ctx.rect(x - r, y - r / 2, 2 * r, r),
};

/**
 * `field()` is the parameter on the horizontal axis, `span()` its range, `states(value)` gives the states there, `shown()` the parameter's value and the
 * first coordinate of the current state; `go(value)` is called where the chart is pressed. `coordinate` says how the first coordinate is shown.
 */
export function createAlong(box, { field, span, states, shown, go }, coordinate) {
  let [colour, points, ask, glass] = [colours(), [], 0, null];
  const axis = (label, size) => ({
    label, labelSize: 18, size, labelGap: 0, stroke: () => colour.ink, font: "12px system-ui", labelFont: "13px system-ui",
    grid: { stroke: () => colour.line, width: 1 }, ticks: { stroke: () => colour.line },
  });
  const plot = new uPlot({
    ...size(), legend: { show: false }, cursor: { show: false },
    scales: { x: { time: false, range: () => span() }, y: { range: () => spread() } },
    axes: [axis(() => measured(field().symbol, field().unit), 34), axis(measured(coordinate.symbol, coordinate.unit), beside)],
    series: [{}, { paths: () => null, points: { show: false } }],
    hooks: { draw: [marks, () => draw()] },
  }, [[0, 1], [0, 1]], box);
  glass = createOverlay(plot.over);

  function size() {
    return { width: Math.max(260, box.clientWidth), height: Math.max(220, box.clientHeight) };
  }

  function spread() {
    const values = [...points.map(({ y }) => y), coordinate.size * (shown()?.[1] ?? 0)];
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = 0.06 * (high - low) || 0.1 * coordinate.size;
    return [low - room, high + room];
  }

  function marks({ ctx, bbox }) {
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const [kind, mark] of Object.entries(MARKS)) {
      for (const whole of [true, false]) {
        ctx.beginPath();
        ctx[whole ? "fillStyle" : "strokeStyle"] = colour[kind] ?? colour.ink;
        for (const point of points.filter((one) => one.kind === kind && one.whole === whole)) {
          const [x, y] = [plot.valToPos(point.x, "x", true), plot.valToPos(point.y, "y", true)];
          ctx.moveTo(x, y);
          mark(ctx, x, y, 2.6 * devicePixelRatio);
        }
        ctx[whole ? "fill" : "stroke"]();
      }
    }
    ctx.restore();
  }

  /** Search anew, from left to right; a search that is still running is given up. */
  function renew() {
    ask += 1;
    const mine = ask;
    points = [];
    let i = 0;
    const [low, high] = span();
    const more = () => {
      if (mine !== ask) {
        return;
      }
      const end = performance.now() + BUDGET;
      while (i < COLUMNS && performance.now() < end) {
        const x = low + ((high - low) * (i + 0.5)) / COLUMNS; // off the ends, which may not be allowed
        points.push(...states(inward(field(), x)).map(({ q, undamped, regime }) => ({ x, y: coordinate.size * q[0], kind: undamped, whole: regime === 0 })));
        i += 1;
      }
      if (i < COLUMNS) {
        requestAnimationFrame(more);
      }
      plot.setData([[0, 1], [0, 1]]);
    };
    more();
  }

  function draw() {
    const now = shown();
    glass?.((ctx, width, height) => {
      if (now) {
        const [x, y] = [plot.valToPos(outward(field(), now[0]), "x"), now[1] === null ? null : plot.valToPos(coordinate.size * now[1], "y")];
        ctx.strokeStyle = colour.accent;
        ctx.lineWidth = 1.5;
        ctx.beginPath();
        ctx.moveTo(x, 0);
        ctx.lineTo(x, height);
        ctx.stroke();
        if (y !== null) {
          ctx.beginPath();
          ctx.lineWidth = 3;
          ctx.arc(x, y, 7, 0, 7);
          ctx.stroke();
        }
      }
    });
  }

  let pending = null;
  function drag(event) {
    const first = pending === null;
    pending = plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x");
    if (first) {
      requestAnimationFrame(() => { const value = pending; pending = null; go(inward(field(), kept(field(), span(), value))); });
    }
  }
  plot.over.addEventListener("pointerdown", (event) => { plot.over.setPointerCapture(event.pointerId); drag(event); event.preventDefault(); });
  plot.over.addEventListener("pointermove", (event) => plot.over.hasPointerCapture(event.pointerId) && drag(event));

  return {
    renew, draw,
    resize: () => plot.setSize(size()),
    recolour: () => { colour = colours(); plot.redraw(false); },
  };
}
