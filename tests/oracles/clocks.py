"""Pages with a clock, as a user writes them."""

HEAD = '''r"""A mass that is shaken.

::

    P cos(omega t)
"""



from spragsym.derive.model import Page, cos, sgn, sin, sqrt, tanh

page = Page("A mass that is shaken.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
P = page.unit("P", "N", "amplitude of the force")
omega = page.parameter("omega", "1/s", "frequency", "> 0", 0.6)

x = page.coordinate("x", "m", "displacement")
phase = page.clock(omega)

page.kinetic(m * page.rate(x) ** 2 / 2)
'''

#: Den Hartog's: dry friction on a floor.
FRICTION = f"""{HEAD}
f = page.parameter("f", "N", "normal force", ">= 0", 0.5)
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 0.4)

page.spring(k, along=x)
page.force(P * cos(phase), along=x)
page.normal_force(f)
page.friction(x, 0, slip=lambda v: mu * sgn(v), holds=mu)
"""

#: Duffing's.
DUFFING = f"""{HEAD}
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
g = page.parameter("g", "N/m^3", "hardening", "real", 0.05)

page.spring(k, along=x)
page.potential(g * x**4 / 4)
page.damper(c, along=x)
page.force(P * cos(phase), along=x)
"""

#: Everything that may follow the clock: the end of a spring, a gap, a normal force, a belt.
MOVED = f"""{HEAD}
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
a = page.parameter("a", "m", "amplitude of what moves", ">= 0", 0.3)
e = page.parameter("e", "1", "share of the normal force that varies", "[0, 1]", 0.5)
k_c = page.parameter("k_c", "N/m", "stiffness of the stop", "> 0", 5.0)
V = page.parameter("V", "m/s", "speed of the belt", ">= 0", 0.4)
f = page.parameter("f", "N", "normal force", ">= 0", 0.5)

page.potential(k * (x - a * sin(phase)) ** 2 / 2)
page.damper(c, along=x)
page.contact(x - a * cos(2 * phase) - P / k / 10, lambda depth: k_c * depth, name="stop")
page.friction(
    x,
    V + page.rate(a * sin(phase)),
    lambda v: tanh(5 * v * sqrt(m * k) / P) / 2,
    on=page.normal_force(f * (1 + e * cos(phase)), name="belt"),
)
"""
