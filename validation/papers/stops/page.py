"""A shaken mass between two elastic stops."""

from spragsym.derive.model import Page, cos

page = Page("A mass on a spring between two elastic stops, under a harmonic force.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "spring")
Delta = page.unit("Delta", "m", "clearance")
k_s = page.parameter("k_s", "N/m", "stop", "> 0", 20.0, becomes="kappa")
c = page.parameter("c", "N s/m", "damper", ">= 0", 0.05, becomes="zeta")
F_0 = page.parameter("F_0", "N", "force", ">= 0", 0.8, becomes="f")
omega = page.parameter("omega", "1/s", "frequency", "> 0", 0.9)
psi = page.clock(omega)
x = page.coordinate("x", "m", "displacement")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(c, along=x)
page.force(F_0 * cos(psi), along=x)
page.contact(Delta - x, lambda depth: k_s * depth, name="right")
page.contact(Delta + x, lambda depth: k_s * depth, name="left")
