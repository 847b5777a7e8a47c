"""The data of a brake, of which a report can be asked."""

from __future__ import annotations

import os
import warnings
from contextlib import nullcontext
from typing import TYPE_CHECKING

from ..core.progress import doing, show_progress
from ..models.parameters import POSITIVE, as_number
from .brake import Brake
from .data import read_brake

if TYPE_CHECKING:
    from .reports import Report


class Study(Brake):
    """The data of one brake with tolerances: ask for a report.

    Parameters
    ----------
    parameters : PhysicalParameters or mapping of str to float
        Single numbers in SI: of the article's model, or the quantities of ``model`` by name; V and
        d may be left out.
    tolerance : mapping, optional
        For each quantity that is known within limits only: how far it may be off, as a number in
        SI; its two ends, as a tuple; or text such as ``"15 %"``, ``"1 deg"``, ``"[150, 210] N/mm"``
        or, for a standard deviation, ``"sd 5 %"``. Where two ends do not hold the value their
        middle takes its place.
    correlation : mapping of pairs of names to float, optional
        Quantities that vary together, see :func:`spragsym.jump_probability`.
    model : str, optional
        Name or folder of the model.
    vary : str, optional
        The quantity that rises until the state jumps, where that is not the friction: a load, a
        stiffness, an angle.
    begin : float, optional
        From where it rises, in SI, instead of its least value.
    may_change : mapping of str to (float, float), optional
        Quantities that a proposal may change, each with the two ends of its range in SI; without it
        all, by up to a factor of 3.
    state : mapping of str to float, optional
        Coordinates in SI near which the state begins that is followed, in place of the reference
        state, as ``{"phi": -0.5}``.
    damping_ratio : float, optional
        That of every mode of the unloaded mechanism, in place of the dampers, which follow from it;
        of the article's model by that with dampers, ``damped``. See
        :func:`spragsym.report.damping.modal_dampers`.

    Attributes
    ----------
    quantities : dict of str to Measured
        Every quantity with its ends in SI, and the unit in which it came.
    model : str
        Name of the model.
    fit : FrictionFit or None
        The fit of the friction law, if it was measured.
    load : LoadParameter or None
        The loading parameter until the state jumps; None for a model without mu0 of which that is
        not said.

    Examples
    --------
    >>> from math import radians
    >>> from spragsym import PhysicalParameters
    >>> brake = PhysicalParameters(
    ...     m=0.35, k=1.8e5, k_x=9e3, k_y=0, k_c=1.5e6, F_L=420, L_0=0.038,
    ...     theta0=radians(52), mu0=0.3,
    ... )
    >>> study = Study(brake, tolerance={"k": "15 %", "mu0": (0.28, 0.32)})
    >>> round(study.report(probability=False, redesign=False).mu_jump, 4)
    0.3663
    """

    @classmethod
    def from_file(cls, path: str | os.PathLike[str], *, trust: bool | str = False) -> Study:
        """The study of a file such as ``brake.toml``; see :func:`spragsym.report.data.read_brake`.

        A number whose unit was probably meant otherwise is a UserWarning.
        """
        study = cls.of(**vars(read_brake(path, trust)))
        warn_of(study)
        return study

    def report(
        self,
        *,
        probability: bool = True,
        redesign: bool = True,
        oscillation: bool = True,
        safety: float = 1.2,
        n: int | None = None,
        progress: bool = False,
    ) -> Report:
        """Everything that can be said of this brake.

        Parameters
        ----------
        probability : bool
            Also the certificate, the probability of a jump, and which tolerance matters.
        redesign : bool
            Also what to change.
        oscillation : bool
            Also follow the motion to its cycle, if V and d are known; that takes about a second.
        safety : float
            What is changed keeps the jump at this many times the largest friction.
        n : int, optional
            Points for the probability: 4096 by closed forms, 2048 where each is followed.
        progress : bool
            Say on stderr what is being computed.

        Returns
        -------
        Report
            What is not answered for the model is None there, with the reason among the warnings.
        """
        from .facts import ReportOptions, facts  # heavy, and a refusal does not need it
        from .reports import Report

        options = ReportOptions(
            probability, redesign, oscillation, as_number("safety", safety, POSITIVE), n
        )
        with show_progress() if progress else nullcontext(), doing(""):
            return Report(**vars(facts(self, options)))

    def to_html(self, path: str | os.PathLike[str], report: Report | None = None) -> None:
        """Write the report as one page with its pictures, which needs no other file (extra
        ``plot``).
        """
        (report or self.report()).to_html(path)


def warn_of(study: Brake) -> None:
    """Warn of numbers of a file whose units were probably meant otherwise, where it is read."""
    from .advice import of_data  # heavy, and a refusal does not need it

    for said in of_data(study):
        warnings.warn(f"{study.source}: {said}", stacklevel=3)
