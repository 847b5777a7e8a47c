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
from string import ascii_lowercase
from typing import TYPE_CHECKING, Any, TypeAlias

import matplotlib
import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.colors import ListedColormap
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
SKY = "#56B4E9"
GREY = "#6b6b6b"
#: Colours of curves that are alike, in their order: the others are purple and orange.
PALETTE = (BLUE, VERMILION, GREEN, "#CC79A7", "#E69F00", SKY)

#: Line style for each type of equilibrium.
LINES: Mapping[EquilibriumType, Any] = {
    EquilibriumType.STABLE: "-",
    EquilibriumType.DIVERGENT: (0, (3.5, 1.6)),
    EquilibriumType.FLUTTER: (0, (6, 1.5, 1.2, 1.5)),
}


#: Data of a panel: columns of numbers or words by name.
Table: TypeAlias = Mapping[str, ArrayLike]


class Sheet(Figure):
    """A figure with its caption, and the data of its panels by letter."""

    caption: str = ""

    def __init__(self, *size: Any, **options: Any) -> None:
        super().__init__(*size, **options)
        self.tables: dict[str, Table] = {}

    def describe(self, caption: str, **tables: Table) -> Sheet:
        """Set the caption, and add the data of panels ``a``, ``b``, …."""
        self.caption = " ".join(caption.split())
        self.tables |= tables
        return self

    def _repr_png_(self) -> bytes:
        with house_style():
            return picture(self, "png", dpi=150)


@contextmanager
def house_style() -> Iterator[None]:
    """Context in which the house style is used."""
    with context(Path(__file__).with_name("house.mplstyle")):
        yield
        interactive = matplotlib.is_interactive()
    # A notebook turns it on at the first import of pyplot, which may be in the context.
    matplotlib.interactive(interactive)


#: Decorator: run a function with the house style, without a change of the global one.
styled = house_style()


def panels(
    rows: int, columns: int, width: float, height: float, **options: Any
) -> tuple[Sheet, NDArray[Any]]:
    """An empty figure of rows × columns panels, lettered if there are several; sizes in inches."""
    figure = Sheet(figsize=(width, height), layout="constrained")
    axes = figure.subplots(rows, columns, squeeze=False, **options)
    if axes.size > 1:
        for letter, ax in zip(ascii_lowercase, axes.flat, strict=False):
            ax.set_title(f"({letter})", loc="left")
    return figure, axes


def single(width: float, height: float) -> tuple[Sheet, Any]:
    """An empty figure of one panel."""
    figure, ((ax,),) = panels(1, 1, width, height)
    return figure, ax


def stacked(tables: Sequence[Table], number: str = "", names: Iterable[str] = ()) -> Table:
    """Concatenate tables with the same columns. The column ``number`` is the index of the table of
    each row. If there are no tables, the columns are ``names``, empty.

    A single value in place of a column is repeated in every row.
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
    """Slices of equal kind, each with the first point of the next, so that curves have no gaps."""
    cuts = [0, *(1 + np.flatnonzero(kinds[1:] != kinds[:-1])), len(kinds)]
    return [slice(begin, end + 1) for begin, end in itertools.pairwise(cuts)]


def denser_at_ends(low: Any, high: Any, inset: float, n: int) -> FloatArray:
    """``n`` values between two ends (or a column of them for each pair of ends), denser at the
    ends, where curves may turn back like a square root; ``inset`` is the distance from the ends.
    """
    share = 0.5 - 0.5 * np.cos(np.pi * np.linspace(inset, 1 - inset, n))
    return np.add(low, np.multiply.outer(share, np.subtract(high, low)))


def places(
    model: Model, names: Sequence[str], of: Result | Mapping[str, FloatArray]
) -> list[FloatArray]:
    """Columns in the units of axes: angles in degrees."""
    return [model.column(name).size * of[name] for name in names]


def own_axes(ax: Axes | None) -> Axes:
    """The given axes, or pyplot's current ones."""
    if ax is not None:
        return ax
    from matplotlib import pyplot

    return pyplot.gca()


