"""A shallow truss of two bars, loaded upwards where they meet: it snaps through."""

from spragsym.derive.model import Page, sqrt

page = Page("Two bars that meet under a load and snap through.")

m = page.unit("m", "kg", "mass of the joint")
E = page.unit("E", "N/m^2", "modulus of elasticity")
x_2 = page.unit("x_2", "m", "horizontal distance of the joint from either support")

A_o = page.parameter("A_o", "m^2", "cross section of a bar", "> 0", 0.1, becomes="area")
z_2 = page.parameter("z_2", "m", "height of the joint without load", "> 0", 1.0, becomes="height")
P = page.parameter("P", "N", "load on the joint, upwards", "real", 0.1, becomes="load")

w = page.coordinate("w", "m", "displacement of the joint upwards")

length = sqrt(x_2**2 + z_2**2)
now = sqrt(x_2**2 + (z_2 + w) ** 2)

page.kinetic(m * page.rate(w) ** 2 / 2)
page.potential(2 * E * A_o * (now - length) ** 2 / (2 * length))
page.force(P, along=w)
