"""Right-hand sides in Python, C and MATLAB, held against the accelerations of a page."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("sympy")

import spragsym as ss
from spragsym.derive import pages
from spragsym.derive.statements import verdicts
from spragsym.derive.statements.book import forms_of
from spragsym.derive.statements.papers import Paper, PaperError, Statement, paper_of
from spragsym.derive.statements.printed_code import accelerations
from spragsym.papers import PaperCheck

PAGE = Path(__file__).parents[2] / "validation/papers/cart_pole/page.py"
CART = pages.read(PAGE)

CODE = {
    "py": """
import numpy as np
m_c = 1.0
class Cart:
    def rhs(self, t, y, p, l, f=0):
        '''The state is x, theta and their rates.'''
        x, th, v, w = y
        S, C = np.sin(th), np.cos(th)
        M = np.array([[m_c + p["m_p"], p["m_p"] * l * C], [p["m_p"] * l * C, p["m_p"] * l**2]])
        b = np.array([f + p["m_p"] * l * w**2 * S, -p["m_p"] * self.g * l * S])
        a = np.linalg.solve(M, b)
        return np.array([v, w, a[0], a[1]])
""",
    "c": """
#define G 9.81
static void rhs(double t, const double *y, double dy[4], const par *p) {
  const double s = sin(y[2]), c = cos(y[2]);  // of the angle
  double below = p->m_c + p->m_p*s*s;         /* below */
  dy[0] = y[1];
  dy[1] = (p->f + p->m_p*s*(p->l*y[3]*y[3] + p->g*c))/below;
  dy[2] = y[3];
  dy[3] = (-p->f*c - p->m_p*p->l*pow(y[3], 2)*c*s - 1.0f*(p->m_c + p->m_p)*p->g*s)/(p->l*below);
}
""",
    "m": r"""
function dz = rhs(t, z, m_c, m_p, l, g, f)
% the state is x, theta and their rates
x = z(1); theta = z(2); dx = z(3); dtheta = z(4);
M = [m_c + m_p, m_p*l*cos(theta); m_p*l*cos(theta), m_p*l^2];
b = [f + m_p*l*dtheta.^2*sin(theta); -m_p*g*l*sin(theta)];
a = M\b;
dz = [dx; dtheta; a(1); ...
      a(2)];
end
""",
}


def judged(code: str, kind: str) -> verdicts.Row:
    """The verdict on the function ``rhs``."""
    statement = Statement("1", "code", code, is_latex=False, file=f"a.{kind}", function="rhs")
    return verdicts.check(Paper("", "", {"th": "theta"}, (statement,)), CART).rows[0]


@pytest.mark.parametrize("kind", CODE)
@pytest.mark.thorough
def test_code_is_confirmed_and_its_fault_is_found(kind: str) -> None:
    row = judged(CODE[kind], kind)
    assert (row.status, row.about) == ("confirmed", "code")
    force = "p->f + " if kind == "c" else "f + "
    wrong = judged(CODE[kind].replace(force, f"2*{force}", 1), kind)
    assert wrong.status in ("misprint", "failed")
    found = PaperCheck("", "", (), (wrong,))
    assert "<br>" in found.to_html()
    assert r"\[function" not in found.to_latex()


@pytest.mark.parametrize(
    ("code", "kind", "said"),
    [
        ("def rhs(t, y):\n    return [y[2], y[3], 1/2*g, y[2]]", "py", "ax = 1 / 2 * g"),
        (
            "void rhs(double *y, double *d) {d[0]=y[2]; d[1]=y[3]; d[2]=1/2*g; d[3]=0;}",
            "c",
            "0 * g",
        ),
        ("rhs = @(t, y) [y(3); y(4); g; -y(3)];", "m", "ax = g; atheta = -vx"),
        ("rhs = lambda x, theta: (-f, sin(theta))", "py", "ax = -f; atheta = sin(theta)"),
        (
            "def rhs(t, y):\n    w, th, v, x = y\n    return [0, w, 0, v]",
            "py",
            "atheta = 0; ax = 0",
        ),
    ],
)
def test_code_is_translated_by_name(code: str, kind: str, said: str) -> None:
    """The state is told by what is returned; of whole numbers C divides without the rest."""
    statement = Statement("1", "code", code, is_latex=False, file=f"a.{kind}", function="rhs")
    text = accelerations(statement, {"th": "theta"}, forms_of(CART)["units"])[1]
    assert said in text


@pytest.mark.parametrize(
    ("code", "said"),
    [
        ("def other(t, y):\n    return y", "there is no function rhs"),
        ("def rhs(t, y):\n    if t:\n        return y", "branches and loops are not read"),
        ("def rhs(t, y):\n    return [y[2], y[3], q_9, 0]", "q_9 is no name of the page"),
        ("def rhs(t, y):\n    return [y[2], 1]", "neither a coordinate nor a rate"),
        ("def rhs(t, y):\n    return open('a')", "is not read"),
        ("def rhs(t, y:\n", "can't be translated"),
    ],
)
def test_what_is_not_translated_says_why(code: str, said: str) -> None:
    row = judged(code, "py")
    assert (row.status, said in row.evidence) == ("unread", True), row.evidence


@pytest.mark.thorough
def test_code_is_read_beside_its_paper_and_not_run(tmp_path: Path) -> None:
    mark = tmp_path / "run"
    (tmp_path / "a.py").write_text(f"open({str(mark)!r}, 'w')\n{CODE['py']}", encoding="utf-8")
    file = tmp_path / "paper.toml"
    row = '[[statement]]\nid = "1"\nabout = "code"\nfile = "a.py"\nfunction = "rhs"\n'
    file.write_text(f"[symbols]\nth = 'theta'\n{row}", encoding="utf-8")
    (found,) = ss.check(file, PAGE).rows
    assert (found.status, mark.exists()) == ("confirmed", False)
    file.write_text(row.replace("a.py", "b.py"), encoding="utf-8")
    with pytest.raises(ss.errors.ParameterError, match="no such file"):
        ss.check(file, PAGE)


def test_code_has_a_file_and_a_function() -> None:
    import tomllib

    row = '[[statement]]\nid = "1"\nabout = "motion x"\nfile = "a.py"\nfunction = "f"\n'
    for text in (row, row.replace('function = "f"\n', "").replace("motion x", "code")):
        with pytest.raises(PaperError, match="code has file"):
            paper_of("a.toml", text, tomllib.loads)
