"""House style: sheets, lines, colours, labels with units, common parts of captions, and a figure as
files.
"""

from __future__ import annotations

import csv
import io
import itertools
import re
import textwrap
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.figure import Figure
from matplotlib.style import context
from matplotlib.ticker import AutoLocator, FixedLocator
from numpy.typing import ArrayLike, NDArray

from ..article.assumed import Parameters
from ..display import Column
from ..files.storage import put
from ..models import Model
from ..models.parameters import FloatArray, ParameterSet, Ranges, largest
from ..results import EquilibriumType, Points, Result

if TYPE_CHECKING:
    from matplotlib.text import Text

#: Width of one column, inches.
SINGLE = 3.5
#: Width of two columns, inches.
DOUBLE = 7.0

#: Okabe and Ito's colours.
BLACK = "#000000"
BLUE = "#0072B2"
VERMILION = "#D55E00"
GREEN = "#009E73"
PURPLE = "#CC79A7"
SKY = "#56B4E9"
ORANGE = "#E69F00"
GREY = "#6b6b6b"

#: How a kind of equilibrium is drawn.
LINES: Mapping[EquilibriumType, Any] = {
    EquilibriumType.STABLE: "-",
    EquilibriumType.DIVERGENT: (0, (3.5, 1.6)),
    EquilibriumType.FLUTTER: (0, (6, 1.5, 1.2, 1.5)),
}


#: Columns of numbers or words by name: what one panel shows.
Table: TypeAlias = Mapping[str, ArrayLike]


class Sheet(Figure):
    """A figure with its caption, and the data of its panels by letter."""

    caption: str = ""

    def __init__(self, *size: Any, **options: Any) -> None:
        super().__init__(*size, **options)
        self.tables: dict[str, Table] = {}

    def describe(self, caption: str, **tables: Table) -> Sheet:
        """Set the caption, and the data of panels ``a``, ``b``, …, as far as they are not there
        yet.
        """
        self.caption = " ".join(caption.split())
        self.tables |= tables
        return self

    def _repr_png_(self) -> bytes:
        with house_style():
            return picture(self, "png", dpi=150)


@contextmanager
def house_style() -> Iterator[None]:
    """The house style for as long as the context lasts."""
    with context(Path(__file__).with_name("house.mplstyle")):
        yield
        interactive = matplotlib.is_interactive()
    # A notebook turns it on when pyplot is first imported, perhaps in here.
    matplotlib.interactive(interactive)


#: Decorator: run a function with the house style, and leave the global one as it was.
styled = house_style()


def panels(
    rows: int, columns: int, width: float, height: float, **options: Any
) -> tuple[Sheet, NDArray[Any]]:
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
    """Tables of equal columns, one below the other, and under ``number`` which is which; without
    tables columns of ``names``.

    What stands in place of a column is in every row.
    """
    rows = [np.broadcast_arrays(*table.values()) for table in tables]
    columns = {
        name: np.concatenate(parts or ([],))
        for name, *parts in zip(tables[0] if tables else names, *rows, strict=True)
    }
    if number:
        return {number: np.repeat(np.arange(len(rows)), [row[0].size for row in rows]), **columns}
    return columns


def runs(kinds: NDArray[Any]) -> list[slice]:
    """Stretches of one kind, each with the first point of the next, so that no gap shows."""
    cuts = [0, *(1 + np.flatnonzero(kinds[1:] != kinds[:-1])), len(kinds)]
    return [slice(begin, end + 1) for begin, end in itertools.pairwise(cuts)]


def denser_at_ends(low: Any, high: Any, inset: float, n: int) -> FloatArray:
    """Values between two ends, or a column of them between each two, a share of the range within;
    denser there, where curves turn back like a square root.
    """
    share = 0.5 - 0.5 * np.cos(np.pi * np.linspace(inset, 1 - inset, n))
    return np.add(low, np.multiply.outer(share, np.subtract(high, low)))


def places(
    model: Model, names: Sequence[str], of: Result | Mapping[str, FloatArray]
) -> list[FloatArray]:
    """Columns as axes show them: angles in degrees."""
    return [model.column(name).size * of[name] for name in names]


def own_axes(ax: Axes | None) -> Axes:
    """The axes to draw on: those given, or pyplot's current ones."""
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.gca()


def angle_axis(
    ax: Axes, low: float = 0.0, high: float = 180.0, step: float = 30.0, **more: Any
) -> None:
    """θ₀ in degrees along x, and more settings of the axes."""
    ax.set(
        xlim=(low, high),
        xticks=np.arange(low, high + step / 2, step),
        xlabel=r"$\theta_0$ (deg)",
        **more,
    )


def remark(ax: Axes, text: str) -> None:
    """Remark on a panel, above its right end."""
    ax.set_title(text, loc="right", color=GREY)


def line_at(
    ax: Axes, x: float, color: str = GREY, width: float = 0.7, style: str = ":", **options: Any
) -> None:
    """A thin line upwards, dotted unless told otherwise."""
    ax.axvline(x, color=color, linewidth=width, linestyle=style, **options)


def write_along(
    ax: Axes, text: str, x: float, y: float, color: str = BLACK, **options: Any
) -> Text:
    """A direct label in data coordinates."""
    return ax.text(
        x, y, text, **{"color": color, "fontsize": 8, "ha": "left", "va": "center", **options}
    )


def say(ax: Axes, text: str) -> None:
    """Words in the middle of a picture that holds nothing else."""
    ax.text(0.5, 0.5, text, transform=ax.transAxes, ha="center", va="center", color=GREY)


def plain_ticks(axis: Axis, values: tuple[float, ...]) -> None:
    """Ticks of a logarithmic axis at the given values, written as plain numbers."""
    axis.set_major_locator(FixedLocator(values))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("")


