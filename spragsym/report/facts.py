"""Facts of a report (:class:`Facts`): plain data about a brake, computed in a fixed order by
:func:`facts`. Questions that the model does not answer leave None and a remark.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

from ..bifurcation.critical import cusp_friction, lowest_of_followed
from ..bifurcation.folds import folds
from ..core.errors import ParameterError, SpragsymError
from ..core.progress import doing
from ..core.remarks import Remark
from ..core.type_variables import T
from ..design.certificates import Certificate
from ..design.jumps import first_limit_points, require_known
from ..design.probability import JumpProbability
from ..numerics.columns import selected_rows
from ..results.points import CriticalLoad, Points
from ..statics.equilibria import equilibria
from .friction_law import speed_for
from .redesigns import Change, changes, distance
from .states import (
    JumpPeak,
    Oscillation,
    State,
    current,
    in_units,
    jump_peak,
    oscillation_of,
    others,
    states,
)
from .study import Study
from .tolerances import bracket, certificate, chance, sampling_budget, varied
from .units import Numbers

#: A friction coefficient above that of any brake.
FRICTION = 2.0


#: Values of :attr:`Facts.reach` of which the friction in use may reach the jump.
REACHED = ("jumped", "within", "faster")


@dataclass(frozen=True)
class ReportOptions:
    """Options of a report, see :meth:`Study.report`."""

    probability: bool = True
    redesign: bool = True
    oscillation: bool = True
    safety: float = 1.2
    n: int | None = None


@dataclass(frozen=True)
class FoldRow:
    """One fold, or another point at which states meet.

    Its location is ``friction``, ``inclination_deg``, or ``value`` of another loading parameter in
    SI; the other two are None. ``ends`` and ``when`` are those of
    :class:`~spragsym.results.Points`; ``unstable`` is how many λ grow with damping in the
    state that ends, −1 where that is undecided. ``before`` and ``after`` are coordinates in the
    units of the file; ``after`` is NaN if no state remains.
    """

    kind: str
    friction: float | None
    inclination_deg: float | None
    value: float | None
    ends: str
    when: str
    before: Numbers
    after: Numbers
    unstable: int


@dataclass(frozen=True, repr=False)
class Facts:
    """Facts about a brake; those that its model does not answer are None, with reasons in
    ``remarks``.

    Attributes
    ----------
    study : Study
        The brake.
    jump_parameter : float or None
        Value of the model's loading parameter at which the followed state jumps; NaN if it does
        not.
    jump_at : float or None
        The same value as reported: the friction of the law, or another quantity in SI.
    speed : float
        Belt speed in m/s above which the largest friction within the tolerances reaches the jump,
        else NaN.
    reach : str
        How the friction of the jump compares with that in use: ``"jumped"``, below that as drawn;
        ``"within"`` the tolerances; ``"faster"``, reached at a higher belt speed; ``"beyond"`` all;
        ``"never"``, no jump; empty if not known.
    states, others
        All states in contact. Stable states other than the current one, by coordinate and unit,
        with the value of the loading parameter at which each ends, NaN if it does not.
    states_complete : bool
        True if the states are proved to be all.
    oscillation, certificate, probability
        See :class:`~spragsym.report.states.Oscillation`, :func:`spragsym.certify` and
        :func:`spragsym.jump_probability`.
    folds, fold_rows
        Folds along the loading parameter and along the inclination; the same, one by one.
    theta0_jump_deg : float or None
        Inclination at which the state jumps as it rises, NaN if it never does.
    mu_lowest, theta0_lowest_deg, kind_lowest
        The friction below which it jumps at no angle, ``inf`` if it never does; its angle and its
        kind, see :class:`spragsym.results.CriticalLoad`, empty if not known.
    mu_cusp : float or None
        Friction of the lowest cusp, ``inf`` if there is none.
    distance : float
        Distance to the nearest jump in tolerances, see :func:`spragsym.jump_margin`; NaN without
        tolerances or a jump.
    peak : JumpPeak or None
        The jump as a motion, if the belt can reach its friction.
    largest, target : float
        Largest value of the loading parameter (for friction at full slip, if it jumps only there);
        and the value up to which changes must avoid the jump.
    searched, redesign
        True if changes were searched for; those that were found, nearest first.
    remarks : tuple of str
        Reasons for which facts are not known.
    kind_jump, kind_theta0_jump
        Kind of the end of the state, as :attr:`spragsym.bifurcation.paths.ModelEnd.kind`, along the
        loading parameter and along the inclination; ``"border"`` if it leaves the contact.
    """

    study: Study
    jump_parameter: float | None
    jump_at: float | None
    speed: float
    reach: str
    states: tuple[State, ...]
    states_complete: bool
    others: tuple[tuple[Numbers, float | None], ...]
    oscillation: Oscillation | None
    certificate: Certificate | None
    probability: JumpProbability | None
    folds: dict[str, Points]
    fold_rows: tuple[FoldRow, ...]
    theta0_jump_deg: float | None
    mu_lowest: float | None
    theta0_lowest_deg: float | None
    kind_lowest: str
    mu_cusp: float | None
    distance: float
    peak: JumpPeak | None
    largest: float
    target: float
    searched: bool
    redesign: tuple[Change, ...]
    remarks: tuple[str, ...]
    kind_jump: str = "fold"
    kind_theta0_jump: str = "fold"

    @property
    def current(self) -> State | None:
        """The state of the brake; None if not known."""
        return next((state for state in self.states if state.current), None)

    @property
    def at_risk(self) -> bool:
        """True if it jumps, or loses its contact, as drawn, within the tolerances, or at a higher
        speed.
        """
        return self.reach in REACHED

    @property
    def jumped(self) -> bool:
        """True if it has jumped as drawn, at the belt's speed."""
        return self.reach == "jumped"

    @property
    def slow(self) -> bool:
        """True if the friction at the belt's speed is visibly below that at full slip."""
        full = self.study.full_slip[2]
        return self.study.in_use[2] < full - 0.005 * abs(full)

    @property
    def complete(self) -> bool:
        """True if states and folds along the loading parameter are proved to be all."""
        load = self.study.load
        return self.states_complete and (
            load is None or (load.name in self.folds and bool(self.folds[load.name].complete))
        )

    @property
    def within(self) -> str:
        """Outcome of the certificate that no brake jumps; empty without one."""
        return "" if self.certificate is None else self.certificate.outcome

    @property
    def unbounded(self) -> tuple[str, ...]:
        """Quantities whose distribution extends beyond the box of the certificate."""
        return tuple(name for name in varied(self.study) if not self.study.quantities[name].cut)

    @property
    def hits(self) -> bool | None:
        """True if some of the sampled brakes jump; None without samples."""
        return None if self.probability is None else self.probability.probability > 0

    @property
    def vary(self) -> str | None:
        """The quantity that is the loading parameter."""
        return self.study.loading.quantity or None

    @property
    def mu_jump(self) -> float | None:
        """The friction at which it jumps."""
        return self.jump_at if self.study.of_friction else None

    @property
    def mu0_jump(self) -> float | None:
        """The parameter mu0 at which it jumps."""
        return self.jump_parameter if self.study.of_friction else None

    @property
    def mu_effective(self) -> float:
        """The friction in use."""
        return self.study.friction[1]

    @property
    def margin_percent(self) -> float | None:
        """Distance of the jump beyond the largest value in use, in percent of that."""
        return None if self.jump_at is None else percent_beyond(self.jump_at, self.study.in_use[2])


