"""Prints in LaTeX are read as they stand, or refused: against SymPy's own printer, and by hand."""

from __future__ import annotations

import random
from dataclasses import replace

import pytest
import sympy as sp

from spragsym.derive.statements import latex, tree
from spragsym.derive.statements.latex import read_latex
from spragsym.derive.statements.tree import Unread, Vocabulary, printed, to_sympy

NAMES = "m k k_0 k_1 k_c l g a V mu0 theta0 theta vtheta atheta x vx ax y vy ay mu N d"
WORDS = Vocabulary(
    frozenset(NAMES.split()),
    ("theta", "x", "y"),
    {
        r"\phi": "theta",
        r"v_r": "V - vx",
        r"\mathbf{q}": "coordinates",
        r"\mathbf{z}": "states",
        "H": "Heaviside",
        "k_1^{NL}": "k_c",
    },
    laws=frozenset({"mu", "N"}),
)
SYMBOLS = {name: sp.Symbol(name, real=True) for name in NAMES.split()}


def _read(text: str) -> list[str]:
    return [f"{printed(it.left)} = {printed(it.right)}" for it in read_latex(text, WORDS)]


READ = {
    r"m\ddot{x} + \tfrac12 k x = 0": ["m*ax + 1/2*k*x = 0"],
    r"m x'' + k x'^{2} - g": ["m*ax + k*vx**2 - g = 0"],
    r"m\frac{d^2 x}{dt^2} = -k \frac{d}{dt} x": ["m*ax = -k*vx"],
    r"\frac{\mathrm{d}^{2}\theta}{\mathrm{d}t^{2}} = dx/dt": ["atheta = vx"],
    r"\sin^2\theta + \cos^{2}{\left(\theta \right)} = 1": ["sin(theta)**2 + cos(theta)**2 = 1"],
    r"m l\cos\theta\,\ddot\theta \sin 2\phi": ["m*l*cos(theta)*atheta*sin(2*theta) = 0"],
    r"\mu_o \left\{1 - \exp(-d|V-\dot x|)\right\} sgn(v_r)": [
        "mu0*(1 - exp(-d*Abs(V - vx)))*sign(V - vx) = 0"
    ],
    r"T = \frac{1}{2} m \dot{x}^2 = k_{c}": ["T = 1/2*m*vx**2", "T = k_c"],
    r"\begin{aligned} m\ddot x &= k x \\ &\quad + k y, \\ a &= 0. \end{aligned}": [
        "m*ax = k*x + k*y",
        "a = 0",
    ],
    r"\begin{aligned} m\ddot x &= k x \\ &+ k y, \\ a &= 0. \end{aligned}": [
        "m*ax = k*x + k*y",
        "a = 0",
    ],
    r"k_1^{NL} x^2 = k_1^{\mathrm{NL}} x + (k^{NL}_1)^2": ["k_c*x**2 = k_c*x + k_c**2"],
    r"\mathbf{B} = \begin{bmatrix} \mathbf{0} & -\begin{pmatrix} a \\ g\end{pmatrix} \\ m & 0\end{bmatrix}": [
        "mathbfB_11 = 0",
        "mathbfB_12 = -a",
        "mathbfB_21 = 0",
        "mathbfB_22 = -g",
        "mathbfB_31 = m",
        "mathbfB_32 = 0",
    ],
    r"\mathbf{K} = \begin{bmatrix} k & 0 \\ -a & k_c\end{bmatrix}": [
        "mathbfK_11 = k",
        "mathbfK_12 = 0",
        "mathbfK_21 = -a",
        "mathbfK_22 = k_c",
    ],
    r"\begin{pmatrix} m & 0 \\ 0 & a\end{pmatrix} \begin{pmatrix}\ddot x\\ \ddot y\end{pmatrix}"
    r" = \begin{pmatrix} k x \\ 0\end{pmatrix}": ["m*ax + 0*ay = k*x", "0*ax + a*ay = 0"],
    r"N = \begin{cases} -k y, & if \quad y < 0\\ 0, & \text{if } y \ge 0\end{cases}": [
        "N = Piecewise(Tuple(-k*y, Lt(y, 0)), Tuple(0, Ge(y, 0)))"
    ],
    r"x(t) = \theta(t)": ["x = theta"],
    r"\mathbf{\ddot{q}} + k \mathbf{q}' = \mathbf{0}": [
        "atheta + k*vtheta = 0",
        "ax + k*vx = 0",
        "ay + k*vy = 0",
    ],
    r"a = \mathbf{q}^\mathrm{T} \operatorname{diag}(m, k, 2) \mathbf{q}": [
        "a = theta*m*theta + x*k*x + y*2*y",
    ],
    r"\begin{vmatrix} a & x \\ k & m \end{vmatrix} = \left|\begin{array}{cc} x & 0 \\ 0 & y"
    r"\end{array}\right|": ["a*m - x*k = x*y - 0*0"],
    r"\max(x, -y, 0) + \left\langle -y \right\rangle^{3/2} - (x - y)_+": [
        "max(x, -y, 0) + max(-y, 0)**(3/2) - max(x - y, 0) = 0"
    ],
    r"k H(-y) x": ["k*Heaviside(-y)*x = 0"],
    r"\sqrt[3]{x} + \sqrt{y}": ["x**(1/3) + sqrt(y) = 0"],
    r"m x_{,tt} + k_{,c} x_{,t} = \partial_t^2 y": ["m*ax + k_c*vx = ay"],
    r"\partial_{tt}(m x) y + k\partial_t x": ["m*ax*y + k*vx = 0"],
    r"m\frac{\partial^2 x}{\partial t^2} = \partial x/\partial t": ["m*ax = vx"],
    r"\mathrm{d}^2x/\mathrm{d}t^2 + k\,{\rm d}x/{\rm d}t": ["ax + k*vx = 0"],
    r"{\bf B} = \begin{Bmatrix}{\rm sgn}(x) \\ \frac{\rm d x}{\rm d t}\end{Bmatrix}": [
        "mathbfB_1 = sign(x)",
        "mathbfB_2 = vx",
    ],
    r"\boldsymbol{q} + k\bm{q} = \boldsymbol 0": [
        "theta + k*theta = 0",
        "x + k*x = 0",
        "y + k*y = 0",
    ],
    r"N = \left\{\begin{array}{ll} -k y & y < 0 \\ 0 & y \ge 0 \end{array}\right.": [
        "N = Piecewise(Tuple(-k*y, Lt(y, 0)), Tuple(0, Ge(y, 0)))"
    ],
    r"\left\{\begin{array}{rcl} m\ddot x &=& k x \\ a &=& 0 \end{array}\right.": [
        "m*ax = k*x",
        "a = 0",
    ],
    r"\begin{cases} m\ddot x = k x, \\ a = 0 \end{cases}": ["m*ax = k*x", "a = 0"],
    r"\sec\theta + \operatorname{arccosh} x + arcsin y": ["sec(theta) + acosh(x) + asin(y) = 0"],
    r"\overset{..}{x} + k\stackrel{\cdot}{x}": ["ax + k*vx = 0"],
    r"m\dv[2]{x}{t} = \dv{t}(l\theta) - \dv{y}{t}": ["m*ax = l*vtheta - vy"],
    r"a = \det\begin{bmatrix} k & \\ & m\end{bmatrix}": ["a = k*m"],
    r"\begin{pmatrix} a \\ g\end{pmatrix} = m\mathbf{I}_2\begin{pmatrix} x \\ y\end{pmatrix}": [
        "a = m*x",
        "g = m*y",
    ],
    r"x^* - y^{*} = \sin\theta(\cos\theta - a)": ["x - y = sin(theta)*(cos(theta) - a)"],
    r"k_c(-y)^{3/2}": ["k_c*(-y)**(3/2) = 0"],
    r"k_{\mathrm{fast}}^\ast = a": ["k_fast_star = a"],
    r"T = {1 \over 2} m\left(\frac{dx}{dt}\right)^2 \quad (3.1a)": ["T = 1/2*m*vx**2"],
    r"N = \begin{dcases} -\nicefrac{k}{2} y & \mbox{if } y < 0\\ 0 & \mbox{otherwise}\end{dcases}": [
        "N = Piecewise(Tuple(-k/2*y, Lt(y, 0)), Tuple(0, Eq(0, 0)))"
    ],
    r"a = \left\{\begin{array}{@{}ll@{}} k & y < 0 \\ 0 & y > 0 \end{array}\right.": [
        "a = Piecewise(Tuple(k, Lt(y, 0)), Tuple(0, Gt(y, 0)))"
    ],
    r"a\mathop{\mathrm{sgn}}(x) = \mathrm{Sgn}(y)": ["a*sign(x) = sign(y)"],
    r"\underline{q} + k\mathbf{q} = m\mathbb{I}_3\underline q": [
        "theta + k*theta = m*theta",
        "x + k*x = m*x",
        "y + k*y = m*y",
    ],
    r"N = \begin{cases} -k y & \text{if } y < 0, \\ 0 & \text{otherwise.}\end{cases}": [
        "N = Piecewise(Tuple(-k*y, Lt(y, 0)), Tuple(0, Eq(0, 0)))"
    ],
    r"k_c y_+^{3/2} = \dot x_{+}": ["k_c*max(y, 0)**(3/2) = max(vx, 0)"],
    r"\left.\begin{aligned} m\ddot x &= k x \\ a &= 0 \end{aligned}\right\}": [
        "m*ax = k*x",
        "a = 0",
    ],
    r"\left.\begin{array}{l} m\ddot x = k x \\ a = 0 \end{array}\right\}": ["m*ax = k*x", "a = 0"],
    r"\left\{\begin{array}{c} m x \\ a \end{array}\right\} = \left\{ \frac{k}{g} \right\}\begin{Bmatrix} 1 \\ g"
    r"\end{Bmatrix}": ["m*x = k/g*1", "a = k/g*g"],
    r"m\ddot x = a, \quad\text{where}\quad a = k x \text{ and } g = 0": [
        "m*ax = a",
        "a = k*x",
        "g = 0",
    ],
    r"\mathbf b = (x, -a y)^{\mathrm T}": ["mathbfb_1 = x", "mathbfb_2 = -a*y"],
    r"\mathbf{B} = \begin{bmatrix} \mathbf{0}_{1\times 2} & a\end{bmatrix}": [
        "mathbfB_11 = 0",
        "mathbfB_12 = 0",
        "mathbfB_13 = a",
    ],
    r"\mathbf{B} = \begin{bmatrix} a & x & y\\ & k & g \\ \text{sym.} & & m\end{bmatrix}": [
        f"mathbfB_{i}{j} = {it}"
        for i, row in enumerate((("a", "x", "y"), ("x", "k", "g"), ("y", "g", "m")), 1)
        for j, it in enumerate(row, 1)
    ],
    r"a \sum_{i=1}^{2} i k_{i-1} x - \sum_{j=0,c} k_j y": [
        "a*(1*k_0*x + 2*k_1*x) - (k_0*y + k_c*y) = 0"
    ],
    r"\frac{\partial}{\partial x}(m x^2 y) + \frac{\partial(k y + \sin x)}{\partial x}": [
        "m*y*(2*x) + cos(x) = 0"
    ],
    r"\begin{split} m\ddot x &- a \\ &+ k x = 0 \end{split}": ["m*ax - a + k*x = 0"],
    r"\begin{multline} m\ddot x + \\ k x = 0,\\ a = m \\ -g = 0\end{multline}": [
        "m*ax + k*x = 0",
        "a = m",
        "-g = 0",
    ],
    r"\boxed{m\ddot x - \underbrace{k x + g}_{F(x)} \overset{!}{=} 0 \text{ .}} \eqno(3)": [
        "m*ax - k*x + g = 0"
    ],
    r"m\ddot x = \overbrace{k x}^{\text{spring}}\, a \Rightarrow a \stackrel{\text{def}}{=} 0": [
        "m*ax = k*x*a",
        "a = 0",
    ],
    r"m\ddot x + f(x) = 0, \quad f(x) = k x \text{ for } x > 0": ["m*ax + f = 0", "f = k*x"],
    r"a = \det\left[\begin{array}{c|c} k & x \\ \hline y & m\end{array}\right]": ["a = k*m - x*y"],
    r"a = \det\mathbf I_2 = -k y \ge 0": ["a = 1", "a = -k*y"],
    r"a = 1{,}25\,x": ["a = 1.25*x"],
    r"\begin{aligned}[t] m\ddot x &= k x \end{aligned}": ["m*ax = k*x"],
    r"\mathbf B(\mathbf q, \dot{\mathbf q}) = \begin{bmatrix} x \\ k\end{bmatrix}": [
        "mathbfB_1 = x",
        "mathbfB_2 = k",
    ],
    r"\dot{\mathbf z} = a\mathbf z": [
        f"{one} = a*{other}"
        for one, other in zip(
            ("vtheta", "vx", "vy", "atheta", "ax", "ay"),
            ("theta", "x", "y", "vtheta", "vx", "vy"),
            strict=True,
        )
    ],
}


