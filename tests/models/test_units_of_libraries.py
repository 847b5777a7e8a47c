"""Numbers that carry a unit, of any library that is installed: converted, or refused by name; never
stripped.
"""

import importlib
import inspect
import math
import re
from collections.abc import Callable, Iterator
from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.models import units
from spragsym.models.units import factor

BASE = ss.Parameters.article(theta0=0.8)
#: Angles in degrees, of each library whose units are understood: of a number, or of several.
CONVERTED: dict[str, Callable[[Any], Any]] = {
    "pint": lambda of: of.UnitRegistry().Quantity,
    "unyt": lambda of: of.unyt_array,
    "astropy.units": lambda of: of.Quantity,
    "quantities": lambda of: of.Quantity,
}
#: Libraries whose units are not understood, and an expression of a length or of several there.
REFUSED = {
    "magnitude": "m.mg(3, 'mm')",
    "unum.units": "3 * m.mm",
    "forallpeople": "(m.environment('default'), 3 * m.m)[1]",
    "ansys.units": "m.Quantity([3.0, 4.0], 'mm')",
    "barril.units": "m.Array([3, 4], 'mm')",
    "unitx": "m.Quantity(3, 'mm')",
    "scipp": "m.scalar(3.0, unit='mm')",
    "scuq.quantities": "m.Quantity(__import__('scuq.si', fromlist=['METER']).METER, 3.0)",
    "natu.units": "3 * m.m",
    "siunits": "3 * m.m",
    "measurement.measures": "m.Distance(mm=3)",
    "saiunit": "np.array([1.0, 2.0]) * m.mmeter",
    "scimath.units.api": "m.UnitArray([1.0], units=__import__('scimath.units.length').units.length.m)",
    "quantiphy": "m.Quantity('3 mm')",
    "units": "m.unit('m')(3)",
    "misu": "3.0 * m.mm",
    "physipy": "np.array([1.0]) * m.m",
    "quantity.predefined": "m.Length('3 m')",
    "pint_pandas": "m.PintArray([1.0, 2.0], dtype='pint[mm]')",
    "pandas_units_extension": "__import__('pandas').Series([1.0, 2.0], dtype='unit[mm]')",
    "MetaArray": "m.MetaArray([1.0, 2.0], info=[{'name': 'x', 'units': 'mm'}])",
    "uncertainties": "m.ufloat(1.0, 0.1)",
}


class Thrust(float):
    """A number of an unknown library."""

    unit = "kN"


class Array(np.ndarray):
    """An array of one."""

    units = "mm"


def quantity(library: str) -> Any:
    module = pytest.importorskip(library, exc_type=Exception)  # some are for an older NumPy
    return CONVERTED[library](module)


def containers(one: Any, several: Any, each: list[Any]) -> Iterator[Any]:
    """Ways to give the angles of 60 and 120 degrees."""
    yield several
    yield each
    yield tuple(each)
    objects = np.empty(2, dtype=object)
    objects[:] = each
    yield objects
    yield [one, each[1]]


@pytest.mark.parametrize("library", CONVERTED)
def test_understood_units_are_converted_in_every_container(library: str) -> None:
    """Of integers, too, whose unit NumPy drops without a warning."""
    made = quantity(library)
    percent = "%" if library in ("astropy.units", "unyt") else "percent"
    deg = "deg" if library == "astropy.units" else "degree"
    each = [made(60, deg), made(120, deg)]
    for given in containers(made(60, deg), made(np.array([60, 120]), deg), each):
        np.testing.assert_array_equal(BASE.replace(theta0=given).theta0, np.radians([60, 120]))
    assert BASE.replace(theta0=made(60, deg)).theta0 == math.radians(60)
    np.testing.assert_array_equal(BASE.replace(mu0=[made(20, percent)]).mu0, [0.2])
    for name, unit in (("theta0", "m"), ("theta0", percent), ("mu0", deg), ("mu0", "kg")):
        for given in (made(1, unit), [made(1, unit)], np.array([made(1, unit)], dtype=object)):
            with pytest.raises(ss.errors.ParameterTypeError, match=f"^{name} is in"):
                BASE.replace(**{name: given})
    with pytest.raises(ss.errors.ParameterTypeError, match="beside values without a unit"):
        BASE.replace(theta0=[made(60, deg), 1.0])