#: θ₀ of the paths a–a′ and b–b′.
PATHS_DEG = {"a": 60.0, "b": 40.0}

#: Parameters that the captions repeat, in the article's letters.
LETTERS = {"alpha": "α", "beta": "β", "kappa": "κ", "mu0": "μ₀", "sigma": "σ", "theta0": "θ₀"}

BASE_TEXT = ", ".join(
    f"{LETTERS[name]} = {getattr(Parameters, name):g}"
    for name in ("kappa", "alpha", "sigma", "beta")
)

LINES_TEXT = "Stable solid, divergent dashed, flutter dash-dotted; dots are folds."

RANGE_TEXT = "The ranges of the axes are our choice."


def symbol(name: str) -> str:
    """A name as mathematics writes it, without the dollars: ``\\kappa``, ``k_{\\rm c}``,
    ``\\theta_0``.
    """
    base, _, index = name.partition("_")
    if numbered := re.fullmatch(r"([^\W\d]+)(\d)", base):
        if not index:
            return f"{symbol(numbered[1])}_{numbered[2]}"
        return f"{symbol(numbered[1])}_{{{numbered[2]}, {index}}}"
    # Names that are letters, those of large ones that Latin has not.
    small = "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau"
    large = "Gamma Delta Theta Lambda Xi Sigma Upsilon Phi Psi Omega"
    greek = {*f"{small} upsilon phi chi psi omega {large}".split()}
    return (rf"\{base}" if base in greek else base) + (rf"_{{\rm {index}}}" if index else "")


def in_letters(scale: str) -> str:
    """The scale of a quantity, as ``L_0*sqrt(k_c)/sqrt(m)``, as mathematics writes it."""
    merged = re.sub(r"sqrt\((\w+)\)/sqrt\((\w+)\)", r"\\sqrt{\1/\2}", scale)
    return (
        re.sub(r"(?<!\\)sqrt\((.+?)\)", r"\\sqrt{\1}", merged)
        .replace("**", "^")
        .replace("*", r"\,")
    )


def label(column: Column, unit: str = "") -> str:
    """The symbol of a column and its unit, of an angle degrees unless told otherwise."""
    written = rf"\dot{{{symbol(column.rate_of)}}}" if column.rate_of else symbol(column.name)
    unit = unit or ("deg" if column.is_angle else "")
    return f"${written}$ ({unit})" if unit else f"${written}$"


def own_unit(model: Model, column: Column) -> str:
    """The unit of a column where it is shown as the model measures it."""
    unit = "1" if column.name in model.parameters else model.unit(column.dimension)
    if column.is_angle or not unit:
        return ""
    return "dimensionless" if unit == "1" else f"units of ${in_letters(unit)}$"


#: What an axis says, and what one of what is drawn is there.
Shown = tuple[str, float]


class _Round(AutoLocator):
    """Ticks at round numbers in the unit of an axis."""

    one: float

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        return [tick / self.one for tick in super().tick_values(self.one * vmin, self.one * vmax)]


def in_units(axis: Axis, shown: Shown | None) -> None:
    """Have an axis show other units than what is drawn is in; None leaves it as it is."""
    if shown is not None:
        title, one = shown
        axis.set_label_text(title)
        if one != 1.0:
            ticks = _Round()
            ticks.one = one
            axis.set_major_locator(ticks)
            axis.set_major_formatter(lambda value, _: f"{one * value:.6g}")


def window(
    p: ParameterSet,
    vary: Sequence[str],
    between: Ranges,
    cusps: Callable[[], Points] | None = None,
) -> Ranges:
    """Ranges to show: those given, the parameter's own, or of one without end as far as its base
    value, 1, all cusps and its value need.
    """
    out = dict(between)
    for name in vary:
        if name not in between:
            own = p.ranges[name]
            low, high = own.low, own.high
            if np.isinf((low, high)).any():
                farthest = float(np.abs(cusps()[name]).max(initial=0.0)) if cusps else 0.0
                # What is shown beyond the farthest cusp.
                far = max(1.0, 2.0 * abs(p.model.base.get(name, 0.0)), 1.25 * farthest)
                if largest(p, name) >= far:
                    far = 2.0 * largest(p, name)
                low, high = -far if np.isinf(low) else low, far if np.isinf(high) else high
            out[name] = low, high
    return out


@styled
def write(figure: Sheet, folder: Path, stem: str, formats: Iterable[str] = ("pdf",)) -> list[Path]:
    """Write ``stem.pdf`` and the like, its caption to ``stem.txt``, its data to ``stem_a.csv`` …;
    returns the paths.

    Parts that are not drawn as lines have 300 dots per inch.
    """
    files: dict[str, bytes | str] = {f"{stem}.{kind}": picture(figure, kind) for kind in formats}
    files[f"{stem}.txt"] = textwrap.fill(figure.caption, 100) + "\n"
    files |= {f"{stem}_{panel}.csv": _table(table) for panel, table in figure.tables.items()}
    for name, content in files.items():
        put(folder / name, content, made=True)
    return [folder / name for name in files]


def picture(figure: Figure, kind: str, **options: Any) -> bytes:
    """A figure in a format, without the date and the version of what drew it."""
    left_out = {
        "pdf": ("CreationDate", "Producer", "Creator"),
        "png": ("Software",),
        "svg": ("Date", "Creator"),
    }
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, metadata=dict.fromkeys(left_out[kind]), **options)
    return stream.getvalue()


def _table(table: Table) -> str:
    """One line per row; numbers with the twelve digits that the library promises."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table)
    for row in zip(*(np.asarray(values).tolist() for values in table.values()), strict=True):
        writer.writerow([f"{value:.12g}" if isinstance(value, float) else value for value in row])
    return text.getvalue()
