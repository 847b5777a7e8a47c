"""Many motions of a model: RMS and final regime over parameters and initial states."""

from __future__ import annotations

import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..dynamics.integrators import OF_ANY_MODEL
from ..dynamics.motions import Motions
from ..dynamics.problem import MAX_STEPS
from ..dynamics.regimes import SETTLED
from ..errors import ParameterError
from ..files import storage
from ..parameters import FloatArray, ParameterSet
from ..sweeps import code
from ..sweeps.many import Plan, carried_out, settings_of
from ..sweeps.measure import Settings, motions_at
from ..sweeps.result import Results, Sweep
from ..sweeps.workers import Workers
from .describe import explained
from .equilibria import index_of
from .field import field_of
from .trajectory import check_start, start_of

if TYPE_CHECKING:
    from .model import Model


@dataclass(frozen=True, eq=False)
class ModelSweep(Sweep):
    """Results of a sweep of a model's motions; as :class:`~spragsym.Sweep`.

    ``x`` stands for the first coordinate and ``y`` for the second. The inputs are the model's parameters and initial state.
    ``equilibrium`` is the slot among the model's equilibria in contact at the friction μ(V).

    Attributes
    ----------
    model : Model
        The model.
    """

    model: Any = None

    @property
    def angles(self) -> tuple[str, ...]:
        return tuple(self.model.about["angles"])

    @cached_property
    def explained(self) -> Mapping[str, tuple[str, str]]:
        return {**storage.QUANTITIES, **explained(self.model.about)}

    @property
    def how(self) -> Results:
        return _ModelResults(self.model)

    def _attributes(self) -> dict[str, Any]:
        return {"model": self.model.name, **super()._attributes()}


@dataclass(frozen=True)
class _ModelResults(Results):
    model: Model

    def identity(self) -> dict[str, Any]:
        about = self.model.about
        return {"model": about["name"], "files": about["files"], "page": about["source"], "code": code.digest("models")}

    def equilibrium(self, inputs: dict[str, FloatArray], x: FloatArray, y: FloatArray) -> NDArray[np.int8]:
        out = np.full(x.shape, -1, dtype=np.int8)
        rows = np.isfinite(x)
        if rows.any():
            given = np.array([np.broadcast_to(inputs[name], x.shape)[rows] for name in self.model.parameters])
            states = np.array([column[rows] for column in (x, y)][: len(self.model.coordinates)])
            out[rows] = index_of(self.model, given, states, SETTLED)
        return out

    def sweep(self, inputs: dict[str, FloatArray], settings: Settings, results: dict[str, Any]) -> Sweep:
        return ModelSweep(inputs, **vars(settings), **results, model=self.model)


def motions_of(
    model: Model, settings: Settings, points: Sequence[tuple[float, ...]]
) -> tuple[Motions | None, dict[int, Exception]]:
    """The motions of points of a sweep, and why points have none."""
    count, errors = len(model.parameters), dict[int, Exception]()
    constants, starts = [], []
    for i, point in enumerate(points):
        p = model.Parameters(**dict(zip(model.parameters, point[:count], strict=True)))
        values, start = tuple(float(value) for value in model.arguments(p, "motion")), point[count:]
        try:
            check_start(model, values, start)
        except ParameterError as error:
            errors[i] = error
            continue
        constants.append(values)
        starts.append(start)
    return motions_at(settings, constants, starts, field_of=partial(field_of, model)), errors


def rms_sweep(
    model: Model,
    p: ParameterSet,
    *,
    t_end: float = 2000.0,
    transient: float | None = None,
    rtol: float = 1e-10,
    backend: str | None = None,
    max_steps: int = MAX_STEPS,
    workers: Workers = 1,
    progress: bool = False,
    store: str | os.PathLike[str] | None = None,
    **single: ArrayLike,
) -> Sweep:
    """Simulate every point of a broadcast; see :meth:`spragsym.Model.rms_sweep`."""
    p.require(*model.parameters)
    inputs = {**{name: getattr(p, name) for name in model.parameters}, **start_of(model, None, single)}
    settings = settings_of(t_end, transient, rtol, backend, max_steps, OF_ANY_MODEL)
    return carried_out(Plan(inputs, settings, partial(motions_of, model), _ModelResults(model)), workers, progress, store)
