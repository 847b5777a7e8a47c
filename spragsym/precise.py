"""The same answers with as many digits as wanted, from parameters taken exactly, each with a proof.

A parameter is an int, a str such as ``"0.007"`` or ``"7/1000"``, a :class:`fractions.Fraction`, an
mpmath number or a float, and is taken to be exactly the rational number that it writes.

Results are ``mpmath.mpf`` with every bit that they were computed with, some more than the digits
asked for; nothing is rounded once a bound is known. The bound is on the numbers as they stand,
whatever ``mpmath.mp.dps`` is. But what mpmath makes of them is rounded to the ``dps`` of that
moment: set it before subtracting two results, and before ``+value``, which rounds as well. No
precision of mpmath's or of python-flint's is set or read here, so results depend neither on them
nor on other threads.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import TYPE_CHECKING, Any, TypeAlias

import mpmath

from .core.error_states import in_usual_state
from .core.errors import ParameterError, ParameterTypeError, hint
from .core.questions import Method, model_of
from .models import Model
from .models.load import USUAL, load
from .models.parameters import ParameterSet, Range, Ranges
from .numerics import balls
from .numerics.balls import Interval
from .numerics.decimals import exactly
from .results.precise_states import CuspProof, PreciseEquilibria

if TYPE_CHECKING:
    from .orbits.orbit import Cycle
    from .orbits.proofs import CycleProof

#: What is taken exactly.
Exact: TypeAlias = int | float | str | Fraction | mpmath.mpf


@dataclass(frozen=True)
class Degrees:
    """An angle that is exact in degrees, and in radians an interval."""

    value: Fraction

    def __call__(self) -> Interval:
        return balls.exact(self.value / 180) * balls.pi()

    def __str__(self) -> str:
        return f"{self.value} degrees"


def as_exact(name: str, value: Exact, allowed: Range) -> Fraction:
    """The rational number that ``value`` writes, or an error that names the argument."""
    if isinstance(value, bool) or not isinstance(value, int | float | str | Fraction | mpmath.mpf):
        raise ParameterTypeError(
            f"{name} = {value!r} is of type {type(value).__name__}; give an int, a str, a "
            "Fraction, an mpf or a float"
        )
    if isinstance(value, str):
        number = re.compile(
            r"\s*[+-]?(\d{1,400}(/\d{1,400})?"
            r"|(\d{1,400}\.?\d{0,400}|\.\d{1,400})([eE][+-]?\d{1,3})?)\s*"
        )
        if not number.fullmatch(value):
            raise ParameterTypeError(
                f"{name} = {value[:40]!r} is not a number such as '0.007' or '7/1000'"
            )
        if re.search(r"/0*$", value.strip()):
            raise ParameterError(f"{name} = {value[:40]!r} divides by zero")
    elif isinstance(value, mpmath.mpf | float) and not mpmath.isfinite(value):
        raise ParameterError(f"{name} = {value} is not a finite number in {allowed}")
    exact = exactly(value)
    # Python compares rational numbers with floats exactly, infinite ones too. π is irrational and
    # its float lies below it: what is beyond the float but below π is not worth a doubt.
    if not allowed.spans(exact):
        raise ParameterError(
            f"{name} = {value} is not in {allowed}"
            + (f": {allowed.remedy}" if allowed.remedy else "")
        )
    return exact


def as_digits(dps: int) -> int:
    """``dps`` as a number of digits that makes sense."""
    if isinstance(dps, bool) or not isinstance(dps, int):
        raise ParameterTypeError(
            f"dps = {dps!r} is not an integer; give a number of decimal digits"
        )
    # Digits beyond which a request is taken for a mistake.
    most_digits = 1000
    if not 1 <= dps <= most_digits:
        raise ParameterError(
            f"dps = {dps} is not in [1, {most_digits}]; give a number of decimal digits"
        )
    return dps


@in_usual_state
def equilibria(
    p: ParameterSet | None = None,
    *,
    contact: bool | Sequence[str] | None = None,
    dps: int = 50,
    method: Method = "auto",
    **exact: Exact,
) -> PreciseEquilibria:
    """All equilibria of one point of any model to ``dps`` digits, count and digits proved by
    interval arithmetic.

    Parameters
    ----------
    p : Parameters, optional
        Of any model, single numbers, taken exactly as the floats that they are; the article's base
        values as it prints them where left out.
    contact : bool or sequence of str, optional
        True for n̄ = 1 (y < 0), as where it is left out, False for n̄ = 0 (y ≥ 0); of several
        contacts as for :func:`spragsym.equilibria`, and ``touching`` of each state says which do.
    dps : int
        Decimal digits, 1 to 1000.
    method : {"auto", "closed", "search"}
        Closed forms where the model has them, or the search over boxes as a second witness.
    **exact : int, str, Fraction, mpf or float
        Parameters by name, taken exactly, in the place of those of ``p``; with ``theta0_deg`` an
        angle in degrees. One that has the name of an argument stands with an underscore behind
        it, as ``method_``.

    Returns
    -------
    PreciseEquilibria

    Raises
    ------
    ParameterError, ParameterTypeError
        For what is not a number, or out of range.
    ConvergenceError
        For a point on a stability boundary that no number of digits can settle.

    Notes
    -----
    Source: f(θ) = 0, (12)–(13) eliminated; of other models the balance of forces, isolated over
    boxes and narrowed by Krawczyk's operator in ball arithmetic.

    Examples
    --------
    >>> import spragsym as ss
    >>> from spragsym import precise
    >>> state, = precise.equilibria(theta0_deg="49", dps=30)
    >>> str(state.decimals()["x"]), str(state.decimals(digits=6)["x"])
    ('1.21742364817816844590957746961466093475851094892 ± 2.9e-45', '1.21742 ± 3.7e-06')
    >>> state, = precise.equilibria(ss.load("stick_slip").Parameters(V=1), dps=30)
    >>> str(state.decimals(digits=20)["x"]), state.undamped.name
    ('0.099009900990099015288 ± 3.1e-22', 'STABLE')
    """
    model = _model(p)
    given = _exactly(model, p, exact)
    from .bifurcation.digits import precise_equilibria

    return precise_equilibria(model.Parameters(), given, contact, as_digits(dps), method=method)


@in_usual_state
def cusps(
    p: ParameterSet | None = None,
    *,
    vary: Sequence[str] | None = None,
    between: Ranges | None = None,
    dps: int = 40,
    method: Method = "auto",
    **exact: Exact,
) -> CuspProof:
    """All cusps of any model in the plane of two parameters to ``dps`` digits, and the proof that
    there are no more.

    Parameters
    ----------
    p : Parameters, optional
        Of any model, single numbers, of which those that vary are not asked; the article's base
        values as it prints them where left out.
    vary : pair of str, optional
        Two parameters; θ₀ and μ₀ where there are both.
    between : mapping, optional
        Ranges of these, as for :func:`spragsym.cusps`: then boxes are searched.
    dps : int
        Decimal digits, 1 to 1000.
    method : {"auto", "closed", "search"}
        The polynomial where the model has it, for θ₀ and μ₀, or the search over boxes as a second
        witness.
    **exact : int, str, Fraction, mpf or float
        Parameters by name, taken exactly, in the place of those of ``p``.

    Returns
    -------
    CuspProof
        A sequence of cusps, empty where there is none; by the polynomial those with θ₀ in (−π, π]
        and μ₀ of either sign, by search those within the parameters' ranges. ``complete`` says
        whether these are all: of a search with numbers that are no floats, as ``"0.007"``, each
        cusp is proved, and not that there are no more.

    Raises
    ------
    ParameterError, ParameterTypeError
        For what is not a number, or out of range.
    ConvergenceError
        For a cusp that no number of digits tells from a worse point, or from one on the border of
        the contact.

    Notes
    -----
    Source: f = f′ = f″ = 0, one polynomial of degree 9 in sin θ with rational coefficients; of
    other models F = 0, det K = 0 and ∇(det K) · v = 0 with K v = 0, isolated over boxes and
    narrowed by Krawczyk's operator in ball arithmetic.

    Examples
    --------
    >>> import spragsym as ss
    >>> from spragsym import precise
    >>> found = precise.cusps(dps=30)
    >>> len(found), found.count, str(found[2].decimals(25)["mu0"]), found[2].versal
    (4, 2, '0.2009317818050900185134401 ± 4.8e-26', True)
    >>> p = ss.load("two_springs").Parameters()
    >>> found = precise.cusps(p, between={"theta0": (0, 2), "mu0": (0, 2)})
    >>> len(found), found.complete, str(found[0].decimals(20)["mu0"])
    (1, True, '1.0630183449987103511 ± 3.8e-20')
    """
    model = _model(p)
    vary = model.two(vary)
    vary = model.axes if set(vary) == set(model.axes) else vary  # one plane, in either order
    given = _exactly(model, p, exact, unasked=vary)
    from .bifurcation.digits import precise_cusps

    return precise_cusps(
        model.Parameters(), given, vary, as_digits(dps), between=between, method=method
    )


def _model(p: ParameterSet | None) -> Model:
    """The model that is asked."""
    if p is not None and not isinstance(p, ParameterSet):
        raise ParameterTypeError(
            f"p = {p!r:.60} is no set of parameters; give one, or numbers by name as "
            f"theta0={p!r:.30}"
        )
    if p is not None and p.shape:
        raise ParameterError(
            f"p has the shape {p.shape}; digits are asked for one point, so give single numbers"
        )
    return load(USUAL) if p is None else model_of(p)


def _exactly(
    model: Model, p: ParameterSet | None, exact: Mapping[str, Exact], unasked: Collection[str] = ()
) -> dict[str, Any]:
    """Parameters as exact numbers: those given by name, of the set, or the base values as printed.

    ``unasked`` are parameters on which the answer does not depend.
    """
    # Arguments of the functions here, whose names parameters of a page may have.
    arguments = frozenset(("p", "contact", "dps", "method", "vary", "between"))
    spelled = {name: f"{name}_" if name in arguments else name for name in model.parameters}
    names = {
        **{called: name for name, called in spelled.items()},
        **{f"{name}_deg": name for name in model.about["angles"]},
    }
    for name in exact:
        if names.get(name) in unasked:
            raise ParameterError(
                f"{name} is not asked: the answer is for all {names[name]}; leave it out"
            )
        if name not in names:
            raise ParameterError(
                f"{name} is no parameter of {model.name}{hint(name, names)}; it has "
                f"{', '.join(names)}"
            )
    given: dict[str, Any] = {}
    for name in (one for one in model.parameters if one not in unasked):
        allowed = model.Parameters.ranges[name]
        degrees = exact.get(f"{name}_deg")
        value = exact.get(spelled[name])
        if degrees is not None and value is not None:
            raise ParameterError(f"give one of {name} (radians) and {name}_deg (degrees)")
        if degrees is not None:
            # 180 where the end is π.
            low, high = (round(math.degrees(end), 9) for end in (allowed.low, allowed.high))
            limits = replace(allowed, low=low, high=high)
            given[name] = Degrees(as_exact(f"{name}_deg", degrees, limits))
            continue
        if value is None and (own := model.base.get(name) if p is None else p[name]) is not None:
            value = repr(own) if p is None else float(own)
        if value is None:
            degrees_too = f" (radians) or {name}_deg (degrees)" * (name in model.about["angles"])
            why = "it has no base value" if p is None else "it is missing from p"
            raise ParameterError(f"give one of {name}{degrees_too}: {why}")
        given[name] = as_exact(spelled[name], value, allowed)
    return given


@in_usual_state
def prove_cycle(cycle: Cycle, **options: Any) -> CycleProof:
    """Prove that a cycle exists, is the only one near, and is stable or not: see
    :func:`spragsym.orbits.proofs.prove_cycle`.
    """
    from .orbits import proofs

    return proofs.prove_cycle(cycle, **options)
