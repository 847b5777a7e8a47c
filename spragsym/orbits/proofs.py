"""Proofs that a cycle exists, is the only one near, and is stable or not."""

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
    """Proof of a cycle.

    ``print`` and :meth:`decimals` write the numbers with bounds that hold for the digits as they
    are written.

    Attributes
    ----------
    proved : bool
        Whether there is exactly one cycle whose state, where x' = 0, and period lie within
        ``radius`` of those below.
    reason : str
        Why not.
    radius : float
        Half width of the box in which the cycle exists and is the only one.
    error : float
        A proved bound on |state − its state| and |period − its period|, both as they stand.
    state : tuple of mpf
        With x' = 0, exactly.
    period : mpf
    multipliers : tuple of (mpc, float)
        Middles and radii of balls that hold the multipliers, the trivial one first; empty where
        they could not be told apart.
    stable : bool or None
        Whether all others are proved to be within the unit circle (True), or one outside of it
        (False).
    values : tuple of float
        Parameters: the binary numbers that these floats are, exactly.
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
        """State, period and multipliers in decimals, each with a bound that covers the rounding to
        these digits too.

        ``digits`` are significant ones; by default as many as are proved. A multiplier's imaginary
        part has a row of its own.
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
        """The decimals, a row each."""
        verdict = {True: "stable", False: "unstable", None: "stability open"}[self.stable]
        title = (
            f"CycleProof, proved, {verdict}"
            if self.proved
            else f"CycleProof, not proved: {self.reason}"
        )
        return Table(
            title,
            ("", "value", "error"),
            tuple((name, *each) for name, each in self.decimals().items()),
        )


def prove_cycle(cycle: Cycle, *, digits: int = 25, patience: float = 1800.0) -> CycleProof:
    """Prove that a cycle exists, that it is the only one near, and where its multipliers are.

    A box of starts of half width 10^−digits is carried once around by Taylor polynomials in ball
    arithmetic, every crossing of a border enclosed and shown to be one; Krawczyk's operator of the
    return maps the box into itself.

    Parameters
    ----------
    cycle : Cycle
        Of :func:`~spragsym.cycle`; it need not be stable.
    digits : int
        10 to 200: the box has a half width of 10^−digits, or less where that is too wide to show
        anything, down to 10^−25. A long or unstable cycle needs more. The article's cycle, of
        period 34, takes half a minute to 25 digits, three times as long to 60, and some ten minutes
        to 200.
    patience : float
        Seconds after which it is given up. The proof runs in a process of its own.

    Returns
    -------
    CycleProof
        With ``proved`` False and the reason where something could not be shown.

    Raises
    ------
    MissingExtraError
        Without python-flint (extra ``certify``).

    Notes
    -----
    Source: (8)–(11) as they stand, with the exponential of (10) everywhere. The parameters are
    taken as the binary numbers that the floats are.
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
    """Proof of a cycle, every bit of it, from what the process says."""
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
    """A binary fraction, every bit of it."""
    return as_mpf(Fraction(text))


def _unproved(cycle: Cycle, reason: str) -> CycleProof:
    return CycleProof(
        False, reason, float("nan"), float("nan"), (), mpmath.nan, (), None, cycle.values
    )


def claim_of(cycle: Cycle, digits: int) -> dict[str, Any]:
    """Claim to be proved, as JSON holds it."""
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
    """The proof in a process of its own."""
    call = [sys.executable, "-m", "spragsym.orbits.ball_proof"]
    try:
        # What it says may hold paths, in an encoding that only it knows.
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
        raise ConvergenceError(
            "the proof stopped: "
            f"{done.stderr.strip().splitlines()[-1] if done.stderr.strip() else 'no word'}"
        )
    return json.loads(done.stdout)
