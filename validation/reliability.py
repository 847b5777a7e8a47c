"""Reliability: sweeps that are killed, files that are damaged, inputs that carry what is no number.

In turn: a sweep is killed at random moments until it is through, and its file is that of a call in
one go, byte for byte; results and stores with bytes changed, cut, or put in, each refused or read
as it was; numbers with units and masks, of any container and library that is installed, converted
as by hand or refused by name; texts with characters that are not printed; folders derived again.
Commands that are killed or interrupted are those of :mod:`validation.files`.
"""

import hashlib
import importlib
import importlib.util
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import warnings
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.core.errors import DamageWarning, SpragsymError
from spragsym.files import storage
from validation import files

CASES = 160
P = ss.Parameters.article(theta0=0.8)
SWEEP = """
import numpy as np, spragsym as ss
p = ss.Parameters.article(theta0=np.linspace(0.6, 0.9, 16))
ss.rms_sweep(p, t_end=40.0, backend="scipy", store={!r}, workers={})
"""
#: Units by what they measure, and the size of each in SI, from their definitions.
UNITS = {
    "kg": {"kg": 1.0, "g": 1e-3, "lb": 0.45359237, "t": 1e3},
    "N/m": {"N/m": 1.0, "N/mm": 1e3, "kN/mm": 1e6, "lbf/inch": 4.4482216152605 / 0.0254},
    "N": {"N": 1.0, "kN": 1e3, "lbf": 4.4482216152605, "mN": 1e-3},
    "m": {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "inch": 0.0254, "ft": 0.3048},
    "rad": {"rad": 1.0, "deg": math.pi / 180, "arcmin": math.pi / 10800},
}
QUANTITIES = {
    "m": "kg",
    "k": "N/m",
    "k_x": "N/m",
    "k_c": "N/m",
    "F_L": "N",
    "L_0": "m",
    "theta0": "rad",
}
LIBRARIES = {
    "pint": lambda of: of.UnitRegistry().Quantity,
    "unyt": lambda of: of.unyt_array,
    "astropy.units": lambda of: of.Quantity,
    "quantities": lambda of: of.Quantity,
}
NOT_PRINTED = "\x00\x07\x08\x0b\x0c\x1b\x7f\x85\x9b\u00ad\u200b\u200e\u2028\u2029\u202e\u2066\ufeff"


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One attack."""
    kinds: tuple[Callable[[np.random.Generator], list[str]], ...] = (
        damaged_result,
        units,
        damaged_store,
        containers,
        texts,
        damaged_journal,
        folders,
        killed_sweep if number % 16 == 7 else damaged_result,
    )
    if number % 32 == 3:
        return files.judge(number // 32, rng)
    kind = kinds[number % 8]
    return {"kind": kind.__name__.replace("_", " "), "wrong": kind(rng)}


def killed_sweep(rng: np.random.Generator) -> list[str]:
    """The same call until it is through, killed at random moments."""
    ending, workers = str(rng.choice([".csv", ".nc"])), int(rng.integers(1, 3))
    with tempfile.TemporaryDirectory() as name:
        stores = [str(Path(name) / f"{one}{ending}") for one in ("whole", "killed")]
        calls = [[sys.executable, "-c", SWEEP.format(store, workers)] for store in stores]
        subprocess.run(calls[0], check=True, timeout=300)
        for _ in range(3):
            with subprocess.Popen(calls[1]) as process:
                time.sleep(rng.uniform(0.5, 4.0))
                process.send_signal(signal.SIGKILL)
        done = subprocess.run(calls[1], capture_output=True, text=True, timeout=300, check=False)
        left = sorted(os.listdir(name))
        if done.returncode or left != [f"killed{ending}", f"whole{ending}"]:
            return [f"{left}: {done.stderr[-300:]}"]
        whole, killed = (Path(store).read_bytes() for store in stores)
    return [] if whole == killed else [f"other bytes in a killed sweep, {ending}"]


def damage(data: bytes, rng: np.random.Generator) -> bytes:
    """Bytes changed, cut off, put in, doubled or exchanged."""
    place, other = sorted(int(one) for one in rng.integers(0, len(data), 2))
    some = rng.bytes(int(rng.integers(1, 9)))
    match int(rng.integers(5)):
        case 0:
            return (
                data[:place] + bytes([data[place] ^ int(rng.integers(1, 256))]) + data[place + 1 :]
            )
        case 1:
            return data[:place]
        case 2:
            return data[:place] + some + data[place:]
        case 3:
            return data[:place] + data[other:]
        case _:
            return data[:other] + data[place:other] + data[other:]


def damaged_result(rng: np.random.Generator) -> list[str]:
    """Forty damaged copies of a file that ``save`` wrote."""
    p = P.replace(mu0=rng.uniform(0.2, 0.8), kappa=rng.uniform(0.001, 0.05))
    found: Any = [ss.folds(p), ss.equilibria(p), ss.cusps(p)][int(rng.integers(3))]
    wrong = []
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / "a.json"
        found.save(file)
        whole = file.read_bytes()
        for _ in range(40):
            file.write_bytes(data := damage(whole, rng))
            try:
                read = ss.open(file)
            except SpragsymError:
                continue
            if repr(read) != repr(found):
                wrong.append(f"a damaged result is read as another: {data[:80]!r}")
    return wrong


def damaged_store(rng: np.random.Generator) -> list[str]:
    """Forty damaged copies of a finished sweep."""
    ending, wrong = str(rng.choice([".csv", ".nc"])), []
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / f"a{ending}"
        p = P.replace(theta0=rng.uniform(0.6, 0.9, 3))
        ss.rms_sweep(p, t_end=2.0, backend="scipy", store=file)
        whole = file.read_bytes()
        for _ in range(40):
            file.write_bytes(data := damage(whole, rng))
            try:
                storage.read(file)
            except SpragsymError:
                continue
            if data != whole:
                wrong.append(f"a damaged store is read: {len(data)} of {len(whole)} bytes")
    return wrong


def damaged_journal(rng: np.random.Generator) -> list[str]:
    """What was finished before a damage is taken as it was, or computed once more."""
    p, wrong = P.replace(theta0=rng.uniform(0.6, 0.9, 6)), []
    options: dict[str, Any] = {"t_end": 2.0, "backend": "scipy"}
    right = ss.rms_sweep(p, **options).rms

    def cut(function: Any, tasks: Any) -> Any:
        for count, task in enumerate(tasks):
            if count == 4:
                raise MemoryError
            yield function(task)

    with tempfile.TemporaryDirectory() as name, warnings.catch_warnings():
        warnings.simplefilter("ignore", DamageWarning)
        store = Path(name) / "a.csv"
        with suppress(SpragsymError):
            ss.rms_sweep(p, **options, store=store, workers=cut)
        partial = store.with_name("a.csv.partial")
        whole = partial.read_bytes()
        for _ in range(6):
            store.unlink(missing_ok=True)
            partial.write_bytes(damage(whole, rng))
            try:
                found = ss.rms_sweep(p, **options, store=store).rms
            except SpragsymError:
                continue
            if not np.array_equal(found, right):
                wrong.append(f"a damaged journal gives {found}, and {right} is right")
    return wrong


def made(rng: np.random.Generator) -> Any:
    """The quantities of a library that is installed, drawn."""
    names = [name for name in LIBRARIES if importlib.util.find_spec(name.partition(".")[0])]
    name = str(rng.choice(names))
    return LIBRARIES[name](importlib.import_module(name)), name


def units(rng: np.random.Generator) -> list[str]:
    """Brakes in drawn units against their numbers in SI by hand; and one that lacks a unit."""
    wrong = []
    quantity, library = made(rng)
    known = {
        "astropy.units": {"lb", "t", "inch", "ft", "lbf", "lbf/inch"},  # in a module of their own
        "quantities": {"mN", "t"},
    }.get(library, {"t"})
    for _ in range(20):
        values = {name: float(10 ** rng.uniform(-2, 2)) for name in QUANTITIES}
        values["theta0"] = rng.uniform(0.2, 2.8)
        given, right = dict[str, Any](), dict[str, float]()
        for name, si in QUANTITIES.items():
            unit = str(rng.choice([one for one in UNITS[si] if one not in known]))
            one = values[name] / UNITS[si][unit] if si == "rad" else values[name]
            held = quantity(one, unit)
            given[name] = [held] if rng.random() < 0.3 else held
            right[name] = one * UNITS[si][unit]
        brake = ss.PhysicalParameters(**given, k_y=0.0, mu0=0.5)
        for name, value in right.items():
            if not np.allclose(getattr(brake, name), value, rtol=1e-12):
                wrong.append(
                    f"{library}: {name} = {given[name]} is {getattr(brake, name)}, {value} is right"
                )
        name = str(rng.choice([one for one in QUANTITIES if one != "theta0"]))
        try:
            ss.PhysicalParameters(**{**given, name: values[name]}, k_y=0.0, mu0=0.5)
            wrong.append(f"{library}: {name} without a unit is taken beside others with one")
        except SpragsymError:
            pass
    return wrong


class Unknown(np.ndarray):
    """Numbers of a library that nobody knows."""

    unit = "mm"


def containers(rng: np.random.Generator) -> list[str]:
    """Numbers in nested containers, some with a mask, a boolean or a unit: as the numbers, or
    refused.
    """
    wrong = []
    for _ in range(60):
        numbers = rng.uniform(0.1, 0.9, int(rng.integers(1, 5)))
        kind = int(rng.integers(7))
        elements: list[Any] = [float(one) for one in numbers]
        place = int(rng.integers(len(elements)))
        bad = kind < 5
        if bad:
            elements[place] = (
                True,
                np.bool_(False),
                np.ma.masked,
                np.array(elements[place]).view(Unknown),
                np.array(True),
            )[kind]
        held: Any = elements
        if rng.random() < 0.3:
            held = tuple(elements)
        elif rng.random() < 0.3:
            held = np.empty(len(elements), dtype=object)
            for i, one in enumerate(elements):
                held[i] = one
        try:
            taken = P.replace(mu0=held).mu0
        except SpragsymError:
            if not bad:
                wrong.append(f"{held!r} is refused")
            continue
        if bad or not np.array_equal(taken, numbers):
            wrong.append(f"{held!r} is taken as {taken}")
    return wrong


def texts(rng: np.random.Generator) -> list[str]:
    """A brake file with a character that is not printed, anywhere in a title or beside it."""
    good = "Bremse, vorn µ₀ 制动"
    wrong = []
    example = Path(ss.__file__).parent / "report" / "brake.toml"
    lines = example.read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        file = Path(name) / "brake.toml"
        for _ in range(20):
            place, one = (
                int(rng.integers(len(good) + 1)),
                NOT_PRINTED[int(rng.integers(len(NOT_PRINTED)))],
            )
            text = good[:place] + one + good[place:]
            raw = rng.random() < 0.5
            written = f'"{text}"' if raw else json.dumps(text)
            file.write_bytes(f"{lines}\ntitle = {written}\n".encode())
            try:
                ss.Study.from_file(file)
                wrong.append(f"{text!a} is taken")
            except SpragsymError as error:
                if one in str(error):
                    wrong.append(f"the error of {text!a} holds it")
    return wrong


def folders(rng: np.random.Generator) -> list[str]:
    """A derived folder in which the user edited, added or removed something, written again."""
    write = importlib.import_module("spragsym.derive.emit.write")

    def marked(texts: dict[str, str]) -> dict[str, str]:
        digests = {one: hashlib.sha256(text.encode()).hexdigest() for one, text in texts.items()}
        about = write.as_json({"files": digests, "digest": write.DIGEST})
        return {**texts, "model.json": write.sealed_alone(about)}

    wrong = []
    for _ in range(10):
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name) / "m"
            old = marked({f"{i}.py": f"old {i}\n" for i in range(4)})
            new = marked({f"{i}.py": f"new {i}\n" for i in rng.permutation(6)[:4]})
            write.write(old, folder, mark="model.json")
            mine = dict[Path, bytes]()
            for one in rng.permutation([*new, *old, "data.csv", "n.txt"])[: int(rng.integers(4))]:
                path = folder / str(one)
                data = damage(path.read_bytes(), rng) if path.exists() else rng.bytes(20)
                if data not in (old.get(str(one), "").encode(), new.get(str(one), "").encode()):
                    path.write_bytes(data)
                    mine[path] = data
            with suppress(FileExistsError):
                write.write(new, folder, mark="model.json")
            wrong += [
                f"{path.name} is lost" for path, data in mine.items() if path.read_bytes() != data
            ]
    return wrong
