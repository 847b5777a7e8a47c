"""A friction law from measurements: μ₀ and d fitted to sliding speeds and coefficients."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..display import Result
from ..errors import ParameterError
from ..files.text import decoded
from ..generated import motion as _motion
from ..parameters import FloatArray


@dataclass(frozen=True)
class FrictionFit(Result):
    """μ₀ and d of the law μ₀ (1 − exp(−d \\|v\\|)) by least squares, with their standard errors and the rms of what is left.

    ``slowest`` and ``fastest`` are the smallest and the largest sliding speed that was measured, in m/s.
    """

    mu0: float
    d: float
    mu0_error: float
    d_error: float
    rms: float
    points: int
    slowest: float
    fastest: float


def read_friction(path: Path) -> tuple[FloatArray, FloatArray]:
    """Sliding speeds in m/s and friction coefficients from the first two columns of a file, which a line of names may head.

    Columns are separated by semicolons, tabs, commas or blanks, the first of these that the line has; where that is no comma, a
    comma is a decimal one.

    Raises
    ------
    ParameterError
        For a file that is missing, or a line that is not two numbers; it names the line.
    """
    try:
        text = decoded(path.read_bytes())
    except UnicodeDecodeError as error:
        raise ParameterError(f"{path} is not text in UTF-8 (byte {error.start}); save it as UTF-8") from error
    except OSError as error:
        remedy = "give a text file with sliding speed and coefficient"
        raise ParameterError(f"{path} can't be read: {error.strerror}; {remedy}") from error
    lines = [(number, line) for number, line in enumerate(text.splitlines(), 1) if line.strip() and line.strip()[0] != "#"]
    if lines and not re.match(r"""[\s"']*[+-]?[.,]?\d""", lines[0][1]):
        del lines[0]  # names of the columns
    rows = []
    for number, line in lines:
        cells = _cells(line)
        if len(cells) < 2 or not (_is_number(cells[0]) and _is_number(cells[1])):
            raise ParameterError(
                f"{path}, line {number}: {line!r} is not a sliding speed in m/s and a coefficient, such as 0.5,0.41"
            )
        if len(cells) > 3 and not len(cells) % 2 and "." not in text and ";" not in line and "," in line:
            raise ParameterError(
                f"{path}, line {number}: {line!r} may have decimal commas between commas; put semicolons between the columns, "
                "or write points"
            )
        speed, friction = float(cells[0]), float(cells[1])
        if friction < 0:
            raise ParameterError(f"{path}, line {number}: the coefficient {friction:g} is negative; give its size")
        rows.append((abs(speed), friction))
    if len({speed for speed, _ in rows if speed}) < 2:
        raise ParameterError(
            f"{path} has {len(rows)} measurements; at least two at different sliding speeds are needed to fit mu0 and d"
        )
    columns = np.array(rows)
    if not columns[:, 1].any():
        raise ParameterError(f"{path}: all coefficients are 0; without friction there is nothing to fit, so give mu0 = 0 and d")
    return columns[:, 0], columns[:, 1]


def _cells(line: str) -> list[str]:
    for separator in (";", "\t", ","):
        if separator in line:
            cells = [cell.strip(" \t\"'") for cell in line.split(separator)]
            return cells if separator == "," else [cell.replace(",", ".") for cell in cells]
    return line.split()


def _is_number(cell: str) -> bool:
    try:
        return math.isfinite(float(cell))
    except ValueError:
        return False


def fit_friction(speed: FloatArray, friction: FloatArray) -> FrictionFit:
    """μ₀ and d by least squares; for each d the best μ₀ is linear, so that one search over d finds the best of all.

    Notes
    -----
    Source: the regularized law (10) at steady sliding.

    Examples
    --------
    >>> speed = np.array([0.05, 0.1, 0.3, 1.0])
    >>> found = fit_friction(speed, 0.4 * (1 - np.exp(-10 * speed)))
    >>> round(found.mu0, 9), round(found.d, 7)
    (0.4, 10.0)
    """
    from scipy.optimize import minimize_scalar

    moving = speed[speed > 0]

    def shape(d: float) -> FloatArray:
        return np.asarray(_motion.friction(0.0, 1.0, speed, d))

    def best(d: float) -> float:
        rise = shape(d)
        return float(rise @ friction / (rise @ rise))

    def left(log_d: float) -> float:
        d = math.exp(log_d)
        return float(((friction - best(d) * shape(d)) ** 2).sum())

    # Beyond these the law is a straight line in v, or a constant, at every speed that was measured.
    ends = math.log(1e-4 / moving.max()), math.log(40.0 / moving.min())
    grid = np.linspace(*ends, 400)
    k = int(np.argmin([left(value) for value in grid]))
    bracket = grid[max(k - 1, 0)], grid[min(k + 1, grid.size - 1)]
    found = minimize_scalar(left, bounds=bracket, method="bounded", options={"xatol": 1e-12})
    d = math.exp(float(found.x))
    mu0 = best(d)
    slopes = np.stack([shape(d), mu0 * speed * np.exp(-d * speed)], axis=1)
    rest = max(speed.size - 2, 1)
    spread = math.sqrt(left(math.log(d)) / rest)
    errors = spread * np.sqrt(np.abs(np.diag(np.linalg.pinv(slopes.T @ slopes))))
    return FrictionFit(mu0, d, float(errors[0]), float(errors[1]), spread, speed.size, moving.min(), speed.max())