def percent_beyond(value: float, other: float) -> float:
    """The difference of two values in percent of the second one; infinite if that is 0."""
    gap = value - other
    if other:
        return 100 * gap / abs(other)
    return math.copysign(math.inf, gap) if abs(gap) > 0 else gap


class _Answers:
    """Collects remarks about questions on a brake that cannot be answered."""

    def __init__(self, study: Study) -> None:
        self.study = study
        self.remarks: list[str] = []

    def known(self, what: str, question: Callable[[], T]) -> T | None:
        """The answer to a question; if it fails, None, with a remark about ``what``."""
        with doing(what.removesuffix(" is").removesuffix(" are")):
            try:
                return question()
            except SpragsymError as reason:
                told = next(iter(reason.args), "")
                why = told if isinstance(told, Remark) else str(reason)
                self.remarks.append(f"{what} not known: {self.brief(why)}")
                return None

    def brief(self, *reasons: str) -> str:
        """The first clause of each reason, in the units of the file."""
        clauses = (self.study.said(reason).partition(";")[0] for reason in reasons)
        return ", and ".join(dict.fromkeys(clauses))


def facts(study: Study, options: ReportOptions) -> Facts:
    """All facts of a report; the same study and options give the same facts."""
    study.kind.model.require_answered("report")
    _slides(study)
    answers = _Answers(study)
    parameter = _jump(answers)
    jump_at = None if parameter is None else study.displayed(parameter)
    speed = speed_of_jump(study, jump_at)
    reach = reach_of(study, jump_at, speed)

    eq = equilibria(study.operating_point)
    here = answers.known("the state that the brake is in is", partial(current, study, eq))
    found = states(study, eq, here)
    beside = () if here is None else others(study, eq, found)
    if here is None and study.load is None:
        answers.remarks.append(
            "which state the brake is in is not known, since nothing is said to rise: "
            "name it with state"
        )
    if not eq.complete:
        answers.remarks.append(f"states may be missing: {answers.brief(*eq.remarks)}")

    moves = options.oscillation and study.moves
    motion = _oscillation(answers, found, here) if moves else None
    proof = None
    if options.probability and study.load is not None:
        proof = answers.known(
            "whether nothing within the tolerances jumps is", partial(certificate, study)
        )
    odds = _probability(answers, proof, options.n) if options.probability else None

    along = _folds(answers)
    angle, angle_kind = _jump_along_the_inclination(answers)
    lowest, cusp = _lowest(answers)
    nearest = answers.known("the nearest jump is", partial(distance, study))
    peak = None
    if moves and parameter is not None and not math.isnan(parameter):
        peak = answers.known("the jump as a motion is", partial(jump_peak, study, parameter, speed))

    largest = (study.full_slip if reach == "faster" else study.in_use)[2]
    target = options.safety * largest
    refuted = proof is not None and proof.outcome == "refuted"
    fails = refuted or (odds is not None and odds.probability > 0)
    searched = options.redesign and _changes_are_searched(
        answers, jump_at, target, options.safety, fails
    )
    searched = searched and (reach != "faster" or (jump_at is not None and jump_at <= largest))
    redesign: tuple[Change, ...] = ()
    if searched:
        with doing("changes"):
            redesign = changes(study.at_full_slip() if reach == "faster" else study, target)
    return Facts(
        study=study,
        jump_parameter=parameter,
        jump_at=jump_at,
        speed=speed,
        reach=reach,
        states=found,
        states_complete=bool(eq.complete),
        others=beside,
        oscillation=motion,
        certificate=proof,
        probability=odds,
        folds=along,
        fold_rows=_rows(study, along),
        theta0_jump_deg=angle,
        mu_lowest=study.of_statics(float(lowest.value)) if lowest is not None else None,
        theta0_lowest_deg=math.degrees(float(lowest.where)) if lowest is not None else None,
        kind_lowest=str(lowest.kind) if lowest is not None else "",
        mu_cusp=cusp,
        distance=math.nan if nearest is None else nearest,
        peak=peak,
        largest=largest,
        target=target,
        searched=searched,
        redesign=redesign,
        remarks=tuple(answers.remarks),
        kind_jump="fold" if jump_at is None else study.ends.kind(),
        kind_theta0_jump=angle_kind,
    )


