"""Models of matrices, as finite-element programs write them: files, onsets of squeal, modes."""

from .answers import flutter_onsets as flutter_onsets
from .answers import modes as modes

#: Modules that other rooms ask; each is loaded when it is imported.
__all__ = ["answers", "files", "model", "onsets", "options"]
