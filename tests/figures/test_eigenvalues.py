"""Frequencies and growth rates over a parameter: columns, JSON and the picture, against closed
forms and matrices.
"""

import json
import math
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner

import spragsym as ss
from spragsym.cli import cli
from tests.support import written_brake

pytest.importorskip("matplotlib")

#: Two modes that friction couples: without damping they meet at mu0 = 0.3389.
COUPLED = ["equilibria", "--model", "mode_coupling", "--vary"]


def test_damped_eigenvalues_of_one_coordinate_in_closed_form() -> None:
    speed = np.array([0.05, 0.101, 0.3])
    eq = ss.equilibria(ss.load("stick_slip").Parameters(V=speed))
    damping = 0.05 + 2 * 0.5 * 0.1 * (0.1**2 - speed**2) / (speed**2 + 0.1**2) ** 2
    want = np.array([np.sort_complex(np.roots([1.0, each, 1.0])) for each in damping])
    np.testing.assert_allclose(np.sort_complex(eq.damped_eigenvalues[:, 0]), want, atol=1e-14)
    np.testing.assert_allclose(eq.damped_eigenvalues.real.max(axis=-1), eq.growth, atol=1e-14)
    assert np.abs(eq.eigenvalues.real).max() == 0


@pytest.mark.thorough
def test_the_picture_shows_what_the_matrices_say() -> None:
    from spragsym.figures import eigenvalue_figure

    p = ss.load("mode_coupling").Parameters()
    figure = eigenvalue_figure(p, "mu0", between={"mu0": (0.0, 1.0)}, n=12)
    (meet,) = ss.flutter_onsets(p, "mu0", damping=False, between={"mu0": (0.0, 1.0)}).mu0
    frequency, growth = (
        {name: np.asarray(column) for name, column in figure.tables[key].items()} for key in "ab"
    )
    mu0, undamped = growth["mu0"], np.array([growth[f"undamped_{i}"] for i in range(1, 5)])
    assert (undamped[:, mu0 < meet] == 0).all()
    assert (undamped.max(axis=0)[mu0 > meet] > 0).all()
    for i in range(0, len(mu0), 7):
        eq = ss.equilibria(p.replace(mu0=mu0[i]))
        shown = [growth[f"damped_{k}"][i] + 1j * frequency[f"damped_{k}"][i] for k in range(1, 5)]
        np.testing.assert_allclose(
            np.sort_complex(shown), np.sort_complex(eq.damped_eigenvalues[0]), atol=1e-12
        )
    for k in range(1, 5):  # each column is one curve: no mode jumps to another
        assert np.abs(np.diff(frequency[f"damped_{k}"])).max() < 0.1
    drawn = np.concatenate([line.get_ydata() for line in figure.axes[0].lines])
    assert np.nanmin(drawn) > 0.9
    assert figure.axes[0].get_xlim() == (0.0, 1.0)
    with pytest.raises(ss.errors.ConvergenceError, match="nothing to draw"):
        eigenvalue_figure(ss.Parameters.article(theta0=0.5, kappa=10.0), "mu0", contact=False, n=4)


@pytest.mark.thorough
def test_the_command_draws_them_and_refuses_what_is_no_curve(tmp_path: Path) -> None:
    target = tmp_path / "modes.svg"
    done = CliRunner().invoke(cli, [*COUPLED, "mu0=0.3:0.4:2", "--plot", str(target), "--json"])
    assert (done.exit_code, "growth Re $\\lambda$ (units of" in target.read_text()) == (0, True)
    rows = [row for point in json.loads(done.stdout)["points"] for row in point["equilibria"]]
    assert all(row["growth"] == max(real for real, _ in row["damped_eigenvalues"]) for row in rows)
    for more in (
        ["mu0=0.3:0.4", "--alpha", "1,2", "--plot", "a.svg"],
        ["mu0=0.3:0.4", "--plot", "a.gif"],
    ):
        assert CliRunner().invoke(cli, [*COUPLED, *more]).exit_code != 0


def test_of_a_brake_the_picture_shows_hertz(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A mass of 2 kg on a spring of 8 kN/m beside a soft inclined one, on a belt without friction:
    10.07 Hz along the belt, by hand.
    """
    from spragsym.figures import style

    axes: list[tuple[str, float]] = []
    monkeypatch.setattr(style, "in_units", lambda axis, shown: axes.append(shown))
    rows = {"m": "2 kg", "k": "1 N/mm", "L_0": "50 mm", "theta0": "90 deg", "k_x": "8 N/mm"}
    rows |= {"k_y": "0 N/mm", "k_c": "500 N/mm", "F_L": "1 N", "V": "1 m/s", "d": "9 s/m"}
    file = written_brake(tmp_path, {**rows, "mu0": "0.01"})
    words = ["--data", str(file), "--vary", "mu0=0:0.1", "--plot", str(tmp_path / "a.svg")]
    done = CliRunner().invoke(cli, ["equilibria", *words])
    assert done.exit_code == 0, done.output
    titles, sizes = zip(*axes, strict=True)
    assert titles[1] == "frequency (Hz)"
    p = ss.Study.from_file(file).dimensionless.replace(mu0=0.0)
    slowest = np.abs(ss.equilibria(p).damped_eigenvalues[0].imag).min()
    assert sizes[1] * slowest == pytest.approx(math.sqrt(8000 / 2) / (2 * math.pi), rel=1e-3)
