"""The charts of accuracy against what makes a scene hard.

A panel a family of methods: the lines of all methods in one panel could not be
told apart. The others stay in sight as thin grey lines.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from analysis.accuracy.hardness import Hardness
from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    Label,
    RateAxis,
    finish,
    label_column,
    style,
    ticks_at,
)
from analysis.report.method_families import by_family, in_order
from analysis.report.wording import listed, share

# Inches.
_WIDTH, _LEFT, _PANEL, _COLUMN = 11.0, 0.95, 2.7, 5.2
_TOP, _BOTTOM, _GAP = 0.95, 0.75, 0.34


def errors_along(
    tables: dict[str, pd.DataFrame], hardness: Hardness, isa: str, footer: str
) -> Chart:
    """Error rate against the parameter: one line a method with its Wilson
    band, a column of panels a scalar and a row a family of methods. `tables`:
    scalar → errors_along, none empty.
    """
    scalars = sorted(tables)
    everything = pd.concat([tables[scalar] for scalar in scalars])
    rates = RateAxis(
        list(everything["error_rate"]), list(everything["error_rate_high"])
    )
    families = by_family(everything["method"])
    heights = [max(1.2, 0.145 * len(members)) for _, members in families]
    panel = _PANEL if len(scalars) > 1 else _PANEL + _COLUMN
    height = _TOP + sum(heights) + _GAP * (len(heights) - 1) + _BOTTOM
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        low = height - _TOP
        for row, (family, members) in enumerate(families):
            low -= heights[row]
            for column, scalar in enumerate(scalars):
                axes = figure.add_axes(
                    (
                        (_LEFT + column * _COLUMN) / _WIDTH,
                        low / height,
                        panel / _WIDTH,
                        heights[row] / height,
                    )
                )
                _panel(axes, tables[scalar], members, hardness, rates)
                if row < len(families) - 1:
                    axes.tick_params(labelbottom=False)
                else:
                    axes.set_xlabel(hardness.axis_label, fontsize=8.5)
                title = f"{family.title}, {scalar}"
                axes.set_title(title, loc="left", fontsize=8.5, weight="bold", pad=3)
            low -= _GAP
        figure.text(
            0.012,
            0.5,
            "wrong answers, share (log scale)      ←  better",
            rotation=90,
            va="center",
        )
        title = _title(tables[scalars[0]], hardness, scalars[0])
        alt = f"{title}. " + " ".join(
            f"{scalar}: " + _extremes(tables[scalar]) for scalar in scalars
        )
        return finish(figure, f"errors-{hardness.family}", title, alt, footer)


def _panel(
    axes: Any,
    table: pd.DataFrame,
    members: list[str],
    hardness: Hardness,
    rates: RateAxis,
) -> None:
    place = hardness.places(table["at"])
    own = table[table["method"].isin(members)]
    _others_in_grey(axes, table[~table["method"].isin(members)], rates, place)
    for method in in_order(own["method"]):
        rows = own[own["method"] == method]
        look = palette.method_style(method)
        at = [place(value) for value in rows["at"]]
        _band(axes, at, rows, rates, look)
        axes.plot(
            at,
            [rates.at(rate) for rate in rows["error_rate"]],
            color=look.colour,
            linestyle=look.dash,
            linewidth=1.4,
            marker="o",
            markersize=2.6,
            markerfacecolor="white" if look.variant else look.colour,
            zorder=3,
        )
    _zero_whiskers(axes, own, rates, place)
    values = sorted(table["at"].unique())
    shown = values[:: max(1, -(-len(values) // 8))]
    names = {place(value): hardness.named(value) for value in shown}
    ticks_at(axes.xaxis, lambda position: names.get(position, ""), list(names))
    axes.tick_params(labelsize=7.5)
    axes.margins(x=0.03)
    if hardness.harder == "falls":
        axes.invert_xaxis()
    rates.apply(axes, "")
    label_column(axes, _labels(own, hardness, rates, place), size=7.2)


def _others_in_grey(
    axes: Any, table: pd.DataFrame, rates: RateAxis, place: Callable[[float], float]
) -> None:
    """All in one line with gaps, and those that are the same once."""
    at: list[float] = []
    heights: list[float] = []
    drawn = set()
    for method in in_order(table["method"]):
        rows = table[table["method"] == method]
        line = tuple(zip(rows["at"], rows["error_rate"]))
        if line in drawn:
            continue
        drawn.add(line)
        at += [*(place(value) for value in rows["at"]), math.nan]
        heights += [*(rates.at(rate) for rate in rows["error_rate"]), math.nan]
    axes.plot(at, heights, color="#DADADA", linewidth=0.6, zorder=1)


def _zero_whiskers(
    axes: Any, table: pd.DataFrame, rates: RateAxis, place: Callable[[float], float]
) -> None:
    """From the lane of zeros, whose place is no number, up to the largest rate
    that they leave possible: one whisker for all methods at a value.
    """
    zeros = table[table["error_rate"] == 0].groupby("at")["error_rate_high"].max()
    axes.vlines(
        [place(at) for at in zeros.index],
        rates.zero,
        [min(high, rates.top) for high in zeros],
        color=palette.FAINT,
        linewidth=0.9,
        zorder=1,
    )


def _band(
    axes: Any,
    at: list[float],
    rows: pd.DataFrame,
    rates: RateAxis,
    look: palette.MethodStyle,
) -> None:
    """The Wilson interval along the rates that are drawn to scale."""
    positive = [rate > 0 for rate in rows["error_rate"]]
    axes.fill_between(
        at,
        [max(low, rates.bottom) for low in rows["error_rate_low"]],
        [min(high, rates.top) for high in rows["error_rate_high"]],
        where=positive,
        color=look.colour,
        alpha=0.14,
        linewidth=0,
    )


def _labels(
    table: pd.DataFrame,
    hardness: Hardness,
    rates: RateAxis,
    place: Callable[[float], float],
) -> list[Label]:
    labels = []
    for method in in_order(table["method"]):
        rows = table[table["method"] == method].sort_values("at")
        last = rows.iloc[0 if hardness.harder == "falls" else -1]
        look = palette.method_style(method)
        labels.append(
            Label(
                place(last["at"]),
                rates.at(last["error_rate"]),
                method,
                look.colour,
                dash=look.dash,
            )
        )
    return labels


def _title(table: pd.DataFrame, hardness: Hardness, scalar: str) -> str:
    worst = table[table["accepts"] == "triangle"].groupby("method")["error_rate"].max()
    clean = [m for m in sorted(worst.index, key=palette.method_rank) if worst[m] == 0]
    if len(worst) and len(clean) == len(worst):
        tail = f"no method errs ({scalar})"
    elif 0 < len(clean) <= 2:
        tail = f"only {listed(clean)} never err" + ("s" if len(clean) == 1 else "")
        tail += f" ({scalar})"
    elif clean:
        tail = f"{len(clean)} of {len(worst)} methods never err ({scalar})"
    else:
        tail = f"every method errs somewhere ({scalar})"
    return f"Errors as the {hardness.what} {hardness.harder}: {tail}"


def _extremes(table: pd.DataFrame) -> str:
    worst = table.groupby("method")["error_rate"].max().sort_values()
    return (
        "; ".join(
            f"{method} errs on {share(rate)} at most" for method, rate in worst.items()
        )
        + "."
    )
