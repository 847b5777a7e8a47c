"""Which integrator carries a cycle's variational equations."""

from __future__ import annotations

from typing import Any

from ..dynamics.field import Field
from ..dynamics.integrators import OF_ANY_MODEL, choose
from . import with_heyoka, with_scipy
from .passage import Fly


def flow(field: Field, backend: str, derivatives: bool = True) -> Any:
    """An integrator of a field: it has ``fly`` and ``sample``."""
    return with_heyoka.compiled(field, derivatives) if backend == "heyoka" else with_scipy.flight(field, derivatives)


def carrier(field: Field, backend: str | None) -> tuple[Fly, str]:
    """``fly`` of an integrator, and the integrator's name."""
    name = choose(backend, OF_ANY_MODEL)
    fly: Fly = flow(field, name).fly
    return fly, name
