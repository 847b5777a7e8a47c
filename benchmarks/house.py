"""How the code is laid out: lines by room, the longest modules and functions, the functions with most arguments, by commit.

``python -m benchmarks.house [REV [REV]] [--longest N]``: two commits side by side, by default the working tree alone; ``.`` is
the working tree. A room is a folder with modules in it; modules that stand beside rooms count as the folder that they are in.
"""

from __future__ import annotations

import argparse
import ast
import subprocess
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
#: What is written by hand; ``generated/`` is not, and links to these count once.
FOLDERS = ("derive", "spragsym", "tests", "benchmarks", "validation")


@dataclass(frozen=True)
class Function:
    """A function or method where it is defined."""

    where: str
    lines: int
    arguments: int


@dataclass(frozen=True)
class Layout:
    """The modules of one commit: path → lines, and all of their functions."""

    modules: dict[str, int]
    functions: tuple[Function, ...]

    def rooms(self) -> Counter[str]:
        """Lines by folder."""
        total: Counter[str] = Counter()
        for path, lines in self.modules.items():
            total[path.rpartition("/")[0]] += lines
        return total


def layout(rev: str) -> Layout:
    """Read a commit, or the working tree for ``.``."""
    modules, functions = {}, []
    for path, text in _here() if rev == "." else _at(rev):
        modules[path] = text.count("\n")
        functions += list(_functions(path, ast.parse(text)))
    return Layout(modules, tuple(functions))


def _here() -> Iterator[tuple[str, str]]:
    listed = ["git", "ls-files", "--cached", "--others", "--exclude-standard", *(f"{folder}/*.py" for folder in FOLDERS)]
    for path in _out(listed).splitlines():
        if (ROOT / path).is_file():
            yield path, (ROOT / path).read_text(encoding="utf-8")


def _at(rev: str) -> Iterator[tuple[str, str]]:
    for path in _out(["git", "ls-tree", "-r", "--name-only", rev, *FOLDERS]).splitlines():
        if path.endswith(".py"):
            yield path, _out(["git", "show", f"{rev}:{path}"])


def _out(command: list[str]) -> str:
    return subprocess.run(command, cwd=ROOT, check=True, capture_output=True, text=True, encoding="utf-8").stdout


def _functions(path: str, module: ast.Module) -> Iterator[Function]:
    for node in ast.walk(module):
        if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            given = node.args
            count = len(given.posonlyargs) + len(given.args) + len(given.kwonlyargs)
            own = bool(given.args) and given.args[0].arg in ("self", "cls")
            yield Function(f"{path}:{node.name}", (node.end_lineno or node.lineno) - node.lineno + 1, count - own)


def table(header: tuple[str, ...], rows: Iterator[tuple[str, ...]] | list[tuple[str, ...]]) -> str:
    """A table in Markdown."""
    lines = [header, tuple("---" for _ in header), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines) + "\n"


def shown_rooms(revs: list[str], layouts: list[Layout]) -> str:
    """Lines of every room, one column a commit."""
    counts = [one.rooms() for one in layouts]
    rows = [(room, *(f"{count[room]:,}" if room in count else "" for count in counts)) for room in sorted(set().union(*counts))]
    total = ("all", *(f"{sum(count.values()):,}" for count in counts))
    return table(("room", *revs), [*rows, total])


def shown_longest(revs: list[str], layouts: list[Layout], longest: int) -> str:
    """The largest modules and functions of what is installed, one column a commit."""
    ours = [
        Layout(
            {path: lines for path, lines in one.modules.items() if path.startswith(FOLDERS[:2])},
            tuple(function for function in one.functions if function.where.startswith(FOLDERS[:2])),
        )
        for one in layouts
    ]
    parts = []
    for title, ranked in (
        ("longest modules, lines", [Counter(one.modules) for one in ours]),
        ("longest functions, lines", [Counter({f.where: f.lines for f in one.functions}) for one in ours]),
        ("most arguments", [Counter({f.where: f.arguments for f in one.functions}) for one in ours]),
    ):
        columns = [[f"{number} {name}" for name, number in count.most_common(longest)] for count in ranked]
        parts.append(f"{title}\n\n" + table(tuple(revs), [tuple(row) for row in zip(*columns, strict=True)]))
    return "\n".join(parts)


def main() -> None:
    """Print the tables."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.house")
    parser.add_argument("revs", nargs="*", default=["."], help="commits, or . for the working tree")
    parser.add_argument("--longest", type=int, default=5, help="how many of the longest to list")
    options = parser.parse_args()
    layouts = [layout(rev) for rev in options.revs]
    print(shown_rooms(options.revs, layouts))
    print(shown_longest(options.revs, layouts, options.longest))


if __name__ == "__main__":
    main()
