// ---------------------------------------------------------------------------------- what the kernel takes for granted

const UNIT_ROUNDOFF = 0.5 * Number.EPSILON;

function larger(one, other) {
  return one > other ? one : other;
}

function smaller(one, other) {
  return one < other ? one : other;
}

const WORDS = new DataView(new ArrayBuffer(8));
const CUBE_ROOT_STEPS = 3;

/**
 * Cube root of x > 0, 0 of 0: a third of the exponent by the bits, which is good to a few percent, then Halley's method.
 * The C library's statements, with its 64 bits as two words.
 */
function cube_root(x) {
  if (!(x > 0)) {
    return 0;
  }
  WORDS.setFloat64(0, x);
  const given = WORDS.getUint32(0);
  let low = ((WORDS.getUint32(4) >>> 2) | (given << 30)) >>> 0;
  let high = given >>> 2;
  for (const shift of [2, 4, 8]) {
    const sum = low + (((low >>> shift) | (high << (32 - shift))) >>> 0);
    high = high + (high >>> shift) + (sum > 4294967295 ? 1 : 0);
    low = sum >>> 0;
  }
  WORDS.setUint32(0, high + 715094163);
  WORDS.setUint32(4, low);
  let root = WORDS.getFloat64(0);
  for (let pass = 0; pass < CUBE_ROOT_STEPS; pass++) {
    const cube = root * root * root;
    root *= (cube + 2 * x) / (2 * cube + x);
  }
  return root;
}

// --------------------------------------------------------------------------------------------------- what is allowed

const REMEDIES = {
  theta0: ": angles are radians, strictly between 0 and pi",
  mu0: ": a belt that runs the other way is the mirror image: give the supplement of theta0",
  kappa: ": without preload nothing presses the mass on the belt",
  sigma: ": without the inclined spring there is no sprag",
};

/** A value as errors show it. */
function shown(value) {
  return typeof value === "string" ? JSON.stringify(value) : typeof value === "symbol" ? "a symbol" : String(value);
}

/** The allowed values of a quantity as text. */
function range(name) {
  const { low = -Infinity, high = Infinity, open = true } = RANGES[name];
  return `${open ? "(" : "["}${low}, ${high === Math.PI ? "pi" : high})`;
}

/** A finite number in the range of a quantity, or an error that names it. */
function checked(name, value) {
  if (value === undefined) {
    throw new TypeError(`${name} is missing; it is a number in ${range(name)}`);
  }
  if (typeof value !== "number") {
    throw new TypeError(`${name} = ${shown(value)} is of type ${typeof value}; it must be a number in ${range(name)}`);
  }
  const { low = -Infinity, high = Infinity, open = true } = RANGES[name];
  if (!(Number.isFinite(value) && (open ? value > low : value >= low) && value < high)) {
    throw new RangeError(`${name} = ${value} is not in ${range(name)}${REMEDIES[name] ?? ""}`);
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

/** The parameters of a point, checked; those in `spanned` are not used and may be left out. */
function parameters_of(given, spanned = []) {
  known("parameters", given, NAMES);
  const values = {};
  for (const name of NAMES) {
    values[name] = spanned.includes(name) && given[name] === undefined ? NaN : checked(name, given[name]);
  }
  return values;
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
