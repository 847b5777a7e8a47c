"""Errors: each says which argument, its value, what is allowed, and what to do."""

from __future__ import annotations


class SpragsymError(Exception):
    """Base of every error that this package raises on purpose."""


class ParameterError(SpragsymError, ValueError):
    """An argument has a value that is not allowed."""


class ParameterTypeError(SpragsymError, TypeError):
    """An argument is not a number, or not numbers of the kind that is needed."""


class ModelError(ParameterTypeError):
    """A model is asked what is not there for it yet; the error says what can be asked instead."""


class NotDimensionlessError(ParameterTypeError, AttributeError):
    """Parameters in newtons and metres stand where dimensionless ones are needed.

    Also an AttributeError, so that ``hasattr`` answers: what is missing is what dimensionless parameters have.
    """


class TargetError(ParameterError, FileExistsError):
    """A file is in the way."""


class ConvergenceError(SpragsymError, RuntimeError):
    """A computation did not converge, or its result could not be certified."""


class MissingExtraError(SpragsymError, ImportError):
    """A feature needs a package that is not installed."""

    def __init__(self, feature: str, module: str, extra: str) -> None:
        super().__init__(f"{feature} needs {module}, which is not installed; in the source folder: pip install '.[{extra}]'")


class BackendError(SpragsymError, ImportError):
    """A backend that this installation does not have."""


class SweepError(SpragsymError, RuntimeError):
    """A sweep had to stop: the machine failed, or whatever else is no property of a motion."""


class StoreError(SpragsymError, OSError):
    """A file is damaged, in use, or cannot be written."""


class DamagedError(StoreError, TargetError):
    """The file is not a result of this library: it is damaged, or something else wrote it."""


class DamageWarning(UserWarning):
    """Part of a file is damaged and left out; the rest is good and used."""


class UndecidedWarning(UserWarning):
    """Some of many points have no answer; the others do."""
