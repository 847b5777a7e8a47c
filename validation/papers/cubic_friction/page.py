"""A mass on a belt, held by a spring and a damper, with friction that is cubic in its speed."""

from spragsym.derive.model import Page, sgn

page = Page("A mass on a belt with a friction law that is cubic in the sliding speed.")
m = page.unit("M", "kg", "mass")
k = page.unit("K", "N/m", "spring")
g = page.unit("g", "m/s^2", "gravity")
C = page.parameter("C", "N s/m", "damper", ">= 0", 0.05, becomes="c")
mu_s = page.parameter("mu_s", "1", "static", ">= 0", 0.4)
mu_m = page.parameter("mu_m", "1", "least", ">= 0", 0.25)
v_m = page.parameter("v_m", "m/s", "speed of the least", "> 0", 0.5)
V_b = page.parameter("V_b", "m/s", "belt", "> 0", 0.2)
x = page.coordinate("X", "m", "displacement")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.damper(C, along=x)
page.normal_force(m * g)
page.friction(
    x,
    V_b,
    slip=lambda v: mu_s * sgn(v) - 3 * (mu_s - mu_m) / 2 * (v / v_m - (v / v_m) ** 3 / 3),
    holds=mu_s,
)