@pytest.mark.parametrize(("text", "expected"), READ.items())
def test_a_print_is_read(text: str, expected: list[str]) -> None:
    """Typical prints, in SymPy's syntax and in the arrangement of the print."""
    assert _read(text) == expected


@pytest.mark.parametrize(
    "text",
    [
        r"\sin\theta a",
        r"\sin\theta^2",
        r"\cos\theta/2",
        r"k(x) = 0",
        r"\mu(V - \dot x) N = 0",
        r"1/2 k x",
        r"a/k/m",
        r"|x| a |y|",
        r"x^{2}^{3}",
        r"x 2",
        r"2\frac{1}{2}",
        r"\sin^{-1} x",
        r"\log x",
        r"\frac{\partial \mu}{\partial t}",
        r"\partial_t m x",
        r"\partial_x m",
        r"\frac{d}{dt} x y",
        r"q = q x",
        r"x = 0,5",
        r"x \pm y",
        r"{x + y} a",
        r"x \le y",
        r"x \approx y",
        r"(x",
        r"x)",
        r"",
        r"\vec{x} + a",
        r"\boldsymbol{x} a = 0",
        r"a = x + ",
        r"x^23",
        r"a + \sin(x, y)",
        r"\max(x)",
        r"\max x",
        r"x_{-}^{+}_2",
        r"\left| a \begin{bmatrix} k & 0 \\ 0 & k\end{bmatrix} \right|",
        r"\det x",
        r"\ddot{} + a",
        r"\frac{}{dt} x",
        r"\begin{bmatrix}\end{bmatrix} = 0",
        r"k x^0 = a",
        r"m\mathbf{I}_{99999} + \mathbf{q} = 0",
        r"\dv[9999999999999]{x}{t} = 0",
        r"\frac{d^{9999999999999}x}{dt^{9999999999999}} = 0",
        "\\partial_t^² x",
        r"k' x = a",
        r"k^* x = a",
        r"{.} = a",
        "k x²",
        r"k(x + a)^{60}",
        r"9^{9^9}",
        r"x^{1/0}",
        r"k(-y) = 0",
        r"\dv[n]{x}{t}",
        r"\dv x t",
        r"\overset{!}{x}",
        r"\sum_i k_i x",
        r"\sum_{i=1}^n k_i x",
        r"a = \sum_{i=1}^2",
        r"\mathbf b = (1,5)^T",
        r"\mathbf{B} = \begin{bmatrix} \mathbf{0}_{1\times 3} & a\\ k & m\end{bmatrix}",
        r"\frac{\partial(m x)}{\partial m}",
        r"m\ddot x + f(y) = 0, \quad f(x) = k x",
    ],
)
def test_what_can_be_read_in_two_ways_or_not_at_all_is_refused(text: str) -> None:
    """The refusal names a place in the print."""
    with pytest.raises(Unread) as refusal:
        read_latex(text, WORDS)
    assert 0 <= refusal.value.place <= len(text)


