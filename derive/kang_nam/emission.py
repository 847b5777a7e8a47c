"""Every file of ``generated/``: what the article's model hands to the targets, and the ledger."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from ..emit import language, targets, double_double_kernel, write
from ..emit.function import renamed
from . import article, bounds, ledger, mechanics
from . import nomenclature as nm
from .catalogue import modules, motion

#: Algebra that a library in another language offers to its callers.
PUBLIC = (
    "contact_quartic", "liftoff_quartic", "f_coefficients", "f", "f_slope", "f_curvature",
    "t_quartic", "resolvent", "state", "residuals", "stiffness", "invariants", "damping", "characteristic",
    "spring_length", "friction", "rhs", "regime_rhs", "regime_jacobian", "energy",
)  # fmt: skip

#: What solvers call on double-double numbers: functions of the kernel with the kinds of their arguments.
WIDELY = (
    ("balance", ("Point",)), ("moderate", ("Point",)), ("representable", ("Balance",)), ("guesses", ("Point", "Balance", "Real")),
    ("at_root", ("Wide", "Point", "Balance", "Real")), ("apart", ("Wide", "Real", "Wide", "Real")),
)  # fmt: skip

#: What spragsym/kang_nam/quartic/_compiled.c calls of the kernel besides.
ASKED = ("one_or_three",)

SUMMARY = "Equilibria, stability and motion of the sprag-slip oscillator, for real-time use."
_GENERAL = Path(language.__file__).parent
_RUNTIME = Path(__file__).parent / "runtime"


def render(outcome: ledger.Ledger) -> dict[str, str]:
    """The text of every file, by its path below ``generated/``."""
    given = material()
    return {
        **targets.render(given),
        "ledger.json": write.as_json(ledger.as_dict(outcome)),
        "LEDGER.md": ledger.markdown(outcome, given.header),
    }


def material() -> targets.Material:
    """What every target prints."""
    parts = modules()
    # What code calls its own begins with an underscore, as no name of MATLAB does.
    of_page = tuple(
        replace(it, functions=tuple(renamed(function, lambda name: name.lstrip("_")) for function in it.functions))
        for it in (motion.module(),)
    )
    solver = kernel()
    arithmetic = language.read(_GENERAL / "double_double.py")
    functions = {function.name: function for module in (*parts, *of_page) for function in module.functions}
    return targets.Material(
        modules=parts,
        of_page=of_page,
        kernel=solver,
        counts=bounds.counts(solver, functions),
        quantities=mechanics.quantities(),
        parameters=tuple(map(str, (nm.theta0, *nm.PARAMETERS))),
        base_values={str(symbol): float(value) for symbol, value in article.BASE.items()},
        public=PUBLIC,
        variant=bool(mechanics.further_parameters()),
        digest=write.DIGEST,
        header=write.header(),
        summary=SUMMARY,
        runtime=own_files(),
        asked=ASKED,
        arithmetic=arithmetic,
        widened=double_double_kernel.widened(solver, arithmetic, functions, WIDELY),
    )


def kernel() -> language.Source:
    """How the equilibria of a point are found and examined, as every target prints it."""
    here = Path(__file__).parent
    return language.read(here / "kernel.py", here / "examination.py", _GENERAL / "elementary.py")


def own_files() -> dict[str, dict[str, str]]:
    """What the article's model offers besides algebra, by language: the files of ``runtime/<language>/``."""
    return {
        folder.name: {path.name: path.read_text(encoding="utf-8") for path in sorted(folder.iterdir()) if path.is_file()}
        for folder in sorted(_RUNTIME.iterdir())
    }
