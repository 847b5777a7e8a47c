"""A map shows what is not known of the lines that were searched."""

from dataclasses import replace

import numpy as np
import pytest

import spragsym as ss


def test_undecided_stretches_are_drawn_where_they_are() -> None:
    pyplot = pytest.importorskip("matplotlib.pyplot")
    from spragsym import figures

    p = ss.load("stick_slip").Parameters()
    found = ss.onset_curves(p, ("V", "zeta"), 4, between={"V": (0.1, 1.0), "zeta": (0.0, 0.5)})
    box = np.array([[[0.0, 0.1], [0.3, 0.4], [0.2, 0.2]]])
    _, (plain, marked) = pyplot.subplots(1, 2)
    before = len(figures.draw_onset_curves(replace(found, undecided=box[:0]), plain))
    line = figures.draw_onset_curves(replace(found, undecided=box, complete=False), marked)[before]
    assert (line.get_xdata().tolist(), line.get_ydata().tolist()) == ([0.3, 0.4], [0.2, 0.2])
    assert marked.get_xlim() == (0.1, 1.0)
    pyplot.close("all")
