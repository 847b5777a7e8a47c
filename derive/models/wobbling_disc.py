r"""A disc that wobbles between two brake pads: friction, and the gyroscopic moments of its spin.

::

         | N_0, k, d
       +---+
       | μ |          two pads at the radius r
    =============o=============   a disc of thickness h turns at Ω,
       | μ |     |                tilted by a and b on a bearing k_t, c_t
       +---+
         | N_0, k, d

A minimal model of squeal in which the speed of the disc counts, after U. von Wagner, D. Hochlenert
and P. Hagedorn, Minimal models for disk brake squeal, Journal of Sound and Vibration 302 (2007),
to first order in the tilts. The tilt a lifts the disc by r a at the pads, b turns it about the axis
that leads to them. The spin, with the moment of inertia Φ about its axis, adds Φ Ω b a′ to the
kinetic energy. Each pad is a spring k and a damper d, pressed on by N_0: the two press with the
difference 2 N, and their friction drives b with the moment μ h N. Its direction follows the
sliding, so that it also damps a, by μ N_0 h²/(2 r Ω). While both pads are on, N is k r a, and half
of it after one has come off, here with a smooth passage, N = (k r a/2) (1 + 1/(1 + (k r a/N_0)²)).
The disc slides faster than it wobbles.

With k_a = 1 + 2 κ, g = φ Ω, and c_a and c_b, all that damps a and b, squeal sets in where

    μ η κ g = c_a (ω² − 1) + c_b (ω² − k_a),   ω⁴ − (1 + k_a + g² + c_a c_b) ω² + k_a = 0,

ω² being the larger root: without spin there is none. Without damping every friction makes it
squeal.
"""

from ..model import Page, log

page = Page("A disc that spins and wobbles between two pads: gyroscopic moments and friction.")

Theta = page.unit("Theta", "kg m^2", "moment of inertia of the disc about a diameter")
k_t = page.unit("k_t", "N m", "stiffness of the bearing against tilting")
r = page.unit("r", "m", "radius of the pads")

mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.9, latex=r"\mu_o")
Omega = page.parameter("Omega", "1/s", "speed of the disc", "> 0", 0.2, latex=r"\Omega")
Phi = page.parameter(
    "Phi", "kg m^2", "moment of inertia of the disc about its axis", ">= 0", 2.0, becomes="phi"
)
h = page.parameter("h", "m", "thickness of the disc", "> 0", 0.15, becomes="eta")
k = page.parameter("k", "N/m", "stiffness of each pad", "> 0", 0.3, becomes="kappa")
N_0 = page.parameter("N_0", "N", "force that presses each pad", "> 0", 0.02, becomes="nu")
d = page.parameter("d", "N s/m", "damping of each pad", ">= 0", 0.004, becomes="delta")
c_t = page.parameter("c_t", "N m s", "damping of the bearing", ">= 0", 0.004, becomes="zeta")

a = page.coordinate("a", "rad", "tilt that lifts the disc at the pads")
b = page.coordinate("b", "rad", "tilt about the axis to the pads")
rate_a, rate_b = page.rate(a), page.rate(b)

page.kinetic(Theta * (rate_a**2 + rate_b**2) / 2 + Phi * Omega * b * rate_a)
page.spring(k_t, along=a)
page.spring(k_t, along=b)
push = k * r * a
page.potential(push**2 / (2 * k) + N_0**2 / (2 * k) * log(1 + (push / N_0) ** 2))
page.force(mu0 * h * push / 2 * (1 + 1 / (1 + (push / N_0) ** 2)), along=b)
page.damper(c_t + 2 * d * r**2 + mu0 * N_0 * h**2 / (2 * r * Omega), along=a)
page.damper(c_t, along=b)
