"""Sound levels of a cycle's speeds."""

import math
from types import SimpleNamespace

import numpy as np
import pytest

import spragsym as ss
from spragsym.report import sound
from tests.conftest import Run

BRAKE = {"m": 0.35, "k": 1.5e6, "N_0": 400.0, "mu_s": 0.5, "v_s": 0.0552, "c": 36.2, "V": 0.276}


@pytest.mark.thorough
def test_speeds_are_those_of_the_places_by_fourier_series() -> None:
    """The root mean square of a derivative, from the coefficients of what it is derived from."""
    study = ss.Study(BRAKE, model="stick_slip")
    cycle = ss.cycle(study.dimensionless)
    (row,) = sound.surface_levels(study, cycle)
    n = 4096
    places = study.scales.length * cycle.samples(np.arange(n) * cycle.period / n)[0]
    omega = 2 * math.pi / (cycle.period * study.scales.time)
    c = np.fft.rfft(places) / n
    rms = math.sqrt(2 * sum(abs(omega * k * c[k]) ** 2 for k in range(1, n // 8)))
    assert row["of"] == "x"
    assert row["speed_m_per_s"] == pytest.approx(rms, rel=1e-3)
    assert row["speed_level_dB"] == pytest.approx(20 * math.log10(rms) + 146.0206, abs=0.01)


@pytest.mark.parametrize("unit", [1e-6, 1.0, 1e6])
def test_one_pascal_is_94_dB_in_any_units(unit: float) -> None:
    """In a plane wave of 1 Pa air moves with 2.42 mm/s; a cycle that rests makes no sound."""
    speeds = {"vx": 1 / 413.2128 / unit, "vy": 0.0}
    study = SimpleNamespace(
        scales=SimpleNamespace(length=3.0 * unit, time=3.0),
        kind=SimpleNamespace(coordinates={"x": "m", "y": "m"}),
    )
    motion = SimpleNamespace(rms=lambda _, of: speeds[of])
    model = SimpleNamespace(components=("x", "y", "vx", "vy"))
    cycle = SimpleNamespace(field=SimpleNamespace(model=model), trajectory=lambda: motion)
    # Stand-ins with what is asked of a study and of a cycle alone.
    x, y = sound.surface_levels(study, cycle)  # type: ignore[arg-type]
    assert x["pressure_level_dB"] == pytest.approx(20 * math.log10(1 / 20e-6), abs=1e-5)
    assert x["speed_level_dB"] == pytest.approx(20 * math.log10(1 / 413.2128 / 50e-9), abs=1e-3)
    assert y["pressure_level_dB"] == -math.inf


def test_sound_needs_units(run: Run) -> None:
    assert "--sound needs metres and seconds: give --data FILE" in run(
        "cycles", "--theta0", "42", "--sound", code=2
    )
