"""A brake from finite elements to begin with: a pad on a strip of a disc, as files."""

from __future__ import annotations

import itertools
from collections import defaultdict
from dataclasses import dataclass, field

import numpy as np

from ..numerics.interval_arrays import FloatArray
from .exports import Label


@dataclass
class _Plate:
    """A plate in its plane, of square elements with four nodes; units are t, mm, s."""

    first: int  #: its first node
    wide: int  #: elements along it
    high: int
    modulus: float
    density: float
    side: float = 10.0  #: of an element
    thick: float = 60.0
    poisson: float = 0.28
    mass: dict[tuple[Label, Label], float] = field(default_factory=lambda: defaultdict(float))
    stiffness: dict[tuple[Label, Label], float] = field(default_factory=lambda: defaultdict(float))

    def row(self, number: int) -> list[int]:
        """The nodes of a row, from below."""
        begin = self.first + number * (self.wide + 1)
        return [*range(begin, begin + self.wide + 1)]

    def hold(self, number: int, along: float, across: float) -> None:
        """Springs at each node of a row."""
        for node in self.row(number):
            self.stiffness[(node, 1), (node, 1)] += along
            self.stiffness[(node, 2), (node, 2)] += across

    def assemble(self) -> None:
        """Add all elements."""
        parts = (self.mass, self.stiffness)
        for row, column in itertools.product(range(self.high), range(self.wide)):
            low, top = self.row(row), self.row(row + 1)
            nodes = (low[column], low[column + 1], top[column + 1], top[column])
            dofs = [(node, number) for node in nodes for number in (1, 2)]
            for part, own in zip(parts, self._element(), strict=True):
                for (i, one), (j, other) in itertools.product(enumerate(dofs), repeat=2):
                    part[one, other] += float(own[i, j])

    def _element(self) -> tuple[FloatArray, FloatArray]:
        """Mass and stiffness of an element in plane stress, by 2 × 2 points of Gauss."""
        nu, M, K = self.poisson, np.zeros((8, 8)), np.zeros((8, 8))
        law = np.array([[1.0, nu, 0.0], [nu, 1.0, 0.0], [0.0, 0.0, 0.5 * (1.0 - nu)]])
        right, above = np.array([-1, 1, 1, -1]), np.array([-1, -1, 1, 1])
        volume = 0.25 * self.side**2 * self.thick
        for x, y in itertools.product((-(3.0**-0.5), 3.0**-0.5), repeat=2):
            along, up = 1.0 + right * x, 1.0 + above * y
            shape = np.kron(0.25 * along * up, np.eye(2))
            strain = np.zeros((3, 8))
            strain[0, ::2] = strain[2, 1::2] = 0.5 / self.side * right * up
            strain[1, 1::2] = strain[2, ::2] = 0.5 / self.side * above * along
            M += volume * self.density * shape.T @ shape
            K += volume * self.modulus / (1.0 - nu**2) * strain.T @ law @ strain
        return 0.5 * (M + M.T), 0.5 * (K + K.T)


def example_files() -> dict[str, str]:
    """The files of a brake by name: mass and stiffness as Abaqus writes them, contact pairs, and
    ``brake.toml``.
    """
    disc = _Plate(1, 24, 2, 110e3, 7.2e-9)
    pad = _Plate(1001, 8, 3, 8e3, 2.8e-9)
    contact = 5e4  # N/mm of a pair
    disc.hold(0, 3e4, 3e4)
    pad.hold(3, 1e4, 2e4)
    pairs = list(zip(disc.row(2)[8:17], pad.row(0), strict=True))
    for plate in (disc, pad):
        plate.assemble()
    stiffness = disc.stiffness | pad.stiffness
    for ends in pairs:
        for (i, one), (j, other) in itertools.product(enumerate(ends), repeat=2):
            held = (one, 2), (other, 2)
            stiffness[held] = stiffness.get(held, 0.0) + (contact if i == j else -contact)
    rows = [f"{one}:2,{other}:2,{one}:1,{other}:1,{contact!r},1" for one, other in pairs]
    return {
        "mass.mtx": _abaqus(disc.mass | pad.mass),
        "stiffness.mtx": _abaqus(stiffness),
        "contacts.csv": "\n".join(
            ["across_1,across_2,along_1,along_2,stiffness,direction", *rows, ""]
        ),
        "brake.toml": _BRAKE,
    }


def _abaqus(entries: dict[tuple[Label, Label], float]) -> str:
    """The lower triangle, a line for each element."""
    lines = [
        f"{row[0]},{row[1]}, {column[0]},{column[1]}, {value!r}"
        for (row, column), value in sorted(entries.items())
        if row >= column and value
    ]
    return "\n".join(["** node, dof, node, dof, value", *lines, ""])


_BRAKE = """\
title = "A pad on a strip of a disc"
damping_ratio = "0.5 %"
band = "[100, 12000] Hz"
modes = 30                       # reduced to these, and static corrections

[matrices]
M = "mass.mtx"
K = "stiffness.mtx"              # with the contact's stiffness in it
contacts = "contacts.csv"
units = "t mm s"

[parameters]
mu = "[0, 0.8]"
"""
