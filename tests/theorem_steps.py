"""What the tests of the theorem share: the derivation as it is, also where a test puts something else in its place."""

from __future__ import annotations

from spragsym.derive.kang_nam import elimination, equilibrium, theorem

quartic, coefficients, state, balance = (
    elimination.quartic_in_t, elimination.f_coefficients, elimination.state, equilibrium.balance
)  # fmt: skip


def derive_first() -> None:
    """Each of these functions keeps what it gave first, which must be what is derived."""
    for function in (quartic, coefficients, state, balance):
        function()


def broken_steps() -> list[str]:
    """What is claimed by steps that do not hold."""
    return [step.claim for step in theorem.one_or_three() if not step.holds]
