r"""Two masses in a row, of which the first rubs on the belt with a friction that falls, and tows
the second.

::

              k_2, c_2        k_1
      (m_2)--/\/\-]|-(m)----/\/\/--|
        x_2           |
                   F_L presses down, k_s leans under 45° so that the contact feels x
             ~~~~~~~~k_c~~~~~~~
      ==============================>  V
"""

from spragsym.derive.model import Abs, Page, exp, sgn

page = Page(
    "Two masses in a row: one rubs with a falling friction, the other is towed by a spring "
    "and a damper."
)

m = page.unit("m", "kg", "mass that rubs")
k_c = page.unit("k_c", "N/m", "contact stiffness")
F_L = page.unit("F_L", "N", "preload")

mu_s = page.parameter("mu_s", "1", "largest friction", ">= 0", 0.6)
v_s = page.parameter("v_s", "m/s", "speed over which friction falls", "> 0", 0.5)
d = page.parameter("d", "s/m", "steepness of the friction law", "> 0", 10.0)
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
k_1 = page.parameter("k_1", "N/m", "stiffness to ground", ">= 0", 0.5, becomes="alpha")
k_2 = page.parameter("k_2", "N/m", "spring between the masses", "> 0", 0.3, becomes="sigma")
k_s = page.parameter("k_s", "N/m", "spring under 45 degrees", ">= 0", 0.2, becomes="eta")
c_2 = page.parameter("c_2", "N s/m", "damper between the masses", ">= 0", 0.1, becomes="zeta")
m_2 = page.parameter("m_2", "kg", "towed mass", "> 0", 0.7, becomes="nu")

x = page.coordinate("x", "m", "displacement along the belt")
y = page.coordinate("y", "m", "displacement across the belt")
x_2 = page.coordinate("x_2", "m", "displacement of the towed mass")

page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2 + m_2 * page.rate(x_2) ** 2 / 2)
page.spring(k_1, along=x)
page.spring(k_2, along=x - x_2)
page.damper(c_2, along=x - x_2)
page.potential(k_s * (x - y) ** 2 / 4)
page.force(0, -F_L, at=(x, y))
page.contact(y, lambda depth: k_c * depth)
page.friction(x, V, lambda v: mu_s * (1 - exp(-d * Abs(v))) / (1 + Abs(v) / v_s) * sgn(v))
