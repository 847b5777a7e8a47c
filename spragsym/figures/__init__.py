"""Figures: the article's 3 to 14, some that it lacks, and the functions that draw them (extra
``plot``).

Drawing functions take ``ax=None``, draw, and return the artists; figure functions return a
:class:`~spragsym.figures.style.Sheet`, a matplotlib figure that carries its caption and the data of
its panels. Nothing here shows a window or changes matplotlib's settings.

Examples
--------
>>> import spragsym.figures
>>> figure = spragsym.figures.figure_12()
>>> figure.caption[:26], sorted(figure.tables)
('Figure 12. Bifurcation set', ['a'])
"""

import lazy_loader as _lazy

from ..core.errors import MissingExtraError as _MissingExtraError
from ..core.errors import ParameterError as _ParameterError

try:
    import matplotlib as _matplotlib  # noqa: F401  # named here where it is missing
except ModuleNotFoundError as error:
    raise _MissingExtraError("spragsym.figures", error.name or "matplotlib", "plot") from error
except ValueError as error:  # of MPLBACKEND, or of matplotlib's file of settings
    raise _ParameterError(
        f"matplotlib can't be loaded: {error}; unset MPLBACKEND, or mend matplotlibrc"
    ) from error

__getattr__, __dir__, __all__ = _lazy.attach_stub(__name__, __file__)
