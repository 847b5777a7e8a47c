"""A state followed as one parameter moves, with its jumps: one class for every model, however it was followed."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.lib.mixins import NDArrayOperatorsMixin
from numpy.typing import NDArray

from ..display import Shown
from ..models.parameters import FloatArray
from ..numerics.interval_arrays import Int8Array, Shape
from .equilibria import Equilibria, Stability
from .result import OfStates, Result, Rows


@dataclass(frozen=True)
class Jump(Result):
    """A state that vanishes at a fold, leaves the contact or runs to infinity, and the one that takes its place.

    ``before`` and ``after`` say where they are, by the names of ``Path.columns``: numbers, angles in radians.
    """

    value: float  #: of the parameter, at the fold, on the border or in the limit
    kind: str  #: ``"fold"``, ``"pitchfork"``, ``"border"`` where the state leaves the contact, or ``"infinity"``
    before: Mapping[str, float]
    after: Mapping[str, float]
    stability_after: Stability
    error: float  #: bound on the error of ``value``


#: Columns of the full linearization, as of :class:`spragsym.Equilibria`.
_OF_STATES = ("growth", "growth_sign", "damped")


@dataclass(frozen=True, eq=False)
class Path(OfStates, Rows):
    """States along the values of the parameter, in the order in which they are passed, and the jumps between them.

    Each coordinate is an attribute under its own name, of the shape of ``values``; so are the direction and the length of each
    inclined spring, as of :class:`spragsym.Equilibria`. Angles are radians. ``stability`` has the codes of (27); ``growth``,
    ``growth_sign`` and ``damped`` are those of the full linearization, made when they are asked for.
    """

    held_in = "places"
    table_codes = ("stability", Stability)

    parameters: Any
    vary: str
    values: FloatArray
    stability: Int8Array
    jumps: tuple[Jump, ...]
    places: Mapping[str, FloatArray] = field(repr=False)
    _along: Equilibria = field(repr=False)

    @property
    def offered(self) -> tuple[str, ...]:
        return (*super().offered, *_OF_STATES)

    def _asked(self, name: str) -> Any:
        return getattr(self._along, name)[:, 0] if name in _OF_STATES else super()._asked(name)


@dataclass(frozen=True, eq=False)
class LowestEnd(Shown, NDArrayOperatorsMixin):
    """Where the state that is followed ends first over a range of another parameter; a number, or an array, as ``value``.

    Numbers for one point, arrays of the shape of the parameters for many; angles are radians.

    Attributes
    ----------
    vary, over : str
        The parameter along which the state is followed, and the one over whose range.
    value, where : float or ndarray
        Of ``vary`` and of ``over``; both are attributes under these names, too, as ``mu0`` and ``theta0``.
    kind : str or ndarray of str
        ``"cusp"``; ``"turn"`` where a curve of folds turns back in ``vary``; ``"border"`` where the state leaves the contact;
        ``"end"`` where it is lowest at an end of the range of ``over``; ``"infinity"`` where the state runs to
        infinity; empty where the state ends nowhere: then ``value`` is
        infinite and ``where`` NaN; ``"undecided"`` where nothing is known above ``value``, below which the state does not end.
    error : float or ndarray
        Bound on \\|error\\| / max(1, \\|value\\|) of both.
    complete : bool
        Whether all of this is proved; otherwise ``remarks`` say what is not.
    """

    vary: str
    over: str
    value: Any
    where: Any
    kind: Any
    error: Any
    complete: bool = True
    remarks: tuple[str, ...] = ()

    @property
    def shape(self) -> Shape:
        """Shape of the parameters."""
        return np.shape(self.value)

    def __getattr__(self, name: str) -> Any:
        names = {self.__dict__.get("vary"): "value", self.__dict__.get("over"): "where"}
        if name not in names:
            raise AttributeError(f"{type(self).__name__!r} has no attribute {name!r}")
        return self.__dict__[names[name]]

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> NDArray[Any]:
        return np.array(self.value, dtype=dtype, copy=copy)

    def __array_ufunc__(self, ufunc: Any, method: str, *inputs: Any, **options: Any) -> Any:
        return getattr(ufunc, method)(*(one.value if isinstance(one, LowestEnd) else one for one in inputs), **options)

    def __float__(self) -> float:
        return float(self.value)

    def __round__(self, digits: int | None = None) -> Any:
        return round(self.value, digits)

    def __format__(self, spec: str) -> str:
        return format(self.value, spec)

    def __str__(self) -> str:
        return str(self.value)

    def __len__(self) -> int:
        return len(self.value)

    def __getitem__(self, index: Any) -> LowestEnd:
        some = {name: getattr(self, name)[index] for name in ("value", "where", "kind", "error")}
        return replace(self, **{name: part if np.ndim(part) else part.item() for name, part in some.items()})
