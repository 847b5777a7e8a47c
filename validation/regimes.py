"""What motions come to, judged early and late; a Markdown table.

``python -m validation.regimes [N] [SEED] [LATE]``: N random motions, judged by their last quarter at τ = 2000. Those of
which a limit is told are run on to LATE, by default 4·10⁴, and judged there again: a verdict is refuted when the late one is of
another limit, or of none. Each of those is printed below the table, with its inputs.
"""

from __future__ import annotations

import sys
from typing import NamedTuple, TypeAlias

import numpy as np

import spragsym as ss
from spragsym.dynamics import regimes
from spragsym.dynamics.regimes import Outcome, Regime
from spragsym.sweeps import Sweep, rms_sweep

#: Where the first verdict is given, and the windows of the two: the late one is wide enough for decays that take a million.
EARLY, WINDOW, LATE_WINDOW = 2000.0, 500.0, 4000.0

#: Arrays of one length by the names of the arguments.
Inputs: TypeAlias = dict[str, np.ndarray]


def main(count: int = 200, seed: int = 20, late_end: float = 4e4) -> int:
    """Print the table; exit code 1 if a verdict is refuted."""
    found = compared(random_motions(np.random.default_rng(seed), count), late_end)
    print(f"| at τ = {EARLY:g} | motions | confirmed at {late_end:g} | refuted |\n|---|---|---|---|")
    for regime in Regime:
        told = [one for one in found if one.early.regime == regime]
        if told:
            judged_late = [one for one in told if one.late is not None]
            refuted = sum(not one.holds for one in judged_late)
            counts = f"{len(judged_late) - refuted} | {refuted}" if judged_late else "– | –"
            print(f"| {regime.name} | {len(told)} | {counts} |")
    wrong = [one for one in found if not one.holds]
    for one in wrong:
        print(f"\nrefuted: {one.early}\nby: {one.late}\nwith: {one.inputs}")
    return int(bool(wrong))


class Compared(NamedTuple):
    """One motion: its inputs, and what is said of it early and late; late only where a limit was told early."""

    inputs: dict[str, float]
    early: Outcome
    late: Outcome | None

    @property
    def holds(self) -> bool:
        """Whether what was said early is not refuted late."""
        return self.late is None or same_limit(self.early, self.late)


def compared(inputs: Inputs, late_end: float = 4e4) -> list[Compared]:
    """Every motion judged at EARLY, and those of which a limit is told judged again at ``late_end``."""
    early = judged(inputs, EARLY, WINDOW)
    told = np.flatnonzero(~np.isin(early.regime, (Regime.UNSETTLED, Regime.FAILED)))
    late = judged({name: values[told] for name, values in inputs.items()}, late_end, LATE_WINDOW)
    outcomes = dict(zip(told.tolist(), (late.outcome(k) for k in range(len(told))), strict=True))
    return [
        Compared({name: float(values[i]) for name, values in inputs.items()}, early.outcome(i), outcomes.get(i))
        for i in range(len(early.regime))
    ]


def random_motions(rng: np.random.Generator, count: int) -> Inputs:
    """Parameters about the article's, belts over a decade, starts about rest; β = 0 in half of them."""
    return {
        "theta0": rng.uniform(0.2, 2.9, count), "mu0": rng.uniform(0.0, 1.0, count),
        "kappa": 0.007 * 10 ** rng.uniform(-0.7, 0.7, count), "alpha": 0.007 * 10 ** rng.uniform(-0.7, 0.7, count),
        "sigma": 0.1 * 10 ** rng.uniform(-0.5, 0.5, count), "beta": rng.choice([0.0, 0.05], count) * rng.uniform(0, 1, count),
        "V": rng.uniform(0.05, 1.0, count), "d": 10 ** rng.uniform(0.3, 1.3, count),
        "x0": rng.normal(0, 0.2, count), "vx0": rng.normal(0, 0.1, count), "vy0": rng.normal(0, 0.02, count),
    }  # fmt: skip


def judged(inputs: Inputs, end: float, window: float) -> Sweep:
    """All motions, looked at over a window before ``end``."""
    parameters = {name: inputs[name] for name in ("theta0", "mu0", "kappa", "alpha", "sigma", "beta")}
    rest = {name: values for name, values in inputs.items() if name not in parameters}
    return rms_sweep(ss.Parameters(**parameters), **rest, t_end=end, transient=end - window)


def same_limit(early: Outcome, late: Outcome) -> bool:
    """Whether both are of one equilibrium, one cycle, or lift-off."""
    return early.equilibrium == late.equilibrium and regimes.same_limit(early, late, ())


if __name__ == "__main__":
    sys.exit(main(*(int(float(argument)) for argument in sys.argv[1:4])))
