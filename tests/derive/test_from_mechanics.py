"""Pages from SymPy's mechanics: the generated code is that of the shipped page, and what no page
can say is refused by name.
"""

from pathlib import Path

import pytest

pytest.importorskip("sympy")

import sympy as sp

from spragsym.derive import folder, pages
from spragsym.derive.model import PageError
from tests.oracles.user_pages import replaced
from tests.shown import DOCS, fenced
from tests.support import few

#: The article's model by Lagrange's method, as the guide has it.
(LAGRANGE,) = fenced(DOCS / "howto_model.md", "python")
#: With speeds of its own.
KANE = """
U, W = dynamicsymbols("u w")
mass.set_vel(belt, (U + W) * belt.x + W * belt.y)
loads = [(mass, (mu * N - k_x * X{along}) * belt.x + (N - F_L - k_y * Y{across}) * belt.y)]
for stiffness, angle, rest, damping in {springs}:
    reach = origin.locatenew("anchor", rest * (cos(angle) * belt.x + sin(angle) * belt.y)).pos_from(mass)
    away = reach / reach.magnitude()
    loads.append((mass, stiffness * (reach.magnitude() - rest) * away - damping * mass.vel(belt).dot(away) * away))
method = KanesMethod(belt, [X, Y], [U, W], [X.diff() - U - W, Y.diff() - W], bodies=[Particle("P", mass, m)], forcelist=loads)
"""
METHODS = {
    "kang_nam": LAGRANGE,
    "two_springs": KANE.format(
        along="", across="", springs="((k, theta0, L_0, 0), (k_2, theta0_2, lambda_2 * L_0, 0))"
    ),
    "damped": KANE.format(
        along=" - c_x * (U + W)", across=" - c_y * W", springs="((k, theta0, L_0, c_s),)"
    ),
}


def read(folder: Path, name: str, method: str) -> pages.PageModel:
    """The shipped page with a method in the place of its coordinates and statements."""
    text = (
        (pages.SHIPPED / f"{name}.py")
        .read_text(encoding="utf-8")
        .partition("x = page.coordinate")[0]
    )
    begun, ended = LAGRANGE.partition("mass.set_vel")[0], LAGRANGE.partition("\npage_from(")[2]
    said = method if "page_from(" in method else f"{begun}{method}\npage_from({ended}"
    (folder / "mine.py").write_text(
        text.replace("..model", "spragsym.derive.model") + said, encoding="utf-8"
    )
    return pages.read(folder / "mine.py", name)


@pytest.mark.parametrize("name", few(METHODS, "kang_nam"))
def test_the_code_is_that_of_the_shipped_page(name: str, tmp_path: Path) -> None:
    ours, theirs = read(tmp_path, name, METHODS[name]), pages.read(pages.SHIPPED / f"{name}.py")
    assert folder.render(ours, "")["algebra.py"] == folder.render(theirs, "")["algebra.py"]


@pytest.mark.thorough
def test_a_damper_between_two_coordinates_resists_their_difference(tmp_path: Path) -> None:
    resisted = (
        "(mu * N - m * V / L_0 * (X - Y).diff()) * belt.x + m * V / L_0 * (X - Y).diff() * belt.y"
    )
    ours = read(tmp_path, "kang_nam", LAGRANGE.replace("mu * N * belt.x", resisted))
    text = (
        (pages.SHIPPED / "kang_nam.py")
        .read_text(encoding="utf-8")
        .replace("..model", "spragsym.derive.model")
    )
    (tmp_path / "theirs.py").write_text(
        f"{text}\npage.damper(m * V / L_0, along=x - y)\n", encoding="utf-8"
    )
    theirs = pages.read(tmp_path / "theirs.py", "kang_nam")
    assert folder.render(ours, "")["algebra.py"] == folder.render(theirs, "")["algebra.py"]


