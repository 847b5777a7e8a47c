"""Each part of a step of the theorem is needed: what it rules out, put in its place, is noticed."""

from __future__ import annotations

from typing import Any

import pytest

from spragsym.derive import catastrophe, elimination, equilibrium, theorem
from spragsym.derive import nomenclature as nm

QUARTIC = elimination.quartic_in_t()
FORM = elimination.f_form
ALONG, ACROSS = equilibrium.balance()
COEFFICIENTS = elimination.f_coefficients()
STATE = elimination.state()


def _broken() -> list[str]:
    return [step.claim for step in theorem.one_or_three() if not step.holds]


@pytest.mark.parametrize(
    ("module", "name", "changed", "claim"),
    [
        pytest.param(elimination, "quartic_in_t", lambda: (*QUARTIC, nm.fm), "begins with −b t⁴", id="a power too many"),
        pytest.param(elimination, "quartic_in_t", lambda: (QUARTIC[0], QUARTIC[1] + nm.fm, *QUARTIC[2:]),
                     "three positive roots need", id="coefficient of t alone"),
        pytest.param(elimination, "quartic_in_t", lambda: (*QUARTIC[:2], QUARTIC[2] + nm.fm, *QUARTIC[3:]),
                     "three positive roots need", id="coefficient of t² alone"),
        pytest.param(elimination, "f_coefficients", lambda: COEFFICIENTS | {nm.fm: -COEFFICIENTS[nm.fm]},
                     "three positive roots need", id="sign of m"),
        pytest.param(elimination, "f_coefficients", lambda: COEFFICIENTS | {nm.fb: 0 * nm.fb},
                     "−b is positive", id="b is zero"),
        pytest.param(equilibrium, "balance", lambda: (ALONG, ACROSS - 2 * nm.kappa),
                     "no equilibrium has sin θ = 0", id="preload"),
        pytest.param(elimination, "state", lambda: STATE | {nm.L: -STATE[nm.L]}, "s > 0 gives L > 0", id="sign of L"),
        pytest.param(elimination, "state", lambda: STATE | {nm.L: 1 / (nm.s * nm.q)},
                     "s < 0 excludes", id="length without preload"),
        pytest.param(elimination, "f_form", FORM + nm.fb * nm.c, "f is negative before", id="f at 0"),
        pytest.param(catastrophe, "slope_identity", lambda: False, "L det K = f′", id="slope"),
    ],
)  # fmt: skip
def test_what_a_step_rules_out_is_noticed(
    module: Any, name: str, changed: Any, claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(module, name, changed)
    assert any(claim in broken for broken in _broken())


@pytest.mark.parametrize(("signs", "number"), [((-1, 0, 0, 1), 1), ((1, 0, 1), 0), ((-1, 1, -1, 0, 1), 3), ((), 0), ((0, -1), 0)])
def test_changes_of_sign(signs: tuple[int, ...], number: int) -> None:
    assert theorem._changes(signs) == number
