"""Type variables: the parameters of a function, keys of a mapping, and any one type."""

from __future__ import annotations

from typing import ParamSpec, TypeVar

P = ParamSpec("P")
K = TypeVar("K")
T = TypeVar("T")
