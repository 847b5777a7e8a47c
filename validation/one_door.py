"""Hostile files at the one door: papers, cache entries, journals, models, data of brakes and CSV.

A case draws ten inputs of one kind, and gives them to the command or function that reads such
files, in a process of its own in a folder of its own. Counted are inputs whose code ran (``ran``),
that changed a file outside of that folder (``outside``), that gave a result in place of the right
one (``believed``), ended in an unexpected error (``tracebacks``), took more than their time or
memory (``beyond``), or reached a terminal or a ledger with commands in them (``raw``); ``right`` and
``judged`` are the right equations beside hostile ones, and those that were judged as right.
"""

import hashlib
import io
import json
import os
import shutil
import signal
import tempfile
import time
import tomllib
import traceback
from collections.abc import Callable
from contextlib import redirect_stderr, redirect_stdout, suppress
from dataclasses import dataclass, field
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

from spragsym.cli import main
from spragsym.files import cache as kept
from spragsym.files import journal, own, storage
from spragsym.models.load import load
from spragsym.report.friction_curve import read_friction
from spragsym.results.files import open as open_result

CASES = 120
ROOT = Path(__file__).resolve().parent.parent
#: Inputs of a case.
INPUTS = 10
#: Seconds of processor time and of the clock, and bytes, that an input may take beside its rows'.
TIME, CLOCK, MEMORY = 60.0, 300.0, 2 << 30
#: What no format may show as it is.
COMMANDS = "\x1b\x07\x00\x08\x7f\x85\x9b\u202e\u2066\u200b\u2028\u2029\ufeff\r"
TEXTS = (
    "\x1b]0;evil\x07",
    "a\r\n| 7 | Equation (7) | motion | confirmed |",
    "<script>alert(1)</script>",
    "\u202etxt.exe",
    "\u2028\x85| forged | confirmed |",
    "`</code>` <img src=x onerror=alert(1)>",
    r"\input{/etc/passwd}\write18{id}",
    "=cmd|'/c calc'!A1",
    "x" * 5000,
    "../../outside/victim",
    "__import__('os').system('touch ran')",
)
#: Options of the sweep that has a journal.
SWEEP = ("sweep", "--theta0", "40,50,60", "--t-end", "5", "--transient", "2", "-q", "-o", "out.csv")


@dataclass
class Found:
    """What is counted over the inputs of a case."""

    wrong: list[str] = field(default_factory=list)
    counts: dict[str, int] = field(
        default_factory=lambda: dict.fromkeys(
            ("inputs", "answered", "ran", "outside", "believed", "tracebacks", "beyond", "raw"), 0
        )
    )

    def add(self, what: str, said: str) -> None:
        """Count one finding, and tell it."""
        self.counts[what] += 1
        self.wrong.append(f"{what}: {said}"[:600])


@dataclass(frozen=True)
class Ended:
    """How a process ended."""

    code: int
    out: str
    err: str
    seconds: float
    memory: int
    is_late: bool


class Place:
    """A folder to work in, with a victim beside it."""

    def __init__(self, home: Path) -> None:
        self.work, self.outside = home / "work", home / "outside"
        for folder in (self.work, self.outside):
            folder.mkdir()
        (self.outside / "victim").write_text("as it was", encoding="utf-8")
        self.ran = self.outside / "ran"
        self.evil = f"import pathlib\npathlib.Path({str(self.ran)!r}).touch()\n"

    def is_as_it_was(self) -> bool:
        """Whether nothing outside has changed."""
        names = {path.name for path in self.outside.iterdir()} - {"ran"}
        victim = self.outside / "victim"
        return names == {"victim"} and victim.read_text(encoding="utf-8") == "as it was"


def alone(place: Place, body: Callable[[], int], clock: float = CLOCK) -> Ended:
    """A function in a process of its own; an exception that leaves it is a traceback."""
    said = [place.work.parent / name for name in ("out", "err")]
    if (child := os.fork()) == 0:
        code = 70
        try:
            os.setsid()
            os.chdir(place.work)
            os.environ |= {
                "XDG_CACHE_HOME": str(place.work / "cache"),
                "HOME": str(place.work),
                "OMP_NUM_THREADS": "1",
            }
            for number, path in enumerate(said, 1):
                os.dup2(os.open(path, os.O_WRONLY | os.O_CREAT | os.O_TRUNC), number)
            code = body()
        except SystemExit as stop:
            code = stop.code if isinstance(stop.code, int) else 1
        except BaseException:
            os.write(2, traceback.format_exc().encode())
        finally:
            os._exit(code)
    end, late = time.monotonic() + clock, False
    while True:
        number, status, usage = os.wait4(child, os.WNOHANG)
        if number:
            break
        if time.monotonic() > end:
            late = True
            os.killpg(child, signal.SIGKILL)
        time.sleep(0.02)
    with suppress(ProcessLookupError):
        os.killpg(child, signal.SIGKILL)  # whatever it left
    out, err = (path.read_text(encoding="utf-8", errors="replace") for path in said)
    seconds, code = usage.ru_utime + usage.ru_stime, os.waitstatus_to_exitcode(status)
    return Ended(code, out, err, seconds, usage.ru_maxrss * 1024, late)