@pytest.mark.parametrize("library", CONVERTED)
def test_a_brake_in_units_is_converted_to_si(library: str) -> None:
    made = quantity(library)
    data = {"m": 0.4, "k": 1e5, "k_x": 7e3, "k_y": 0, "k_c": 1e6, "F_L": 350, "L_0": 0.05}
    others = {"theta0": 0.8, "mu0": 0.5}
    given = {
        "m": made(400, "g"),
        "k": made(100, "N/mm"),
        "k_x": made(7, "kN/m"),
        "k_c": made(1, "kN/mm"),
        "F_L": made(0.35, "kN"),
        "L_0": made(5, "cm"),
    }
    brake = ss.PhysicalParameters(**{"k_y": 0, **given}, **others)
    right = ss.PhysicalParameters(**data, **others)
    for name in data:
        assert getattr(brake, name) == pytest.approx(getattr(right, name), rel=1e-15)
    for name in given:
        with pytest.raises(ss.errors.ParameterTypeError, match=f"with units, and {name} without"):
            ss.PhysicalParameters(**{"k_y": 0, **given, name: data[name]}, **others)
    with pytest.raises(ss.errors.ParameterTypeError, match="m is in"):
        ss.PhysicalParameters(**{"k_y": 0, **given, "m": given["k"]}, **others)


@pytest.mark.parametrize("library", REFUSED)
def test_units_that_are_not_understood_are_refused(library: str) -> None:
    try:
        names = {"m": importlib.import_module(library), "np": np}
        value = eval(REFUSED[library], names)  # noqa: S307  # text of this file
    except Exception as error:  # not installed, or for an older NumPy
        pytest.skip(f"{library}: {error}")
    for given in (value, [value], (value, 1.0)):
        with pytest.raises(ss.errors.ParameterTypeError, match="mu0"):
            BASE.replace(mu0=given)


@pytest.mark.parametrize(
    ("value", "words"),
    [
        (Thrust(0.4), "in kN"),
        ([Thrust(0.4)], "in kN"),
        (np.array([0.4]).view(Array), "in mm"),
        (np.array([Thrust(0.4), 0.2], dtype=object), "in kN"),
        ([True, 0.9], "boolean"),
        ((0, np.True_), "boolean"),
        (np.array([True]), "boolean"),
        ([np.array(True), 0.2], "boolean"),
        (np.ma.array([0.1, 0.2], mask=[0, 1]), "1 masked"),
        ([np.ma.masked, 0.2], "masked"),
    ],
)
def test_what_is_no_plain_number_is_refused_by_its_elements(value: Any, words: str) -> None:
    with pytest.raises(ss.errors.ParameterTypeError, match=words):
        BASE.replace(mu0=value)
    with pytest.raises(ss.errors.ParameterTypeError, match=words):
        ss.folds(BASE, vary="mu0", between={"mu0": value})


def test_labels_and_masks_of_containers_are_read() -> None:
    xarray = pytest.importorskip("xarray")
    dask = pytest.importorskip("dask.array")
    assert BASE.replace(theta0=xarray.DataArray(60.0, attrs={"units": "deg"})).theta0 == math.pi / 3
    assert BASE.replace(mu0=xarray.DataArray(0.2)).mu0 == 0.2
    np.testing.assert_array_equal(BASE.replace(mu0=dask.from_array(np.ones(2))).mu0, 1.0)
    masked = dask.from_array(np.ma.array([0.1, 0.2], mask=[0, 1]))
    for value in (xarray.DataArray(0.2, attrs={"units": "furlong"}), masked):
        with pytest.raises(ss.errors.ParameterTypeError, match=r"furlong|masked"):
            BASE.replace(mu0=value)


