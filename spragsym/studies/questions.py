"""What is asked of a model about tolerances and changes of a brake: by closed forms of the article's, by tubes of any other."""

from __future__ import annotations

import inspect
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial

import numpy as np

from ..design.design_space import PHYSICAL, Design, dimensionless, space
from ..errors import ParameterError
from ..kang_nam.design import jump_margin, redesign
from ..kang_nam.design.events import have_jumped
from ..kang_nam.design.jump_values import first_jumps
from ..models.balance import Balance
from ..models.load import load
from ..models.points import ranges
from ..models.redesigns import reaching
from ..parameters import FloatArray, Parameters, PhysicalParameters
from . import brake_quantities, tube_tolerances
from .study import Study
from .tolerances import BoxCertificate, Chance, Jumping, brakes, certificate, chance, jumping, values_at

#: What may be changed of the article's brake, one at a time.
SINGLE = ("theta0", "k", "k_x", "k_y", "k_c", "F_L", "L_0")
#: Slices of a certificate, and boxes of each: where few do not decide, a design a little further off is proved sooner.
_SLICES, _BOXES = (1, 4, 16), 120
#: Boxes of a certificate by tubes, which take longer, points at which it is refuted, and changes that get one.
_FEW_BOXES, _FEW_POINTS, _MOST = 3000, 64, 4


@dataclass(frozen=True)
class Questions:
    """What is asked of a model, of brakes by the values of their quantities in SI.

    ``certificate`` is the claim that no brake within the tolerances jumps, ``chance`` how probable a jump is from that many
    samples, ``samples`` if not said otherwise, and ``distance`` the nearest jump in tolerances, at the friction that works,
    NaN where that is not asked. Up to the friction ``top`` a jump is looked for. ``names`` are the quantities that may be
    changed one at a time; ``inside(name, low, high)`` whether all between two ends are quantities. ``rows(study, shares)``
    are brakes of the tolerances, and ``ending(study, rows, friction)`` is 1 for those that jump at a friction or below it,
    the own one of each where it is None, 0 for those that don't, and NaN where that is not known; ``jumping`` the same of
    shares. ``outcome`` is that of a hasty certificate of a study, ``jump`` where a brake jumps, and ``joint`` the least
    change of some quantities at once, in SI; None for none. A single quantity is looked at at ``values`` first, then
    ``rounds`` times at ``between``, and the ``most`` that are the nearest are proved, each ``further`` by these shares of
    what is left; ``points`` are those of the share that jumps, and where there is no proof.
    """

    certificate: Callable[[Study], BoxCertificate]
    chance: Callable[[Study, int], Chance | None]
    samples: int
    top: float
    distance: Callable[[Study], float]
    names: tuple[str, ...]
    inside: Callable[[str, float, float], bool]
    rows: Callable[[Study, FloatArray], dict[str, FloatArray]]
    ending: Callable[[Study, Mapping[str, FloatArray], float | None], FloatArray]
    jumping: Jumping
    outcome: Callable[[Study], str]
    jump: Callable[[Study, Mapping[str, float]], float]
    joint: Callable[[Study, tuple[str, ...], float, Mapping[str, float]], dict[str, float] | None]
    values: int
    between: int
    rounds: int
    most: int
    further: tuple[float, ...]
    points: tuple[int, int]


def questions(study: Study) -> Questions:
    """Those of the study's model."""
    return _article() if study.model == "kang_nam" else _any(study)


