"""Published models of friction-induced vibration, of rotors and of moving strings as pages: each
with a number that its paper prints, or that follows from it in closed form, at random parameters.

Their pages stand in ``validation/papers`` and, of several contacts and with a clock, in
``tests/oracles``.
"""

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles import clocks, contact_pages
from tests.oracles.user_pages import model_of

PAPERS = Path(__file__).parent / "papers"

#: What is computed, and what it is to be.
Pair = tuple[float, float]


def chain_of_blocks(model: Any, rng: np.random.Generator) -> Pair:
    """Blocks that start alike stick and slip as one: period 2 Δ/V + 2 π − 2 atan(Δ/V)."""
    mu_k, fall, V = rng.uniform(0.1, 0.4), rng.uniform(0.1, 0.3), rng.uniform(0.05, 0.3)
    p = model.Parameters(mu_s=mu_k + fall, mu_k=mu_k, kappa=rng.uniform(0.2, 3.0), V=V)
    found = ss.cycle(p, near=(*3 * (mu_k + fall,), *3 * (V,)))
    return found.period, 2 * fall / V + 2 * math.pi - 2 * math.atan(fall / V)


def drum(model: Any, rng: np.random.Generator) -> Pair:
    """Two modes meet at μ = |k₁ − k₂| / (2 √(k₁ k₂))."""
    kappa = rng.uniform(1.1, 2.0)
    known = (kappa - 1) / (2 * math.sqrt(kappa))
    p = model.Parameters(mu0=None, kappa=kappa, f_1=rng.uniform(0.3, 0.6), f_2=1.0)
    found = ss.flutter_onsets(
        p, vary="mu0", between={"mu0": (0.5 * known, 1.5 * known)}, damping=False
    )
    value = found["mu0"][found["touching"] == "first, second"]
    return float(value[0]) if len(value) == 1 else math.nan, known


def disc_between_pads(model: Any, rng: np.random.Generator) -> Pair:
    """Two modes meet at μ = |(k_y + 2 k_c)/m − k_t/J| √(m J) / (4 √(N₀ (h k_c − N₀)))."""
    beta, tau, iota, kappa = (
        rng.uniform(*ends) for ends in ((0, 1), (0.5, 1), (0.3, 0.6), (0.1, 0.4))
    )
    known = abs(beta + 2 - tau / iota) * math.sqrt(iota) / (4 * math.sqrt(kappa * (1 - kappa)))
    p = model.Parameters(mu0=None, beta=beta, tau=tau, iota=iota, kappa=kappa)
    between = {"mu0": (0.5 * known, 1.5 * known)}
    found = ss.flutter_onsets(p, vary="mu0", between=between, damping=False)
    value = found["mu0"][(found["touching"] == "upper, lower") & (np.abs(found["y"]) < 1e-9)]
    return float(value[0]) if len(value) == 1 else math.nan, known


def rotating_shaft(model: Any, rng: np.random.Generator) -> Pair:
    """Between the two critical speeds it diverges: the largest λ of λ⁴ + (k_x + k_y + 2 Ω²) λ² +
    (k_x − Ω²)(k_y − Ω²) = 0.
    """
    kappa = rng.uniform(1.5, 4.0)
    W = rng.uniform(1.05, 0.95 * math.sqrt(kappa))
    state = ss.equilibria(model.Parameters(kappa=kappa, W=W))
    half, rest = (1 + kappa) / 2 + W**2, (1 - W**2) * (kappa - W**2)
    return float(state.growth[0]), math.sqrt(-rest / (half + math.sqrt(half**2 - rest)))


def rotating_saddle(model: Any, rng: np.random.Generator) -> Pair:
    """Stable without damping from Ω = √k on, up to where n allows; unstable by any damper."""
    n, W = rng.uniform(0.2, 0.9), rng.uniform(1.05, 2.0)
    alone = ss.equilibria(model.Parameters(fall=n, W=W))
    damped = ss.equilibria(model.Parameters(fall=n, W=W, zeta=rng.uniform(0.01, 0.3)))
    slower = ss.equilibria(model.Parameters(fall=n, W=rng.uniform(0.1, 0.95)))
    told = [str(one["stability"][0]) for one in (alone, damped, slower)]
    return float(told == ["neutral", "unstable", "unstable"]), 1.0


def rotating_damping(model: Any, rng: np.random.Generator) -> Pair:
    """It whirls from Ω = √(k/m) (1 + c_e/c_i) on."""
    inner, outer = rng.uniform(0.05, 0.4, 2)
    known = 1 + outer / inner
    p = model.Parameters(zeta_i=inner, zeta_e=outer, W=None)
    found = ss.flutter_onsets(p, vary="W", between={"W": (0.5, 1.5 * known)})
    return float(found["W"][0]) if len(found) == 1 else math.nan, known


def travelling_string(model: Any, rng: np.random.Generator) -> Pair:
    """At the speed of its waves it is at rest in any shape of its modes, and below it is neutral
    with the lower of the two frequencies of q₁″ − 16/3 v q₂′ + π² (1 − v²) q₁ = 0, q₂″ + 16/3 v q₁′
    + 4 π² (1 − v²) q₂ = 0.
    """
    v = rng.uniform(0.1, 0.9)
    state = ss.equilibria(model.Parameters(v=v))
    whole = np.asarray(state.damped_eigenvalues)
    stiff = math.pi**2 * (1 - v**2)
    half = (5 * stiff + (16 / 3 * v) ** 2) / 2
    lowest = math.sqrt(half - math.sqrt(half**2 - 4 * stiff**2))
    return float(np.abs(whole.imag).min()), lowest


