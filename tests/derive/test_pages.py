"""Pages: what is refused and in which words, what a folder holds, and that the article's page is
the article's model.
"""

import re
from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("sympy")

import sympy as sp
from sympy.physics.mechanics import LagrangesMethod, Point, ReferenceFrame, dynamicsymbols

import spragsym as ss
from spragsym.derive import pages, reserved
from spragsym.derive.kang_nam import mechanics, page_equivalence
from spragsym.derive.kang_nam import nomenclature as nm
from spragsym.derive.model import PageError
from spragsym.derive.statements import objects
from tests.conftest import Run
from tests.oracles.user_pages import derived, replaced

TESTS = Path(__file__).resolve().parent.parent
ARTICLE = (pages.SHIPPED / "kang_nam.py").read_text(encoding="utf-8")


def changed(tmp_path: Path, *changes: tuple[str, str]) -> Path:
    """The article's page with pieces of text replaced, as a user's file."""
    text = ARTICLE.replace(
        "from ..model import", "import sympy as sp; from spragsym.derive.model import"
    )
    path = tmp_path / "mine.py"
    path.write_text(replaced(text, *changes), encoding="utf-8")
    return path


def line_of(path: Path, piece: str) -> int:
    lines = path.read_text(encoding="utf-8").splitlines()
    (number,) = [number for number, line in enumerate(lines, 1) if piece in line]
    return number


