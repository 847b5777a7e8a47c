"""The list of what a page can't describe, each with what can be written instead; the guide lists
them, and errors quote them.
"""

from enum import Enum


class Limit(Enum):
    """Something that a page can't describe, and what to write instead, in the guide's order."""

    CONTACT_DAMPING = (
        "damping in the contact",
        "a damper beside it, page.damper(c, along=y), takes the same energy, in lift-off too, and "
        "adds nothing to the normal force",
    )
    NORMAL_SPEED = (
        "a normal force that holds a speed",
        "take its value at the speed that matters, as page.normal_force(F_L + c*V), or let it "
        "follow the place, as page.normal_force(F_L * exp(y/L_0))",
    )
    EITHER_FACE = (
        "a given normal force that is not seen to press, N >= 0, for all parameters of their "
        "domains and at all places",
        'give domains that decide it, as "> 0", or a form that does, as F_L*exp(y/L_0) in the '
        "place of F_L + k*y; what presses on either of two faces, in a slot or on a hoop, rubs "
        "with |N|: page.normal_force(N, unilateral=False)",
    )
    PULLING = (
        "a contact law that is not seen to push, law(depth) >= 0, for every depth > 0 and all "
        "parameters of their domains",
        'give domains that decide it, as "> 0", or a form that does, as k*depth + k_3*depth**3; '
        "what holds on as well never opens: page.contact(gap, law, unilateral=False)",
    )
    NONLINEAR_DAMPER = (
        "a damper that is nonlinear in speed",
        "take the coefficient at the speeds that matter, page.damper(c, along=x); it may depend "
        "on the place, as c*(1 + x**2/L_0**2)",
    )
    STICKING = (
        "a friction that is not 0 at speed 0 without what it holds there",
        "say both, as page.friction(x, V, slip=lambda v: mu_k*sgn(v), holds=mu_s), or write a law "
        "that is steep there, as mu0*tanh(d*v)",
    )
    PLANE = (
        "friction in a plane, whose direction turns with the sliding",
        "keep the direction along which it slides most, as page.friction(x, V, …), and say what "
        "resists across it as a damper, page.damper(mu0*N/V, along=y), while |y′| is far below V",
    )
    FORCING = (
        "a time that is not a clock's",
        "let phase = page.clock(omega) stand in cos and sin of whole multiples, as in "
        "page.force(P*cos(phase), along=x)",
    )
    FRICTION_STATE = (
        "friction with a state of its own",
        "write its steady value as a law of the sliding speed; a bristle may be a light mass that "
        "slides, on a spring and a damper",
    )
    MASS_OF_SPEED = (
        "a kinetic energy of more than the second power in the rates",
        "keep its terms without rates, linear and quadratic in them: masses may depend on the "
        "place, as m*(1 + x**2/L_0**2), and not on the speed",
    )
    WITHOUT_MASS = (
        "a slider without mass",
        "give it a mass so small that its frequency is far above the others",
    )
    FIFTH_COORDINATE = (
        "more than four coordinates",
        "hold still what is stiffest, or join what moves together",
    )

    def __init__(self, what: str, instead: str) -> None:
        self.what = what
        self.instead = instead

    def __str__(self) -> str:
        return f"a page can't say {self.what}; {self.instead}"
