r"""What is printed: every numbered equation, appendix coefficient and definition of the article,
mistakes included.

J. Kang and J. Nam, "Minimal Model for Sprag-Slip Oscillation as Catastrophe-Type Behavior", Applied
Sciences 10 (2020)
2748. Nothing here is derived or corrected; :mod:`derive.kang_nam.check` compares each entry with
      the
derivation.

``latex`` is the article's typesetting. ``expression`` is its transcription: for an equation, left
side less right side; for several components, a tuple. Where the article writes a relation between
objects that it defines elsewhere (D, b, the coefficients), the transcription is a function of those
objects, so that each mistake is found where it stands and not wherever it is used.
"""

from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import sympy as sp

from ..algebra import Row
from .mechanics import AX, AY
from .nomenclature import (
    F_L,
    L,
    L_0,
    N,
    V,
    alpha,
    b1,
    b2,
    b3,
    b4,
    beta,
    c,
    c0,
    creep,
    k,
    k_c,
    k_x,
    k_y,
    kappa,
    m_mass,
    mu,
    mu0,
    n,
    nbar,
    s,
    s0,
    sigma,
    vx,
    x,
    y,
)

#: The stretch of the inclined spring, as the article writes it in (1)–(3).
Delta = sp.Symbol("Delta", real=True)
lam = sp.Symbol("lambda")

Expression = sp.Expr | Row | Callable[..., Any]


@dataclass(frozen=True)
class Printed:
    """One printed statement."""

    id: str
    where: str
    latex: str
    expression: Expression


def _linear(D: sp.Matrix, b: sp.Matrix) -> Row:
    """D (cos θ, sin θ)ᵀ = b."""
    return tuple(D * sp.Matrix([c, s]) - b)


def _unit_norm(D: sp.Matrix, b: sp.Matrix) -> sp.Expr:
    """1 = bᵀ (D Dᵀ)⁻¹ b."""
    return (b.T * (D * D.T).inv() * b)[0, 0] - 1


def _quartic(*coefficients: sp.Expr) -> sp.Expr:
    """Coefficients of ascending powers of L."""
    return sp.Add(*(value * L**power for power, value in enumerate(coefficients)))


def _equation(number: int, latex: str, expression: Expression) -> Printed:
    return Printed(f"eq-{number}", f"Equation ({number})", latex, expression)


def _appendix(id: str, latex: str, expression: sp.Expr) -> Printed:
    return Printed(id, f"Appendix A, ({id.split('-')[0]})", latex, expression)


def _definition(id: str, latex: str, expression: Expression) -> Printed:
    return Printed(f"def-{id}", "text after Equation (9)", latex, expression)


