"""Made from ``_search.c`` on installation, if there is a C compiler."""

from typing import Any as Buffer

from .verdicts import CompiledRules

def plan(n: int, coordinates: int, parameters: int, *tapes_and_others: Buffer) -> object: ...
def kept(
    plan: object, given: Buffer, parameters: Buffer, margin: float, boxes: Buffer, keep: Buffer
) -> None: ...
def decided(
    plan: object,
    given: Buffer,
    boxes: Buffer,
    parameters: Buffer,
    limits: Buffer,
    single: Buffer,
    spent: Buffer,
    sharp: bool,
    rules: CompiledRules,
    wide: Buffer,
    step: Buffer,
    left: Buffer,
    verdicts: Buffer,
    along: Buffer,
) -> None: ...
def rounds(
    plan: object,
    given: Buffer,
    parameters: Buffer,
    limits: Buffer,
    sharp: bool,
    rules: CompiledRules,
    budget: int,
    most: int,
) -> tuple[int, bytes, bytes, bytes, bytes]: ...
def tubes(
    tapes: tuple[Buffer, Buffer, Buffer],
    borders: Buffer,
    parameters: Buffer,
    pivot: int,
    inflation: float,
    times: int,
    *arrays: Buffer,
) -> None: ...
def corrected(
    tapes: tuple[Buffer, Buffer], parameters: Buffer, pivot: int, steps: int, z: Buffer
) -> None: ...
def tangents(
    tapes: tuple[Buffer, Buffer], parameters: Buffer, pivot: int, *arrays: Buffer
) -> None: ...