def command(place: Place, *words: str) -> Ended:
    """A command of spragsym."""

    def asked() -> int:
        main([*words])

    return alone(place, asked)


def examined(found: Found, place: Place, ended: Ended, said: str, seconds: float = TIME) -> None:
    """Count what no input may do."""
    where = f"{said:.200}: exit {ended.code}, {ended.err[-300:]}"
    found.counts["answered"] += ended.code == 0
    if place.ran.exists():
        place.ran.unlink()
        found.add("ran", where)
    if not place.is_as_it_was():
        found.add("outside", where)
    if ended.is_late or ended.seconds > seconds or ended.memory > MEMORY:
        found.add("beyond", f"{where}; {ended.seconds:.0f} s, {ended.memory / 1e6:.0f} MB")
    elif (
        ended.code not in (0, 1, 2, 3)
        or "Traceback" in ended.err
        or "a mistake in spragsym" in ended.err
    ):
        found.add("tracebacks", where)
    if set(ended.out + ended.err) & set(COMMANDS):
        found.add("raw", where)


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """Ten inputs of one kind."""
    kind = [*KINDS][number % len(KINDS)]
    found = Found()
    with tempfile.TemporaryDirectory() as name:
        KINDS[kind](Place(Path(name)), rng, found)
    return {"kind": kind, "wrong": found.wrong, **found.counts}


# ------------------------------------------------------------------------------------------------
# papers

#: Right rows of the page stick_slip.
RIGHT = (
    {"about": "energy T", "sympy": "m*vx**2/2"},
    {"about": "energy T", "latex": r"\frac{1}{2} m \dot{x}^2"},
)


def _hostile_print(rng: np.random.Generator) -> str:
    """A print in the notation of SymPy, of what no kinetic energy is."""
    n = int(rng.integers(3, 40))
    draws = (
        "m*vx**2/2 + 1e400",
        "m*vx**2/2 + 1e-400",
        f"m*vx**2/2 + {'9' * 5000}",
        "m*vx**2/2*" + "**".join("9" * n),
        f"m*vx**2/2 + {'sin(' * 30 * n}x{')' * 30 * n}",
        f"{'(' * 20 * n}m*vx**2{')' * 20 * n}",
        "m*vx**2/2 + " + " + ".join(f"{i + 1}*x**{i % 7}*vx" for i in range(60 * n)),
        f"((m + k + x + vx + 1)**{n})**{n}",
        f"({'('.join(['m + x)**9'] * n)}",
        "max(" * n + "x" + ", vx)" * n,
        "m*vx**2/2 + factorial(10**9)",
        "m*vx**2/2 + binomial(10**8, 10**7)",
        "m*vx**2/2 + Sum(1/x, (x, 1, oo))",
        "m*vx**2/2 + zoo",
        "m*vx**2/2 + 0/0",
        "__import__('os').system('touch ../outside/ran')",
        "(lambda: open('../outside/ran', 'w'))()",
        "m.__class__.__mro__[1].__subclasses__()",
        'exec(\'open("../outside/ran", "w")\')',
        "m*vx**2/3 " + "\u202e\u2066",
        "m*vx**2/3 # " + str(rng.choice(TEXTS)),
        "".join(map(chr, rng.integers(32, 1000, 10 * n))),
        "exp(" * n + "x" + ")" * n + " + 1/x**(1/x)",
        "Piecewise((x, x > 0)," * n + "(1, True)" + ")" * n,
        "[" * 10 * n,
    )
    return draws[int(rng.integers(len(draws)))]


