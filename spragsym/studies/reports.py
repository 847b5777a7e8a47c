"""The report of a study: everything computed once, as a dataclass that turns into a sentence, a text or JSON."""

from __future__ import annotations

import math
import sys
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from typing import Any

from ..catastrophe import critical_friction, cusp_friction, folds
from ..design import jump_margin, jump_value
from ..display import Result
from ..errors import ParameterError
from ..statics.points import Points
from .cautions import cautions
from .facts import Facts, facts
from .jumps import JumpPeak, jump_peak
from .oscillations import Oscillation, oscillation_of
from .redesigns import Change, changes
from .states import State, states
from .study import Study
from .tolerances import BoxCertificate, Chance, certificate, chance


@dataclass(frozen=True)
class Report(Result):
    """What can be said of a brake.

    Attributes
    ----------
    mu_jump, theta0_jump_deg : float
        Friction at which the state of small deformation jumps at this angle, and angle at which it does at this friction; NaN
        where it never does.
    mu_lowest, theta0_lowest_deg : float
        The lowest fold: the friction below which it jumps at no angle, ``inf`` where it never does, and its angle.
    kind_lowest : str
        ``"cusp"``, ``"turn"`` or ``"end"``, see :class:`spragsym.LowestEnd`; empty where it never jumps.
    mu_cusp : float
        Friction of the lowest cusp, ``inf`` where there is none.
    mu_effective : float
        The friction that works at the speed of the belt.
    margin_percent : float
        By how much ``mu_jump`` exceeds the largest friction within the tolerances; NaN where nothing jumps.
    distance : float
        The nearest jump in tolerances, see :func:`spragsym.jump_margin`; NaN where nothing has one.
    states : tuple of State
        All states in contact.
    folds : dict of str to Points
        Folds along the friction and along the inclination.
    oscillation : Oscillation or None
    certificate : BoxCertificate or None
    probability : Chance or None
    redesign : tuple of Change
    needed : bool
        Whether changes were looked for.
    target : float
        The friction that the changes of ``redesign`` are for: at the belt's speed, or at full slip if it jumps at no other.
    peak : JumpPeak or None
        The jump as a motion, if there is one at a friction that the belt may reach.
    facts : Facts
        What is so: the sentences say this.
    warnings : tuple of str
    verdict : str
        One sentence.
    """

    mu_jump: float
    theta0_jump_deg: float
    mu_lowest: float
    theta0_lowest_deg: float
    kind_lowest: str
    mu_cusp: float
    mu_effective: float
    margin_percent: float
    distance: float
    states: tuple[State, ...]
    folds: Mapping[str, Points]
    oscillation: Oscillation | None
    certificate: BoxCertificate | None
    probability: Chance | None
    redesign: tuple[Change, ...]
    needed: bool
    target: float
    peak: JumpPeak | None
    facts: Facts
    warnings: tuple[str, ...]
    verdict: str
    study: Study

    @property
    def current(self) -> State:
        """The state that the brake is in."""
        return next(state for state in self.states if state.current)

    def to_dict(self) -> dict[str, Any]:
        """The report as JSON has it: numbers, texts, lists and dictionaries; quantities in the units of the file."""
        from .texts import as_json

        return as_json(self)

    def text(self) -> str:
        """The report as text: the verdict, then the numbers."""
        from .texts import as_text

        return as_text(self)

    def __str__(self) -> str:
        return self.text()

    def to_html(self, path: Any) -> None:
        """Write the report as one page with its pictures (extra ``plot``)."""
        self.study.to_html(path, self)


#: Says what is computed now; nothing, for an empty text.
Tell = Callable[[str], None]
#: Points that a probability is estimated from.
POINTS = 4096


def teller(show: bool) -> Tell:
    """On a terminal one line, written over and over."""

    def tell(part: str) -> None:
        if show:
            line = f"computing {part}" if part else ""
            sys.stderr.write(f"\r{line:<72}" + ("" if part else "\r"))
            sys.stderr.flush()

    return tell


def report(
    study: Study, *, probability: bool, redesign: bool, oscillation: bool, safety: float, n: int = POINTS, progress: bool
) -> Report:
    """The report of a study; see :meth:`Study.report`."""
    tell = teller(progress)
    try:
        return _report(study, probability, redesign, oscillation, safety, n, tell)
    finally:
        tell("")


def _report(study: Study, probability: bool, redesign: bool, oscillation: bool, safety: float, n: int, tell: Tell) -> Report:
    low, working, high = study.friction
    if high == 0 and study.quantities["mu0"].high > 0:
        raise ParameterError(
            f"V = {study.shown('V', study.values['V'])}: nothing slides at that speed, and the friction law has no friction "
            "there; give the speed of the belt, or leave V and d out for friction at full slip"
        )
    tell("jumps, lowest fold and states")
    p = study.dimensionless
    mu_jump = float(jump_value(p, "mu0"))
    theta0_jump = float(jump_value(p.replace(mu0=working), "theta0"))
    lowest, mu_cusp = critical_friction(p), float(cusp_friction(p))
    found = states(study)
    margin = 100 * (mu_jump / high - 1) if high > 0 else math.inf
    tell("the proof for all within the tolerances")
    reached = certificate(study) if probability else None
    moving = oscillation and study.moves
    tell("the jump as a motion (--no-oscillation leaves it out)" if moving else "")
    peak = jump_peak(study, mu_jump) if moving and mu_jump <= study.quantities["mu0"].high else None
    tell("the oscillation (--no-oscillation leaves it out)" if moving else "the probability of a jump")
    lives = oscillation_of(study) if moving else None
    tell("the probability of a jump")
    odds = chance(study, n) if probability else None
    tell("what to change (--no-redesign leaves it out)" if redesign else "")
    so = facts(study, mu_jump, reached, odds)
    faster = so.reach == "faster"
    target = safety * (so.full[2] if faster else high)
    needed = redesign and target > 0 and bool(mu_jump < target or so.hits or so.within == "refuted")
    turns = {"mu0": folds(p, "mu0"), "theta0": folds(p.replace(mu0=working), "theta0")}
    parts: dict[str, Any] = dict(
        mu_jump=mu_jump, theta0_jump_deg=math.degrees(theta0_jump), mu_lowest=float(lowest),
        theta0_lowest_deg=math.degrees(lowest.theta0), kind_lowest=lowest.kind, mu_cusp=mu_cusp, mu_effective=working,
        margin_percent=margin,
        distance=_distance(study), states=found, folds=turns, oscillation=lives, certificate=reached,
        probability=odds, redesign=changes(study.at_full_slip() if faster else study, target) if needed else (),
        needed=needed, target=target, peak=peak, facts=so,
        warnings=cautions(study, found, so.jumped), study=study,
    )  # fmt: skip
    from .texts import verdict

    return Report(**parts, verdict=verdict(study, parts))


def _distance(study: Study) -> float:
    """The nearest jump in tolerances, at the friction that works."""
    scale = {name: size for name, size in study.tolerances.items() if name not in ("m", "V", "d")}
    if not scale:
        return math.nan
    brake = study.parameters
    friction = type(brake)(**{**asdict(brake), "mu0": study.friction[1]})
    return jump_margin(friction, scale).distance
