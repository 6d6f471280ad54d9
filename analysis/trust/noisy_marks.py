"""How a chart shows that a row is noisy (analysis/trust/row_noise.py): by a ring."""

from __future__ import annotations

from typing import Any

import pandas as pd
from matplotlib.lines import Line2D

from analysis.report.wording import counted

_COLOUR = "#C2185B"  # of no method
_SIZE = 9.5


def is_noisy(table: pd.DataFrame) -> pd.Series:
    """Which rows are; none of a table that does not tell."""
    if "noise" not in table:
        return pd.Series(False, index=table.index)
    return table["noise"].fillna("").astype(bool)


def ring(axes: Any, rows: pd.DataFrame, xs: Any, ys: Any) -> None:
    """Draws a ring around the marks (xs, ys) of those `rows` that are noisy."""
    found = [
        (x, y) for x, y, noisy in zip(xs, ys, is_noisy(rows), strict=True) if noisy
    ]
    if found:
        axes.plot(*zip(*found), **_look(), zorder=6)


def noise_legend(table: pd.DataFrame) -> list[Any]:
    """What explains the rings in a chart's legend; nothing without rings."""
    return [Line2D([], [], label="noisy", **_look())] if is_noisy(table).any() else []


def noise_note(table: pd.DataFrame) -> str:
    """A sentence for the caption, with a space before it; empty without rings."""
    noisy = int(is_noisy(table).sum())
    if not noisy:
        return ""
    verb = "is" if noisy == 1 else "are"
    return f" Ringed: {noisy} of {counted(len(table), 'row')} {verb} noisy."


def _look() -> dict[str, Any]:
    return {
        "linestyle": "",
        "marker": "o",
        "markersize": _SIZE,
        "markerfacecolor": "none",
        "markeredgecolor": _COLOUR,
        "markeredgewidth": 0.9,
    }