def _slides(study: Study) -> None:
    """Raise ParameterError for a belt at rest, against which nothing slides."""
    kind = study.kind
    rubs = kind.has_friction and study.quantities[str(kind.friction)].high > 0
    if study.friction[2] == 0 and rubs:
        law = " and ".join(kind.of_the_law)
        without = f", or leave {law} out for friction at full slip" if law else ""
        speed = study.shown_speed(study.values[study.belt or "V"])
        raise ParameterError(
            f"{speed}: nothing slides at that speed; give the speed of the belt{without}"
        )


def _jump(answers: _Answers) -> float | None:
    """Value of the loading parameter at which the state jumps, NaN if it does not, None if
    unknown.
    """
    study = answers.study
    if study.load is None:
        name = study.kind.rises
        cure = f'say which quantity rises until the state jumps, as vary = "{name}"'
        cure = cure if name else "no quantity moves its states"
        answers.remarks.append(f"the model has no friction coefficient: {cure}")
        return None
    along = f"the jump along {study.load.quantity} is"
    found = answers.known(along, study.jump)
    if found is not None and math.isnan(found) and study.in_use[2] > study.upper_limit:
        answers.remarks.append(
            f"{along} not known: there is none up to {study.load_text(study.upper_limit)}, "
            "where the search ends"
        )
        return None
    return found


def speed_of_jump(study: Study, jump: float | None) -> float:
    """Smallest belt speed at which the largest friction reaches the jump; NaN without one."""
    jumps = jump is not None and not math.isnan(jump) and study.of_friction
    return speed_for(study, jump) if jump is not None and jumps else math.nan


def reach_of(study: Study, jump: float | None, speed: float) -> str:
    """The value of :attr:`Facts.reach`."""
    _, here, most = study.in_use
    if jump is None:
        return ""
    if math.isnan(jump):
        return "never"
    if jump <= most:
        return "within" if jump > here else "jumped"
    return "faster" if jump <= study.full_slip[2] or not math.isnan(speed) else "beyond"


def _oscillation(
    answers: _Answers, found: tuple[State, ...], here: Numbers | None
) -> Oscillation | None:
    """The oscillation, for the states ``found``, of which the one ``here`` is current."""
    stability = next((state.stability for state in found if state.current), None)
    holds = any(state.stability != "unstable" for state in found if state.current or here is None)
    question = partial(oscillation_of, answers.study, stability, holds)
    return answers.known("the oscillation is", question)