def _hostile_latex(rng: np.random.Generator) -> str:
    n = int(rng.integers(3, 60))
    draws = (
        r"\input{/etc/passwd} \frac{1}{3} m \dot{x}^2",
        r"\def\a{\a\a}\a",
        r"\newcommand{\m}{\m\m} \m",
        r"\frac{1}{" * n + "m" + "}" * n,
        r"\sqrt{" * 5 * n + "m" + "}" * 5 * n,
        r"\left(" * 5 * n + "x" + r"\right)" * 5 * n,
        "{" * 30 * n,
        r"\begin{matrix}" * n,
        r"\frac{1}{3} m \dot{x}^2 \text{" + str(rng.choice(TEXTS)) + "}",
        "m^{9^{9^{9^{9^{9}}}}} \\dot{x}^2",
        r"\dot{" * n + "x" + "}" * n,
        r"\sum_{i=1}^{10^{9}} m_i \dot{x}^2",
        r"\int_0^\infty " * n + "m",
        "m x " * 300 * n,
        r"\frac{d^{9999}}{dt^{9999}} x",
        "".join(map(chr, rng.integers(32, 127, 20 * n))),
    )
    return draws[int(rng.integers(len(draws)))]


def _statement(number: str, parts: dict[str, str]) -> str:
    return "\n".join(
        [
            "[[statement]]",
            f"id = {json.dumps(number)}",
            *(f"{name} = {json.dumps(text)}" for name, text in parts.items()),
            "",
        ]
    )


