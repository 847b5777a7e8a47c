"""What is generated from the shipped pages, held against numerical differentiation in 50 digits."""

from __future__ import annotations

import importlib
import json
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import mpmath as mp
import numpy as np
import pytest

FOLDER = Path(__file__).resolve().parent.parent / "generated/models"
NAMES = sorted(path.parent.name for path in FOLDER.glob("*/model.json"))

mp.mp.dps = 15  # tests raise it where they need more
XP: Any = SimpleNamespace(sqrt=mp.sqrt, exp=mp.exp, sign=mp.sign)


class Generated:
    """The functions of one model, with directions filled in from the geometry."""

    def __init__(self, name: str) -> None:
        self.about = json.loads((FOLDER / name / "model.json").read_text(encoding="utf-8"))
        self.statics, self.linearization = (
            importlib.import_module(f"spragsym.generated.models.{name}.{part}") for part in ("statics", "linearization")
        )
        self.n = len(self.about["coordinates"])
        self.parameters = [entry["name"] for entry in self.about["parameters"]]

    def point(self, seed: int) -> tuple[list[Any], dict[str, Any]]:
        """Coordinates in contact and parameters, all positive, with few digits."""
        rng = np.random.default_rng(seed)
        q = [mp.mpf(round(value, 3)) for value in rng.uniform(0.1, 0.4, self.n)]
        names = [entry["name"] for entry in self.about["coordinates"]]
        if self.about["contact"]["gap"] == "y":
            q[names.index("y")] *= -1
        return q, {name: mp.mpf(round(value, 3)) for name, value in zip(self.parameters, rng.uniform(0.2, 1.2, 99), strict=False)}

    def arguments(self, kind: str, p: dict[str, Any]) -> list[Any]:
        values = dict(p)
        for angle, (cosine, sine) in self.about["angles"].items():
            values |= {cosine: mp.cos(p[angle]), sine: mp.sin(p[angle])}
        return [values[name] for name in self.about["arguments"][kind]]

    def state(self, q: list[Any], p: dict[str, Any]) -> list[Any]:
        """Coordinates, directions, parameters."""
        taken = self.arguments("statics", p)
        directions = []
        for dx, dy, _ in self.statics.geometry(*q, *taken, xp=XP):
            length = mp.hypot(dx, dy)
            directions += [dx / length, dy / length, length]
        return [*q, *directions, *taken]

    def forces(self, q: list[Any], p: dict[str, Any], mu: Any, pushing: int, name: str = "forces") -> Any:
        return getattr(self.statics, name)(*self.state(q, p), mu, pushing, xp=XP)


@pytest.fixture(params=NAMES)
def model(request: pytest.FixtureRequest) -> Generated:
    return Generated(request.param)


def slope(function: Any, at: Any) -> Any:
    """Central difference with an error far below the tolerance."""
    h = mp.mpf(10) ** -15
    return (function(at + h) - function(at - h)) / (2 * h)


@pytest.mark.parametrize("pushing", [0, 1])
def test_derivatives_are_those_of_the_forces(model: Generated, pushing: int) -> None:
    """Jacobian, second derivatives and derivatives by parameters, directions of the springs following."""
    with mp.workdps(50):
        q, p = model.point(1)
        mu = mp.mpf("0.4")
        jacobian = model.forces(q, p, mu, pushing, "forces_jacobian")
        hessian = model.forces(q, p, mu, pushing, "forces_hessian")
        by_parameters = model.forces(q, p, mu, pushing, "forces_by_parameters")
        for j in range(model.n):

            def at(value: Any, j: int = j) -> list[Any]:
                return [*q[:j], value, *q[j + 1 :]]

            for i in range(model.n):
                want = slope(lambda value, i=i: model.forces(at(value), p, mu, pushing)[i], q[j])
                assert abs(jacobian[i][j] - want) < 1e-25, (i, j)
                for k in range(model.n):
                    want = slope(lambda value, i=i, k=k: model.forces(at(value), p, mu, pushing, "forces_jacobian")[i][k], q[j])
                    assert abs(hessian[i][k][j] - want) < 1e-25, (i, k, j)
        for column, name in enumerate(model.about["by_parameters"]):
            for i in range(model.n):
                if name == "mu":
                    want = slope(lambda value, i=i: model.forces(q, p, value, pushing)[i], mu)
                else:
                    want = slope(lambda value, i=i, name=name: model.forces(q, {**p, name: value}, mu, pushing)[i], p[name])
                assert abs(by_parameters[i][column] - want) < 1e-25, (i, name)