EQUATIONS = (
    _equation(
        1,
        r"m\ddot{x} = \mu N - k\Delta\cos\theta - k_x x",
        m_mass * AX - (mu * N - k * Delta * c - k_x * x),
    ),
    _equation(
        2,
        r"m\ddot{y} = N - F_L - k\Delta\sin\theta - k_y y",
        m_mass * AY - (N - F_L - k * Delta * s - k_y * y),
    ),
    _equation(3, r"\Delta = L_o - L", L_0 - L),
    _equation(4, r"L\cos\theta = L_0\cos\theta_0 - x", L * c - (L_0 * c0 - x)),
    _equation(5, r"L\sin\theta = L_0\sin\theta_0 - y", L * s - (L_0 * s0 - y)),
    _equation(
        6,
        r"L = \sqrt{\left(L_o \cos \theta - x\right)^2 + \left(L_o \sin \theta - y\right)^2}",
        sp.sqrt((L_0 * c - x) ** 2 + (L_0 * s - y) ** 2),
    ),
    _equation(
        7,
        r"N = \begin{cases} -k_c y, & if \quad y < 0\\ 0, & if \quad y \ge 0 \end{cases}",
        (-k_c * y, sp.S.Zero),
    ),
    _equation(
        8,
        r"x'' + \frac{\sigma}{L}(1-L)(\cos\theta_o - x) + \alpha x - \mu n = 0",
        AX + sigma / L * (1 - L) * (c0 - x) + alpha * x - mu * n,
    ),
    _equation(
        9,
        r"y'' + \frac{\sigma}{L}(1-L)(\sin\theta_o - y) + \beta y - n = 0",
        AY + sigma / L * (1 - L) * (s0 - y) + beta * y - n,
    ),
    _equation(
        10,
        r"\mu = \mu_o \left\{ 1 - \exp\left(-d\left|V - \dot{x}\right|\right) \right\} sgn(V "
        r"- \dot{x})",
        mu0 * (1 - sp.exp(-creep * sp.Abs(V - vx))) * sp.sign(V - vx),
    ),
    _equation(11, r"n = \frac{1}{2} \left(\left| y \right| - y \right)", (sp.Abs(y) - y) / 2),
    _equation(
        12,
        r"F_x = \frac{\sigma}{L}(1-L)(\cos\theta_o - x) + \alpha x - \mu_o n = 0",
        sigma / L * (1 - L) * (c0 - x) + alpha * x - mu0 * n,
    ),
    _equation(
        13,
        r"F_y = \frac{\sigma}{L}(1-L)(\sin\theta_o - y) + \beta y - n = 0",
        sigma / L * (1 - L) * (s0 - y) + beta * y - n,
    ),
    _equation(
        14,
        r"\sigma(1-L)\cos\theta + \alpha(\cos\theta_o - L\cos\theta) + \mu_o(\sin\theta_o - "
        r"L\sin\theta) = 0",
        sigma * (1 - L) * c + alpha * (c0 - L * c) + mu0 * (s0 - L * s),
    ),
    _equation(
        15,
        r"\sigma(1-L)\sin\theta + \beta(\sin\theta_o - L\sin\theta) + (\sin\theta_o - "
        r"L\sin\theta) = -\kappa",
        sigma * (1 - L) * s + beta * (s0 - L * s) + (s0 - L * s) + kappa,
    ),
    _equation(
        16,
        r"\mathbf{D}\left\{\begin{array}{c}\cos\theta\\\sin\theta\end{array}\right\} = \mathbf{b}",
        _linear,
    ),
    _equation(
        17,
        r"\mathbf{D} = \sigma \mathbf{I} + L \mathbf{A}",
        lambda A: tuple(sigma * sp.eye(2) + L * A),
    ),
    _equation(
        18,
        r"\mathbf{A} = \begin{bmatrix} -(\sigma + \alpha) & -\mu \\ 0 & -(\sigma + \beta + 1) "
        r"\end{bmatrix}",
        (-(sigma + alpha), -mu, sp.S.Zero, -(sigma + beta + 1)),
    ),
    _equation(
        19,
        r"\mathbf{b} = \left\{ \begin{array}{c} -\alpha \cos \theta_o - \mu \sin \theta_o \\ "
        r"-(\beta + 1) \sin \theta_o - \kappa \end{array} \right\}",
        (-alpha * c0 - mu * s0, -(beta + 1) * s0 - kappa),
    ),
    _equation(
        20,
        r"\left\{\begin{array}{c}\cos\theta\\\sin\theta\end{array}\right\}^{T}"
        r"\left\{\begin{array}{c}\cos\theta\\\sin\theta\end{array}\right\} = 1 = "
        r"\mathbf{b}^{T}\left(\mathbf{D}\mathbf{D}^{T}\right)^{-1}\mathbf{b}",
        _unit_norm,
    ),
    _equation(21, r"c_0 + c_1 L + c_2 L^2 + c_3 L^3 + c_4 L^4 = 0", _quartic),
    _equation(
        22,
        r"\widetilde{\mathbf{D}}\left\{\begin{array}{c}\cos\theta\\\sin\theta\end{array}\right\} = "
        r"\widetilde{\mathbf{b}}",
        _linear,
    ),
    _equation(
        23,
        r"\begin{cases} \cos\theta\\ \sin\theta \end{cases}^{T} \begin{cases} \cos\theta\\ "
        r"\sin\theta \end{cases} "
        r"= 1 = \widetilde{\mathbf{b}}^{T} (\widetilde{\mathbf{D}}\widetilde{\mathbf{D}}^{T})^{-1} "
        r"\widetilde{\mathbf{b}}",
        _unit_norm,
    ),
    _equation(
        24,
        r"\widetilde{\mathbf{D}} = \begin{bmatrix} \sigma(1-L) - L\alpha & 0\\ 0 & "
        r"\sigma(1-L) - L\beta "
        r"\end{bmatrix}",
        (sigma * (1 - L) - L * alpha, sp.S.Zero, sp.S.Zero, sigma * (1 - L) - L * beta),
    ),
    _equation(
        25,
        r"\widetilde{\mathbf{b}} = \left\{ \begin{array}{c} -\alpha \cos \theta_o \\ "
        r"-\beta \sin \theta_o - \kappa \end{array} \right\}",
        (-alpha * c0, -beta * s0 - kappa),
    ),
    _equation(26, r"d_0 + d_1 L + d_2 L^2 + d_3 L^3 + d_4 L^4 = 0", _quartic),
    _equation(
        27, r"\det(\lambda^2 \mathbf{I} + \mathbf{K}) = 0", lambda K: (lam**2 * sp.eye(2) + K).det()
    ),
    _equation(
        28,
        r"\mathbf{K} = \begin{bmatrix} \frac{\partial F_x}{\partial x} & \frac{\partial "
        r"F_x}{\partial y} \\ "
        r"\frac{\partial F_y}{\partial x} & \frac{\partial F_y}{\partial y} "
        r"\end{bmatrix}_{equilibriums} = "
        r"\begin{bmatrix} \sigma \left(1 - \frac{\sin^2 \theta_{eq}}{L_{eq}} \right) + \alpha & "
        r"\frac{\sigma}{L_{eq}} \sin \theta_{eq} \cos \theta_{eq} + \mu_0 \overline{n} \\ "
        r"\frac{\sigma}{L_{eq}} \sin \theta_{eq} \cos \theta_{eq} & "
        r"\sigma \left(1 - \frac{\cos^2 \theta_{eq}}{L_{eq}} \right) + \beta + \overline{n} "
        r"\end{bmatrix}",
        (
            sigma * (1 - s**2 / L) + alpha,
            sigma / L * s * c + mu0 * nbar,
            sigma / L * s * c,
            sigma * (1 - c**2 / L) + beta + nbar,
        ),
    ),
    _equation(
        29,
        r"\overline{n} = \begin{cases} 1 , & if \quad n \neq 0 \\ 0 , & if \quad n = 0 \end{cases}",
        (sp.S.One, sp.S.Zero),
    ),
)

