"""The article's model: where its closed forms stand, each under the name of the public function or the step that it answers."""

from __future__ import annotations

from ..parameters import Parameters

__all__ = ["CLOSED", "Parameters"]

_ROOMS = {
    "kang_nam.statics": ("equilibria", "count"),
    "kang_nam.catastrophe": (
        "folds", "cusps", "flutter_onsets", "bifurcation_set", "quasi_static_path", "critical_friction",
    ),
    "kang_nam.lift_off": ("aloft",), "kang_nam.rest": ("rest_index",), "kang_nam.design.events": ("have_jumped",),
    "kang_nam.design.jump_values": ("first_ends",), "kang_nam.design.certificates": ("certify",),
    "kang_nam.design.margins": ("safe_within",),
    "kang_nam.ranks": ("linked",), "kang_nam.cases": ("cases",),
    "kang_nam.digits": ("precise_equilibria", "precise_cusps"), "dynamics.with_compiled": ("integrate",),
}  # fmt: skip
#: What may vary, where that is not any parameter.
_ALONG = {
    "precise_cusps": (("theta0", "mu0"),),
}  # fmt: skip
#: Public function or step → room of its closed form, and along what it is known; nothing there for anything.
CLOSED = {name: (room, _ALONG.get(name, ())) for room, names in _ROOMS.items() for name in names}
