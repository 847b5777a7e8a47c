"""Proofs that a cycle exists, is unique in a box, and is stable or unstable, by interval methods.

:func:`prove_cycle` sends a claim to a process that runs :mod:`.ball_proof`, and returns its result
as a :class:`CycleProof`.
"""

import importlib.util
import json
import subprocess
import sys
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np

from ..core.errors import ConvergenceError, MissingExtraError, require_kind
from ..display import Table
from ..models.parameters import as_count
from ..numerics.balls import as_mpf
from ..numerics.decimals import Decimal, float_above, rounded_decimal
from ..results.result import Result
from .orbit import Cycle


@dataclass(frozen=True, eq=False)
class CycleProof(Result):
    """Result of a proof.

    ``print`` and :meth:`decimals` write the numbers with error bounds that include the rounding to
    the written digits.

    Attributes
    ----------
    proved : bool
        True if there is exactly one cycle whose state, at x' = 0, and period are within ``radius``
        of those below.
    reason : str
        Reason for which the proof failed.
    radius : float
        Half-width of the box in which the cycle exists and is unique.
    error : float
        Proved bound of the distance of the cycle's state and period from those below.
    state : tuple of mpf
        State with x' = 0, exactly.
    period : mpf
    multipliers : tuple of (mpc, float)
        Midpoints and radii of balls that contain the multipliers, the trivial one first; empty if
        they could not be separated.
    stable : bool or None
        True if all others are proved to be inside the unit circle, False if one is proved to be
        outside, None if neither is.
    values : tuple of float
        Parameters: the exact values of these binary floats.
    """

    proved: bool
    reason: str
    radius: float
    error: float
    state: tuple[mpmath.mpf, ...]
    period: mpmath.mpf
    multipliers: tuple[tuple[mpmath.mpc, float], ...]
    stable: bool | None
    values: tuple[float, ...]

    def decimals(self, digits: int | None = None) -> dict[str, Decimal]:
        """State, period and multipliers as decimals, each with an error bound that includes the
        rounding to these digits.

        ``digits`` is the number of significant digits, by default as many as are proved. A
        multiplier's imaginary part has a row of its own.
        """
        numbers = {
            f"state_{i + 1}": rounded_decimal(value, self.error, digits)
            if value
            else Decimal("0", "0")  # the section is exactly x' = 0
            for i, value in enumerate(self.state)
        }
        if self.proved:
            numbers["period"] = rounded_decimal(self.period, self.error, digits)
        for i, (value, radius) in enumerate(self.multipliers, 1):
            numbers[f"multiplier_{i}"] = rounded_decimal(value.real, radius, digits)
            if value.imag:
                numbers[f"multiplier_{i}_imaginary"] = rounded_decimal(value.imag, radius, digits)
        return numbers

    def as_table(self) -> Table:
        """The :meth:`decimals`, a row each."""
        title = f"CycleProof, not proved: {self.reason}"
        if self.proved:
            verdict = {True: "stable", False: "unstable", None: "stability open"}[self.stable]
            title = f"CycleProof, proved, {verdict}"
        rows = tuple((name, *each) for name, each in self.decimals().items())
        return Table(title, ("", "value", "error"), rows)


def prove_cycle(cycle: Cycle, *, digits: int = 25, patience: float = 1800.0) -> CycleProof:
    """Prove that a cycle exists and is unique in a box, and enclose its multipliers.

    A box of initial states of half-width 10^−digits is integrated over one period by Taylor
    polynomials in ball arithmetic; every crossing of a border is enclosed, and proved to be a
    single one. Then Krawczyk's operator of the return map maps the box into itself.

    Parameters
    ----------
    cycle : Cycle
        Result of :func:`~spragsym.cycle`, stable or not.
    digits : int
        10 to 200. The half-width of the box is 10^−digits; if that is too wide for the proof,
        smaller ones down to 10^−25 are tried. A long or unstable cycle needs more digits. The
        article's cycle, of period 34, takes half a minute with 25 digits, three times as long with
        60, and some ten minutes with 200.
    patience : float
        Time limit in seconds. The proof runs in a process of its own.

    Returns
    -------
    CycleProof
        If the proof fails, ``proved`` is False, with the reason.

    Raises
    ------
    MissingExtraError
        Without python-flint (extra ``certify``).

    Notes
    -----
    Source: (8)–(11), with the exponential of (10) nowhere omitted. The parameters are the exact
    values of the binary floats.
    """
    require_kind("cycle", cycle, Cycle, "one of ss.cycle(...)")
    if cycle.field.model is not None:
        cycle.field.model.require_answered("prove_cycle")
    if not importlib.util.find_spec("flint"):
        raise MissingExtraError("spragsym.precise.prove_cycle", "flint", "certify")
    digits = as_count("digits", digits, 10, 200)
    if not cycle.field.where:
        return _unproved(
            cycle, "the field of this cycle can't be made again in the process that proves"
        )
    found = _run(claim_of(cycle, digits), patience)
    if not found["proved"]:
        return _unproved(cycle, found["reason"])
    return proof_of(cycle, found)


def proof_of(cycle: Cycle, found: dict[str, Any]) -> CycleProof:
    """The proof of a cycle from the output of the process, without rounding."""
    multipliers = tuple(
        (
            mpmath.mp.make_mpc((_binary(real)._mpf_, _binary(imaginary)._mpf_)),
            float_above(Fraction(radius)),
        )
        for real, imaginary, radius in found["multipliers"]
    )
    return CycleProof(
        True,
        "",
        10.0 ** -found["digits"],
        float_above(Fraction(found["error"])),
        tuple(map(_binary, found["state"])),
        _binary(found["period"]),
        multipliers,
        found["stable"],
        cycle.values,
    )


def _binary(text: str) -> mpmath.mpf:
    """The exact value of a binary fraction in text."""
    return as_mpf(Fraction(text))


def _unproved(cycle: Cycle, reason: str) -> CycleProof:
    return CycleProof(
        False, reason, float("nan"), float("nan"), (), mpmath.nan, (), None, cycle.values
    )


def claim_of(cycle: Cycle, digits: int) -> dict[str, Any]:
    """The claim to be proved, as JSON data: field, parameters, approximate state, period and
    crossings, and the Jacobian of the return in the state without x', and the period.
    """
    m, n = cycle.field.size, len(cycle.field.coordinates)
    flow = cycle.orbit.rate(cycle.state)
    slopes = np.column_stack([np.delete(cycle.orbit.monodromy - np.eye(m), n, axis=1), flow])
    return {
        "field": cycle.field.where,
        "values": list(cycle.values),
        "state": cycle.state.tolist(),
        "period": cycle.period,
        "digits": digits,
        "slopes": slopes.tolist(),
        "crossings": [[crossing.t, crossing.border] for crossing in cycle.orbit.crossings()],
    }


def _run(claim: dict[str, Any], patience: float) -> dict[str, Any]:
    """Run the proof in a process of its own; its output as data."""
    call = [sys.executable, "-m", "spragsym.orbits.ball_proof"]
    try:
        # Error messages may contain paths in an unknown encoding.
        done = subprocess.run(
            call,
            input=json.dumps(claim),
            capture_output=True,
            text=True,
            errors="replace",
            timeout=patience,
            check=False,
        )
    except subprocess.TimeoutExpired:
        reason = f"it was given up after {patience:g} s; give a larger patience or fewer digits"
        return {"proved": False, "reason": reason}
    if done.returncode:
        lines = done.stderr.strip().splitlines() or ["no word"]
        raise ConvergenceError(f"the proof stopped: {lines[-1]}")
    return json.loads(done.stdout)
