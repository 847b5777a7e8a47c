"""Published models of friction-induced vibration, of rotors, of moving strings and of forced
oscillators as pages: each with numbers that its paper prints, that follow from it in closed form,
or that a driver of its own finds, at random parameters.

Of each the largest error is told beside the bound that it must keep. Their pages stand in
``validation/papers`` and, of several contacts and with a clock, in ``tests/oracles``.
"""

import math
from collections.abc import Callable
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles import clocks, contact_pages, turning_frames, two_blocks
from tests.oracles.user_pages import model_of, shipped_page

PAPERS = Path(__file__).parent / "papers"

#: What is computed, and what it is to be: numbers of one size.
Pair = tuple[Any, Any]


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


def blocks_at_rest(model: Any, rng: np.random.Generator) -> Pair:
    """U. Galvanetto and S. R. Bishop, Dynamics of a simple damped oscillator undergoing stick-slip
    vibrations, Meccanica 34 (1999) 337-347: two blocks at rest stick up to x₁ = (K₂₂ f₁ + κ f₂) /
    det K, x₂ = (κ f₁ + K₁₁ f₂) / det K, within an area of 4 f₁ f₂ / det K.
    """
    beta, kappa, N_1, N_2 = rng.uniform(0.5, 2.0, 4)
    p = model.Parameters(beta=beta, kappa=kappa, N_1=N_1, N_2=N_2, mu_s=0.6, V=0.0)
    K = np.array([[1 + kappa, -kappa], [-kappa, beta + kappa]])
    f = 0.6 * np.array([N_1, N_2])
    most = np.abs(np.linalg.inv(K)) @ f
    found = ss.sticking_states(p)
    names = ("x_1_high", "x_2_high", "x_1_low", "x_2_low", "measure")
    area = 4 * f.prod() / np.linalg.det(K)
    return [found[name][0] for name in names], [*most, *-most, area]


def blocks_alike(model: Any, rng: np.random.Generator) -> Pair:
    """Identical blocks slip at one instant and stick at one instant, as the closed form says."""
    values, slips, sticks = two_blocks.alike(rng)
    V = values["V"]
    tr = ss.simulate(model.Parameters(**values), vx_10=V, vx_20=V, t_end=slips[-1] + 1e-6)
    found = [
        tr.events.of(kind).on(name).t for kind in ("slip", "stick") for name in ("first", "second")
    ]
    return np.concatenate(found), np.concatenate([slips, slips, sticks, sticks])


def blocks_driven(model: Any, rng: np.random.Generator) -> Pair:
    """Event times of two blocks, and their state at the end, against another driver."""
    values, start = two_blocks.drawn(int(rng.integers(1 << 30)))
    driver = two_blocks.Driver(values)
    end = driver.run(start, 20.0)
    tr = ss.simulate(model.Parameters(**values), start=start, t_end=20.0, rtol=1e-13)
    return [*tr.events.t, *tr.state[:, -1]], [*(t for t, *_ in driver.events), *end]


def leg_that_lifts(model: Any, rng: np.random.Generator) -> Pair:
    """A pad on two legs lifts the rear one at μ = (2 k_c a² + k_t) / (2 k_c a h) and passes, its
    depth then half the load's; without the torsion spring nothing goes on at a/h.
    """
    k_t, h = rng.uniform(0.05, 1.0), rng.uniform(0.5, 1.5)
    found, known = [], []
    for torsion, kind in ((k_t, "passes"), (0.0, "border_fold")):
        lifts = (2 + torsion) / (2 * h)
        p = model.Parameters(mu0=None, tau=torsion, eta=h)
        at = ss.folds(p, vary="mu0", between={"mu0": (0.5 * lifts, 1.2 * lifts)})
        rear = (at.kind == kind) & (at["at_border"] == "rear")
        found += [*at["mu0"][rear], *at["y"][rear]]
        known += [lifts, -0.025]
    return found, known


