"""The charts of speed. Each takes a finished table and draws it, no more.

Titles carry the message of the chart and are computed from the same table.
"""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    finish,
    isa_legend,
    style,
    ticks_at,
)
from analysis.report.method_families import in_order
from analysis.report.wording import (
    between,
    listed,
    nanoseconds,
    significant,
    times,
    with_interval,
)
from analysis.trust.noisy_marks import noise_legend, ring


def scaling(table: pd.DataFrame, scalar: str, footer: str) -> Chart:
    """How many times as fast as its scalar row each ISA is, a row a method.

    `table`: tables.reference_cells.
    """
    methods = in_order(table["method"])
    isas = sorted(table["isa"].unique(), key=palette.isa_rank)
    rows = table.dropna(subset=["times_scalar"])
    places = {method: -index for index, method in enumerate(methods)}
    with style():
        height = 1.95 + 0.225 * len(methods)
        figure, axes = plt.subplots(figsize=(10, height))
        figure.subplots_adjust(
            left=0.27, right=0.97, top=1 - 0.75 / height, bottom=1.05 / height
        )
        for isa in isas:
            _scaling_marks(axes, rows[rows["isa"] == isa], isa, places)
        best = rows.loc[rows.groupby("method")["times_scalar"].idxmax()]
        top = float(rows["times_scalar_high"].max())
        for row in best.itertuples():
            axes.text(
                row.times_scalar_high + 0.015 * top,
                places[row.method],
                significant(row.times_scalar),
                va="center_baseline",
                fontsize=7.5,
            )
        axes.set_xlim(0, top * 1.09)
        axes.set_yticks(list(places.values()), methods, fontsize=8)
        for tick, method in zip(axes.get_yticklabels(), methods):
            tick.set_color(palette.method_style(method).colour)
        axes.set_ylim(-len(methods) + 0.4, 0.6)
        axes.tick_params(axis="y", length=0)
        axes.set_xlabel(f"times as fast as the scalar row, {scalar}      better →")
        isa_legend(figure, isas, noise_legend(rows))
        widest = rows[~rows["isa"].map(palette.is_autovec)]
        widest = widest.sort_values("times_scalar").groupby("method").tail(1)
        title = (
            f"By instruction set, {scalar}: the best rows are "
            f"{_range(widest)} times as fast as scalar code"
        )
        alt = f"{title}. " + " ".join(
            f"{row.method}: {times(row.times_scalar)} on {row.isa}."
            for row in widest.sort_values("times_scalar", ascending=False).itertuples()
        )
        return finish(figure, f"scaling-{scalar}", title, alt, footer)


def _range(rows: pd.DataFrame) -> str:
    """The smallest and the largest gain, each with its interval."""
    ends = [rows["times_scalar"].idxmin(), rows["times_scalar"].idxmax()]
    words = [
        with_interval(r["times_scalar"], r["times_scalar_low"], r["times_scalar_high"])
        for _, r in rows.loc[list(dict.fromkeys(ends))].iterrows()
    ]
    return " to ".join(words)


def _scaling_marks(
    axes: Any, rows: pd.DataFrame, isa: str, places: dict[str, int]
) -> None:
    """The marks of one ISA with their intervals; hollow for a plain loop."""
    looks = [palette.method_style(method).colour for method in rows["method"]]
    heights = [places[method] for method in rows["method"]]
    marker = palette.isa_marker(isa)
    axes.hlines(
        heights,
        rows["times_scalar_low"],
        rows["times_scalar_high"],
        colors=palette.INK,
        linewidth=0.9,
        zorder=4,
    )
    axes.scatter(
        rows["times_scalar"],
        heights,
        s=64 if marker == "*" else 26,
        marker=marker,
        color=["white"] * len(rows) if palette.is_autovec(isa) else looks,
        edgecolors=looks,
        linewidths=0.9,
        zorder=3,
    )
    ring(axes, rows, rows["times_scalar"], heights)


