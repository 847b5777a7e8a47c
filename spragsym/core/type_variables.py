"""Type variables of signatures: the parameters and the result of a function, and any one type."""

from __future__ import annotations

from typing import ParamSpec, TypeVar

P = ParamSpec("P")
R = TypeVar("R")
T = TypeVar("T")
