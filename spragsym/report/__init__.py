"""A brake in, a verdict out: data with units and tolerances, answered in newtons, millimetres and
hertz.
"""

from .reports import Report
from .study import Study

__all__ = ["Report", "Study"]
