"""A table and a bit on a drill string, in the frame of the drive, with friction at the bit."""

from spragsym.derive.model import Abs, Page, exp, sgn

page = Page("Two inertias on a drill string, the bit rubs at a radius.")
J_b = page.unit("J_b", "kg m^2", "inertia of the bit")
k_t = page.unit("k_t", "N m", "torsional stiffness of the string")
R_b = page.unit("R_b", "m", "radius of the bit")
J_r = page.parameter("J_r", "kg m^2", "inertia of the table", "> 0", 5.0, becomes="iota")
c_t = page.parameter("c_t", "N m s", "damping of the string", ">= 0", 0.1, becomes="gamma_t")
c_r = page.parameter("c_r", "N m s", "damping of the table", ">= 0", 0.4, becomes="gamma_r")
c_b = page.parameter("c_b", "N m s", "damping of the bit", ">= 0", 0.1, becomes="gamma_b")
W = page.parameter("W", "N", "weight on bit", "> 0", 1.0, becomes="w")
T_m = page.parameter("T_m", "N m", "torque of the drive", "> 0", 1.0, becomes="tau_m")
mu_cb = page.parameter("mu_cb", "1", "Coulomb", ">= 0", 0.3)
mu_sb = page.parameter("mu_sb", "1", "static", ">= 0", 0.5)
nu_f = page.parameter("nu_f", "s/m", "decay", "> 0", 2.0)
Omega = page.parameter("Omega", "1/s", "speed of the drive", "> 0", 0.8)
phi_r = page.coordinate("phi_r", "rad", "table")
phi_b = page.coordinate("phi_b", "rad", "bit")
vr, vb = page.rate(phi_r), page.rate(phi_b)
page.kinetic((J_r * vr**2 + J_b * vb**2) / 2)
page.potential(k_t * (phi_r - phi_b) ** 2 / 2)
page.damper(c_t, along=phi_r - phi_b)
page.damper(c_r, along=phi_r)
page.damper(c_b, along=phi_b)
page.force(T_m, along=phi_r)
page.normal_force(W)
page.friction(
    -R_b * phi_b,
    R_b * Omega,
    slip=lambda v: (mu_cb + (mu_sb - mu_cb) * exp(-nu_f * Abs(v))) * sgn(v),
    holds=mu_sb,
)
