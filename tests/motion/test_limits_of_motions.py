"""Limits of motions by their whole state: equilibria and cycles that differ in any coordinate, and
rotations modulo a turn.
"""

import numpy as np
import pytest
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.motion.sweeps import Regime, basin
from tests.oracles.user_pages import model_of

HEAD = '''"""A page."""
from spragsym.derive.model import Page, cos

page = Page("A page.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
l = page.unit("l", "m", "length")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.3)
'''

#: A mass on a belt beside two masses in wells at y, z = ±1, which it does not feel.
WELLS = (
    HEAD
    + """V = page.parameter("V", "m/s", "speed of the belt", ">= 0", 0.2)
v = page.parameter("v_s", "m/s", "speed of most friction", "> 0", 0.1)
x, y, z = (page.coordinate(name, "m", "way " + name) for name in "xyz")
page.kinetic(sum(m * page.rate(q) ** 2 / 2 for q in (x, y, z)))
page.potential(k * x**2 / 2 + sum(k * (q**4 / l**2 - 2 * q**2) / 8 for q in (y, z)))
for q in (x, y, z):
    page.damper(c / 6 if q is x else c, along=q)
page.normal_force(k * l)
page.friction(x, V, lambda u: u * v / (u**2 + v**2))
"""
)

#: A pendulum with a torque of 0.8 and a mass on a spring that it shakes.
SHAKER = (
    HEAD
    + """q = {name: page.coordinate(name, "rad" if name == "phi" else "m", "way " + name) for name in ORDER}
x, phi, T = q["x"], q["phi"], page.parameter("T", "N m", "torque", ">= 0", 0.8)
swing, way = page.rate(phi), page.rate(x)
page.kinetic(m * (l**2 * swing**2 + way**2) / 2 + m * l * way * swing * cos(phi) / 4)
page.potential(k * l**2 * (1 - cos(phi)) + k * x**2 / 2)
page.damper(c, along=x)
page.damper(c * l**2, along=phi)
page.force(T, along=phi)
"""
)


def test_one_cycle_is_one_attractor_in_one_coordinate_and_a_turn_is_no_other_state() -> None:
    found = basin(
        ss.load("stick_slip").Parameters(V=0.2), x=[0.0, 0.3, 0.6], vx=[0.0, 0.1], t_end=400.0
    )
    assert [one[0] for one in found.attractors] == [Regime.LIMIT_CYCLE]
    rod = ss.load("sprag_rod").Parameters(theta0=np.radians(40), zeta=0.2)
    sweep = ss.rms_sweep(rod, vphi0=[0.0, 2.0, 3.0, 5.0], t_end=400.0)  # the last two after a turn
    assert sweep.equilibrium.tolist() == [0, 2, 0, 2]
    np.testing.assert_allclose(sweep.rest_phi[2:], sweep.rest_phi[:2], rtol=1e-9)


@pytest.mark.thorough
def test_states_of_three_coordinates_are_told_apart_by_all_of_them() -> None:
    model = model_of(WELLS, "wells")
    p, start = model.Parameters(V=2.0), np.array([[0.9, 0.9, -0.9, -0.9], [0.9, -0.9, 0.9, -0.9]])
    sweep, known = ss.rms_sweep(p, y0=start[0], z0=start[1], t_end=400.0), ss.equilibria(p)
    assert known.count == 9
    for name, wanted in (
        ("y", np.sign(start[0])),
        ("z", np.sign(start[1])),
        ("x", np.full(4, 0.2 / 4.01)),
    ):
        assert getattr(sweep, f"rest_{name}") == pytest.approx(wanted, abs=1e-9)
        assert getattr(known, name)[sweep.equilibrium] == pytest.approx(wanted, abs=1e-9)
    cycles = basin(model.Parameters(), x=[0.3, 0.5], z=[0.9, -0.9], y0=0.8, t_end=400.0)
    assert cycles.attractor.tolist() == [[0, 1], [0, 1]]
    assert cycles.sweep.mean_z[0] == pytest.approx([1.0, -1.0], abs=1e-9)


@pytest.mark.validate
def test_the_edge_between_two_cycles_that_differ_in_the_last_coordinate() -> None:
    p = model_of(WELLS, "wells").Parameters()
    found = ss.fate_boundary(
        p, "c", between={"c": (0.2, 0.4)}, start=(0.3, 1.0, 2.0, 0.0, 0.0, 0.0)
    )
    assert found.below.cycle_z * found.above.cycle_z == pytest.approx(-1.0)
    assert found.growth == pytest.approx(
        (np.hypot(found.value, 2**0.5) - found.value) / 2
    )  # of the hill at z = 0


@pytest.mark.thorough
@pytest.mark.parametrize("order", [("x", "phi"), ("phi", "x")])
def test_a_rotation_is_a_cycle_modulo_a_turn(order: tuple[str, str]) -> None:
    model = model_of(SHAKER.replace("ORDER", repr(order)), "_".join(order))
    sweep = ss.rms_sweep(
        model.Parameters(), vphi0=[0.0, 3.0, 5.0], phi0=[0.0, 0.3, 7.0], t_end=400.0
    )
    assert sweep.regime.tolist() == [Regime.EQUILIBRIUM, Regime.LIMIT_CYCLE, Regime.LIMIT_CYCLE]

    def field(_: float, state: np.ndarray) -> list[float]:
        x, phi, vx, vphi = state
        mass = [[1.0, np.cos(phi) / 4], [np.cos(phi) / 4, 1.0]]
        force = [-x - 0.3 * vx + np.sin(phi) / 4 * vphi**2, 0.8 - 0.3 * vphi - np.sin(phi)]
        return [vx, vphi, *np.linalg.solve(mass, force)]

    start = [sweep.measured[f"cycle_{name}"][1] for name in ("x", "phi", "vx", "vphi")]
    end = solve_ivp(field, (0.0, float(sweep.period[1])), start, rtol=1e-11, atol=1e-12).y[:, -1]
    assert end == pytest.approx(np.add(start, [0.0, 2 * np.pi, 0.0, 0.0]), abs=1e-7)
    assert sweep.outcome(1).limit == sweep.outcome(2).limit
    assert [
        one[0]
        for one in basin(
            model.Parameters(), phi=[0.3, 7.0], vphi=[3.0, 5.0], t_end=400.0
        ).attractors
    ] == [2]
    fate = ss.fate(
        model.Parameters(),
        start=[{"vphi": 3.0}.get(name, 0.0) for name in (*model.coordinates, *model.rates)],
    )
    assert (fate.kind, fate.exponents.size) == ("cycle", 4)
    assert fate.exponents[1] == pytest.approx(-float(sweep.rate[1]), rel=1e-5)


@pytest.mark.parametrize("backend", ["heyoka", "scipy"])
def test_what_has_died_out_to_noise_is_at_rest_where_nothing_has_a_size(backend: str) -> None:
    text = HEAD + "x = page.coordinate('x', 'm', 'way')\npage.kinetic(m * page.rate(x) ** 2 / 2)\n"
    p = model_of(text + "page.spring(k, along=x)\npage.damper(c, along=x)\n", "free").Parameters()
    late = ss.simulate(p, x0=0.1, t_end=700.0, backend=backend).outcome(350.0)  # 1e-24 at t = 350
    assert (late.regime, late.rate) == (Regime.EQUILIBRIUM, pytest.approx(0.15, rel=1e-12))
    assert ss.fate(p, start=(0.1, 0.0), backend=backend).kind == "rest"
