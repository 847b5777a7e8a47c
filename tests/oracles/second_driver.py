"""Motions of the article's model by SciPy's solve_ivp with its own event location, on equations
written by hand.
"""

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

import spragsym as ss
from spragsym.motion import shooting
from tests.oracles import article_motion


def carried(
    values: Sequence[float],
    state: Any,
    span: float,
    rtol: float = 1e-11,
    atol: float | None = None,
    **options: Any,
) -> tuple[Any, int]:
    """Where the motion is after a while, and how often it crossed y = 0, piece by piece between
    SciPy's events.

    A state of twenty numbers carries the derivatives by the first four along, row by row.
    """
    theta0, *rest = values
    constants, V = (math.cos(theta0), math.sin(theta0), *rest), rest[-2]
    state, clock, crossed = np.array(state, dtype=float), 0.0, 0
    contact, side = int(state[1] <= 0), 1 if state[2] <= V else -1
    while clock < span:
        mode = (contact, side)

        def rates(_: float, z: Any, mode: tuple[int, int] = mode) -> Any:
            now = z[:4].tolist()
            here = [*now[2:], *article_motion.accelerations(now, constants, *mode)]
            if len(z) == 4:
                return here
            slopes = np.vstack([np.eye(4)[2:], article_motion.slopes(now, constants, *mode)])
            return np.concatenate([here, (slopes @ z[4:].reshape(4, 4)).ravel()])

        def leaves(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float((1 - 2 * mode[0]) * z[1] + 1e-12)

        def turns(_: float, z: Any, mode: tuple[int, int] = mode) -> float:
            return float(mode[1] * (V - z[2]) + 1e-12)

        for event in (leaves, turns):
            # as SciPy wants it
            event.terminal, event.direction = True, -1  # type: ignore[attr-defined]
        part = solve_ivp(
            rates,
            (clock, span),
            state,
            method="DOP853",
            rtol=rtol,
            atol=atol or 1e-3 * rtol,
            events=(leaves, turns),
            **options,
        )
        clock, state = float(part.t[-1]), part.y[:, -1]
        if len(part.t_events[0]):
            contact, crossed = 1 - contact, crossed + 1
        elif len(part.t_events[1]):
            side = -side
    return state, crossed


def differences(cycle: ss.results.Cycle) -> tuple[float, float, float]:
    """Of state, period, and multipliers relative to the larger of 1 and their size: what Newton's
    step of this driver is.
    """
    whole, _ = carried(
        cycle.values,
        np.concatenate([cycle.state, np.eye(4).ravel()]),
        cycle.period,
        rtol=3e-14,
        atol=1e-15,
        max_step=0.25,
    )
    end, matrix = whole[:4], whole[4:].reshape(4, 4)
    flow = shooting.rate(cycle.field, cycle.state, cycle.orbit.constants)
    step = np.linalg.solve(
        np.column_stack([(matrix - np.eye(4))[:, [0, 1, 3]], flow]), cycle.state - end
    )
    ours, theirs = (
        np.sort_complex(values) for values in (cycle.multipliers, np.linalg.eigvals(matrix))
    )
    return (
        float(np.abs(step[:3]).max()),
        abs(float(step[3])),
        float((np.abs(ours - theirs) / np.maximum(1, np.abs(ours))).max()),
    )
