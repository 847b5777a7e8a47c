// A number and a slider for each parameter.

import { degrees, parsed, radians, typed, written } from "./numbers.js";

/** A parameter is `{ name, symbol, meaning, angle, low, high }`: the slider spans low to high, in degrees where it is an angle. */
export const inward = ({ angle }, value) => (angle ? radians(value) : value);
export const outward = ({ angle }, value) => (angle ? degrees(value) : value);
export const idOf = ({ name, angle }) => (angle ? `${name}_deg` : name);

/** What is wrong with a number, or an empty text. */
export function wrong(field, value, text, range = {}) {
  const { low = -Infinity, high = Infinity, low_open, high_open } = range;
  const [least, most] = [outward(field, low), outward(field, high)].map((end) => Number(end.toPrecision(12)));
  if (!Number.isFinite(value)) {
    return `“${text}” is not a number; type one like 0.5 or 0,5`;
  }
  if (value > least || (value === least && !low_open)) {
    if (value < most || (value === most && !high_open)) {
      return "";
    }
  }
  const unit = field.angle ? " degrees" : "";
  const ends = Number.isFinite(high) ? `between ${least} and ${most}${unit}` : `${low_open ? "greater than" : "at least"} ${least}${unit}`;
  return `${field.symbol} must be ${ends}; ${text} is not`;
}

/** Builds the rows; typing and sliding move the store's point. `beside(name, value)` is a text that follows the number. */
export function createInputs(box, store, fields, RANGES, beside = () => "") {
  const rows = fields.map(row);

  function row(field) {
    const { name, symbol, meaning, low, high } = field;
    const id = idOf(field);
    const line = document.createElement("div");
    line.className = "parameter";
    line.innerHTML = `<label for="${id}"><b></b> <span></span> <i></i></label>
      <input id="${id}" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}_error">
      <input id="${id}_slider" type="range" min="${low}" max="${high}" step="any">
      <p class="error" id="${id}_error" role="alert"></p>`;
    line.querySelector("b").textContent = symbol; // what a page says is text, and no HTML
    line.querySelector("span").textContent = meaning + (field.angle ? ", degrees" : "");
    line.querySelector("input[type=range]").setAttribute("aria-label", meaning);
    box.append(line);
    const [number, slider, error, aside] = ["input[type=text]", "input[type=range]", ".error", "i"].map((what) => line.querySelector(what));
    let taken = ""; // the text that was last taken up: leaving the field does not take it up again
    let begun = null; // the state when typing began: half a number leaves no trace on the path

    function say(text) {
      error.textContent = text;
      number.setAttribute("aria-invalid", String(Boolean(text)));
    }

    function take() {
      const value = parsed(number.value);
      const problem = wrong(field, value, number.value, RANGES[name]);
      taken = number.value;
      say(problem);
      if (!problem) {
        begun ??= store.get();
        store.move({ [name]: inward(field, value) }, begun);
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
        const value = outward(field, store.get().point[name]) + (step * (event.shiftKey ? 10 : 1) * (high - low)) / 200;
        if (!wrong(field, value, "", RANGES[name])) {
          store.move({ [name]: inward(field, value) });
          show(true);
        }
      }
    });
    // A slider jumps where it is pressed: at most one move per picture.
    let pending = false;
    slider.addEventListener("input", () => {
      if (!pending) {
        pending = true;
        requestAnimationFrame(() => { pending = false; store.move({ [name]: inward(field, Number(slider.value)) }); });
      }
    });

    function show(always = false) {
      const value = outward(field, store.get().point[name]);
      slider.value = value;
      aside.textContent = beside(name, store.get().point[name]);
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

/** What a parameter is in units of the reader's own, as a text that follows the number. */
export function besides(units) {
  return (name, value) => {
    const unit = units?.parameters[name];
    return unit ? `${unit[0]} = ${written(value * unit[1], 5)} ${unit[2]}` : "";
  };
}
