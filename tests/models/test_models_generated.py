"""What is generated from the shipped pages, held against numerical differentiation in 50 digits."""

import importlib
import json
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np
import pytest

from tests.oracles.user_pages import alone
from tests.support import ROOT, few

FOLDER = ROOT / "generated/models"
NAMES = sorted(path.parent.name for path in FOLDER.glob("*/model.json"))

mp.mp.dps = 15  # tests raise it where they need more
XP: Any = SimpleNamespace(
    sqrt=mp.sqrt,
    exp=mp.exp,
    sign=mp.sign,
    cos=mp.cos,
    sin=mp.sin,
    atan2=mp.atan2,
    pi=mp.pi,
    log=mp.log,
)


class Generated:
    """The functions of one model, with directions filled in from the geometry."""

    def __init__(self, name: str) -> None:
        self.about = json.loads((FOLDER / name / "model.json").read_text(encoding="utf-8"))
        self.algebra = importlib.import_module(f"spragsym.generated.models.{name}.algebra")
        self.n = len(self.about["coordinates"])
        self.parameters = [entry["name"] for entry in self.about["parameters"]]
        #: How many contacts there are, and the names of those that rub.
        self.contacts = len(self.about["contacts"])
        rubs = self.about["frictions"] or self.about["contacts"][:1]
        self.rubbing = [entry["name"] for entry in rubs]

    def mode(self, pushing: int, side: int) -> list[int]:
        """All contacts touch or none, and every belt is ahead or every mass."""
        return [*[pushing] * self.contacts, *[side] * len(self.rubbing)]

    def point(self, seed: int) -> tuple[list[Any], dict[str, Any]]:
        """Coordinates in contact and parameters, all positive, with few digits."""
        rng = np.random.default_rng(seed)
        q = [mp.mpf(round(value, 3)) for value in rng.uniform(0.1, 0.4, self.n)]
        names = [entry["name"] for entry in self.about["coordinates"]]
        if "y" in names:
            q[names.index("y")] *= -1
        return q, {
            name: mp.mpf(round(value, 3))
            for name, value in zip(self.parameters, rng.uniform(0.2, 1.2, 99), strict=False)
        }

    def arguments(self, kind: str, p: dict[str, Any]) -> list[Any]:
        values = dict(p)
        for angle, (cosine, sine) in self.about["angles"].items():
            values |= {cosine: mp.cos(p[angle]), sine: mp.sin(p[angle])}
        return [values[name] for name in self.about["arguments"][kind]]

    def state(self, q: list[Any], p: dict[str, Any]) -> list[Any]:
        """Coordinates, directions, parameters."""
        taken = self.arguments("statics", p)
        directions = []
        for dx, dy, _ in self.algebra.geometry(*q, *taken, xp=XP):
            length = mp.hypot(dx, dy)
            directions += [dx / length, dy / length, length]
        turned = []
        if self.about["torsions"]:
            turned = [
                mp.atan2(sine, cosine)
                for cosine, sine in self.algebra.turnings(*q, *directions, *taken, xp=XP)
            ]
        return [*q, *directions, *turned, *taken]

    def forces(
        self, q: list[Any], p: dict[str, Any], mus: list[Any], pushing: int, name: str = "forces"
    ) -> Any:
        pushed = [pushing] * self.contacts
        return getattr(self.algebra, name)(*self.state(q, p), *mus, *pushed, xp=XP)


@pytest.fixture(params=few(NAMES, "kang_nam", "trolley", "stick_slip"))
def model(request: pytest.FixtureRequest) -> Generated:
    return Generated(request.param)


def slope(function: Any, at: Any) -> Any:
    """Central difference with an error far below the tolerance."""
    h = mp.mpf(10) ** -15
    return (function(at + h) - function(at - h)) / (2 * h)


@pytest.mark.parametrize("pushing", [0, 1])
def test_derivatives_are_those_of_the_forces(model: Generated, pushing: int) -> None:
    """Jacobian and derivatives by parameters, directions of the springs following."""
    with mp.workdps(50):
        q, p = model.point(1)
        mus = [mp.mpf("0.4") + mp.mpf(k) / 9 for k in range(len(model.rubbing))]
        jacobian = model.forces(q, p, mus, pushing, "forces_jacobian")
        by_parameters = model.forces(q, p, mus, pushing, "forces_by_parameters")
        for j in range(model.n):

            def at(value: Any, j: int = j) -> list[Any]:
                return [*q[:j], value, *q[j + 1 :]]

            for i in range(model.n):
                want = slope(lambda value, i=i: model.forces(at(value), p, mus, pushing)[i], q[j])
                assert abs(jacobian[i][j] - want) < 1e-25, (i, j)
        for column, name in enumerate(model.about["by_parameters"]):
            for i in range(model.n):
                if name not in p:
                    place = column - len(model.about["by_parameters"])
                    want = slope(
                        lambda value, i=i, place=place: model.forces(
                            q, p, [*mus[:place], value, *mus[len(mus) + place + 1 :]], pushing
                        )[i],
                        mus[place],
                    )
                else:
                    want = slope(
                        lambda value, i=i, name=name: model.forces(
                            q, {**p, name: value}, mus, pushing
                        )[i],
                        p[name],
                    )
                assert abs(by_parameters[i][column] - want) < 1e-25, (i, name)


