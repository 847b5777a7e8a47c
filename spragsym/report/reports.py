"""The report of a study: facts about a brake, each computed once, which sentences, rows, pages and
JSON only state.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import cached_property, partial
from typing import Any, TypeVar

from .._version import __version__
from ..bifurcation.critical import critical_friction, cusp_friction
from ..bifurcation.folds import folds
from ..design.certificates import Certificate
from ..design.jumps import jump_value
from ..design.probability import JumpProbability
from ..display import Table
from ..errors import ParameterError, SpragsymError
from ..files.storage import put
from ..numerics.columns import picked
from ..remarks import Remark
from ..results import Equilibria, Points, Result
from ..statics.equilibria import equilibria
from . import texts
from .advice import FRICTION, cautions, next_steps
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
from .tolerances import bracket, certificate, chance, effort, speed_for, varied
from .units import Numbers

T = TypeVar("T")


@dataclass(frozen=True)
class Asked:
    """What a report is to say, see :meth:`Study.report`."""

    probability: bool = True
    redesign: bool = True
    oscillation: bool = True
    safety: float = 1.2
    n: int | None = None


@dataclass(frozen=True)
class FoldRow:
    """One fold, or another point at which states meet.

    ``friction``, ``inclination_deg`` or ``value``, of the loading parameter in SI, is where, the
    others None; ``ends`` and ``when`` are as of :class:`~spragsym.Points`. ``before`` and ``after``
    are the coordinates in the units of the file, of which those after are NaN where nothing is
    left.
    """

    kind: str
    friction: float | None
    inclination_deg: float | None
    value: float | None
    ends: str
    when: str
    before: Numbers
    after: Numbers


class Report(Result):
    """Report on a brake; what its model does not answer is None, with the reason among
    ``warnings``.

    What is computed is an attribute.
    """

    def __init__(self, study: Study, asked: Asked) -> None:
        if study.friction[2] == 0 and study.kind.of_mu0 and study.quantities["mu0"].high > 0:
            law = " and ".join(study.kind.of_the_law)
            without = f", or leave {law} out for friction at full slip" if law else ""
            speed = study.shown_speed(study.values[study.belt or "V"])
            raise ParameterError(
                f"{speed}: nothing slides at that speed; give the speed of the belt{without}"
            )
        self.study, self.asked, self.remarks = study, asked, list[str]()

    def _known(self, what: str, question: Callable[[], T]) -> T | None:
        """An answer; what can't be answered is remarked, and None."""
        try:
            return question()
        except SpragsymError as reason:
            self.remarks.append(f"{what} not known: {self._brief(reason)}")
            return None

    def _brief(self, *reasons: object) -> str:
        """The first clause of each reason, in the units of the file."""
        study, of = (
            self.study,
            {name: quantity for quantity, name in self.study.kind.parameters.items()},
        )

        def units(name: str) -> tuple[str, float]:
            quantity = of.get(name, "")
            if quantity not in study.quantities:
                return name, 1.0
            unit, size = study.unit_of(study.kind.units[quantity], quantity)
            return f"{quantity}/{unit}" if unit else quantity, size

        told = (
            reason.told(units) if isinstance(reason, Remark) else str(reason) for reason in reasons
        )
        return ", and ".join(dict.fromkeys(text.partition(";")[0] for text in told))

    @cached_property
    def _jump(self) -> float | None:
        """Where the followed state jumps, as the parameter that rises; NaN where it does not."""
        study = self.study
        if study.rise is None:
            asked = (
                f'say which quantity rises until the state jumps, as vary = "{study.kind.rises}"'
            )
            self.remarks.append(
                "the model has no mu0: "
                f"{asked if study.kind.rises else 'no quantity moves its states'}"
            )
            return None
        along = f"the jump along {study.rise.quantity} is"
        found = self._known(along, study.jump)
        if found is not None and math.isnan(found) and study.working[2] > study.top:
            self.remarks.append(
                f"{along} not known: there is none up to {study.amount(study.top)}, where the "
                "search ends"
            )
            return None
        return found

    @cached_property
    def jump_at(self) -> float | None:
        """Where it jumps, as it is told: the friction of the law, or another quantity in SI; NaN
        where it never does.
        """
        return None if self._jump is None else self.study.told(self._jump)

    @cached_property
    def theta0_jump_deg(self) -> float | None:
        """Where the state jumps as the inclination rises, NaN where it never does."""
        study, at = self.study, self.study.at_work
        if "theta0" not in at.model.parameters or study.rises.name == "theta0":
            return None
        return self._known(
            "the jump along theta0 is", lambda: math.degrees(jump_value(at, "theta0"))
        )

    @property
    def _has_plane(self) -> bool:
        return self.study.of_friction and "theta0" in self.study.dimensionless.model.parameters

    @cached_property
    def _lowest(self) -> Any:
        if not self._has_plane:
            return None
        found = self._known(
            "the friction below which it jumps at no angle is",
            lambda: critical_friction(self.study.dimensionless),
        )
        if found is not None and found.kind == "undecided":
            below = (
                f"below a friction of {found.value:.4g} it cannot jump at any angle; above that"
                if found.value
                else ""
            )
            self.remarks.append(
                f"{below or 'whether some friction is too small for a jump at any angle'} is "
                "not decided"
            )
            return None
        if found is not None and not found.complete:
            self.remarks.append(
                f"that nothing jumps below mu_lowest is not proved: {self._brief(*found.remarks)}"
            )
        return found

    @property
    def mu_lowest(self) -> float | None:
        """The friction below which it jumps at no angle, ``inf`` where it never does."""
        return None if self._lowest is None else self.study.of_statics(float(self._lowest.value))

    @property
    def theta0_lowest_deg(self) -> float | None:
        """Its angle."""
        return None if self._lowest is None else math.degrees(float(self._lowest.where))

    @property
    def kind_lowest(self) -> str:
        """``"cusp"``, ``"turn"`` or ``"end"``, see :class:`spragsym.LowestEnd`; empty where it
        never jumps, or is not known.
        """
        return "" if self._lowest is None else str(self._lowest.kind)

    @cached_property
    def mu_cusp(self) -> float | None:
        """Friction of the lowest cusp, ``inf`` where there is none."""
        if not self._has_plane:
            return None
        study = self.study
        return self._known(
            "the lowest cusp is",
            lambda: study.of_statics(float(cusp_friction(study.dimensionless))),
        )

    @cached_property
    def speed(self) -> float:
        """The speed of the belt in m/s above which the largest friction within the tolerances
        reaches the jump; else NaN.
        """
        jump = self.jump_at
        return (
            math.nan
            if jump is None or math.isnan(jump) or not self.study.of_friction
            else speed_for(self.study, jump)
        )

    @property
    def reach(self) -> str:
        """How the friction of the jump compares with what works as drawn, within the tolerances,
        and at full slip.

        ``"jumped"``, ``"within"``, ``"faster"``, ``"beyond"``, ``"never"``, or empty where it is
        not known.
        """
        jump, (_, here, most) = self.jump_at, self.study.working
        if jump is None:
            return ""
        if math.isnan(jump):
            return "never"
        if jump <= most:
            return "within" if jump > here else "jumped"
        return "faster" if jump <= self.study.full[2] or not math.isnan(self.speed) else "beyond"

    @property
    def jumped(self) -> bool:
        """Whether it has jumped as drawn, at the belt's speed."""
        return self.reach == "jumped"

    @property
    def slow(self) -> bool:
        """Whether friction at the belt's speed falls short of that at full slip by more than the
        digits that are printed.
        """
        full = self.study.full[2]
        return self.study.working[2] < full - 0.005 * abs(full)

    @cached_property
    def _equilibria(self) -> Equilibria:
        return equilibria(self.study.at_work)

    @cached_property
    def _here(self) -> Numbers | None:
        return self._known(
            "the state that the brake is in is", lambda: current(self.study, self._equilibria)
        )

    @cached_property
    def states(self) -> tuple[State, ...]:
        """All states in contact."""
        return states(self.study, self._equilibria, self._here)

    @cached_property
    def others(self) -> tuple[tuple[Numbers, float | None], ...]:
        """Other stable states, by coordinate and unit, and where each ends as the loading parameter
        goes on; NaN if nowhere.
        """
        found = () if self._here is None else others(self.study, self._equilibria, self.states)
        if self._here is None and self.study.rise is None:
            self.remarks.append(
                "which state the brake is in is not known, since nothing is said to rise: "
                "name it with state"
            )
        if not self._equilibria.complete:
            self.remarks.append(f"states may be missing: {self._brief(*self._equilibria.remarks)}")
        return found

    @property
    def current(self) -> State | None:
        """The state that the brake is in; None where that is not known."""
        return next((state for state in self.states if state.current), None)

    @cached_property
    def folds(self) -> dict[str, Points]:
        """Folds along the loading parameter and along the inclination, where they are known."""
        study, rise = self.study, self.study.rises
        p, found = study.at_work, dict[str, Points]()
        for vary in dict.fromkeys((rise.name, "theta0")):
            asked = partial(folds, p, vary)
            if (
                vary in p.model.parameters
                and (known := self._known(f"folds along {vary} are", asked)) is not None
            ):
                found[vary] = known
        own = found.get(rise.name)
        # Folds at more friction than any brake has do not matter.
        if (
            own is not None
            and not own.complete
            and (len(own.undecided) or not study.of_friction or study.top <= FRICTION)
        ):
            self.remarks.append(
                f"folds along {rise.quantity} may be missing: {self._brief(*own.remarks)}"
            )
        return found

    @cached_property
    def fold_rows(self) -> tuple[FoldRow, ...]:
        """Rows of folds, one by one."""
        rows, study = [], self.study
        for vary, found in self.folds.items():
            for i, value in enumerate(getattr(found, vary).tolist()):
                angle = math.degrees(value) if vary == "theta0" else None
                told = None if angle is not None else study.told(value)
                friction, other = (told, None) if study.of_friction else (None, told)
                places = (found.coordinates, found.after)
                before, after = (in_units(study, picked(place, i)) for place in places)
                kind, ends, when = (str(words[i]) for words in (found.kind, found.ends, found.when))
                rows.append(FoldRow(kind, friction, angle, other, ends, when, before, after))
        return tuple(rows)

    @property
    def complete(self) -> bool:
        """Whether states and folds along the loading parameter are proved to be all there are."""
        rise = self.study.rise
        return bool(
            self._equilibria.complete
            and (rise is None or (rise.name in self.folds and self.folds[rise.name].complete))
        )

    @cached_property
    def peak(self) -> JumpPeak | None:
        """The jump as a motion; of friction, if there is one that the belt may reach."""
        value = self._jump
        if not (self.asked.oscillation and self.study.moves) or value is None or math.isnan(value):
            return None
        return self._known(
            "the jump as a motion is", lambda: jump_peak(self.study, value, self.speed)
        )

    @cached_property
    def oscillation(self) -> Oscillation | None:
        """What the motion comes to from rest, or from far out."""
        if not (self.asked.oscillation and self.study.moves):
            return None
        settles = None if self.current is None else self.current.settles
        holds = any(state.stable for state in self.states if state.current or self._here is None)
        return self._known("the oscillation is", lambda: oscillation_of(self.study, settles, holds))

    @cached_property
    def certificate(self) -> Certificate | None:
        """What is proved of all brakes within the tolerances, if it was asked."""
        if not self.asked.probability or self.study.rise is None:
            return None
        return self._known(
            "whether nothing within the tolerances jumps is", lambda: certificate(self.study)
        )

    @property
    def within(self) -> str:
        """Its outcome: ``"proved"`` that none jumps, ``"refuted"``, ``"undecided"``, or empty if it
        was not asked.
        """
        return "" if self.certificate is None else self.certificate.outcome

    @property
    def unbounded(self) -> tuple[str, ...]:
        """Quantities of whose distribution a part lies beyond the box of the certificate."""
        return tuple(name for name in varied(self.study) if not self.study.quantities[name].cut)

    @cached_property
    def probability(self) -> JumpProbability | None:
        """The probability, by samples and between its proved bounds; nothing is sampled where no
        brake jumps, by proof.
        """
        study, n = self.study, self.asked.n
        if not self.asked.probability or study.rise is None or not varied(study):
            return None
        if self.within == "proved" and not self.unbounded:
            return JumpProbability(0.0, 0.0, 0.0, 1.0, 0, 0.0, {}, {}, {}, {}, (0.0, 0.0))
        odds = chance(study, effort(study).samples if n is None else n)
        bounds = self._known("bounds of the probability are", lambda: bracket(study))
        return odds if bounds is None else replace(odds, proved=bounds)

    @property
    def hits(self) -> bool | None:
        """Whether any of the sampled brakes jumps, None without a sample."""
        return None if self.probability is None else self.probability.probability > 0

    @cached_property
    def distance(self) -> float:
        """The nearest jump in tolerances, see :func:`spragsym.jump_margin`; NaN where nothing has
        one, or that is not known.
        """
        found = self._known("the nearest jump is", lambda: distance(self.study))
        return math.nan if found is None else found

    @property
    def target(self) -> float:
        """The value of the loading parameter that changes are for; of friction at full slip, if it
        jumps only there.
        """
        return self.asked.safety * self.largest

    @property
    def largest(self) -> float:
        """The largest value of the loading parameter to which that refers."""
        return (self.study.full if self.reach == "faster" else self.study.working)[2]

    @cached_property
    def needed(self) -> bool:
        """Whether changes were looked for."""
        study, jump = self.study, self.jump_at
        if (
            not self.asked.redesign
            or jump is None
            or not (jump < self.target or self.hits or self.within == "refuted")
        ):
            return False
        plain = not study.of_friction or study.kind.law["at_rest"] == "mu0"
        if not plain:
            self.remarks.append(
                "changes are not looked for: statics of this model does not take mu0 itself "
                "for the friction"
            )
        if not self.target > 0:
            times = f"{self.asked.safety:g} times {study.named(study.working[2])}"
            self.remarks.append(f"changes are not looked for: {times} does not lie beyond it")
        return self.target > 0 and plain and (self.reach != "faster" or jump <= self.largest)

    @cached_property
    def redesign(self) -> tuple[Change, ...]:
        """What to change, nearest first."""
        study = self.study.at_full_slip() if self.reach == "faster" else self.study
        return changes(study, self.target) if self.needed else ()

    # ----------------------------------------------------------------------------- what is said of
    # that

    @property
    def vary(self) -> str | None:
        """The quantity that rises."""
        return self.study.rises.quantity or None

    @property
    def mu_jump(self) -> float | None:
        """Where it jumps, of friction."""
        return self.jump_at if self.study.of_friction else None

    @property
    def mu0_jump(self) -> float | None:
        """The parameter mu0 there."""
        return self._jump if self.study.of_friction else None

    @property
    def mu_effective(self) -> float:
        """The friction that works."""
        return self.study.friction[1]

    @property
    def margin_percent(self) -> float | None:
        """By how much the jump lies beyond the largest value within the tolerances."""
        return (
            None
            if self.jump_at is None
            else texts.percent_beyond(self.jump_at, self.study.working[2])
        )

    @property
    def warnings(self) -> tuple[str, ...]:
        """Where an answer would mislead, or is not known."""
        return (*cautions(self), *self.remarks)

    @property
    def verdict(self) -> str:
        """Whether it sprags, at what friction, and how far that is; then what other states, motion
        and tolerances add.
        """
        return " ".join(texts.verdict(self))

    @property
    def about(self) -> dict[str, str]:
        """Title and date, as the file gives them, the file, its model, and the version of
        spragsym.
        """
        study = self.study
        return {
            "title": study.title,
            "date": study.date,
            "file": study.source,
            "model": f"model {study.kind.about['name']}",
            "version": f"spragsym {__version__}",
        }

    @property
    def next_steps(self) -> tuple[str, ...]:
        """What to do next, at most five steps."""
        return tuple(f"{verb} {what}" for verb, what in next_steps(self))

    def blocks(self) -> Iterator[str]:
        """The text of the report, piece by piece, each as soon as it is computed; the verdict
        first.
        """
        return texts.blocks(self)

    def to_dict(self) -> texts.Json:
        """The report as JSON has it: numbers, texts, lists and dictionaries; quantities in the
        units of the file.
        """
        return texts.as_json(self)

    def text(self) -> str:
        """The report as text: the verdict, then the numbers."""
        return "\n".join(self.blocks())

    def to_html(self, path: str | os.PathLike[str]) -> None:
        """Write the report as one page with its pictures (extra ``plot``)."""
        # a shorthand for what a user asks the package: no room imports one behind it
        import spragsym

        put(path, spragsym.figures.report_page(self))

    def as_table(self) -> Table:
        """The rows of its text."""
        return Table(
            self.verdict,
            ("", "value"),
            tuple(row for _, rows in texts.sections(self) for row in rows),
        )

    def _for_file(self) -> Report:
        raise ParameterError(
            "path: a report is computed anew from its study; write to_html(path), or "
            "json.dumps(to_dict())"
        )

    def table_values(self) -> texts.Json:
        """It has no columns."""
        return {}

    __str__ = text

    def __repr__(self) -> str:
        return f"Report({self.verdict!r}, {self.study!r})"