def papers(place: Place, rng: np.random.Generator, found: Found) -> None:
    """Ten hostile rows between right ones; their paper names code, or has a hostile head."""
    found.counts |= {"right": 0, "judged": 0}
    (place.work / "evil.py").write_text(place.evil, encoding="utf-8")
    rows = [_statement("right 1", RIGHT[0])]
    for number in range(INPUTS):
        text = _hostile_print(rng) if rng.random() < 0.6 else ""
        parts = {"sympy": text} if text else {"latex": _hostile_latex(rng)}
        abouts = ("energy T", "energy T", "motion", "other", "definition", "notation", "x" * 300)
        parts["about"] = abouts[int(rng.integers(7))] if rng.random() < 0.4 else "energy T"
        for name in ("where", "note"):
            if rng.random() < 0.5:
                parts[name] = str(rng.choice(TEXTS))
        rows.append(_statement(f"hostile {number} {str(rng.choice(TEXTS))[:60]}", parts))
    rows.insert(1 + INPUTS // 2, _statement("right 2", RIGHT[1]))
    rows.append(_statement("right 3", RIGHT[0]))
    heads = (
        f"symbols = {{ m = {json.dumps(TEXTS[-1])} }}",
        "a = " + "[" * 400 + "]" * 400,
        ".".join("a" * 300) + " = 1",
        "a = 1e400",
        f"model = {json.dumps(TEXTS[0])}",
        f"{json.dumps(TEXTS[1])} = 1",
        f"conventions = [{json.dumps(TEXTS[-1])}]",
    )
    asks = tuple[str, ...]()
    drawn = rng.random()
    if drawn < 0.25:  # code that is named does not run; then the page is given
        model = str(rng.choice(["evil.py", str(place.work / "evil.py"), "../work/evil.py", "."]))
        head = f"model = {json.dumps(model)}\n"
        asks = ("--model", "stick_slip")
    elif drawn < 0.4:
        head = f"{heads[int(rng.integers(len(heads)))]}\n"
    else:
        head = 'model = "stick_slip"\n'
    title = f"paper = {json.dumps(str(rng.choice(TEXTS)))}\n" if rng.random() < 0.5 else ""
    file = place.work / "paper.toml"
    file.write_text(title + head + "\n".join(rows), encoding="utf-8", errors="surrogatepass")
    found.counts["inputs"] += INPUTS
    words = ("check", "paper.toml", "--out", "ledger", "--row-limit", "3", "--json")
    if asks:
        examined(found, place, command(place, *words), head)
    elif "stick_slip" not in head:
        asks = ("--model", "stick_slip")

    def asked() -> int:
        main([*words, *asks])

    ended = alone(place, asked, 3 * CLOCK)
    examined(found, place, ended, title + head + "; ".join(rows)[:100], TIME + 12 * INPUTS)
    for path in place.work.glob("ledger/*"):
        text = path.read_text(encoding="utf-8")
        lines = text.split("\n")
        is_forged = any(line.startswith("| 7 |") for line in lines)
        is_html = path.suffix in (".md", ".html") and ("<script" in text or "<img" in text)
        if set(text) & set(COMMANDS) or is_forged or is_html:
            found.add("raw", f"{path.name} of {file.read_text(encoding='utf-8')[:300]!r}")
    if ended.code == 2:
        if "stick_slip" in head:
            found.add("believed", f"the paper is refused for a row: {ended.err[-300:]}")
        return
    with suppress(ValueError):
        for row in json.loads(ended.out)["rows"]:
            if row["id"].startswith("right") and "symbols" in head:
                continue  # whose names mean something else
            if row["id"].startswith("right"):
                found.counts["right"] += 1
                if row["status"] == "confirmed":
                    found.counts["judged"] += 1
                else:
                    found.add("believed", f"{row['id']} is {row['status']}: {row['evidence']}")
            elif row["status"] in ("confirmed", "approximation"):
                found.add("believed", f"{row['print']:.200} is {row['status']}")


# ------------------------------------------------------------------------------------------------
# the cache


def _entries(place: Place, rng: np.random.Generator, entry: Path) -> None:
    """Damage the one entry of a cache, its key or its folder."""
    whole, victim = entry.read_bytes(), place.outside / "victim"
    signature, _, data = whole.partition(b"\n")
    key = entry.parent.with_name("spragsym-key")
    evil = str(rng.choice(["../x", "/tmp/x", str(victim), "a/../../../x", ".x", "text", "a\0b"]))
    contents: list[Any] = [{evil: "evil"}, {}, [], {"text": 1}, {"text": "evil"}, "x", None, 1e308]
    files = json.dumps(contents[int(rng.integers(len(contents)))]).encode()
    changed = bytearray(whole)
    changed[int(rng.integers(len(whole)))] ^= int(rng.integers(1, 256))
    other = entry.with_name("0.json")
    draws: list[list[tuple[Any, ...]]] = [
        [(entry.write_bytes, storage.sealed(files))],
        [(entry.write_bytes, signature + b"\n" + files)],
        [(entry.write_bytes, b"0" * len(signature) + b"\n" + files)],
        [(entry.write_bytes, files)],
        [(entry.write_bytes, changed)],
        [(entry.write_bytes, whole[: int(rng.integers(len(whole)))])],
        [(entry.write_bytes, signature + b"\n" + b"[" * 100_000)],
        [(entry.write_bytes, b'{"text": "evil"}'), (entry.chmod, 0o666)],
        [(entry.unlink,), (entry.symlink_to, victim)],
        [(entry.unlink,), (os.link, victim, entry)],
        [(entry.unlink,), (entry.mkdir,)],
        [(entry.unlink,), (os.mkfifo, entry)],
        [(entry.unlink,), (entry.symlink_to, "/dev/zero")],
        [(os.truncate, entry, 1 << 40)],
        [(key.unlink,), (key.symlink_to, victim)],
        [(key.chmod, 0o666), (entry.write_bytes, storage.sealed(files))],
        [(key.unlink,), (os.mkfifo, key)],
        [(key.write_bytes, b""), (entry.write_bytes, storage.sealed(files))],
        [(entry.parent.chmod, 0o777), (entry.write_bytes, storage.sealed(files))],
        [(shutil.rmtree, entry.parent), (entry.parent.symlink_to, place.outside)],
        [(shutil.rmtree, entry.parent), (entry.parent.write_bytes, b"x")],
        [(kept._write, other, _evil(other)), (os.replace, other, entry)],  # right by another name
    ]
    for step, *given in draws[int(rng.integers(len(draws)))]:
        step(*given)


def _evil(path: Path) -> bytes:
    data = json.dumps({"text": "evil"}).encode()
    return own.signature(own.user_key(), path.name, data) + b"\n" + data


def caches(place: Place, rng: np.random.Generator, found: Found) -> None:
    """Exports by the command, whose derivation is replaced by a text."""
    from spragsym.derive import export

    def exported(text: str) -> Callable[[], int]:
        def asked() -> int:
            vars(export)["export"] = lambda *_: {"text": text}
            main(["export", "--model", "stick_slip", "--language", "jax", "--out", "m", "--force"])

        return asked

    for number in range(INPUTS):
        shutil.rmtree(place.work / "cache", ignore_errors=True)
        shutil.rmtree(place.work / "m", ignore_errors=True)
        alone(place, exported("right"))
        (entry,) = (place.work / "cache/spragsym").glob("*.json")
        os.environ["XDG_CACHE_HOME"] = str(place.work / "cache")
        _entries(place, np.random.default_rng([int(rng.integers(2**31)), number]), entry)
        found.counts["inputs"] += 1
        for again in ("right", "right"):
            ended = alone(place, exported(again))
            examined(found, place, ended, f"cache, input {number}")
            written = {path.name: path for path in (place.work / "m").iterdir()}
            if ended.code or [*written] != ["text"] or written["text"].read_text() != "right":
                found.add("believed", f"{[*written]}, exit {ended.code}: {ended.err[-200:]}")


# ------------------------------------------------------------------------------------------------
# journals


@cache
def _sweep() -> tuple[bytes, str, list[Any]]:
    """The right result of a sweep, its fingerprint, and the numbers of a finished point."""
    with tempfile.TemporaryDirectory() as name:
        place = Place(Path(name))
        _warm(*SWEEP[:-1], str(place.work / "warm.csv"))

        def asked() -> int:
            append = journal._append

            def both(file: Any, path: Path, line: bytes) -> None:
                append(file, path, line)
                with open("lines", "ab") as log:
                    log.write(line)

            vars(journal)["_append"] = both
            main([*SWEEP])

        ended = alone(place, asked)
        if ended.code:
            raise RuntimeError(ended.err)
        data = (place.work / "out.csv").read_bytes()
        lines = (place.work / "lines").read_bytes().splitlines()
    points = [json.loads(line.partition(b" ")[2]) for line in lines]
    key = points[0]["fingerprint"]
    return data, key, points[1:]


def _journal(place: Place, rng: np.random.Generator, path: Path) -> None:
    """Right points, some of others' hands, and lines of wrong structure that the user signed; and
    what is no file.
    """
    _, about, points = _sweep()
    os.environ["XDG_CACHE_HOME"] = str(place.work / "cache")
    mine, other_key = own.user_key(), rng.bytes(32)
    _, values, _ = points[int(rng.integers(len(points)))]
    odd: list[Any] = [
        None, True, -1, 3, 10**30, 0.5, "0", [], {}, [0], {"0": 1}, float("nan"), float("inf"), "x" * 10**6,
    ]  # fmt: skip

    def one() -> Any:
        return odd[int(rng.integers(len(odd)))]

    def of(*point: Any) -> bytes:
        return journal._line(mine, about, [*point])

    def forged(*point: Any) -> bytes:
        text = json.dumps(point).encode()
        signs = (
            own.signature(other_key, about, text),
            own.signature(b"", about, text),
            hashlib.sha256(about.encode() + b" " + text).hexdigest()[:16].encode(),
            hashlib.sha256(about.encode() + b"\n" + text).hexdigest().encode(),
            right[0].partition(b" ")[0],
            b"",
        )
        return signs[int(rng.integers(len(signs)))] + b" " + text + b"\n"

    right = [of(*point) for point in sorted(points)]
    other = [*values]
    other[int(rng.integers(len(values)))] = one()
    evil = str(rng.choice(TEXTS))
    lines = (
        lambda: forged(0, values, evil),
        lambda: forged(0, [1.0 for _ in values], ""),
        lambda: forged(2, other, ""),
        lambda: right[1].replace(b"[1,", b"[0,"),
        lambda: right[0].replace(b"[0,", b"[1,"),
        lambda: right[int(rng.integers(3))],
        lambda: of(3, values, ""),
        lambda: forged(0, other, one()),
        lambda: of(0, one() or None, ""),
        lambda: of(0, [None, *values[1:]], ""),
        lambda: of(0, values[:-1], ""),
        lambda: of(0, [*values, 1.0], ""),
        lambda: of(0, values),
        lambda: of(0, values, "", one()),
        lambda: of(),
        lambda: journal._line(mine, about, one()),
        lambda: journal._line(mine, about, {"0": values}),
        lambda: of(-1, values, ""),
        lambda: of(2**70, values, ""),
        lambda: of(True, values, ""),
        lambda: of(0, [[it] for it in values], ""),
        lambda: of(0, [str(it) for it in values], ""),
        lambda: b"0" * 64 + b' [0, [1.0], ""]\n',
        lambda: own.signature(mine, about, b"[" * 10**5) + b" " + b"[" * 10**5 + b"\n",
        lambda: own.signature(mine, about, b'[0,[1e400],""]') + b' [0,[1e400],""]\n',
        lambda: journal._line(mine, "", {"journal": one(), "fingerprint": one()}),
        lambda: journal._line(other_key, "", {"journal": one(), "fingerprint": one()}),
    )
    chosen = [lines[int(rng.integers(len(lines)))]() for _ in range(int(rng.integers(1, 5)))]
    key = other_key if rng.random() < 0.2 else mine
    text = journal._Sweep(key, about, 3, None).head() + b"".join(chosen)
    if rng.random() < 0.7:
        path.write_bytes(text)
        return
    victim, new = place.outside / "victim", place.outside / "new"
    draws: list[list[tuple[Any, ...]]] = [
        [(path.symlink_to, victim)],
        [(os.link, victim, path)],
        [(path.symlink_to, new)],
        [(os.mkfifo, path)],
        [(path.mkdir,)],
        [(path.symlink_to, "/dev/zero")],
        [(path.write_bytes, rng.bytes(1000))],
        [(path.write_bytes, text), (os.truncate, path, 1 << 40)],
        [(path.symlink_to, path.name)],
    ]
    for step, *given in draws[int(rng.integers(len(draws)))]:
        step(*given)


def journals(place: Place, rng: np.random.Generator, found: Found) -> None:
    """A sweep goes on from a journal that others wrote."""
    right, _, _ = _sweep()
    for number in range(INPUTS):
        path, target = place.work / "out.csv.partial", place.work / "out.csv"
        for one in (path, target):
            if one.is_dir() and not one.is_symlink():
                one.rmdir()
            elif os.path.lexists(one):
                one.unlink()
        for one in place.outside.iterdir():
            one.unlink()
        (place.outside / "victim").write_text("as it was", encoding="utf-8")
        _journal(place, rng, path)
        found.counts["inputs"] += 1
        shown = path.read_bytes()[:2000] if path.is_file() and path.stat().st_size < 1e7 else b""
        ended = command(place, *SWEEP)
        examined(found, place, ended, f"journal, input {number}: {shown[-400:]!r}")
        if target.exists() and target.read_bytes() != right:
            found.add("believed", f"another result from {shown[-400:]!r}")
        if ended.code == 0 and not target.exists():
            found.add("believed", "success, and nothing is written")


# ------------------------------------------------------------------------------------------------
# models


def _places(data: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The places of nested data."""
    parts = data.items() if isinstance(data, dict) else enumerate(data)
    found = []
    for name, part in parts:
        found.append((*path, name))
        if isinstance(part, dict | list):
            found += _places(part, (*path, name))
    return found


def _damaged(about: dict[str, Any], rng: np.random.Generator) -> str:
    """Change one place of a model's description; what was changed."""
    odd: list[Any] = [
        None, True, -1, 10**30, 0.5, "", "x", [], {}, [0], {"0": 1}, [[1]], "__import__('os')", "x" * 10**5,
        1e300, str(rng.choice(TEXTS)), "9**9**9", -0.0,
    ]  # fmt: skip
    places = _places(about)
    *way, last = places[int(rng.integers(len(places)))]
    held: Any = about
    for part in way:
        held = held[part]
    drawn = rng.random()
    if drawn < 0.2:
        del held[last]
        return f"without {[*way, last]}"
    if drawn < 0.3 and isinstance(held, list):
        held *= 3
        return f"three times {way}"
    held[last] = odd[int(rng.integers(len(odd)))]
    return f"{[*way, last]} = {held[last]!r:.60}"


def models(place: Place, rng: np.random.Generator, found: Found) -> None:
    """Folders of models: named by data without trust; changed and sealed again."""
    from spragsym.derive.emit import write

    whole = ROOT / "generated" / "models"
    questions = (
        ("equilibria",),
        ("folds",),
        ("report", "brake.toml", "--no-oscillation", "--no-redesign"),
        ("simulate", "--t-end", "1"),
        ("report", "--example"),
    )
    for number in range(INPUTS):
        model = place.work / "model"
        shutil.rmtree(model, ignore_errors=True)
        name = str(rng.choice(["stick_slip", "two_springs", "cubic_contact", "two_blocks"]))
        if not (whole / name).is_dir():
            name = "stick_slip"
        shutil.copytree(whole / name, model)
        about = json.loads((model / "model.json").read_text(encoding="utf-8"))
        with open(model / "algebra.py", "a", encoding="utf-8") as file:
            file.write(place.evil)
        names = [path.name for path in model.iterdir() if path.suffix == ".py"]
        files = {one: _sha256(model / one) for one in names}
        if "_broadcast.py" not in files:
            shutil.copy(whole.parent / "_broadcast.py", model)
            files["_broadcast.py"] = _sha256(model / "_broadcast.py")
        found.counts["inputs"] += 1
        if number == 0:  # not sealed again: it does not run, though its user names it
            ended = command(place, "equilibria", "--model", "model")
            examined(found, place, ended, "code that is changed")
            if ended.code == 0:
                found.add("believed", "code that is changed")
            continue
        about |= {"files": files, "digest": write.DIGEST}
        text = write.sealed_alone(write.as_json(about))
        (model / "model.json").write_text(text, encoding="utf-8", newline="\n")
        if number == 1:  # sealed: it runs where its user names it, and not where a file does
            (place.work / "brake.toml").write_text('model = "model"\n[brake]\nm = "1 kg"\n')
            paper = place.work / "paper.toml"
            paper.write_text('model = "model"\n' + _statement("1", RIGHT[0]), encoding="utf-8")
            for asks in (("report", "brake.toml"), ("check", "paper.toml")):
                examined(found, place, command(place, *asks), f"{asks}")
            continue
        said = _damaged(about, rng)
        with suppress(ValueError, KeyError, TypeError):
            about["digest"] = write.DIGEST
            text = write.sealed_alone(write.as_json(about))
        (model / "model.json").write_text(text, encoding="utf-8", newline="\n")
        if (place.work / "brake.toml").exists():
            (place.work / "brake.toml").unlink()
        words = questions[int(rng.integers(len(questions)))]
        ended = command(place, *words, "--model", "model")
        place.ran.unlink(missing_ok=True)  # which its user allowed
        examined(found, place, ended, f"{name}, {said}, {words[0]}")


@cache
def _warm(*words: str) -> None:
    """Load what a command needs, so that the processes of the inputs need not."""
    with suppress(SystemExit), redirect_stdout(io.StringIO()), redirect_stderr(io.StringIO()):
        main([*words])


def _sha256(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


# ------------------------------------------------------------------------------------------------
# data of brakes


@cache
def _brake() -> dict[str, Any]:
    text = (ROOT / "spragsym/report/brake.toml").read_text(encoding="utf-8")
    return tomllib.loads(text)


def data(place: Place, rng: np.random.Generator, found: Found) -> None:
    """Data of a brake with hostile values, keys, files and models."""
    (place.work / "evil.py").write_text(place.evil, encoding="utf-8")
    (place.work / "folder").mkdir()
    _warm("report", str(ROOT / "spragsym/report/brake.toml"), "--no-oscillation", "--no-redesign")
    n = int(rng.integers(3, 60))
    values = (
        "1e400 N/mm", "1e-400 N/mm", "9" * 5000 + " N/mm", "nan N/mm", "inf kg", "180 kg**9**9**9",
        "180 N/mm**" + "9" * 400, "180 " + "(" * 30 * n + "N" + ")" * 30 * n, "180 " + "*".join(["N"] * 900),
        "180 N/mm +- 1e308 %", "180 N/mm +- " + "9" * 4000, "[" * 400, "__import__('os').system('id') N",
        "180 N/mm sd 0 %", "[1, 2, 3] N/mm", "180 exec(1)", "-0 N/mm", "180 yottaN/fm", "180 °C/°F", "180 m.__class__",
    )  # fmt: skip
    files = (
        "/dev/zero",
        "../outside/victim",
        "pipe",
        "folder",
        "/proc/self/mem",
        "x" * 5000,
        "evil.py",
        "a\0b",
    )
    os.mkfifo(place.work / "pipe")
    for _ in range(INPUTS):
        brake, head = dict(_brake()["brake"]), ""
        drawn = rng.random()
        if drawn < 0.5:
            brake[str(rng.choice([*brake]))] = values[int(rng.integers(len(values)))]
        elif drawn < 0.6:
            brake[str(rng.choice(TEXTS))] = "1 kg"
        elif drawn < 0.7:
            odd: list[Any] = [None, True, 10**30, [], [["1 kg"]], {"a": {"b": 1}}, 1.5, "", -1]
            value = odd[int(rng.integers(len(odd)))]
            brake[str(rng.choice([*brake]))] = "" if value is None else value
        elif drawn < 0.8:
            brake["friction"] = files[int(rng.integers(len(files)))]
            del brake["mu0"], brake["d"]
        elif drawn < 0.9:
            brake["model"] = str(
                rng.choice(
                    ["evil.py", str(place.work / "evil.py"), "../work", "folder", *TEXTS[:3]]
                )
            )
        else:
            brake["title"] = str(rng.choice(TEXTS))
            head = str(
                rng.choice(
                    ["a = [", "[[[", '"""', "a.b.c = 1\na.b = 2\n", "\ufeff\ufeff", "a" * 10**6]
                )
            )
        text = head + "\n[brake]\n"
        text += "\n".join(f"{json.dumps(name)} = {_toml(value)}" for name, value in brake.items())
        (place.work / "brake.toml").write_text(text + "\n", encoding="utf-8")
        found.counts["inputs"] += 1
        words = ("report", "brake.toml", "--no-oscillation", "--no-redesign")
        examined(found, place, command(place, *words), text)


def _toml(value: Any) -> str:
    if isinstance(value, dict):
        return "{" + ", ".join(f"{name} = {_toml(one)}" for name, one in value.items()) + "}"
    return json.dumps(value)


# ------------------------------------------------------------------------------------------------
# CSV


def tables(place: Place, rng: np.random.Generator, found: Found) -> None:
    """Measured curves of friction, and kept results in CSV and JSON that others sealed."""
    right, _, _ = _sweep()
    model = load("kang_nam")
    for number in range(INPUTS):
        path = place.work / f"{number}.csv"
        evil = str(rng.choice(TEXTS))
        n = int(rng.integers(2, 400))
        rows = "".join(f"{v};{0.3 + v / 100}\n" for v in range(1, 9))
        heads = (
            f"v [{evil}];mu\n", f"{evil};mu\n", "v [m/s];mu" + ";a" * 100 * n + "\n", "v [m/s];v;mu\n", "\n" * n,
            "v [m/s**9**9**9];mu\n", "v [" + "(" * 40 * n + "m];mu\n", '"' * n + "\n", "v [m/s];mu\n", "v\tmu\n",
        )  # fmt: skip
        bodies = (
            rows, "1e400;0.3\n" + rows, "nan;0.3\n" + rows, "1;" + "9" * 5000 + "\n" + rows, f"1;0.3;{evil}\n{rows}",
            f"{evil};0.3\n{rows}", "1;-0.3\n" + rows, "1;0.3\n" * 60 * n, '1;"' + "x" * 10**6, ";" * 10**5 + "\n" + rows,
            "1e-320;0.3\n2e300;0.4\n", "0;0.3\n0;0.4\n", "١;0.3\n" + rows,
        )  # fmt: skip
        drawn = rng.random()
        if drawn < 0.6:
            text = heads[int(rng.integers(len(heads)))] + bodies[int(rng.integers(len(bodies)))]
            path.write_text(
                text, encoding=str(rng.choice(["utf-8", "utf-8", "utf-16", "utf-8-sig"]))
            )

            def asked(path: Path = path) -> int:
                from spragsym.core.errors import SpragsymError

                try:
                    speed, friction = read_friction(path)
                except SpragsymError as error:
                    os.write(2, str(error).encode())
                    return 2
                good = np.isfinite(speed).all() and np.isfinite(friction).all()
                return 0 if good and (friction <= 2).all() else 71

            ended = alone(place, asked)
        elif drawn < 0.85:  # a result of a sweep that others sealed
            lines = right.rpartition(storage._TRAILER)[0].decode().splitlines(keepends=True)
            for _ in range(int(rng.integers(1, 4))):
                at = int(rng.integers(len(lines)))
                changes = ("", lines[at] * 2, lines[at].replace(",", ""), lines[at].replace(": ", ":"), f"{evil}\n",
                           "," * n + "\n", lines[at].replace("0", "x"), '"' + lines[at], f"# {evil}: {evil}\n")  # fmt: skip
                lines[at] = changes[int(rng.integers(len(changes)))]
            target = place.work / "out.csv"
            target.write_bytes(storage.sealed("".join(lines).encode()))
            ended = command(place, *SWEEP)
            path = target
        else:
            about = {"class": ["spragsym", evil, {"dict": [[evil, 1]]}]}
            path = path.with_suffix(".json")
            path.write_text(json.dumps({"result": about, "sha256": "0" * 64}), encoding="utf-8")

            def opened(path: Path = path) -> int:
                from spragsym.core.errors import SpragsymError

                try:
                    open_result(path, model)
                except SpragsymError as error:
                    os.write(2, str(error).encode())
                    return 2
                return 71

            ended = alone(place, opened)
        found.counts["inputs"] += 1
        shown = path.read_bytes()[:200]
        examined(found, place, ended, f"table: {shown!r}")


KINDS: dict[str, Callable[[Place, np.random.Generator, Found], None]] = {
    "papers": papers,
    "cache": caches,
    "journals": journals,
    "models": models,
    "data": data,
    "CSV": tables,
}