def legs(model: Any, rng: np.random.Generator) -> Pair:
    """Every equilibrium of a pad on legs: one linear system for each combination of touches."""
    values = {
        name: float(rng.uniform(*ends))
        for name, ends in contact_pages.RANGES.items()
        if name in model.parameters
    }
    names = tuple(entry["name"] for entry in model.contacts)
    eq = ss.equilibria(model.Parameters(**values))
    found = {
        eq["touching"][slot]: [eq[name][slot] for name in model.coordinates]
        for slot in range(int(eq.count))
    }
    known = {
        ", ".join(touching): q
        for touching, q in contact_pages.balanced(*contact_pages.pad(values, names))
        if touching
    }
    return np.ravel([found[some] for some in sorted(found)]), np.ravel(
        [known[some] for some in sorted(known)]
    )


def shoes(model: Any, rng: np.random.Generator) -> Pair:
    """Normal forces of a leading and a trailing shoe are F l / (b ∓ μ c); beyond b/c it locks."""
    F, arm, b, c = (rng.uniform(*ends) for ends in ((0.01, 0.1), (1, 2), (0.5, 1), (0.5, 1)))
    mu = rng.uniform(0.1, 0.95) * b / c
    p = model.Parameters(F=F, l=arm, b=b, c=c, mu0=mu)
    eq = ss.equilibria(p)
    forces = [eq[f"contact_force_{name}"][0] for name in ("leading", "trailing")]
    counts = [ss.count(p.replace(mu0=side * b / c)).item() for side in (1 - 1e-9, 1 + 1e-9)]
    return [*forces, *counts], [F * arm / (b - mu * c), F * arm / (b + mu * c), 1, 0]


def shoe_on_a_spring(model: Any, rng: np.random.Generator) -> Pair:
    """A leading shoe against a spring comes off at P = 0: it passes up to where it locks, at μ =
    (k + k_c b²)/(k_c b c), beyond which the load is at its largest there.
    """
    b, c, k = rng.uniform(0.4, 1.0, 3)
    found = []
    for side, kind in ((0.9, "passes"), (1.1, "border_fold")):
        p = model.Parameters(b=b, c=c, k=k, mu0=side * (k + b * b) / (b * c))
        at = ss.folds(p, vary="P", between={"P": (-1.0, 1.0)})
        found += [*at["P"][(at.kind == kind) & (at["at_border"] == "leading")] + 1]
    return found, [1.0, 1.0]


def ladder(model: Any, rng: np.random.Generator) -> Pair:
    """A ladder between a floor and a wall that slide stands at tan α = (1 − μ ν) / (2 μ)."""
    mu, nu = rng.uniform(0.1, 1.0), rng.uniform(0.0, 0.9)
    within = {"alpha": (0.01, 1.56), "x": (-3.0, 3.0), "y": (-3.0, 3.0)}
    eq = ss.equilibria(model.Parameters(mu0=mu, nu=nu), within=within)
    return eq["alpha"][0], math.atan((1 - mu * nu) / (2 * mu))


def between_pads(model: Any, rng: np.random.Generator) -> Pair:
    """A mass pressed by δ into both pads in the middle, of the speed v₀ there, leaves one at
    asin(δ √2 / v₀) / √2 and is back after 2 atan(v₁ / 2 δ), v₁² = v₀² − 2 δ²; four and two of these
    are the period. Nothing damps, and v₀ of the orbit found is that of its energy.
    """

    def pieces(v_0: float) -> tuple[float, float]:
        """The quarter within both, and the half beyond one."""
        v_1 = math.sqrt(v_0**2 - 2 * depth**2)
        return math.asin(depth * math.sqrt(2) / v_0) / math.sqrt(2), 2 * math.atan(v_1 / 2 / depth)

    depth = rng.uniform(0.05, 0.2)
    start = rng.uniform(1.1, 4.0) * depth * math.sqrt(2)
    p = model.Parameters(d=depth)
    within, beyond = pieces(start)
    times = within + np.cumsum([0.0, beyond, *3 * (2 * within, beyond)])
    tr = ss.simulate(p, vx0=start, t_end=times[-1] + within / 2)
    orbit = ss.cycle(p, near=(0.0, start))
    within, beyond = pieces(math.sqrt((orbit.state[0] + depth) ** 2 - 2 * depth**2))
    return [*tr.events.t, orbit.period], [*times, 4 * within + 2 * beyond]


