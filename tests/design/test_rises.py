"""Loading parameters other than friction: a load on a truss, the preload of the article's brake.

The truss snaps where P(u) = k u (l/r − 1), r² = b² + u², has its maximum over the height u that is
left: r³ = l b².
"""

import math
from pathlib import Path

import pytest

import spragsym as ss
from tests.oracles.user_pages import derived
from tests.support import ROOT, written_brake

pytest.importorskip("sympy")

PAGE = (ROOT / "tests/oracles/pages/snapping_truss.py").read_text(encoding="utf-8")
TRUSS = {
    "m": "0.35 kg",
    "k": "1500 N/mm",
    "b": "38 mm",
    "h": "11.4 mm",
    "P": "200 N",
    "c": "70 N s/m",
}
BRAKE = {
    "m": "0.35 kg",
    "k": "180 N/mm",
    "k_x": "9 N/mm",
    "k_y": "0 N/mm",
    "k_c": "1500 N/mm",
    "F_L": "420 N ± 10 %",
    "L_0": "38 mm",
    "theta0": "40 deg",
    "mu0": "0.45",
    "V": "0.1 m/s",
    "d": "10 s/m",
}
QUICKLY = {"redesign": False, "oscillation": False}


def snaps(k: float, b: float, h: float) -> float:
    """The largest load in N."""
    length = math.hypot(b, h)
    r = (length * b**2) ** (1 / 3)
    return k * math.sqrt(r**2 - b**2) * (length / r - 1)


def truss(folder: Path, **changes: str) -> ss.Study:
    model = derived(PAGE, "snapping_truss").as_posix()
    return ss.Study.from_file(
        written_brake(folder, {"model": model, **TRUSS, "vary": "P", **changes}), trust=True
    )


LOAD = snaps(1.5e6, 0.038, 0.0114)


def weighted(folder: Path, **changes: str) -> ss.Study:
    """The same under a weight of 400 N too: it snaps at a load that is negative, which holds it
    up.
    """
    text = PAGE.replace('">= 0", 0.004', '"real", 0.0')
    weight = 'page.parameter("G", "N", "weight", ">= 0", 0.007, becomes="gam")'
    model = derived(f"{text}page.force({weight}, along=w)\n", "weighted_truss").as_posix()
    rows = {**TRUSS, "P": "-200 N ± 10 %", "G": "400 N", "vary": "P", "begin": "-500 N"}
    return ss.Study.from_file(
        written_brake(folder, {"model": model, **rows, **changes}), trust=True
    )


@pytest.mark.thorough
def test_a_load_rises_to_where_the_truss_snaps(tmp_path: Path) -> None:
    found = truss(tmp_path, P="200 N ± 10 %").report()
    assert found.jump_at == pytest.approx(LOAD, rel=1e-10)
    assert found.mu_jump is None
    assert found.margin_percent == pytest.approx(100 * (LOAD / 220 - 1))
    assert found.certificate is not None
    assert found.certificate.outcome == "proved"
    assert found.distance == pytest.approx((LOAD - 200) / 20, rel=1e-9)
    assert found.current is found.states[0]
    assert found.peak is not None
    assert found.peak.settles == "rest"
    assert found.peak.at == found.jump_at
    told = found.to_dict()
    assert told["jump_at"] == {"value": pytest.approx(LOAD), "unit": "N"}
    assert told["folds"][0]["value"]["value"] == pytest.approx(LOAD)
    assert f"P = {LOAD:.1f} N" in found.verdict
    assert "friction" not in found.text()


@pytest.mark.validate
def test_changes_keep_the_load_at_its_target(tmp_path: Path) -> None:
    study = truss(tmp_path, P="[230, 270] N", h="11.4 mm ± 1 %")
    found = study.report(oscillation=False, n=256)
    assert found.target == pytest.approx(1.2 * 270)
    assert found.redesign
    for one in found.redesign:
        values = {**study.values, **one.after}
        assert one.jump_at == pytest.approx(snaps(values["k"], values["b"], values["h"]), rel=1e-9)
        assert one.jump_at >= found.target
        assert one.outcome == "proved"
    assert {name for one in found.redesign for name in one.after} == {"k", "b", "h"}


@pytest.mark.thorough
@pytest.mark.parametrize(
    ("ends", "outcome"), [((200, 0.9999 * LOAD), "proved"), ((200, 1.0001 * LOAD), "refuted")]
)
def test_a_certificate_is_as_sharp_as_the_closed_form(
    ends: tuple[float, float], outcome: str, tmp_path: Path
) -> None:
    found = truss(tmp_path, P=f"[{ends[0]}, {ends[1]}] N").report(**QUICKLY, n=64)
    assert found.certificate is not None
    assert found.certificate.outcome == outcome
    assert found.within == outcome


@pytest.mark.thorough
def test_the_probability_is_the_share_of_loads_beyond(tmp_path: Path) -> None:
    found = truss(tmp_path, P="[260, 300] N").report(**QUICKLY, n=256)
    share = (300 - LOAD) / 40
    assert found.probability is not None
    assert found.probability.low < share < found.probability.high
    low, high = found.probability.proved
    assert low < share < high < low + 1e-4


@pytest.mark.parametrize(
    ("rows", "named"),
    [
        ({"vary": "F_l"}, ("vary = 'F_l'", "did you mean F_L")),
        ({"vary": "k_c"}, ("vary = 'k_c'", "k_x")),
        ({"vary": "F_L"}, ("vary = 'F_L'", "begin")),
        ({"vary": "F_L", "begin": "500 N"}, ("begin = 500", "F_L = 420")),
        ({"vary": "F_L", "begin": "5 mm"}, ("begin = '5 mm'", "420 N")),
        ({"begin": "5 N"}, ("begin = '5 N'", "vary")),
        ({"vary": "mu0", "begin": "0.2"}, ("begin = 0.2", "leave begin out")),
    ],
)
def test_what_can_t_rise_is_said_with_its_line(
    rows: dict[str, str], named: tuple[str, ...], tmp_path: Path
) -> None:
    with pytest.raises(ss.errors.ParameterError) as error:
        ss.Study.from_file(written_brake(tmp_path, BRAKE | rows))
    for part in (*named, ", line "):
        assert part in str(error.value)


@pytest.mark.thorough
def test_a_load_may_be_negative(tmp_path: Path) -> None:
    found = weighted(tmp_path).report(**QUICKLY)
    assert found.jump_at == pytest.approx(LOAD - 400, rel=1e-10)
    assert found.distance == pytest.approx((LOAD - 400 + 200) / 20, rel=1e-9)
    assert found.margin_percent == pytest.approx(100 * (LOAD - 400 + 180) / 180)
    assert "35 % above the largest that you have, -180 N" in found.verdict
    assert "full slip" not in found.text()
