"""What :mod:`benchmarks.bench_before` asks of a tree besides the equilibria of many points: the name of each question, and its call.

It is loaded beside the package of either tree and needs nothing else. Where another commit spells a question otherwise, its call
looks which is meant; a call that raises is a question that the tree doesn't know.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

Call = Callable[[], Any]
#: Of the random points, as many are taken for what is asked of one point at a time, and for what takes arrays.
FEW, SOME = 30, 300
#: Name → what a fresh interpreter runs, whose own start is not counted.
STARTS = {
    "import spragsym": "import spragsym",
    "import and first equilibria": "import spragsym as ss; ss.equilibria(ss.Parameters.article(theta0=1.0))",
    "import and first folds and cusps": "import spragsym as ss; p = ss.Parameters.article(); ss.folds(p); ss.cusps(p)",
    "import and first jump value": "import spragsym as ss; ss.jump_value(ss.Parameters.article(theta0=1.0), 'mu0')",
    "import and first motion": "import spragsym as ss; ss.simulate(ss.Parameters.article(theta0=1.0), V=0.5, d=10.0, t_end=10.0)",
    "command --version": "from spragsym.cli import main; main(['--version'])",
    "command --help": "from spragsym.cli import main; main(['--help'])",
    "command equilibria": "from spragsym.cli import main; main(['equilibria', '--theta0', '49'])",
}


def questions(ss: Any, points: Any) -> dict[str, Call]:
    """Name → call; ``points`` holds the six parameters of random points, one a column."""
    one, many = ss.Parameters.article(theta0=np.radians(49.0)), ss.Parameters(*points)
    some = ss.Parameters(*points[:, :SOME])
    few = [ss.Parameters(*map(float, point)) for point in points[:, :FEW].T]
    return {
        "equilibria of one point, numpy": _on(ss, lambda: ss.equilibria(one), "numpy", 1),
        "equilibria of one point, compiled": _on(ss, lambda: ss.equilibria(one), "compiled", 1),
        "count, numpy": _on(ss, lambda: ss.count(many), "numpy", 1),
        "count, compiled": _on(ss, lambda: ss.count(many), "compiled", 1),
        **{name: _on(ss, call, "auto") for name, call in (_statics(ss, one, some, few) | _motions(ss, one)).items()},
    }


def _statics(ss: Any, one: Any, some: Any, few: list[Any]) -> dict[str, Call]:
    """Folds, cusps, onsets, paths and jumps."""
    up, flutters = np.linspace(0.01, 3.0, 500), ss.Parameters.article(sigma=1.0, mu0=1.5)
    cusp = getattr(
        ss, "cusp_friction", ss.critical_friction
    )  # what the critical friction was, before folds below cusps were known
    return {
        "folds along theta0": lambda: ss.folds(one, "theta0"),
        "folds along mu0": lambda: ss.folds(one, "mu0"),
        f"folds along theta0, {FEW} points": lambda: [ss.folds(p, "theta0") for p in few],
        f"folds along mu0, {FEW} points": lambda: [ss.folds(p, "mu0") for p in few],
        "cusps": lambda: ss.cusps(one),
        f"cusps, {FEW} points": lambda: [ss.cusps(p) for p in few],
        "flutter_onsets": lambda: _undamped_onsets(ss, flutters),
        f"flutter_onsets, {FEW} points": lambda: [_undamped_onsets(ss, p) for p in few],
        "bifurcation_set": lambda: ss.bifurcation_set(one),
        "quasi_static_path along theta0": lambda: ss.quasi_static_path(one, "theta0", up),
        "quasi_static_path along mu0": lambda: ss.quasi_static_path(one, "mu0", np.linspace(0.0, 1.0, 500)),
        "jump_value along mu0": lambda: ss.jump_value(one, "mu0"),
        "jump_value along theta0": lambda: ss.jump_value(one, "theta0"),
        f"jump_value along mu0, {SOME} points": lambda: ss.jump_value(some, "mu0"),
        f"jump_value along theta0, {SOME} points": lambda: ss.jump_value(some, "theta0"),
        "friction of the lowest cusp": lambda: cusp(one),
        f"friction of the lowest cusp, {SOME} points": lambda: cusp(some),
        "critical_friction": lambda: ss.critical_friction(one),
        f"critical_friction, {SOME} points": lambda: ss.critical_friction(some),
        **_designs(ss, one.replace(theta0=0.7, mu0=0.5), ""),
        **_designs(ss.load("cubic_contact"), ss.load("cubic_contact").Parameters(theta0=0.7, mu0=0.5), " of cubic_contact"),
    }


def _designs(asked: Any, p: Any, whose: str) -> dict[str, Call]:
    """How far a design is from a jump, and what to change; asked of the package, or of a model that is searched."""
    scale = {"theta0": 0.02, "mu0": 0.05, "sigma": 0.01, "kappa": 0.001}
    return {
        f"jump_margin{whose}": lambda: asked.jump_margin(p, scale),
        f"redesign{whose}": lambda: asked.redesign(p, ("theta0", "sigma"), {"mu0": 0.7}),
    }


def _motions(ss: Any, one: Any) -> dict[str, Call]:
    """Motions and sweeps of them; the integrator is the default one where none is named."""
    law = {"V": 0.5, "d": 10.0}
    angles = ss.Parameters.article(theta0=np.radians(np.linspace(5.0, 175.0, 35)))

    def sweep(**options: Any) -> Call:
        return lambda: ss.rms_sweep(angles, **law, t_end=500.0, **options)

    return {
        "simulate": lambda: ss.simulate(one, **law),
        "simulate, compiled": lambda: ss.simulate(one, **law, backend="compiled"),
        "simulate, scipy": lambda: ss.simulate(one, **law, t_end=100.0, backend="scipy"),
        "simulate to a time of 10": lambda: ss.simulate(one, **law, t_end=10.0),
        "rms_sweep": sweep(),
        "rms_sweep, compiled": sweep(backend="compiled"),
        "rms_sweep, 2 workers": sweep(workers=2),
    }


def _on(ss: Any, call: Call, *backend: Any) -> Call:
    """A call with a backend that solves for equilibria."""

    def asked() -> Any:
        ss.set_backend(*backend)
        return call()

    return asked


def _undamped_onsets(ss: Any, p: Any) -> Any:
    """The onsets by (27); the slope of the friction law is taken in unless told otherwise, once it could be."""
    try:
        return ss.flutter_onsets(p, damping=False)
    except TypeError:
        return ss.flutter_onsets(p)
