"""The article's model: where its closed forms stand, each under the name of the question that it answers."""

from __future__ import annotations

from ..models.parameters import Parameters

__all__ = ["CLOSED_FORMS", "Parameters"]

_ROOMS = {
    ".kang_nam.quartic": ("equilibria", "count"),
    ".kang_nam.folds": (
        "folds", "cusps", "flutter_onsets", "bifurcation_set", "critical_friction",
    ),
    ".kang_nam.lift_off": ("aloft",), ".kang_nam.rest": ("rest_index",), ".kang_nam.jumps.events": ("have_jumped",),
    ".kang_nam.jumps.jump_values": ("first_ends",), ".kang_nam.jumps.certificates": ("certify",),
    ".kang_nam.jumps.margins": ("safe_within",),
    ".kang_nam.ranks": ("linked", "open_ends"), ".kang_nam.cases": ("cases",),
    ".kang_nam.digits": ("precise_equilibria", "precise_cusps"), ".motion.with_compiled": ("integrate",),
}  # fmt: skip
#: Question → room of its closed form.
CLOSED_FORMS = {name: room for room, names in _ROOMS.items() for name in names}