def fixed_against_fresh(table: pd.DataFrame, scalar: str, footer: str) -> Chart:
    """How many times as long a cell takes on rotating sets as on one set.

    `table`: tables.fixed_against_fresh of one loop and scalar.
    """
    methods = sorted(table["method"].unique(), key=palette.method_rank)
    with style():
        height = 1.95 + 0.3 * len(methods)
        figure, axes = plt.subplots(figsize=(10, height))
        figure.subplots_adjust(
            left=0.26, right=0.97, top=1 - 0.75 / height, bottom=1.05 / height
        )
        isas = sorted(table["isa"].unique(), key=palette.isa_rank)
        for row in table.itertuples():
            look = palette.method_style(row.method)
            shift = (isas.index(row.isa) - (len(isas) - 1) / 2) * 0.75 / len(isas)
            marker = palette.isa_marker(row.isa)
            axes.errorbar(
                [row.fresh_over_fixed],
                [-methods.index(row.method) - shift],
                xerr=[
                    [row.fresh_over_fixed - row.fresh_over_fixed_low],
                    [row.fresh_over_fixed_high - row.fresh_over_fixed],
                ],
                fmt=marker,
                markersize=8 if marker == "*" else 5,
                color=look.colour,
                markerfacecolor="white" if look.variant else look.colour,
                elinewidth=1,
            )
            heights = [-methods.index(row.method) - shift]
            ring(axes, table.loc[[row.Index]], [row.fresh_over_fixed], heights)
        axes.axvline(1, color=palette.INK, linewidth=1)
        axes.set_yticks([-i for i in range(len(methods))], methods)
        axes.set_ylim(-len(methods) + 0.4, 0.6)
        low = min(0.9, float(table["fresh_over_fixed_low"].min()))
        high = max(1.1, float(table["fresh_over_fixed_high"].max()))
        if high > 3:
            axes.set_xscale("log")
            ticks = [
                t for t in (0.5, 1, 2, 3, 5, 10, 20, 50, 100) if low < t < high * 1.2
            ]
            ticks_at(axes.xaxis, lambda value: f"{value:g}", ticks)
        axes.set_xlim(low / 1.03, high * 1.03)
        scale = " (log scale)" if high > 3 else ""
        axes.set_xlabel(
            f"time on fresh input ÷ time on fixed input{scale}; 1 = no difference"
        )
        isa_legend(figure, isas, noise_legend(table))
        low_ends, high_ends = (
            table["fresh_over_fixed_low"],
            table["fresh_over_fixed_high"],
        )
        apart = int(((low_ends > 1) | (high_ends < 1)).sum())
        largest = table.loc[table["fresh_over_fixed"].idxmax()]
        title = (
            f"Fresh against fixed input, {scalar}: {times(largest['fresh_over_fixed'])}"
            " the time at most ("
            f"{between(largest['fresh_over_fixed_low'], largest['fresh_over_fixed_high'])}"
            f"; {largest['method']}, {largest['isa']}); "
            f"{apart} of {len(table)} intervals leave out 1"
        )
        alt = f"{title}. " + " ".join(
            f"{row.method} on {row.isa}: {times(row.fresh_over_fixed)}."
            for row in table.sort_values("fresh_over_fixed", ascending=False)
            .head(8)
            .itertuples()
        )
        return finish(figure, f"fixed-{scalar}", title, alt, footer)


def loops(table: pd.DataFrame, scalar: str, footer: str) -> Chart:
    """Each method's time an item in each loop. `table`: tables.loops_compared."""
    methods = sorted(table["method"].unique(), key=palette.method_rank)
    names = sorted(table["loop"].unique(), key=palette.loop_rank)
    with style():
        height = 1.95 + 0.3 * len(methods)
        figure, axes = plt.subplots(figsize=(10, height))
        figure.subplots_adjust(
            left=0.26, right=0.97, top=1 - 0.75 / height, bottom=1.05 / height
        )
        axes.set_xscale("log")
        for name in names:
            rows = table[table["loop"] == name]
            marker, colour = palette.loop_style(name)
            axes.errorbar(
                rows["ns"],
                [-methods.index(method) for method in rows["method"]],
                xerr=[rows["ns"] - rows["ns_low"], rows["ns_high"] - rows["ns"]],
                fmt=marker,
                color=colour,
                markersize=6,
                elinewidth=1,
                label=name,
            )
            places = [-methods.index(method) for method in rows["method"]]
            ring(axes, rows, rows["ns"], places)
        low, high = float(table["ns_low"].min()), float(table["ns_high"].max())
        axes.set_xlim(low / 1.15, high * 1.15)
        steps = [m * 10.0**e for e in range(-4, 5) for m in (1, 2, 5)]
        ticks_at(
            axes.xaxis,
            lambda value: f"{value:g}",
            [t for t in steps if low / 1.15 < t < high * 1.15],
        )
        axes.set_yticks([-i for i in range(len(methods))], methods)
        axes.set_ylim(-len(methods) + 0.4, 0.6)
        isa = table["isa"].iloc[0]
        axes.set_xlabel(f"←  better      ns per item, {scalar}, {isa} (log scale)")
        handles = axes.get_legend_handles_labels()[0] + noise_legend(table)
        figure.legend(
            handles=handles,
            loc="lower left",
            bbox_to_anchor=(0.25, 0.26 / height),
            ncol=len(handles),
            fontsize=8.5,
        )
        medians = table.groupby("loop")["ns"].median()
        title = f"By loop, {scalar}, {isa}: median over the methods " + listed(
            [f"{nanoseconds(medians[name])} ({name})" for name in names]
        )
        alt = f"{title}. " + " ".join(
            f"{row.method}, {row.loop}: {significant(row.ns)} ns."
            for row in table.itertuples()
        )
        return finish(figure, f"loops-{scalar}", title, alt, footer)
