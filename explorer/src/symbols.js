// Names of parameters and coordinates as symbols.

const GREEK = { alpha: "α", beta: "β", gamma: "γ", delta: "δ", kappa: "κ", lambda: "λ", mu: "μ", nu: "ν", psi: "ψ", phi: "φ", rho: "ρ",
  sigma: "σ", tau: "τ", theta: "θ", zeta: "ζ", omega: "ω", iota: "ι", eta: "η", epsilon: "ε", chi: "χ", xi: "ξ", upsilon: "υ",
  Gamma: "Γ", Delta: "Δ", Theta: "Θ", Lambda: "Λ", Xi: "Ξ", Sigma: "Σ", Upsilon: "Υ", Phi: "Φ", Psi: "Ψ", Omega: "Ω" };
const DIGITS = "₀₁₂₃₄₅₆₇₈₉";

/** A letter with an index if there are several of its kind: θ₁ of two, θ of one. */
export const numbered = (letter, i, count) => letter + (count > 1 ? [...String(i + 1)].map((digit) => DIGITS[digit]).join("") : "");

/** `theta0_2` as θ₀₂, `zeta_x` as ζ_x, `lambda_`, which Python has to write so, as λ, any other name as it is. */
export function symbolOf(name) {
  const [, head, digits, tail] = /^([A-Za-z]+?)(\d*)((?:_\w+)?)_?$/.exec(name) ?? [null, name, "", ""];
  const low = (text) => [...text].map((digit) => DIGITS[digit]).join("");
  const behind = /^_\d+$/.test(tail) ? low(tail.slice(1)) : tail;
  return (GREEK[head] ?? head) + low(digits) + behind;
}
