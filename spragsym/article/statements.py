"""The article's statements, in its order: where each stands, what it says, and what decides it."""

from __future__ import annotations

from collections.abc import Sequence

from . import computed, oscillation
from .ledger import Statement, Status

_PROMISED = "what the library promises: 1e-12 relative to the larger of 1 and the value"
_MOTION = "a unit of the last digit given: two integrators and two tolerances agree to it"
_LAST_DIGIT = "a unit of the last digit given"


def _figure(number: int | str) -> str:
    return f"spragsym figures --only {number} --out figures"


def _family(number: int, name: str, bracket: tuple[float, float], samples: Sequence[tuple[float, bool]]) -> list[Statement]:
    """The yes or no of Figures 8 to 10 for each sample of a parameter."""
    return [
        Statement(
            id=f"fig-{number}-{name}-{value:g}",
            where=f"Section 3, text before Figure 8; Figure {number}",
            stated=f"at {name} = {value:g} the curve from small deformation "
            + ("meets the catastrophe" if jumps else "is smooth"),
            compute=computed.family_row(name, value, bracket, jumps),
            outcome=("it jumps: mu_lowest is below" if jumps else "no jump: mu_lowest is above")
            + f" mu0 = 0.5; the answer changes at the critical {name}",
            test="test_yes_or_no_of_figures_8_to_10",
            command=_figure("cusp-friction"),
            tolerance=_PROMISED,
        )
        for value, jumps in samples
    ]


