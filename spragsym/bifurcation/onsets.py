"""Onsets of flutter as a result: supercritical or subcritical, once that is asked."""

from __future__ import annotations

from dataclasses import dataclass, fields
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..numerics.balls import Undecided
from ..numerics.interval_arrays import FloatArray
from ..results.points import Points

#: Why an onset of (27) has no coefficient.
UNDAMPED = (
    "without damping two frequencies meet there, and all eigenvalues stay on the imaginary axis up to it: no generic Hopf point; "
    "ask for the onsets of the damped model, damping=True"
)
#: Why one has that is not told from 0, and one that is smaller than what its law can mean.
NEAR_ZERO = "the first Lyapunov coefficient is not told from 0 by its bound"
BELOW_THE_LAW = (
    "the first Lyapunov coefficient is below the smoothing of the friction law: up to amplitudes at which sliding stops it "
    "changes the growth rate by less than {:.0e} ω; what happens there decides"
)
#: Change of the growth rate over ω below which a coefficient is the tail of a smoothed law.
MEANT = 1e-9


def _of_forms(name: str, missing: float) -> cached_property[FloatArray]:
    """A column of normal forms, of onsets that have one."""
    return cached_property(
        lambda found: np.array([missing if isinstance(form, str) else getattr(form, name) for form in found.normal_forms])
    )


@dataclass(frozen=True, eq=False)
class Onsets(Points):
    """Onsets of flutter along one parameter, of the kind ``"hopf"`` or ``"flutter"``, with their normal forms.

    What follows is computed when it is first asked for; with all that :class:`Points` has, ``omega`` the frequency.

    Attributes
    ----------
    criticality : ndarray of str
        ``"gentle"`` where l₁ < 0 is proved (supercritical: the cycle that is born attracts within the plane of the pair, and
        grows from nothing), ``"dangerous"`` where l₁ > 0 is (subcritical: an unstable cycle shrinks onto the state, and beyond
        the onset motions go far), else ``"undecided"``, also where l₁ comes from the tail of a law smoothed at rest alone.
    lyapunov, lyapunov_error : ndarray
        The first Lyapunov coefficient l₁ and a bound on its error that is proved; NaN and inf where ``why`` says that there is
        none. The state is coordinates, then rates, in the model's units, and ⟨q, q⟩ = ⟨p, q⟩ = 1.
    crossing, crossing_error : ndarray
        d Re λ / d parameter of the pair: where it is positive, the state is unstable for larger values.
    when : ndarray of str
        What the sign of that says, where its bound leaves it: as the parameter goes ``"up"`` or ``"down"``, this pair makes the
        state unstable; else empty.
    why : tuple of str
        Why an onset is undecided; empty for the others.
    """

    @property
    def table_columns(self) -> dict[str, NDArray[Any]]:
        """The frequency, what closed forms know, and the criticality of each."""
        more = {name: getattr(self, name) for name in ("omega", "branch", "count", "side") if hasattr(self, name)}
        return {**more, "kind": self.kind, "criticality": self.criticality}

    @cached_property
    def normal_forms(self) -> tuple[Any, ...]:
        """The :class:`~spragsym.bifurcation.normal_forms.NormalForm` of each, or why it has none."""
        return tuple(self._normal_form(row) for row in range(len(self)))

    lyapunov = _of_forms("lyapunov", np.nan)
    lyapunov_error = _of_forms("lyapunov_error", np.inf)
    crossing = _of_forms("crossing", np.nan)
    crossing_error = _of_forms("crossing_error", np.inf)

    @cached_property
    def when(self) -> NDArray[np.str_]:
        """Direction of the parameter, ``"up"`` or ``"down"``, in which the state loses its stability to this pair; else empty."""
        known = np.abs(self.crossing) > self.crossing_error
        return np.where(known, np.where(self.crossing > 0, "up", "down"), "")

    @cached_property
    def criticality(self) -> NDArray[np.str_]:
        """gentle, dangerous or undecided."""
        return np.array([told(form)[0] for form in self.normal_forms], dtype=np.str_)

    @cached_property
    def why(self) -> tuple[str, ...]:
        """Why an onset is undecided."""
        return tuple(told(form)[1] for form in self.normal_forms)

    def _normal_form(self, row: int) -> Any:
        if self.kind[row] != "hopf":
            return UNDAMPED
        state, vary = self.state(row), self.vary[0]
        # The error is relative to max(1, |value|), and its product with that is rounded.
        radii = self.error[row] * np.maximum(1.0, np.abs([*state, getattr(self, vary)[row]])) * (1 + 2.0**-50)
        return form_or_why(self.parameters.model, self.given(row), state, vary, radii)

    def given(self, row: int) -> FloatArray:
        """Parameters of one of them, in the order of the model."""
        return np.array([getattr(self, name)[row] for name in self.parameters.model.parameters])

    def state(self, row: int) -> FloatArray:
        """Coordinates of one of them."""
        return np.array([getattr(self, name)[row] for name in self.parameters.model.coordinates])


def form_or_why(*point: Any) -> Any:
    """The normal form of a point, arguments as of :func:`.normal_forms.normal_form`, or why it has none."""
    from .normal_forms import normal_form  # many who ask for onsets never ask for this

    try:
        return normal_form(*point)
    except Undecided as reason:
        return str(reason)


def told(form: Any) -> tuple[str, str]:
    """What the sign of the coefficient says, and why nothing where it does not; of a normal form, or of why there is none."""
    if isinstance(form, str):
        return "undecided", form
    if not abs(form.lyapunov) > form.lyapunov_error:
        return "undecided", NEAR_ZERO
    if abs(form.lyapunov) * form.reach**2 < MEANT:
        return "undecided", BELOW_THE_LAW.format(MEANT)
    return "gentle" if form.lyapunov < 0 else "dangerous", ""


def onsets_of(found: Points) -> Onsets:
    """Points as onsets."""
    return Onsets(**{each.name: getattr(found, each.name) for each in fields(Points)})