APPENDIX = (
    _appendix(
        "A1-c0",
        r"c_0 = \left(b_1^2 + b_2^2\right)\sigma^2 - \sigma^4",
        (b1**2 + b2**2) * sigma**2 - sigma**4,
    ),
    _appendix(
        "A1-d0",
        r"d_0 = \left(b_1^2 + b_2^2\right)\sigma^2 - \sigma^4",
        (b1**2 + b2**2) * sigma**2 - sigma**4,
    ),
    _appendix(
        "A2",
        r"c_{1} = 2b_{1}b_{2}\mu_{o}\sigma + (\sigma^{3} - b_{1}^{2}\sigma)(2 + 2\beta + "
        r"2\sigma) + "
        r"(\sigma^{3} - b_{2}^{2}\sigma)(2\alpha + 2\sigma)",
        2 * b1 * b2 * mu0 * sigma
        + (sigma**3 - b1**2 * sigma) * (2 + 2 * beta + 2 * sigma)
        + (sigma**3 - b2**2 * sigma) * (2 * alpha + 2 * sigma),
    ),
    _appendix(
        "A3",
        r"c_{2} = \mu_{0}^{2}\sigma^{2} - 2b_{1}b_{2}\mu_{0}(1+\beta+\sigma) + "
        r"(b_{1}^{2}-\sigma^{2})(1+\beta+\sigma)^{2} - "
        r"(2+2\beta+2\sigma)\sigma^{2}(2\alpha+2\sigma) + "
        r"(b_{2}^{2}-\sigma^{2})(\mu_{0}^{2}+(\alpha+\sigma)^{2})",
        mu0**2 * sigma**2
        - 2 * b1 * b2 * mu0 * (1 + beta + sigma)
        + (b1**2 - sigma**2) * (1 + beta + sigma) ** 2
        - (2 + 2 * beta + 2 * sigma) * sigma**2 * (2 * alpha + 2 * sigma)
        + (b2**2 - sigma**2) * (mu0**2 + (alpha + sigma) ** 2),
    ),
    _appendix(
        "A4",
        r"c_{3} = -2\mu_{o}^{2}\sigma(1+\beta+\sigma) + "
        r"\sigma(1+\beta+\sigma)^{2}(2\alpha+2\sigma) + "
        r"\sigma(2+2\beta+2\sigma)(\mu_{o}^{2}+(\alpha+\sigma)^{2})",
        -2 * mu0**2 * sigma * (1 + beta + sigma)
        + sigma * (1 + beta + sigma) ** 2 * (2 * alpha + 2 * sigma)
        + sigma * (2 + 2 * beta + 2 * sigma) * (mu0**2 + (alpha + sigma) ** 2),
    ),
    _appendix(
        "A5",
        r"c_4 = -(1+\beta+\sigma)^2(\alpha+\sigma)^2",
        -((1 + beta + sigma) ** 2) * (alpha + sigma) ** 2,
    ),
    _appendix(
        "A6",
        r"d_1 = (\alpha + \sigma) \left(-2b_4^2 \sigma + 2\sigma^3 \right) + "
        r"(\beta + \sigma) \left(-2b_3^2 \sigma + 2\sigma^3 \right)",
        (alpha + sigma) * (-2 * b4**2 * sigma + 2 * sigma**3)
        + (beta + sigma) * (-2 * b3**2 * sigma + 2 * sigma**3),
    ),
    _appendix(
        "A7",
        r"d_2 = \left(b_4^2 - \sigma^2\right)(\alpha + \sigma)^2 - 4\sigma^2(\alpha + "
        r"\sigma)(\beta + \sigma) + "
        r"\left(b_3^2 - \sigma^2\right)(\beta + \sigma)^2",
        (b4**2 - sigma**2) * (alpha + sigma) ** 2
        - 4 * sigma**2 * (alpha + sigma) * (beta + sigma)
        + (b3**2 - sigma**2) * (beta + sigma) ** 2,
    ),
    _appendix(
        "A8",
        r"d_3 = 2\sigma(\alpha + \sigma)^2(\beta + \sigma) + 2\sigma(\alpha + \sigma)(\beta + "
        r"\sigma)^2",
        2 * sigma * (alpha + sigma) ** 2 * (beta + sigma)
        + 2 * sigma * (alpha + sigma) * (beta + sigma) ** 2,
    ),
    _appendix(
        "A9",
        r"d_4 = -(\alpha + \sigma)^2 (\beta + \sigma)^2",
        -((alpha + sigma) ** 2) * (beta + sigma) ** 2,
    ),
    _appendix("A10", r"b_1 = -\alpha \cos \theta_o - \mu_o \sin \theta_o", -alpha * c0 - mu0 * s0),
    _appendix("A11", r"b_2 = -(\beta + 1)\sin\theta_o - \kappa", -(beta + 1) * s0 - kappa),
    _appendix("A12", r"b_3 = -\alpha \cos \theta_o", -alpha * c0),
    _appendix("A13", r"b_4 = -\beta \sin \theta_o - \kappa", -beta * s0 - kappa),
)

