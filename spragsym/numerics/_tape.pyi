"""Made from ``_tape.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

OPERATIONS: tuple[str, ...]

def run(
    code: Buffer, numbers: Buffer, inputs: tuple[Buffer, ...], out: Buffer, slots: int
) -> None: ...
def affine(code: Buffer, numbers: Buffer, *arrays_and_slots: Buffer) -> None: ...
