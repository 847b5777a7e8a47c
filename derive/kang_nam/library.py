"""The article's model as a library in any language, printed from the generated Python package
without SymPy.
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
    """The library's files in a language by name, from the package in ``generated/``."""
    generated = _HERE.parent.parent / "generated"
    return render(written_in, lambda name: (generated / name).read_text(encoding="utf-8"))


def render(written_in: str, generated: Callable[[str], str]) -> dict[str, str]:
    """The library's files in a language by name, sealed with their digest.

    ``generated`` gives the text of a file of the generated package.
    """
    return write.sealed(targets.render(written_in, material(generated)))


def material(generated: Callable[[str], str]) -> targets.Material:
    """The material that a target prints."""
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
    # Functions of the kernel that are called on double-double numbers, with the kinds of their
    # arguments.
    widely = (
        ("balance", ("Point",)),
        ("moderate", ("Point",)),
        ("representable", ("LineBalance",)),
        ("guesses", ("Point", "LineBalance", "Real")),
        ("at_root", ("Wide", "Point", "LineBalance", "Real")),
        ("apart", ("Wide", "Real", "Wide", "Real")),
    )
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
            name: Quantity(article, meaning, unit, written(Interval(*ends)))
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
        asked=("one_or_three",),  # called by spragsym/kang_nam/quartic/_compiled.c
        arithmetic=arithmetic,
        widened=double_double_kernel.widened(solver, arithmetic, functions, widely),
    )


def kernel() -> language.Source:
    """The kernel: the search for equilibria of a point, and their examination."""
    elementary = Path(language.__file__).with_name("elementary.py")
    return language.read(_HERE / "kernel.py", _HERE / "examination.py", elementary)


def double_doubles() -> language.Source:
    """The double-double arithmetic, in the kernel's language."""
    return language.read(Path(language.__file__).with_name("double_double.py"))


def _of_page(text: str) -> tuple[Definition, ...]:
    """Functions of the article's page in the library's form."""
    by_name = {function.name: function for function in definitions.of_module(text)}
    # Functions, and the equations that they hold.
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
    """A function of the page with n̄ as the contact indicator, all boundary layers of the friction
    law switched on, and no name that begins with an underscore.
    """
    form = function.spelled(_spelled)
    statements = tuple(
        (name, value) for name, value in form.statements if not name.startswith("near")
    )
    arguments = tuple(name for name in form.arguments if not name.startswith("near"))
    # The others take all arguments of a motion.
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
