"""``python -m validation`` lists the campaigns; ``python -m validation NAME [NUMBER] [--first K]
[--seed S] [--folder F]`` runs one.

``python -m validation all --folder F [--seconds T]`` runs every one after another, each for its own
number of cases and at most T seconds (900). A campaign is a module with ``judge(number, rng)``,
which draws a case and gives what was found as a dictionary: ``kind``, ``wrong`` (a list of
contradictions), and numbers, of which integers are added up and the largest of floats is kept. With
a folder every finished case stands in ``NAME-KEY.jsonl``, from which the same command goes on; the
key is made of the campaign, the seed, and all the code that computes and judges, so that no result
of another claim is counted.
"""

import argparse
import ast
import hashlib
import importlib
import json
import signal
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np

HERE = Path(__file__).resolve().parent
#: What a result depends on.
CODE = ("derive", "generated", "spragsym", "tests/oracles", "validation", "constraints.txt")
#: Seconds of processor time after which a case is given up, and counted as late.
PATIENCE = 600.0

Judge = Callable[[int, np.random.Generator], dict[str, Any]]


class Late(BaseException):
    """A case has had its time."""


def names() -> list[str]:
    """The modules that judge cases."""
    return sorted(
        path.stem
        for path in HERE.glob("[a-z]*.py")
        if "\ndef judge(" in path.read_text(encoding="utf-8")
    )


def code() -> str:
    """A digest of all files that compute and judge."""
    found = hashlib.sha256()
    for part in CODE:
        place = HERE.parent / part
        for path in sorted(place.rglob("*")) if place.is_dir() else [place]:
            if (
                path.suffix in (".py", ".c", ".h", ".json", ".toml", ".txt")
                and "__pycache__" not in path.parts
            ):
                found.update(f"{path.relative_to(HERE.parent)}\n".encode() + path.read_bytes())
    return found.hexdigest()


def store_of(folder: Path, name: str, seed: int) -> Path:
    """The file of a campaign's finished cases, for one seed, claim and code."""
    key = hashlib.sha256(f"{name}\n{seed}\n{code()}".encode()).hexdigest()[:16]
    return folder / f"{name.split()[0]}-{key}.jsonl"


def finished(path: Path) -> dict[int, dict[str, Any]]:
    """The finished cases of a file by number; a line that was cut short by a kill is dropped from
    it.
    """
    if not path.is_file():
        return {}
    whole = [
        line
        for line in path.read_text(encoding="utf-8").splitlines(keepends=True)
        if line.endswith("\n")
    ]
    path.write_text("".join(whole), encoding="utf-8")
    return {line["number"]: line for line in map(json.loads, whole)}


def in_time(judge: Judge, number: int, seed: int) -> dict[str, Any]:
    """What is found for a case; that it took too long, or that it ended with an error, which is
    wrong.
    """

    def stop(*_: Any) -> None:
        raise Late

    before = signal.signal(signal.SIGPROF, stop)
    signal.setitimer(signal.ITIMER_PROF, PATIENCE)
    begun = time.process_time()
    try:
        found = judge(number, np.random.default_rng([seed, number]))
    except Late:
        found = {"kind": "late", "wrong": []}
    except Exception as error:  # whatever it is, it is a finding
        found = {"kind": "error", "wrong": [f"{type(error).__name__}: {error}"[:500]]}
    finally:
        signal.setitimer(signal.ITIMER_PROF, 0.0)
        signal.signal(signal.SIGPROF, before)
    return {"number": number, **found, "seconds": time.process_time() - begun}


def cases(
    judge: Judge, numbers: range, seed: int, path: Path | None, seconds: float
) -> Iterator[dict[str, Any]]:
    """All cases: those of the file, and the others until the time is over."""
    done, end = {} if path is None else finished(path), time.monotonic() + seconds
    for number in numbers:
        if number not in done:
            if time.monotonic() > end:
                return
            done[number] = in_time(judge, number, seed)
            if path is not None:
                with path.open("a", encoding="utf-8") as file:
                    file.write(json.dumps(done[number], default=float) + "\n")
        yield done[number]


def summed(found: list[dict[str, Any]]) -> str:
    """How many of cases are contradicted, the sums of their integers and the largest of floats."""
    numbers: dict[str, list[Any]] = {}
    for case in found:
        for key, value in case.items():
            if isinstance(value, int | float) and key != "number":
                numbers.setdefault(key, []).append(value)
    told = [
        f"{key} {sum(some)}" if isinstance(some[0], int) else f"{key} {np.max(some):.3g}"
        for key, some in numbers.items()
    ]
    bad = sum(bool(case["wrong"]) for case in found)
    return ", ".join([f"{len(found)} cases", f"{bad} contradicted", *told])


def run(name: str, numbers: range, seed: int, folder: Path | None, seconds: float) -> bool:
    """Run a campaign, print each contradiction, a line for each kind and one for all cases; whether
    nothing contradicts.
    """
    module = importlib.import_module(f"validation.{name}")
    kinds: dict[str, list[dict[str, Any]]] = {}
    path = None if folder is None else store_of(folder, name, seed)
    for found in cases(module.judge, numbers, seed, path, seconds):
        kinds.setdefault(found["kind"], []).append(found)
        for text in found["wrong"]:
            print(f"  {name} {found['number']}: {text}", flush=True)
    for kind in sorted(kinds):
        print(f"  {kind}: {summed(kinds[kind])}")
    every = [found for some in kinds.values() for found in some]
    print(f"{name}, of {len(numbers)}: {summed(every)}", flush=True)
    return not any(found["wrong"] for found in every)


def main() -> int:
    """Exit code 1 if anything contradicts."""
    parser = argparse.ArgumentParser(prog="python -m validation")
    parser.add_argument("name", nargs="?", choices=[*names(), "all"], metavar="NAME")
    parser.add_argument("number", nargs="?", type=int, help="how many cases")
    parser.add_argument("--first", type=int, default=0, help="the first case")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--folder", type=Path, help="where finished cases are kept")
    parser.add_argument("--seconds", type=float, help="when no further case is begun")
    given = parser.parse_args()
    if given.name is None:
        for name in names():
            text = (
                ast.get_docstring(ast.parse((HERE / f"{name}.py").read_text(encoding="utf-8")))
                or ""
            )
            print(f"{name:16} {text.splitlines()[0]}")
        return 0
    chosen = names() if given.name == "all" else [given.name]
    seconds = given.seconds or (900.0 if given.name == "all" else np.inf)
    if given.folder is not None:
        given.folder.mkdir(parents=True, exist_ok=True)
    good = True
    for name in chosen:
        number = given.number or int(importlib.import_module(f"validation.{name}").CASES)
        good &= run(
            name, range(given.first, given.first + number), given.seed, given.folder, seconds
        )
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
