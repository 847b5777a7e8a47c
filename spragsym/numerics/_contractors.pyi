"""Made from ``_contractors.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

MOST: int

def inverse(matrices: Buffer, n: int, to: Buffer) -> None: ...
def newton(
    values: Buffer,
    slopes: Buffer,
    middle: Buffer,
    reach: Buffer,
    n: int,
    rows: bool,
    ends: Buffer,
    noise: Buffer,
    none: Buffer,
) -> None: ...
