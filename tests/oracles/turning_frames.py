"""A rotor in its own turning frame, a page as a user writes it, and its closed forms."""

from tests.oracles.user_pages import model_of

#: With damping of the shaft, c_i, which turns, and of the ground, c_e, which stands: in the frame
#: c_e (q′ + Ω × q). The force p follows the displacement, turned by a right angle.
ROTOR = '''r"""A disc on a shaft.

::

    turns at W
"""

from spragsym.derive.model import Page

page = Page("A disc on a shaft, in the frame of the shaft.")

m = page.unit("m", "kg", "mass")
T = page.unit("T", "s", "unit of time")
L = page.unit("L", "m", "unit of length")
k_x = page.parameter("k_x", "N/m", "stiffness along x", "> 0", 1.0)
k_y = page.parameter("k_y", "N/m", "stiffness along y", "> 0", 2.25)
c_i = page.parameter("c_i", "N s/m", "damping of the shaft", ">= 0", 0.0)
c_e = page.parameter("c_e", "N s/m", "damping of the ground", ">= 0", 0.0)
g = page.parameter("g", "N/m^3", "hardening of the shaft", "real", 0.0)
f = page.parameter("f", "N/m", "force across the displacement", "real", 0.0)
W = page.parameter("W", "1/s", "speed of the frame", "real", 0.5)

x = page.coordinate("x", "m", "displacement")
y = page.coordinate("y", "m", "displacement across")
v, w = page.rate(x), page.rate(y)

page.kinetic(m * ((v - W * y) ** 2 + (w + W * x) ** 2) / 2)
page.spring(k_x, along=x)
page.spring(k_y, along=y)
page.potential(g * (x**2 + y**2) ** 2 / 4)
page.damper(c_i + c_e, along=x)
page.damper(c_i + c_e, along=y)
page.force((c_e * W - f) * y, along=x)
page.force((f - c_e * W) * x, along=y)
'''

#: Three coordinates with every gyroscopic term that there is, and a part without rates.
GYROSTAT = '''r"""Three masses that turn.

::

    g_1, g_2, g_3
"""

from spragsym.derive.model import Page

page = Page("Three masses with gyroscopic forces between all of them.")

m = page.unit("m", "kg", "mass")
T = page.unit("T", "s", "unit of time")
L = page.unit("L", "m", "unit of length")
k = [page.parameter(f"k_{i}", "N/m", "stiffness", "> 0", 1.0 + i) for i in (1, 2, 3)]
c = [page.parameter(f"c_{i}", "N s/m", "damping", ">= 0", 0.0) for i in (1, 2, 3)]
g = [page.parameter(f"g_{i}", "kg/s", "gyroscopic", "real", 0.5) for i in (1, 2, 3)]
f = page.parameter("f", "N/m", "force across the displacement", "real", 0.0)
h = page.parameter("h", "N/m", "what the speed of the frame takes from stiffness", ">= 0", 0.0)

q = [page.coordinate(name, "m", "displacement") for name in ("x", "y", "z")]
v = [page.rate(one) for one in q]

page.kinetic(
    m * (v[0] ** 2 + 2 * v[1] ** 2 + v[2] ** 2 + v[0] * v[1]) / 2
    + g[0] * (q[1] * v[2] - q[2] * v[1]) / 2 + g[1] * q[2] * v[0] + g[2] * q[0] * v[1]
    + h * (q[0] ** 2 + q[1] ** 2) / 2
)
for place, rate in enumerate(q):
    page.spring(k[place], along=rate)
    page.damper(c[place], along=rate)
page.force(-f * q[1], along=q[0])
page.force(f * q[0], along=q[1])
'''


def rotor() -> object:
    """The model of the rotor."""
    return model_of(ROTOR, "rotor")


def gyrostat() -> object:
    """The model of the three masses."""
    return model_of(GYROSTAT, "gyrostat")
