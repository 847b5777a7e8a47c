"""Made from ``_contractors.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

from .verdicts import CompiledRules

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
def judged(
    values: Buffer,
    slopes: Buffer,
    middle: Buffer,
    given: Buffer,
    boxes: Buffer,
    wide: Buffer,
    n: int,
    sharp: bool,
    single: Buffer,
    spent: Buffer,
    rules: CompiledRules,
    step: Buffer,
    left: Buffer,
    verdicts: Buffer,
    along: Buffer,
) -> None: ...
