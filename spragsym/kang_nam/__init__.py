"""The article's model: what only it has, and its closed forms, each by the name of the public function that it answers."""

import lazy_loader as _lazy

from ..models.parameters import Parameters as Parameters

__getattr__, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)

_MODULES = {
    ".kang_nam.quartic.solver": ("equilibria", "count"),
    ".kang_nam.folds.fold_points": ("folds",), ".kang_nam.folds.cusp_points": ("cusps",),
    ".kang_nam.folds.flutter_points": ("flutter_onsets",), ".kang_nam.folds.bifurcation_sets": ("bifurcation_set",),
    ".kang_nam.folds.lowest_fold": ("critical_friction",), ".kang_nam.lift_off": ("aloft",), ".kang_nam.rest": ("rest_index",),
    ".kang_nam.jumps.events": ("have_jumped",), ".kang_nam.jumps.jump_values": ("first_ends",),
    ".kang_nam.jumps.certificates": ("claims",),
    ".kang_nam.ranks": ("linked", "open_ends"), ".kang_nam.cases": ("cases",),
    ".kang_nam.digits": ("precise_equilibria", "precise_cusps"), ".motion.with_compiled": ("integrate",),
}  # fmt: skip
#: Question → module of its closed form.
CLOSED_FORMS = {name: module for module, names in _MODULES.items() for name in names}
