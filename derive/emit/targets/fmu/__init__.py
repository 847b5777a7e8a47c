"""FMU: a model of a page for importers of FMI 3.0, for Model Exchange and Co-Simulation, on the C
library of the same page.

An importer sees quantities and motion in their units where data came with units of measure; inside
all is dimensionless.
"""

import hashlib
import io
import math
import os
import platform
import shlex
import shutil
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree as ET
import zipfile
from collections.abc import Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from xml.sax.saxutils import quoteattr

from ...definitions import Definition
from ...expressions import number
from .. import Edge, Material, MotionMaterial, Variable, c, runtime, spoken, taken
from ..c.layout import plain


def render(material: Material) -> dict[str, str]:
    """The texts of the archive by their paths: the description and all sources."""
    library, source, seen = material.library, c.render(material), material.motion
    assert seen, "an FMU is made of a page"
    words = {"header": material.header.replace("``", ""), "library": library}
    own = ("buildDescription.xml", "fmi3.h", "motion.h", "fmu.c")
    texts = {name: source[name] for name in (f"{library}.c", f"{library}.h")} | {
        "model.h": _model(material, seen, words)
    }
    texts |= {name: spoken(runtime(__file__, name), words) for name in own}
    token = {"token": hashlib.sha256("".join(texts.values()).encode()).hexdigest()}
    texts["model.h"] = spoken(texts["model.h"], token)
    described = spoken(
        runtime(__file__, "modelDescription.xml"),
        words | token | _description(material.summary, seen),
    )
    return {"modelDescription.xml": described} | {
        f"sources/{name}": text for name, text in texts.items()
    }


def packed(files: Mapping[str, str]) -> bytes:
    """The archive, the same bytes for the same files and compiler; a warning where this machine has
    no compiler.

    A compiler that ``CC`` names and that is not there, or one that fails, is a ChildProcessError.
    """
    members = {name: text.encode() for name, text in files.items()}
    try:
        members |= _binary(members)
    except (FileNotFoundError, KeyError) as error:
        warnings.warn(
            f"the FMU has sources, and no binary for this machine: {error}; give CC a "
            "compiler of C99",
            stacklevel=2,
        )
    stream = io.BytesIO()
    with zipfile.ZipFile(stream, "w") as archive:
        for name, data in members.items():
            archive.writestr(zipfile.ZipInfo(name), data, zipfile.ZIP_DEFLATED)
    return stream.getvalue()


def _binary(members: Mapping[str, bytes]) -> dict[str, bytes]:
    """The shared library for this machine, by its path, from the compiler that CC names or the
    usual ones.
    """
    systems = {
        "linux": ("linux", ".so"),
        "darwin": ("darwin", ".dylib"),
        "win32": ("windows", ".dll"),
    }
    system, ending = systems[sys.platform]
    machine = platform.machine().lower()
    compiler = _compiler(os.environ.get("CC", "").strip())
    sources = [Path(name).name for name in members if name.endswith(".c")]
    library = next(name for name in sources if name != "fmu.c").replace(".c", ending)
    with tempfile.TemporaryDirectory() as folder:
        for name, data in members.items():
            (Path(folder) / Path(name).name).write_bytes(data)
        flags = (
            "-std=c99",
            "-O2",
            "-Werror=implicit",
            "-ffp-contract=off",
            "-fPIC",
            "-fvisibility=hidden",
            "-shared",
        )
        command = [*compiler, *flags, "-o", library, *sources, "-lm"]
        try:
            done = subprocess.run(command, cwd=folder, check=False, capture_output=True)
        except OSError as error:
            raise ChildProcessError(f"{shlex.join(compiler)} can't be run: {error}") from error
        built = Path(folder) / library
        if done.returncode or not built.is_file():
            said = (done.stderr or done.stdout).decode(errors="replace").split("\n")
            words = "; ".join([line.strip() for line in said if line.strip()][:3])
            raise ChildProcessError(
                f"{shlex.join(compiler)} failed with exit code {done.returncode}: {words}; "
                "give CC a "
                "compiler of C99, as CC=gcc"
            )
        machines = {"amd64": "x86_64", "arm64": "aarch64"}
        return {f"binaries/{machines.get(machine, machine)}-{system}/{library}": built.read_bytes()}


def _compiler(given: str) -> list[str]:
    """The words of the command that ``CC`` gives, as ``ccache gcc``, or a usual compiler."""
    if not given:
        usual = next(filter(None, map(shutil.which, ("cc", "gcc", "clang"))), None)
        if usual is None:
            raise FileNotFoundError("no C compiler was found")
        return [usual]
    try:
        words = [given] if shutil.which(given) else shlex.split(given, posix=os.name == "posix")
    except ValueError as error:
        raise ChildProcessError(
            f"CC = {given!r} can't be read: {error}; close its quotes"
        ) from error
    if not shutil.which(words[0]):
        raise ChildProcessError(
            f"CC = {given!r}: there is no program {words[0]!r}; give a compiler of C99, as CC=gcc, "
            "or leave CC out"
        )
    return words


# ------------------------------------------------------------------------------------------------
# model.h