def test_a_page_with_a_word_for_a_column_has_no_columns() -> None:
    """Of coordinates whose rates are a quantity of the page nothing is known."""
    renamed = {r"\mathbf{q}": "coordinates"}
    words = Vocabulary(frozenset({"x", "rates"}), ("x",), renamed, fixed=frozenset({"rates"}))
    with pytest.raises(Unread, match="the rate of coordinates is not read"):
        read_latex(r"\dot{\mathbf{q}} = x", words)


def test_what_is_no_argument_is_told_so() -> None:
    """Of two things in brackets a name that is no function is no function."""
    with pytest.raises(Unread, match="k is no function that is known"):
        read_latex("k(x, y) = 0", WORDS)


@pytest.mark.parametrize(
    ("text", "roots"),
    [
        (r"x = a \pm 2", "a + 2, a - 2"),
        (r"x = a \mp 2", "a + 2, a - 2"),
        (r"\lambda_{1{,}2} = a \pm 2{,}0", "a + 2, a - 2"),
        (r"0 = x - a \pm 2", "a + 2, a - 2"),
        (r"x^2 - a \pm \sqrt{a} = 0", "sqrt(a + sqrt(a)), -sqrt(a - sqrt(a))"),
        (r"x = \sqrt{a \pm \sqrt{a}}", "sqrt(a + sqrt(a)), sqrt(a - sqrt(a))"),
        (r"x = \mp a \pm 2", "2 - a, a - 2"),
        (r"x = -a \pm i\sqrt{2}", "-a + I*sqrt(2), -a - I*sqrt(2)"),
        (r"x = \frac{-a \pm \mathrm{j}\,a\sqrt{3}}{2}", "-a/2 + I*a*sqrt(3)/2"),
        (
            r"x = -\frac{a \pm \sqrt{a^2 - 1}}{2}",
            "-(a + I*sqrt(1 - a**2))/2, -(a - I*sqrt(1 - a**2))/2",
        ),
        (
            r"x^2 = a \left(1 \pm \frac{1}{2}\sqrt{a}\right)",
            "sqrt(a + a*sqrt(a)/2), -sqrt(a + a*sqrt(a)/2)",
        ),
        (
            r"x = \pm\sqrt{a \pm \sqrt{a}}",
            "sqrt(a + sqrt(a)), -sqrt(a + sqrt(a)), sqrt(a - sqrt(a))",
        ),
    ],
)
def test_two_signs_are_both_roots(text: str, roots: str) -> None:
    """Where an equation is about all roots of a polynomial, it holds of each of these."""
    words = Vocabulary(frozenset({"a", "x", "lam"}), (), {r"\lambda": "lam"}, has_roots=True)
    (both,) = read_latex(text, words)
    names = {name: sp.Symbol(name, positive=True) for name in ("a", "x")}
    names["lam"] = names["x"]
    whole = to_sympy(tree.residual(both), names)
    for root in sp.sympify(f"[{roots}]", locals=names):
        assert sp.simplify(whole.subs(names["x"], root)) == 0
    other = whole.subs({names["x"]: sp.Rational(7, 3), names["a"]: sp.Rational(1, 5)})
    assert abs(sp.N(other)) > 0.01