def test_the_unit_of_a_series_is_used_as_that_of_an_array_with_names() -> None:
    pandas = pytest.importorskip("pandas")
    series = pandas.Series([60.0, 90.0])
    series.attrs["units"] = "deg"
    np.testing.assert_array_equal(BASE.replace(theta0=series).theta0, [math.pi / 3, math.pi / 2])


def test_masks_of_astropy_are_kept() -> None:
    units = pytest.importorskip("astropy.units")
    table, masks = (importlib.import_module(f"astropy.{n}") for n in ("table", "utils.masked"))
    for value in (
        masks.Masked([1.0, 2.0] * units.deg, mask=[True, False]),
        masks.Masked(np.array([1.0, 2.0]), mask=[True, False]),
        table.MaskedColumn([1.0, 2.0], unit="deg", mask=[True, False]),
    ):
        with pytest.raises(ss.errors.ParameterTypeError, match="1 masked"):
            BASE.replace(theta0=value)
    column = table.Column([60.0, 90.0], unit="deg")
    np.testing.assert_array_equal(BASE.replace(theta0=column).theta0, np.radians([60, 90]))


#: What functions need beside the parameters.
OTHERS: dict[str, Any] = {
    "vary": "kappa",
    "values": [0.1, 0.2],
    "between": {"kappa": (0.3, 0.6)},
    "theta": 1.0,
    "theta0": 1.0,
    "V": 0.5,
    "d": 10.0,
    "mu0": (0.3, 0.6),
    "claim": "no jump",
}


def numeric() -> Iterator[tuple[Callable[..., Any], dict[str, Any], str, Any]]:
    """Every public function, what it needs, the name of a number it takes, and a bad value
    there.
    """
    one = Thrust(3.0)
    for module in ("spragsym", "spragsym.kang_nam", "spragsym.motion.sweeps"):
        for public in sorted(importlib.import_module(module).__all__):
            function = getattr(importlib.import_module(module), public, None)
            if not inspect.isfunction(function):
                continue
            taken = inspect.signature(function).parameters.values()
            needed = {
                arg.name: BASE if "Parameter" in str(arg.annotation) else OTHERS.get(arg.name)
                for arg in taken
                if arg.default is arg.empty and arg.kind is not arg.VAR_KEYWORD
            }
            if None in needed.values():
                continue
            for arg in taken:
                kind = str(arg.annotation)
                if "ArrayLike" in kind or kind.startswith("float"):
                    yield function, needed, arg.name, one
                elif "Ranges" in kind:
                    bad = {name: (one, Thrust(4.0)) for name in ("theta0", "mu0", "x")}
                    for name, ends in bad.items():
                        yield function, needed, arg.name, {name: ends}


@pytest.mark.thorough
def test_no_number_of_any_question_loses_its_unit() -> None:
    """A unit that is not understood is an error of every argument that takes numbers."""
    for function, needed, name, bad in numeric():
        where = name
        if inspect.signature(function).parameters[name].kind is inspect.Parameter.VAR_KEYWORD:
            where = "V"
        with pytest.raises(ss.errors.SpragsymError) as refused:
            function(**{**needed, where: bad})
        if "kN" in str(refused.value):
            continue
        # Something else is missing, of a bare number as well.
        bare = 3.0 if isinstance(bad, Thrust) else dict.fromkeys(bad, (3.0, 4.0))
        with pytest.raises(ss.errors.SpragsymError) as same:
            function(**{**needed, where: bare})
        assert str(refused.value) == str(same.value), (function, name)


#: Words that pint takes for a unit, and engineers for another, or for none.
WORDS = "mt pc ct dr cwt u th li hand rod c ton gr grad pt oz nmi at kt amu l dt B perch"


