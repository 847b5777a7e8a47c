"""A damped mass on a spring against a stop, under a harmonic force.

S. W. Shaw and P. J. Holmes, A periodically forced piecewise linear oscillator, Journal of Sound and
Vibration 90 (1983) 129-155.
"""

from spragsym.derive.model import Page, cos

page = Page("A damped mass on a spring against a stop, under a harmonic force.")

m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness of the spring")
P = page.unit("P", "N", "amplitude of the force")

omega = page.parameter("omega", "1/s", "frequency of the force", "> 0", 0.6)
c = page.parameter("c", "N s/m", "damping", ">= 0", 0.1)
d = page.parameter("d", "m", "play before the stop", "real", 0.5)
k_c = page.parameter("k_c", "N/m", "stiffness of the stop", "> 0", 5.0)

x = page.coordinate("x", "m", "displacement")
phase = page.clock(omega)

page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.force(P * cos(phase), along=x)
page.contact(d - x, lambda depth: k_c * depth, name="stop")