def moving(model: Generated, seed: int) -> tuple[list[Any], dict[str, Any]]:
    """Coordinates and rates, the mass slower than the belt, and parameters."""
    q, p = model.point(seed)
    rates = [
        mp.mpf(round(value, 3)) / 10
        for value in np.random.default_rng(seed + 50).uniform(-1.0, 1.0, model.n)
    ]
    return [*q, *rates], p


@pytest.mark.parametrize(("pushing", "side"), [(1, 1), (0, 1), (1, -1)])
def test_derivatives_are_those_of_the_motion(model: Generated, pushing: int, side: int) -> None:
    with mp.workdps(50):
        z, p = moving(model, 2)
        if side < 0:  # the mass is ahead
            z[model.n] = p.get("V", 0) + mp.mpf("0.3")
        felt = [1] * (model.about["layers"] + len(model.about["torsions"]))

        def accelerations(z: list[Any], p: dict[str, Any], name: str = "regime_rhs") -> Any:
            return getattr(model.algebra, name)(
                *z, *model.arguments("motion", p), *model.mode(pushing, side), *felt, xp=XP
            )

        jacobian, by_parameters = (
            accelerations(z, p, name) for name in ("regime_jacobian", "regime_by_parameters")
        )
        for i in range(model.n):
            for j in range(2 * model.n):
                want = slope(
                    lambda value, i=i, j=j: accelerations([*z[:j], value, *z[j + 1 :]], p)[i], z[j]
                )
                assert abs(jacobian[i][j] - want) < 1e-25, (i, j)
            for column, name in enumerate(model.parameters):
                want = slope(
                    lambda value, i=i, name=name: accelerations(z, {**p, name: value})[i], p[name]
                )
                assert abs(by_parameters[i][column] - want) < 1e-25, (i, name)


def test_the_kinked_field_is_that_of_the_regime(model: Generated) -> None:
    kinked = alone(model.about["name"]).algebra.rhs
    with mp.workdps(50):
        for seed, raised, faster in ((3, False, False), (4, True, False), (5, False, True)):
            z, p = moving(model, seed)
            names = [entry["name"] for entry in model.about["coordinates"]]
            if raised and "y" in names:
                z[names.index("y")] *= -1
            if faster:
                z[model.n] = p.get("V", 0) + 1
            taken = model.arguments("motion", p)
            borders = model.algebra.borders(*z, *taken, xp=XP)
            pushing = [
                int(gap < 0 or not contact["border"])
                for gap, contact in zip(borders, model.about["contacts"], strict=False)
            ]
            sides = [int(mp.sign(slip)) for slip in borders[model.contacts :]]
            felt = [1] * (model.about["layers"] + len(model.about["torsions"]))
            regime = model.algebra.regime_rhs(*z, *taken, *pushing, *sides, *felt, xp=XP)
            for ours, theirs in zip(kinked(*z, *taken, xp=XP), regime, strict=True):
                assert abs(ours - theirs) < 1e-45


def test_the_energy_changes_by_the_powers_only(model: Generated) -> None:
    """Along the field the energy's numerical rate is the power of friction and dampers, and dampers
    take.
    """
    with mp.workdps(50):
        z, p = moving(model, 6)
        p["V"] = mp.mpf("0.7")
        taken, felt = model.arguments("motion", p), [1] * model.about["layers"]
        q, v = z[: model.n], z[model.n :]
        a = model.algebra.regime_rhs(
            *z, *taken, *model.mode(1, 1), *felt, *[1] * len(model.about["torsions"]), xp=XP
        )

        def energy(time: Any) -> Any:
            state = [x + time * speed for x, speed in zip(q, v, strict=True)]
            state += [speed + time * push for speed, push in zip(v, a, strict=True)]
            strain = model.algebra.strain_energy(
                *state[: model.n], *taken, *[1] * model.contacts, xp=XP
            )
            return strain + model.algebra.energy_besides_strain(*state, *taken, xp=XP)

        rates = model.algebra.border_rates(*q, *[0] * model.n, *v, *taken, xp=XP)
        friction = mp.mpf(0)
        for slide, name in zip(rates[model.contacts :], model.rubbing, strict=True):
            force = getattr(model.algebra, f"friction_force_{name}" if name else "friction_force")
            friction -= slide * force(*z, *taken, *model.mode(1, 1), *felt, xp=XP)
        others = model.algebra.power_besides_friction(*z, *taken, xp=XP)
        assert abs(slope(energy, mp.mpf(0)) - friction - others) < 1e-25
        if not hasattr(model.algebra, "clock"):
            assert others <= 0  # no other shipped model has a force without a potential
            assert (others < 0) == (model.about["dampers"])
