"""A model of matrices: small vibrations about steady sliding, of any number of coordinates."""

from __future__ import annotations

import itertools
import math
import os
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any, NoReturn, TypeAlias

import numpy as np
from scipy.sparse import csr_array, issparse

from ..core.errors import ModelError, ParameterError, ParameterTypeError
from ..display import Column
from ..files.text import path_text
from ..models.model import Model, parameter_class
from ..models.parameters import (
    NOT_NEGATIVE,
    FloatArray,
    ParameterSet,
    as_count,
    as_mapping,
    as_numbers,
)
from ..numerics.definite import Pencil, Terms
from .contacts import ContactPair, Dof, directions, read_contacts
from .exports import Label, Labelled
from .files import read, read_dofs
from .reduction import basis
from .uniqueness import unique_up_to

#: A matrix: an array, a sparse one of SciPy, or the name of a file.
Matrix: TypeAlias = Any

#: Coordinates up to which all eigenvectors are computed.
LARGEST = 1000
#: Questions that models of matrices answer.
ANSWERED = ("flutter_onsets", "modes")


class MatrixModel(Model):
    """M q″ + (C + Ω G) q′ + (K + μ K_f + Σ p_i K_i) q = 0, made by :func:`spragsym.matrices`.

    Its parameters are ``mu``, ``Omega``, and the names of stiffnesses and dampings; with contact
    pairs also ``contact``, by which their stiffness is multiplied, in K as in K_f.

    Attributes
    ----------
    given : mapping of str to ndarray, of more than 1000 coordinates to sparse array
        The matrices by name: ``M``, ``C``, ``G``, ``K``, ``friction``, and those of the parameters.
    dofs : tuple of (node, number)
        The degree of freedom of each row, if it is known.
    pairs : tuple of ContactPair
        If ``friction`` was made of them.
    full : MatrixModel or None
        The model that was reduced, by ``basis``, and is meant up to ``highest_hz``.
    """

    full: MatrixModel | None = None
    basis: FloatArray
    highest_hz: float = math.inf

    def __init__(
        self,
        given: Mapping[str, Matrix],
        names: Mapping[str, tuple[str, ...]],
        dofs: tuple[Label, ...] = (),
        pairs: tuple[ContactPair, ...] = (),
    ) -> None:
        self.given, self.names = dict(given), dict(names)
        self.dofs, self.pairs = dofs, pairs
        entries = [
            _entry("mu", None, "friction coefficient", low=0.0),
            _entry("Omega", 0.0 if is_zero(given["G"]) else None, "speed of rotation", "1/s"),
            *(_entry(one, 0.0, f"stiffness in units of {one}") for one in names["stiffnesses"]),
            *(_entry(one, 0.0, f"damping in units of {one}") for one in names["dampings"]),
            *(
                _entry("contact", 1.0, "stiffness of the contacts over that of the pairs", low=0.0)
                for _ in range("contact" in given)
            ),
        ]
        about: dict[str, Any] = {
            "name": "matrices",
            "summary": f"matrices of {given['M'].shape[0]} coordinates",
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
        return int(self.given["M"].shape[0])

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
        given, zero = self.given, 0.0 * self.given["M"]
        parts = {"mu": given["friction"], "Omega": given["G"]} | given
        share = self.contact_share(p) if vary != "contact" else 1.0
        if vary == "contact":
            parts["contact"] = parts["contact"] + p.scalars("mu")[0] * parts["mu"]
        if share != 1.0:
            parts["mu"] = share * parts["mu"]
        of_damping = ("Omega", *self.names["dampings"])
        fixed = {
            name: (p.scalars(name)[0], parts[name])
            for name in self.parameters
            if name not in (vary, "contact") and not is_zero(parts[name])
        }
        damping: Terms = ((1.0, given["C"]),)
        stiffness: Terms = ((1.0, given["K"]),)
        if vary == "contact":
            stiffness, fixed = (*stiffness, (-1.0, given["contact"])), fixed | {"mu": (0.0, zero)}
        elif share != 1.0:
            stiffness += ((share, given["contact"]), (-1.0, given["contact"]))
        for name, term in fixed.items():
            if name in of_damping:
                damping += (term,)
            else:
                stiffness += (term,)
        slopes = (parts[vary], zero) if vary in of_damping else (zero, parts[vary])
        return Pencil(given["M"], damping, stiffness, *slopes)

    def contact_share(self, p: ParameterSet) -> float:
        """By what the stiffness of the contacts is multiplied."""
        return p.scalars("contact")[0] if "contact" in self.given else 1.0

    def reduced(self, modes: int, corrections: int | None = None) -> MatrixModel:
        """The model in few coordinates: modes without friction and damping, and static corrections
        to what the other matrices do.

        Parameters
        ----------
        modes : int
            How many; the model is meant up to two thirds of the frequency of the last.
        corrections : int, optional
            The most of these; as many as modes, by default.

        Returns
        -------
        MatrixModel
            Onsets of it have a column ``full_model``: those of the model itself, computed from
            each of them.

        Raises
        ------
        ParameterError
            If there are not so many modes.

        Examples
        --------
        >>> import numpy as np, spragsym as ss
        >>> K = 1e6 * (2.0 * np.eye(40) - np.eye(40, k=1) - np.eye(40, k=-1))
        >>> pair = ss.ContactPair(across=(10, 11), along=(12, 14), stiffness=1e6)
        >>> m = ss.matrices(np.eye(40), K, [pair], rayleigh=(1.0, 1e-6)).reduced(12)
        >>> on = ss.flutter_onsets(m.Parameters())
        >>> m.size, on.mu.round(3), on.full_model.round(3)
        (14, array([0.956]), array([0.954]))
        """
        most = as_count("modes", modes, 1, self.size - 1)
        more = most if corrections is None else as_count("corrections", corrections, 0)
        space, highest = basis(self.given, most, more)
        given = {name: space.T @ (one @ space) for name, one in self.given.items()}
        given["M"] = 0.5 * (given["M"] + given["M"].T)
        found = MatrixModel(given, self.names)
        found.full, found.basis, found.highest_hz = self, space, highest / (3.0 * np.pi)
        return found

    def unique_up_to(self, p: ParameterSet) -> float:
        """The friction up to which there is one state of steady sliding under every load, with
        contacts that open and close: proved, for the matrices as they are given.

        Beyond it there may be loads with no such state or with several, between which it jumps; a
        criterion that is sufficient was asked, so that it may be unique there too.

        Parameters
        ----------
        p : Parameters
            Of this model, made with contact pairs; ``mu`` in it means nothing here.

        Returns
        -------
        float
            At most 10.

        Raises
        ------
        ModelError
            Without contact pairs, or if nothing but contacts holds a body.

        Examples
        --------
        A block between a stiff spring across, 1, and one that leans, 0.5, on a moving plate:

        >>> import numpy as np, spragsym as ss
        >>> K = [[1.0, 0.5], [0.5, 1.0 + 2.0]]  # along, across; the contact's stiffness is 2
        >>> pair = ss.ContactPair(across=(1,), along=(0,), stiffness=2.0)
        >>> m = ss.matrices(np.eye(2), K, [pair])
        >>> round(m.unique_up_to(m.Parameters(mu=0.0)), 6)  # 1/2 + 4/3 = μ 2/3
        2.75
        """
        if self.full is not None:
            given = {one: p[one] for one in self.parameters}
            return self.full.unique_up_to(self.full.Parameters(**given))
        self.require_small()
        if not self.pairs:
            raise ModelError("whether sliding is unique is asked of contact pairs; give them")
        pencil = self.pencil(p.replace(mu=0.0), "mu")
        places: dict[Dof, int] = {one: place for place, one in enumerate(self.dofs)}
        W_n, W_t, k = directions(self.pairs, self.size, places)
        k = k * self.contact_share(p)
        return unique_up_to(pencil.at(0.0)[1], pencil.sizes(0.0)[1], W_n, W_t, k)

    def require_small(self) -> None:
        """Raise for a model that is only asked when it is reduced."""
        if self.size > LARGEST:
            raise ParameterError(
                f"the model has {self.size} coordinates, more than {LARGEST}; reduce it, as "
                "m.reduced(modes=100)"
            )

    def __repr__(self) -> str:
        return f"matrices of {self.size} coordinates, parameters {', '.join(self.parameters)}"

    def __reduce__(self) -> tuple[Any, ...]:
        own = {"full": self.full, "basis": self.__dict__.get("basis")}
        return (
            MatrixModel,
            (self.given, self.names, self.dofs, self.pairs),
            own | {"highest_hz": self.highest_hz},
        )


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
    dofs: Sequence[Label] | str | os.PathLike[str] | None = None,
) -> MatrixModel:
    """A model of matrices, as of a finite-element program: vibrations about steady sliding.

    M q″ + (C + Ω G) q′ + (K + μ K_f + Σ p_i K_i) q = 0, with K_f that is ``friction``.

    Parameters
    ----------
    M, K, friction : array_like, sparse array, or path
        Mass, stiffness, and what stiffness the friction coefficient 1 adds; shape (n, n). M is
        symmetric and positive definite. A path is read by its ending, as
        ``.mtx``, ``.mat``, ``.npy``. In place of the matrix ``friction`` is a list of
        :class:`ContactPair`, or a table of them, ``.csv``.
    C, G : likewise, optional
        Damping, and gyroscopic terms at the speed of rotation ``Omega`` = 1.
    stiffnesses, dampings : mapping of str to matrices, optional
        Further stiffnesses and dampings by the names of their parameters, which are 0 unless given.
    damping_ratio : float, optional
        Adds damping of this ratio to every mode of M and the symmetric part of K.
    rayleigh : tuple of two floats, optional
        Adds the damping α M + β K.
    dofs : sequence of (node, number), or path, optional
        The degree of freedom of each row, or Ansys' file ``.mapping`` with them. Files with labels
        of nodes bring their own: rows are those of M and K, in the order of nodes.

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
    more = {
        "stiffnesses": as_mapping("stiffnesses", stiffnesses, '{"k_pad": K_pad}'),
        "dampings": as_mapping("dampings", dampings, '{"c_shim": C_shim}'),
    }
    raw = {"M": M, "K": K, "friction": friction, "C": C, "G": G}
    for kind, named in more.items():
        for name, one in named.items():
            if name in (*raw, "mu", "Omega", "contact") or not str(name).isidentifier():
                raise ParameterError(f"{kind} has the name {name!r}; give another, a word")
            raw[name] = one
    raw = {name: _read(one) for name, one in raw.items() if one is not None}
    labels = read_dofs(dofs) if isinstance(dofs, str | os.PathLike) else tuple(dofs or ())
    of_nodes = [raw[name].dofs for name in ("M", "K") if isinstance(raw[name], Labelled)]
    labels = labels or tuple(sorted({*itertools.chain(*of_nodes)}))
    places: dict[Dof, int] = {one: place for place, one in enumerate(labels)}
    pairs = raw["friction"] if _are_pairs(raw["friction"]) else ()
    given = {name: _dense(name, raw[name], places) for name in raw if raw[name] is not pairs}
    n = int(given["M"].shape[0]) if given["M"].ndim == 2 else 0
    if pairs:
        W_n, W_t, stiffness = directions(pairs, n, places)
        across = csr_array(W_n)
        for name, one in (("friction", W_t), ("contact", W_n)):
            given[name] = _dense(name, csr_array(one.T * stiffness) @ across, {})
    for name in ("C", "G"):
        given.setdefault(name, 0.0 * given["M"])
    for name, each in given.items():
        if each.shape != (n, n) or not n:
            raise ParameterError(
                f"{name} has the shape {each.shape}; all matrices are square, of the size of M"
            )
    own = given["M"]
    if abs(own - own.T).max() > 1e-10 * abs(own).max() or not _positive(own):
        raise ParameterError("M is no mass matrix: it must be symmetric and positive definite")
    given["C"] = given["C"] + _damping(given, damping_ratio, rayleigh)
    names = {kind: tuple(named) for kind, named in more.items()}
    return MatrixModel(given, names, labels, tuple(pairs))


def _are_pairs(one: Matrix) -> bool:
    listed = isinstance(one, list | tuple) and len(one) > 0
    return listed and all(isinstance(each, ContactPair) for each in one)


def _read(one: Matrix) -> Matrix:
    """A matrix, or contact pairs, from a file if it is a path."""
    if not isinstance(one, str | os.PathLike):
        return one
    return read_contacts(one) if path_text(one).lower().endswith(".csv") else read(one)


def _dense(name: str, one: Matrix, places: Mapping[Dof, int]) -> Matrix:
    """A matrix as an array of floats; a large sparse one as it is."""
    if isinstance(one, Labelled):
        unknown = [each for each in one.dofs if each not in places]
        if unknown:
            raise ParameterError(
                f"{name} has the degree of freedom {unknown[0]}, which neither M nor K has"
            )
        one = one.over(places)
    if issparse(one):
        if max(one.shape) > LARGEST:
            as_numbers(name, one.data)
            return one
        one = one.toarray()
    return as_numbers(name, one)


def is_zero(matrix: Matrix) -> bool:
    """Whether all elements are 0."""
    return not abs(matrix).max()


def _positive(matrix: Matrix) -> bool:
    """Whether it is positive definite; of a large sparse one the diagonal is looked at."""
    if issparse(matrix):
        return bool((matrix.diagonal() > 0).all())
    try:
        np.linalg.cholesky(matrix)
    except np.linalg.LinAlgError:
        return False
    return True


def _damping(
    given: Mapping[str, Matrix],
    ratio: float | None,
    rayleigh: tuple[float, float] | None,
) -> Matrix:
    """Damping of one ratio of all modes, and of Rayleigh's two factors."""
    M, K = given["M"], given["K"]
    total = 0.0 * M
    if ratio is not None:
        if issparse(M):
            raise ParameterError(
                f"damping_ratio = {ratio!r} is that of all modes, which {M.shape[0]} coordinates "
                "have too many of; give rayleigh, or C"
            )
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
