"""A rod that leans on a belt with its end: the page, and its equilibria in closed form.

The gap is an expression of two coordinates. One balance alone tells the normal force, N = f, and
with steady friction μ N the others are κ x = μ f and τ (a − t₀) = f (μ sin a − cos a).
"""

ROD = '''r"""A rod on its end."""
from spragsym.derive.model import Page, cos, sin, tanh
page = Page("A rod whose end is on a belt, its inclination held by a torsion spring.")
m = page.unit("m", "kg", "mass")
k_c = page.unit("k_c", "N/m", "stiffness of the belt")
l = page.unit("l", "m", "half length")
F = page.parameter("F", "N", "force on the centre", "> 0", 0.02, becomes="f")
mu = page.parameter("mu", "1", "friction coefficient", ">= 0", 5.0)
t0 = page.parameter("t0", "rad", "inclination at rest", "(0, pi)", 0.3)
k_t = page.parameter("k_t", "N m", "torsion spring", "> 0", 0.05, becomes="tau")
k_x = page.parameter("k_x", "N/m", "spring along the belt", "> 0", 0.1, becomes="kappa")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.3)
d = page.parameter("d", "s/m", "steepness", "> 0", 10.0)
x = page.coordinate("x", "m", "centre along the belt")
y = page.coordinate("y", "m", "centre across the belt")
a = page.coordinate("a", "rad", "inclination")
page.kinetic(m * (page.rate(x)**2 + page.rate(y)**2) / 2 + m * l**2 * page.rate(a)**2 / 6)
page.force(0, -F, at=(x, y))
page.spring(k_x, along=x)
page.potential(k_t * (a - t0)**2 / 2)
page.contact(y - l * sin(a) + l, lambda depth: k_c * depth)
page.friction(x - l * cos(a), V, lambda v: mu * tanh(d * v), at_rest=mu)
'''
