r"""Half of a shallow truss that a load presses down until it snaps through: no friction, no
contact, no angle.

::

          P
          |
          v
          o  m           height h
           \
        k,c \
             \
        ------o------    span b
"""

from spragsym.derive.model import Page

page = Page("Half of a shallow truss, pressed down until it snaps through.")

m = page.unit("m", "kg", "mass at the apex")
k = page.unit("k", "N/m", "stiffness of the bar")
b = page.unit("b", "m", "half of the span")

h = page.parameter("h", "m", "height of the apex without load", "> 0", 0.3, becomes="eta")
P = page.parameter("P", "N", "load on the apex", ">= 0", 0.004, becomes="pi_load")
c = page.parameter("c", "N s/m", "damper along the bar's height", ">= 0", 0.1, becomes="zeta")

w = page.coordinate("w", "m", "how far the apex has come down")

page.kinetic(m * page.rate(w) ** 2 / 2)
page.spring(k, (0, h - w), (b, 0), length=(b**2 + h**2) ** (1 / 2))
page.damper(c, along=w)
page.force(P, along=w)
