// --------------------------------------------------------------------------------------------------- what is allowed

/** A value as errors show it. */
function shown(value) {
  return typeof value === "string" ? JSON.stringify(value) : typeof value === "symbol" ? "a symbol" : String(value);
}

/** The ends of a quantity's range, and whether they are left out. */
function ends(name) {
  return { low: -Infinity, high: Infinity, low_open: true, high_open: true, ...RANGES[name] };
}

/** The allowed values of a quantity as text. */
function range(name) {
  const { low, high, low_open, high_open } = ends(name);
  return `${low_open ? "(" : "["}${low}, ${high === Math.PI ? "pi" : high}${high_open ? ")" : "]"}`;
}

/** A finite number in the range of a quantity, or an error that names it and says what to do. */
function checked(name, value, remedy = "") {
  if (value === undefined) {
    throw new TypeError(`${name} is missing; it is a number in ${range(name)}`);
  }
  if (typeof value !== "number") {
    throw new TypeError(`${name} = ${shown(value)} is of type ${typeof value}; it must be a number in ${range(name)}`);
  }
  const { low, high, low_open, high_open } = ends(name);
  if (!(Number.isFinite(value) && (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high))) {
    throw new RangeError(`${name} = ${value} is not in ${range(name)}${Number.isFinite(value) ? remedy : ""}`);
  }
  return value;
}

/** An object of which nothing but some names is read; what it is called is for the error. */
function known(what, given, names) {
  if (given === null || typeof given !== "object") {
    throw new TypeError(`the ${what} are ${shown(given)}; give an object with ${names.join(", ")}`);
  }
  for (const name of Object.keys(given)) {
    if (!names.includes(name)) {
      throw new TypeError(`${name} is not among the ${what}, which are ${names.join(", ")}`);
    }
  }
  return given;
}

/** A whole number of at least `least`. */
function whole(name, value, least) {
  if (typeof value !== "number") {
    throw new TypeError(`${name} = ${shown(value)} is of type ${typeof value}; it must be a whole number >= ${least}`);
  }
  if (!(Number.isInteger(value) && value >= least)) {
    throw new RangeError(`${name} = ${value} is not a whole number >= ${least}`);
  }
  return value;
}

/** An array of `length` finite numbers. */
function numbers(name, value, length) {
  if (!(Array.isArray(value) || ArrayBuffer.isView(value)) || value.length !== length) {
    throw new TypeError(`${name} = ${shown(value)} is not an array of ${length} numbers`);
  }
  for (let i = 0; i < length; i++) {
    if (typeof value[i] !== "number") {
      throw new TypeError(`${name}[${i}] = ${shown(value[i])} is of type ${typeof value[i]}; it must be a finite number`);
    }
    if (!Number.isFinite(value[i])) {
      throw new RangeError(`${name}[${i}] = ${value[i]} is not in (-Infinity, Infinity)`);
    }
  }
  return value;
}
