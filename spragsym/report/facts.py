"""What is so with a brake, decided once: sentences, rows and pages say these facts, and decide nothing themselves."""

from __future__ import annotations

import math
from dataclasses import dataclass

from ..display import Result
from . import rises
from .jump_verdicts import BoxCertificate, Chance
from .study import Study

#: What a belt that reaches full slip brings: the friction of the jump is beyond all that there is, or there is none; it is beyond
#: what works at the belt's speed; within its tolerances; or the state has jumped already.
REACHES = ("never", "beyond", "faster", "within", "jumped")


@dataclass(frozen=True)
class Facts(Result):
    """Whether the state of small deformation jumps, and what is known of all brakes within the tolerances.

    ``jump`` is NaN where it jumps at no friction up to ``top``, which ``looked`` says in words, and None where that is not
    known; where another quantity rises it is that in SI, and so are all frictions here. ``reach`` compares the
    friction of the jump, as drawn otherwise, with that which works at the belt's speed, and with that at full slip: one of
    ``REACHES``, or ``""`` where nothing is known of it. ``speed`` is the belt's speed in m/s above which the largest friction
    within the tolerances reaches the jump; NaN where none does, or where the friction law is not known. ``within`` is what is
    known of all brakes within the tolerances at the belt's speed: ``"proved"`` that none jumps, ``"refuted"``,
    ``"undecided"``, or ``""`` if it was not asked. ``hits`` says whether any of the sampled brakes jumps, None without a
    sample. ``unbounded`` names the quantities of whose distribution a part lies beyond the box of the certificate.
    """

    jump: float | None
    working: tuple[float, float, float]
    full: tuple[float, float, float]
    reach: str
    speed: float
    within: str
    hits: bool | None
    unbounded: tuple[str, ...]
    top: float
    looked: str

    @property
    def sprags(self) -> bool:
        """Whether it jumps as drawn, at the belt's speed or above it, with a friction within the tolerances."""
        return self.reach in ("faster", "within", "jumped")

    @property
    def jumped(self) -> bool:
        """Whether it has jumped as drawn, at the belt's speed."""
        return self.reach == "jumped"

    @property
    def slow(self) -> bool:
        """Whether friction at the belt's speed falls short of that at full slip by more than the digits that are printed."""
        return self.working[2] < self.full[2] - 0.005 * abs(self.full[2])


def percent_beyond(value: float, other: float) -> float:
    """By how much a value exceeds another, in percent of the size of that; infinite where that is 0."""
    gap = value - other
    if other:
        return 100 * gap / abs(other)
    return math.copysign(math.inf, gap) if abs(gap) > 0 else gap


def facts(
    study: Study, jump: float | None, top: float, speed: float, reached: BoxCertificate | None, odds: Chance | None
) -> Facts:
    """The facts of a study: where it jumps, up to where that was looked for, at what speed, certificate and probability."""
    working, full = rises.working(study), rises.full(study)
    if jump is None:
        reach = ""
    elif math.isnan(jump):
        reach = "never"
    elif jump <= working[2]:
        reach = "within" if jump > working[1] else "jumped"
    else:
        reach = "faster" if jump <= full[2] or not math.isnan(speed) else "beyond"
    return Facts(
        jump, working, full, reach, speed, "" if reached is None else reached.outcome,
        None if odds is None else odds.probability > 0,
        tuple(name for name in study.unbounded if name != "m"),  # of which no equilibrium depends
        top,
        "" if study.rise is None else rises.looked(study),
    )  # fmt: skip