@pytest.mark.thorough
def test_a_lagrangian_with_terms_linear_in_the_rates_is_a_kinetic_energy(tmp_path: Path) -> None:
    linear = LAGRANGE.replace("- stored, [X, Y],", "+ m * V / L_0 * X * Y.diff() - stored, [X, Y],")
    ours = read(tmp_path, "kang_nam", linear)
    text = (pages.SHIPPED / "kang_nam.py").read_text(encoding="utf-8")
    turned = text.replace("page.kinetic(", "page.kinetic(m * V / L_0 * x * page.rate(y) + ")
    (tmp_path / "theirs.py").write_text(
        turned.replace("..model", "spragsym.derive.model"), encoding="utf-8"
    )
    theirs = folder.render(pages.read(tmp_path / "theirs.py", "kang_nam"), "")["algebra.py"]
    assert folder.render(ours, "")["algebra.py"] == theirs
    assert "def gyroscopic" in theirs


@pytest.mark.parametrize(
    ("before", "after", "words"),
    [
        ("- stored, [X, Y],", "- stored, [X, Y], hol_coneqs=[X - Y],", "has constraints"),
        (
            "mu * N * belt.x",
            "(mu * N + F_L * cos(dynamicsymbols._t)) * belt.x",
            "a time that is not a clock's",
        ),
        ("mu * N * belt.x", "(mu * N - m / L_0 * X.diff() ** 2) * belt.x", "nonlinear in speed"),
        (
            "mu * N * belt.x",
            "(mu * N + N * X / L_0) * belt.x",
            "along x holds N beside contact and friction",
        ),
        ("mu * N * belt.x", "(mu * N + m * V / L_0 * Y.diff()) * belt.x", "gyroscopic"),
        ("(length - L_0) ** 2)", "(length - L_0) ** 4 / L_0**2)", "is no spring of a page"),
        (
            "sp.sqrt((L_0 * cos(theta0) - X) ** 2",
            "sp.sqrt((L_0 * cos(theta0) - X) * L_0",
            "no length between two points",
        ),
        ("contact=(N, Y, lambda depth: k_c * depth),", "", "friction and no normal force"),
    ],
)
def test_what_a_page_cannot_say_is_refused_by_name(
    before: str, after: str, words: str, tmp_path: Path
) -> None:
    assert before in LAGRANGE
    with pytest.raises(PageError, match=rf"^mine\.py, line \d+: .*{words}"):
        read(tmp_path, "kang_nam", LAGRANGE.replace(before, after))


#: One coordinate with a given normal force and dry friction, from SymPy's own symbols.
STICK_SLIP = '''"""A block on a belt."""
import sympy as sp
from sympy.physics.mechanics import *
from spragsym.derive.model import Page, page_from, sgn
page = Page("A block on a belt.")
m = page.unit("m", "kg", "mass")
k = page.unit("k", "N/m", "stiffness")
W = page.unit("W", "N", "normal force")
page.parameter("mu_s", "1", "static friction coefficient", ">= 0", 0.6)
page.parameter("mu_k", "1", "kinetic friction coefficient", ">= 0", 0.4)
page.parameter("V", "m/s", "belt speed", ">= 0", 0.5)
mine = sp.symbols("m k W mu_s mu_k V")
m, k, W, mu_s, mu_k, V = mine
{stated}
'''
BY_METHOD = """
X, N, mu = dynamicsymbols("x"), *sp.symbols("N mu")
frame, origin = ReferenceFrame("frame"), Point("O")
origin.set_vel(frame, 0)
mass = origin.locatenew("mass", X * frame.x)
mass.set_vel(frame, X.diff() * frame.x)
loads = [(mass, mu * N * frame.x)]
method = LagrangesMethod((m * X.diff()**2 - k * X**2) / 2, [X], forcelist=loads, frame=frame)
page_from(
    method,
    page,
    {X: ("m", "displacement along the belt")},
    contact={"normal": N, "force": W},
    friction={
        "coefficient": mu, "along": X, "belt": V, "slip": lambda v: mu_k * sgn(v), "holds": mu_s
    },
)
"""
BY_SYSTEM = """
X, U, N, mu = *dynamicsymbols("x u"), *sp.symbols("N mu")
frame, origin = ReferenceFrame("frame"), Point("O")
origin.set_vel(frame, 0)
system = System(frame, origin)
body = Particle("P", origin.locatenew("mass", X * frame.x), m)
body.masscenter.set_vel(frame, U * frame.x)
system.add_bodies(body)
system.q_ind, system.u_ind, system.kdes = [X], [U], [X.diff() - U]
system.add_loads(Force(body.masscenter, mu * N * frame.x))
system.add_actuators(LinearSpring(k, LinearPathway(origin, body.masscenter)))
system.form_eoms()
page_from(system,""" + BY_METHOD.partition("page_from(\n    method,")[2]
BY_HAND = """
m, k, W, mu_s, mu_k, V = (one.symbol for one in (*page.units, *page.parameters))
x = page.coordinate("x", "m", "displacement along the belt")
page.kinetic(m * page.rate(x) ** 2 / 2)
page.spring(k, along=x)
page.normal_force(W)
page.friction(x, V, slip=lambda v: mu_k * sgn(v), holds=mu_s)
"""

