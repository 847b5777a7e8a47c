r"""Two blocks on one belt, tied to the ground and to each other: dry friction that falls with the
sliding speed.

::

            k     +-----+   k_12   +-----+    k_2
    |----/\/\/\---|  m  |--/\/\/\--| m_2 |--/\/\/\---|
                  +-----+          +-----+
                    x_1              x_2
     ==========================================>  V
                        belt

The belt carries both blocks, which are pressed on it by N_1 and N_2, until the springs pull one of
them, or both, by more than μ_s times that. The friction of a block that slides at the speed v is
μ_s/(1 + γ v) times its normal force; with γ = 0 it is that of Coulomb. Lengths are measured in
N_1/k, time in √(m/k). Where masses, springs to the ground and normal forces are equal, blocks that
are started alike move as one. From rest the motion comes to a cycle at V = 0.2, and is chaotic at
V = 0.1.

Modelled after the two blocks of U. Galvanetto and S. R. Bishop, Dynamics of a simple damped
oscillator undergoing stick-slip vibrations, Meccanica 34 (1999); the paper was not at hand, and the
base values are of our own choice.
"""

from ..model import Abs, Page, sgn

page = Page("Two blocks with dry friction on one belt, tied to the ground and to each other.")

m = page.unit("m", "kg", "mass of the first block")
k = page.unit("k", "N/m", "stiffness of the spring of the first block to the ground")
N_1 = page.unit("N_1", "N", "normal force of the first block")

mu_s = page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 1.0)
gamma = page.parameter("gamma", "s/m", "decay of friction with the sliding speed", ">= 0", 3.0)
m_2 = page.parameter("m_2", "kg", "mass of the second block", "> 0", 1.0, becomes="nu")
k_2 = page.parameter(
    "k_2",
    "N/m",
    "stiffness of the spring of the second block to the ground",
    ">= 0",
    1.0,
    becomes="beta",
)
k_12 = page.parameter(
    "k_12", "N/m", "stiffness of the spring between the blocks", ">= 0", 1.2, becomes="sigma"
)
N_2 = page.parameter("N_2", "N", "normal force of the second block", "> 0", 1.3, becomes="kappa")
V = page.parameter("V", "m/s", "belt speed", ">= 0", 0.2)

x_1 = page.coordinate("x_1", "m", "displacement of the first block along the belt")
x_2 = page.coordinate("x_2", "m", "displacement of the second block along the belt")

page.kinetic((m * page.rate(x_1) ** 2 + m_2 * page.rate(x_2) ** 2) / 2)
page.spring(k, along=x_1)
page.spring(k_2, along=x_2)
page.spring(k_12, along=x_2 - x_1)
first = page.normal_force(N_1, name="first")
second = page.normal_force(N_2, name="second")
for block, x in ((first, x_1), (second, x_2)):
    page.friction(x, V, slip=lambda v: mu_s / (1 + gamma * Abs(v)) * sgn(v), holds=mu_s, on=block)