@pytest.mark.parametrize(
    "text", [r"x = \pm a \pm 2", r"\pm x = \mp a", r"x = \exp(\pm a)", r"x = i a", r"x = i \pm a"]
)
def test_signs_that_are_no_two_roots_are_refused(text: str) -> None:
    """Two signs that may belong together or not, one on each side, one within a function."""
    words = Vocabulary(frozenset({"a", "x"}), (), {}, has_roots=True)
    with pytest.raises(Unread, match=r"sign|i stands elsewhere"):
        read_latex(text, words)


def test_what_a_print_calls_a_function_can_be_evaluated() -> None:
    """A function that is read has a meaning: another one would end a check with an error."""
    assert {*latex.FUNCTIONS.values()} <= tree.FUNCTIONS.keys()


def test_a_law_is_named_with_any_argument_where_it_gets_its_value() -> None:
    """On the left of what gives it one; elsewhere another argument is none of it."""
    words = replace(WORDS, gives_names=True)
    (equation,) = read_latex(r"\mu(V - \dot x) = \mu_0", words)
    assert printed(equation.left) == "mu"
    for text, known in ((r"\mu(V) = \mu_0", WORDS), (r"\mu_0 = \mu(V)", words)):
        with pytest.raises(Unread, match="a product, or a function"):
            read_latex(text, known)


