"""The chart that carries the result: speed against error, the frontier drawn."""

from __future__ import annotations

import dataclasses
from typing import Any, Final

import matplotlib.pyplot as plt
import pandas as pd
from matplotlib.lines import Line2D

from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    Label,
    RateAxis,
    finish,
    isa_legend,
    label_column,
    per_second,
    style,
)
from analysis.peers.peer_marks import peer_marks, peer_names
from analysis.report.method_families import CLASSICS, in_order
from analysis.report.wording import listed, share, significant
from analysis.trust.noisy_marks import noise_legend, ring

_OTHERS = "#C4C4C4"


@dataclasses.dataclass(frozen=True)
class Words:
    """What a chart of speed against error is about."""

    key: str
    items: str  # what is decided
    error: str
    classics: tuple[str, ...]


POINTS: Final = Words("hero", "points", "wrong answers near an edge", tuple(CLASSICS))


def named(table: pd.DataFrame, words: Words = POINTS) -> set[str]:
    """The methods that the chart names: those of the frontier and classics."""
    front = set(table[table["on_frontier"]]["method"])
    return front | (set(words.classics) & set(table["method"]))


def hero(
    table: pd.DataFrame,
    scalar: str,
    footer: str,
    peers: pd.DataFrame | None = None,
    words: Words = POINTS,
) -> Chart:
    """Speed against error: one mark a method × ISA, the frontier drawn. Only
    the methods of the frontier and the classics are named and in colour; the
    table beside has the others.

    `table`: tables.speed_against_error, without rows whose error is unknown;
    `peers`: the same of other libraries, which have no part in the frontier.
    """
    beside = table.iloc[:0] if peers is None else peers
    marks = pd.concat([table, beside]) if len(beside) else table
    with style():
        figure, axes = plt.subplots(figsize=(10, 6.2))
        figure.subplots_adjust(left=0.1, right=0.735, top=0.885, bottom=0.2)
        rates = RateAxis(list(marks["error_rate"]), list(marks["error_rate_high"]))
        axes.set_xscale("log")
        labels = []
        known = named(table, words)
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
            ring(axes, rows, rows["items_per_second"], heights)
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
        peer_marks(axes, beside, rates)
        _frontier_line(axes, table, rates)
        rates.apply(axes, f"{words.error}, share (log scale)      ←  better")
        axes.set_xlabel(
            f"{words.items} decided per second, {scalar} (log scale)      better  →"
        )
        axes.margins(x=0.03)
        axes.autoscale_view()
        per_second(axes.xaxis)
        label_column(axes, labels)
        peer_names(axes, beside, rates)
        isas = sorted(marks["isa"].unique(), key=palette.isa_rank)
        more = [Line2D([], [], color=palette.INK, linewidth=1.4, label="frontier")]
        if not set(table["method"]) <= known:
            more.append(_legend_of_others())
        isa_legend(figure, isas, more)
        rings = noise_legend(table[table["method"].isin(known)])
        if rings:  # the row of the ISAs is full, that of the footer is not
            figure.legend(
                handles=rings,
                loc="lower right",
                bbox_to_anchor=(0.985, 0.0),
                fontsize=8.5,
                handletextpad=0.3,
            )
        front = table[table["on_frontier"]].sort_values("items_per_second")
        names = list(dict.fromkeys(reversed(list(front["method"]))))
        title = f"Speed against error, {scalar}: " + (
            f"{listed(names)} "
            + ("stand" if len(names) > 1 else "stands")
            + " on the frontier"
        )
        alt = f"{title}. " + " ".join(
            f"{row.method} on {row.isa}: {significant(row.items_per_second / 1e9)} "
            f"billion {words.items} per second, error rate {share(row.error_rate)}."
            for row in front.itertuples()
        )
        if len(beside):
            alt += f" Other libraries stand beside: {listed(list(beside['method']))}."
        return finish(figure, f"{words.key}-{scalar}", title, alt, footer)


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
