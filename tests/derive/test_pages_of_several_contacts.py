"""Pages with several contacts: what is refused by its line, and what is derived."""

from inspect import unwrap
from pathlib import Path

import pytest

pytest.importorskip("sympy")

import sympy as sp

from spragsym.derive import pages, statics
from spragsym.derive.limits import Limit
from spragsym.derive.model import PageError
from tests.oracles.contact_pages import FALLING_BLOCKS, HEAD, PAD, TIED_BLOCKS
from tests.oracles.user_pages import model_of, replaced

REAR = 'rear = page.contact(y + a * phi, lambda depth: k_c * depth, name="rear")'
ON_REAR = "page.friction(x + h * phi, V, law, at_rest=mu0, on=rear)"
#: Parameters of the pad, and what is known of their signs.
KNOWN = {"F": "nonnegative", "k_x": "positive", "k_t": "nonnegative", "h": "positive"}
DRY = "page.friction({}, V, slip=lambda v: mu0 * sgn(v), holds=mu0, on={})"


def line_of(text: str, piece: str) -> int:
    return text[: text.rindex(piece)].count("\n") + 1


@pytest.mark.parametrize(
    ("before", "after", "message"),
    [
        (REAR, REAR.replace('"rear"', '"front"'), "named 'front', as is that of line"),
        (REAR, REAR.replace(', name="rear"', ""), "of 2 contacts each has a name"),
        (REAR, REAR.replace('"rear"', '"rear leg"'), "a name is of Latin letters"),
        (REAR, REAR.replace('"rear"', "3"), "name = 3 is no text"),
        (ON_REAR, ON_REAR.replace(", on=rear", ""), "say on which of them"),
        (ON_REAR, ON_REAR.replace("on=rear", "on='rear'"), "no contact of this"),
        (ON_REAR, ON_REAR.replace("on=rear", "on=front"), str(Limit.PLANE)),
        ('"h", "m"', '"mu_on_front", "m"', "an argument for the contact front"),
    ],
)
def test_what_does_not_tell_contacts_apart_is_refused_by_its_line(
    before: str, after: str, message: str, tmp_path: Path
) -> None:
    text = replaced(PAD, (before, after))
    path = tmp_path / "page.py"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(PageError) as error:
        pages.read(path)
    assert message in error.value.message
    assert error.value.line == line_of(text, after)


def test_frictions_that_hold_along_one_displacement_are_refused(tmp_path: Path) -> None:
    rows = [DRY.format("x + h * phi", name) for name in ("front", "rear")]
    law = "page.friction(x + h * phi, V, law, at_rest=mu0, on={})"
    text = replaced(PAD, *zip(map(law.format, ("front", "rear")), rows, strict=True))
    path = tmp_path / "page.py"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(PageError, match="follows from that of front") as error:
        pages.read(path)
    assert error.value.line == line_of(text, rows[1])


def test_the_forces_of_two_legs_are_those_by_hand(tmp_path: Path) -> None:
    path = tmp_path / "page.py"
    path.write_text(PAD, encoding="utf-8")
    it = pages.read(path).mechanics
    x, y, phi = it.coordinates
    F, k_x, k_t, h = (sp.Symbol(name, **{how: True}) for name, how in KNOWN.items())
    mu, touches = it.coefficients, it.pushings
    assert [str(symbol) for symbol in (*mu, *touches)] == [
        "mu_on_front",
        "mu_on_rear",
        "pushing_front",
        "pushing_rear",
    ]
    N = touches[0] * (phi - y), -touches[1] * (phi + y)
    rubbing = sum(a * b for a, b in zip(mu, N, strict=True))
    rows = (
        k_x * x - rubbing,
        F - N[0] - N[1],
        k_t * phi + N[0] - N[1] - h * rubbing,
    )
    for row, by_hand in zip(it.residuals, rows, strict=True):
        assert sp.expand(row - by_hand) == 0
    K = sp.Matrix(rows).jacobian(it.coordinates)
    assert (sp.Matrix(statics.jacobian(it)) - K).applyfunc(sp.expand).is_zero_matrix


def test_the_only_contact_needs_no_name_and_takes_one(tmp_path: Path) -> None:
    text = (
        HEAD
        + """
k = page.parameter("k", "N/m", "stiffness", "> 0", 0.5)
F = page.parameter("F", "N", "load", "> 0", 0.05)
x = page.coordinate("x", "m", "along the belt")
page.kinetic(m * page.rate(x)**2 / 2)
page.spring(k, along=x)
pad = page.normal_force(F, name="pad")
page.friction(x, V, law, at_rest=mu0, on=pad)
"""
    )
    without = replaced(text, (', name="pad"', ""), (", on=pad", ""))
    found = []
    for number, one in enumerate((text, without)):
        path = tmp_path / f"page{number}.py"
        path.write_text(one, encoding="utf-8")
        found.append(pages.read(path).mechanics)
    assert found[0].residuals == found[1].residuals
    assert [str(symbol) for symbol in found[0].coefficients] == ["mu"]


@pytest.mark.thorough
def test_a_friction_that_inertia_couples_with_no_other_holds_by_itself() -> None:
    """What one holds with depends on whether the other sticks only where the blocks are tied."""
    mass = ("page.rate(x_2)**2) / 2", "beta * page.rate(x_2)**2) / 2")
    for page, name, coupled in (
        (replaced(FALLING_BLOCKS, mass), "uneven_blocks", False),
        (TIED_BLOCKS, "tied_blocks", True),
    ):
        code = unwrap(model_of(page, name).algebra.grip).__code__
        assert any(name.startswith("_stuck_") for name in code.co_varnames) == coupled


def test_functions_of_contacts_with_the_same_algebra_are_one() -> None:
    algebra = model_of(FALLING_BLOCKS, "falling_blocks").algebra
    for name, alike in (("friction_slope", True), ("contact_force", False)):
        one, other = (unwrap(getattr(algebra, f"{name}_{end}")) for end in ("first", "second"))
        assert (one is other) == alike
