"""A mass in the corner of two bands that slide past it, pressed on both: a drum brake's shoe.

J. Hultén, Brake squeal - a self-exciting mechanism with constant friction, SAE Truck and Bus
Meeting, Detroit 1993, paper 932965.
"""

from spragsym.derive.model import Page, tanh

page = Page("A mass in the corner of two bands that slide past it, pressed on both.")

m = page.unit("m", "kg", "mass")
k_1 = page.unit("k_1", "N/m", "stiffness of the first band")
L = page.unit("L", "m", "length")

mu0 = page.parameter("mu0", "1", "friction coefficient", ">= 0", 0.2)
k_2 = page.parameter("k_2", "N/m", "stiffness of the second band", "> 0", 1.5, becomes="kappa")
F_1 = page.parameter("F_1", "N", "load on the first band", "> 0", 0.1, becomes="f_1")
F_2 = page.parameter("F_2", "N", "load on the second band", "> 0", 0.1, becomes="f_2")
V = page.parameter("V", "m/s", "speed of the bands", "> 0", 1.0)

x = page.coordinate("x", "m", "displacement across the first band")
y = page.coordinate("y", "m", "displacement across the second band")


def law(v):
    return mu0 * tanh(20 * v / V)


page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)
page.force(-F_1, along=x)
page.force(-F_2, along=y)
first = page.contact(x, lambda depth: k_1 * depth, name="first")
second = page.contact(y, lambda depth: k_2 * depth, name="second")
page.friction(-y, V, law, at_rest=mu0, on=first)
page.friction(x, V, law, at_rest=mu0, on=second)
