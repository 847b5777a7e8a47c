r"""A mass on a floor with dry friction, driven by a harmonic force: it slides, or stops at turns.

::

                     N_0
               k      |
    |-------/\/\/\--+---+
                    | m |---> x  <--- P cos(ω t)
                    +---+
     ------------------------------- floor

A spring holds a mass on a floor, and a force drives it. Friction holds it by up to μ_s N_0, and
takes μ_k N_0 where it slides. Lengths are measured in P/k, time in √(m/k). The phase φ is that of a
clock: it grows by ω t, and a motion may begin at any.

With f = μ_k N_0/P, a motion that slides and never rests has the amplitude

    √(1/(1 − ω²)² − (f S)²),   S = sin(π/ω)/(ω (1 + cos(π/ω))),

and what rests where |x| + 1 ≤ μ_s N_0/P stays there for good. Below ω = 1 a motion may stop at both
turns: it rests there until force and spring pull by more than μ_s N_0.

After J. P. Den Hartog, Forced vibrations with combined Coulomb and viscous friction, Transactions
of the ASME 53 (1931) 107–115.
"""

from ..model import Page, cos, sgn

page = Page("A mass on a floor with dry friction, driven by a harmonic force: it slides or stops.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
P = page.unit("P", "N", "amplitude of the force")

mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.4)
mu_k = page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)
N_0 = page.parameter("N_0", "N", "normal force", ">= 0", 0.5, becomes="kappa")
omega = page.parameter("omega", "1/s", "frequency of the force", "> 0", 0.7)

x = page.coordinate("x", "m", "displacement along the floor")
phase = page.clock(omega)

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.force(P * cos(phase), along=x)
page.normal_force(N_0)
page.friction(x, 0, slip=lambda v: mu_k * sgn(v), holds=mu_s)
