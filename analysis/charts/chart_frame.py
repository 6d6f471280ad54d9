"""What all charts share: size, type, footer, and labels that keep apart."""

from __future__ import annotations

import dataclasses
import functools
import io
import math
import textwrap
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from typing import Any

import matplotlib

matplotlib.use("agg")

import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402
from matplotlib.ticker import FixedLocator, FuncFormatter, NullLocator  # noqa: E402

from analysis.charts.palette import GRID, INK, isa_marker  # noqa: E402
from analysis.charts.small_svg import inline  # noqa: E402

# hashsalt: the same data gives the same bytes. Words stay words; the page brings
# the letters with it (chart_font.py).
_STYLE = {
    "svg.hashsalt": "pitbench",
    "svg.fonttype": "none",
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "text.color": INK,
    "axes.edgecolor": "#8A8A8A",
    "axes.labelcolor": INK,
    "axes.labelsize": 9.5,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": True,
    "axes.axisbelow": True,
    "grid.color": GRID,
    "grid.linewidth": 0.7,
    "xtick.color": INK,
    "ytick.color": INK,
    "xtick.major.size": 3,
    "ytick.major.size": 3,
    "legend.frameon": False,
    "path.simplify": False,
}
_DPI = 100
_TALL = 9  # inches; above, a PNG at twice the size is larger than a screen shows


@dataclasses.dataclass(frozen=True)
class Chart:
    """A finished chart: its words, and its picture, which is drawn in a format
    when that is first asked for.
    """

    key: str
    title: str
    alt: str
    figure: Figure

    @functools.cached_property
    def svg(self) -> str:
        """An element to stand in a page."""
        drawn = io.StringIO()
        with style():
            self.figure.savefig(
                drawn, format="svg", metadata={"Date": None, "Creator": None}
            )
        return inline(drawn.getvalue(), self.key)

    @functools.cached_property
    def png(self) -> bytes:
        drawn = io.BytesIO()
        dpi = _DPI if self.figure.get_figheight() > _TALL else 2 * _DPI
        with style():
            self.figure.savefig(
                drawn, format="png", dpi=dpi, metadata={"Software": None}
            )
        return drawn.getvalue()


@contextmanager
def style() -> Iterator[None]:
    """Every figure is made inside this; other settings do not leak in."""
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.use("agg")
        matplotlib.rcParams.update(_STYLE)
        yield


def finish(figure: Any, key: str, title: str, alt: str, footer: str) -> Chart:
    """Adds title and footer; the figure is then the chart's alone. Leave 0.7
    inches free above for a title of two lines and 0.3 below.
    """
    width, height = figure.get_size_inches()
    figure.suptitle(
        textwrap.fill(title, round(10.1 * width)),
        x=0.012,
        y=1 - 0.1 / height,
        ha="left",
        va="top",
        fontsize=11.5,
        weight="bold",
        linespacing=1.25,
    )
    figure.text(
        0.012,
        0.07 / height,
        footer,
        ha="left",
        va="bottom",
        fontsize=7.5,
        color="#666666",
    )
    plt.close(figure)
    return Chart(key, title, alt, figure)


def spread(
    positions: Sequence[float], gap: float, low: float, high: float
) -> list[float]:
    """Positions moved as little as possible (least squares) so that they stand
    at least `gap` apart, in their order, and within [low, high] if they fit.
    """
    order = sorted(range(len(positions)), key=lambda i: (positions[i], i))
    blocks: list[list[float]] = []  # [sum, count] of positions less their place
    for place, index in enumerate(order):
        blocks.append([positions[index] - place * gap, 1.0])
        while (
            len(blocks) > 1
            and blocks[-2][0] / blocks[-2][1] > blocks[-1][0] / blocks[-1][1]
        ):
            total, count = blocks.pop()
            blocks[-1][0] += total
            blocks[-1][1] += count
    levels = [total / count for total, count in blocks for _ in range(int(count))]
    room = high - low - gap * (len(positions) - 1)
    moved = [0.0] * len(positions)
    for place, index in enumerate(order):
        level = min(max(levels[place], low), low + max(room, 0.0))
        moved[index] = level + place * gap
    return moved


@dataclasses.dataclass(frozen=True)
class Label:
    """A text for the column beside an axes, and the point that it is about."""

    x: float
    y: float
    text: str
    colour: str
    bold: bool = False
    dash: str = "-"


