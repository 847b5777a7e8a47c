"""Two masses, each held by a spring and a damper, and connected by a third spring and damper."""

from spragsym.derive.model import Page

page = Page("Two masses between two walls, in a chain of springs and dampers.")

m0 = page.unit("m0", "kg", "first mass")
k0 = page.unit("k0", "N/m", "spring between the first wall and the first mass")
h = page.unit("h", "m", "a length, by which displacements are measured")

m1 = page.parameter("m1", "kg", "second mass", "> 0", 1.0)
k1 = page.parameter("k1", "N/m", "spring between the masses", "> 0", 1.0)
k2 = page.parameter("k2", "N/m", "spring between the second mass and its wall", "> 0", 1.0)
c0 = page.parameter("c0", "N s/m", "damper beside k0", ">= 0", 0.1)
c1 = page.parameter("c1", "N s/m", "damper beside k1", ">= 0", 0.1)
c2 = page.parameter("c2", "N s/m", "damper beside k2", ">= 0", 0.1)

x = page.coordinate("x", "m", "displacement of the first mass")
y = page.coordinate("y", "m", "displacement of the second mass")

page.kinetic((m0 * page.rate(x) ** 2 + m1 * page.rate(y) ** 2) / 2)
page.spring(k0, along=x)
page.spring(k1, along=y - x)
page.spring(k2, along=y)
page.damper(c0, along=x)
page.damper(c1, along=y - x)
page.damper(c2, along=y)
