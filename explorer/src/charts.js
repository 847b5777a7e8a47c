// The charts of a motion: trace in time, phase portrait and spectrum.

import FFT from "fft.js";
import uPlot from "uplot";
import { colours } from "./colours.js";
import { beside, measured } from "./units.js";

/** The most samples that are kept, and the fewest that give a spectrum. */
const SAMPLES = 2048;
const FEWEST = 256;
const HIGHEST = 2; // angular frequency of the spectrum, in sqrt(k_c/m)
/** Colours and lines of the coordinates, told apart by dashes as well. */
const STROKES = ["accent", "flutter", "divergent", "ink"];
const LINES = [{ width: 2 }, { width: 1.5, dash: [6, 4] }, { width: 1.5, dash: [2, 3] }, { width: 1, dash: [10, 3, 2, 3] }];

/**
 * `coordinates` are as coordinatesIn gives them, the third argument is the model's unit of time: its length and its name. A state holds the coordinates,
 * then their rates.
 */
export function createCharts({ trace, phase, spectrum }, coordinates, [lasting, time_name]) {
  const n = coordinates.length;
  const names = coordinates.map(({ symbol }) => symbol);
  const [first] = coordinates;
  let colour = colours();
  let history = empty();
  const transforms = new Map();

  function empty() {
    return { t: [], q: names.map(() => []), v: [], off: [], ahead: [] };
  }

  const axis = (label, more = {}) => ({
    label, labelSize: 18, labelGap: 0, stroke: () => colour.ink, font: "11px system-ui", labelFont: "12px system-ui",
    grid: { stroke: () => colour.line, width: 1 }, ticks: { stroke: () => colour.line }, ...more,
  });
  /** The range of an axis: that of the data, or of length `end` where they are constant or missing. */
  const reach = (end) => (plot, low, high) => (low === null || low === high ? [Math.min(0, low ?? 0), (high ?? 0) + end] : uPlot.rangeNum(low, high, 0.05, true));
  const plain = { legend: { show: false }, cursor: { show: false } };

  const traced = new uPlot({
    ...plain, ...size(trace), scales: { x: { time: false, range: reach(100 * lasting) }, y: { range: reach(0.1 * first.size) } }, axes: [axis(time_name ? measured("time", time_name) : "time τ", { size: 32 }), axis(measured(names.join(", "), first.unit), { size: beside })],
    series: [{}, ...names.map((_, i) => ({ ...LINES[i % LINES.length], stroke: () => colour[STROKES[i % STROKES.length]] }))],
    hooks: { drawAxes: [marks] },
  }, [[], ...names.map(() => [])], trace);

  const portrait = new uPlot({
    ...plain, ...size(phase), scales: { x: { time: false, range: () => spread(history.q[0], first.size) }, y: { range: () => spread(history.v, first.rate) } },
    axes: [axis(measured(names[0], first.unit), { size: 32 }), axis(measured(`${names[0]}′`, first.rate_unit), { size: beside })], series: [{}, { paths: () => null, points: { show: false } }],
    hooks: { draw: [orbit] },
  }, [[0, 1], [0, 1]], phase);

  const spectral = new uPlot({
    ...plain, ...size(spectrum), scales: { x: { time: false, range: () => [0, time_name ? HIGHEST / (2 * Math.PI * lasting) : HIGHEST] }, y: { range: reach(0.1 * first.size) } },
    axes: [axis(time_name ? `frequency in ${time_name === "s" ? "Hz" : `1/${time_name}`}` : "angular frequency", { size: 32 }), axis(measured(`amplitude of ${names[0]}`, first.unit), { size: beside })],
    series: [{}, { stroke: () => colour.accent, width: 1.5, fill: () => colour.three }],
  }, [[], []], spectrum);

  function spread(values, size) {
    const [low, high] = values.length ? [Math.min(...values), Math.max(...values)] : [-size, size];
    const room = 0.08 * (high - low) || 0.1 * size;
    return [low - room, high + room];
  }

  /** Marks the times at which the mass is off the belt by a band, those at which it is faster than the belt by a bar at the top. */
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
    const count = history.v.length;
    const place = (i) => [plot.valToPos(history.q[0][i], "x", true), plot.valToPos(history.v[i], "y", true)];
    for (const off of [false, true]) {
      ctx.beginPath();
      ctx.strokeStyle = off ? colour.flutter : colour.accent;
      ctx.setLineDash(off ? [5 * devicePixelRatio, 3 * devicePixelRatio] : []);
      ctx.lineWidth = 1.5 * devicePixelRatio;
      for (let i = 1; i < count; i++) {
        if (history.off[i] === off) {
          if (i === 1 || history.off[i - 1] !== off) {
            ctx.moveTo(...place(i - 1));
          }
          ctx.lineTo(...place(i));
        }
      }
      ctx.stroke();
    }
    if (count) {
      ctx.setLineDash([]);
      ctx.fillStyle = colour.ink;
      ctx.beginPath();
      ctx.arc(...place(count - 1), 4 * devicePixelRatio, 0, 7);
      ctx.fill();
    }
    ctx.restore();
  }

  /** The spectrum of the first coordinate, over the largest power of two of the last samples, with a Hann window: frequencies and amplitudes. */
  function analysed() {
    const size = 2 ** Math.floor(Math.log2(Math.max(1, history.v.length)));
    if (size < FEWEST) {
      return [[], []];
    }
    if (!transforms.has(size)) {
      transforms.set(size, new FFT(size));
    }
    const fft = transforms.get(size);
    const output = fft.createComplexArray();
    const x = history.q[0].slice(-size);
    const mean = x.reduce((sum, value) => sum + value, 0) / size;
    fft.realTransform(output, x.map((value, i) => (value - mean) * (0.5 - 0.5 * Math.cos((2 * Math.PI * i) / size))));
    const step = (2 * Math.PI) / (size * (history.t.at(-1) - history.t.at(-2)));
    const bins = Array.from({ length: Math.min(size / 2, Math.ceil(HIGHEST / lasting / step)) }, (_, i) => i);
    return [bins.map((i) => (time_name ? (i * step) / (2 * Math.PI) : i * step)), bins.map((i) => (4 / size) * Math.hypot(output[2 * i], output[2 * i + 1]))];
  }

  function draw(also_spectrum) {
    traced.setData([history.t, ...history.q]);
    portrait.redraw(false, true);
    portrait.setData([[0, 1], [0, 1]]);
    if (also_spectrum) {
      spectral.setData(analysed());
    }
  }

  return {
    add(t, state, { touching, sides }) {
      history.q.forEach((column, i) => column.push(coordinates[i].size * state[i]));
      const row = { t: lasting * t, v: first.rate * state[n], off: !touching.every(Boolean), ahead: sides.some((side) => side < 0) };
      Object.entries(row).forEach(([name, value]) => history[name].push(value));
      if (history.v.length > SAMPLES) {
        [...history.q, history.t, history.v, history.off, history.ahead].forEach((column) => column.shift());
      }
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