def _model(material: Material, seen: MotionMaterial, words: Mapping[str, str]) -> str:
    """Sizes, quantities with their units, and adapters of the library's functions, which take
    arrays.
    """
    algebra, parameters, count = material.algebra, len(material.parameters), len(seen.accelerations)
    layers, turnings = (
        len(algebra[name].leaves) if name in algebra else 0
        for name in ("layers", "turning_borders")
    )
    kinds = [one.kind for one in seen.borders]
    contacts, sides = len(seen.rooted), len(seen.rubbing)
    near = contacts + sides
    sizes = {
        "coordinates": count,
        "parameters": parameters,
        "units": len(seen.given) - parameters,
        "contacts": contacts,
        "sides": sides,
        "lifts": kinds.count("gap") + kinds.count("face"),
        "slides": kinds.count("slip"),
        "holds": kinds.count("ahead"),
        "layers": layers,
        "turnings": turnings,
        "clock": "clock" in algebra,
        "springs": len(algebra["geometry"].leaves) // 3 if "geometry" in algebra else 0,
        "outputs": len(seen.outputs),
    }
    places = {
        "s": [f"s[{i}]" for i in range(2 * count)],
        "a": [f"a[{i}]" for i in range(count)],
        "l": [f"m[{i}]" for i in range(contacts, near)],
        "p": [f"p[{i}]" for i in range(parameters)],
        "m": [f"m[{i}]" for i in range(near + layers + turnings)],
        "w": [f"m[{i}]" for i in range(near + layers, near + layers + turnings)],
    }
    # Functions of the library that the motion calls, and what they are given: state,
    # accelerations, parameters, numbers of the mode.
    in_c = {
        "rhs": "sp",
        "regime_rhs": "spm",
        "regime_jacobian": "spm",
        "regime_by_parameters": "spm",
        "borders": "sp",
        "border_rates": "sap",
        "layers": "spl",
        "layer_rates": "sapl",
        "turning_borders": "spw",
        "turning_rates": "sapw",
        "grip": "spm",
        "grip_slopes": "spm",
        "outputs": "spm",
        "output_slopes": "spm",
        "clock": "p",
    }
    called = [
        _adapter(material, algebra[name], kinds, places)
        for name, kinds in in_c.items()
        if name in algebra
    ]
    geometry = algebra.get("geometry")  # none where there are no springs along lines
    if geometry and geometry.leaves:
        names = taken(algebra["rhs"], material.angles)
        variables = dict(zip(names, (*places["s"], *places["p"]), strict=True))
        own = [variables[name] for name in taken(geometry, material.angles)]
        called.append(_calling(material, geometry, "sp", own))
    texts = {
        "quantities": ",\n    ".join(map(_quantity, (*seen.given, Variable("", "")))),
        "powers": ", ".join(map(_powers, (*seen.states[:count], seen.time))),
        "angles": ", ".join(f"{bool(one.dimension[3]):d}" for one in seen.states[:count]),
        "output_powers": ", ".join(map(_powers, seen.outputs)),
        "rooted": ", ".join(f"{one:d}" for one in seen.rooted),
        "of_place": ", ".join(f"{one:d}" for one in seen.of_place),
        "rubbing": ", ".join(
            f"{{{contact}, {_row(seen, contacts + side)}}}"
            for side, contact in enumerate(seen.rubbing)
        ),
        "event_borders": ", ".join(map(_event_border, seen.borders)) or '{LIFT, 0, -1, ""}',
        "adapters": "\n".join(called),
    }
    return spoken(
        runtime(__file__, "model.h"),
        {**words, **{name: str(int(size)) for name, size in sizes.items()}, **texts},
    )


def _row(seen: MotionMaterial, index: int) -> int:
    """The number of a friction among those that hold, by that of a mode; −1 of one that doesn't."""
    return max((one.row for one in seen.borders if one.place == index), default=-1)


def _event_border(one: Edge) -> str:
    kind = {"gap": "lift", "face": "lift"}.get(one.kind, one.kind).upper()
    return f'{{{kind}, {one.place}, {one.row}, "{one.contact and f" of {plain(one.contact)}"}"}}'


def _adapter(
    material: Material, function: Definition, kinds: str, places: Mapping[str, list[str]]
) -> str:
    """A function of the library, given arrays; not 0 where it has no result."""
    given = [one for kind in kinds for one in places[kind]]
    assert len(given) == len(taken(function, material.angles)), function.name
    return _calling(material, function, kinds, given)


def _calling(material: Material, function: Definition, kinds: str, given: list[str]) -> str:
    arrays = dict.fromkeys("m" if kind in "lw" else kind for kind in kinds)
    head = ", ".join(f"const double *{name}" for name in arrays)
    called = f"{material.library}_{function.name}({', '.join(given)}, result)"
    return (
        f"static int {function.name}({head}, double *result) {{ return {called} != "
        f"{material.library.upper()}_OK; }}\n"
    )


