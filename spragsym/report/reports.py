"""The report of a study: everything computed once, as a dataclass that turns into a sentence, a text or JSON."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from contextlib import nullcontext
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeVar

import spragsym as ss

from ..display import Result
from ..errors import ParameterError, SpragsymError
from ..progress import doing, show_progress, tell
from ..results.points import Points
from . import brake_quantities, rises
from .cautions import cautions
from .effort import effort
from .facts import Facts, facts, percent_beyond
from .friction import of_statics, speed_for
from .jump_verdicts import BoxCertificate, Chance, bracket, certificate, chance
from .jumps import JumpPeak, jump_peak
from .oscillations import Oscillation, oscillation_of
from .redesigns import Change, changes, distance
from .states import State, current, others, states
from .study import Study
from .tolerances import varied

T = TypeVar("T")


@dataclass(frozen=True)
class Report(Result):
    """What can be said of a brake; None where a model gives no answer, with the reason among ``warnings``.

    Attributes
    ----------
    vary : str or None
        The quantity that rises until the state jumps: ``"mu0"`` for the friction.
    jump_at : float or None
        Where it jumps: ``mu_jump``, or the value of another quantity that rises, in SI.
    mu_jump, theta0_jump_deg : float or None
        Friction at which the state of small deformation jumps at this angle, and angle at which it does at this friction; NaN
        where it never does. Of a model whose statics does not take mu0 itself, it is the friction of its law there.
    mu0_jump : float or None
        The parameter mu0 of the page at that jump.
    mu_lowest, theta0_lowest_deg : float or None
        The lowest fold: the friction below which it jumps at no angle, ``inf`` where it never does, and its angle.
    kind_lowest : str
        ``"cusp"``, ``"turn"`` or ``"end"``, see :class:`spragsym.LowestEnd`; empty where it never jumps, or that is not known.
    mu_cusp : float or None
        Friction of the lowest cusp, ``inf`` where there is none.
    mu_effective : float
        The friction that works at the speed of the belt, by the model's law.
    margin_percent : float or None
        By how much ``jump_at`` exceeds the largest value within the tolerances; NaN where nothing jumps.
    distance : float
        The nearest jump in tolerances, see :func:`spragsym.jump_margin`; NaN where nothing has one, or that is not known.
    states : tuple of State
        All states in contact.
    others : tuple of (dict, float or None)
        Other stable states at the design, by coordinate and unit, and where each ends as what rises goes on; NaN if nowhere.
    complete : bool
        Whether states and folds along what rises are proved to be all there are.
    folds : dict of str to Points
        Folds along what rises and along the inclination, where they are known.
    oscillation : Oscillation or None
    certificate : BoxCertificate or None
    probability : Chance or None
    redesign : tuple of Change
    needed : bool
        Whether changes were looked for.
    target : float
        The value of what rises that the changes of ``redesign`` are for; of friction at the belt's speed, or at full slip if it
        jumps at no other.
    peak : JumpPeak or None
        The jump as a motion; of friction, if there is one that the belt may reach.
    facts : Facts
        What is so: the sentences say this.
    warnings : tuple of str
    verdict : str
        A sentence on the jump, and one on the motion where steady sliding is not all.
    """

    vary: str | None
    jump_at: float | None
    mu_jump: float | None
    theta0_jump_deg: float | None
    mu0_jump: float | None
    mu_lowest: float | None
    theta0_lowest_deg: float | None
    kind_lowest: str
    mu_cusp: float | None
    mu_effective: float
    margin_percent: float | None
    distance: float
    states: tuple[State, ...]
    others: tuple[tuple[dict[str, float], float | None], ...]
    complete: bool
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
    def current(self) -> State | None:
        """The state that the brake is in; None where that is not known."""
        return next((state for state in self.states if state.current), None)

    def to_dict(self) -> dict[str, Any]:
        """The report as JSON has it: numbers, texts, lists and dictionaries; quantities in the units of the file."""
        from .report_json import as_json

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


def report(
    study: Study, *, probability: bool, redesign: bool, oscillation: bool, safety: float, n: int | None, progress: bool
) -> Report:
    """The report of a study; see :meth:`Study.report`."""
    with show_progress() if progress else nullcontext(), doing(""):
        return _report(study, probability, redesign, oscillation, safety, n)


class _Asked:
    """What is asked of the model of a brake; what it can't answer is remarked, and None."""

    def __init__(self, study: Study) -> None:
        self.study, self.remarks = study, list[str]()

    def known(self, what: str, question: Callable[[], T]) -> T | None:
        """The answer."""
        try:
            return question()
        except SpragsymError as reason:
            self.remarks.append(f"{what} not known: {reason}")
            return None

    def jump(self, top: float) -> float | None:
        """Where the state of small deformation jumps as what rises does, as its parameter."""
        study = self.study
        if study.rise is None:
            self.remarks.append(
                f"the model has no mu0 that would rise until the state jumps; say which quantity does, as in vary = "
                f'"{rises.for_example(study.model)}"'
            )
            return None
        found = self.known(f"the jump along {study.rise.quantity} is", partial(rises.jump, study))
        if found is not None and math.isnan(found) and rises.working(study)[2] > top:
            below = f"it was looked for up to {rises.amount(study, top)}, and there is none"
            self.remarks.append(f"the jump along {study.rise.quantity} is not known: {below}")
            return None
        return found

    def angle(self, at: Any) -> float | None:
        """Where the state jumps as the inclination rises, in degrees."""
        if "theta0" not in at.model.parameters or (self.study.rise is not None and self.study.rise.name == "theta0"):
            return None
        found = self.known("the jump along theta0 is", lambda: ss.jump_value(at, "theta0"))
        return None if found is None else math.degrees(found)

    def lowest(self, p: Any) -> tuple[float | None, float | None, str]:
        """Friction, angle in degrees and kind of the lowest end over all angles."""
        if not self._has_plane(p):
            return None, None, ""
        found = self.known("the friction below which it jumps at no angle is", lambda: ss.critical_friction(p))
        if found is None:
            return None, None, ""
        why = "; ".join(dict.fromkeys(found.remarks))
        if found.kind == "undecided":
            below = f"below a friction of {found.value:.4g} it jumps at no angle; whether it does above is not decided: {why}"
            self.remarks.append(below)
            return None, None, ""
        if not found.complete:
            self.remarks.append(f"that nothing jumps below mu_lowest is not proved for all: {why}")
        return of_statics(self.study, float(found.value)), math.degrees(float(found.where)), str(found.kind)

    def cusp(self, p: Any) -> float | None:
        """Friction of the lowest cusp."""
        if not self._has_plane(p):
            return None
        return self.known("the lowest cusp is", lambda: of_statics(self.study, float(ss.cusp_friction(p))))

    def _has_plane(self, p: Any) -> bool:
        """Whether friction rises, at an inclination."""
        return self.study.rise is not None and self.study.rise.is_friction and "theta0" in p.model.parameters

    def folds(self, sets: Mapping[str, Any]) -> dict[str, Points]:
        """Folds along each parameter of these sets."""
        found = {}
        for vary, p in sets.items():
            points = self.known(f"folds along {vary} are", partial(ss.folds, p, vary))
            if points is not None:
                found[vary] = points
        rise = self.study.rise
        if rise is not None and rise.name in found and not found[rise.name].complete:
            why = "; ".join(found[rise.name].remarks)
            unit = "" if rises.scale(self.study) == 1 else (
                f"; {rise.name} = 1 of the model is {rises.amount(self.study, rises.scale(self.study))}"
            )  # fmt: skip
            self.remarks.append(f"that the folds below are all along {rise.quantity} is not proved: {why}{unit}")
        return found