def _article() -> Questions:
    """Closed forms."""

    def rows(study: Study, shares: FloatArray) -> dict[str, FloatArray]:
        low, high = math.radians(1e-6), math.pi - math.radians(1e-6)
        found = brakes(study, shares)
        return {**found, "theta0": np.clip(found["theta0"], low, high)}

    def ending(study: Study, rows: Mapping[str, FloatArray], friction: float | None) -> FloatArray:
        p = _set(rows)
        found = have_jumped(p if friction is None else p.replace(mu0=np.broadcast_to(friction, p.shape)))
        out = np.where(found.jumped, 1.0, 0.0)
        out.flat[list(found.reasons)] = np.nan
        return out

    def jump(study: Study, values: Mapping[str, float]) -> float:
        return float(first_jumps(_set({name: np.array(values[name]) for name in PHYSICAL}), "mu0").value)

    def joint(study: Study, names: tuple[str, ...], target: float, scale: Mapping[str, float]) -> dict[str, float] | None:
        names = names if len(names) > 1 else ("theta0", "k", "k_x")
        brake = PhysicalParameters(**{**study.values, "mu0": study.friction[1]})
        found = redesign(brake, names, {"mu0": target}, {name: scale[name] for name in names})
        if not np.isfinite(found.distance) or not isinstance(found.parameters, PhysicalParameters):
            return None
        return {name: float(getattr(found.parameters, name)) for name in names}

    def inside(name: str, low: float, high: float) -> bool:
        return (low > 0 and (name != "theta0" or high < math.pi)) or (low == 0 and name in ("k_x", "k_y"))

    def distance(study: Study) -> float:
        scale = {name: size for name, size in study.tolerances.items() if name not in ("m", "V", "d")}
        brake = PhysicalParameters(**{**study.values, "mu0": study.friction[1]})
        return jump_margin(brake, scale).distance if scale else math.nan

    return Questions(
        certificate, chance, 4096, math.inf, distance,
        SINGLE, inside, rows, ending, jumping, lambda study: certificate(study, _SLICES, _BOXES, hasty=True).outcome, jump, joint,
        160, 32, 2, len(SINGLE), (0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0), (1 << 10, 1 << 17),
    )  # fmt: skip


def _set(rows: Mapping[str, FloatArray]) -> Parameters:
    shape = np.shape(rows["theta0"])
    return Parameters(**{name: np.broadcast_to(value, shape) for name, value in dimensionless(rows).items()})


def _any(study: Study) -> Questions:
    """Tubes around the states that are followed."""
    model = load(study.model)
    top = float(ranges(model, ("mu0",), {})[0, 1]) if "mu0" in model.parameters else math.nan
    units = brake_quantities.bases(study.model, study.values)

    def inside(name: str, low: float, high: float) -> bool:
        if name in units and low <= 0:
            return False
        try:
            brake_quantities.dimensionless(study.model, {**study.values, name: np.array([low, high])})
        except ParameterError:
            return False
        return True

    def outcome(study: Study) -> str:
        return tube_tolerances.certificate(study, _FEW_BOXES, _FEW_POINTS).outcome

    def jump(study: Study, values: Mapping[str, float]) -> float:
        return float(model.jump_value(brake_quantities.dimensionless(study.model, values)[0], "mu0"))

    matter = _that_matter(study)

    def joint(study: Study, names: tuple[str, ...], target: float, scale: Mapping[str, float]) -> dict[str, float] | None:
        names = names if len(names) > 1 else matter[:3]
        design = Design(
            study.values,
            brake_quantities.ranges(study.model),
            partial(brake_quantities.groups, study.model),
            dict,
            model.Parameters,
        )
        found = reaching(model, space(design, {name: scale[name] for name in names}, None), {"mu0": target}, 0.0)
        return {name: study.values[name] + step for name, step in found.change.items()} or None

    return Questions(
        tube_tolerances.certificate, tube_tolerances.chance, 2048, top, lambda study: math.nan,
        matter, inside, values_at, tube_tolerances.ending, tube_tolerances.jumping, outcome, jump, joint,
        32, 8, 3, _MOST, (0.0, 0.03, 0.3), (1 << 8, 1 << 11),
    )  # fmt: skip


def _that_matter(study: Study) -> tuple[str, ...]:
    """Quantities on which the balance of forces depends, other than its friction."""
    model = load(study.model)
    # Of the friction law mu0 stands for all: an angle enters by its cosine and sine.
    balance = Balance(model, contact=True)
    taken = inspect.signature(model.statics.forces).parameters
    names = [name for name in balance.parameters if {name, *balance.angles.get(name, ())} & set(taken)]

    def groups(values: Mapping[str, float]) -> list[float]:
        return [float(value) for value in brake_quantities.dimensionless(study.model, values)[0].scalars(*names)]

    before = groups(study.values)
    moved = {name: {**study.values, name: value * (1 - 2.0**-10) or 0.5} for name, value in study.values.items()}
    return tuple(name for name, values in moved.items() if name != "mu0" and groups(values) != before)
