"""Dampers of a brake from its modal damping ratio."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

import numpy as np

from ..core.errors import ParameterError
from ..models.load import WITH_DAMPERS
from ..models.parameters import FloatArray, Range
from ..models.quantities import Quantities
from .example import example_of
from .units import Measured

#: Damping ratios that are allowed.
RATIO = Range(0.0, 1.0)


def modal_dampers(
    kind: Quantities, measured: Mapping[str, Measured], ratio: float
) -> dict[str, Measured]:
    """Dampers with which all modes of the unloaded mechanism have the same damping ratio.

    Parameters
    ----------
    kind : Quantities
        The quantities of the model.
    measured : mapping of str to Measured
        All of them except the dampers.
    ratio : float
        The damping ratio ζ.

    Raises
    ------
    ParameterError
        If the model has no dampers, or they cannot give all modes this ratio.

    Notes
    -----
    Source: C = 2 ζ M (M⁻¹ K)^½, by which det(λ² M + λ C + K) = ∏ (λ² + 2 ζ ω_i λ + ω_i²), with M
    and K where all coordinates are 0, in contact and without friction; C is linear in the dampers.
    For the model ``damped``, with S = √(K_xx + K_yy + 2 √det K), that is c_s = 2 ζ √m k/S, c_x =
    2 ζ √m (k_x + √det K)/S and c_y = 2 ζ √m (k_y + k_c + √det K)/S.

    Examples
    --------
    >>> from spragsym.models.quantities import quantities
    >>> si = {"m": 2.0, "k": 800.0, "N_0": 1.0, "mu_s": 0.5, "v_s": 0.1, "V": 1.0}
    >>> oscillator = {name: Measured(one, one, one, "") for name, one in si.items()}
    >>> round(modal_dampers(quantities("stick_slip"), oscillator, 0.01)["c"].value, 12)
    0.8
    """
    names, size = kind.dampers, len(kind.coordinates)
    subject = f"damping_ratio = {ratio:g}: the model {kind.model.name}"
    values = {name: one.value for name, one in measured.items()}
    for name in names:
        if name in values:
            raise ParameterError(
                f"damping_ratio = {ratio:g}: {name} is given too; leave one of the two out"
            )
    if not names:
        raise ParameterError(
            f"{subject} has no dampers; add them to its page, or leave this line out"
        )
    none = dict.fromkeys(names, 0.0)
    M, C, K = _matrices(kind, {**values, **none})
    each = [_matrices(kind, {**values, **none, name: 1.0})[1] - C for name in names]
    inverse = np.linalg.inv(np.linalg.cholesky(M))
    squares, modes = np.linalg.eigh(inverse @ (0.5 * (K + K.T)) @ inverse.T)
    if not squares[0] > 0:
        raise ParameterError(
            f"{subject} has a mode without stiffness where it is unloaded; write "
            f"{_lines(kind, names)}"
        )
    back = M @ inverse.T @ modes
    asked = back @ np.diag(2 * ratio * np.sqrt(squares)) @ back.T
    columns = np.array(each).reshape(len(names), size * size).T
    sizes = np.linalg.norm(columns, axis=0)
    found = np.linalg.lstsq(columns / sizes, asked.reshape(-1), rcond=None)[0]
    off = np.linalg.norm(columns / sizes @ found - asked.reshape(-1))
    # Relative to the damping matrix.
    rounding = 1e-9
    if off > rounding * np.linalg.norm(asked) or found.min() < -rounding * found.max():
        raise ParameterError(
            f"{subject} has {' and '.join(names)}, which cannot give all {size} modes one ratio; "
            f"write {_lines(kind, names)}"
        )
    units = kind.units
    return {
        name: Measured(value, value, value, units[name])
        for name, value in zip(names, np.maximum(found / sizes, 0.0).tolist(), strict=True)
    }


def _lines(kind: Quantities, dampers: Iterable[str]) -> str:
    """Example lines of a file for dampers."""
    return ", ".join(f'{name} = "{example_of(name, kind.units[name])}"' for name in dampers)


def remedy(kind: Quantities, values: Mapping[str, float]) -> str:
    """What to write in the file, or on the page, to add damping; ``values`` are those of the
    quantities, in SI.
    """
    if kind.model.where in WITH_DAMPERS:
        return 'write damping_ratio = "0.5 %" or what you measured'
    if idle := [name for name in kind.dampers if not values.get(name)]:
        return f"write {_lines(kind, idle)} or what you measured"
    given = f"check {' and '.join(kind.dampers)}, or " if kind.dampers else ""
    return f"{given}add a damper to the page"


def _matrices(kind: Quantities, values: Mapping[str, float]) -> list[FloatArray]:
    """Mass, damping and stiffness matrices (n, n) without friction at all coordinates 0, in
    contact.
    """
    # Slow imports, which input errors do not need.
    from ..statics.balance import Balance
    from ..statics.stability import linearization

    p, model = kind.parameter_set(values), kind.model
    off = {name: 1.0 for name in model.parameters if p[name] is None}
    if model.coefficient is not None:
        off[model.coefficient] = 0.0
    p = p.replace(**off)
    given = np.array(p.scalars(*model.parameters))[:, None]
    law = "friction_at_rest"
    found = linearization(Balance(model, True, law), np.zeros((len(kind.coordinates), 1)), given)
    return [one[0] for one in found]