def forced_friction(model: Any, rng: np.random.Generator) -> Pair:
    """J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Transactions
    of the ASME 53 (1931) 107-115: the amplitude where nothing sticks, √(1/(1 − ω²)² − (F S)²), S =
    sin(π/ω) / (ω (1 + cos(π/ω))).
    """
    omega, f = rng.uniform(1.4, 2.5), rng.uniform(0.4, 0.9)
    found = ss.cycle(model.Parameters(omega=omega, f=f), turns=1)
    slowed = math.sin(math.pi / omega) / (omega * (1 + math.cos(math.pi / omega)))
    return found.amplitude, math.sqrt(1 / (1 - omega**2) ** 2 - (0.4 * f * slowed) ** 2)


def forced_stops(model: Any, rng: np.random.Generator) -> Pair:
    """Den Hartog's, where it stops at both turns: its amplitude, put together from its pieces."""
    omega, force = rng.uniform(0.3, 0.36), rng.uniform(0.17, 0.25)
    found = ss.cycle(model.Parameters(omega=omega, f=force, mu=1.0), turns=1)
    near = (0.98 * found.amplitude, 0.3 * found.period)
    return found.amplitude, clocks.stopping_amplitude(omega, force, near)


def forced_linear(model: Any, rng: np.random.Generator) -> Pair:
    """The linear response: amplitude 1/√((1 − ω²)² + (c ω)²)."""
    c, omega = rng.uniform(0.05, 0.5), rng.uniform(0.3, 3.0)
    found = ss.cycle(model.Parameters(c=c, g=0.0, omega=omega), turns=1)
    return found.amplitude, 1 / math.hypot(1 - omega**2, c * omega)


def forced_hardening(model: Any, rng: np.random.Generator) -> Pair:
    """G. Duffing, Erzwungene Schwingungen bei veränderlicher Eigenfrequenz, Vieweg 1918: the two
    folds of the resonance, by shooting.
    """
    c, g = rng.uniform(0.08, 0.12), rng.uniform(0.04, 0.1)
    p = model.Parameters(omega=0.9, c=c, g=g)
    branch = ss.cycle_branch(ss.cycle(p, turns=1), "omega", between={"omega": (0.8, 2.6)})
    folds = branch.of("fold")
    known = [clocks.duffing_fold(c, g, fold.cycle, fold.value) for fold in folds]
    return [fold.value for fold in folds], known if len(known) == 2 else [math.nan] * 2


def forced_against_a_stop(model: Any, rng: np.random.Generator) -> Pair:
    """S. W. Shaw and P. J. Holmes, A periodically forced piecewise linear oscillator, Journal of
    Sound and Vibration 90 (1983) 129-155: resonance with a stop, cycles that close by their pieces.
    """
    ends = {"omega": (0.5, 2.0), "c": (0.1, 0.5), "d": (-0.3, 0.8), "k_c": (1.0, 10.0)}
    values = {name: float(rng.uniform(*some)) for name, some in ends.items()}
    p = model.Parameters(**values)
    try:
        found = ss.cycle(p, turns=1)
    except ss.errors.ConvergenceError:  # the motion has doubled its period
        found = ss.cycle(p, turns=2)
    x, phase, v, omega = found.state
    begin = phase / omega
    return [x, v], clocks.stopped(values, x, v, begin, begin + found.period)


