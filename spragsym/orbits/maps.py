"""Maps of fates over a grid of parameters: each point by the rules of :func:`spragsym.fate`, resumable."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ..errors import ParameterError
from ..files import storage
from ..files.journal import Record
from ..models.parameters import POSITIVE, FloatArray, ParameterSet, as_number
from ..motion import integrators
from ..motion.simulation import state_of
from ..motion.sweeps.points import made_or_loaded
from ..motion.sweeps.result import fingerprint, with_degrees
from ..motion.sweeps.workers import Workers
from ..numerics.interval_arrays import Int8Array
from ..questions import model_of
from ..results.result import Result
from .verdicts import UNFOLLOWED, fate

#: Numbers of a record, in this order.
MEASURED = ("kind", "period", "exponent", "exponent_error", "time_scale", "t")


class Kind(IntEnum):
    """What a motion comes to, as :attr:`spragsym.Fate.kind` has it in words."""

    UNDECIDED = 0
    REST = 1
    CYCLE = 2
    LIFT_OFF = 3
    CHAOTIC = 4


@dataclass(frozen=True, eq=False)
class FateMap(Result):
    """Fates of motions over a grid of parameters; every array has the common shape of the parameters.

    Attributes
    ----------
    inputs : dict of str to ndarray
        The parameters as they were given, which broadcast together.
    start : tuple of float
        Where every motion begins: coordinates, then rates.
    t_end : float
    backend : str
    kind : ndarray of int8
        0 undecided, 1 rest, 2 cycle, 3 lift-off, 4 chaotic.
    period : ndarray
        Of the cycle; NaN for none.
    exponent, exponent_error : ndarray
        The largest Lyapunov exponent but the trivial one, and the half-width of its 95 % interval.
    time_scale : ndarray
        On which the slowest deviations from steady sliding die out.
    t : ndarray
        How long the motion was followed.
    why : ndarray of str
        What decides the kind, or would.
    model : Model
    """

    table_codes: ClassVar[Mapping[str, type[Kind]]] = {"kind": Kind}

    inputs: dict[str, FloatArray]
    start: tuple[float, ...]
    t_end: float
    backend: str
    kind: Int8Array
    period: FloatArray
    exponent: FloatArray
    exponent_error: FloatArray
    time_scale: FloatArray
    t: FloatArray
    why: NDArray[np.str_]
    model: Any = field(repr=False)

    def count(self) -> dict[str, int]:
        """How many points are of each kind."""
        return {kind.name.lower().replace("_", "-"): int(np.count_nonzero(self.kind == kind)) for kind in Kind}

    def _save_columns(self, path: Path) -> None:
        """Write ``*.csv``: one line a point."""
        explained = {**self.model.quantities, "t": (self.model.quantities["t"][0], "how long the motion was followed")}
        names = (f"{name}0" for name in (*self.model.coordinates, *self.model.rates))
        made = {
            **storage.provenance(), "model": self.model.name, **dict(zip(names, self.start, strict=True)), "t_end": self.t_end,
            "backend": self.backend, "fingerprint": _Asked(self.model, self.start, self.t_end, self.backend).key(self.inputs),
        }  # fmt: skip
        storage.write(path, dict, self._columns, made, explained)

    def _columns(self) -> dict[str, NDArray[Any]]:
        columns = with_degrees(self.model, self.inputs) | {name: getattr(self, name) for name in (*MEASURED, "why")}
        return {name: np.broadcast_to(values, self.kind.shape).ravel() for name, values in columns.items()}


def fate_map(
    p: ParameterSet, *, V: Any = None, d: Any = None, start: Any = None, t_end: float = 40_000.0,
    backend: str | None = None, workers: Workers = 1, progress: bool = False, store: str | os.PathLike[str] | None = None,
) -> FateMap:  # fmt: skip
    """What the motion from one start comes to, at every point of a broadcast of parameters.

    Parameters
    ----------
    p : Parameters of any model
        Any shape.
    V, d : array_like, optional
        In place of those of ``p``.
    start : array_like, optional
        Coordinates, then rates, of the article's model x, y, x', y'; 0 where it is left out.
    t_end : float
        As for :func:`spragsym.fate`.
    backend : {"heyoka", "scipy"}, optional
    workers, progress
        As for :func:`~spragsym.rms_sweep`.
    store : path, optional
        ``*.csv``. Finished points go to ``<store>.partial`` one by one; the same call goes on from there after a kill, and loads
        the file when it is finished.

    Returns
    -------
    FateMap

    Raises
    ------
    ParameterError, ParameterTypeError
        Before the work starts. A motion that can't be followed is undecided, with the reason.

    Examples
    --------
    >>> import numpy as np
    >>> import spragsym as ss
    >>> found = ss.fate_map(ss.Parameters.article(theta0=np.radians([30.0, 42.0])), V=0.5, d=10.0)
    >>> found.kind, found.period.round(3)
    (array([1, 2], dtype=int8), array([   nan, 34.267]))
    """
    model = model_of(p)
    p.require(*p.ranges)
    p = p.given(V=V, d=d)
    inputs = {name: np.asarray(getattr(p, name), dtype=float) for name in p.ranges}
    state = tuple(state_of(model, start).tolist())
    t_end, name = as_number("t_end", t_end, POSITIVE), integrators.choose(backend, integrators.OF_ANY_MODEL)
    if store is not None and Path(store).suffix != ".csv":
        raise ParameterError(f"store = {store} does not end in .csv")
    asked = _Asked(model, state, t_end, name)
    made, key = partial(asked.made, inputs), partial(asked.key, inputs)
    return made_or_loaded(inputs, asked.records, made, MEASURED, "why", key, FateMap.save, workers, progress, store)


@dataclass(frozen=True)
class _Asked:
    """What is the same at every point."""

    model: Any
    start: tuple[float, ...]
    t_end: float
    backend: str

    def records(self, points: Sequence[tuple[float, ...]]) -> list[Record]:
        """What is said of each point, a task of its own; what makes its motion impossible is why it is undecided."""
        (values,) = points
        try:
            p = self.model.Parameters(**dict(zip(self.model.parameters, values, strict=True)))
            found = fate(p, start=self.start, t_end=self.t_end, backend=self.backend)
        except (ParameterError, ArithmeticError) as error:
            return [([float(Kind.UNDECIDED), *[float("nan")] * 5], f"{UNFOLLOWED}: {error}")]
        kind = Kind[found.kind.upper().replace("-", "_")]
        which = 1 if found.trivial == 0 else 0
        largest, width = float(found.exponents[which]), float(found.error[which])
        return [([float(kind), found.outcome.period, largest, width, found.time_scale, found.t], found.why)]

    def key(self, inputs: dict[str, FloatArray]) -> str:
        """A hash of everything that decides the bits of a map."""
        settings = {"start": self.start, "t_end": self.t_end, "backend": self.backend}
        return fingerprint(self.model, inputs, settings, "orbits")

    def made(self, inputs: dict[str, FloatArray], records: list[Record], _: Mapping[str, Any]) -> FateMap:
        """The map of these records."""
        shape = np.broadcast_shapes(*(values.shape for values in inputs.values()))
        table = np.array([values for values, _ in records], dtype=float).reshape(-1, len(MEASURED))
        columns: dict[str, Any] = {name: column.reshape(shape) for name, column in zip(MEASURED, table.T, strict=True)}
        columns["kind"] = columns["kind"].astype(np.int8)
        why = np.array([storage.plain(text) for _, text in records], dtype=np.str_).reshape(shape)
        return FateMap(inputs, self.start, self.t_end, self.backend, **columns, why=why, model=self.model)