def label_column(axes: Any, labels: Sequence[Label], size: float = 8.5) -> None:
    """Writes the labels in a column right of the axes, each beside its point,
    none upon another, with a thin line from point to label.
    """
    box = axes.get_window_extent()
    gap = size * 1.32 / 72 * axes.figure.dpi / box.height
    to_axes = axes.transData + axes.transAxes.inverted()
    points = [to_axes.transform((label.x, label.y)) for label in labels]
    heights = spread([point[1] for point in points], gap, 0.0, 1.0)
    for label, point, height in zip(labels, points, heights, strict=True):
        axes.plot(
            [point[0], 1.012, 1.028],
            [point[1], height, height],
            transform=axes.transAxes,
            color=label.colour,
            linewidth=0.7,
            alpha=0.55,
            linestyle=label.dash,
            clip_on=False,
            zorder=1,
        )
        axes.text(
            1.033,
            height,
            label.text,
            transform=axes.transAxes,
            color=label.colour,
            fontsize=size,
            weight="bold" if label.bold else "normal",
            va="center_baseline",
        )


def isa_legend(figure: Any, isas: Sequence[str], more: Sequence[Any] = ()) -> None:
    """The marks of the ISAs in a row below the axes, and `more` behind them."""
    marks = {isa: isa_marker(isa) for isa in isas}
    handles = [
        Line2D(
            [],
            [],
            linestyle="",
            marker=marker,
            markersize=9 if marker == "*" else 6,
            color="#666666",
            label=isa,
        )
        for isa, marker in marks.items()
    ]
    handles.extend(more)
    figure.legend(
        handles=handles,
        loc="lower left",
        bbox_to_anchor=(0.075, 0.26 / figure.get_size_inches()[1]),
        ncol=len(handles),
        fontsize=8.5 if len(handles) <= 10 else 8.0,
        handletextpad=0.3,
        columnspacing=1.2 if len(handles) <= 10 else 0.6,
    )


class RateAxis:
    """A logarithmic axis of shares with a lane for exact zeros below it."""

    def __init__(self, rates: Sequence[float], highs: Sequence[float]) -> None:
        """`highs`: upper ends of the intervals of the rates."""
        shown = [rate for rate in rates if rate > 0]
        shown += [h for r, h in zip(rates, highs, strict=True) if r == 0 and h > 0]
        smallest = min(shown, default=1e-6)
        largest = max(shown, default=1.0)
        self.has_zeros = any(rate == 0 for rate in rates)
        self.floor = 10.0 ** math.floor(math.log10(smallest))
        self.top = min(10.0 ** math.ceil(math.log10(largest) + 0.05), 1.3)
        self.zero = self.floor / 10**0.6
        self.bottom = self.zero / 10**0.4 if self.has_zeros else self.floor

    def at(self, rate: float) -> float:
        """Where a rate is drawn: zeros in their lane."""
        return self.zero if rate <= 0 else max(rate, self.bottom)

    def whiskers(self, rate: float, low: float, high: float) -> tuple[float, float]:
        """Lengths of the whiskers below and above the mark."""
        here = self.at(rate)
        below = 0.0 if rate <= 0 else here - max(low, self.bottom)
        return (max(below, 0.0), max(min(high, self.top) - here, 0.0))

    def apply(self, axes: Any, label: str) -> None:
        axes.set_yscale("log")
        axes.set_ylim(self.bottom, self.top)
        first, last = round(math.log10(self.floor)), math.floor(math.log10(self.top))
        ticks = [10.0**e for e in range(first, last + 1)]
        step = 1 if len(ticks) <= 8 else 2
        ticks = ticks[::-1][::step][::-1]
        names = {tick: _share_tick(tick) for tick in ticks}
        if self.has_zeros:
            names[self.zero] = "none"
            axes.axhspan(self.bottom, self.floor / 10**0.2, color="#F2F2F2", zorder=0)
        axes.yaxis.set_major_locator(FixedLocator(sorted(names)))
        axes.yaxis.set_minor_locator(NullLocator())
        axes.yaxis.set_major_formatter(
            FuncFormatter(lambda value, _: names.get(value, ""))
        )
        axes.set_ylabel(label)


def _share_tick(value: float) -> str:
    if value >= 0.0009:
        return f"{100 * value:g} %"
    return f"{1e6 * value:g} ppm"


def per_second(axis: Any) -> None:
    """Ticks of an axis of items a second: 100 M, 1 G."""

    def name(value: float, _: Any) -> str:
        for unit, size in (("G", 1e9), ("M", 1e6), ("k", 1e3)):
            if value >= 0.999 * size:
                return f"{value / size:g} {unit}"
        return f"{value:g}"

    low, high = axis.get_view_interval()
    steps = (1, 2, 5) if high / low < 300 else (1,)
    ticks = [m * 10.0**e for e in range(0, 16) for m in steps]
    axis.set_major_locator(FixedLocator([t for t in ticks if low <= t <= high]))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(name))


def ticks_at(axis: Any, name: Callable[[float], str], ticks: Sequence[float]) -> None:
    axis.set_major_locator(FixedLocator(list(ticks)))
    axis.set_minor_locator(NullLocator())
    axis.set_major_formatter(FuncFormatter(lambda value, _: name(value)))
