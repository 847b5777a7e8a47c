"""The article's model as a library in any language, from the generated Python package; without
SymPy.
"""

import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from ..emit import definitions, double_double_kernel, language, targets, write
from ..emit.definitions import Definition
from ..emit.quantities import Interval, Quantity, written


_HERE = Path(__file__).parent


def exported(written_in: str) -> dict[str, str]:
    """The files of the library in a language, by their names, from the package that was generated
    beside this one.
    """
    generated = _HERE.parent.parent / "generated"
    return render(written_in, lambda name: (generated / name).read_text(encoding="utf-8"))


def render(written_in: str, generated: Callable[[str], str]) -> dict[str, str]:
    """The same from the texts of a generated package, given by their names; they carry the hash of
    what they are.
    """
    return write.sealed(targets.render(written_in, material(generated)))


def material(generated: Callable[[str], str]) -> targets.Material:
    """Material that every target prints."""
    package, table = generated("__init__.py"), _run(generated("quantities.py"))
    names = re.findall(r"^- :mod:`(\w+)`", package, re.MULTILINE)
    parts = [
        definitions.of_module(generated(f"{name}.py"))
        for name in names
        if name not in ("kernel", "double_double", "quantities")
    ]
    modules = (*parts, _of_page(generated("models/kang_nam/algebra.py")))
    solver, arithmetic = kernel(), double_doubles()
    functions = {function.name: function for module in modules for function in module}
    # Algebra that a library in another language offers to its callers.
    public = (
        "contact_quartic",
        "liftoff_quartic",
        "f_coefficients",
        "f",
        "f_slope",
        "f_curvature",
        "t_quartic",
        "resolvent",
        "state",
        "residuals",
        "stiffness",
        "invariants",
        "damping",
        "characteristic",
        "spring_length",
        "friction",
        "rhs",
        "regime_rhs",
        "regime_jacobian",
        "energy",
    )
    # What solvers call on double-double numbers: functions of the kernel with the kinds of
    # their arguments.
    widely = (
        ("balance", ("Point",)),
        ("moderate", ("Point",)),
        ("representable", ("LineBalance",)),
        ("guesses", ("Point", "LineBalance", "Real")),
        ("at_root", ("Wide", "Point", "LineBalance", "Real")),
        ("apart", ("Wide", "Real", "Wide", "Real")),
    )
    # What spragsym/kang_nam/quartic/_compiled.c calls of the kernel besides.
    return targets.Material(
        modules=modules,
        kernel=solver,
        counts={
            name: float(value)
            for name, value in re.findall(
                r"^(COUNT_\w+) = (.+)$", generated("kernel.py"), re.MULTILINE
            )
        },
        quantities={
            name: Quantity(name, article, meaning, unit, written(Interval(*ends)))
            for name, (article, meaning, unit, *ends) in table["QUANTITIES"].items()
        },
        parameters=table["PARAMETERS"],
        base_values=table["BASE_VALUES"],
        public=public,
        digest=write.DIGEST,
        header=package.split("\n\n")[2].partition("\n")[0],
        summary="Equilibria, stability and motion of the sprag-slip oscillator, for real-time use.",
        runtime={
            folder.name: {
                path.name: path.read_text(encoding="utf-8")
                for path in sorted(folder.iterdir())
                if path.is_file()
            }
            for folder in sorted((_HERE / "runtime").iterdir())
        },
        asked=("one_or_three",),
        arithmetic=arithmetic,
        widened=double_double_kernel.widened(solver, arithmetic, functions, widely),
    )


def kernel() -> language.Source:
    """Search for the equilibria of a point and their examination, as every target prints it."""
    elementary = Path(language.__file__).with_name("elementary.py")
    return language.read(_HERE / "kernel.py", _HERE / "examination.py", elementary)


def double_doubles() -> language.Source:
    """The arithmetic on which the kernel runs a second time."""
    return language.read(Path(language.__file__).with_name("double_double.py"))


def _of_page(text: str) -> tuple[Definition, ...]:
    """Functions of the page, with n̄ for contact and all exponentials of the friction law felt; no
    name begins with an underscore.
    """
    by_name = {function.name: function for function in definitions.of_module(text)}
    # The functions of the page that the library has, and the equations that are in them.
    of_page = {
        "rhs": "(8)–(11)",
        "regime_rhs": "(8)–(10)",
        "regime_jacobian": "(8)–(10)",
        "regime_by_parameters": "(8)–(10)",
        "energy": "(1), (2)",
        "friction_force": "(8)",
    }
    return tuple(_library_form(by_name[name], equations) for name, equations in of_page.items())


def _library_form(function: Definition, equations: str) -> Definition:
    form = function.spelled(_spelled)
    statements = tuple(
        (name, value) for name, value in form.statements if not name.startswith("near")
    )
    arguments = tuple(name for name in form.arguments if not name.startswith("near"))
    # Those that take no more than they read; the others take all that a motion is given.
    if function.name in ("energy", "friction_force"):
        arguments = tuple(name for name in arguments if name in form.read)
    return replace(form, equations=equations, arguments=arguments, statements=statements)


def _spelled(text: str) -> str:
    text = re.sub(r"-near\d\*(xp\.exp\(.*\)) \+ 1", r"1 - \1", text)
    return re.sub(r"near\d\*|\b_", "", text).replace("pushing", "nbar")


def _run(text: str) -> dict[str, Any]:
    names: dict[str, Any] = {}
    exec(text, names)  # noqa: S102  # our own file, as every import is
    return names
