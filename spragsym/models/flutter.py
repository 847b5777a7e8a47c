"""Onsets of flutter of a model along one parameter, proved: with dampers and the slope of the friction law, or without."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from ..exact.interval_arrays import FloatArray
from . import stability
from .balance import Balance, Model
from .conditions import Flutter, Hopf
from .points import Found, ModelPoints, arranged, given_column, picked, ranges, search


def flutter_onsets(
    model: Model,
    p: Any,
    vary: str,
    *,
    damping: bool | None = None,
    between: Mapping[str, tuple[float, float]] | None = None,
) -> ModelPoints:
    """All onsets of flutter in contact along one parameter, the others fixed.

    Parameters
    ----------
    model : Model
    p : Parameters
        Of the model, scalars; the one that varies is not used.
    vary : str
        A parameter.
    damping : bool, optional
        True for Hopf points of the full linearization, det(λ² M + λ C + K) = 0 with dampers and slope of the friction law; False
        for (27), without C, as the article's flutter. Without it True, unless C is 0.
    between : mapping, optional
        Its range, as for :func:`spragsym.models.folds.folds`.

    Returns
    -------
    ModelPoints
        Of the kind ``"hopf"``, where a pair ± i ω crosses the imaginary axis, or ``"flutter"``, where two frequencies meet;
        ``omega`` is the frequency.

    Notes
    -----
    Source: F = 0 and Hurwitz's determinant of order 2 n − 1, or the discriminant of det(K − κ M) in κ. Points where a real pair
    ± λ has the sum 0, or two real λ meet, are roots as well and left out.
    """
    balance = Balance(model, contact=True)
    spans = ranges(model, (vary,), between or {})
    given = given_column(p, balance.parameters, (vary,))
    if damping is None:
        damping = _is_damped(balance, given, spans)
    found = search(balance, (vary,), Hopf() if damping else Flutter(), given, spans)
    omega = _frequency(balance, vary, given, found, damping)
    oscillates = np.isfinite(omega)
    kept = replace(found, roots=picked(found.roots, oscillates))
    kind = np.full(int(oscillates.sum()), "hopf" if damping else "flutter")
    return arranged(balance, (vary,), given, kept, kind, {"omega": omega[oscillates]})


def _is_damped(balance: Balance, given: FloatArray, spans: FloatArray) -> bool:
    """Whether C is not 0 at a state that is nothing special."""
    point = np.where(np.isnan(given), 0.5 * spans.sum(axis=1)[0], given)
    state = -np.linspace(0.11, 0.23, balance.n)[:, None]
    return bool(np.any(stability.linearization(balance, state, point)[1]))


def _frequency(balance: Balance, vary: str, given: FloatArray, found: Found, damping: bool) -> FloatArray:
    """ω of the pair ± i ω at each point; NaN where the pair is real."""
    middle = found.roots.middle
    point = np.repeat(given, middle.shape[1], axis=1)
    point[balance.parameters.index(vary)] = middle[-1]
    out = np.full(middle.shape[1], np.nan)
    if not out.size:
        return out
    M, C, K = (np.moveaxis(part, -1, 0) for part in stability.linearization(balance, middle[: balance.n], point))
    for i in range(out.size):
        if damping:
            roots = stability.roots(M[i], C[i], K[i])
            sums = np.abs(roots[:, None] + roots[None]) + np.where(np.eye(roots.size), np.inf, 0.0)
            one = roots[np.unravel_index(sums.argmin(), sums.shape)[0]]
            out[i] = abs(one.imag) if abs(one.imag) > abs(one.real) else np.nan
        else:
            squares = np.linalg.eigvals(np.linalg.solve(M[i], K[i])).astype(complex)
            apart = np.abs(squares[:, None] - squares[None]) + np.where(np.eye(squares.size), np.inf, 0.0)
            one = squares[np.unravel_index(apart.argmin(), apart.shape)[0]] if squares.size > 1 else np.nan
            out[i] = np.sqrt(one.real) if one.real > 0 else np.nan
    return out