LAW = "lambda depth: k_c * depth"
FRICTION = "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v), at_rest=mu0"
REFUSED = {
    "a law of a coordinate": (
        LAW,
        "lambda depth: k_c * depth * (1 + x / L_0)",
        "page.contact(",
        "depends on x; it is a",
    ),
    "a stiffness that moves": (
        "page.spring(k_y, along=y)",
        "page.spring(k_y * y / L_0, along=y)",
        "k_y * y",
        "depends on y",
    ),
    "one name for two": (
        'becomes="beta"',
        'becomes="alpha"',
        "k_y = page.parameter(",
        "k_x and k_y both become alpha",
    ),
    "a damper that may drive": (
        "page.contact(",
        'c = page.parameter("c", "N s/m", "damping", "real", 0.1)\npage.damper(c, '
        "along=y)\npage.contact(",
        "page.damper(",
        "c, is negative at c = -[0-9.]+, where it drives",
    ),
    "a contact that pulls": (LAW, "lambda depth: -k_c * depth", "page.contact(", "pulls"),
    "a contact that jumps": (
        LAW,
        "lambda depth: k_c * depth + F_L",
        "page.contact(",
        "just touches",
    ),
    "units of a law": (LAW, "lambda depth: k_c * depth**2", "page.contact(", "kg m^2 s^-2"),
    "no inertia": (
        "page.kinetic(m * (page.rate(x) ** 2 + page.rate(y) ** 2) / 2)",
        "page.kinetic(m * page.rate(x) ** 2 / 2)",
        'page.coordinate("y"',
        "no inertia",
    ),
    "no domain": (
        '"steepness of the friction law in creep", "> 0"',
        '"steepness of the friction law in creep", "positive"',
        "positive",
        "is not a domain",
    ),
    "a base value outside": (
        '">= 0", 0.5, latex',
        '">= 0", -0.5, latex',
        "-0.5",
        "not in its domain",
    ),
    "nothing uses it": (
        "V = page.p",
        'q = page.parameter("q", "m", "idle")\nV = page.p',
        '"idle"',
        "in no statement",
    ),
    "a damper that drives": (
        "page.spring(k_y, along=y)",
        "page.damper(-k_c / d / V, along=y)",
        "page.damper(",
        "is negative",
    ),
    "one named as a speed": (
        'becomes="beta"',
        'becomes="vx"',
        "k_y = page.parameter(",
        "the rate of x",
    ),
    "a word of Python": (
        'becomes="beta"',
        'becomes="lambda"',
        "k_y = page.parameter(",
        "no name in Python",
    ),
    "a point of space": (
        "page.spring(k_y, along=y)",
        "page.spring(k_y, (x, y, 0), (0, 0, 0))",
        "(0, 0, 0)",
        "point of the",
    ),
    "along what stands still": (
        "page.spring(k_y, along=y)",
        "page.spring(k_y, along=L_0)",
        "along=L_0",
        "no coordinate moves",
    ),
    "a gap that never closes": (
        "page.contact(y,",
        "page.contact(L_0,",
        "page.contact(",
        "holds no coordinate",
    ),
    "an energy of speed": (
        "page.spring(k_y, along=y)",
        "page.potential(m * page.rate(x) ** 2)",
        "potential(",
        "holds a speed",
    ),
    "a name of generated code": (
        'becomes="beta"',
        'becomes="_one"',
        "k_y = page.parameter(",
        "begins with a letter",
    ),
    "a function as coefficient": (
        "page.spring(k_y, along=y)",
        "page.damper(lambda v: k_c / V, along=y)",
        "page.damper(",
        "here is a function; give an expression",
    ),
    "a name of two words": (
        '"k_y", "N/m"',
        '"k y", "N/m"',
        "k_y = page.parameter(",
        "no name; give .* 'k_y'",
    ),
    "a meaning of two lines": (
        '"preload',
        '"pre\\nload',
        "F_L = page",
        r"U\+000A, which is not printed",
    ),
    "a Greek name": (
        'becomes="beta"',
        'becomes="β"',
        "k_y = page.parameter(",
        "which C can't spell",
    ),
    "another name of an angle": (
        '"(0, pi)", latex',
        '"(0, pi)", becomes="q", latex',
        "theta0 = page.parameter(",
        "has no unit to be rid of",
    ),
    "a base value in degrees": (
        '"(0, pi)", latex',
        '"(0, pi)", 45, latex',
        "theta0 = page.parameter(",
        "45 degrees are pi/4",
    ),
    "a kink in the contact": (
        LAW,
        "lambda depth: k_c * (depth + Abs(depth - L_0))",
        "page.contact(",
        "not smooth",
    ),
    "a step in friction": (
        FRICTION,
        "lambda v: mu0 * (1 - exp(-d * Abs(v))) * sgn(v) * (2 + sgn(d * Abs(v) - 3))",
        "page.friction(",
        "not smooth",
    ),
    "an error function in the energy": (
        LAW,
        "lambda depth: k_c * L_0 * (1 - exp(-(depth**2) / L_0**2))",
        "page.contact(",
        "has no energy",
    ),
    "a complex law": (
        LAW,
        "lambda depth: k_c * depth * (-1) ** 0.5",
        "page.contact(",
        "no real number",
    ),
    "a force that pulls": (
        "page.contact(y, lambda depth: k_c * depth)",
        "page.normal_force(-F_L)",
        "normal_force",
        "pulls",
    ),
    "a force in N/m": (
        "page.contact(y, lambda depth: k_c * depth)",
        "page.normal_force(k_c)",
        "normal_force",
        "normal force",
    ),
    "a belt backwards": (
        "page.friction(x, V",
        "page.friction(x, -V",
        "page.friction(",
        "may be negative",
    ),
    "a unit too many": (
        "theta0 = page.p",
        'q = page.unit("q", "N", "a force")\ntheta0 = page.p',
        '"a force"',
        "can't become 1 too",
    ),
    "an argument of other libraries": (
        LAW,
        f"{LAW}, restitution=0.5",
        "page.contact(",
        "page.contact: got an unexpected keyword argument 'restitution'; it takes gap, law",
    ),
    "an argument of a page": (
        "page = Page(",
        "page = Page(restitution=0.5, summary=",
        "page = Page(",
        "Page: got an unexpected keyword argument 'restitution'; it takes summary",
    ),
    "neither true nor false": (
        LAW,
        f'{LAW}, unilateral="no"',
        "page.contact(",
        "unilateral = 'no' is neither True nor False",
    ),
    "a truth for an expression": (
        "page.kinetic(m",
        "page.potential(x > y)\npage.kinetic(m",
        "page.potential(",
        "here is .*give an expression, or a number",
    ),
    "an exit": ("page.spring(k_y, along=y)", "raise SystemExit(3)", "SystemExit(3)", "SystemExit"),
}
REFUSED |= {
    "a function without intervals": (
        "exp(-d * Abs(v))",
        "sp.erfc(d * Abs(v))",
        "page.friction(",
        "generated code does not know",
    ),
    "a root without slope": (
        FRICTION,
        "lambda v: mu0 * sp.sqrt(d * Abs(v)) * sgn(v)",
        "page.friction(",
        "not seen to be positive",
    ),
    "a symbol for an exponent": (
        LAW,
        "lambda depth: k_c * L_0 * (depth / L_0) ** mu0",
        "page.contact(",
        "a fraction of two integers",
    ),
}


