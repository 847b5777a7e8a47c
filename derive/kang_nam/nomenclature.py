"""The nomenclature: every symbol of the article's model with its name in code, the article's name,
meaning, unit and domain.

Angles enter the algebra only by cosine and sine: ``c`` and ``s`` are cos θ and sin θ, ``c0`` and
``s0`` are cos θ₀ and sin θ₀, with the relations in :data:`UNIT_CIRCLES`.
"""

import sympy as sp
from sympy import Symbol

from ..emit.quantities import Quantity

#: Every entry of the nomenclature, and its symbol, by its name in code.
QUANTITIES: dict[str, Quantity] = {}
SYMBOLS: dict[str, Symbol] = {}


def _define(
    code: str, article: str, meaning: str, unit: str = "1", domain: str = "real", scale: str = ""
) -> Symbol:
    """Enter a quantity and return its symbol."""
    # SymPy needs to know positive signs only, to simplify the spring length; proofs that use other
    # signs state them.
    symbol = Symbol(code, real=True, positive=True if domain == "> 0" else None)
    return _enter(symbol, Quantity(article, meaning, unit, domain, scale))


def _scaled(
    code: str,
    article: str,
    measured: str,
    scale: str,
    remark: str = "",
    domain: str = "real",
) -> Symbol:
    """Enter a quantity over its scale; the remark is added to its meaning."""
    over = f", times {scale[3:-1]}" if scale.startswith("1/(") else f" over {scale}"
    said = f", {remark}" if remark else ""
    return _define(code, article, f"{measured}{over}{said}", "1", domain, scale)


def _local(code: str, meaning: str) -> Symbol:
    """Enter a symbol of generated code only, without assumptions."""
    symbol = Symbol(code)
    return _enter(symbol, Quantity(sp.latex(symbol), meaning))


def _enter(symbol: Symbol, entry: Quantity) -> Symbol:
    """Enter a quantity whose symbol is new."""
    name = str(symbol)
    if name in SYMBOLS:
        raise ValueError(
            f"{name} stands in the nomenclature twice; give the second quantity another name"
        )
    SYMBOLS[name], QUANTITIES[name] = symbol, entry
    return symbol


# Dimensional data.
m_mass = _define("m", "m", "mass", "kg", "> 0")
k = _define("k", "k", "stiffness of the inclined spring", "N/m", "> 0")
k_x = _define("k_x", "k_x", "stiffness to ground along the belt", "N/m", ">= 0")
k_y = _define("k_y", "k_y", "stiffness to ground across the belt", "N/m", ">= 0")
k_c = _define("k_c", "k_c", "contact stiffness", "N/m", "> 0")
F_L = _define("F_L", "F_L", "preload that presses the mass on the belt", "N", "> 0")
L_0 = _define("L_0", "L_o", "undeformed length of the inclined spring", "m", "> 0")
N = _define("N", "N", "contact force on the mass", "N", ">= 0")
V_dim = _define("V_dim", "V", "belt speed", "m/s")
d_dim = _define("d_dim", "d", "steepness of the friction law in creep", "s/m", "> 0")
t = _define("time", "t", "time", "s")

# Dimensionless parameters, in the order in which every public function takes them.
theta0 = _define("theta0", r"\theta_o", "inclination of the undeformed spring", "rad", "(0, pi)")
c0 = _define("cos0", r"\cos\theta_o", "cos θ₀", domain="[-1, 1]")
s0 = _define("sin0", r"\sin\theta_o", "sin θ₀", domain="[-1, 1]")
mu0 = _define("mu0", r"\mu_o", "friction coefficient at full slip", domain=">= 0")
kappa = _define("kappa", r"\kappa", "preload F_L / (k_c L_0)", domain="> 0")
alpha = _define("alpha", r"\alpha", "stiffness ratio k_x / k_c", domain=">= 0")
sigma = _define("sigma", r"\sigma", "stiffness ratio k / k_c", domain="> 0")
beta = _define("beta", r"\beta", "stiffness ratio k_y / k_c", domain=">= 0")
V = _scaled("V", "V", "belt speed", "L_0 sqrt(k_c/m)")
creep = _scaled(
    "d", "d", "steepness of the friction law in creep", "1/(L_0 sqrt(k_c/m))", domain="> 0"
)
nbar = _define("nbar", r"\overline{n}", "1 in contact, 0 in lift-off", domain="{0, 1}")

# State.
theta = _define("theta", r"\theta", "current inclination of the spring", "rad")
c = _define("cos", r"\cos\theta", "cos θ", domain="[-1, 1]")
s = _define("sin", r"\sin\theta", "sin θ", domain="[-1, 1]")
L = _scaled("L", "L", "spring length", "L_0", domain="> 0")
x = _scaled("x", "x", "displacement along the belt", "L_0")
y = _scaled("y", "y", "displacement across the belt", "L_0", "negative into the belt")
vx = _define("vx", "x'", "dx/dτ", scale="L_0 sqrt(k_c/m)")
vy = _define("vy", "y'", "dy/dτ", scale="L_0 sqrt(k_c/m)")
tau = _scaled("tau", r"\tau", "time", "sqrt(m/k_c)")
mu = _define("mu", r"\mu", "friction coefficient at the current sliding speed")
n = _define("n", "n", "contact force N / (k_c L_0)", domain=">= 0")
tt = _define("t", "t", "tan(θ/2)")

# Shorthands, as symbols: the elimination is read, and emitted, in them.
B = _define("B", "B", "β + n̄, the stiffness across the belt with the contact")
M = _define("M", "M", "μ₀ n̄, friction per unit of penetration")
p = _define("p", "p", "α + σ")
q = _define("q", "q", "B + σ")
b1 = _define("b1", "b_1", "first component of b")
b2 = _define("b2", "b_2", "second component of b")
b3 = _define("b3", "b_3", "first component of b in lift-off")
b4 = _define("b4", "b_4", "second component of b in lift-off")
fa = _define("a_f", "a", "coefficient of sin θ cos θ in f")
fb = _define("b_f", "b", "coefficient of cos θ in f")
fd = _define("d_f", "d", "coefficient of sin θ in f")
fm = _define("m_f", "m", "coefficient of −sin² θ in f")

# Arguments of generated functions that are no quantities of the article.
side = _local(
    "side", "sign of V − x': 1 where the belt is ahead of the mass, −1 where the mass is ahead"
)
T = _define("T", "T", "tan θ₀", domain="> 0")
C11 = _local("C11", "damping ∂F_x/∂x'")
fa_v, fb_v, fd_v, fm_v = (
    _local(f"{name}_v", f"derivative of {name} of f by the parameter that varies")
    for name in "abdm"
)
stiffness_entries = tuple(
    _local(f"K{place}", f"entry {place[0]}, {place[1]} of the stiffness matrix")
    for place in ("11", "12", "21", "22")
)

PARAMETERS = (mu0, kappa, alpha, sigma, beta)
UNIT_CIRCLES = ((c, s), (c0, s0))
