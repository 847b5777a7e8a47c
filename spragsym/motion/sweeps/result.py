"""The result of a sweep: made of the records of its motions, written to a file and loaded from it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ...files import storage
from ...files.journal import Record
from ...models.parameters import FloatArray, degrees
from ...numerics.interval_arrays import Int8Array, Shape
from ...results.named_columns import Columns
from ...statics.search import rest_index
from .. import integrators
from ..regimes import Outcome, Regime
from . import code
from .measure import Settings, reported


@dataclass(frozen=True, eq=False)
class Sweep(Columns, held_in="measured"):
    """Results of a sweep; every array has the common shape of the inputs. NaN where a motion failed.

    Attributes
    ----------
    inputs : dict of str to ndarray
        The model's parameters and initial state as they were given, which broadcast together; for the article's θ₀, μ₀, κ, α,
        σ, β, V, d, x0, y0, vx0, vy0. In what follows x is the model's first coordinate, and y stands for every other one.
    measured : dict of str to ndarray
        What follows, up to ``distance``; each is an attribute of its name.
    rms, spread, largest, mean, mean_y : ndarray
        Of x after the transient, over L_0: root mean square about zero, and about the mean; largest \\|x\\|;
        means of x and y.
    contact_lost, slip_reversed : ndarray
        How often, after the transient.
    period, cycle_mean, cycle_rms : ndarray
        Of the cycle that the motion is on or approaches: period, mean of x, and root mean square of x about zero, over
        one whole period. NaN for no cycle. Unlike ``mean`` and ``rms`` they depend on no window.
    cycle_x, cycle_y, cycle_vx, cycle_vy : ndarray
        State of that cycle where its x is largest, or 0 if x turns around; NaN for no cycle.
    rest_x, rest_y : ndarray
        Where the equilibrium is that the motion is at or approaches; NaN for none.
    rate, distance : ndarray
        In the long run a motion nears what it settles to or approaches as exp(−rate τ); ``distance`` is what is left of the
        way at ``t_end``, relative to the reach of a cycle, or over L_0 for rest. See :class:`~spragsym.motion.regimes.Outcome`.
    regime : ndarray of int8
        Codes of :class:`Regime`.
    equilibrium : ndarray of int8
        For ``Regime.EQUILIBRIUM`` and ``APPROACHES_EQUILIBRIUM`` its slot among ``equilibria(p)`` in contact at the friction
        μ(V); −1 otherwise.
    reason : ndarray of str
        Why a motion failed.
    model : Model
        The model.
    """

    table_codes: ClassVar[Mapping[str, type[Regime]]] = {"regime": Regime}

    inputs: dict[str, FloatArray]
    t_end: float
    transient: float
    rtol: float
    backend: str
    max_steps: int
    measured: dict[str, FloatArray]
    regime: Int8Array
    equilibrium: Int8Array
    reason: NDArray[np.str_]
    model: Any

    def outcome(self, index: Any) -> Outcome:
        """What one motion comes to."""
        names = (*self.model.coordinates, *self.model.rates)
        rest, cycle = (
            tuple(float(self.measured[f"{what}_{name}"][index]) for name in places)
            for what, places in (("rest", self.model.coordinates), ("cycle", names))
        )
        known = {name: float(self.measured[name][index]) for name in ("rate", "distance", "period", "cycle_mean", "cycle_rms")}
        regime, which = Regime(int(self.regime[index])), int(self.equilibrium[index])
        at_rest, on_cycle = not np.isnan(rest[0]), not np.isnan(cycle[0])
        return Outcome(regime, which, rest if at_rest else (), cycle=cycle if on_cycle else (), names=names, **known)

    def to_dataset(self) -> Any:
        """An ``xarray.Dataset`` with units and provenance (extra ``sweep``).

        An axis along which one input alone varies is named after it; others are ``axis_0``, ``axis_1``, …. θ₀ is there
        in radians and, as ``theta0_deg``, in degrees.
        """
        dims = _dimensions(self.inputs, self.rms.shape)
        # A single number stays one, an axis becomes a coordinate, and a table keeps the full shape.
        inputs = {
            name: ((), float(values.flat[0])) if values.size == 1
            else (name.removesuffix("_deg"), values.ravel()) if name.removesuffix("_deg") in dims
            else (dims, np.broadcast_to(values, self.rms.shape).copy())
            for name, values in with_degrees(self.model, self.inputs).items()
        }  # fmt: skip
        columns = {**self.measured, "regime": self.regime, "equilibrium": self.equilibrium, "reason": self.reason.astype(object)}
        results = {name: (dims, values) for name, values in columns.items()}
        return storage.dataset(results, inputs, self._attributes(), self.model.quantities, self.table_codes)

    def _save_columns(self, path: Path) -> None:
        """Write netCDF to ``*.nc`` (extra ``sweep``), or one line a motion to ``*.csv``."""
        storage.write(path, self.to_dataset, self._columns, self._attributes(), self.model.quantities)

    def _columns(self) -> dict[str, NDArray[Any]]:
        found: dict[str, NDArray[Any]] = {
            **self.measured,
            "regime": self.regime,
            "equilibrium": self.equilibrium,
            "reason": self.reason,
        }
        inputs = with_degrees(self.model, self.inputs)
        return {name: np.broadcast_to(values, self.rms.shape) for name, values in inputs.items()} | found

    def _attributes(self) -> dict[str, Any]:
        settings = {name: getattr(self, name) for name in ("t_end", "transient", "rtol", "backend", "max_steps")}
        key = fingerprint(self.model, self.inputs, settings)
        return {**storage.provenance(), "model": self.model.name, **settings, "fingerprint": key}


def fingerprint(model: Any, inputs: Mapping[str, FloatArray], settings: Mapping[str, Any], *rooms: str) -> str:
    """A hash of everything that decides the bits of a result, the code of further ``rooms`` too."""
    decides = {
        "integrator": integrators.version(settings["backend"]), "code": code.digest(*rooms),
        "numpy": np.__version__,  # its eigenvalues tell what is approached
        "model": model.name, "files": model.about["files"], "page": model.about["source"], "own": sorted(model.closed),
    }  # fmt: skip
    return storage.fingerprint(inputs, {**settings, **decides})


def with_degrees(model: Any, inputs: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """The inputs, every angle in degrees beside it in radians."""
    known = {}
    for name, values in inputs.items():
        known[name] = values
        if name in model.about["angles"]:
            known[f"{name}_deg"] = np.vectorize(degrees, otypes=[np.float64])(values)
    return known


def made_of(
    model: Any, inputs: dict[str, FloatArray], settings: Settings, records: list[Record], columns: Mapping[str, Any]
) -> Sweep:  # fmt: skip
    """The sweep of these records; of a file's columns the slots of equilibria, which are searched for otherwise."""
    names, shape = (*reported(model.coordinates, model.rates), "regime"), np.broadcast_shapes(*(v.shape for v in inputs.values()))
    table = np.array([values or [np.nan] * len(names) for values, _ in records]).reshape(-1, len(names))
    measured = {name: column.reshape(shape) for name, column in zip(names, table.T, strict=True)}
    regime = measured.pop("regime")
    if "equilibrium" in columns:
        which = np.asarray(columns["equilibrium"]).astype(np.int8).reshape(shape)
    else:
        p = model.Parameters(**{name: inputs[name] for name in model.parameters})
        which = rest_index(p, np.array([measured[f"rest_{name}"] for name in model.coordinates]))
    reason = np.array([reason and storage.plain(reason) for _, reason in records], dtype=np.str_).reshape(shape)
    regime = np.where(np.isnan(regime), Regime.FAILED, regime).astype(np.int8)
    return Sweep(inputs, **vars(settings), measured=measured, regime=regime, equilibrium=which, reason=reason, model=model)


def _dimensions(inputs: dict[str, FloatArray], shape: Shape) -> tuple[str, ...]:
    """A name for every axis: the input that alone varies along it, and along no other axis."""

    def axes(values: FloatArray) -> tuple[int, ...]:
        lead = len(shape) - values.ndim
        return tuple(lead + i for i, size in enumerate(values.shape) if size > 1)

    along = {name: axes(values) for name, values in inputs.items()}
    names = []
    for axis in range(len(shape)):
        candidates = [name for name, varied in along.items() if axis in varied]
        alone = len(candidates) == 1 and along[candidates[0]] == (axis,)
        names.append(candidates[0] if alone else f"axis_{axis}")
    return tuple(names)
