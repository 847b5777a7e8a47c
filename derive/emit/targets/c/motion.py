"""The motion in C: sizes and tables of a model, and adapters through which the stepper calls the
library's functions with arrays. The stepper is that of an FMU too.
"""

import textwrap
from collections.abc import Mapping

from ...definitions import WIDTH, Definition
from .. import Edge, Material, MotionMaterial, runtime, spoken, taken, transition
from . import kernel
from .layout import plain

#: Functions of the library that the stepper calls, and the arrays that each is given: s is the
#: state, a has accelerations, p parameters, and m the mode.
CALLED = {
    "rhs": "sp",
    "regime_rhs": "spm",
    "regime_jacobian": "spm",
    "borders": "sp",
    "border_rates": "sap",
    "layers": "spm",
    "layer_rates": "sapm",
    "turning_borders": "spm",
    "turning_rates": "sapm",
    "grip": "spm",
    "grip_slopes": "spm",
    "clock": "p",
    "geometry": "sp",
}
#: The files of the stepper, in the order in which they follow the library.
PARTS = ("tables.h", "motion.h", "stepper.c")


def stepper(material: Material, motion: MotionMaterial) -> tuple[str, str]:
    """What a header declares of the motion, and the source that follows the library's functions."""
    sizes = _sizes(material, motion)
    states = 2 * sizes["coordinates"]
    words = {
        "library": material.library,
        "LIBRARY": material.library.upper(),
        "names": textwrap.fill(
            plain(", ".join(material.parameters)), WIDTH - 3, subsequent_indent=" * "
        ),
        "parameters": str(sizes["parameters"]),
        "states": str(states),
        "modes": str(sum(sizes[name] for name in ("contacts", "sides", "layers", "turnings"))),
        "borders": str(
            sum(sizes[name] for name in ("lifts", "slides", "layers", "turnings"))
            + 2 * sizes["holds"]
        ),
        "transition": rule(),
    }
    texts = (tables(material, motion), *(runtime(__file__, name) for name in PARTS[1:]))
    return spoken(runtime(__file__, "stepper.h"), words), spoken("\n".join(texts), words)


def tables(material: Material, motion: MotionMaterial) -> str:
    """Sizes, tables and adapters of a model's motion."""
    contacts = len(motion.rooted)
    places = motion.states[: len(motion.accelerations)]
    mass = {"mass_matrix": "sp"} if "grip" in material.algebra else {}
    texts = {
        "angles": ", ".join(f"{bool(one.dimension[3]):d}" for one in places),
        "rooted": ", ".join(f"{one:d}" for one in motion.rooted),
        "of_place": ", ".join(f"{one:d}" for one in motion.of_place),
        "rubbing": ", ".join(
            f"{{{contact}, {_row(motion, contacts + side)}}}"
            for side, contact in enumerate(motion.rubbing)
        ),
        "event_borders": ", ".join(map(_event_border, motion.borders)) or '{LIFT, 0, -1, ""}',
        "adapters": adapters(material, motion, CALLED | mass),
    }
    sizes = {name: str(size) for name, size in _sizes(material, motion).items()}
    return spoken(runtime(__file__, "tables.h"), sizes | texts)


def _sizes(material: Material, motion: MotionMaterial) -> dict[str, int]:
    algebra, kinds = material.algebra, [one.kind for one in motion.borders]
    layers, turnings = (
        len(algebra[name].leaves) if name in algebra else 0
        for name in ("layers", "turning_borders")
    )
    return {
        "coordinates": len(motion.accelerations),
        "parameters": len(material.parameters),
        "contacts": len(motion.rooted),
        "sides": len(motion.rubbing),
        "lifts": kinds.count("gap") + kinds.count("face"),
        "slides": kinds.count("slip"),
        "holds": kinds.count("ahead"),
        "layers": layers,
        "turnings": turnings,
        "clock": int("clock" in algebra),
        "springs": len(algebra["geometry"].leaves) // 3 if "geometry" in algebra else 0,
    }


def adapters(material: Material, motion: MotionMaterial, called: Mapping[str, str]) -> str:
    """C functions of arrays that call those of the library which it has."""
    sizes = _sizes(material, motion)
    counts = {
        "s": 2 * sizes["coordinates"],
        "p": sizes["parameters"],
        "m": sum(sizes[name] for name in ("contacts", "sides", "layers", "turnings")),
    }
    # The elements of arrays that stand for the arguments of functions.
    elements = [f"{array}[{i}]" for array, count in counts.items() for i in range(count)]
    algebra = material.algebra
    places = dict(zip(taken(algebra["regime_rhs"], material.angles), elements, strict=True))
    names = taken(algebra["border_rates"], material.angles)
    accelerations = (name for name in names if name not in places)
    places |= {name: f"a[{i}]" for i, name in enumerate(accelerations)}
    return "\n".join(
        _adapter(material, algebra[name], arrays, places)
        for name, arrays in called.items()
        if name in algebra
    )


def rule() -> str:
    """The rule by which frictions go on."""
    source = transition()
    numbers = {item.name: (item.value, item.comment) for item in source.constants}
    functions = (kernel.routine(it, source) for it in source.routines.values())
    return "\n".join([kernel.constants(numbers), *functions])


def _adapter(
    material: Material, function: Definition, arrays: str, places: Mapping[str, str]
) -> str:
    """A C function of arrays that calls the library's with their elements; it returns 0 if that
    has a result.
    """
    head = ", ".join(f"const double *{name}" for name in arrays)
    given = ", ".join(places[name] for name in taken(function, material.angles))
    called = f"{material.library}_{function.name}({given}, result)"
    return (
        f"static int {function.name}({head}, double *result) {{ return {called} != "
        f"{material.library.upper()}_OK; }}\n"
    )


def _row(motion: MotionMaterial, index: int) -> int:
    """The index among the frictions that can stick of that at an index of the mode; −1 if it can't
    stick.
    """
    return max((one.row for one in motion.borders if one.place == index), default=-1)


def _event_border(edge: Edge) -> str:
    kind = {"gap": "lift", "face": "lift"}.get(edge.kind, edge.kind).upper()
    return (
        f'{{{kind}, {edge.place}, {edge.row}, "{edge.contact and f" of {plain(edge.contact)}"}"}}'
    )
