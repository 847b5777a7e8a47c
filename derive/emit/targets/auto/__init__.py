"""AUTO-07p: the equations file of a page's model, in Fortran, and for each proved start the
constants of a first run, which stops at the borders of its smooth regime.

Parameters stand in PAR in the page's order, then the numbers of the regime, then the margins of the
borders; PAR(10) to PAR(15) are AUTO's own.
"""

import math
import re
from collections.abc import Iterable, Iterator, Mapping

from ...names import apart
from .. import Material, MotionMaterial, Start, runtime, spoken, taken
from . import fortran

#: Branches are continued from starts.
CONTINUES = True
#: Entries of PAR that AUTO has for itself, and the number up to which it has them without a word.
_OWN, _USUAL = range(10, 16), 36
#: Modules and subroutines of AUTO, modules of compilers, words of statements, AUTO's files.
RESERVED = frozenset(
    re.findall(
        r"\w+",
        "ae auto auto_constants autompi autonompi bcnd bvp compat endfile equilibrium f2003 fconst "
        "floquet fopt fort func getp homcont icnd ieee_arithmetic ieee_exceptions ieee_features "
        "interfaces io iso_c_binding iso_fortran_env main maps mesh mpi omp_lib omp_lib_kinds "
        "openacc openacc_kinds optimization parabolic periodic procedure pvls solvebv stpnt "
        "support timeint toolboxae toolboxbv user_c",
    )
)
#: Kinds of borders, by the sign of a mode's number inside of which they hold.
_INSIDE = {"gap": "1 - 2*{}", "face": "1 - 2*{}", "slip": "{}"}


def render(material: Material) -> dict[str, str]:
    """The equations file; of a page with starts also constants and a script that runs them."""
    library, motion = material.library, material.motion
    names = fortran.distinct(material.algebra)
    words = {
        "library": library,
        "summary": "\n".join(fortran.comment(material.summary))[2:],
        "meanings": "\n".join(
            fortran.meanings(
                {
                    name: material.quantities[name].meaning
                    for name in dict.fromkeys(
                        argument
                        for function in material.algebra.values()
                        for argument in taken(function, material.angles)
                    )
                }
            )
        ),
        "header": "\n".join(fortran.comment(material.header.replace("``", "")))[2:],
        "algebra": "\n".join(
            fortran.definition(function, names[name], material.angles)
            for name, function in material.algebra.items()
        ),
        "margins": "",
    }
    if motion is None:
        return {f"{library}.f90": spoken(runtime(__file__, "module.f90"), words)}
    problem = _Problem(material, motion)
    words["margins"] = problem.margins()
    files = {
        f"{library}.f90": spoken(runtime(__file__, "module.f90"), words) + problem.shell(),
        **{f"c.{library}.{start.name}": problem.constants(start) for start in motion.starts},
    }
    if motion.starts:
        said = {
            "library": library,
            "along": motion.starts[0].along,
            "starts": ", ".join(repr(start.name) for start in motion.starts),
        }
        files[f"example_{library}.auto"] = spoken(runtime(__file__, "example.auto"), said)
    return files