def test_a_word_of_several_meanings_is_refused_with_what_to_write() -> None:
    for word in re.findall(r"\w+", WORDS):
        for text in (word, f"N/{word}", f"{word}^2"):
            words = r"meanings|is not read; write m, g|is not known; write m, g|no unit"
            with pytest.raises(ss.errors.ParameterError, match=words):
                factor(text, "m")


def test_every_word_that_is_read_is_read_as_pint_writes_it_too() -> None:
    pint = pytest.importorskip("pint")
    registry = pint.application_registry
    known = units._words()
    for word, name in known.items():
        if word in units._TWO_MEANINGS:
            continue
        assert _as_pint(word, registry.Unit(name)), word
        written = str(registry.Unit(name))
        if written not in units._TWO_MEANINGS:  # what pint calls a ton
            assert units.parsed(written) == units.parsed(word), word
    assert len(known) > 200


def test_products_of_units_are_read_as_pint_reads_them() -> None:
    registry = pytest.importorskip("pint").application_registry
    random = np.random.default_rng(8)
    words = sorted(set(units._words()) - set(units._TWO_MEANINGS) - {"°"})
    for _ in range(60):
        one, two, three = random.choice(words, 3)
        power = random.choice(["", "^2", "**-1", "^(3/2)", "^-2"])
        text = random.choice([f"{one}/({two} {three}{power})", f"{one} {two}{power}/{three}"])
        named = re.sub(r"[a-zA-Zµμ_]+", lambda found: units._words()[found[0]], text)
        assert _as_pint(text, registry.parse_units(named)), text


def test_units_that_pint_prints_are_read() -> None:
    """Powers of several factors, raised or behind a sign."""
    assert factor("kg m^2 s^-2", "N m") == factor("kg·m²·s⁻²", "N m") == 1.0
    assert factor("kg * m ** 2 / s ** 2", "N m") == 1.0


@pytest.mark.parametrize(
    "text", ["m^2^3", "(m^9 s)^9", "m²2", "J⁻¹^2", "10 N", "N//m", "m^s", "s^(1/0)", "((m"]
)
def test_what_is_no_product_of_powers_is_refused(text: str) -> None:
    with pytest.raises(
        ss.errors.ParameterError, match=r"is not known|can't be read|does not measure"
    ):
        factor(text, "m")


def _as_pint(text: str, other: Any) -> bool:
    """Whether a unit has the size in SI and the dimension that pint's own definitions give it."""
    base = (1 * other).to_base_units()
    powers = {name: float(power) for name, power in base.unit_items()}
    axes = {"kilogram": "[mass]", "meter": "[length]", "second": "[time]", "radian": "[angle]"}
    mine = units.dimension(text)
    same = all(
        np.isclose(powers.get(name, 0), float(mine.get(axis, 0)), atol=1e-12)
        for name, axis in axes.items()
    )
    size = float(units._size(text)) / 1000.0 ** float(mine.get("[mass]", 0))
    return same and bool(np.isclose(size, base.magnitude, rtol=1e-13, atol=0))


@pytest.mark.parametrize(
    ("text", "si", "value"),
    [
        ("µm", "m", 1e-6),
        ("daN", "N", 10.0),
        ("kN/mm", "N/m", 1e6),
        ("MPa·mm", "N/m", 1e3),
        ("lbf/in", "N/m", 4.4482216152605 / 0.0254),
        ("psi in", "N/m", 4.4482216152605 / 0.0254),
        ("ft", "m", 0.3048),
        ("t", "kg", 1000.0),
        ("km/h", "m/s", 1 / 3.6),
        ("m/min", "m/s", 1 / 60),
        ("mm²/s²", "m^2/s^2", 1e-6),
        ("°", "rad", math.pi / 180),
        ("rpm", "rad/s", math.pi / 30),
        ("kgf", "N", 9.80665),
        ("bar cm", "N/m", 1e3),
    ],
)
def test_units_of_engineers_are_read(text: str, si: str, value: float) -> None:
    assert factor(text, si) == pytest.approx(value, rel=1e-14)
