"""The chart that carries the result: speed against error, the frontier drawn."""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.lines import Line2D

from analysis import palette
from analysis.chart_frame import (
    Chart,
    Label,
    RateAxis,
    finish,
    isa_legend,
    label_column,
    per_second,
    style,
)
from analysis.method_families import CLASSICS, in_order
from analysis.wording import listed, share, significant

_OTHERS = "#C4C4C4"


def named(table: pd.DataFrame) -> set[str]:
    """The methods that the chart names: those of the frontier and classics."""
    front = set(table[table["on_frontier"]]["method"])
    return front | (set(CLASSICS) & set(table["method"]))


def hero(table: pd.DataFrame, scalar: str, footer: str) -> Chart:
    """Speed against error: one mark a method × ISA, the frontier drawn. Only
    the methods of the frontier and the classics are named and in colour; the
    table beside has the others.

    `table`: tables.speed_against_error, without rows whose error is unknown.
    """
    with style():
        figure, axes = plt.subplots(figsize=(10, 6.2))
        figure.subplots_adjust(left=0.1, right=0.735, top=0.885, bottom=0.2)
        rates = RateAxis(list(table["error_rate"]), list(table["error_rate_high"]))
        axes.set_xscale("log")
        labels = []
        known = named(table)
        for method in in_order(table["method"]):
            rows = table[table["method"] == method].sort_values("items_per_second")
            if method not in known:
                _faint_marks(axes, rows, rates)
                continue
            look = palette.method_style(method)
            heights = [rates.at(rate) for rate in rows["error_rate"]]
            axes.plot(
                rows["items_per_second"],
                heights,
                color=look.colour,
                linestyle=look.dash,
                linewidth=0.8,
                alpha=0.25,
                zorder=2,
            )
            for row in rows.itertuples():
                _hero_mark(axes, row, rates, look)
            best = rows.iloc[-1]
            labels.append(
                Label(
                    best["items_per_second"],
                    rates.at(best["error_rate"]),
                    method,
                    look.colour,
                    bold=bool(rows["on_frontier"].any()),
                    dash=look.dash,
                )
            )
        _frontier_line(axes, table, rates)
        rates.apply(
            axes, "wrong answers near an edge, share (log scale)      ←  better"
        )
        axes.set_xlabel(
            f"points decided per second, {scalar} (log scale)      better  →"
        )
        axes.margins(x=0.03)
        axes.autoscale_view()
        per_second(axes.xaxis)
        label_column(axes, labels)
        isas = sorted(table["isa"].unique(), key=palette.isa_rank)
        more = [Line2D([], [], color=palette.INK, linewidth=1.4, label="frontier")]
        if not set(table["method"]) <= known:
            more.append(_legend_of_others())
        isa_legend(figure, isas, more)
        front = table[table["on_frontier"]].sort_values("items_per_second")
        names = list(dict.fromkeys(reversed(list(front["method"]))))
        title = f"Speed against error, {scalar}: " + (
            f"{listed(names)} "
            + ("stand" if len(names) > 1 else "stands")
            + " on the frontier"
        )
        alt = f"{title}. " + " ".join(
            f"{row.method} on {row.isa}: {significant(row.items_per_second / 1e9)} "
            f"billion points per second, error rate {share(row.error_rate)}."
            for row in front.itertuples()
        )
        return finish(figure, f"hero-{scalar}", title, alt, footer)


def _faint_marks(axes: Any, rows: pd.DataFrame, rates: RateAxis) -> None:
    """The marks of a method that is not named, below all others."""
    for row in rows.itertuples():
        axes.plot(
            [row.items_per_second],
            [rates.at(row.error_rate)],
            marker=palette.isa_marker(row.isa),
            markersize=4.5,
            color=_OTHERS,
            linestyle="",
            zorder=1.5,
        )


def _legend_of_others() -> Any:
    return Line2D(
        [],
        [],
        color=_OTHERS,
        marker="o",
        markersize=4.5,
        linestyle="",
        label="other methods",
    )


def _hero_mark(axes: Any, row: Any, rates: RateAxis, look: palette.MethodStyle) -> None:
    marker = palette.isa_marker(row.isa)
    strong = bool(row.on_frontier)
    below, above = rates.whiskers(
        row.error_rate, row.error_rate_low, row.error_rate_high
    )
    axes.errorbar(
        [row.items_per_second],
        [rates.at(row.error_rate)],
        xerr=[
            [row.items_per_second - row.items_per_second_low],
            [row.items_per_second_high - row.items_per_second],
        ],
        yerr=[[below], [above]],
        fmt=marker,
        markersize=(12 if marker == "*" else 8)
        if strong
        else 9
        if marker == "*"
        else 5.5,
        color=look.colour,
        markerfacecolor="white" if look.variant else look.colour,
        markeredgecolor=palette.INK if strong and not look.variant else look.colour,
        markeredgewidth=0.9 if not strong else 1.9 if look.variant else 1.2,
        elinewidth=0.9,
        alpha=1.0 if strong else 0.4,
        zorder=5 if strong else 3,
    )


def _frontier_line(axes: Any, table: pd.DataFrame, rates: RateAxis) -> None:
    front = table[table["on_frontier"]].sort_values("items_per_second")
    if len(front):
        axes.step(
            front["items_per_second"],
            [rates.at(rate) for rate in front["error_rate"]],
            where="pre",
            color=palette.INK,
            linewidth=1.4,
            zorder=4,
        )
