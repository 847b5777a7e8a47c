"""What motions come to over a grid of parameters: each point by the rules of :func:`spragsym.fate`, resumable."""

from __future__ import annotations

import os
from collections.abc import Mapping
from contextlib import closing
from dataclasses import dataclass
from enum import IntEnum
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..display import Result
from ..dynamics import integrators
from ..errors import ConvergenceError, ModelError, ParameterError, TargetError
from ..files import storage
from ..files.journal import Record, clear, journal
from ..parameters import FINITE, POSITIVE, FloatArray, Parameters, ParameterSet, as_number, common_shape, degrees
from ..sweeps import code
from ..sweeps import workers as processes
from ..sweeps.many import advance
from ..sweeps.workers import Workers
from .sprag import SPRAG
from .verdicts import fate_of

#: Numbers of a record, in this order.
MEASURED = ("kind", "period", "exponent", "exponent_error", "time_scale", "t")

#: What a file says of the results.
EXPLAINED = {
    **storage.QUANTITIES,
    "kind": ("1", "0 undecided, 1 rest, 2 cycle, 3 lift-off, 4 chaotic"),
    "exponent": ("sqrt(k_c/m)", "largest Lyapunov exponent but the trivial one"),
    "exponent_error": ("sqrt(k_c/m)", "half-width of its 95 % interval; 0 where eigenvalues or multipliers give it"),
    "time_scale": ("sqrt(m/k_c)", "on which deviations die out at steady sliding"),
    "t": ("sqrt(m/k_c)", "how long the motion was followed"),
    "why": ("1", "what decides the kind, or would"),
}


class Kind(IntEnum):
    """What a motion comes to, as :attr:`spragsym.Fate.kind` has it in words."""

    UNDECIDED = 0
    REST = 1
    CYCLE = 2
    LIFT_OFF = 3
    CHAOTIC = 4


@dataclass(frozen=True, eq=False)
class FateMap(Result):
    """What motions come to; every array has the common shape of the parameters.

    Attributes
    ----------
    inputs : dict of str to ndarray
        The parameters as they were given, which broadcast together.
    t_end : float
    kind : ndarray of int8
        0 undecided, 1 rest, 2 cycle, 3 lift-off, 4 chaotic.
    period : ndarray
        Of the cycle; NaN for none.
    exponent, exponent_error : ndarray
        The largest Lyapunov exponent but the trivial one, and the half-width of its 95 % interval.
    time_scale : ndarray
        On which deviations die out at steady sliding.
    t : ndarray
        How long the motion was followed.
    why : ndarray of str
        What decides the kind, or would.
    """

    inputs: dict[str, FloatArray]
    t_end: float
    kind: NDArray[np.int8]
    period: FloatArray
    exponent: FloatArray
    exponent_error: FloatArray
    time_scale: FloatArray
    t: FloatArray
    why: NDArray[np.str_]

    def count(self) -> dict[str, int]:
        """How many points are of each kind."""
        return {kind.name.lower().replace("_", "-"): int(np.count_nonzero(self.kind == kind)) for kind in Kind}

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write ``*.csv``: one line a point."""
        storage.write(Path(path), dict, self._columns, storage.provenance() | {"t_end": self.t_end}, EXPLAINED)

    def _columns(self) -> dict[str, NDArray[Any]]:
        shape = self.kind.shape
        given = {name: np.broadcast_to(values, shape).ravel() for name, values in self.inputs.items()}
        given["theta0_deg"] = np.array([degrees(value) for value in given["theta0"]])
        return given | {name: getattr(self, name).ravel() for name in (*MEASURED, "why")}


def fate_map(
    p: Parameters, *, V: Any = None, d: Any = None, start: Any = (0.0, 0.0, 0.0, 0.0), t_end: float = 40_000.0,
    backend: str | None = None, workers: Workers = 1, progress: bool = False, store: str | os.PathLike[str] | None = None,
) -> FateMap:  # fmt: skip
    """What the motion from one start comes to, at every point of a broadcast of parameters.

    Parameters
    ----------
    p : Parameters
        Any shape.
    V, d : array_like, optional
        In place of those of ``p``.
    start : array_like of 4 numbers
        x, y, x', y'.
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
    if isinstance(p, ParameterSet) and not isinstance(p, Parameters):
        raise ModelError(f"p = {type(p).__name__}: a map is of the article's model; model.fate(p) has the verdict on one motion")
    p.require()  # of what is no set, too, its error
    p = p.given(V=V, d=d)
    inputs = {name: np.asarray(getattr(p, name), dtype=float) for name in p.ranges}
    shape = common_shape({name: values.shape for name, values in inputs.items()})
    state = tuple(as_number("start", value, FINITE) for value in start)
    t_end, name = as_number("t_end", t_end, POSITIVE), integrators.choose(backend, integrators.OF_ANY_MODEL)
    columns = [np.broadcast_to(values, shape).ravel().tolist() for values in inputs.values()]
    points = dict(enumerate(zip(*columns, strict=True)))
    work = partial(_record, state, t_end, name)

    def records(done: dict[int, Record], keep: Any) -> FateMap:
        left = {i: point for i, point in points.items() if i not in done}
        with advance(progress, len(points), len(done)) as step, closing(processes.results(workers, work, left)) as found:
            for i, record in found:
                keep(i, record)
                step()
        return _made(inputs, shape, t_end, [done[i] for i in points])

    if store is None:
        kept: dict[int, Record] = {}
        return records(kept, kept.__setitem__)
    target = storage.resolved(store)
    if target.suffix != ".csv":
        raise ParameterError(f"store = {target} does not end in .csv")
    settings = {"start": state, "t_end": t_end, "integrator": integrators.version(name), "code": code.digest("cycles")}
    key = storage.fingerprint(inputs, settings)
    if target.is_file():
        clear(target, key, len(points))
        return _loaded(target, inputs, shape, t_end)
    storage.check_target(target, 100_000 + 1000 * len(points))
    with journal(target, key, len(points)) as (done, keep):
        found = records(done, keep)
        found.save(target)
    return found


