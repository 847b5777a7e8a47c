"""How much is looked at for a report: more by closed forms, in thousands of a second, than where states are followed."""

from __future__ import annotations

from dataclasses import dataclass

from ..models.load import load
from .study import Study


@dataclass(frozen=True)
class Effort:
    """Numbers of what is looked at.

    ``samples`` of a probability; ``boxes`` of a proof and of one that is asked of a change, and the ``points`` at which each is
    refuted; ``shares`` of a change that are sampled, where it is not proved, and where not even a sample jumps. A single
    quantity is looked at at ``values`` first, then ``rounds`` times at ``between``, and the ``most`` that are the nearest are
    proved, each ``further`` by these shares of what is left.
    """

    samples: int
    boxes: tuple[int, int]
    points: tuple[int, int]
    shares: tuple[int, int]
    values: int
    between: int
    rounds: int
    most: int
    further: tuple[float, ...]


_CLOSED = Effort(4096, (20_000, 1000), (1024, 1024), (1 << 10, 1 << 17), 160, 32, 2, 16, (0.0, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0))
_FOLLOWED = Effort(2048, (4000, 3000), (512, 64), (1 << 8, 1 << 11), 32, 8, 3, 4, (0.0, 0.03, 0.3))


def effort(study: Study) -> Effort:
    """That of the study's model, whose closed forms are of rising friction."""
    closed = "first_ends" in load(study.model).closed and (study.rise is None or study.rise.is_friction)
    return _CLOSED if closed else _FOLLOWED
