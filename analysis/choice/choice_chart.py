"""The decision chart: which method is the cheapest that is right, for triangles
from stout to thin and tolerances from loose to tight.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Final

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
from matplotlib.colors import to_rgb
from matplotlib.patches import Patch

from analysis.charts.chart_frame import Chart, finish, style
from analysis.charts.palette import method_rank, method_style
from analysis.choice.choose import Option, is_right, options, ranked
from analysis.choice.choose_scene import Described, Scene, checked
from analysis.choice.choose_times import ByCell, timings
from analysis.choice.extent import DIGITS
from analysis.read.run import MethodEntry
from analysis.report.wording import counted, listed, power_of_two, share

# Where the square of the triangles lies: its distance from the origin in its own
# sides, as a power of two; NaN: at the origin.
PLACES: Final = {"f32": (math.nan, 10.0), "f64": (math.nan, 30.0)}
# Points a triangle: so many that its set-up is lost, or one.
SHAPES: Final = {4096: "many points a triangle", 1: "a triangle for each point"}
_THIN: Final = 21  # columns, from stout to where few digits are left
_TIGHT: Final = 24  # rows
_NOTHING: Final = "#E4E4E4"  # where no method of the run is right

CHOICE_COLUMNS: Final = [
    "points",
    "scalar",
    "away",
    "aspect",
    "tolerance",
    "method",
    "exact",
    "right_beyond",
    "ns",
]


def choices(
    by_cell: ByCell,
    cells: pd.DataFrame,
    methods: tuple[MethodEntry, ...],
    alike: float = 1.0,
) -> pd.DataFrame:
    """One row a scene of the chart (CHOICE_COLUMNS): longest edges of 1 in a
    square of side 1, whole multiples of the last bit of 1. A scene for which no
    method of the run is right has no row. `alike`: as of choose.
    """
    rows: list[dict[str, Any]] = []
    for points in SHAPES:
        for scalar in sorted(set(cells["scalar"]) & set(PLACES)):
            here = scene_at(points, scalar, math.nan, 2, 0)
            timed = timings(here, by_cell, cells, methods)
            digits = DIGITS[scalar]
            for away in PLACES[scalar]:
                for aspect in 2.0 ** np.linspace(1, 0.75 * digits, _THIN):
                    scene = scene_at(points, scalar, away, float(aspect), 0)
                    place = (points, scalar, away, float(aspect))
                    tight = 2.0 ** -np.linspace(0, digits + 4, _TIGHT)
                    found = options(scene, timed, methods)
                    rows += _along(scene, place, found, tight, alike)
    return pd.DataFrame(rows, columns=CHOICE_COLUMNS)


def _along(
    scene: Scene,
    place: tuple[Any, ...],
    found: list[Option],
    tolerances: Any,
    alike: float,
) -> list[dict[str, Any]]:
    """The rows of one slimness: its bounds are the same at every tolerance."""
    rows = []
    for tolerance in map(float, tolerances):
        here = dataclasses.replace(scene, tolerance=tolerance)
        fit = [o for o in found if is_right(here, o.bound, o.boundary)]
        right = ranked(fit, alike)
        if right:
            values = (*place, tolerance, right[0].name, right[0].bound.exact)
            values = (*values, right[0].bound.distance, right[0].ns)
            rows.append(dict(zip(CHOICE_COLUMNS, values)))
    return rows


def scene_at(
    points: int, scalar: str, away: float, aspect: float, tolerance: float
) -> Scene:
    """The scene of a place in the chart."""
    low = 0.0 if math.isnan(away) else 2.0**away
    given = Described(
        scalar=scalar,
        coordinates=(low, low + 1),
        aspect=aspect,
        edge=(1.0,),
        points=points,
        precision=2.0 ** -DIGITS[scalar],
        tolerance=tolerance,
    )
    return checked(given)


def choice_map(table: pd.DataFrame, footer: str) -> Chart:
    """A row a shape of the work, a column a scalar and place; the colour is
    that of the chosen method.
    """
    scalars = sorted(table["scalar"].unique())
    columns = [(scalar, away) for scalar in scalars for away in PLACES[scalar]]
    shapes = [points for points in SHAPES if points in set(table["points"])]
    methods = sorted(table["method"].unique(), key=method_rank)
    height = 1.75 + 2.7 * len(shapes)
    with style():
        figure, grid = plt.subplots(
            len(shapes), len(columns), figsize=(11, height), squeeze=False
        )
        figure.subplots_adjust(
            left=0.09,
            right=0.985,
            top=1 - 0.95 / height,
            bottom=1.15 / height,
            wspace=0.25,
            hspace=0.3,
        )
        for panels, points in zip(grid, shapes):
            for axes, (scalar, away) in zip(panels, columns):
                rows = _rows(table, points, scalar, away)
                if len(rows):
                    _panel(axes, rows)
                title = f"{scalar}, {_place(away)}"
                axes.set_title(title, loc="left", fontsize=9, weight="bold")
            panels[0].set_ylabel(f"{SHAPES[points]}\ntolerance (log scale)   tighter →")
        figure.text(
            0.09,
            0.68 / height,
            "longest edge over smallest altitude (log scale)   thinner →",
            fontsize=9.5,
        )
        figure.legend(
            handles=[Patch(facecolor=_colour(m), label=m) for m in methods],
            loc="lower left",
            bbox_to_anchor=(0.08, 0.22 / height),
            ncol=4,
            fontsize=8,
        )
        title = choice_title(table)
        alt = " ".join([f"{title}.", *_words(table, shapes, columns)])
        return finish(figure, "choice_map", title, alt, footer)


def _rows(table: pd.DataFrame, points: int, scalar: str, away: float) -> pd.DataFrame:
    own = table[(table["scalar"] == scalar) & (table["points"] == points)]
    return own[own["away"].isna() if math.isnan(away) else own["away"] == away]


def _place(away: float) -> str:
    at_origin = math.isnan(away)
    return "at the origin" if at_origin else f"{power_of_two(away)} sides away"


def _colour(method: str) -> str:
    return method_style(method).colour if method else _NOTHING


def _panel(axes: Any, rows: pd.DataFrame) -> None:
    shown = rows.pivot(index="tolerance", columns="aspect", values="method")
    shown = shown.astype(object).where(shown.notna(), "")
    x = np.log2(shown.columns.to_numpy(dtype=float))
    y = np.log2(shown.index.to_numpy(dtype=float))
    colours = [[to_rgb(_colour(m)) for m in row] for row in shown.values]
    half_x = (x[-1] - x[0]) / max(2 * (len(x) - 1), 1)
    half_y = (y[-1] - y[0]) / max(2 * (len(y) - 1), 1)
    axes.imshow(
        (255 * np.array(colours)).round().astype(np.uint8),
        origin="lower",
        aspect="auto",
        interpolation="nearest",
        extent=(x[0] - half_x, x[-1] + half_x, y[0] - half_y, y[-1] + half_y),
    )
    axes.invert_yaxis()
    axes.grid(False)
    for axis in (axes.xaxis, axes.yaxis):
        axis.get_major_locator().set_params(integer=True, nbins=6)
        axis.set_major_formatter(lambda value, _: power_of_two(value))


def choice_title(table: pd.DataFrame) -> str:
    exact, methods = table["exact"].mean(), table["method"].nunique()
    always = counted(methods, "method is", "methods are")
    return (
        f"{always} the cheapest that is right somewhere; on {share(exact)} of this map "
        "it is one whose answers are exact there"
    )


def _words(
    table: pd.DataFrame, shapes: list[int], columns: list[tuple[str, float]]
) -> list[str]:
    found = []
    for points in shapes:
        for scalar, away in columns:
            rows = _rows(table, points, scalar, away)
            counts = rows["method"].value_counts()
            named = sorted(counts.index, key=lambda m: (-counts[m], method_rank(m)))
            words = [f"{m} on {share(counts[m] / len(rows))}" for m in named]
            found.append(
                f"{SHAPES[points].capitalize()}, {scalar}, {_place(away)}: "
                f"{listed(words)} of the map."
            )
    return found
