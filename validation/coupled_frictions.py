"""Motions and cycles of eleven pages whose dry frictions share inertias, against an event-driven
driver with its own complementarity, a regularized law by Radau, SciPy's backend, the FMU and the
exported C.
"""

import ctypes
import subprocess
import tempfile
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

import spragsym as ss
from tests.oracles.coupled_frictions import SYSTEMS, Driver, drawn, regularized
from tests.oracles.user_pages import derived

MOTIONS = 200
CASES = MOTIONS + 60
T_END = 50.0


def judge(number: int, rng: np.random.Generator) -> dict[str, Any]:
    """One motion to t = 50, with one coefficient or two; of the last sixty one cycle."""
    name = [*SYSTEMS][number % len(SYSTEMS)]
    equal = number // len(SYSTEMS) % 2 == 0 and number < MOTIONS
    values, start = drawn(name, rng, equal)
    model = ss.load(derived(SYSTEMS[name].text, name))
    p = model.Parameters(**{each: values[each] for each in values if each in model.parameters})
    return (_motion if number < MOTIONS else _cycle)(number, name, p, values, start)


def _whole(name: str, values: dict[str, float], state: Any) -> Any:
    """A state with phase 0 and rate of the clock, if the page has one."""
    n = len(state) // 2
    return np.insert(state, [n, 2 * n], [0.0, values["w"]]) if SYSTEMS[name].clock else state


def _motion(number: int, name: str, p: Any, values: dict[str, float], start: Any) -> dict[str, Any]:
    full = _whole(name, values, start)
    by = {
        backend: ss.simulate(p, start=full, t_end=T_END, rtol=1e-12, backend=backend)
        for backend in ("heyoka", "scipy")
    }
    n = len(full) // 2
    kept = np.flatnonzero(~np.isin(np.arange(2 * n), [n - 1, 2 * n - 1] * SYSTEMS[name].clock))
    wrong, allowed = list[str](), 0.0
    for longest in (0.1, 0.01):  # steps of the driver, whose interpolant sets its error
        driver = Driver(name, values, longest)
        end = driver.run(start, T_END)
        off = max(float(np.abs(tr.state[kept, -1] - end).max()) for tr in by.values())
        allowed = allowed or _allowed(name, values, start, end)
        if off <= allowed:
            break
    for backend, tr in by.items():
        dry = tr.events.of("stick", "slip", "mass_overtakes", "belt_overtakes")
        if len(dry) != len(driver.events):
            wrong.append(f"{backend}: {len(dry)} events for {len(driver.events)}")
        if not (np.diff(tr.events.t) >= 0).all():
            wrong.append(f"{backend}: events are not in order")
        for index, contact in enumerate(entry["name"] for entry in p.model.frictions):
            limits = [
                values["mu_s"] * driver.normal(q)[index]
                for q in tr.state[kept[: n - SYSTEMS[name].clock]].T
            ]
            over = float((np.abs(tr.friction_force(contact)) - limits).max())
            if over > 1e-9:
                wrong.append(f"{backend}: friction {contact} is {over:.2g} beyond its limit")
        leap = np.abs(np.diff(tr.state[n:], axis=1)) - 20.0 * np.diff(tr.t)
        if leap.max() > 1e-9:
            wrong.append(f"{backend}: rates leap by {leap.max():.2g}")
    wrong += [f"{off:.2g} off the driver"] * (off > allowed)
    found = {"kind": name, "off": off, "events": len(driver.events)}
    if values["mu_s"] == values["mu_k"]:
        smooth = regularized(name, values, start, 10.0, 1e-5)
        found["regularized"] = float(np.abs(smooth - Driver(name, values).run(start, 10.0)).max())
        wrong += ["not as the regularized law"] * (found["regularized"] > 2e-3)
    for by, state in (("fmu", _by_fmu(name, p, full)), ("c", _by_c(name, p, full))):
        found[by] = float(np.abs(np.array(state)[kept] - end).max())
        wrong += [f"by {by} it is {found[by]:.2g} off"] * (found[by] > max(1e-6, allowed))
    return found | {"wrong": [f"{text}: {values}, {start.tolist()}" for text in wrong]}


def _allowed(name: str, values: dict[str, float], start: Any, end: Any) -> float:
    """How far a motion may be off: 1e-8, or what a change of 1e-11 of the start grows to."""
    near = Driver(name, values).run(start + 1e-11, T_END)
    return max(1e-8, 100 * float(np.abs(near - end).max()))


