"""The roofline: what a method reaches, under what the machine can do.

Across: operations for each byte read, a property of the method. Upwards:
operations a second. Memory that delivers B bytes a second is a slope through
the origin, B · intensity; arithmetic is a level roof (Williams, Waterman and
Patterson 2009). Both axes are logarithmic, so slopes are parallel.
"""

from __future__ import annotations

import math
from typing import Any, Final

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    Label,
    finish,
    label_column,
    per_second,
    style,
    ticks_at,
)
from analysis.read.limits import Limits
from analysis.report.method_families import CLASSICS, in_order
from analysis.report.wording import significant
from analysis.speed.tables import reference_cells, widest_isa

LOOPS: Final = ("one_triangle", "one_point")
_WIDTH, _HEIGHT = 11.0, 5.4
_OTHERS: Final = "#C4C4C4"
_SLOPES: Final = ("-", "--", "-.", ":")  # of the levels, nearest first


def marks(cells: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """The cells of the loops' reference scenes at the widest ISA of which the
    operations were counted, with `intensity` (operations a byte) and
    `operations_per_second` with its interval.
    """
    if "operations_per_item" not in cells:
        return cells.iloc[:0]
    parts = []
    for loop in LOOPS:
        rows = reference_cells(cells, scalar, loop)
        rows = rows[rows["operations_per_item"] > 0]
        parts.append(rows[rows["isa"] == widest_isa(rows)])
    joined = pd.concat([cells.iloc[:0], *parts], ignore_index=True)
    each = joined["operations_per_item"].astype(float)
    return joined.assign(
        intensity=each / joined["bytes_per_item"],
        operations_per_second=each * joined["items_per_second"],
        operations_per_second_low=each * joined["items_per_second_low"],
        operations_per_second_high=each * joined["items_per_second_high"],
    )


def roofs(limits: Limits, scalar: str) -> list[tuple[str, float]]:
    """(ISA, most operations a second of any kinds), lowest first; an ISA that
    adds nothing over the one before is left out.
    """
    isas = sorted(limits.operations["isa"].unique(), key=palette.isa_rank)
    found: list[tuple[str, float]] = []
    for isa in isas:
        rate = limits.total_rate(isa, scalar)
        if rate == rate and (not found or rate > 1.2 * found[-1][1]):
            found.append((isa, rate))
    return found


def slopes(limits: Limits, isa: str, scalar: str) -> list[tuple[str, float]]:
    """(level, bytes a second) of loads, nearest first."""
    found = [
        (level.name, limits.bandwidth(isa, scalar, level.name))
        for level in limits.levels
    ]
    return [(name, value) for name, value in found if value == value]


def roofline(table: pd.DataFrame, limits: Limits, scalar: str, footer: str) -> Chart:
    """A panel a loop. `table`: marks, not empty."""
    loops = [loop for loop in LOOPS if loop in set(table["loop"])]
    isa = str(table["isa"].iloc[0])
    tops = roofs(limits, scalar)
    sides = slopes(limits, isa, scalar)
    low_x = min(0.2, 0.7 * float(table["intensity"].min()))
    high_x = max(8.0, 1.6 * float(table["intensity"].max()))
    shown = [float(table["operations_per_second"].min()), *(rate for _, rate in tops)]
    low_y, high_y = 0.5 * min(shown), 1.6 * max(shown)
    with style():
        figure = plt.figure(figsize=(_WIDTH, _HEIGHT))
        for column, loop in enumerate(loops):
            axes = figure.add_axes(
                ((0.75 + 5.25 * column) / _WIDTH, 0.135, 2.95 / _WIDTH, 0.7)
            )
            axes.set_xscale("log")
            axes.set_yscale("log")
            axes.set_xlim(low_x, high_x)
            axes.set_ylim(low_y, high_y)
            _draw_roofs(axes, tops, sides, limits.rate(isa, scalar, "multiply_add"))
            _draw_marks(axes, table[table["loop"] == loop])
            axes.set_title(f"{loop}, {isa}", loc="left", fontsize=9, weight="bold")
            axes.set_xlabel("operations a byte read (log scale)", fontsize=8.5)
            ticks_at(axes.xaxis, lambda v: f"{v:g}", _ticks(low_x, high_x))
            per_second(axes.yaxis)
            if column == 0:
                axes.set_ylabel(
                    f"operations a second, {scalar} (log scale)      better  →"
                )
        title = _title(table, scalar, isa)
        alt = f"{title}. " + " ".join(
            f"{row.method}, {row.loop}: {significant(row.operations_per_second / 1e9)} "
            f"billion operations a second at {significant(row.intensity)} a byte."
            for row in table.itertuples()
            if row.method in CLASSICS
        )
        return finish(figure, f"roofline-{scalar}", title, alt, footer)


def _title(table: pd.DataFrame, scalar: str, isa: str) -> str:
    start = f"How far below the roof, {scalar} on {isa}"
    sound = table[(table["loop"] == LOOPS[0]) & ~table["beaten"].astype(bool)]
    if not len(sound):
        return start
    best = sound.loc[sound["ns"].idxmin()]
    return (
        f"{start}: {best['method']}, the fastest in {LOOPS[0]}, reaches "
        f"{significant(100 * best['of_limit'])} % of its bound"
    )


def _draw_roofs(
    axes: Any,
    tops: list[tuple[str, float]],
    sides: list[tuple[str, float]],
    multiply_add: float,
) -> None:
    low_x, high_x = axes.get_xlim()
    low_y, _ = axes.get_ylim()
    highest = max(rate for _, rate in tops)
    widest = max((bandwidth for _, bandwidth in sides), default=math.nan)
    for isa, rate in tops:
        start = rate / widest if widest == widest else low_x
        axes.plot([max(start, low_x), high_x], [rate, rate], color="#555555", lw=1.1)
        axes.annotate(isa, (high_x, rate), (-3, 2), textcoords="offset points", **_TEXT)
    if multiply_add < 0.95 * highest:  # else the roof is that of multiply-adds
        start = max(multiply_add / widest, low_x) if widest == widest else low_x
        axes.plot(
            [start, high_x],
            [multiply_add, multiply_add],
            color="#8A8A8A",
            lw=0.8,
            dashes=(5, 3),
        )
        room_above = all(not 1 <= rate / multiply_add < 1.25 for _, rate in tops)
        axes.annotate(
            "multiply-adds alone",
            (high_x, multiply_add),
            (-3, 2 if room_above else -2),
            textcoords="offset points",
            **(_TEXT | {"va": "bottom" if room_above else "top"}),
        )
    box = axes.get_window_extent()
    steep = math.atan(
        (box.height / math.log(axes.get_ylim()[1] / low_y))
        / (box.width / math.log(high_x / low_x))
    )
    for place, (level, bandwidth) in enumerate(sides):
        ends = (max(low_x, low_y / bandwidth), min(high_x, highest / bandwidth))
        if ends[0] >= ends[1]:
            continue
        axes.plot(
            ends,
            [bandwidth * x for x in ends],
            color="#9A9A9A",
            lw=0.9,
            linestyle=_SLOPES[min(place, len(_SLOPES) - 1)],
        )
        # Below its line, where the one below leaves room; else above it, and as
        # much further along as keeps it off the axis.
        crowded = any(bandwidth / 1.6 < other < bandwidth for _, other in sides)
        along, across = (17, 2) if crowded else (5, -2)
        axes.annotate(
            f"{level} {significant(bandwidth / 1e9)} GB/s",
            (ends[0], bandwidth * ends[0]),
            (
                along * math.cos(steep) - across * math.sin(steep),
                along * math.sin(steep) + across * math.cos(steep),
            ),
            textcoords="offset points",
            rotation=math.degrees(steep),
            va="bottom" if crowded else "top",
            rotation_mode="anchor",
            fontsize=7,
            color="#666666",
        )


_TEXT: Final = {"fontsize": 7, "color": "#555555", "ha": "right", "va": "bottom"}


def _draw_marks(axes: Any, rows: pd.DataFrame) -> None:
    labels = []
    for method in in_order(rows["method"]):
        own = rows[rows["method"] == method].iloc[0]
        known = method in CLASSICS
        look = palette.method_style(method)
        colour = look.colour if known else _OTHERS
        value = own["operations_per_second"]
        axes.errorbar(
            [own["intensity"]],
            [value],
            yerr=[
                [value - own["operations_per_second_low"]],
                [own["operations_per_second_high"] - value],
            ],
            fmt="o",
            markersize=5.5 if known else 4,
            color=colour,
            markerfacecolor="white" if look.variant and known else colour,
            elinewidth=0.9,
            zorder=4 if known else 3,
        )
        if known:
            text = f"{method} {significant(100 * own['of_limit'], 2)} %"
            labels.append(
                Label(own["intensity"], value, text, look.colour, dash=look.dash)
            )
    label_column(axes, labels, size=8)


def _ticks(low: float, high: float) -> list[float]:
    every = [m * 10.0**e for e in range(-3, 5) for m in (1, 2, 5)]
    inside = [tick for tick in every if low <= tick <= high]
    return inside if len(inside) <= 7 else [t for t in inside if f"{t:e}"[0] == "1"]
