"""Made from ``_carried.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

SOURCE: str

def carry(
    constants: Buffer,
    mode: Buffer,
    limits: Buffer,
    tables: Buffer,
    unit: Buffer,
    state: Buffer,
    clock: Buffer,
    times: Buffer,
    states: Buffer,
) -> tuple[int, int, int, int]: ...
