// Trace, phase portrait and spectrum of a motion.

import FFT from "fft.js";
import uPlot from "uplot";
import { colours } from "./colours.js";

/** Samples that are kept, and the fewest that give a spectrum. */
const SAMPLES = 2048;
const FEWEST = 256;
const HIGHEST = 2; // angular frequency, in sqrt(k_c/m)

export function createCharts({ trace, phase, spectrum }) {
  let colour = colours();
  let history = empty();
  const transforms = new Map();

  function empty() {
    return { t: [], x: [], y: [], vx: [], off: [], ahead: [] };
  }

  const axis = (label, more = {}) => ({
    label, labelSize: 18, labelGap: 0, stroke: () => colour.ink, font: "11px system-ui", labelFont: "12px system-ui",
    grid: { stroke: () => colour.line, width: 1 }, ticks: { stroke: () => colour.line }, ...more,
  });
  /** The range of the data, or from 0 to a number without any. */
  const reach = (end) => (plot, low, high) => (low === null || low === high ? [Math.min(0, low ?? 0), (high ?? 0) + end] : uPlot.rangeNum(low, high, 0.05, true));
  const plain = { legend: { show: false }, cursor: { show: false } };

  const traced = new uPlot({
    ...plain, ...size(trace), scales: { x: { time: false, range: reach(100) }, y: { range: reach(0.1) } }, axes: [axis("time τ", { size: 32 }), axis("x, y", { size: 50 })],
    series: [{}, { stroke: () => colour.accent, width: 2 }, { stroke: () => colour.flutter, width: 1.5, dash: [6, 4] }],
    hooks: { drawAxes: [marks] },
  }, [[], [], []], trace);

  const portrait = new uPlot({
    ...plain, ...size(phase), scales: { x: { time: false, range: (u, low, high) => spread(history.x) }, y: { range: () => spread(history.vx) } },
    axes: [axis("x", { size: 32 }), axis("x′", { size: 50 })], series: [{}, { paths: () => null, points: { show: false } }],
    hooks: { draw: [orbit] },
  }, [[0, 1], [0, 1]], phase);

  const spectral = new uPlot({
    ...plain, ...size(spectrum), scales: { x: { time: false, range: () => [0, HIGHEST] }, y: { range: reach(0.1) } },
    axes: [axis("angular frequency", { size: 32 }), axis("amplitude of x", { size: 50 })],
    series: [{}, { stroke: () => colour.accent, width: 1.5, fill: () => colour.three }],
  }, [[], []], spectrum);

  function spread(values) {
    const [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [-1, 1];
    const room = 0.08 * (high - low) || 0.1;
    return [low - room, high + room];
  }

  /** Where the mass is off the belt, a band; where it is faster than the belt, a bar at the top. */
  function marks(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    for (const [flags, fill, height] of [[history.off, colour.three, bbox.height], [history.ahead, colour.divergent, 6 * devicePixelRatio]]) {
      ctx.fillStyle = fill;
      let start = null;
      flags.forEach((flag, i) => {
        start = flag && start === null ? history.t[i] : start;
        if (start !== null && (!flag || i === flags.length - 1)) {
          const [left, right] = [start, history.t[i]].map((t) => plot.valToPos(t, "x", true));
          ctx.fillRect(Math.max(left, bbox.left), bbox.top, Math.max(1, right - Math.max(left, bbox.left)), height);
          start = null;
        }
      });
    }
    ctx.restore();
  }

  function orbit(plot) {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    const place = (i) => [plot.valToPos(history.x[i], "x", true), plot.valToPos(history.vx[i], "y", true)];
    for (const off of [false, true]) {
      ctx.beginPath();
      ctx.strokeStyle = off ? colour.flutter : colour.accent;
      ctx.setLineDash(off ? [5 * devicePixelRatio, 3 * devicePixelRatio] : []);
      ctx.lineWidth = 1.5 * devicePixelRatio;
      for (let i = 1; i < history.x.length; i++) {
        if (history.off[i] === off) {
          if (i === 1 || history.off[i - 1] !== off) {
            ctx.moveTo(...place(i - 1));
          }
          ctx.lineTo(...place(i));
        }
      }
      ctx.stroke();
    }
    if (history.x.length) {
      ctx.setLineDash([]);
      ctx.fillStyle = colour.ink;
      ctx.beginPath();
      ctx.arc(...place(history.x.length - 1), 4 * devicePixelRatio, 0, 7);
      ctx.fill();
    }
    ctx.restore();
  }

  /** Amplitudes over angular frequency of the last values, as many as a power of two, by a Hann window. */
  function analysed() {
    const size = 2 ** Math.floor(Math.log2(Math.max(1, history.x.length)));
    if (size < FEWEST) {
      return [[], []];
    }
    if (!transforms.has(size)) {
      transforms.set(size, new FFT(size));
    }
    const fft = transforms.get(size);
    const output = fft.createComplexArray();
    const x = history.x.slice(-size);
    const mean = x.reduce((sum, value) => sum + value, 0) / size;
    fft.realTransform(output, x.map((value, i) => (value - mean) * (0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size))));
    const step = (2 * Math.PI) / (size * (history.t.at(-1) - history.t.at(-2)));
    const bins = Array.from({ length: Math.min(size / 2, Math.ceil(HIGHEST / step)) }, (_, i) => i);
    return [bins.map((i) => i * step), bins.map((i) => (4 / size) * Math.hypot(output[2 * i], output[2 * i + 1]))];
  }

  function draw(also_spectrum) {
    traced.setData([history.t, history.x, history.y]);
    portrait.redraw(false, true);
    portrait.setData([[0, 1], [0, 1]]);
    if (also_spectrum) {
      spectral.setData(analysed());
    }
  }

  return {
    add(t, [x, y, vx], { contact, side }) {
      const row = { t, x, y, vx, off: !contact, ahead: side < 0 };
      Object.entries(row).forEach(([name, value]) => {
        history[name].push(value);
        if (history[name].length > SAMPLES) {
          history[name].shift();
        }
      });
    },
    clear() { history = empty(); draw(true); },
    draw,
    resize() { [[traced, trace], [portrait, phase], [spectral, spectrum]].forEach(([plot, box]) => plot.setSize(size(box))); },
    recolour() { colour = colours(); [traced, portrait, spectral].forEach((plot) => plot.redraw()); },
  };
}

function size(box) {
  return { width: Math.max(240, box.clientWidth), height: Math.max(160, box.clientHeight) };
}
