// A number and a slider for each parameter.

import { parsed, typed, written } from "./numbers.js";
import { inward, outward } from "./units.js";

/** The id of a parameter's input. */
export const idOf = ({ name, angle }) => (angle ? `${name}_deg` : name);

/** What is wrong with a typed number, or an empty text; `field` is as parametersIn gives it, `range` in the model's units. */
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
  const unit = field.unit && ` ${field.unit}`;
  const ends = Number.isFinite(high) ? `between ${least} and ${most}${unit}` : `${low_open ? "greater than" : "at least"} ${least}${unit}`;
  return `${field.symbol} must be ${ends}; ${text} is not`;
}

/** Builds the rows; typing and sliding move the store's point. Beside a number in a file's unit stands the model's own. Returns what updates the rows. */
export function createInputs(box, store, fields, RANGES) {
  const rows = fields.map(row);

  function row(field) {
    const { name, symbol, own, one, angle, meaning, unit, low, high } = field;
    const id = idOf(field);
    const line = document.createElement("div");
    line.className = "parameter";
    line.innerHTML = `<label for="${id}"><b></b> <span></span> <i></i></label>
      <input id="${id}" type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-describedby="${id}_error">
      <input id="${id}_slider" type="range" min="${low}" max="${high}" step="any">
      <p class="error" id="${id}_error" role="alert"></p>`;
    line.querySelector("b").textContent = symbol; // what a page says is text, and no HTML
    line.querySelector("span").textContent = meaning + (unit && `, ${unit}`);
    line.querySelector("input[type=range]").setAttribute("aria-label", meaning);
    box.append(line);
    const [number, slider, error, aside] = ["input[type=text]", "input[type=range]", ".error", "i"].map((what) => line.querySelector(what));
    let taken = ""; // the last text that moved the point: leaving the field does not move it again
    let begun = null; // the store's state when typing began: a number that is not yet whole leaves no trace on the path

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
      aside.textContent = angle || one === 1 ? "" : `${own} = ${written(store.get().point[name], 5)}`;
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