def _quantity(one: Variable) -> str:
    ends = (f"{'-' * (end < 0)}HUGE_VAL" if math.isinf(end) else number(end) for end in _ends(one))
    numbers = [number(one.start), *ends, f"{one.input == 'continuous':d}", number(one.factor)]
    return f'{{"{plain(one.name)}", {", ".join(numbers)}, {_powers(one)}}}'


def _ends(one: Variable) -> tuple[float, float]:
    """The least and the largest double that is allowed: FMI has no open ends.

    Beside an open 0 it is the least normal one.
    """
    low, high = one.allowed.low, one.allowed.high
    above, below = (
        math.copysign(sys.float_info.min, to) if end == 0.0 else math.nextafter(end, to)
        for end, to in ((low, math.inf), (high, -math.inf))
    )
    return (
        above if one.allowed.low_open and math.isfinite(low) else low,
        below if one.allowed.high_open and math.isfinite(high) else high,
    )


def _powers(one: Variable) -> str:
    return f"{{{', '.join(map(number, (*one.powers, 0.0, 0.0, 0.0)[:3]))}}}"


# -----------------------------------------------------------------------------------------------
# modelDescription.xml


def _description(summary: str, seen: MotionMaterial) -> dict[str, str]:
    """Units, variables in the order of their value references, and what each of them is in the
    structure of the model.
    """
    everything = (seen.time, *seen.states, *seen.accelerations, *seen.given, *seen.outputs)
    variables = list[ET.Element]()
    structure = {
        part: list[str]()
        for part in ("Output", "ContinuousStateDerivative", "InitialUnknown", "EventIndicator")
    }

    def add(parts: str, one: Variable, kind: str = "Float64", **more: str) -> None:
        index = str(len(variables))
        attributes = {
            "name": one.name,
            "valueReference": index,
            "description": one.meaning,
            "unit": one.unit,
            **more,
        }
        variables.append(
            ET.Element(kind, {name: value for name, value in attributes.items() if value})
        )
        for part in parts.split():
            structure[part].append(f'<{part} valueReference="{index}"/>')

    add("", seen.time, causality="independent", variability="continuous")
    for one in seen.states:
        nominal = "" if one.nominal == 1.0 else repr(one.nominal)
        add(
            "Output",
            one,
            causality="output",
            initial="exact",
            start=repr(one.start),
            nominal=nominal,
            reinit="true" if one.reset else "",
        )
    for index, one in enumerate((*seen.states[len(seen.accelerations) :], *seen.accelerations)):
        rate = replace(one, name=f"der({seen.states[index].name})")
        add(
            "ContinuousStateDerivative InitialUnknown",
            rate,
            causality="local",
            initial="calculated",
            derivative=str(index + 1),
        )
    turned = [f"turning{count}" for count in range(1, seen.turnings + 1)]
    for name in (*(one.said(one.kind) for one in seen.borders), *turned):
        add(
            "EventIndicator",
            Variable(f"clearance.{name}", f"event indicator, dimensionless: {name}"),
            causality="local",
        )
    for one in seen.given:
        least, most = (repr(end) if math.isfinite(end) else "" for end in _ends(one))
        kind = (
            {"causality": "input", "variability": one.input}
            if one.input
            else {"causality": "parameter", "variability": "tunable", "initial": "exact"}
        )
        add("", one, start=repr(one.start), min=least, max=most, **kind)
    for one in seen.outputs:
        add("Output InitialUnknown", one, causality="output", initial="calculated")
    # Outputs that a border brings.
    flagged = {
        "gap": ("mode.contact", "whether there is contact"),
        "face": ("mode.face", "whether the normal force is not negative"),
        "slip": ("mode.belt_ahead", "whether the belt is ahead"),
        "ahead": ("mode.sticks", "whether friction holds the mass"),
    }
    for edge in (edge for edge in seen.borders if edge.kind in flagged):
        name, meaning = flagged[edge.kind]
        add(
            "Output InitialUnknown",
            Variable(edge.said(name), ", ".join(filter(None, (meaning, edge.contact)))),
            "Boolean",
            causality="output",
            variability="discrete",
        )
    return {
        "summary": quoteattr(summary),
        "names": "structured" if all(one.name.isascii() for one in everything) else "flat",
        "units": _units({one.unit: one for one in everything if one.unit}.values()),
        "duration": repr(1000 * seen.step),
        "step": repr(seen.step),
        "variables": "\n    ".join(ET.tostring(one, encoding="unicode") for one in variables),
        "structure": "\n    ".join(line for lines in structure.values() for line in lines),
    }


def _units(variables: Iterable[Variable]) -> str:
    """Every unit with its dimension and what one of it is in SI; the standard has none with broken
    powers.
    """
    units = ET.Element("UnitDefinitions")
    for one in variables:
        unit = ET.SubElement(units, "Unit", name=one.unit)
        if all(power == int(power) for power in one.dimension):
            base = {
                axis: str(power)
                for axis, power in zip(("kg", "m", "s", "rad"), one.dimension, strict=True)
                if power
            }
            ET.SubElement(unit, "BaseUnit", base, factor=repr(one.factor))
    ET.indent(units, level=1)
    return ET.tostring(units, encoding="unicode") if len(units) else ""
