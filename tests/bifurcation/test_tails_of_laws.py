"""A model that is linear but for the tail of its smoothed friction law has no dangerous onset, and
no generalized Hopf point.
"""

from typing import Any

import numpy as np
import pytest

import spragsym as ss
from spragsym.bifurcation import hopf_curves
from spragsym.bifurcation.normal_forms import coefficients, normal_form
from spragsym.numerics import contractors
from spragsym.numerics.interval_arrays import Intervals
from tests.oracles.user_pages import model_of, shipped_page

#: Mode coupling with dampers (Hoffmann and Gaul 2003) under the law μ0 tanh(d v).
CHANGES = (
    ("mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0", "mu0 * tanh(d * v)"),
    ("Abs, Page, exp, sgn", "Page, tanh"),
    (
        "page.spring(k_x, along=x)\n",
        "page.spring(k_x, along=x)\npage.damper(c_x, along=x)\npage.damper(c_y, along=y)\n",
    ),
    (
        "V = page",
        """c_x = page.parameter("c_x", "N s/m", "damper", ">= 0", 0.05)
c_y = page.parameter("c_y", "N s/m", "damper", ">= 0", 0.02)
V = page""",
    ),
)


@pytest.fixture(scope="module")
def model() -> Any:
    return model_of(shipped_page("mode_coupling", *CHANGES), "hoffmann_gaul")


def test_an_onset_of_the_tail_is_undecided(model: Any) -> None:
    onsets = ss.flutter_onsets(model.Parameters(V=1.0, d=20.0), "mu0", between={"mu0": (0.0, 1.0)})
    # Hurwitz's determinant of M = 1, C = diag(c_x, c_y), K = ((1.55, μ − 0.25), (−0.25, 1.25)), by
    # hand: 0 at the onset.
    a, b = 0.07, 0.05 * 1.25 + 0.02 * 1.55
    mu = 0.25 - (1.55 * 1.25 - b / a * (2.8 + 0.05 * 0.02 - b / a)) / 0.25
    assert onsets.mu0 == pytest.approx([mu], abs=1e-12)
    assert (
        abs(onsets.lyapunov[0]) > onsets.lyapunov_error[0]
    )  # its sign is proved, and means nothing
    assert (onsets.criticality[0], "below the smoothing" in onsets.why[0]) == ("undecided", True)
    # Where the law is felt at the onset, its sign is told.
    assert (
        ss.flutter_onsets(
            model.Parameters(V=1.0, d=5.0), "mu0", between={"mu0": (0.0, 1.0)}
        ).criticality[0]
        == "subcritical"
    )


def test_no_generalized_hopf_point_in_the_tail(model: Any) -> None:
    found = ss.onset_curves(
        model.Parameters(d=20.0), ("mu0", "V"), 6, between={"mu0": (0.2, 0.5), "V": (0.8, 2.0)}
    )
    assert {kind for curve in found.curves for kind in curve.criticality} == {"undecided"}
    assert not np.concatenate([found.changes["mu0"]]).size


@pytest.mark.thorough
def test_what_is_not_asked_with_digits_they_do_not_tell_either(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Coefficients far below their bound: by many digits they are undecided too, and agree."""
    asked: list[tuple[tuple[Any, ...], list[Any]]] = []

    def noted(*given: Any) -> list[Any]:
        asked.append((given, coefficients(*given)))
        return asked[-1][1]

    monkeypatch.setattr(hopf_curves, "coefficients", noted)
    ss.onset_curves(ss.load("cubic_contact").Parameters())
    told = left = 0
    for (balance, given, ends, vary), forms in asked:
        for k, form in enumerate(forms):
            left += form is None
            if form is None or abs(form.lyapunov) > form.lyapunov_error:
                continue
            middle, n = Intervals(ends[:, :, k]).middle, balance.n
            column = given[:, k].copy()
            column[[balance.parameters.index(name) for name in vary]] = middle[n:]
            radii = contractors.distance(ends[:, :, k], middle)
            exact = normal_form(balance, column, middle[:n], vary, radii)
            assert abs(exact.lyapunov) <= exact.lyapunov_error
            off = abs(exact.lyapunov - form.lyapunov)
            assert off <= exact.lyapunov_error + form.lyapunov_error
            told += 1
    assert told > 4
    assert 0 < left < 15
