"""What several test modules share: numbers in other forms, exact onsets, and generated modules by
name.
"""

import importlib
import inspect
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from fractions import Fraction
from pathlib import Path
from types import ModuleType
from typing import Any

import mpmath
import numpy as np
import pytest

import spragsym as ss
import spragsym.generated as generated_package
from spragsym.kang_nam import flutter
from spragsym.motion import integrators
from spragsym.numerics import balls
from tests.oracles.families import random_fixed

ROOT = Path(__file__).parents[1]

#: For what other systems do in another way: signals to other processes, shells, links that anyone
#: may make.
needs_posix = pytest.mark.skipif(os.name != "posix", reason="signals, shells and links of POSIX")

#: Why tests with long motions are skipped; empty where an integrator that was compiled is there.
LONG_MOTIONS_TAKE_MINUTES = (
    "long motions take SciPy minutes" if integrators.choose(None) == "scipy" else ""
)
needs_a_quick_integrator = pytest.mark.skipif(
    bool(LONG_MOTIONS_TAKE_MINUTES), reason=LONG_MOTIONS_TAKE_MINUTES
)

#: As little as a process can be given: Windows starts none without its own folder.
NO_ENVIRONMENT = {name: os.environ[name] for name in ("SYSTEMROOT",) if name in os.environ}


def few(parameters: Iterable[Any], *kept: Any) -> list[Any]:
    """Parameters of a test: those kept, by value or id, run in ``make test``, the others in
    ``make check`` only.
    """
    found = []
    for one in parameters:
        values, name, marks = (
            (one.values, one.id, one.marks) if hasattr(one, "marks") else ([one], None, ())
        )
        more = [] if one in kept or name in kept else [pytest.mark.thorough]
        found.append(pytest.param(*values, id=name, marks=[*marks, *more]))
    return found


def box_of(low: Any, high: Any) -> dict[str, tuple[float, float]]:
    """Sides of a box, by the parameters at two of its corners."""
    return {
        name: (float(low[name]), float(high[name]))
        for name in low.ranges
        if low[name] is not None and low[name] != high[name]
    }


def as_fraction(value: mpmath.mpf) -> Fraction:
    """The rational that a number of mpmath is."""
    negative, mantissa, exponent, _ = value._mpf_
    return (-1) ** negative * Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def written_brake(folder: Path, rows: Mapping[str, str]) -> Path:
    """A file of these quantities, as text with units."""
    file = folder / "brake.toml"
    file.write_text(
        "[brake]\n" + "".join(f'{name} = "{value}"\n' for name, value in rows.items()),
        encoding="utf-8",
    )
    return file


def fractions(values: Iterable[Any]) -> list[Fraction]:
    """Floats, exactly."""
    return [Fraction(float(value)) for value in values]


def with_roots(*roots: Fraction | int, lead: Fraction | int = 1) -> tuple[Fraction, ...]:
    """Coefficients of the polynomial with these roots, lowest power first."""
    product = (Fraction(lead),)
    for root in roots:
        product = tuple(a - root * b for a, b in zip((0, *product), (*product, 0), strict=True))
    return product


def as_mpf(value: Fraction) -> mpmath.mpf:
    """A rational to mpmath's precision."""
    return mpmath.mpf(value.numerator) / value.denominator


def generated(name: str) -> ModuleType:
    """A module of generated algebra."""
    return importlib.import_module(f"{generated_package.__name__}.{name}")


def in_python(name: str, names: Sequence[str]) -> Callable[..., Any]:
    """A function that a library in another language has, in Python: of arguments in that library's
    order, by its names for them.

    Of the page's functions it leaves out what nothing depends on, and the factor of an exponential,
    which it always feels.
    """
    function = _function(name)
    taken = [argument for argument in inspect.signature(function).parameters if argument != "xp"]
    spelled = {"cos_theta": "cos", "sin_theta": "sin"} | (
        {"nbar": "pushing"} if "pushing" in taken else {}
    )
    given = [spelled.get(argument, argument) for argument in names]
    assert set(given) <= set(taken), name
    return lambda *values: function(
        **{**dict.fromkeys(taken, 1.0), **dict(zip(given, values, strict=True))}
    )


def leaves(result: Any) -> list[Any]:
    """Numbers or arrays of nested lists and tuples, in their order."""
    return (
        [leaf for part in result for leaf in leaves(part)]
        if isinstance(result, list | tuple)
        else [result]
    )


def _function(name: str) -> Callable[..., Any]:
    modules = map(
        generated,
        (
            "catastrophe",
            "equilibrium",
            "laws",
            "linear_sprag",
            "stability",
            "models.kang_nam.algebra",
        ),
    )
    return next(getattr(module, name) for module in modules if name in module.__all__)


def exact_onsets(*values: Fraction | int) -> list[flutter.Onset]:
    """Onsets of flutter for exact mu0, kappa, alpha, sigma, beta."""
    with balls.precision(192):
        return list(flutter.onsets(flutter.Elimination(*map(Fraction, values)), 192))


def middle_of(value: balls.Interval) -> float:
    """The middle of an interval."""
    low, high = balls.ends(value)
    return float((low + high) / 2)


def lowest_sets(number: int) -> list[Any]:
    """Sets whose lowest fold is a cusp, a turn or none: one of each, one without a spring along the
    belt, random ones.
    """
    rng = np.random.default_rng(31)
    first = [
        ss.Parameters.article(),
        ss.Parameters(kappa=1e-4, alpha=0.25, sigma=5.4, beta=0.0),
        ss.Parameters.article(alpha=0.0),
        ss.Parameters(kappa=0.5499, alpha=0.8771, sigma=0.022509, beta=4.455),
    ]
    return [*first, *(random_fixed(rng) for _ in range(number - len(first)))]
