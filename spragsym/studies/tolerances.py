"""What the tolerances leave possible: a certificate for the whole box, the probability of a jump, and which quantity matters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
from scipy.optimize import brentq
from scipy.stats import qmc

from ..catastrophe.sliding import sliding_friction
from ..design import certify, jump_probability
from ..design.events import have_jumped
from ..design.probability import BELT
from ..design.spaces import PHYSICAL, dimensionless
from ..display import Result
from ..parameters import NAMES, Parameters
from .study import Study

#: Slices of the contact's stiffness, on which all groups depend: more of them until the claim is decided.
_SLICES = (1, 4, 16, 48)
#: The step between slices that are looked at first.
_SPREAD = 8
#: Boxes for one slice, and points at which counterexamples are looked for.
_BOXES, _POINTS = 400, 1024


@dataclass(frozen=True)
class BoxCertificate(Result):
    """What is known of "nothing jumps" for every brake within the tolerances.

    ``outcome`` is ``"proved"``, ``"refuted"`` or ``"undecided"``; ``counterexample`` is a brake within the tolerances that jumps,
    in SI; ``undecided`` is the share of the slices of the box that is not proved.
    """

    claim: str
    outcome: str
    counterexample: Mapping[str, float] | None
    undecided: float
    boxes: int


def ends(study: Study) -> dict[str, tuple[float, float]]:
    """Both ends of every quantity that the statics depend on; of the friction, the one that works."""
    found = {name: (study.quantities[name].low, study.quantities[name].high) for name in PHYSICAL}
    return found | {"mu0": (study.friction[0], study.friction[2])}


def friction_at(study: Study, shares: Mapping[str, Any]) -> Any:
    """The friction that works at shares of the tolerances of mu0, V and d; 1 is the upper end."""
    values = {}
    for name in ("mu0", *BELT) if study.moves else ("mu0",):
        one = study.quantities[name]
        values[name] = np.clip(one.low + np.asarray(shares.get(name, 0.0)) * (one.high - one.low), one.low, one.high)
    return sliding_friction(*values.values()) if study.moves else values["mu0"]


def belt_at(study: Study, friction: float) -> dict[str, float]:
    """mu0, V and d within their tolerances, all at one share of them, at which the friction that works is a given one."""
    wide = [name for name in ("mu0", *BELT) if name in study.tolerances and (name == "mu0" or study.moves)]

    def off(share: float) -> float:
        return float(friction_at(study, dict.fromkeys(wide, share))) - friction

    low, high = off(0.0), off(1.0)
    share = 0.0 if low >= 0 else 1.0 if high <= 0 else float(brentq(off, 0.0, 1.0, xtol=1e-15))
    ends = {name: study.quantities[name] for name in {"mu0", *wide}}
    return {name: float(np.clip(one.low + share * (one.high - one.low), one.low, one.high)) for name, one in ends.items()}


def certificate(study: Study) -> BoxCertificate:
    """Prove that nothing jumps within the tolerances, or find a brake within them that does.

    Notes
    -----
    Source: :func:`spragsym.certify` over boxes of the dimensionless groups that enclose the tolerances, rounded outward. All
    groups have the stiffness of the contact in common, so it is cut into slices until the boxes are narrow enough.
    Counterexamples are looked for among the corners and Sobol' points of the tolerances themselves.
    """
    box = ends(study)
    point = _counterexample(box)
    if point is not None:
        return BoxCertificate("no jump", "refuted", point | belt_at(study, point["mu0"]), 0.0, 0)
    seen, left = 0, 1.0
    for slices in _SLICES:
        cuts = np.linspace(*box["k_c"], slices + 1)
        low_k, high_k = cuts[:-1], cuts[1:]
        open_ones = 0
        # From all parts of the range first: where each of these is open, so are the others, or nearly.
        order = sorted(range(slices), key=lambda i: i % _SPREAD)
        for done, i in enumerate(order, 1):
            found = certify(*_corners(box | {"k_c": (float(low_k[i]), float(high_k[i]))}), "no jump", max_boxes=_BOXES)
            seen += found.boxes
            open_ones += found.outcome != "proved"
            if open_ones and (slices != _SLICES[-1] or open_ones == done == slices // _SPREAD):
                open_ones += slices - done
                break
        left = open_ones / slices
        if not open_ones:
            return BoxCertificate("no jump", "proved", None, 0.0, seen)
        if box["k_c"][0] == box["k_c"][1]:
            break
    return BoxCertificate("no jump", "undecided", None, left, seen)


def _counterexample(box: Mapping[str, tuple[float, float]]) -> dict[str, float] | None:
    wide = [name for name, (low, high) in box.items() if high > low]
    corners = np.array(list(product((0.0, 1.0), repeat=len(wide)))) if wide else np.zeros((1, 0))
    shares = [corners]
    if wide:
        shares.append(qmc.Sobol(len(wide), rng=0).random(_POINTS))
    inside = np.concatenate(shares)
    values: dict[str, Any] = {name: np.full(len(inside), low) for name, (low, high) in box.items()}
    for j, name in enumerate(wide):
        low, high = box[name]
        values[name] = np.clip(low + inside[:, j] * (high - low), low, high)
    jumping = np.flatnonzero(have_jumped(Parameters(**dimensionless(values))).jumped)
    return {name: float(value[jumping[0]]) for name, value in values.items()} if jumping.size else None


def _corners(box: Mapping[str, tuple[float, float]]) -> tuple[Parameters, Parameters]:
    """Dimensionless parameters between which all of the box lies, rounded outward."""
    low, high = ({name: end[side] for name, end in box.items()} for side in (0, 1))
    # Every group is one quantity over k_c, and κ over L_0 as well.
    least = dimensionless(low | {"k_c": high["k_c"], "L_0": high["L_0"]})
    most = dimensionless(high | {"k_c": low["k_c"], "L_0": low["L_0"]})
    for name in NAMES:
        if name in ("theta0", "mu0"):
            continue
        for _ in range(4):  # three operations at most, each rounded by half a unit
            least[name] = max(np.nextafter(least[name], -np.inf), 0.0) if least[name] else least[name]
            most[name] = np.nextafter(most[name], np.inf) if most[name] else most[name]
    return Parameters(**least), Parameters(**most)


@dataclass(frozen=True)
class Chance(Result):
    """The probability of a jump with its interval; Sobol' indices: first order, total, and the total's half-width."""

    probability: float
    low: float
    high: float
    confidence: float
    n: int
    sobol: Mapping[str, tuple[float, float, float]]


def chance(study: Study, n: int) -> Chance | None:
    """How probable a jump is if every value within the tolerances is as probable; None where nothing has a tolerance."""
    names = PHYSICAL + (BELT if study.moves else ())
    box = {name: (study.quantities[name].low, study.quantities[name].high) for name in names}
    if all(low == high for low, high in box.values()):
        return None
    found = jump_probability({name: low if low == high else (low, high) for name, (low, high) in box.items()}, n=n, rng=0)
    indices = {
        name: (found.first[name], found.total[name], found.total_error[name])
        for name in sorted(found.total, key=lambda name: -np.nan_to_num(found.total[name]))
    }
    return Chance(found.probability, found.low, found.high, found.confidence, found.n, indices)
