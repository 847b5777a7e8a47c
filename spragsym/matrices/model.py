"""A model of matrices: small vibrations about steady sliding, of any number of coordinates."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cached_property
from typing import Any, NoReturn, TypeAlias

import numpy as np

from ..core.errors import ModelError, ParameterError, ParameterTypeError
from ..display import Column
from ..models.model import Model, parameter_class
from ..models.parameters import NOT_NEGATIVE, FloatArray, ParameterSet, as_mapping, as_numbers
from ..numerics.definite import Pencil, Terms

#: A matrix: an array, a sparse one of SciPy, or the name of a file.
Matrix: TypeAlias = Any

#: Coordinates up to which all eigenvectors are computed.
LARGEST = 1000
#: Questions that models of matrices answer.
ANSWERED = ("flutter_onsets", "modes")


class MatrixModel(Model):
    """M q″ + (C + Ω G) q′ + (K + μ K_f + Σ p_i K_i) q = 0, made by :func:`spragsym.matrices`.

    Its parameters are ``mu``, ``Omega``, and the names of stiffnesses and dampings.

    Attributes
    ----------
    given : mapping of str to ndarray
        The matrices by name: ``M``, ``C``, ``G``, ``K``, ``friction``, and those of the parameters.
    """

    def __init__(
        self, given: Mapping[str, FloatArray], names: Mapping[str, tuple[str, ...]]
    ) -> None:
        self.given, self.names = dict(given), dict(names)
        entries = [
            _entry("mu", None, "friction coefficient", low=0.0),
            _entry("Omega", None if np.any(given["G"]) else 0.0, "speed of rotation", "1/s"),
            *(_entry(one, 0.0, f"stiffness in units of {one}") for one in names["stiffnesses"]),
            *(_entry(one, 0.0, f"damping in units of {one}") for one in names["dampings"]),
        ]
        about: dict[str, Any] = {
            "name": "matrices",
            "summary": f"matrices of {len(given['M'])} coordinates",
            "drawing": "",
            "parameters": entries,
            "coordinates": [],
            "contacts": [],
            "frictions": [],
            "springs": [],
            "angles": {},
            "roles": {"friction": "mu", "inclination": None},
            "scales": {"length": "1", "time": "1", "force": "1", "rate": "1"},
        }
        own = parameter_class(about, "matrices")
        super().__init__("matrices", about, _no_algebra, own, dict.fromkeys(ANSWERED, __package__))
        own._model = self

    @property
    def search(self) -> MatrixModel:
        """The model itself: one algorithm answers."""
        return self

    @property
    def size(self) -> int:
        """Number of coordinates."""
        return len(self.given["M"])

    @property
    def clock(self) -> str:
        """Empty: matrices have no clock."""
        return ""

    @cached_property
    def columns(self) -> Mapping[str, Column]:
        """Columns of the parameters by name."""
        return {
            one["name"]: Column(one["name"], one["unit"], one["meaning"])
            for one in self.about["parameters"]
        }

    def require_answered(self, question: str) -> None:
        """Raise ModelError for a question that has no answer for matrices, with the reason."""
        if question not in ANSWERED:
            raise ModelError(
                f"{question} is not asked of matrices: they tell small vibrations about one state "
                "of steady sliding, and neither other states nor large motions; ask "
                f"{', '.join(ANSWERED)}, or write the mechanism as a page"
            )

    def pencil(self, p: ParameterSet, vary: str) -> Pencil:
        """The matrices of a set of parameters as sums that depend on one of them."""
        given, zero = self.given, np.zeros_like(self.given["M"])
        parts = {"mu": given["friction"], "Omega": given["G"]} | given
        of_damping = ("Omega", *self.names["dampings"])
        fixed = {
            name: (p.scalars(name)[0], parts[name])
            for name in self.parameters
            if name != vary and np.any(parts[name])
        }
        damping: Terms = ((1.0, given["C"]),)
        stiffness: Terms = ((1.0, given["K"]),)
        for name, term in fixed.items():
            if name in of_damping:
                damping += (term,)
            else:
                stiffness += (term,)
        slopes = (parts[vary], zero) if vary in of_damping else (zero, parts[vary])
        return Pencil(given["M"], damping, stiffness, *slopes)

    def __repr__(self) -> str:
        return f"matrices of {self.size} coordinates, parameters {', '.join(self.parameters)}"

    def __reduce__(self) -> tuple[Any, ...]:
        return MatrixModel, (self.given, self.names)


def _no_algebra() -> NoReturn:
    raise ModelError("matrices have no generated functions")


def _entry(
    name: str, base: float | None, meaning: str, unit: str = "1", low: float | None = None
) -> dict[str, Any]:
    return {
        "name": name,
        "base": base,
        "unit": unit,
        "low": low,
        "high": None,
        "low_open": False,
        "high_open": True,
        "domain": "any number" if low is None else f">= {low:g}",
        "meaning": meaning,
        "role": "both",
    }


def matrices(
    M: Matrix,
    K: Matrix,
    friction: Matrix,
    *,
    C: Matrix | None = None,
    G: Matrix | None = None,
    stiffnesses: Mapping[str, Matrix] | None = None,
    dampings: Mapping[str, Matrix] | None = None,
    damping_ratio: float | None = None,
    rayleigh: tuple[float, float] | None = None,
) -> MatrixModel:
    """A model of matrices, as of a finite-element program: vibrations about steady sliding.

    M q″ + (C + Ω G) q′ + (K + μ K_f + Σ p_i K_i) q = 0, with K_f that is ``friction``.

    Parameters
    ----------
    M, K, friction : array_like, sparse array, or path
        Mass, stiffness, and what stiffness the friction coefficient 1 adds; shape (n, n). M is
        symmetric and positive definite. A path is read by its ending, as
        ``.mtx``, ``.mat``, ``.npy``.
    C, G : likewise, optional
        Damping, and gyroscopic terms at the speed of rotation ``Omega`` = 1.
    stiffnesses, dampings : mapping of str to matrices, optional
        Further stiffnesses and dampings by the names of their parameters, which are 0 unless given.
    damping_ratio : float, optional
        Adds damping of this ratio to every mode of M and the symmetric part of K.
    rayleigh : tuple of two floats, optional
        Adds the damping α M + β K.

    Returns
    -------
    MatrixModel
        ``m.Parameters(mu=0.4)`` makes a set of parameters.

    Raises
    ------
    ParameterError
        For matrices of other shapes, values that are not finite, an M that is no mass matrix, or
        names that are taken.

    Examples
    --------
    >>> import numpy as np, spragsym as ss
    >>> m = ss.matrices(
    ...     M=np.eye(2), K=[[1.55, -0.25], [-0.25, 1.25]], friction=[[0, 1], [0, 0]],
    ...     damping_ratio=1e-3,
    ... )
    >>> onsets = ss.flutter_onsets(m.Parameters(), vary="mu", between={"mu": (0.0, 1.0)})
    >>> onsets.mu.round(3), onsets.kind, onsets.complete
    (array([0.339]), array(['flutter'], dtype='<U10'), True)
    """
    from .files import read

    def dense(name: str, one: Matrix) -> FloatArray:
        if isinstance(one, str | os.PathLike):
            one = read(one)
        if hasattr(one, "toarray"):
            if max(one.shape) > LARGEST:
                raise ParameterError(
                    f"{name} has {one.shape[0]} coordinates, more than {LARGEST}; give those of "
                    "a reduced model, as finite-element programs export them"
                )
            one = one.toarray()
        return as_numbers(name, one)

    given = {"M": dense("M", M), "K": dense("K", K), "friction": dense("friction", friction)}
    zero = np.zeros_like(given["M"])
    for name, one in (("C", C), ("G", G)):
        given[name] = zero if one is None else dense(name, one)
    more = {
        "stiffnesses": as_mapping("stiffnesses", stiffnesses, '{"k_pad": K_pad}'),
        "dampings": as_mapping("dampings", dampings, '{"c_shim": C_shim}'),
    }
    for kind, named in more.items():
        for name, one in named.items():
            if name in (*given, "mu", "Omega") or not str(name).isidentifier():
                raise ParameterError(f"{kind} has the name {name!r}; give another, a word")
            given[name] = dense(f"{kind}[{name!r}]", one)
    n = len(given["M"]) if given["M"].ndim == 2 else 0
    for name, each in given.items():
        if each.shape != (n, n) or not n:
            raise ParameterError(
                f"{name} has the shape {each.shape}; all matrices are square, of the size of M"
            )
    own = given["M"]
    if not np.allclose(own, own.T, rtol=0.0, atol=1e-10 * np.abs(own).max()) or not _positive(own):
        raise ParameterError("M is no mass matrix: it must be symmetric and positive definite")
    given["C"] = given["C"] + _damping(given, damping_ratio, rayleigh)
    return MatrixModel(given, {kind: tuple(named) for kind, named in more.items()})


def _positive(matrix: FloatArray) -> bool:
    try:
        np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return False
    return True


def _damping(
    given: Mapping[str, FloatArray],
    ratio: float | None,
    rayleigh: tuple[float, float] | None,
) -> FloatArray:
    """Damping of one ratio of all modes, and of Rayleigh's two factors."""
    M, K = given["M"], given["K"]
    total = np.zeros_like(M)
    if ratio is not None:
        from scipy.linalg import eigh

        share = as_numbers("damping_ratio", ratio, NOT_NEGATIVE)
        squares, modes = eigh(0.5 * (K + K.T), M)
        rates = 2.0 * share * np.sqrt(np.maximum(squares, 0.0))
        total += (M @ modes * rates) @ (M @ modes).T
    if rayleigh is not None:
        factors = as_numbers("rayleigh", np.asarray(rayleigh, dtype=float), NOT_NEGATIVE)
        if factors.shape != (2,):
            raise ParameterTypeError(f"rayleigh = {rayleigh!r}; give two factors, of M and of K")
        total += factors[0] * M + factors[1] * K
    return total
