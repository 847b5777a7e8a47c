"""Rendering of all files of ``generated/``: the Python package, the C library, and the ledger."""

import re

from ..emit import python, targets, write
from ..emit.python import kernel, quantities
from ..emit.targets.javascript import kernel as in_javascript
from . import article, bounds, ledger, library, mechanics
from . import nomenclature as nm
from .catalogue import modules


def render(outcome: ledger.Ledger, models: dict[str, str]) -> dict[str, str]:
    """The texts of all files by their paths below ``generated/``; ``models`` are those of the
    models' folders.
    """
    parts = modules()
    solver = library.kernel()
    named = mechanics.quantities()
    header = write.header()
    counts = bounds.counts(
        solver, {function.name: function for module in parts for function in module.functions}
    )
    parameters = tuple(map(str, (nm.theta0, *nm.PARAMETERS)))
    base = {str(symbol): float(value) for symbol, value in article.BASE.items()}
    files = {
        **python.render(parts, named, solver, library.double_doubles(), write.DIGEST, header),
        "kernel.py": kernel.render(solver, counts, parts, header),
        "quantities.py": quantities.render(named, parameters, base, header),
        "transition.py": kernel.of_floats(targets.transition(), header),
        "transition.mjs": in_javascript.module("transition", targets.transition(), header),
        **models,
    }
    # A variant's functions have further arguments, which the library's own C files do not pass.
    in_c = {} if mechanics.further_parameters() else library.render("c", files.__getitem__)
    for source in re.findall(r'_SOURCE "(\w+)"', in_c.get("spragsym.h", "")):
        said = "Head of the SHA-256 over the C library, which extension modules are built with."
        files["__init__.py"] += f'\n#: {said}\nC_SOURCE = "{source}"\n'
    return {
        **files,
        **{f"c/{name}": text for name, text in in_c.items()},
        "ledger.json": write.as_json(ledger.as_dict(outcome)),
        "LEDGER.md": ledger.markdown(outcome, header),
    }