@cache
def _exported(name: str, language: str) -> Path:
    """The export of a page: the FMU, or a folder."""
    from spragsym.cli import main

    out = Path(tempfile.mkdtemp()) / f"{name}.{language}"
    command = ["export", "--model", str(derived(SYSTEMS[name].text, name)), "--language", language]
    try:
        main([*command, "--out", str(out)])
    except SystemExit as ended:
        if ended.code:
            raise RuntimeError(f"no {language} of {name}") from ended
    return out


@cache
def _compiled(name: str) -> ctypes.CDLL:
    """The C library of a page."""
    (source,) = (one for one in _exported(name, "c").glob("*.c") if one.name != "main.c")
    built = source.with_suffix(".so")
    flags = ("-std=c99", "-O2", "-ffp-contract=off", "-shared", "-fPIC")
    subprocess.run(["cc", *flags, "-o", built, source, "-lm"], check=True)
    return ctypes.CDLL(str(built))


def _by_c(name: str, p: Any, start: Any) -> list[float]:
    """The state at the end by the exported stepper."""
    library, numbers = _compiled(name), ctypes.c_double * 1000
    (prefix,) = (one.stem for one in _exported(name, "c").glob("*.h"))
    motion, given = numbers(), [float(getattr(p, each)) for each in p.model.parameters]
    tolerance, t_end = ctypes.c_double(1e-12), ctypes.c_double(T_END)
    begin, advance = getattr(library, f"{prefix}_begin"), getattr(library, f"{prefix}_advance")
    if begin(motion, numbers(*given), numbers(*start), tolerance) or advance(motion, t_end):
        return [np.nan] * len(start)
    return [*motion[1 : 1 + len(start)]]


def _by_fmu(name: str, p: Any, start: Any) -> list[float]:
    """The state at the end by Co-Simulation."""
    import fmpy

    names = [*p.model.starting]
    # A clock has a rate of its own, which no start gives.
    given = dict(zip(names, start, strict=False)) | {
        each: float(getattr(p, each)) for each in p.model.parameters
    }
    found = fmpy.simulate_fmu(
        str(_exported(name, "fmu")),
        start_values=given,
        stop_time=T_END,
        output_interval=T_END,
        relative_tolerance=1e-12,
        fmi_type="CoSimulation",
        output=[*p.model.field.components],
    )
    return [float(value) for value in found[-1].tolist()[1:]]


def _cycle(number: int, name: str, p: Any, values: dict[str, float], start: Any) -> dict[str, Any]:
    try:
        cycle = ss.cycle(p, near=_whole(name, values, start), patient=False)
    except ss.errors.ConvergenceError:  # it comes to rest or to steady sliding
        return {"kind": "no cycle", "wrong": []}
    n, clock = len(cycle.state) // 2, SYSTEMS[name].clock
    kept = np.flatnonzero(~np.isin(np.arange(2 * n), [n - 1, 2 * n - 1] * clock))
    begin = cycle.state[n - 1] / values["w"] if clock else 0.0

    here, step = cycle.state[kept], 1e-6
    own = Driver(name, values)
    holding = np.flatnonzero(np.abs(own.slips(here)) < 1e-9)

    def after(state: Any) -> Any:
        # What holds at the start holds in what is near: with a static coefficient above the kinetic
        # one the motion jumps where a sliding speed, however small, is given to it.
        from_rest = own.at_rest(state, holding)
        return Driver(name, values).run(from_rest, begin + cycle.period, begin)

    off = float(np.abs(after(here) - here).max())
    wrong = [f"open by {off:.2g}"] * (off > 1e-8)
    trivial = float(np.abs(cycle.multipliers - 1).min())
    wrong += [f"trivial multiplier off by {trivial:.2g}"] * (trivial > 1e-8)
    columns = [(after(here + d) - after(here - d)) / (2 * step) for d in step * np.eye(len(here))]
    ours = cycle.multipliers
    if clock:  # the driver's time has no multiplier of its own
        ours = np.delete(ours, np.abs(ours - 1).argmin())
    # The polynomials: multipliers that are equal lose half of the digits of a difference quotient.
    theirs, ours = np.poly(np.transpose(columns)), np.poly(ours)
    unlike = float(np.abs(ours - theirs[: len(ours)]).max())
    wrong += [f"polynomial of multipliers {ours} for {theirs}"] * (unlike > 1e-3)
    return {
        "kind": f"cycle of {name}",
        "wrong": [f"{text}: {values}, {start.tolist()}" for text in wrong],
        "open": off,
        "trivial": trivial,
        "multipliers": unlike,
    }
