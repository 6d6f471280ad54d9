"""The charts of accuracy against what makes a scene hard."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from analysis import palette
from analysis.chart_frame import (
    Chart,
    Label,
    RateAxis,
    finish,
    label_column,
    style,
    ticks_at,
)
from analysis.wording import listed, plain, power_of_two, share


@dataclasses.dataclass(frozen=True)
class Hardness:
    """A family of scenes and the parameter that makes its members harder."""

    family: str
    key: str
    axis: str
    what: str
    harder: str  # "falls" or "grows": which way the parameter makes it hard
    is_power: bool  # the parameter is an exponent of two
    worded: str  # a value of it in a sentence

    def words(self, value: float) -> str:
        """A value of the parameter as a sentence has it."""
        return self.worded.format(
            power_of_two(value) if self.is_power else plain(value)
        )


HARDNESSES = (
    Hardness(
        "near_edge",
        "ulps",
        "distance from the edge, in ulps",
        "distance from the edge",
        "falls",
        False,
        "{} ulps",
    ),
    Hardness(
        "needle",
        "aspect",
        "length of the triangle over height",
        "aspect of a needle",
        "grows",
        True,
        "an aspect of {}",
    ),
    Hardness(
        "offset",
        "ratio",
        "distance from the origin over size",
        "distance from the origin",
        "grows",
        True,
        "{} sizes",
    ),
)


def errors_along(
    tables: dict[str, pd.DataFrame], hardness: Hardness, isa: str, footer: str
) -> Chart:
    """Error rate against the parameter: one line a method with its Wilson
    band, one panel a scalar. `tables`: scalar → errors_along, none empty.
    """
    scalars = sorted(tables)
    everything = pd.concat([tables[scalar] for scalar in scalars])
    rates = RateAxis(
        list(everything["error_rate"]), list(everything["error_rate_high"])
    )
    with style():
        figure = plt.figure(figsize=(11, 4.7))
        for index, scalar in enumerate(scalars):
            axes = figure.add_axes((0.085 + 0.49 * index, 0.175, 0.24, 0.63))
            _panel(axes, tables[scalar], hardness, rates)
            rates.apply(
                axes,
                "wrong answers, share (log scale)   ←  better" if index == 0 else "",
            )
            axes.set_title(scalar, loc="left", fontsize=9.5, weight="bold", pad=4)
            label_column(axes, _labels(tables[scalar], hardness, rates), size=7.6)
        title = _title(tables[scalars[0]], hardness, scalars[0])
        alt = f"{title}. " + " ".join(
            f"{scalar}: " + _extremes(tables[scalar]) for scalar in scalars
        )
        return finish(figure, f"errors-{hardness.family}", title, alt, footer)


def _panel(axes: Any, table: pd.DataFrame, hardness: Hardness, rates: RateAxis) -> None:
    place = _places(table, hardness)
    for method in sorted(table["method"].unique(), key=palette.method_rank):
        rows = table[table["method"] == method]
        look = palette.method_style(method)
        at = [place(value) for value in rows["at"]]
        _band(axes, at, rows, rates, look)
        axes.plot(
            at,
            [rates.at(rate) for rate in rows["error_rate"]],
            color=look.colour,
            linestyle=look.dash,
            linewidth=1.5,
            marker="o",
            markersize=3,
            markerfacecolor="white" if look.variant else look.colour,
        )
    _zero_whiskers(axes, table, rates, place)
    values = sorted(table["at"].unique())
    shown = values[:: max(1, -(-len(values) // 8))]
    name: Callable[[float], str] = power_of_two if hardness.is_power else plain
    names = {place(value): name(value) for value in shown}
    ticks_at(axes.xaxis, lambda position: names.get(position, ""), list(names))
    axes.set_xlabel(f"{hardness.axis} (log scale)   harder →", fontsize=8.5)
    axes.margins(x=0.03)
    if hardness.harder == "falls":
        axes.invert_xaxis()


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


def _places(table: pd.DataFrame, hardness: Hardness) -> Callable[[float], float]:
    """Where a value of the parameter stands on the axis: at its logarithm, and
    0, which has none, one step before the smallest.
    """
    positive = [value for value in table["at"] if value > 0]
    smallest = min(positive, default=1.0)
    if hardness.is_power:
        return lambda value: value
    return lambda value: math.log2(value) if value > 0 else math.log2(smallest) - 1


def _labels(table: pd.DataFrame, hardness: Hardness, rates: RateAxis) -> list[Label]:
    place = _places(table, hardness)
    labels = []
    for method in sorted(table["method"].unique(), key=palette.method_rank):
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