def quadratic_pencil(model: Any, rng: np.random.Generator) -> Pair:
    """Eigenvalues at 25 sets, with and without damping, against SciPy's of the companion matrices:
    their symmetric functions, since two that nearly meet are known to half of the digits.
    """
    sets = turning_frames.drawn(model, 25, rng, still="g" * ("k_x" in model.parameters))
    matrices = turning_frames.of_rotor if "k_x" in model.parameters else turning_frames.of_gyrostat
    eq = ss.equilibria(model.Parameters(**sets), within=dict.fromkeys(model.coordinates, (-1, 1)))
    found, known = [], []
    for row, (M, C, G, K) in enumerate(zip(*matrices(sets), strict=True)):
        for got, B in ((eq.damped_eigenvalues, C + G), (eq.eigenvalues, G)):
            exact = turning_frames.polyeig(M, B, K)
            size = np.abs(exact).max()
            found.append(np.poly(got[row, 0] / size))
            known.append(np.poly(exact / size))
    return np.array(found), np.array(known)


def page(name: str) -> str:
    """The page of a paper."""
    return (PAPERS / name / "page.py").read_text(encoding="utf-8")


#: Relative errors of states, thresholds, and places where something changes; and of motions.
STATIC = 1e-12
MOVING = 1e-9

#: Each reference: its check, page, and the largest relative error that it may have.
MODELS: dict[str, tuple[Callable[[Any, np.random.Generator], Pair], str, float]] = {
    "chain_of_blocks": (chain_of_blocks, page("chain_of_blocks"), MOVING),
    "drum": (drum, page("drum"), STATIC),
    "disc_between_pads": (disc_between_pads, shipped_page("disc_between_pads"), STATIC),
    "rotating_shaft": (rotating_shaft, page("rotating_shaft"), STATIC),
    "rotating_saddle": (rotating_saddle, page("rotating_saddle"), STATIC),
    "rotating_damping": (rotating_damping, page("rotating_damping"), STATIC),
    "travelling_string": (travelling_string, page("travelling_string"), STATIC),
    "rotor": (quadratic_pencil, turning_frames.ROTOR, STATIC),
    "gyrostat": (quadratic_pencil, turning_frames.GYROSTAT, STATIC),
    "blocks_at_rest": (blocks_at_rest, contact_pages.BLOCKS, STATIC),
    "blocks_alike": (blocks_alike, contact_pages.BLOCKS, MOVING),
    "blocks_driven": (blocks_driven, contact_pages.BLOCKS, MOVING),
    "leg_that_lifts": (leg_that_lifts, shipped_page("pad_on_legs"), STATIC),
    "two_legs": (legs, contact_pages.PAD, STATIC),
    "three_legs": (legs, contact_pages.THREE, STATIC),
    "legs_and_stop": (legs, contact_pages.FOUR, STATIC),
    "shoes": (shoes, contact_pages.SHOES, STATIC),
    "shoe_on_a_spring": (shoe_on_a_spring, contact_pages.SPRUNG, STATIC),
    "ladder": (ladder, contact_pages.LADDER, STATIC),
    "between_pads": (between_pads, contact_pages.PADS, MOVING),
    "forced_friction": (forced_friction, clocks.FRICTION, MOVING),
    "forced_stops": (forced_stops, clocks.FRICTION, MOVING),
    "forced_linear": (forced_linear, clocks.DUFFING, MOVING),
    "forced_hardening": (forced_hardening, clocks.DUFFING, MOVING),
    "forced_against_a_stop": (forced_against_a_stop, page("forced_stop"), MOVING),
}

CASES = 20 * len(MODELS)


@cache
def derived(name: str) -> Any:
    """A model, derived once."""
    return model_of(MODELS[name][1], name)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """The numbers of one reference at one set of parameters."""
    name = list(MODELS)[number % len(MODELS)]
    check, _, bound = MODELS[name]
    found, known = map(np.asarray, check(derived(name), rng))
    off = math.nan
    if found.shape == known.shape:
        off = float(np.abs(found - known).max() / np.abs(known).max())
    wrong = [] if off <= bound else [f"{name}: {found} where {known} is known"]
    return {"kind": name, "wrong": wrong, "off": off, "bound": bound}