def _record(start: tuple[float, ...], t_end: float, backend: str, values: tuple[float, ...]) -> Record:
    """What is said of one point; what makes its motion impossible is why it is undecided."""
    try:
        found = fate_of(SPRAG, values, np.array(start), t_end, backend)
    except (ConvergenceError, ParameterError, ArithmeticError) as error:
        return [float(Kind.UNDECIDED), *[float("nan")] * 5], f"the motion can't be followed: {error}"
    kind = Kind[found.kind.upper().replace("-", "_")]
    trivial = int(np.argmin(np.abs(found.exponents))) if kind in (Kind.CYCLE, Kind.CHAOTIC, Kind.UNDECIDED) else -1
    across = [i for i in range(len(found.exponents)) if i != trivial]
    largest, width = float(found.exponents[across[0]]), float(found.error[across[0]])
    return [float(kind), found.outcome.period, largest, width, found.time_scale, found.t], found.why


def _made(inputs: dict[str, FloatArray], shape: tuple[int, ...], t_end: float, records: list[Record]) -> FateMap:
    table = np.array([values for values, _ in records], dtype=float).reshape(-1, len(MEASURED))
    columns: dict[str, Any] = {name: column.reshape(shape) for name, column in zip(MEASURED, table.T, strict=True)}
    columns["kind"] = columns["kind"].astype(np.int8)
    why = np.array([storage.plain(text) for _, text in records], dtype=np.str_).reshape(shape)
    return FateMap(inputs, t_end, **columns, why=why)


def _loaded(path: Path, inputs: Mapping[str, FloatArray], shape: tuple[int, ...], t_end: float) -> FateMap:
    """The map that a file holds, if it is this one."""
    columns, attributes = storage.read(path)
    given = {name: np.broadcast_to(values, shape).ravel() for name, values in inputs.items()}
    same = len(columns.get("why", ())) == len(given["theta0"]) and all(
        np.array_equal(np.asarray(columns[name], dtype=float), values) for name, values in given.items()
    )
    if not same or float(attributes.get("t_end", "nan")) != t_end:
        raise TargetError(f"{path} exists and holds something else; remove it, or give another path")
    numbers = np.array([np.asarray(columns[name], dtype=float) for name in MEASURED]).T.tolist()
    return _made(dict(inputs), shape, t_end, list(zip(numbers, (str(text) for text in columns["why"]), strict=True)))
