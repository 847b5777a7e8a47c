"""Chains of points in a graph of neighbours: curves from points in any order."""

from collections.abc import Iterable

import numpy as np

from .interval_arrays import IntArray


def link(links: list[set[int]], pairs: Iterable[tuple[int, int]]) -> None:
    """Add edges between pairs of points to ``links``, the neighbours of each point."""
    for one, other in pairs:
        links[one].add(other)
        links[other].add(one)


def walked(links: list[set[int]]) -> list[IntArray]:
    """Chains of points: open ones from one end to the other, closed ones with the first point
    repeated at the end.
    """
    seen: set[int] = set()
    chains = []
    # Ends of open chains, which have the fewest neighbours, come first.
    for start in sorted(range(len(links)), key=lambda point: len(links[point])):
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