def test_a_decimal_is_the_fraction_that_is_written(tmp_path: Path) -> None:
    path = changed(tmp_path, (LAW, "lambda depth: 0.1 * k_c * L_0 * (depth / L_0) ** 1.5"))
    law = pages.read(path).mechanics.contacts[0].law
    (depth,) = law.free_symbols
    assert law == depth ** sp.Rational(3, 2) / 10


@pytest.mark.parametrize("case", REFUSED)
def test_a_page_that_makes_no_sense_is_refused_by_its_line(case: str, tmp_path: Path) -> None:
    before, after, place, words = REFUSED[case]
    path = changed(tmp_path, (before, after))
    with pytest.raises(
        PageError, match=rf"^mine\.py, line {line_of(path, place)}: .*{words.replace('^', '.')}"
    ):
        pages.read(path)


def test_a_page_that_is_no_text_in_utf_8(tmp_path: Path) -> None:
    path = tmp_path / "mine.py"
    path.write_bytes(ARTICLE.encode("utf-16"))
    with pytest.raises(PageError, match=r"mine\.py: the file is no text in UTF-8"):
        pages.read(path)


def test_names_of_the_package_are_free_for_pages() -> None:
    """Items are the page's, attributes the package's, and what both have is told apart by an
    underscore.
    """
    assert len(reserved.OF_CODE | reserved.OF_FILES) <= 12
    text = (TESTS / "oracles/pages/named.py").read_text(encoding="utf-8")
    model = ss.load(derived(text, "named"))
    p = model.Parameters(omega=[0.3, 0.5])
    assert p.shape == (2,)
    assert p["shape"] == 0.5
    eq = ss.equilibria(p)
    assert {"mean", "when", "omega", "error", "error_"} <= set(eq.columns)
    assert eq["mean"].shape == eq.error.shape == eq["error_"].shape
    assert eq["error"] == 0.5
    assert eq.error is eq["error_"]
    assert eq.columns["mean"].dimension == "m"
    assert eq.columns["error_"].meaning.startswith("bound")
    frame = eq.data()
    assert next(iter(frame)) == "omega"
    assert np.all(frame["error_"] < 1e-9)
    motion = ss.simulate(model.Parameters(), t_end=5.0)
    assert np.array_equal(motion["mean"], motion.state[0])
    assert motion.mean(0.0) == pytest.approx(np.sum(motion.weights * motion["mean"]) / 5.0)


def test_directions_lengths_and_forces_of_a_page_are_told_from_those_of_its_springs(
    run: Run,
) -> None:
    """The page of the tests with an inclined spring, whose quantities have the names of columns."""
    text = (TESTS / "oracles/pages/named.py").read_text(encoding="utf-8")
    for ours, theirs in {"rate": "contact_force", "count": "spring_force", "error": "L"}.items():
        text = re.sub(rf"(?<!page\.)\b{ours}\b", theirs, text)
    text = text.replace("import Page, tanh", "import Page, cos, sin, tanh") + (
        'theta = page.parameter("theta", "rad", "inclination", "(0, pi)", 1.2)\n'
        "anchor = (L_0 * cos(theta), L_0 * sin(theta))\n"
        "page.spring(spring_force, (mean, when), anchor, length=L_0)\n"
    )
    folder = derived(text, "named_springs")
    p = ss.load(folder).Parameters()
    eq = ss.equilibria(p)
    mean, when = eq["mean"], eq["when"]
    dx, dy = np.cos(1.2) - mean, np.sin(1.2) - when
    np.testing.assert_allclose(eq["L_"], np.hypot(dx, dy), rtol=1e-12)
    np.testing.assert_allclose(eq["theta_"], np.arctan2(dy, dx), rtol=1e-12)
    np.testing.assert_allclose(eq["spring_force_"], 0.5 * (np.hypot(dx, dy) - 1), atol=1e-12)
    np.testing.assert_allclose(eq["contact_force_"], -(when + mean / 8), rtol=1e-12)
    given = {name: eq[name] for name in ("L", "theta", "spring_force", "contact_force")}
    assert given == {"L": 0.5, "theta": 1.2, "spring_force": 0.5, "contact_force": 1.0}
    assert re.search(r" theta__deg +L_ +mean ", str(eq))
    folds = ss.folds(p, "L")
    assert folds.decided
    assert "theta_" in folds.columns
    # A table that is too wide leaves out the length of the spring, and not what varies.
    table = run("equilibria", "--model", folder.as_posix(), "--vary", "L=0.4:0.6:2")
    assert re.findall(r"^(\S+) ", table, re.MULTILINE) == ["L", "0.4", "0.6"]
    assert " L_ " not in table