def _probability(
    answers: _Answers, proof: Certificate | None, n: int | None
) -> JumpProbability | None:
    """The probability of a jump by sampling, with proved bounds; 0 without sampling if no brake
    within the tolerances jumps, by the certificate.
    """
    study = answers.study
    if study.load is None or not varied(study):
        return None
    cut = all(study.quantities[name].cut for name in varied(study))
    if proof is not None and proof.outcome == "proved" and cut:
        return JumpProbability(0.0, 0.0, 0.0, 1.0, 0, 0.0, {}, {}, {}, {}, (0.0, 0.0))
    odds = chance(study, sampling_budget(study).samples if n is None else n)
    bounds = answers.known("bounds of the probability are", partial(bracket, study))
    return odds if bounds is None else replace(odds, proved=bounds)


def _folds(answers: _Answers) -> dict[str, Points]:
    """Folds along the loading parameter and the inclination, by the model's parameters."""
    study = answers.study
    load, p, found = study.loading, study.operating_point, dict[str, Points]()
    for vary in dict.fromkeys((load.name, p.model.inclination)):
        if vary in p.model.parameters:
            points = answers.known(f"folds along {vary} are", partial(folds, p, vary))
            found |= {} if points is None else {vary: points}
    own = found.get(load.name)
    # Folds at more friction than any brake has do not matter.
    if (
        own is not None
        and not own.complete
        and (len(own.undecided) or not study.of_friction or study.upper_limit <= FRICTION)
    ):
        remarks = answers.brief(*own.remarks)
        answers.remarks.append(f"folds along {load.quantity} may be missing: {remarks}")
    return found


def _rows(study: Study, found: dict[str, Points]) -> tuple[FoldRow, ...]:
    """The folds one by one."""
    rows = []
    for vary, points in found.items():
        for i, value in enumerate(points[vary].tolist()):
            angle = math.degrees(value) if vary == study.kind.model.inclination else None
            shown = None if angle is not None else study.displayed(value)
            friction, other = (shown, None) if study.of_friction else (None, shown)
            places = (points.coordinates, points.after)
            before, after = (in_units(study, selected_rows(state, i)) for state in places)
            words = (points.kind, points.ends, points.when)
            kind, ends, when = (str(word[i]) for word in words)
            unstable = int(points.unstable_before[i])
            rows.append(FoldRow(kind, friction, angle, other, ends, when, before, after, unstable))
    return tuple(rows)


def _jump_along_the_inclination(answers: _Answers) -> tuple[float | None, str]:
    """The inclination in degrees at which the state ends, and the kind of end."""
    study, at = answers.study, answers.study.operating_point
    vary = at.model.inclination
    if vary is None or study.loading.name == vary:
        return None, "fold"
    what = f"the jump along {vary} is"
    found = answers.known(what, lambda: require_known(first_limit_points(at, vary)))
    return (None, "fold") if found is None else (math.degrees(found.value), found.kind())


def _lowest(answers: _Answers) -> tuple[CriticalLoad | None, float | None]:
    """The lowest friction of a jump at any angle, and that of the lowest cusp; None for models
    without an inclination.
    """
    study, p = answers.study, answers.study.dimensionless
    if not (study.of_friction and p.model.inclination):
        return None, None
    what = "the friction below which it jumps at no angle is"
    found = answers.known(what, partial(lowest_of_followed, p))
    if found is not None and found.kind == "undecided":
        below = "whether some friction is too small for a jump at any angle"
        if found.value:
            below = f"below a friction of {found.value:.4g} it cannot jump at any angle; above that"
        answers.remarks.append(f"{below} is not decided")
        found = None
    elif found is not None and not found.complete:
        reasons = answers.brief(*found.remarks)
        answers.remarks.append(f"that nothing jumps below mu_lowest is not proved: {reasons}")
    cusp = answers.known("the lowest cusp is", lambda: study.of_statics(float(cusp_friction(p))))
    return found, cusp


def _changes_are_searched(
    answers: _Answers, jump: float | None, target: float, safety: float, fails: bool
) -> bool:
    """True if changes are to be searched: the jump is below the target, or a brake within the
    tolerances jumps (``fails``). A remark explains why they cannot be.
    """
    study = answers.study
    if jump is None or not (jump < target or fails):
        return False
    plain = not study.of_friction or study.kind.law["at_rest"] == "full"
    if not plain:
        answers.remarks.append(
            "changes are not looked for: statics of this model does not take "
            f"{study.kind.friction} itself for the friction"
        )
    if not target > 0:
        times = f"{safety:g} times {study.named(study.in_use[2])}"
        answers.remarks.append(f"changes are not looked for: {times} does not lie beyond it")
    return target > 0 and plain
