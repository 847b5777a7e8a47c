"""The article's model: functions that only it has, and closed forms of public questions."""

import lazy_loader as _lazy

from .parameters import Parameters as Parameters

__getattr__, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)

#: The module of each question's closed form, a function of the same name.
CLOSED_FORMS = {
    name: module
    for module, names in {
        ".kang_nam.quartic.solver": ("equilibria", "count"),
        ".kang_nam.quartic.adaptive_precision": ("precise_equilibria",),
        ".kang_nam.states": ("linked", "border_ends", "airborne", "rest_index", "cases"),
        ".kang_nam.folds": ("folds",),
        ".kang_nam.cusps": ("cusps", "precise_cusps"),
        ".kang_nam.flutter": ("flutter_onsets",),
        ".kang_nam.hopf_curves": ("onset_curves",),
        ".kang_nam.bifurcation_sets": ("bifurcation_set",),
        ".kang_nam.lowest_fold": ("critical_friction",),
        ".kang_nam.jump_values": ("first_limit_points", "limit_point_passed"),
        ".kang_nam.certificates": ("claims",),
        ".motion.with_compiled": ("integrate",),
    }.items()
    for name in names
}
