"""Made from ``_compiled.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

SOURCE: str

def solve(
    theta0: Buffer,
    mu0: Buffer,
    kappa: Buffer,
    alpha: Buffer,
    sigma: Buffer,
    beta: Buffer,
    contact: int,
    settled: Buffer,
    count: Buffer,
    first: tuple[Buffer, ...],
    further: tuple[Buffer, ...],
) -> int: ...
def solve_widely(
    theta0: Buffer,
    mu0: Buffer,
    kappa: Buffer,
    alpha: Buffer,
    sigma: Buffer,
    beta: Buffer,
    contact: int,
    settled: Buffer,
    count: Buffer,
    first: tuple[Buffer, ...],
    further: tuple[Buffer, ...],
) -> int: ...
def count(
    theta0: Buffer,
    mu0: Buffer,
    kappa: Buffer,
    alpha: Buffer,
    sigma: Buffer,
    beta: Buffer,
    counts: Buffer,
) -> None: ...
