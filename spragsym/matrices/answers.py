"""Onsets of squeal and modes of models of matrices, as results."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, cast

import numpy as np
from numpy.typing import NDArray

from ..core.errors import ModelError, ParameterError
from ..core.questions import model_of
from ..display import Column
from ..models.parameters import ParameterSet, Ranges, as_number, varied_range
from ..numerics.interval_arrays import ComplexArray, FloatArray
from ..results.result import Named, Rows
from .model import MatrixModel
from .onsets import OnsetSearch, PairCrossing
from .options import MatrixOptions
from .reduction import onset_of_whole

#: Damping ratio up to which a mode counts as undamped: far above the rounding of eigenvalues.
_UNDAMPED = 1e-8


class _OfMatrices(Named, Rows):
    """A result whose columns stand in ``values``."""

    _held = "values"
    values: Mapping[str, NDArray[Any]]

    def _shown(self) -> dict[str, Any]:
        return self.data() | {"remarks": getattr(self, "remarks", ())}

    def data(self) -> dict[str, NDArray[Any]]:
        """The columns by name.

        Returns
        -------
        dict of str to array

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> m = ss.matrices(M=np.eye(1), K=[[4.0]], friction=[[0.0]])
        >>> ss.modes(m.Parameters(mu=0.0)).data()["omega"].round(6)
        array([2.])
        """
        return dict(self.values)


@dataclass(frozen=True, eq=False)
class MatrixOnsets(_OfMatrices):
    """Onsets of squeal along one parameter, a row for each, in its order: proved for the matrices
    as they are given, as floats.

    Attributes
    ----------
    vary : str
        The parameter; its values are an attribute under its name, as ``mu``.
    between : tuple of float
        The range.
    frequency, frequency_error : ndarray
        \\|Im λ\\| in rad/s, and a bound on its error.
    error : ndarray
        Bound on the error of the parameter.
    kind : ndarray of str
        ``"flutter"`` where a pair of eigenvalues passes the threshold, ``"divergence"`` where a
        real one does.
    direction : ndarray of str
        ``"up"`` where it grows faster than the threshold for larger values, ``"down"`` for smaller.
    partner_hz : ndarray
        Frequency in Hz of the mode with which it merges, by floats: the one that bends its
        eigenvalue most. NaN for divergence.
    full_model : ndarray
        Of a reduced model: the parameter at the same onset of the model before its reduction,
        computed from the two modes that are nearest; NaN where it is lost.
    threshold : float
        Growth in 1/s above which it is squeal.
    complete : bool
        Whether these are all onsets in the range.
    undecided : ndarray
        Ends of the parts of the range on which nothing is proved, shape (parts, 2).
    growing : ndarray
        Rows low, high, count: on each part of the range so many eigenvalues grow faster than the
        threshold, a pair being two: proved.
    remarks : tuple of str
        The threshold if it is a default, and what is undecided.
    """

    schema = (
        Column("{a}", "{a}", "the parameter"),
        Column("frequency", "1/s", "frequency in rad/s"),
        Column("frequency_error", "1/s", "bound on the error of the frequency"),
        Column("frequency_hz", "Hz", "frequency in Hz"),
        Column("kind", "1", "flutter or divergence"),
        Column("direction", "1", "the parameter's direction in which it sets in"),
        Column("partner_hz", "Hz", "frequency in Hz of the mode that it merges with"),
        Column("error", "1", "bound on the error of the parameter"),
        Column("full_model", "1", "the parameter in the model before its reduction"),
    )

    parameters: Any
    vary: str
    between: tuple[float, float]
    threshold: float
    complete: bool
    undecided: FloatArray
    growing: FloatArray
    remarks: tuple[str, ...]
    values: Mapping[str, NDArray[Any]] = field(repr=False)

    @cached_property
    def eigenvalues(self) -> tuple[FloatArray, ComplexArray]:
        """Eigenvalues with Im λ ≥ 0 at 241 values of the parameter, by LAPACK: the value of each,
        and λ in 1/s.
        """
        pencil = self.parameters.model.pencil(self.parameters, self.vary)
        values = np.linspace(*self.between, 241)
        each = [pencil.eigenbasis(float(value))[0] for value in values]
        return np.repeat(values, [len(one) for one in each]), np.concatenate(each)


def flutter_onsets(
    p: ParameterSet,
    vary: str | None = None,
    *,
    between: Ranges | None = None,
    threshold: float | None = None,
    options: MatrixOptions | None = None,
    **others: object,
) -> MatrixOnsets:
    """The onsets of a model of matrices: all values at which an eigenvalue passes the threshold.

    ``vary`` is ``mu`` by default, over [0, 1]. The default of ``threshold`` is 0 if all modes are
    damped without friction, else a share of the model's own damping, which a remark says.
    """
    if others:
        raise ParameterError(
            f"{next(iter(others))} is nothing of matrices; give vary, between, threshold, options"
        )
    model = cast(MatrixModel, p.model)
    name = "mu" if vary is None else vary
    model.require_parameter(name)
    model.require_small()
    span = (
        (0.0, 1.0)
        if between is None and name == "mu"
        else varied_range(name, between, model.Parameters.ranges[name])
    )
    pencil = model.pencil(p, name)
    remarks = list[str]()
    if threshold is None:
        # The model's own damping is that without friction.
        own = p.replace(**{name: span[0]}).replace(mu=0.0)
        growth, said = _default(model.pencil(own, "mu").eigenbasis(0.0)[0])
        remarks += said
    else:
        growth = as_number("threshold", threshold)
    found = OnsetSearch(pencil, span, growth, options or MatrixOptions()).run()
    rows = [
        one
        for one in found.crossings
        if span[0] - one.proof.error <= one.value <= span[1] + one.proof.error
    ]
    for one in rows:
        if not span[0] + one.proof.error < one.value < span[1] - one.proof.error:
            remarks.append(
                f"the onset at {one.value:.10g} lies at an end of the range: on which side of the "
                "end is not decided"
            )
    beyond = [one for one in rows if one.proof.frequency > 2.0 * np.pi * model.highest_hz]
    rows = [one for one in rows if one not in beyond]
    full = _in_full(p, name, growth, rows)
    if model.full is not None:
        remarks.append(
            f"reduced from {model.full.size} coordinates, and meant up to {model.highest_hz:.4g} "
            f"Hz: {len(beyond)} onsets beyond that are left out; full_model has those of all "
            "coordinates, computed from each onset"
        )
    if found.undecided:
        gaps = np.array(found.undecided)
        share = np.diff(gaps).sum() / (span[1] - span[0])
        remarks.append(
            f"undecided in {len(gaps)} parts, {share:.1e} of the range, between {gaps.min():.10g} "
            f"and {gaps.max():.10g}"
        )
    proofs = [one.proof for one in rows]
    frequency = np.array([one.frequency for one in proofs])
    values = {
        name: np.array([one.value for one in rows]),
        "frequency": frequency,
        "frequency_error": np.array([one.frequency_error for one in proofs]),
        "frequency_hz": frequency / (2.0 * np.pi),
        "kind": np.array(["flutter" if one.frequency else "divergence" for one in proofs], "<U10"),
        "direction": np.array(["up" if one.direction > 0 else "down" for one in proofs], "<U4"),
        "partner_hz": np.array([one.partner / (2.0 * np.pi) for one in rows]),
        "error": np.array([one.error for one in proofs]),
    }
    if model.full is not None:
        values["full_model"] = full
    return MatrixOnsets(
        parameters=p,
        vary=name,
        between=span,
        threshold=growth,
        complete=not found.undecided,
        undecided=np.array(found.undecided).reshape(-1, 2),
        growing=np.array([(one.low, one.high, one.count) for one in found.merged()]).reshape(-1, 3),
        remarks=tuple(remarks),
        values=values,
    )


def _in_full(p: ParameterSet, name: str, growth: float, rows: list[PairCrossing]) -> FloatArray:
    """The onsets of a reduced model in the one before, or NaN."""
    model, found = cast(MatrixModel, p.model), np.full(len(rows), np.nan)
    if model.full is None:
        return found
    own = model.pencil(p, name)
    held = {one: p[one] for one in model.parameters}
    whole = model.full.pencil(model.full.Parameters(**held), name)
    for place, one in enumerate(rows):
        proof, near = one.proof, complex(growth, one.proof.frequency)
        shapes = np.vstack([part.nearest(one.value, near)[1] for part in (own, own.transposed)])
        space = model.basis @ np.hstack([shapes.real.T, shapes.imag.T])
        guess = one.value, proof.frequency, proof.direction
        found[place] = onset_of_whole(whole, growth, guess, space)
    return found


def _default(values: ComplexArray) -> tuple[float, list[str]]:
    """The threshold for eigenvalues without friction, and a remark on it."""
    size = np.abs(values)
    moving = size > 1e-6 * size.max()
    rate, size = -values.real[moving], size[moving]
    ratio = rate / size
    neutral = np.abs(ratio) <= _UNDAMPED
    damped = ratio > _UNDAMPED
    if not neutral.any() and moving.all():
        return 0.0, []
    if damped.any():
        growth = 1e-3 * float(np.median(rate[damped]))
        why = "a thousandth of the median decay of the damped modes, as some modes are undamped"
    else:
        growth = 1e-4 * float(size.min())
        why = "1e-4 of the lowest frequency, as the model has no damping"
    return growth, [f"growth above {growth:.3g} 1/s is squeal: {why}; threshold= says another"]


@dataclass(frozen=True, eq=False)
class Modes(_OfMatrices):
    """Modes of a model of matrices, a row for each, by frequency; computed by LAPACK, not proved.

    Columns ``growth_by_NAME`` and ``frequency_by_NAME`` are the derivatives by each parameter, in
    1/s and Hz.

    Attributes
    ----------
    frequency_hz : ndarray
        Im λ/2π; 0 for a real eigenvalue.
    damping_ratio : ndarray
        −Re λ/\\|λ\\|; negative where the mode grows.
    growth : ndarray
        Re λ in 1/s.
    omega : ndarray
        Im λ in rad/s.
    shapes : ndarray
        The eigenvectors, complex, one a column.
    """

    schema = (
        Column("frequency_hz", "Hz", "frequency"),
        Column("damping_ratio", "1", "damping ratio; negative where it grows"),
        Column("growth", "1/s", "growth"),
        Column("omega", "1/s", "frequency in rad/s"),
    )

    parameters: Any
    values: Mapping[str, NDArray[Any]] = field(repr=False)
    shapes: ComplexArray = field(repr=False)

    @cached_property
    def sensitivities(self) -> dict[str, ComplexArray]:
        """dλ/dp of each parameter by its name: its real part is that of the growth."""
        return {
            name: self.values[f"growth_by_{name}"]
            + 2j * np.pi * self.values[f"frequency_by_{name}"]
            for name in self.parameters.model.parameters
        }


def modes(p: ParameterSet) -> Modes:
    """Modes of a model of matrices: frequencies, damping ratios, and what changes them.

    Parameters
    ----------
    p : Parameters
        Of a model made by :func:`spragsym.matrices`, scalars.

    Returns
    -------
    Modes

    Raises
    ------
    ModelError
        For a page; its states have frequencies and growth of their own.
    ParameterError
        For a parameter that is missing or an array.

    Notes
    -----
    Source: dλ/dp = −yᵀ (λ ∂C/∂p + ∂K/∂p) x / yᵀ (2 λ M + C) x, with left and right eigenvectors.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> none = np.zeros((2, 2))
    >>> m = ss.matrices(M=np.eye(2), K=np.diag([4.0, 9.0]), friction=none, rayleigh=(0.1, 0))
    >>> found = ss.modes(m.Parameters(mu=0.0))
    >>> found.omega.round(3), found.growth.round(3), found.damping_ratio.round(4)
    (array([1.999, 3.   ]), array([-0.05, -0.05]), array([0.025 , 0.0167]))
    """
    model_of(p)  # refuses what is no set of parameters
    model = p.model
    if not isinstance(model, MatrixModel):
        raise ModelError(
            "modes is asked of matrices, made by spragsym.matrices; of a page, equilibria has "
            "growth and stability of each state"
        )
    model.require_small()
    t, pencil = p.scalars("mu")[0], model.pencil(p, "mu")
    values, vectors = pencil.eigenbasis(t)
    order = np.lexsort((values.real, values.imag))
    values, vectors = values[order], vectors[:, order]
    others, left = pencil.transposed.eigenbasis(t)
    left = left[:, np.abs(values[:, None] - others).argmin(axis=1)]
    D, _ = pencil.at(t)
    norm = np.einsum("ik,ik->k", left, pencil.mass @ vectors * (2.0 * values) + D @ vectors)
    columns: dict[str, FloatArray] = {
        "frequency_hz": values.imag / (2.0 * np.pi),
        "damping_ratio": -values.real / np.maximum(np.abs(values), 1e-300),
        "growth": values.real,
        "omega": values.imag,
    }
    for name in model.parameters:
        own = model.pencil(p, name)
        change = (own.damping_slope @ vectors) * values + own.stiffness_slope @ vectors
        slope = -np.einsum("ik,ik->k", left, change) / norm
        columns[f"growth_by_{name}"] = slope.real
        columns[f"frequency_by_{name}"] = slope.imag / (2.0 * np.pi)
    return Modes(p, columns, vectors)
