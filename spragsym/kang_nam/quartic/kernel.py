"""The generated algebra without the wrapper that restores shapes: of any number type."""

from __future__ import annotations

import inspect

from ...generated import catastrophe as _catastrophe
from ...generated import equilibrium as _equilibrium
from ...generated import stability as _stability
from ...generated.kernel import depressed as depressed

f_coefficients = inspect.unwrap(_equilibrium.f_coefficients)
resolvent = inspect.unwrap(_equilibrium.resolvent)
t_quartic = inspect.unwrap(_equilibrium.t_quartic)
f = inspect.unwrap(_equilibrium.f)
f_slope = inspect.unwrap(_equilibrium.f_slope)
f_curvature = inspect.unwrap(_equilibrium.f_curvature)
f_third = inspect.unwrap(_equilibrium.f_third)
f_changes = inspect.unwrap(_catastrophe.f_changes)
f_in_differences = inspect.unwrap(_catastrophe.f_in_differences)
fold_sextic = inspect.unwrap(_catastrophe.fold_sextic)
fold_cubics = inspect.unwrap(_catastrophe.fold_cubics)
fold_sine = inspect.unwrap(_catastrophe.fold_sine)
fold_angles = inspect.unwrap(_catastrophe.fold_angles)
state = inspect.unwrap(_equilibrium.state)
stiffness = inspect.unwrap(_stability.stiffness)
invariants = inspect.unwrap(_stability.invariants)
