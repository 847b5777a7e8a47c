"""A bead on a hoop that turns about its vertical diameter (Strogatz, section 3.5)."""

from spragsym.derive.model import Page, cos, sin

page = Page("A bead on a rotating hoop.")
m = page.unit("m", "kg", "mass")
r = page.unit("r", "m", "radius")
g = page.unit("g", "m/s^2", "gravity")
b = page.parameter("b", "N s/m", "viscous", ">= 0", 0.3, becomes="beta")
omega = page.parameter("omega", "1/s", "speed", "> 0", 1.3)
phi = page.coordinate("phi", "rad", "angle from the bottom")
page.kinetic(m * r**2 * (page.rate(phi) ** 2 + omega**2 * sin(phi) ** 2) / 2)
page.potential(-m * g * r * cos(phi))
page.damper(b * r**2, along=phi)
