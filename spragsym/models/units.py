"""Units of measure by pint: parsed, checked for their dimension, and what each is in SI."""

from __future__ import annotations

import functools
import re
from typing import TYPE_CHECKING, Any

from ..errors import ParameterError

if TYPE_CHECKING:
    import pint

#: What a unit may be written with; pint's own parser sees nothing else.
_LETTERS = re.compile(r"[\w°µμΩ%*/^·⋅²³⁻¹ ().\-]{1,40}")
#: What pint knows by another meaning than many a writer's, and what says each of the two.
_TWO_MEANINGS = {
    "grad": "deg and gon", "Grad": "deg and gon", "gr": "g and grain",
    "ton": "t (1000 kg) and short_ton", "tons": "t (1000 kg) and short_ton",
    "mil": "mm and thou", "mils": "mm and thou",
}  # fmt: skip
_TORQUE = [("[length]", 2.0), ("[mass]", 1.0), ("[time]", -2.0)]


@functools.cache
def registry() -> pint.UnitRegistry[Any]:
    """The units of pint."""
    from pint import UnitRegistry

    return UnitRegistry(cache_folder=None)


@functools.lru_cache(maxsize=256)
def factor(unit: str, si: str) -> float:
    """What one ``unit`` is in the SI unit ``si``; an error for one that is not known, or is of another quantity.

    >>> import math
    >>> factor("N/mm", "N/m"), factor("deg", "rad") == math.pi / 180
    (1000.0, True)
    """
    if si == "1":
        if unit not in ("", "1", "%"):
            raise ParameterError(f"the unit {unit!r} is too much: this is a number without unit")
        return 0.01 if unit == "%" else 1.0
    wanted, given = registry().parse_units(si), parsed(unit)
    (*of_given, angle), (*of_wanted, wanted_angle) = dimension(given), dimension(wanted)
    # A torque is N m, and its stiffness N m or N m/rad: the radian is 1.
    if of_given != of_wanted or (angle != wanted_angle and of_wanted != _TORQUE):
        raise ParameterError(f"the unit {unit!r} ({given}) does not measure what {si} does")
    size: Any = registry().Quantity(1.0, given).to(wanted).magnitude
    return float(size)


def parsed(unit: str) -> pint.Unit:
    """A unit from its text."""
    powers = re.search(r"(\^|\*\*)[^*/·⋅]*(\^|\*\*)", unit)  # a power of a power may be larger than any number
    if not _LETTERS.fullmatch(unit) or powers or any(len(digits) > 2 for digits in re.findall(r"\d+", unit)):
        raise ParameterError(f"the unit {unit!r} can't be read")
    for word in re.findall(r"[^\W\d]+", unit):
        if word in _TWO_MEANINGS:
            raise ParameterError(f"the unit {word!r} has two meanings, {_TWO_MEANINGS[word]}")
    try:
        found = registry().parse_units(unit.replace("·", "*").replace("⋅", "*"))
        bare = [name for name in found._units if not any(power for _, power in dimension(registry().Unit(name)))]
        zero = registry().Quantity(0.0, found).to_base_units().magnitude
    except Exception as error:  # pint raises many kinds, of the tokenizer too
        raise ParameterError(f"the unit {unit!r} is not known") from error
    if bare:
        raise ParameterError(f"{bare[0]} in the unit {unit!r} is a factor and no unit; multiply the number by it")
    if zero != 0:
        raise ParameterError(f"the unit {unit!r} has a zero point of its own")
    return found


def dimension(unit: pint.Unit) -> tuple[Any, ...]:
    """Powers of length, mass and time, and of the radian, which pint counts as a number."""
    from pint.util import to_units_container

    powers: dict[str, Any] = dict(unit.dimensionality)
    radians: Any = to_units_container(registry().get_base_units(unit)[1]).get("radian", 0)
    return (*sorted((name, round(float(power), 9)) for name, power in powers.items()), ("angle", round(float(radians), 9)))