def angle_axis(
    ax: Axes, low: float = 0.0, high: float = 180.0, step: float = 30.0, **more: Any
) -> None:
    """Set the x axis to θ₀ in degrees, and other properties of the axes."""
    ax.set(
        xlim=(low, high),
        xticks=np.arange(low, high + step / 2, step),
        xlabel=r"$\theta_0$ (deg)",
        **more,
    )


def remark(ax: Axes, text: str) -> None:
    """Write a remark above the right end of a panel."""
    ax.set_title(text, loc="right", color=GREY)


def line_at(
    ax: Axes, x: float, color: str = GREY, width: float = 0.7, style: str = ":", **options: Any
) -> None:
    """Draw a thin vertical line, by default dotted."""
    ax.axvline(x, color=color, linewidth=width, linestyle=style, **options)


def write_along(
    ax: Axes, text: str, x: float, y: float, color: str = BLACK, **options: Any
) -> Text:
    """Write a label at a point in data coordinates."""
    return ax.text(
        x, y, text, **{"color": color, "fontsize": 8, "ha": "left", "va": "center", **options}
    )


def once(ax: Axes, name: str) -> str:
    """A label for an artist: the name, or hidden from the legend if another artist has it."""
    return f"_{name}" if name in ax.get_legend_handles_labels()[1] else name


def cells(
    ax: Axes, places: Sequence[FloatArray], values: NDArray[Any], colour: str = "", name: str = ""
) -> list[Any]:
    """Draw a value for each point of a grid as a cell, sampled at its middle; where ``values`` is
    true in one colour, which a legend names.
    """
    across, up = map(np.unique, places)
    shown = values[np.lexsort(places)].reshape(up.size, across.size)
    if not colour:
        return [ax.pcolormesh(across, up, shown, cmap="viridis")]
    if not values.any():
        return []
    mesh = ax.pcolormesh(across, up, np.where(shown, 1.0, np.nan), cmap=ListedColormap([colour]))
    (entry,) = ax.plot([], [], "s", color=colour, markeredgecolor=GREY, label=name)
    return [mesh, entry]


def say(ax: Axes, text: str) -> None:
    """Write a text in the middle of an empty panel."""
    ax.text(0.5, 0.5, text, transform=ax.transAxes, ha="center", va="center", color=GREY)


def plain_ticks(axis: Axis, values: tuple[float, ...]) -> None:
    """Set ticks of a logarithmic axis at the given values, as plain numbers."""
    axis.set_major_locator(FixedLocator(values))
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("")


#: θ₀ of the paths a–a′ and b–b′.
PATHS_DEG = {"a": 60.0, "b": 40.0}

#: Letters of parameters in captions.
LETTERS = {"alpha": "α", "beta": "β", "kappa": "κ", "mu0": "μ₀", "sigma": "σ", "theta0": "θ₀"}

BASE_TEXT = ", ".join(
    f"{LETTERS[name]} = {getattr(Parameters, name):g}"
    for name in ("kappa", "alpha", "sigma", "beta")
)

LINES_TEXT = "Stable solid, divergent dashed, flutter dash-dotted; dots are folds."

RANGE_TEXT = "The ranges of the axes are our choice."


def symbol(name: str) -> str:
    """A name in LaTeX, without dollar signs: ``\\kappa``, ``k_{\\rm c}``, ``\\theta_0``."""
    base, _, index = name.partition("_")
    if numbered := re.fullmatch(r"([^\W\d]+)(\d)", base):
        if not index:
            return f"{symbol(numbered[1])}_{numbered[2]}"
        return f"{symbol(numbered[1])}_{{{numbered[2]}, {index}}}"
    # Greek letters for which LaTeX has commands.
    greek = (
        "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau "
        "upsilon phi chi psi omega Gamma Delta Theta Lambda Xi Sigma Upsilon Phi Psi Omega"
    )
    if base in greek.split():
        letter = rf"\{base}"
    else:
        letter = base if len(base) == 1 else rf"\mathrm{{{base}}}"
    return letter + (rf"_{{\rm {index}}}" if index else "")


