"""``python -m derive [--out DIR] [--variant]`` derives the article's model, checks the article, and
writes generated/; for a single page there is ``spragsym derive PAGE.py --out DIR``.
"""

import argparse
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import TypeVar

try:
    import sympy  # noqa: F401  # here only to be missed early, with a remedy
except ModuleNotFoundError:
    sys.exit("derive: SymPy is missing; in the source folder: pip install '.[derive]'")

from . import export, folder, pages
from .emit import write

try:
    from .kang_nam import (
        catastrophe,
        elimination,
        emission,
        equilibrium,
        ledger,
        linear_sprag,
        lowest_fold,
        mechanics,
    )
    from .kang_nam import page_equivalence, routh, stability, theorem
except ArithmeticError as error:  # what the article's page says can't be carried through
    sys.exit(f"derive: {error}; nothing was written")

T = TypeVar("T")


def readable() -> None:
    """Make a console that can't print Greek letters print their names."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="namereplace")


def main(arguments: list[str] | None = None) -> int:
    """Run all steps; the exit code is 0 if the files were written, 1 if a check failed and nothing
    was written, 2 for wrong usage.
    """
    parser = argparse.ArgumentParser(
        prog="python -m derive", description="Derive the model, check the article, emit generated/."
    )
    # Where everything is written unless told otherwise.
    default = Path(__file__).parent.parent / "generated"
    parser.add_argument("--out", type=Path, default=default, help="folder to write")
    parser.add_argument(
        "--variant",
        action="store_true",
        help="write even if printed rows no longer hold, as when the article's page was changed on "
        "purpose",
    )
    options = parser.parse_args(arguments)
    readable()
    _step("equations of motion (8)–(11)", mechanics.motion)
    _step("balance and matrix form (12)–(25)", equilibrium.matrix_form)
    identities = _step("elimination (20)–(26), f, the quartic in t", elimination.identities)
    _step("stability (27)–(29)", stability.stiffness)
    identities |= _step("surface, folds, cusps", catastrophe.identities)
    identities |= _step("where folds turn back", lowest_fold.identities)
    identities |= _step("linear sprag model", linear_sprag.identities)
    proof = _step("one or three", theorem.one_or_three)
    least = _step("the critical friction", lowest_fold.steps)
    damped: tuple[theorem.Step, ...] = ()
    if not options.variant:
        damped = _step("stability with damping", routh.steps)
        identities |= _step("the general way", page_equivalence.identities)
    rows = tuple(_step("check against the article", ledger.run))
    outcome = ledger.Ledger(rows, identities, proof, least, damped)

    unproved = [claim for claim, holds in identities.items() if not holds]
    unproved += [step.claim for step in (*proof, *least, *damped) if not step.holds]
    failed = ledger.failures(rows)
    for claim in unproved:
        print(f"not proved: {claim}", file=sys.stderr)
    for row in failed:
        print(
            f"{row.id} ({row.where}): {row.note}\n  printed:    {row.printed}\n  derived:    "
            f"{row.derived}\n"
            f"  difference: {row.difference}",
            file=sys.stderr,
        )
    if unproved or (failed and not options.variant):
        print(f"derive: the check failed; {options.out} is untouched", file=sys.stderr)
        return 1
    of_models = _step("models", lambda: models(options.variant))
    files = _step("emit", lambda: emission.render(outcome, of_models))
    files = write.listed(write.sealed(files))
    write.write(files, options.out)
    counts = ", ".join(f"{count} {status}" for status, count in ledger.summary(rows).items())
    print(
        f"ledger: {len(rows)} rows: {counts}; {len(identities)} identities, {len(proof)} steps of "
        f"the count theorem, {len(least)} of the critical friction and {len(damped)} of "
        "stability with damping proved"
    )
    for row in rows:
        if row.status in ("misprint", "failed"):
            print(f"  {row.id:6} {row.status}: {row.cause or row.note}")
    print(f"wrote {len(files)} files to {options.out.name}/")
    return 0


def models(variant: bool) -> dict[str, str]:
    """The files of ``generated/models``, a folder for each shipped page; in a variant only that of
    the article's page.
    """
    shared: folder.Shared = {}
    files = {
        "models/__init__.py": f'"""Models from pages, one folder each.\n\n{write.header()}\n"""\n'
    }
    article = "kang_nam"
    for path in pages.shipped():
        if variant and path.stem != article:
            continue
        model = pages.read(path)
        files |= {
            f"models/{model.name}/{name}": text
            for name, text in folder.render(model, write.header(), shared).items()
        }
        # Pages of the explorer that are written without SymPy.
        if model.name in (article, "damped") and not variant:
            module = f"models/{model.name}/{model.name}.mjs"
            files[module] = export.for_the_browser(model, write.header())
    return files


def _step(title: str, work: Callable[[], T]) -> T:
    """Run one step and print how long it took."""
    begin = time.perf_counter()
    result = work()
    print(f"{time.perf_counter() - begin:6.2f} s  {title}", flush=True)
    return result


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (ArithmeticError, OSError) as error:
        sys.exit(f"derive: {error}; nothing was written")
    except KeyboardInterrupt:
        sys.exit("derive: interrupted; nothing was written")