def _report(study: Study, probability: bool, redesign: bool, oscillation: bool, safety: float, n: int | None) -> Report:
    rise, friction = study.rise, study.friction
    if friction[2] == 0 and "mu0" in study.quantities and study.quantities["mu0"].high > 0:
        law = " and ".join(brake_quantities.of_the_law(study.model))
        without = f", or leave {law} out for friction at full slip" if law else ""
        raise ParameterError(
            f"{study.shown_speed(study.values[study.belt or 'V'])}: nothing slides at that speed, and the friction law has no "
            f"friction there; give the speed of the belt{without}"
        )
    tell("jumps, lowest fold and states")
    p, at, asked, end = study.dimensionless, study.at_work, _Asked(study), rises.top(study)
    value = asked.jump(end)
    jump, speed = value, math.nan
    if value is not None and not math.isnan(value):
        jump = rises.told(study, value)
        speed = speed_for(study, jump) if rises.of(study).is_friction else math.nan
    of_friction = rise is not None and rise.is_friction
    theta0_jump, lowest, mu_cusp = asked.angle(at), asked.lowest(p), asked.cusp(p)
    eq = ss.equilibria(at)
    here = asked.known("the state that the brake is in is", lambda: current(study, eq))
    found, beside = states(study, eq, here), others(study, eq, here)
    if here is None and rise is None:
        asked.remarks.append("which of the states the brake is in is not known: nothing is said to rise to where it is")
    if not eq.complete:
        asked.remarks.append(f"that these are all states is not proved: {'; '.join(eq.remarks)}")
    along = {} if rise is None else {rise.name: p if of_friction else at}
    turns = asked.folds(along | ({"theta0": at} if "theta0" in p.model.parameters else {}))
    tell("the proof for all within the tolerances")
    proving = probability and rise is not None
    reached = asked.known("whether nothing within the tolerances jumps is", lambda: certificate(study)) if proving else None
    moving = oscillation and study.moves
    tell("the jump as a motion" if moving else "")
    peak = lives = None
    if moving and value is not None and jump is not None and not math.isnan(jump):
        peak = asked.known("the jump as a motion is", lambda: jump_peak(study, value, jump, speed))
    tell("the oscillation" if moving else "the probability of a jump")
    if moving:
        settles = next((state.settles for state in found if state.current), None)
        holds = any(state.stable for state in found if state.current or here is None)
        lives = asked.known("the oscillation is", lambda: oscillation_of(study, settles, holds))
    tell("the probability of a jump")
    odds = _chance(asked, reached, n) if proving else None
    so = facts(study, jump, end, speed, reached, odds)
    faster = so.reach == "faster"
    target = safety * (so.full[2] if faster else so.working[2])
    sprags = jump is not None and (jump < target or so.hits or so.within == "refuted")
    plain = not of_friction or p.model.about["friction"]["at_rest"] == "mu0"
    wanted, within = redesign and bool(sprags), not faster or jump is None or jump <= so.full[2]
    needed = wanted and target > 0 and plain and within
    if wanted and not plain:
        asked.remarks.append("what to change is not looked for: statics of this model does not take mu0 itself for the friction")
    if wanted and not target > 0:
        times = f"{safety:g} times {rises.named(study, so.working[2])}"
        asked.remarks.append(f"what to change is not looked for: {times} does not lie beyond it")
    tell("what to change" if needed else "")
    changed = changes(study.at_full_slip() if faster else study, target) if needed else ()
    tell("the nearest jump" if rise is not None else "")
    nearest = asked.known("the nearest jump is", partial(distance, study)) if rise is not None else None
    margin = None if jump is None else percent_beyond(jump, so.working[2])
    parts: dict[str, Any] = dict(
        vary=None if rise is None else rise.quantity, jump_at=jump, mu_jump=jump if of_friction else None,
        theta0_jump_deg=theta0_jump, mu0_jump=value if of_friction else None,
        mu_lowest=lowest[0], theta0_lowest_deg=lowest[1], kind_lowest=lowest[2], mu_cusp=mu_cusp, mu_effective=friction[1],
        margin_percent=margin, distance=math.nan if nearest is None else nearest, states=found, others=beside, folds=turns,
        oscillation=lives, certificate=reached,
        complete=bool(eq.complete and (rise is None or (rise.name in turns and turns[rise.name].complete))),
        probability=odds, redesign=changed, needed=needed, target=target, peak=peak, facts=so,
        warnings=(*cautions(study, found, so.jumped), *asked.remarks), study=study,
    )  # fmt: skip
    from .texts import verdict

    return Report(**parts, verdict=verdict(study, parts))


def _chance(asked: _Asked, reached: BoxCertificate | None, n: int | None) -> Chance | None:
    """The probability, by samples and between its proved bounds; nothing is sampled where no brake jumps, by proof."""
    study = asked.study
    if not varied(study):
        return None
    proved = reached is not None and reached.outcome == "proved"
    if proved and not study.unbounded:
        return Chance(0.0, 0.0, 0.0, 1.0, 0, {}, (0.0, 0.0))
    odds = chance(study, effort(study).samples if n is None else n)
    bounds = asked.known("bounds of the probability are", lambda: bracket(study))
    return odds if odds is None or bounds is None else replace(odds, proved=bounds)
