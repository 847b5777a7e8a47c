"""Files of a user's under attack: commands that write are killed, interrupted, and given a full
disk; a model's folder is changed.

In turn: a kill at a random moment, Ctrl-C at one, a file system of some kilobytes, and forty
changes of one byte in a derived folder. What was there stays or is replaced whole, neighbours'
names are nobody's, Ctrl-C ends with 130 within a second, and every change is refused. Last found:
``derive --force`` deleted what stood in the folder, and Ctrl-C was lost while heyoka was imported.
"""

import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from spragsym.core.errors import SpragsymError
from validation.machine_attacks import small_disk

CASES = 40
PAGE = Path(__file__).resolve().parent.parent / "derive" / "models" / "stick_slip.py"
SHORT = ("--t-end", "100", "--transient", "50", "-q", "-o", "out.csv")
#: Commands that write, and a file that each writes.
COMMANDS = (
    (("sweep", "--theta0", "40,50", *SHORT), "out.csv"),
    (("fates", "--theta0", "30", "--t-end", "500", "-q", "-o", "out.csv"), "out.csv"),
    (("explore", "--no-open", "--out", "e.html"), "e.html"),
    (("export", "--out", "."), "spragsym.c"),
    (("figures", "4", "--out", ".", "-q", "-j", "1"), "figure_4.pdf"),
    (("check", "--report", "r.md"), "r.md"),
    (("derive", str(PAGE), "--out", "m"), "m/model.json"),
    (("bifurcation", "--mu0", "0.5", "--plot", "p.svg"), "p.svg"),
)


def begun(words: tuple[str, ...], folder: Path) -> subprocess.Popen[str]:
    """A command in a folder."""
    command = [sys.executable, "-m", "spragsym", *words, "--force"]
    signal.signal(
        signal.SIGINT, signal.default_int_handler
    )  # which a campaign in the background ignores, and what it starts
    return subprocess.Popen(
        command, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True
    )


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One attack."""
    kind = ("kill", "interrupt", "full disk", "bytes")[number % 4]
    if kind == "bytes":
        return {"kind": kind, "wrong": changed(rng)}
    words, target = COMMANDS[number // 4 % len(COMMANDS)]
    if kind != "full disk":
        with tempfile.TemporaryDirectory() as name:
            return {"kind": kind, "wrong": attacked(words, target, Path(name), rng, kind)}
    try:
        with small_disk(int(rng.choice([20, 60, 400, 4000]))) as folder:
            return {"kind": kind, "wrong": attacked(words, target, folder, rng, kind)}
    except PermissionError as error:
        return {"kind": f"{kind}: {error}", "wrong": []}


def attacked(
    words: tuple[str, ...], target: str, folder: Path, rng: np.random.Generator, kind: str
) -> list[str]:
    """What is wrong after a command that was cut off."""
    path = folder / target
    mine = (
        [folder / "notes.txt", *(path.with_name(path.name + end) for end in (".new", ".before"))]
        if "/" not in target
        else []
    )
    for one in mine:
        one.write_text("mine")
    old = "/" not in target
    if old:
        path.write_text("old")
    with begun(words, folder) as process:
        begin = time.monotonic()
        if kind != "full disk":
            time.sleep(rng.uniform(0.2, 4.0))
            process.send_signal(signal.SIGKILL if kind == "kill" else signal.SIGINT)
            begin = time.monotonic()
        _, said = process.communicate(timeout=300)
    spent, wrong = (
        time.monotonic() - begin,
        [f"{words}: {one.name} is lost" for one in mine if one.read_text() != "mine"],
    )
    if kind == "interrupt" and process.returncode not in (0, 130, -signal.SIGINT):
        wrong.append(f"{words} ends with {process.returncode}: {said[-200:]}")
    if (
        "Traceback" in said
        or "a mistake in spragsym" in said
        or (kind == "interrupt" and spent > 2)
    ):
        wrong.append(f"{words}, {spent:.1f} s: {said[-200:]}")
    if kind != "full disk":
        with tempfile.TemporaryDirectory() as other, begun(words, Path(other)) as whole:
            whole.communicate(timeout=300)
            right = (Path(other) / target).read_bytes()
        now = path.read_bytes() if path.exists() else None
        wrong += [f"{words}: {target} is half-written"] * (
            now not in ((b"old", right) if old else (None, right))
        )
    elif process.returncode and any(name.startswith(".spragsym") for name in os.listdir(folder)):
        wrong.append(f"{words} leaves what it could not write")
    return wrong


def changed(rng: np.random.Generator) -> list[str]:
    """Changes of one byte that a folder is loaded with."""
    from spragsym.derive import folder as derived

    with tempfile.TemporaryDirectory() as name:
        whole, out, wrong = Path(name) / "whole", Path(name) / "out", []
        derived.write_page(PAGE, whole)
        shutil.copytree(whole, out)
        for _ in range(40):
            path = out / str(
                rng.choice(sorted(path.name for path in whole.iterdir() if path.is_file()))
            )
            data = bytearray(path.read_bytes())
            data[place := int(rng.integers(len(data)))] ^= int(rng.integers(1, 256))
            path.write_bytes(data)
            try:
                ss.load(out)
                wrong.append(f"byte {place} of {path.name}")
            except SpragsymError:
                shutil.copy(whole / path.name, path)
    return wrong