DEFINITIONS = (
    # Each as the ratio of what the article writes to the dimensional quantity for which it stands.
    _definition("tau", r"\tau = t \sqrt{k_c/m}", sp.sqrt(k_c / m_mass)),
    _definition("prime", r"(\bullet)' = d(\bullet)/d\tau", sp.S.One),
    _definition("x", r"x \to x/L_o", 1 / L_0),
    _definition("y", r"y \to y/L_o", 1 / L_0),
    _definition("L", r"L \to L/L_o", 1 / L_0),
    _definition("sigma", r"\sigma = k/k_c", k / k_c),
    _definition("alpha", r"\alpha = k_x/k_c", k_x / k_c),
    _definition("beta", r"\beta = k_y/k_c", k_y / k_c),
    _definition("kappa", r"\kappa = F_L/(k_c L_o)", F_L / (k_c * L_0)),
    _definition("n", r"n = N/k_c", N / k_c),
)

PRINTED: tuple[Printed, ...] = (*EQUATIONS, *DEFINITIONS, *APPENDIX)

#: The article's base values (Section 3), exactly.
BASE = {
    mu0: sp.Rational(1, 2),
    kappa: sp.Rational(7, 1000),
    alpha: sp.Rational(7, 1000),
    sigma: sp.Rational(1, 10),
    beta: sp.Integer(0),
}
#: The angle of its Figure 7a, in degrees.
BASE_ANGLE_DEG = 49