def test_both_readings_are_told() -> None:
    """An argument without brackets ends here, or goes on."""
    with pytest.raises(Unread) as refusal:
        read_latex(r"\sin\theta a", WORDS)
    assert refusal.value.readings == ("sin(theta)*a", "sin(theta*a)")
    with pytest.raises(Unread) as refusal:
        read_latex(r"\sin\theta(x - a)", WORDS)
    assert refusal.value.readings == ("sin(theta)*(x - a)", "sin(theta*(x - a))")


def _drawn(draw: random.Random, depth: int) -> sp.Expr:
    if depth == 0:
        atoms = [SYMBOLS[it] for it in ("m", "k_c", "theta", "x", "a", "g", "mu0")]
        return draw.choice([*atoms, sp.Integer(2), sp.Rational(3, 2), sp.Integer(-1)])
    one, other = _drawn(draw, depth - 1), _drawn(draw, depth - 1)
    kinds = [one + other, one - other, one * other, one / (other**2 + 1), one**2, sp.sin(one)]
    return draw.choice([*kinds, sp.cos(one), sp.exp(one), sp.sqrt(one**2 + 1), sp.Abs(one)])


@pytest.mark.thorough
def test_what_sympy_prints_comes_back_equal_or_is_refused() -> None:
    """300 expressions, as SymPy prints them and in variants that a hand writes."""
    draw = random.Random(78)
    variants = [
        lambda text: text,
        lambda text: text.replace(r"\left", "").replace(r"\right", ""),
        lambda text: text.replace(r"\cdot", r"\times"),
        lambda text: text.replace(r"{\left(", "(").replace(r"\right)}", ")"),
        lambda text: text.replace(" ", r"\,"),
    ]
    read = 0
    for number in range(300):
        expression = _drawn(draw, 3)
        text = variants[number % len(variants)](sp.latex(expression))
        try:
            [equation] = read_latex(text, WORDS)
        except Unread:
            continue
        read += 1
        found = to_sympy(equation.left, SYMBOLS)
        point = {it: sp.Rational(draw.randint(-9, 9), 7) for it in SYMBOLS.values()}
        gap = (found - expression).subs(point)
        assert gap == 0 or abs(gap.evalf(40)) < 1e-25 * (1 + abs(expression.subs(point).evalf(40)))
    assert read >= 250
