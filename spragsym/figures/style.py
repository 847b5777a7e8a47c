"""House style: sizes, lines and colours that print well and that the colour-blind can tell apart."""

from __future__ import annotations

import functools
import io
import itertools
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, ParamSpec, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ..errors import MissingExtraError
from ..results import Stability

try:
    import matplotlib
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure
    from matplotlib.ticker import FixedLocator, NullFormatter
except ModuleNotFoundError as error:
    raise MissingExtraError("spragsym.figures", error.name or "matplotlib", "plot") from error

#: Widths of one column and of two, inches.
SINGLE, DOUBLE = 3.5, 7.0

#: Okabe and Ito's colours.
BLACK, BLUE, VERMILION, GREEN, PURPLE, SKY, ORANGE = (
    "#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00",
)  # fmt: skip
GREY = "#6b6b6b"

#: How a kind of equilibrium is drawn.
LINES: Mapping[Stability, Any] = {
    Stability.STABLE: "-",
    Stability.DIVERGENT: (0, (3.5, 1.6)),
    Stability.FLUTTER: (0, (6, 1.5, 1.2, 1.5)),
}

STYLE: dict[str, Any] = {
    "font.family": "STIXGeneral",
    "mathtext.fontset": "stix",
    "font.size": 9,
    "axes.labelsize": 9,
    "axes.titlesize": 9,
    "axes.linewidth": 0.6,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "xtick.major.width": 0.6,
    "ytick.major.width": 0.6,
    "lines.linewidth": 1.3,
    "lines.solid_capstyle": "butt",
    "legend.frameon": False,
    "legend.fontsize": 8,
    "figure.dpi": 150,
    "savefig.dpi": 300,
    "pdf.fonttype": 42,
    "svg.hashsalt": "spragsym",  # without a salt the ids in an SVG file are random
    "svg.fonttype": "path",
}

#: Columns of numbers or words by name: what one panel shows.
Table: TypeAlias = Mapping[str, ArrayLike]

_P = ParamSpec("_P")
_R = TypeVar("_R")


class Sheet(Figure):
    """A figure with its caption, and the data of its panels by letter."""

    caption: str = ""

    def __init__(self, *args: Any, **options: Any) -> None:
        super().__init__(*args, **options)
        self.tables: dict[str, Table] = {}

    def describe(self, caption: str, **tables: Table) -> Sheet:
        """Set the caption, and the data of panels ``a``, ``b``, …."""
        self.caption = " ".join(textwrap.dedent(caption).split())
        self.tables = dict(tables)
        return self

    def _repr_png_(self) -> bytes:
        with house_style(), io.BytesIO() as file:
            self.savefig(file, format="png", dpi=150)
            return file.getvalue()


@contextmanager
def house_style() -> Iterator[None]:
    """The house style for as long as the context lasts."""
    style: Any = STYLE  # matplotlib's type for it lists every setting by name
    with matplotlib.rc_context(style):
        yield
        interactive = matplotlib.is_interactive()
    matplotlib.interactive(interactive)  # which a notebook turns on when pyplot is first imported, perhaps in here


def styled(function: Callable[_P, _R]) -> Callable[_P, _R]:
    """Run a function with the house style, and leave the global one as it was."""

    @functools.wraps(function)
    def inside(*args: _P.args, **options: _P.kwargs) -> _R:
        with house_style():
            return function(*args, **options)

    return inside


def panels(rows: int, columns: int, width: float, height: float, **options: Any) -> tuple[Sheet, NDArray[Any]]:
    """An empty figure of rows × columns panels, lettered if there are several; sizes in inches."""
    figure = Sheet(figsize=(width, height), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, **options)
    if axes.size > 1:
        for letter, ax in zip("abcdefgh", axes.flat, strict=False):
            ax.set_title(f"({letter})", loc="left")
    return figure, axes


def single(width: float, height: float) -> tuple[Sheet, Any]:
    """An empty figure of one panel."""
    figure, ((ax,),) = panels(1, 1, width, height)
    return figure, ax


def stacked(tables: Sequence[Table], number: str = "", names: Iterable[str] = ()) -> Table:
    """Tables of equal columns, one below the other, and under ``number`` which is which; without tables columns of ``names``."""
    names = list(tables[0] if tables else names)
    sizes = [np.size(table[names[0]]) for table in tables]
    columns = {name: np.concatenate([table[name] for table in tables] or [[]]) for name in names}
    return {number: np.repeat(np.arange(len(tables)), sizes), **columns} if number else columns


def runs(kinds: NDArray[Any]) -> list[slice]:
    """Stretches of one kind, each with the first point of the next, so that no gap shows."""
    cuts = [0, *(1 + np.flatnonzero(kinds[1:] != kinds[:-1])), len(kinds)]
    return [slice(begin, end + 1) for begin, end in itertools.pairwise(cuts)]


def own_axes(ax: Axes | None) -> Axes:
    """The axes to draw on: those given, or pyplot's current ones."""
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.gca()


def angle_axis(ax: Axes, low: float = 0.0, high: float = 180.0, step: float = 30.0, label: bool = True) -> None:
    """θ₀ in degrees along x."""
    ax.set_xlim(low, high)
    ax.set_xticks(np.arange(low, high + step / 2, step))
    if label:
        ax.set_xlabel(r"$\theta_0$ (deg)")


def remark(ax: Axes, text: str) -> None:
    """What a panel is of, above its right end."""
    ax.set_title(text, loc="right", color=GREY)


def line_at(ax: Axes, place: float, color: str = GREY, width: float = 0.7, style: str = ":", **options: Any) -> None:
    """A thin line upwards, dotted unless told otherwise."""
    ax.axvline(place, color=color, linewidth=width, linestyle=style, **options)


def write_along(ax: Axes, text: str, x: float, y: float, color: str = BLACK, **options: Any) -> Any:
    """A direct label in data coordinates."""
    style: dict[str, Any] = {"color": color, "fontsize": 8, "ha": "left", "va": "center"}
    return ax.text(x, y, text, **(style | options))


def say(ax: Axes, text: str) -> None:
    """Words in the middle of a picture that holds nothing else."""
    ax.text(0.5, 0.5, text, transform=ax.transAxes, ha="center", va="center", color=GREY)


def plain_ticks(axis: Any, values: tuple[float, ...]) -> None:
    """Ticks of a logarithmic axis at the given values, written as plain numbers."""
    axis.set_major_locator(FixedLocator(values))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter(NullFormatter())