STATEMENTS: tuple[Statement, ...] = (
    Statement(
        id="fig-3",
        where="Section 2, Figure 3",
        stated="regularized friction coefficient over speed, contact force over displacement",
        compute=computed.friction_law,
        outcome="neither V nor d is stated; with our V = 0.5, d = 10 friction at steady sliding is 0.7 % below "
        "mu0, which (12) and (14) put in its place",
        status=Status.NOT_STATED,
        test="test_friction_at_steady_sliding",
        command=_figure(3),
        tolerance=_PROMISED,
    ),
    Statement(
        id="claim-roots-of-21",
        where="Section 2, after (21)",
        stated="the solutions of (21) give the steady-sliding equilibria",
        compute=computed.roots_of_21,
        outcome="(21) has one real root more than there are equilibria, two or four in all: it has L < 0 or "
        "y >= 0 and is to be left out",
        status=Status.CORRECTED,
        test="test_equation_21_has_one_root_too_many",
        command="spragsym equilibria --theta0 30",
    ),
    Statement(
        id="claim-reference-12",
        where="Section 2, before (27)",
        stated="'the eigenvalue λ of Equations (12) and (13)'",
        compute=computed.reference_12,
        outcome="of (8) and (9), linearized: (12) and (13) hold no accelerations",
        status=Status.MISPRINT,
        test="test_cross_references",
        command="spragsym check --claims",
    ),
    Statement(
        id="claim-reference-22",
        where="Section 3, first paragraph",
        stated="'by solving Equations (21), (22), and (27)'",
        compute=computed.reference_22,
        outcome="(21), (26) and (27): the polynomial without contact is (26), and (22) is its matrix form",
        status=Status.MISPRINT,
        test="test_cross_references",
        command="spragsym check --claims",
    ),
    Statement(
        id="fig-4-regions",
        where="Section 3, first paragraph; Figure 4a,b",
        stated="three steady-sliding equilibria for the lower and upper range of theta0",
        compute=computed.base_regions,
        outcome="three below the first fold and above the second, one between them",
        test="test_folds_of_figures_4_and_5",
        command="spragsym bifurcation",
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-4-stability",
        where="Section 3, first paragraph; Figure 4a,b",
        stated="one of the three is geometrically unstable and the others are stable",
        compute=computed.base_stability,
        outcome="the middle one is divergent; the others, and the single one, are stable",
        test="test_stability_by_eigenvalues",
        command="spragsym equilibria --theta0 30",
    ),
    Statement(
        id="fig-4-lift-off",
        where="Section 3, first paragraph; Figure 4c,d",
        stated="fixed points without contact are static equilibria in the lift-off state",
        compute=computed.lift_off,
        outcome="one for every theta0, and divergent; d_0 of (A1) is misprinted, as printed it gives other lengths (row A1-d0)",
        test="test_lift_off",
        command="spragsym equilibria --theta0 49",
        tolerance=_PROMISED,
    ),
    Statement(
        id="claim-mu-cr",
        where="Section 3, before Figure 5",
        stated="the critical friction of the linear sprag model is around 0.58",
        compute=computed.linear_critical,
        outcome="0.5741: 0.58 is 0.0059 or 1.0 % above it, and to two digits it is 0.57",
        status=Status.CORRECTED,
        test="test_critical_friction_of_the_linear_model",
        command="spragsym critical --theta0 30",
        tolerance="half a unit of the last printed digit, 0.005",
    ),
    Statement(
        id="fig-5-bounded",
        where="Section 3, before Figure 5; Figure 5a,b",
        stated="below mu_cr the equilibrium of the linear model always exists and is bounded",
        compute=computed.linear_bounded,
        outcome="no pole, and y < 0, for every theta0 and for mu0 up to mu_cr (1 - 1e-9)",
        test="test_critical_friction_of_the_linear_model",
        command=_figure(5),
        digits=7,
    ),
    Statement(
        id="fig-5-poles",
        where="Section 3, before Figure 5; Figure 5c,d",
        stated="above mu_cr it goes to infinity at certain angles, and with it the contact force",
        compute=computed.linear_poles,
        outcome="two poles at mu0 = 0.7; towards them, from outside, the contact force has no bound",
        test="test_poles_of_the_linear_model",
        command=_figure(5),
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-5-approximation",
        where="Section 3, before Figure 5; Figure 5",
        stated="the linear model approximates the nonlinear one for the lower and upper range of theta0, but not in between",
        compute=computed.linear_approximates,
        outcome="x is within 10 % below the first angle and above the second, and not between them",
        test="test_where_the_linear_model_is_good",
        command=_figure(5),
        digits=9,
        tolerance="the article has no measure; ours is a tenth of x",
    ),
    Statement(
        id="claim-one-or-three",
        where="Section 3, before Figure 5 and before Figure 11",
        stated="there are always one or three real steady-sliding equilibria",
        compute=computed.one_or_three,
        outcome="counted for all parameters of the figures, and proved for all others in derive/kang_nam/theorem.py",
        test="test_one_or_three_by_signs",
        command="spragsym check",
    ),
    Statement(
        id="claim-bounded",
        where="Abstract; Section 3, before Figure 5; Section 4",
        stated="with a variable angle the contact force is always bounded",
        compute=computed.bounded,
        outcome="by (15) it is at most (kappa + sigma (1 - sin theta0)) / (1 + beta + sigma), whatever mu0",
        test="test_contact_force_is_bounded",
        command="spragsym equilibria --theta0 30",
        digits=8,
    ),
    Statement(
        id="fig-6-rising",
        where="Section 3, before Figure 6; Figure 6a",
        stated="as theta0 rises from zero there is a jump from the lower to the upper stable equilibrium",
        compute=computed.jump_rising,
        outcome="one jump, at the fold, to the only equilibrium that is left",
        test="test_jumps_of_figure_6",
        command="spragsym bifurcation --mu0 0.7",
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-6-falling",
        where="Section 3, before Figure 6; Figure 6a",
        stated="as theta0 falls there is no jump, but the static deformation grows",
        compute=computed.no_jump_falling,
        outcome="no jump from the state in which the rising path ends, and x grows between the angles given; "
        "the other stable state above the second fold, which no rising path reaches, does jump as theta0 "
        "falls through that fold",
        test="test_jumps_of_figure_6",
        command=_figure(6),
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-6-linear",
        where="Section 3, before Figure 6; Figure 6b",
        stated="between critical angles the linear model has no steady sliding",
        compute=computed.no_linear_sliding,
        outcome="between its poles y > 0, no contact; outside of them y < 0",
        test="test_poles_of_the_linear_model",
        command=_figure(6),
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-7a",
        where="Section 3, before Figure 7; Figure 7a",
        stated="from x = y = 0 at theta0 = 49 deg the motion reaches a stable limit cycle",
        compute=computed.limit_cycle,
        outcome="V, d and the initial speed are not stated; from rest with V = 0.5, d = 10 it does, and repeats "
        "itself after tau = 8000; the only equilibrium, stable by (27), repels slowly: the friction law feeds one of its modes",
        status=Status.NOT_STATED,
        consequence="a motion of 2000 time units does not show what it comes to: another stable cycle, of period 69.16, stands "
        "beside this one, and which of them is reached depends on the start",
        test="test_limit_cycle_by_another_integrator",
        command="spragsym simulate --theta0 49 --t-end 10000 --transient 8000",
        digits=5,
        tolerance=_MOTION,
    ),
    Statement(
        id="fig-7b",
        where="Section 3, before Figure 7; Figure 7b",
        stated="near the catastrophe the amplitude increases drastically as theta0 varies",
        compute=computed.amplitude_jump,
        outcome="V, d and the window in time are not stated; from rest with V = 0.5, d = 10 the RMS of x grows "
        "more than fivefold, before the fold: the motion overshoots the divergent state while the stable one "
        "is still there",
        status=Status.NOT_STATED,
        consequence="Figure 7b can't be compared point by point: V, d and the start decide where the amplitude grows",
        test="test_amplitude_jump_by_another_integrator",
        command=_figure(7),
        digits=5,
        tolerance=_MOTION,
    ),
    Statement(
        id="fig-7b-fate",
        where="Section 3, before Figure 7; Figure 7b",
        stated="the amplitude increases drastically 'near the value of catastrophe'",
        compute=oscillation.fate_of_rest,
        outcome="the jump is no bifurcation: there the start at rest lies on the stable manifold of the divergent equilibrium, "
        "at which the motion then hovers; other starts jump elsewhere, and stable sliding goes on to the fold. V and d are not "
        "stated; with V = 0.5, d = 10 and with three other belts it stands 3 to 4 degrees before the fold",
        status=Status.CORRECTED,
        consequence="the angle of the jump in Figure 7b is a property of the start, not of the system: no limit to design by",
        test="test_the_fate_of_rest",
        command="spragsym figures --only cycles --out figures",
        digits=9,
        tolerance="a unit of the last digit given: the saddle's stable manifold, refined to later and later times",
    ),
    Statement(
        id="fig-7-oscillation",
        where="Section 3, before Figure 7",
        stated="'the sprag-slip oscillation was initiated from the catastrophic behavior': the sliding equilibrium meets the "
        "catastrophe and seeks the adjacent attractor",
        compute=oscillation.lives_below,
        outcome="the oscillation is there without it: a stable limit cycle lies beside stable sliding at 10, 20, 30 and 40 "
        "degrees, far below the fold. V and d are not stated: this is so with V = 0.5, d = 10, and at 30 degrees with three "
        "other belts",
        status=Status.CORRECTED,
        consequence="to stay below the catastrophe rules out the jump of slow changes, not the oscillation: a knock can start it "
        "where the statics see nothing",
        test="test_the_oscillation_far_below_the_fold",
        command="spragsym cycles --theta0 42 --vary theta0=10:60",
        digits=9,
        tolerance="a unit of the last digit given: the error of the cycles is below 1e-10",
    ),
    *_family(8, "beta", (1.0, 2.0), ((0.0, True), (1.0, True), (2.0, False))),
    *_family(9, "alpha", (0.007, 0.07), ((0.007, True), (0.07, False), (0.7, False))),
    Statement(
        id="fig-9-flutter",
        where="Section 3, text before Figure 8; Figure 9",
        stated="for alpha = 0.7 flutter by mode coupling takes place around 150 deg",
        compute=computed.flutter_alpha,
        outcome="between the two onsets; it grows fastest 0.74 deg from 150 deg",
        test="test_flutter_by_eigenvalues",
        command="spragsym bifurcation --alpha 0.7 --undamped",
        digits=11,
        tolerance="'around 150' has two digits: 5 deg",
    ),
    *_family(10, "sigma", (0.01, 0.1), ((0.01, False), (0.1, True), (1.0, True))),
    Statement(
        id="fig-10-flutter",
        where="Section 3, text before Figure 8; Figure 10",
        stated="one of the stable equilibria for sigma = 1 can become unstable by mode coupling",
        compute=computed.flutter_sigma,
        outcome="the one of largest theta does, below the first onset and above the second",
        test="test_flutter_by_eigenvalues",
        command="spragsym bifurcation --sigma 1 --undamped",
        digits=11,
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-11",
        where="Section 3, before Figure 11; Figure 11",
        stated="one or three equilibria, the central surface divergent, the upper and lower ones stable",
        compute=computed.sheets,
        outcome="so it is for 0 <= mu0 <= 1; flutter needs five times as much friction",
        test="test_stability_by_eigenvalues",
        command=_figure(11),
        digits=4,
        tolerance="the article's range of mu0 is unknown; ours is 0 to 1",
    ),
    Statement(
        id="fig-12-set",
        where="Section 3, before Figure 11; Figure 12",
        stated="the bifurcation set separates one solution from three",
        compute=computed.separates,
        outcome="one on one side and three on the other, all along both curves",
        test="test_bifurcation_set_by_counts",
        command="spragsym bifurcation --plot set.pdf",
    ),
    Statement(
        id="claim-must-jump",
        where="Section 3, before Figure 11",
        stated="at the bifurcation set the state must jump to another",
        compute=computed.must_jump,
        outcome="only the state that ends there does: a-a' passes two folds each way, one of them without a jump",
        status=Status.CORRECTED,
        test="test_jumps_of_figure_13",
        command=_figure(13),
    ),
    Statement(
        id="fig-12-cusp",
        where="Section 3, before Figure 11; Figure 12",
        stated="there is a cusp, and near it two jumps for a given theta0",
        compute=computed.cusp,
        outcome="one cusp, proved to be one; two jumps between where its lower curve leaves mu0 = 0 and the cusp",
        test="test_cusp_by_residuals",
        command="spragsym bifurcation",
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-13a",
        where="Section 3, before Figure 11; Figure 13a",
        stated="at theta0 = 60 deg the trajectory has hysteresis, its reverse path is another",
        compute=computed.hysteresis,
        outcome="it jumps up and down at different frictions",
        test="test_jumps_of_figure_13",
        command=_figure(13),
        tolerance=_PROMISED,
    ),
    Statement(
        id="fig-13b",
        where="Section 3, before Figure 11; Figure 13b",
        stated="at theta0 = 40 deg there is a single jump, and the trajectory does not return",
        compute=computed.no_return,
        outcome="one jump as mu0 rises, none as it falls to zero: the fold that would bring it back has mu0 < 0",
        test="test_jumps_of_figure_13",
        command=_figure(13),
        tolerance=_PROMISED,
    ),
    Statement(
        id="claim-reference-10",
        where="caption of Figure 13",
        stated="'trajectories of a-a' and b-b' in Figure 10'",
        compute=computed.reference_10,
        outcome="in Figure 11: friction varies along these paths, and is constant in Figure 10",
        status=Status.MISPRINT,
        test="test_cross_references",
        command=_figure(11),
    ),
    Statement(
        id="fig-14",
        where="Section 3, before Figure 11; Figure 14",
        stated="for sigma = 1 a Hopf bifurcation separates stable equilibria from flutter on the surface",
        compute=computed.hopf,
        outcome="so it does, from the friction given upwards; (27) has no damping, so that two frequencies meet "
        "where a Hopf bifurcation in the usual sense has one pair that crosses",
        test="test_flutter_by_eigenvalues",
        command=_figure(14),
        digits=4,
        tolerance=_LAST_DIGIT,
    ),
)
