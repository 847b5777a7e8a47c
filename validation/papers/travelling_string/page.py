"""A string that travels between two eyes, by its two lowest modes.

R. D. Swope and W. F. Ames, Vibrations of a moving threadline, Journal of the Franklin Institute
275 (1963) 36-55; the modes by Galerkin's method.
"""

from spragsym.derive.model import Page, pi

page = Page("A string that travels between two eyes, by its two lowest modes.")

rho = page.unit("rho", "kg/m", "mass over length")
T = page.unit("T", "N", "tension")
L = page.unit("L", "m", "distance of the eyes")

v = page.parameter("v", "m/s", "speed of the string", ">= 0", 0.5)

q_1 = page.coordinate("q_1", "m", "amplitude of half a wave")
q_2 = page.coordinate("q_2", "m", "amplitude of a whole wave")

at_rest = page.rate(q_1) ** 2 + page.rate(q_2) ** 2
turning = q_1 * page.rate(q_2) - q_2 * page.rate(q_1)
slopes = pi**2 * (q_1**2 + 4 * q_2**2) / (4 * L)
page.kinetic(rho * L * at_rest / 4 + 4 * rho * v * turning / 3 + rho * v**2 * slopes)
page.potential(T * slopes)