#: A load with its law, its friction as it is said then, and the same by hand.
LOAD = "system.add_loads(Force(body.masscenter, mu * N * frame.x))"
KINETIC = "system.add_actuators(CoulombKineticFriction(mu_k, N, LinearPathway(origin, {})))"
STRIBECK = "body.masscenter), v_s=W / sp.sqrt(k * m), mu_s=mu_s, sigma=sp.sqrt(k * m)"
STRIBECK_BY_HAND = (
    ("import Page", "import Page, exp, sqrt"),
    ("page.normal_force", "page.damper(sqrt(k * m), along=x)\npage.normal_force"),
    ("mu_k * sgn(v)", "(mu_k + (mu_s - mu_k) * exp(-k * m * v**2 / W**2)) * sgn(v)"),
)
OF_LOADS = {
    "a belt": (
        BY_METHOD,
        ("mu * N", "mu_k * N * sp.sign(V - X.diff())"),
        'friction={"holds": mu_s})',
        (),
    ),
    "Stribeck": (
        BY_SYSTEM,
        (LOAD, KINETIC.format(STRIBECK)[:-1]),
        'friction={"belt": V})',
        STRIBECK_BY_HAND,
    ),
}


def algebra_of(folder_: Path, stated: str) -> str:
    path = folder_ / "block.py"
    path.write_text(STICK_SLIP.format(stated=stated), encoding="utf-8")
    return folder.render(pages.read(path), "")["algebra.py"]


@pytest.mark.thorough
@pytest.mark.parametrize("stated", [BY_METHOD, BY_SYSTEM], ids=["Lagrange", "System"])
def test_dry_friction_and_a_given_normal_force_by_name(stated: str, tmp_path: Path) -> None:
    """From symbols that SymPy made itself, with the names of the page's quantities."""
    assert algebra_of(tmp_path, stated) == algebra_of(tmp_path, BY_HAND)


@pytest.mark.thorough
@pytest.mark.parametrize("case", OF_LOADS)
def test_the_friction_of_loads_is_read(case: str, tmp_path: Path) -> None:
    """CoulombKineticFriction along a pathway of length |x|, and a sign of a load's own."""
    stated, change, friction, by_hand = OF_LOADS[case]
    ours = replaced(stated.partition("friction={")[0] + friction, change)
    theirs = replaced(STICK_SLIP.format(stated=BY_HAND), *by_hand)
    (tmp_path / "theirs.py").write_text(theirs, encoding="utf-8")
    expected = folder.render(pages.read(tmp_path / "theirs.py", "block"), "")["algebra.py"]
    assert algebra_of(tmp_path, ours) == expected