@pytest.mark.thorough
def test_tables_tell_a_quantity_from_a_column_of_its_name(run: Run) -> None:
    """A quantity that is called error is no bound, which is shown with two digits, rounded up."""
    text = (TESTS / "oracles/pages/named.py").read_text(encoding="utf-8").replace("count", "kind")
    folder = derived(text, "named_kind")
    path = ss.quasi_static_path(ss.load(folder).Parameters(), "error", [0.1, 0.2, 0.3])
    model = ("--model", folder.as_posix())
    for table in (str(path), run("path", *model, "--vary", "error=0.1:0.3:3")):
        assert re.findall(r"^(0\.\d+) ", table, re.MULTILINE) == ["0.1", "0.2", "0.3"]
    # Lift leaves the contact where it is the weight, 1.
    lifted = run("critical", *model, "--vary", "error=0:2").splitlines()[1]
    assert lifted.split()[-1] == "1"
    assert "first jump" in run("critical", *model, "--vary", "kind=0.5:1")


# ------------------------------------------------------------------------------------------------
# the article's page


@pytest.mark.thorough
def test_the_general_way_gives_the_article() -> None:
    assert all(page_equivalence.identities().values())


@pytest.mark.thorough
def test_a_page_that_differs_is_noticed(monkeypatch: pytest.MonkeyPatch) -> None:
    """The comparison can fail: what the pages add is not added for nothing."""
    monkeypatch.setattr(
        page_equivalence, "ADDED", {"cubic_contact": (), "damped": ("zeta_x", "zeta_y")}
    )
    held = page_equivalence.identities()
    assert [*held.values()].count(False) == 2
    assert len(held) == 4


def test_the_articles_page_gives_lagranges_equations() -> None:
    """(1) and (2), with all units, from energies and forces written here, by SymPy's own
    mechanics.
    """
    m, k, k_x, k_y, F_L, L_0 = (nm.SYMBOLS[name] for name in ("m", "k", "k_x", "k_y", "F_L", "L_0"))
    x, y = dynamicsymbols("x y")
    frame, origin = ReferenceFrame("belt"), Point("O")
    origin.set_vel(frame, 0)
    mass = origin.locatenew("mass", x * frame.x + y * frame.y)
    mass.set_vel(frame, x.diff() * frame.x + y.diff() * frame.y)
    length = sp.sqrt((L_0 * nm.c0 - x) ** 2 + (L_0 * nm.s0 - y) ** 2)
    stored = (k_x * x**2 + k_y * y**2 + k * (length - L_0) ** 2) / 2
    pushed = [(mass, nm.mu * nm.N * frame.x + (nm.N - F_L) * frame.y)]
    method = LagrangesMethod(
        m * (x.diff() ** 2 + y.diff() ** 2) / 2 - stored, [x, y], forcelist=pushed, frame=frame
    )
    theirs = (
        method.form_lagranges_equations()
        .doit()
        .subs({x.diff().diff(): sp.Symbol("ax"), y.diff().diff(): sp.Symbol("ay")})
    )
    measured = objects.derivation_of(mechanics.page(), mechanics.of_page(), "units")
    ours = objects.derived(measured, "motion").entries
    theta0 = sp.Symbol("theta0")
    known = {x: sp.Symbol("x"), y: sp.Symbol("y"), nm.c0: sp.cos(theta0), nm.s0: sp.sin(theta0)}
    for mine, row in zip(map(measured.expanded, ours), theirs, strict=True):
        gap = row.subs(known) - mine
        plain = gap.subs({it: sp.Symbol(it.name) for it in gap.free_symbols})
        assert sp.simplify(plain) == 0