class _Problem:
    """The motion of a page as AUTO's problem."""

    def __init__(self, material: Material, motion: MotionMaterial) -> None:
        self.material, self.motion = material, motion
        self.count = len(motion.accelerations)
        given = taken(material.algebra["regime_rhs"], material.angles)
        modes = given[2 * self.count + len(motion.given) :]
        margins = [edge.label(edge.kind) for edge in motion.borders]
        listed = (*(one.name for one in motion.states), *(one.name for one in motion.given))
        every = apart((*listed, *(mode.removesuffix("_") for mode in modes), *margins))
        self.unnames, parameters = every[: 2 * self.count], every[2 * self.count :]
        slots = (slot for slot in range(1, 2**15) if slot not in _OWN)
        self.slots = dict(zip(parameters, slots, strict=False))
        self.given = parameters[: len(motion.given)]
        self.modes = parameters[len(motion.given) : len(motion.given) + len(modes)]
        self.borders = parameters[len(motion.given) + len(modes) :]

    @property
    def last(self) -> int:
        """The last entry of PAR that is used."""
        return max(self.slots.values(), default=0)

    def _call(self, name: str, values: str, state: str = "u({})", called: str = "") -> str:
        """A call of a generated subroutine at a state and the parameters."""
        wanted = taken(self.material.algebra[name], self.material.angles)
        whole = taken(self.material.algebra["regime_rhs"], self.material.angles)
        texts = [state.format(index) for index in range(1, 2 * self.count + 1)]
        texts += [f"par({self.slots[one]})" for one in (*self.given, *self.modes)]
        at = dict(zip(whole, texts, strict=True))
        listed = ", ".join([*(at[one] for one in wanted), values])
        return _lines([f"call {called or name}({listed})"], "  ")

    def margins(self) -> str:
        """The subroutine that measures how far a motion stays from the borders of its regime."""
        edges, modes = self.motion.borders, self.modes
        if not edges:
            return ""
        computed = [self._call("borders", "border", "u({}, at)")]
        holds = any(edge.row >= 0 for edge in edges)
        if holds:
            computed.append(self._call("grip", "grips", "u({}, at)"))
        for index, edge in enumerate(edges, 1):
            mode = f"par({self.slots[modes[edge.place]]})"
            if edge.kind in _INSIDE:
                margin = f"({_INSIDE[edge.kind].format(mode)}) * border({edge.place + 1})"
                condition = f"if ({mode} /= 0.0d0) " if edge.kind == "slip" else ""
            else:
                margin = f"grips({2 * edge.row + 1 + (edge.kind == 'behind')})"
                condition = f"if ({mode} == 0.0d0) "
            computed.append(
                _lines([f"{condition}least({index}) = min(least({index}), {margin})"], "    ")
            )
        words = {
            "size": str(2 * self.count),
            "edges": str(len(edges)),
            "borders": str(len(self.material.algebra["borders"].leaves)),
            "grips": f", grips({len(self.material.algebra['grip'].leaves)})" if holds else "",
            "computed": "\n".join(computed),
        }
        return spoken(runtime(__file__, "margins.f90"), words)

    def shell(self) -> str:
        """The subroutines that AUTO calls."""
        n, columns = self.count, len(self.given)
        first = [self.slots[one] for one in self.borders]
        words = {
            "library": self.material.library,
            "count": str(n),
            "size": str(2 * n),
            "slopes": str(2 * n * n),
            "turns": str(n * columns),
            "last": str(self.last),
            "rhs": self._call("regime_rhs", f"f({n + 1}:{2 * n})"),
            "jacobian": self._call("regime_jacobian", "slopes"),
            "by_parameters": self._call("regime_by_parameters", "turns"),
            "columns": "\n".join(
                f"    dfdp({n} + i, {self.slots[name]}) = turns((i - 1) * {columns} + {index})"
                for index, name in enumerate(self.given, 1)
            ),
            "start": _lines(self._start(), "  "),
            "uses": "",
            "measured": "",
        }
        if first:
            words["uses"] = f"  use {self.material.library}, only: margins"
            between = {"first": str(first[0]), "last": str(first[-1])}
            words["measured"] = spoken(runtime(__file__, "measured.f90"), between).rstrip("\n")
        return spoken(runtime(__file__, "shell.f90"), words)

    def _start(self) -> Iterator[str]:
        """Assignments of the first start, or of base values at rest."""
        motion = self.motion
        if motion.starts:
            place, values, modes = self._numbers(motion.starts[0])
        else:
            place = [0.0] * (2 * self.count)
            values, modes = [one.start for one in motion.given], [1.0] * len(self.modes)
        for index, value in enumerate(place, 1):
            yield f"u({index}) = {_double(value)}"
        for name, value in zip((*self.given, *self.modes), (*values, *modes), strict=True):
            yield f"par({self.slots[name]}) = {_double(value)}"

    def _numbers(self, start: Start) -> tuple[list[float], list[float], list[float]]:
        """State, parameters and numbers of the regime."""
        return (
            [*start.place, *[0.0] * self.count],
            [start.values[one] for one in self.material.parameters],
            list(map(float, start.mode)),
        )

    def constants(self, start: Start) -> str:
        """The constants of a first run from a start, along its parameter."""
        place, values, modes = self._numbers(start)
        along = self.given[self.material.parameters.index(start.along)]
        allowed = self.motion.given[self.given.index(along)].allowed
        ends = [end for end in (allowed.low, allowed.high) if math.isfinite(end)]
        stops = {along: ends} if ends else {}
        return spoken(
            runtime(__file__, "constants"),
            {
                "said": f"{self.material.library}: steady state {start.name}, proved to "
                f"{start.error:.0e}; it goes along {along} to the borders of its regime.",
                "header": self.material.header.replace("``", ""),
                "parnames": _table({slot: repr(name) for name, slot in self.slots.items()}),
                "unames": _table({i: repr(name) for i, name in enumerate(self.unnames, 1)}),
                "size": str(2 * self.count),
                "icp": ", ".join(map(repr, (along, *self.borders))),
                "par": _table(
                    {
                        self.slots[name]: repr(float(value))
                        for name, value in zip(
                            (*self.given, *self.modes), (*values, *modes), strict=True
                        )
                    }
                ),
                "u": _table({i: repr(float(value)) for i, value in enumerate(place, 1)}),
                "npar": str(max(self.last, _USUAL)),
                "stops": ", ".join(
                    f"{name!r}: {ends}"
                    for name, ends in {**stops, **{key: [0.0] for key in self.borders}}.items()
                ),
            },
        )


def _table(entries: Mapping[int, str]) -> str:
    return ", ".join(f"{key}: {value}" for key, value in entries.items())


def _double(value: float) -> str:
    """A number in Fortran, all its digits."""
    text = repr(float(value))
    return text.replace("e", "d") if "e" in text else f"{text}d0"


def _lines(statements: Iterable[str], indent: str) -> str:
    return "\n".join(line for one in statements for line in fortran.wrapped(f"{indent}{one}"))
