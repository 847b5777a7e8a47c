"""Contact pairs, from which the friction matrix follows."""

from __future__ import annotations

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from ..core.errors import ParameterError, ParameterTypeError
from ..files.text import FilePath, path_text, text_of
from ..models.parameters import POSITIVE, as_number
from ..numerics.interval_arrays import FloatArray

#: A degree of freedom: its row, from 0, or the label of its node and its number there.
Dof: TypeAlias = int | tuple[int, int]


@dataclass(frozen=True)
class ContactPair:
    """Two facing degrees of freedom of a contact across the surface, and two along it.

    Parameters
    ----------
    across : pair of dofs
        Of the first body and of the second, positive from the first to the second: their
        difference opens the contact. One alone, in a tuple, rubs on what does not move.
    along : pair of dofs
        Of the first body and of the second along the surface, likewise.
    stiffness : float
        Of the contact, across; K has it already.
    direction : int
        1 if the first body slides over the second in the positive sense of ``along``, −1 if in the
        negative one.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> pair = ss.ContactPair(across=(0, 2), along=(1, 3), stiffness=2.0)
    >>> m = ss.matrices(np.eye(4), np.eye(4), [pair])
    >>> m.given["friction"][[1, 3]].tolist()
    [[2.0, 0.0, -2.0, 0.0], [-2.0, 0.0, 2.0, 0.0]]
    """

    across: tuple[Dof, ...]
    along: tuple[Dof, ...]
    stiffness: float
    direction: int = 1

    def __post_init__(self) -> None:
        as_number("stiffness", self.stiffness, POSITIVE)
        if self.direction not in (1, -1):
            raise ParameterError(f"direction = {self.direction!r} is neither 1 nor -1")
        for name in ("across", "along"):
            dofs = getattr(self, name)
            if not isinstance(dofs, tuple) or not 1 <= len(dofs) <= 2 or len(set(dofs)) < len(dofs):
                raise ParameterTypeError(
                    f"{name} = {dofs!r} are not one or two dofs; give those of the two bodies, as "
                    f"{name}=(0, 2)"
                )
        if len(self.across) != len(self.along):
            raise ParameterError("across and along differ in the number of bodies")

    def rows(self, size: int, places: Mapping[Dof, int]) -> tuple[FloatArray, FloatArray]:
        """The rows w_n of the gap, and w_t along which friction drags the second body; ``places``
        are the rows of labelled degrees of freedom.
        """
        out = np.zeros((2, size))
        for row, dofs in zip(out, (self.across, self.along), strict=True):
            for sign, dof in zip((-1.0, 1.0)[-len(dofs) :], dofs, strict=True):
                place = places.get(dof, dof)
                if not isinstance(place, int | np.integer) or not 0 <= place < size:
                    raise ParameterError(
                        f"{dof!r} is no degree of freedom of the matrices; give a row from 0 to "
                        f"{size - 1}" + ", or (node, number)" * bool(places)
                    )
                row[place] = sign
        return out[0], self.direction * out[1]


def directions(
    pairs: Sequence[ContactPair], size: int, places: Mapping[Dof, int]
) -> tuple[FloatArray, FloatArray, FloatArray]:
    """W_n and W_t, a row for each pair, and the stiffnesses k: friction adds μ W_tᵀ k W_n."""
    rows = np.array([one.rows(size, places) for one in pairs]).reshape(-1, 2, size)
    return rows[:, 0], rows[:, 1], np.array([float(one.stiffness) for one in pairs])


def read_contacts(path: FilePath) -> list[ContactPair]:
    """Contact pairs of a file ``.csv``, whose first line names its columns: ``across_1``,
    ``across_2``, ``along_1``, ``along_2``, ``stiffness``, ``direction``.

    A degree of freedom is its row, or ``node:number``; of a body that does not move it is empty.
    """
    names = ("across_1", "across_2", "along_1", "along_2", "stiffness", "direction")
    shown = path_text(path)
    rows = csv.DictReader(io.StringIO(text_of(path, 1 << 26, "a table of contact pairs")))
    if sorted(rows.fieldnames or ()) != sorted(names):
        raise ParameterError(f"{shown}, line 1: the columns are not {','.join(names)}; name them")
    pairs = []
    for row in rows:
        try:
            ends = {
                name: tuple(_dof(row[f"{name}_{body}"]) for body in (1, 2) if row[f"{name}_{body}"])
                for name in ("across", "along")
            }
            numbers = float(row["stiffness"]), int(row["direction"])
            pairs.append(ContactPair(ends["across"], ends["along"], *numbers))
        except (ValueError, TypeError) as error:
            raise ParameterError(
                f"{shown}, line {rows.line_num}: {error}; write a line as 1:3,7:3,1:1,7:1,1e5,1"
            ) from error
    if not pairs:
        raise ParameterError(f"{shown} has no contact pair; write one a line")
    return pairs


def _dof(text: str) -> Dof:
    node, sign, number = text.partition(":")
    return (int(node), int(number)) if sign else int(node)
