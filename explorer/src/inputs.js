// A number and a slider for each parameter.

import { degrees, parsed, radians, typed } from "./numbers.js";

/** Per parameter: what it means, and what the slider spans; the number may be anything that is allowed. */
const FIELDS = [
  ["theta0", "θ₀", "inclination of the spring, degrees", 0.5, 179.5],
  ["mu0", "μ₀", "friction coefficient", 0, 1],
  ["kappa", "κ", "preload", 0.001, 0.05],
  ["alpha", "α", "stiffness along the belt", 0, 1],
  ["sigma", "σ", "stiffness of the inclined spring", 0.02, 1],
  ["beta", "β", "stiffness across the belt", 0, 3],
];

const inward = (name, value) => (name === "theta0" ? radians(value) : value);
const outward = (name, value) => (name === "theta0" ? degrees(value) : value);

/** What is wrong with a number, or an empty text. */
export function wrong(name, symbol, value, text, RANGES) {
  const { low = -Infinity, high = Infinity, low_open, high_open } = RANGES[name];
  const [least, most] = [outward(name, low), outward(name, high)];
  if (!Number.isFinite(value)) {
    return `“${text}” is not a number; type one like 0.5 or 0,5`;
  }
  if (value > least || (value === least && !low_open)) {
    if (value < most || (value === most && !high_open)) {
      return "";
    }
  }
  const unit = name === "theta0" ? " degrees" : "";
  const ends = Number.isFinite(high) ? `between ${least} and ${most}${unit}` : `${low_open ? "greater than" : "at least"} ${least}${unit}`;
  return `${symbol} must be ${ends}; ${text} is not`;
}

/** Builds the rows; typing and sliding move the store's point. */
export function createInputs(box, store, RANGES) {
  const rows = FIELDS.map((field) => row(...field));

  function row(name, symbol, meaning, low, high) {
    const id = name === "theta0" ? "theta0_deg" : name;
    const line = document.createElement("div");
    line.className = "parameter";
    line.innerHTML = `<label for="${id}"><b>${symbol}</b> <span>${meaning}</span></label>
      <input id="${id}" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}_error">
      <input id="${id}_slider" type="range" min="${low}" max="${high}" step="any" aria-label="${meaning}">
      <p class="error" id="${id}_error" role="alert"></p>`;
    box.append(line);
    const [number, slider, error] = ["input[type=text]", "input[type=range]", ".error"].map((what) => line.querySelector(what));
    let taken = ""; // the text that was last taken up: leaving the field does not take it up again
    let begun = null; // the state when typing began: half a number leaves no trace on the path

    function say(text) {
      error.textContent = text;
      number.setAttribute("aria-invalid", String(Boolean(text)));
    }

    function take() {
      const value = parsed(number.value);
      const problem = wrong(name, symbol, value, number.value, RANGES);
      taken = number.value;
      say(problem);
      if (!problem) {
        begun ??= store.get();
        store.move({ [name]: inward(name, value) }, begun);
      }
    }

    const done = () => { begun = null; };
    number.addEventListener("input", take);
    number.addEventListener("change", () => {
      if (number.value !== taken) {
        take();
      }
      done();
    });
    number.addEventListener("blur", done);
    number.addEventListener("keydown", (event) => {
      const step = { ArrowUp: 1, ArrowDown: -1 }[event.key];
      if (event.key === "Enter") {
        done();
      } else if (step) {
        event.preventDefault();
        done();
        const value = outward(name, store.get().point[name]) + (step * (event.shiftKey ? 10 : 1) * (high - low)) / 200;
        if (!wrong(name, symbol, value, "", RANGES)) {
          store.move({ [name]: inward(name, value) });
          show(true);
        }
      }
    });
    // A slider jumps where it is pressed: at most one move per picture.
    let pending = false;
    slider.addEventListener("input", () => {
      if (!pending) {
        pending = true;
        requestAnimationFrame(() => { pending = false; store.move({ [name]: inward(name, Number(slider.value)) }); });
      }
    });

    function show(always = false) {
      const value = outward(name, store.get().point[name]);
      slider.value = value;
      slider.setAttribute("aria-valuetext", typed(value, 5));
      if (always || (document.activeElement !== number && parsed(number.value) !== value)) {
        taken = number.value = typed(value);
        done();
        say("");
      }
    }
    return show;
  }

  return (always) => rows.forEach((show) => show(always));
}
