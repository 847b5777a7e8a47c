"""A pad and a disc, each on a spring and a damper, with falling friction between them."""

from spragsym.derive.model import Page, exp, sgn

page = Page("A pad and a disc.")
m_p = page.unit("m_p", "kg", "pad")
k_p = page.unit("k_p", "N/m", "pad spring")
N_0 = page.unit("N_0", "N", "load")
m_d = page.parameter("m_d", "kg", "disc", "> 0", 2.0, becomes="nu")
k_d = page.parameter("k_d", "N/m", "disc spring", "> 0", 2.0, becomes="kappa_d")
c_p = page.parameter("c_p", "N s/m", "pad damper", ">= 0", 0.1, becomes="zeta_p")
c_d = page.parameter("c_d", "N s/m", "disc damper", ">= 0", 0.1, becomes="zeta_d")
mu_s = page.parameter("mu_s", "1", "static", ">= 0", 0.6)
a = page.parameter("a", "s/m", "fall", ">= 0", 0.01)
v_0 = page.parameter("v_0", "m/s", "disc speed", "> 0", 0.5)
x_p = page.coordinate("x_p", "m", "pad")
x_d = page.coordinate("x_d", "m", "disc")
page.kinetic(m_p * page.rate(x_p) ** 2 / 2 + m_d * page.rate(x_d) ** 2 / 2)
page.spring(k_p, along=x_p)
page.spring(k_d, along=x_d)
page.damper(c_p, along=x_p)
page.damper(c_d, along=x_d)
page.normal_force(N_0)
page.friction(x_p - x_d, v_0, slip=lambda v: mu_s * exp(-a * abs(v)) * sgn(v), holds=mu_s)
