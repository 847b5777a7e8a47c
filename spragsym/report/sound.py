"""Sound level of a vibrating surface, from the speeds of one period of a cycle."""

from __future__ import annotations

import math

from ..orbits import Cycle
from .study import Study


def surface_levels(study: Study, found: Cycle) -> list[dict[str, str | float]]:
    """Speeds and sound levels of a cycle, a row for each coordinate that is a length.

    Parameters
    ----------
    study : Study
        The brake, for its units.
    found : Cycle
        A cycle of the model with ``study.dimensionless``.

    Returns
    -------
    list of dict
        The coordinate; root mean square of its speed v in m/s over one period; its level
        20 log₁₀(v/50 nm/s); and that of the pressure ρ c v, 20 log₁₀(ρ c v/20 µPa), both in dB.

    Notes
    -----
    Source: a plane wave p(t − x/c) obeys ρ ∂v/∂t = −∂p/∂x, so that p = ρ c v where it leaves the
    surface. That is the level before a surface much larger than a wavelength; a smaller one
    radiates less.

    Examples
    --------
    >>> import spragsym as ss
    >>> brake = {"m": 0.35, "k": 1.5e6, "N_0": 400.0, "mu_s": 0.5, "v_s": 0.0552, "c": 36.2}
    >>> study = ss.Study({**brake, "V": 0.276}, model="stick_slip")
    >>> (row,) = surface_levels(study, ss.cycle(study.dimensionless))
    >>> round(row["speed_m_per_s"], 3), round(row["pressure_level_dB"], 1)
    (0.259, 134.6)
    """
    one = study.scales.length / study.scales.time
    names = found.field.model.components
    motion = found.trajectory()
    rows: list[dict[str, str | float]] = []
    # Density of air in kg/m³ times the speed of sound in m/s, at 20 °C and 101325 Pa.
    impedance = 1.204 * 343.2
    for name, rate in zip(names, names[len(names) // 2 :], strict=False):
        if study.kind.coordinates[name] == "m":
            speed = one * motion.rms(0.0, of=rate)
            # Reference values of ISO 1683: speed in m/s, pressure in air in Pa.
            level, pressure = _decibels(speed / 50e-9), _decibels(impedance * speed / 20e-6)
            row = {"speed_m_per_s": speed, "speed_level_dB": level, "pressure_level_dB": pressure}
            rows.append({"of": name, **row})
    return rows


def _decibels(ratio: float) -> float:
    """Level of a ratio of amplitudes; −∞ for 0."""
    return 20 * math.log10(ratio) if ratio else -math.inf
