"""Error rates of all methods at once: method × what makes a scene hard."""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd

from analysis.accuracy.hardness import Hardness
from analysis.charts import palette, ramp
from analysis.charts.chart_frame import Chart, finish, style
from analysis.report.method_families import in_order
from analysis.report.wording import counted, share

# Inches.
_WIDTH, _LEFT, _RIGHT, _BETWEEN = 11.0, 2.55, 0.25, 0.3
_TOP, _BOTTOM, _ROW = 1.45, 0.78, 0.185


def heat_map(
    tables: dict[str, pd.DataFrame], hardness: Hardness, isa: str, footer: str
) -> Chart:
    """The error rate as a colour: a row a method, a column a value of the
    parameter, a panel a scalar. `tables`: scalar → errors_along, none empty.
    """
    scalars = sorted(tables)
    methods = in_order(m for table in tables.values() for m in table["method"])
    height = _TOP + _ROW * len(methods) + _BOTTOM
    values = {scalar: sorted(tables[scalar]["at"].unique()) for scalar in scalars}
    if hardness.harder == "falls":
        values = {scalar: at[::-1] for scalar, at in values.items()}
    columns = sum(len(at) for at in values.values())
    room = _WIDTH - _LEFT - _RIGHT - _BETWEEN * (len(scalars) - 1)
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        left = _LEFT
        for scalar in scalars:
            width = room * len(values[scalar]) / columns
            axes = figure.add_axes(
                (
                    left / _WIDTH,
                    _BOTTOM / height,
                    width / _WIDTH,
                    _ROW * len(methods) / height,
                )
            )
            left += width + _BETWEEN
            _panel(axes, tables[scalar], methods, values[scalar], hardness)
            axes.set_title(f"{scalar}, {isa}", loc="left", fontsize=9, weight="bold")
            axes.set_yticks(
                range(len(methods)), methods if scalar == scalars[0] else []
            )
        for tick, method in zip(figure.axes[0].get_yticklabels(), methods):
            tick.set_color(palette.method_style(method).colour)
            tick.set_fontsize(7.5)
        figure.text(
            _LEFT / _WIDTH,
            0.33 / height,
            hardness.axis_label.replace(" (log scale)", ""),
            fontsize=8.5,
        )
        _legend(figure, height)
        title = _title(tables[scalars[0]], hardness, scalars[0])
        alt = f"{title}. " + " ".join(
            f"{scalar}: {_words(tables[scalar], hardness)}" for scalar in scalars
        )
        return finish(figure, f"heat-{hardness.family}", title, alt, footer)


def picture(table: pd.DataFrame, methods: list[str], values: list[float]) -> Any:
    """The colours, methods × values × 3; grey where a method has no row."""
    rates = table.pivot(index="method", columns="at", values="error_rate")
    rates = rates.reindex(index=methods, columns=values)
    rows = [[ramp.colour(float(rate)) for rate in row] for row in rates.to_numpy()]
    return np.array(rows, dtype=np.uint8)


def _panel(
    axes: Any,
    table: pd.DataFrame,
    methods: list[str],
    values: list[float],
    hardness: Hardness,
) -> None:
    axes.imshow(
        picture(table, methods, values),
        interpolation="none",
        aspect="auto",
        extent=(-0.5, len(values) - 0.5, len(methods) - 0.5, -0.5),
    )
    step = max(1, -(-len(values) // 12))
    shown = list(range(0, len(values), step))
    axes.set_xticks(shown, [hardness.named(values[i]) for i in shown], fontsize=7.5)
    axes.grid(visible=False)
    axes.tick_params(length=0)
    for side in axes.spines.values():
        side.set_visible(True)
    # Lines between the cells, so that a row can be followed by eye.
    axes.hlines(
        [row + 0.5 for row in range(len(methods) - 1)],
        -0.5,
        len(values) - 0.5,
        color="#D9D9D9",
        linewidth=0.5,
    )


def _legend(figure: Any, height: float) -> None:
    """The scale of colours, and the two that stand outside of it."""
    axes = figure.add_axes(
        (_LEFT / _WIDTH, 1 - 0.82 / height, 5.2 / _WIDTH, 0.15 / height)
    )
    scale = np.logspace(-6, 0, 121)
    zero, unknown = [ramp.colour(0.0)] * 20, [ramp.colour(float("nan"))] * 20
    strip = [*unknown, *zero, *(ramp.colour(float(rate)) for rate in scale)]
    axes.imshow(
        np.array([strip], dtype=np.uint8),
        interpolation="none",
        aspect="auto",
        extent=(0, len(strip), 0, 1),
    )
    names = {10.0: "not measured", 30.0: "none"}
    ticks = ("1 ppm", "10 ppm", "100 ppm", "0.1 %", "1 %", "10 %", "100 %")
    names |= {40.0 + 20 * i: text for i, text in enumerate(ticks)}
    axes.set_xticks(list(names), list(names.values()), fontsize=7)
    axes.tick_params(length=2, pad=2)
    axes.set_yticks([])
    axes.grid(visible=False)
    for side in axes.spines.values():
        side.set_visible(True)


def _title(table: pd.DataFrame, hardness: Hardness, scalar: str) -> str:
    whole = table[table["accepts"] == "triangle"]
    worst = whole.groupby("method")["error_rate"].max()
    half = int((worst >= 0.1).sum())
    clean = int((worst == 0).sum())
    return (
        f"Method against {hardness.what}, {scalar}: of {counted(len(worst), 'method')} "
        f"{clean} never {'errs' if clean == 1 else 'err'}, "
        f"{half} {'errs' if half == 1 else 'err'} on a tenth or more"
    )


def _words(table: pd.DataFrame, hardness: Hardness) -> str:
    worst = table.loc[table.groupby("method")["error_rate"].idxmax()]
    return "; ".join(
        f"{row.method} {share(row.error_rate)} at {hardness.words(row.at)}"
        for row in worst.sort_values("error_rate", ascending=False).itertuples()
    )
