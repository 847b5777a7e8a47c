// Runs calls of the module for the tests: `node driver.mjs MODULE < calls.json > answers.json`.
// A call is { name, given } with the arguments; an answer is { value }, or { error, message } where the call threw.
// Numbers that JSON has not are written as { number: "NaN" }.
import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const library = await import(pathToFileURL(process.argv[2]));

/** The state after `count` steps. */
function steps(parameters, drive, start, h, count) {
  const { step } = library.motion(parameters, drive);
  let state = start;
  for (let i = 0; i < count; i++) {
    state = step(state, h);
  }
  return state;
}

/** Nanoseconds a call of `equilibria` over points, the best of three runs. */
function speed(points, options) {
  let best = Infinity;
  let counted = 0;
  for (let run = 0; run < 3; run++) {
    const start = process.hrtime.bigint();
    for (const point of points) {
      counted += library.equilibria(point, options).count;
    }
    best = Math.min(best, Number(process.hrtime.bigint() - start));
  }
  return { nanoseconds: best / points.length, counted };
}

const own = {
  steps,
  speed,
  motion: (method, parameters, drive, ...given) => library.motion(parameters, drive)[method](...given),
};

function called(name) {
  const found = own[name] ?? name.split(".").reduce((at, part) => at?.[part], library);
  if (typeof found !== "function") {
    throw new Error(`the module has no function ${name}`);
  }
  return found;
}

const read = (_, value) => (value !== null && typeof value === "object" && "number" in value ? Number(value.number) : value);
const written = (_, value) => (typeof value === "number" && !Number.isFinite(value) ? { number: String(value) } : value);

const answers = JSON.parse(readFileSync(0, "utf8"), read).map(({ name, given }) => {
  try {
    return { value: called(name)(...given) };
  } catch (error) {
    return { error: error.name, message: error.message };
  }
});
process.stdout.write(JSON.stringify(answers, written));
