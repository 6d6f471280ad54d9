"""Other libraries in the chart of speed against error: small marks of their
own with their names at them, so that the kernels keep the foreground.
"""

from __future__ import annotations

from typing import Any

import pandas as pd

from analysis.charts import palette
from analysis.charts.chart_frame import RateAxis, spread

_SIZE = 7.0  # of the names, in points
_WIDTH = 0.65 * _SIZE  # of a letter, at the most on average
_ABOVE = 7.0  # from a mark to its name, in points


def peer_marks(axes: Any, rows: pd.DataFrame, rates: RateAxis) -> None:
    """Draws the marks. `rows`: peers_exhibits.hero_rows."""
    for row in rows.itertuples():
        look = palette.method_style(row.method)
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
            fmt=palette.isa_marker(row.isa),
            markersize=6,
            color=look.colour,
            markerfacecolor="white" if look.variant else look.colour,
            elinewidth=0.8,
            zorder=2.5,
        )


def peer_names(axes: Any, rows: pd.DataFrame, rates: RateAxis) -> None:
    """Writes each name upwards from its mark, or downwards where it would leave
    the axes or cross another mark; none beside another. Call it when the axes have their final limits.
    """
    to_points = 72 / axes.figure.dpi
    marks = [
        axes.transData.transform((row.items_per_second, rates.at(row.error_rate)))
        * to_points
        for row in rows.itertuples()
    ]
    box = axes.get_window_extent()
    left, right = box.x0 * to_points, box.x1 * to_points
    # Beside the whisker, where that goes upwards from the lane of zeros.
    aside = [_SIZE * 0.8 * (rate == 0) for rate in rows["error_rate"]]
    wanted = [x + shift for (x, _), shift in zip(marks, aside, strict=True)]
    places = spread(wanted, _SIZE * 1.25, left + _SIZE, right)
    top = box.y1 * to_points
    for row, (x, y), place in zip(rows.itertuples(), marks, places, strict=True):
        end = y + _ABOVE + _WIDTH * len(row.method)
        crosses = any(y < v <= end and abs(u - x) < _SIZE for u, v in marks)
        rises = end <= top and not crosses
        axes.annotate(
            row.method,
            (row.items_per_second, rates.at(row.error_rate)),
            xytext=(place - x, _ABOVE if rises else -_ABOVE),
            textcoords="offset points",
            rotation=90,
            ha="center",
            va="bottom" if rises else "top",
            fontsize=_SIZE,
            color=palette.method_style(row.method).colour,
            zorder=2.5,
            arrowprops={
                "arrowstyle": "-",
                "linewidth": 0.5,
                "color": palette.method_style(row.method).colour,
                "alpha": 0.6,
                "shrinkA": 0,
                "shrinkB": 3,
            },
        )
