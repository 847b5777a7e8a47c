"""Two twin modes of a disc, and a load with a spring that turns on it."""

from spragsym.derive.model import Page, cos, sin

page = Page("Two twin modes of a disc and a mass that turns on it.")
M = page.unit("M", "kg", "modal mass")
omega_n = page.unit("omega_n", "1/s", "frequency")
w_0 = page.unit("w_0", "m", "displacement")
k = page.parameter("k", "N/m", "slider spring", ">= 0", 0.1, becomes="kappa")
xi = page.parameter("xi", "1", "modal damping", ">= 0", 0.01)
P = page.parameter("P", "N", "load", ">= 0", 0.1, becomes="p")
Omega = page.parameter("Omega", "1/s", "speed", "> 0", 0.5)
q_1 = page.coordinate("q_1", "m", "cosine mode")
q_2 = page.coordinate("q_2", "m", "sine mode")
ph = page.clock(Omega)
page.kinetic(M * (page.rate(q_1) ** 2 + page.rate(q_2) ** 2) / 2)
page.potential(M * omega_n**2 * (q_1**2 + q_2**2) / 2)
page.damper(2 * xi * omega_n * M, along=q_1)
page.damper(2 * xi * omega_n * M, along=q_2)
page.potential(k * (q_1 * cos(2 * ph) + q_2 * sin(2 * ph)) ** 2 / 2)
page.force(P * cos(2 * ph), along=q_1)
page.force(P * sin(2 * ph), along=q_2)
