"""What is known of each mutant, kept from run to run, and how much of it still holds.

A verdict names the tests behind it by stamps. A stamp is a hash of the text of a test, of what that test names in its own file,
and of the functions of the broken module that it reaches. A mutant stays killed as long as the stamp of the test that killed it
stands; one that survived meets only the tests whose stamps it has not met yet. So a run can be ended at any moment and taken up
again, and a new test is run against survivors alone.
"""

from __future__ import annotations

import ast
import hashlib
import json
from collections.abc import Iterable
from pathlib import Path
from typing import Any


def stamp(*parts: str) -> str:
    """A short hash of texts."""
    return hashlib.sha256("\0".join(parts).encode()).hexdigest()[:16]


def code_of(file: str) -> ast.Module:
    """A source file without its docstrings: prose voids no verdict."""
    tree = ast.parse(Path(file).read_text(encoding="utf-8"))
    for node in ast.walk(tree):
        if isinstance(node, ast.Module | ast.ClassDef | ast.FunctionDef) and ast.get_docstring(node, clean=False) is not None:
            node.body = node.body[1:] or [ast.Pass()]
    return tree


class Definitions:
    """The parts of a source file by name; layout, comments and docstrings do not count."""

    def __init__(self, file: str) -> None:
        self.always: list[str] = []  #: imports and whatever else defines no name of its own
        self.named: dict[str, list[ast.stmt]] = {}
        for statement in code_of(file).body:
            names = _defined(statement)
            for name in names:
                self.named.setdefault(name, []).append(statement)
            if not names:
                self.always.append(ast.unparse(statement))

    def text(self, names: Iterable[str]) -> str:
        """Some definitions, with all that they name, and what they name in turn."""
        waiting, seen = [name for name in names if name in self.named], set[str]()
        while waiting:
            name = waiting.pop()
            if name not in seen:
                seen.add(name)
                waiting.extend(used for part in self.named[name] for used in _used(part) if used in self.named)
        return "\n".join([*self.always, *(ast.unparse(part) for name in sorted(seen) for part in self.named[name])])


def _defined(statement: ast.stmt) -> list[str]:
    match statement:
        case ast.FunctionDef(name=name) | ast.ClassDef(name=name):
            return [name]
        case ast.Assign() | ast.AnnAssign() | ast.AugAssign():
            targets = statement.targets if isinstance(statement, ast.Assign) else [statement.target]
            return [part.id for target in targets for part in ast.walk(target) if isinstance(part, ast.Name)]
    return []


def _used(statement: ast.stmt) -> set[str]:
    """Names in a statement; an argument may be a fixture, a string may name one."""
    parts = list(ast.walk(statement))
    names = {part.id for part in parts if isinstance(part, ast.Name)} | {part.arg for part in parts if isinstance(part, ast.arg)}
    return names | {part.value for part in parts if isinstance(part, ast.Constant) and isinstance(part.value, str)}


class Journal:
    """Verdicts of one subject: a line each, the last one of a mutant counts."""

    def __init__(self, file: Path) -> None:
        self.file = file
        self.rows: dict[str, dict[str, Any]] = {}
        for line in file.read_text(encoding="utf-8").splitlines() if file.exists() else ():
            try:
                row = json.loads(line)
                self.rows[row["key"]] = row
            except (ValueError, KeyError, TypeError):
                continue  # cut off where a run was ended
        file.parent.mkdir(parents=True, exist_ok=True)
        whole = file.with_suffix(".new")
        whole.write_text("".join(map(_line, self.rows.values())), encoding="utf-8")
        whole.replace(file)

    def add(self, key: str, by: str, stamps: Iterable[str], seconds: float) -> None:
        """A mutant was killed by a test, of this stamp; or by none, of these."""
        self.rows[key] = {"key": key, "by": by, "stamps": sorted(stamps), "seconds": round(seconds, 2)}
        with self.file.open("a", encoding="utf-8") as out:
            out.write(_line(self.rows[key]))

    def killer(self, key: str) -> str:
        """The test that killed a mutant when it was last run, whether or not that holds still."""
        return str(self.rows.get(key, {}).get("by", ""))

    def killed(self, key: str, stamps: dict[str, str]) -> bool:
        """Whether the test that killed a mutant is as it was."""
        by = self.killer(key)
        return bool(by) and stamps.get(by) in self.rows[key]["stamps"]

    def survived(self, key: str) -> set[str]:
        """The stamps of the tests that did not notice a mutant."""
        return set() if self.killer(key) else set(self.rows.get(key, {}).get("stamps", ()))


def _line(row: dict[str, Any]) -> str:
    return json.dumps(row, ensure_ascii=False) + "\n"


def report(subject: str, lines: dict[str, int], killed: set[str], run: set[str], listed: set[str]) -> int:
    """Print the counts of a subject and its survivors; return how many mutants nobody has killed or explained, or run.

    Parameters
    ----------
    subject : str
        Its name.
    lines : dict
        The line of each mutant.
    killed, run, listed : set
        Keys of the mutants that were killed, that have a verdict at all, that are listed as equivalent.
    """
    alive = run - killed
    for key in lines:
        if key in alive - listed:
            print(f"  survives, line {lines[key]}: {key}")
    wrong = sorted((listed - lines.keys()) | (listed & killed))
    for key in wrong:
        print(f"  listed as equivalent, but killed or gone: {key}")
    left = len(lines.keys() - run - listed)
    rest = f", {len(lines) - len(run)} not run" if len(lines) > len(run) else ""
    counts = f"{len(killed)} killed, {len(alive & listed)} equivalent, {len(alive - listed)} survive{rest}"
    print(f"{subject}: {len(lines)} mutants, {counts}", flush=True)
    return len(alive - listed) + left
