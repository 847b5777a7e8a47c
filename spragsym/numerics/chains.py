"""Curves from points that are linked to their neighbours."""

from collections.abc import Iterable

import numpy as np

from .interval_arrays import IntArray


def link(links: list[set[int]], pairs: Iterable[tuple[int, int]]) -> None:
    """Make neighbours of pairs of points."""
    for one, other in pairs:
        links[one].add(other)
        links[other].add(one)


def walked(links: list[set[int]]) -> list[IntArray]:
    """Chains of a graph, open ones from an end, closed ones from anywhere and back to there."""
    seen: set[int] = set()
    chains = []
    for start in sorted(range(len(links)), key=[*map(len, links)].__getitem__):
        if start in seen:
            continue
        chain = [start]
        seen.add(start)
        while ahead := links[chain[-1]] - seen:
            chain.append(min(ahead))
            seen.add(chain[-1])
        if len(links[start]) == 2 and start in links[chain[-1]] and len(chain) > 2:
            chain.append(start)
        chains.append(np.array(chain))
    return chains