@pytest.mark.parametrize(
    ("stated", "before", "after", "place", "words"),
    [
        (BY_METHOD, ", frame=frame", "", "page_from(", "without the frame"),
        (BY_METHOD, '"force": W', '"pull": W', "page_from(", "pull is unknown or missing"),
        (
            BY_METHOD,
            "mu * N",
            "sp.cos(dynamicsymbols._t) * N",
            "page_from(",
            "a time that is not a clock's",
        ),
        (BY_METHOD, "mu * N", "-mu_k * W * sp.sign(X.diff())", "page_from(", "CoulombKinetic"),
        (BY_SYSTEM, "system.form_eoms()", "", "page_from(", "call its form_eoms"),
        (
            BY_SYSTEM,
            "LinearSpring(k, ",
            "CoulombKineticFriction(mu_k, W, ",
            "page_from(",
            "CoulombKineticFriction, all friction is read; let their normal force be a symbol N",
        ),
    ],
)
def test_a_method_is_refused_by_the_line_of_the_file_of_the_user(
    stated: str, before: str, after: str, place: str, words: str, tmp_path: Path
) -> None:
    text = STICK_SLIP.format(stated=stated.replace(before, after))
    lines = text.splitlines()
    first = next(number for number, line in enumerate(lines, 1) if line.startswith(place))
    (tmp_path / "block.py").write_text(text, encoding="utf-8")
    with pytest.raises(PageError, match=words) as refused:
        pages.read(tmp_path / "block.py")
    line = int(str(refused.value).partition("line ")[2].partition(":")[0])
    assert first <= line <= len(lines)


#: A particle on springs in a frame that turns, by Kane's method, its velocity in either frame.
TURNING = """'A mass on springs in a frame that turns.'
from spragsym.derive.model import Page, page_from
import sympy as sp
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols

page = Page("A mass on springs in a frame that turns.")
m, k, L = (page.unit(name, unit, "scale") for name, unit in (("m", "kg"), ("k", "N/m"), ("L", "m")))
W = page.parameter("W", "1/s", "speed of the frame", ">= 0", 0.1)
x, y, u, v = dynamicsymbols("x y u v")
t, ground, frame, O = dynamicsymbols._t, ReferenceFrame("N"), ReferenceFrame("A"), Point("O")
O.set_vel(ground, 0)
frame.orient_axis(ground, ground.z, W * t)
P = O.locatenew("P", x * frame.x + y * frame.y)
P.set_vel(frame, u * frame.x + v * frame.y)
P.v1pt_theory(O, ground, frame)
if {0}:
    P.set_vel(ground, P.vel(ground).express(ground))
method = KanesMethod(ground, [x, y], [u, v], kd_eqs=[x.diff() - u, y.diff() - v])
force = -k * x * frame.x - k * y * frame.y
method.kanes_equations([Particle("B", P, m)], [(P, {1})])
page_from(method, page, dict.fromkeys((x, y), ("m", "displacement")))
"""


@pytest.mark.parametrize("expressed", [False, True])
def test_a_turning_frame_is_read_as_one(expressed: bool, tmp_path: Path) -> None:
    """Time cancels in its energies and forces; Coriolis and centrifugal forces are left."""
    path = tmp_path / "turning.py"
    path.write_text(TURNING.format(expressed, "force"), encoding="utf-8")
    it = pages.read(path).mechanics
    (Omega,), (x, y) = it.arguments, it.coordinates
    assert it.gyroscopic == sp.Matrix([[0, -2 * Omega], [2 * Omega, 0]])
    assert [*it.residuals] == [place * (1 - Omega**2) for place in (x, y)]


def test_a_force_that_keeps_its_direction_while_the_frame_turns_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "turning.py"
    path.write_text(TURNING.format(False, "m * ground.x"), encoding="utf-8")
    with pytest.raises(PageError, match=r"cos\(W\*t\).* varies in time by itself"):
        pages.read(path)
