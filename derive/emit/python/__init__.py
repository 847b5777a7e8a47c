"""Python: plain algebra for any number type, the kernel for arrays, and the table of quantities."""

from collections.abc import Mapping
from pathlib import Path

from ..function import Module
from ..language import Source
from ..quantities import Quantity
from . import algebra, kernel


def render(
    modules: tuple[Module, ...],
    quantities: Mapping[str, Quantity],
    solver: Source,
    arithmetic: Source,
    digest: str,
    header: str,
) -> dict[str, str]:
    """A package: one module for each of the catalogue's, double-double numbers, and what stands
    beside them.
    """
    return {
        "__init__.py": _package(
            modules, {"kernel": solver, "double_double": arithmetic}, digest, header
        ),
        "py.typed": "",
        **{f"{module.name}.py": algebra.render(module, quantities, header) for module in modules},
        **{name: beside(name, header) for name in ("_broadcast.py", "_cube_root.py", "_where.py")},
        "double_double.py": kernel.arithmetic(arithmetic, header),
    }


def beside(name: str, header: str) -> str:
    """A file of ``runtime/``."""
    runtime = Path(__file__).parent / "runtime"
    return (runtime / name).read_text(encoding="utf-8").replace("@header@", header)


def _package(
    modules: tuple[Module, ...], sources: Mapping[str, Source], digest: str, header: str
) -> str:
    """The package's docstring, which lists its modules, and the hash by which results say what they
    were computed with.
    """
    summaries = {module.name: module.summary for module in modules}
    summaries |= {name: source.summary for name, source in sources.items()}
    summaries["quantities"] = (
        "What every name stands for, its unit, its allowed values and its value in the article."
    )
    listed = "\n".join(f"- :mod:`{name}`: {summary}" for name, summary in summaries.items())
    return (
        '"""Plain algebra, derived from first principles and checked against the '
        f'article.\n\n{listed}\n\n{header}\n"""\n\n'
        f'#: SHA-256 over all files that were generated with this one.\nSOURCE_HASH = "{digest}"\n'
    )