def in_letters(scale: str) -> str:
    """The scale of a quantity, as ``L_0*sqrt(k_c)/sqrt(m)``, in LaTeX."""
    merged = re.sub(r"sqrt\((\w+)\)/sqrt\((\w+)\)", r"\\sqrt{\1/\2}", scale)
    return (
        re.sub(r"(?<!\\)sqrt\((.+?)\)", r"\\sqrt{\1}", merged)
        .replace("**", "^")
        .replace("*", r"\,")
    )


def label(column: Column, unit: str = "") -> str:
    """Symbol of a column with its unit; the default for angles is degrees."""
    letter = symbol(column.rate_of or column.name)
    if column.rate_of:
        letter = rf"\dot{{{letter}}}"
    unit = unit or ("deg" if column.is_angle else "")
    return f"${letter}$ ({unit})" if unit else f"${letter}$"


def own_unit(model: Model, column: Column) -> str:
    """Unit of a column in the model's units, as a label has it; empty for angles."""
    unit = "1" if column.name in model.parameters else model.unit(column.dimension)
    if column.is_angle or not unit:
        return ""
    return "dimensionless" if unit == "1" else f"units of ${in_letters(unit)}$"


#: Title of an axis, and the factor from the unit of the drawn values to that of the axis.
Shown = tuple[str, float]


class _Round(AutoLocator):
    """Ticks at round numbers in the unit of an axis, for values in another unit."""

    #: Factor from the unit of the values to that of the axis.
    one: float

    def tick_values(self, vmin: float, vmax: float) -> list[float]:
        return [tick / self.one for tick in super().tick_values(self.one * vmin, self.one * vmax)]


def in_units(axis: Axis, shown: Shown | None) -> None:
    """Show an axis in another unit than that of the drawn values; None changes nothing."""
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
    """Ranges of parameters to show: those given, else the parameter's own. An unbounded one ends
    where 1, twice the base value, all cusps, and the value in ``p`` are inside.
    """
    out = dict(between)
    for name in vary:
        if name not in between:
            own = p.ranges[name]
            low, high = own.low, own.high
            if np.isinf((low, high)).any():
                farthest = float(np.abs(cusps()[name]).max(initial=0.0)) if cusps else 0.0
                far = max(1.0, 2.0 * abs(p.model.base.get(name, 0.0)), 1.25 * farthest)
                if largest(p, name) >= far:
                    far = 2.0 * largest(p, name)
                low, high = -far if np.isinf(low) else low, far if np.isinf(high) else high
            out[name] = low, high
    return out


@styled
def write(figure: Sheet, folder: Path, stem: str, formats: Iterable[str] = ("pdf",)) -> list[Path]:
    """Write a figure to ``stem.pdf`` (and other formats), its caption to ``stem.txt``, and its data
    to ``stem_a.csv``, …; the paths.

    Rasterized parts have 300 dots per inch.
    """
    files: dict[str, bytes | str] = {f"{stem}.{kind}": picture(figure, kind) for kind in formats}
    files[f"{stem}.txt"] = textwrap.fill(figure.caption, 100) + "\n"
    files |= {f"{stem}_{panel}.csv": _table(table) for panel, table in figure.tables.items()}
    for name, content in files.items():
        put(folder / name, content, made=True)
    return [folder / name for name in files]


def picture(figure: Figure, kind: str, **options: Any) -> bytes:
    """A figure as bytes in a format, without date and version."""
    left_out = {
        "pdf": ("CreationDate", "Producer", "Creator"),
        "png": ("Software",),
        "svg": ("Date", "Creator"),
    }
    stream = io.BytesIO()
    figure.savefig(stream, format=kind, metadata=dict.fromkeys(left_out[kind]), **options)
    return stream.getvalue()


def _table(table: Table) -> str:
    """A table as CSV text; numbers with twelve digits."""
    text = io.StringIO(newline="")
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow(table)
    for row in zip(*(np.asarray(values).tolist() for values in table.values()), strict=True):
        writer.writerow([f"{value:.12g}" if isinstance(value, float) else value for value in row])
    return text.getvalue()
