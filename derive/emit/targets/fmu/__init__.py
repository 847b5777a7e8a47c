"""FMU: a page's model as an archive for importers of FMI 3.0 or 2.0, for Model Exchange and
Co-Simulation, built on the page's C library. The functions of FMI 2.0 call those of FMI 3.0.

The archive's variables have units where the data of the page came with units of measure; inside,
everything is dimensionless.
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
from dataclasses import dataclass, replace
from pathlib import Path
from xml.sax.saxutils import quoteattr

from ...expressions import number
from .. import Material, MotionMaterial, Variable, beginnings, c, runtime, spoken
from ..c import motion as c_motion
from ..c.layout import plain


def _text(name: str) -> str:
    """A source of the FMU, or that of C."""
    return runtime(c_motion.__file__ if name == "motion.h" else __file__, name)


#: Sources besides the library, which has functions of its name, an underscore, and another word.
OWN = ("fmi2.c", "fmi3.h", "fmu.c", "model.h", "motion.h")
#: Names of files, and beginnings of the names in them.
RESERVED = (
    c.RESERVED
    | {name.partition(".")[0].casefold() for name in OWN}
    | beginnings("\n".join(map(_text, OWN)))
)
#: The motion is exported as a whole.
MOVES = True


#: Versions of the standard.
VERSIONS = ("2", "3")
#: Where the two archives differ: by version the description, the file that is compiled beside the
#: library, and what the other one has alone.
_FILES = {
    "2": (
        "modelDescription2.xml",
        "fmi2.c",
        ("modelDescription.xml", "sources/buildDescription.xml"),
    ),
    "3": ("modelDescription.xml", "fmu.c", ("modelDescription2.xml", "sources/fmi2.c")),
}


@dataclass(frozen=True)
class _Told:
    """What a description says of a model, as FMI 3.0 spells it."""

    variables: list[ET.Element]  #: in the order of value references
    structure: dict[str, list[int]]  #: value references by their part in the model's structure


def render(material: Material) -> dict[str, str]:
    """The text files of both archives by their paths: descriptions and all sources."""
    library, motion = material.library, material.motion
    assert motion, "an FMU is made of a page"
    source = c.render(replace(material, motion=None))
    words = {
        "header": material.header.replace("``", ""),
        "library": library,
        "transition": c_motion.rule(),
    }
    own = ("buildDescription.xml", "fmi2.c", "fmi3.h", "fmu.c")
    texts = {name: source[name] for name in (f"{library}.c", f"{library}.h")} | {
        "model.h": _model(material, motion, words)
    }
    texts |= {name: spoken(runtime(__file__, name), words) for name in own}
    texts["motion.h"] = spoken(_text("motion.h"), words)
    token = {"token": hashlib.sha256("".join(texts.values()).encode()).hexdigest()}
    texts["model.h"] = spoken(texts["model.h"], token)
    described = words | token | _description(material.summary, motion)
    told = _told(motion)
    of_version = {"2": _in_fmi2(told, library), "3": _in_fmi3(told)}
    return {
        _FILES[one][0]: spoken(runtime(__file__, _FILES[one][0]), described | of_version[one])
        for one in VERSIONS
    } | {f"sources/{name}": text for name, text in texts.items()}


def packed(files: Mapping[str, str], version: str = "3") -> bytes:
    """The archive for a version of FMI, the same bytes for the same files and compiler; without a
    binary, and with a warning, where this machine has no compiler.

    Raises
    ------
    ChildProcessError
        If the compiler that ``CC`` names is missing, or the compiler fails.
    """
    described, compiled, others = _FILES[version]
    members = {
        "modelDescription.xml" if name == described else name: text.encode()
        for name, text in files.items()
        if name not in others
    }
    try:
        members |= _binary(members, compiled, version)
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


def _binary(members: Mapping[str, bytes], compiled: str, version: str) -> dict[str, bytes]:
    """The shared library for this machine, by its path in the archive; ``compiled`` is the source
    beside the page's library.
    """
    systems = {
        "linux": ("linux", ".so"),
        "darwin": ("darwin", ".dylib"),
        "win32": ("windows", ".dll"),
    }
    system, ending = systems[sys.platform]
    machine = platform.machine().lower()
    compiler = _compiler(os.environ.get("CC", "").strip())
    own = next(
        Path(name).name for name in members if name.endswith(".c") and Path(name).name not in OWN
    )
    sources = [compiled, own]
    library = own.replace(".c", ending)
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
                f"{shlex.join(compiler)} failed with exit code {done.returncode}: {words}; give CC "
                "a compiler of C99, as CC=gcc"
            )
        machines = {"amd64": "x86_64", "arm64": "aarch64"}
        tuple_of = f"{machines.get(machine, machine)}-{system}"
        # FMI 2.0 has names for these machines only.
        before = {
            "x86_64-linux": "linux64",
            "x86_64-windows": "win64",
            "x86_64-darwin": "darwin64",
            "aarch64-darwin": "darwin64",
        }
        folder_of = before.get(tuple_of, tuple_of) if version == "2" else tuple_of
        return {f"binaries/{folder_of}/{library}": built.read_bytes()}


def _compiler(given: str) -> list[str]:
    """The words of the command in ``CC``, as ``ccache gcc``, or without it a usual compiler."""
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


def _model(material: Material, motion: MotionMaterial, words: Mapping[str, str]) -> str:
    """The text of model.h: quantities with their units, and what the motion knows of the model."""
    besides = {"regime_by_parameters": "spm", "outputs": "spm", "output_slopes": "spm"}
    texts = {
        "units": str(len(motion.given) - len(material.parameters)),
        "outputs": str(len(motion.outputs)),
        "quantities": ",\n    ".join(map(_quantity, (*motion.given, Variable("", "")))),
        "powers": ", ".join(
            map(_powers, (*motion.states[: len(motion.accelerations)], motion.time))
        ),
        "output_powers": ", ".join(map(_powers, motion.outputs)),
        "tables": c_motion.tables(material, motion),
        "adapters": c_motion.adapters(material, motion, besides),
    }
    return spoken(runtime(__file__, "model.h"), {**words, **texts})


def _quantity(variable: Variable) -> str:
    ends = (
        f"{'-' * (end < 0)}HUGE_VAL" if math.isinf(end) else number(end) for end in _ends(variable)
    )
    numbers = [
        number(variable.start),
        *ends,
        f"{variable.input == 'continuous':d}",
        number(variable.factor),
    ]
    return f'{{"{plain(variable.name)}", {", ".join(numbers)}, {_powers(variable)}}}'


def _ends(variable: Variable) -> tuple[float, float]:
    """The smallest and the largest allowed double, since FMI has no open ends; next to an open 0
    the smallest normal one.
    """
    low, high = variable.allowed.low, variable.allowed.high
    above, below = (
        math.copysign(sys.float_info.min, to) if end == 0.0 else math.nextafter(end, to)
        for end, to in ((low, math.inf), (high, -math.inf))
    )
    return (
        above if variable.allowed.low_open and math.isfinite(low) else low,
        below if variable.allowed.high_open and math.isfinite(high) else high,
    )


def _powers(variable: Variable) -> str:
    return f"{{{', '.join(map(number, (*variable.powers, 0.0, 0.0, 0.0)[:3]))}}}"


# -----------------------------------------------------------------------------------------------
# modelDescription.xml


def _description(summary: str, motion: MotionMaterial) -> dict[str, str]:
    """The texts that descriptions share: summary, kind of names, units, and the experiment."""
    everything = (
        motion.time,
        *motion.states,
        *motion.accelerations,
        *motion.given,
        *motion.outputs,
    )
    return {
        "summary": quoteattr(summary),
        "names": "structured" if all(one.name.isascii() for one in everything) else "flat",
        "units": _units({one.unit: one for one in everything if one.unit}.values()),
        "duration": repr(1000 * motion.step),
        "step": repr(motion.step),
    }


def _in_fmi3(told: _Told) -> dict[str, str]:
    """Variables and structure in FMI 3.0."""
    parts = (
        f'<{part} valueReference="{one}"/>' for part, ones in told.structure.items() for one in ones
    )
    return {"variables": _lines(told.variables), "structure": "\n    ".join(parts)}


def _in_fmi2(told: _Told, library: str) -> dict[str, str]:
    """Variables, structure, number of event indicators and sources in FMI 2.0, which counts
    variables from 1.
    """
    types = {"Float64": "Real", "Boolean": "Boolean"}
    of_type = ("unit", "start", "min", "max", "nominal", "derivative", "reinit")
    variables = list[ET.Element]()
    for one in told.variables:
        given = dict(one.attrib)
        if "derivative" in given:
            given["derivative"] = str(int(given["derivative"]) + 1)
        typed = {name: given.pop(name) for name in of_type if name in given}
        variables.append(ET.Element("ScalarVariable", given))
        ET.SubElement(variables[-1], types[one.tag], typed)
    parts = {
        "Outputs": "Output",
        "Derivatives": "ContinuousStateDerivative",
        "InitialUnknowns": "InitialUnknown",
    }
    structure = list[ET.Element]()
    for name, part in parts.items():
        structure.append(ET.Element(name))
        for place in told.structure[part]:
            ET.SubElement(structure[-1], "Unknown", index=str(place + 1))
    sources = ET.Element("SourceFiles")
    for name in ("fmi2.c", f"{library}.c"):
        ET.SubElement(sources, "File", name=name)
    return {
        "variables": _lines(variables),
        "structure": _lines(structure),
        "indicators": str(len(told.structure["EventIndicator"])),
        "sources": ET.tostring(sources, encoding="unicode"),
    }


def _lines(elements: Iterable[ET.Element]) -> str:
    return "\n    ".join(ET.tostring(one, encoding="unicode") for one in elements)


def _told(motion: MotionMaterial) -> _Told:
    """The variables in the order of their value references, and the model's structure."""
    variables = list[ET.Element]()
    structure = {
        part: list[int]()
        for part in ("Output", "ContinuousStateDerivative", "InitialUnknown", "EventIndicator")
    }

    def add(parts: str, variable: Variable, kind: str = "Float64", **more: str) -> None:
        index = len(variables)
        attributes = {
            "name": variable.name,
            "valueReference": str(index),
            "description": variable.meaning,
            "unit": variable.unit,
            **more,
        }
        variables.append(
            ET.Element(kind, {name: value for name, value in attributes.items() if value})
        )
        for part in parts.split():
            structure[part].append(index)

    add("", motion.time, causality="independent", variability="continuous")
    for one in motion.states:
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
    for index, one in enumerate(
        (*motion.states[len(motion.accelerations) :], *motion.accelerations)
    ):
        rate = replace(one, name=f"der({motion.states[index].name})")
        add(
            "ContinuousStateDerivative InitialUnknown",
            rate,
            causality="local",
            initial="calculated",
            derivative=str(index + 1),
        )
    turned = [f"turning{count}" for count in range(1, motion.turnings + 1)]
    for name in (*(edge.label(edge.kind) for edge in motion.borders), *turned):
        add(
            "EventIndicator",
            Variable(f"clearance.{name}", f"event indicator, dimensionless: {name}"),
            causality="local",
        )
    for one in motion.given:
        least, most = (repr(end) if math.isfinite(end) else "" for end in _ends(one))
        kind = (
            {"causality": "input", "variability": one.input}
            if one.input
            else {"causality": "parameter", "variability": "tunable", "initial": "exact"}
        )
        add("", one, start=repr(one.start), min=least, max=most, **kind)
    for one in motion.outputs:
        add("Output InitialUnknown", one, causality="output", initial="calculated")
    # Outputs that say on which side of a border the state is.
    flagged = {
        "gap": ("mode.contact", "whether there is contact"),
        "face": ("mode.face", "whether the normal force is not negative"),
        "slip": ("mode.belt_ahead", "whether the belt is ahead"),
        "ahead": ("mode.sticks", "whether friction holds the mass"),
    }
    for edge in (edge for edge in motion.borders if edge.kind in flagged):
        name, meaning = flagged[edge.kind]
        add(
            "Output InitialUnknown",
            Variable(edge.label(name), ", ".join(filter(None, (meaning, edge.contact)))),
            "Boolean",
            causality="output",
            variability="discrete",
        )
    return _Told(variables, structure)


def _units(variables: Iterable[Variable]) -> str:
    """Definitions of units with their dimensions and values in SI; the standard has no fractional
    powers, so that those units have a name only.
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
