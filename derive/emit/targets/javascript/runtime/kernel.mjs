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
