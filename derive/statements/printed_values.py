"""Printed numbers, as frequencies and thresholds, held against the page at the printed data."""

from __future__ import annotations

import re
from fractions import Fraction

import sympy as sp

from .book import Book, equations_of, meanings
from .papers import Statement
from .tree import Unread, symbols, to_sympy

_SIGNS = re.compile(r"=|\\(?:approx|simeq|equiv)(?![A-Za-z])")
_NUMBER = re.compile(
    r"[\s&{]*(?P<digits>-?\d+(?:\.(?P<after>\d+))?)\}?"
    r"(?:\s*(?:\\times|\\cdot|\*)\s*10\s*\^\s*\{?(?P<power>-?\d+)\}?|[eE](?P<exponent>-?\d+))?"
    r"(?P<unit>(?:\\[,;:! ]|~|\s)*(?:\\(?:mathrm|text|rm|textrm|,)?.*|[A-Za-z].*)?)[\s.]*",
    re.S,
)


def verdict_on_value(statement: Statement, book: Book) -> tuple[str, str, str, str]:
    """Status, what was read, what is right and the evidence: whether every side before a printed
    number has this value at the printed data, to the digits that are printed.

    Raises
    ------
    Unread
        If there is no number, or a name without a value.
    """
    *sides, last = _SIGNS.split(statement.judged)
    found = _NUMBER.fullmatch(last)
    if not sides or found is None:
        raise Unread("a value is a name or an expression, an equal sign and a number")
    exponent = int(found["power"] or found["exponent"] or 0)
    if abs(exponent) > 300:
        raise Unread("a number beyond double precision")
    last_place = Fraction(10) ** (exponent - len(found["after"] or ""))
    printed = Fraction(found["digits"]) * Fraction(10) ** exponent
    derivation = book.forms[statement.form or "units"]
    known = meanings(derivation, book)
    for side in sides:
        tree = equations_of(f"{side} = 0", statement, derivation, book)[0].left
        if missing := sorted(symbols(tree) - known.keys()):
            raise Unread(f"{missing[0]} has no value on the page; define it, or print it in [data]")
        value = to_sympy(tree, known)
        at = {
            it: _rational(book.data[it.name]) for it in value.free_symbols if it.name in book.data
        }
        value = value.xreplace(at)
        if missing := sorted(map(str, value.free_symbols)):
            raise Unread(f"{', '.join(missing)} has no value in [data]")
        exact = sp.N(value, 30)
        if not exact.is_real:
            raise Unread(f"at the printed data it is {exact}, no real number")
        near = Fraction(str(exact))
        said = f"at the printed data {side.strip()} is {sp.N(value, 10)}"
        if abs(near - printed) > last_place / 2:
            right = round(near / last_place) * last_place
            digits = max(0, -exponent + len(found["after"] or ""))
            return "misprint", f"{side.strip()} = {printed}", f"{float(right):.{digits}f}", said
    return "confirmed", statement.judged, "", f"{said}, to the digits that are printed"


def _rational(text: str) -> sp.Rational:
    """The number in a text, exactly."""
    try:
        return sp.Rational(Fraction(text.strip()))
    except (ValueError, ZeroDivisionError) as error:
        raise Unread(f"{text!r} in [data] is no number; write it as 9.81") from error