def blocks(model: Any, rng: np.random.Generator) -> Pair:
    """U. Galvanetto and S. R. Bishop, Dynamics of a simple damped oscillator undergoing stick-slip
    vibrations, Meccanica 34 (1999) 337-347: two blocks at rest stick up to x₁ = (K₂₂ f₁ + κ f₂) /
    det K.
    """
    beta, kappa, N_1, N_2 = rng.uniform(0.5, 2.0, 4)
    p = model.Parameters(beta=beta, kappa=kappa, N_1=N_1, N_2=N_2, mu_s=0.6, V=0.0)
    own, other = beta + kappa, beta + kappa + beta * kappa
    return float(ss.sticking_states(p)["x_1_high"][0]), 0.6 * (own * N_1 + kappa * N_2) / other


def two_legs(model: Any, rng: np.random.Generator) -> Pair:
    """A pad on two legs lifts the rear one at μ = (2 k_c a² + k_t) / (2 k_c a h)."""
    k_t, h = rng.uniform(0.05, 1.0), rng.uniform(0.5, 1.5)
    known = (2 + k_t) / (2 * h)
    p = model.Parameters(mu0=None, k_t=k_t, h=h)
    found = ss.folds(p, vary="mu0", between={"mu0": (0.5 * known, 1.2 * known)})
    lifts = found["mu0"][found.kind == "passes"]
    return float(lifts[0]) if len(lifts) == 1 else math.nan, known


def shoes(model: Any, rng: np.random.Generator) -> Pair:
    """The normal force of a leading shoe is F l / (b − μ c)."""
    F, arm, b, c = (rng.uniform(*ends) for ends in ((0.01, 0.1), (1, 2), (0.5, 1), (0.5, 1)))
    mu = rng.uniform(0.1, 0.95) * b / c
    eq = ss.equilibria(model.Parameters(F=F, l=arm, b=b, c=c, mu0=mu))
    return float(eq["contact_force_leading"][0]), F * arm / (b - mu * c)


def ladder(model: Any, rng: np.random.Generator) -> Pair:
    """A ladder between a floor and a wall that slide stands at tan α = (1 − μ ν) / (2 μ)."""
    mu, nu = rng.uniform(0.1, 1.0), rng.uniform(0.0, 0.9)
    within = {"alpha": (0.01, 1.56), "x": (-3.0, 3.0), "y": (-3.0, 3.0)}
    eq = ss.equilibria(model.Parameters(mu0=mu, nu=nu), within=within)
    return math.tan(eq["alpha"][0]), (1 - mu * nu) / (2 * mu)


def between_pads(model: Any, rng: np.random.Generator) -> Pair:
    """A mass pressed by δ into both pads in the middle, of the speed v₀ there: period 4 [asin(δ √2
    / v₀) / √2 + atan(v₁ / 2 δ)], v₁² = v₀² − 2 δ²; nothing damps, and v₀ is that of the orbit
    found, by its energy.
    """
    depth = rng.uniform(0.05, 0.2)
    start = rng.uniform(1.1, 4.0) * depth * math.sqrt(2)
    found = ss.cycle(model.Parameters(d=depth), near=(0.0, start))
    v_0 = math.sqrt((found.state[0] + depth) ** 2 - 2 * depth**2)
    v_1 = math.sqrt(v_0**2 - 2 * depth**2)
    inside = math.asin(depth * math.sqrt(2) / v_0) / math.sqrt(2)
    return found.period, 4 * (inside + math.atan(v_1 / (2 * depth)))


def forced_friction(model: Any, rng: np.random.Generator) -> Pair:
    """J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Transactions
    of the ASME 53 (1931) 107-115: the amplitude where nothing sticks, √(1/(1 − ω²)² − (F S)²), S =
    sin(π/ω) / (ω (1 + cos(π/ω))).
    """
    omega, f = rng.uniform(1.4, 2.5), rng.uniform(0.4, 0.9)
    found = ss.cycle(model.Parameters(omega=omega, f=f), turns=1)
    slowed = math.sin(math.pi / omega) / (omega * (1 + math.cos(math.pi / omega)))
    return found.amplitude, math.sqrt(1 / (1 - omega**2) ** 2 - (0.4 * f * slowed) ** 2)


def page(name: str) -> str:
    """The page of a paper."""
    return (PAPERS / name / "page.py").read_text(encoding="utf-8")


#: Each check with its page.
MODELS: tuple[tuple[Callable[[Any, np.random.Generator], Pair], str], ...] = (
    *(
        (check, page(check.__name__))
        for check in (
            chain_of_blocks,
            drum,
            disc_between_pads,
            rotating_shaft,
            rotating_saddle,
            rotating_damping,
            travelling_string,
        )
    ),
    (blocks, contact_pages.BLOCKS),
    (two_legs, contact_pages.PAD),
    (shoes, contact_pages.SHOES),
    (ladder, contact_pages.LADDER),
    (between_pads, contact_pages.PADS),
    (forced_friction, clocks.FRICTION),
)

CASES = 20 * len(MODELS)

#: Relative error of a number that is one.
SMALL = 1e-9


@cache
def derived(number: int) -> Any:
    """A model, derived once."""
    check, text = MODELS[number]
    return model_of(text, check.__name__)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One number of one model."""
    which = number % len(MODELS)
    check = MODELS[which][0]
    found, known = check(derived(which), rng)
    off = abs(found / known - 1)
    wrong = [] if off < SMALL else [f"{check.__name__}: {found:.12g} where {known:.12g} is known"]
    return {"kind": check.__name__, "wrong": wrong, "off": off}
