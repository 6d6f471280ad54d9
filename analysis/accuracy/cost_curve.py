"""What exact answers cost where a bound on the rounding error decides nothing: as
ever more points lie on an edge, and at worst. The table, the worst case and the
chart.
"""

from __future__ import annotations

import math
from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from analysis.accuracy.exact_tables import EDGE
from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    Label,
    finish,
    label_column,
    style,
    ticks_at,
)
from analysis.read.cells import parse_scene
from analysis.report.method_families import in_order
from analysis.report.wording import between, counted, significant, times
from analysis.speed.tables import compared, parameter, widest_isa
from analysis.trust.noisy_marks import ring

_WIDTH, _HEIGHT = 11.0, 4.6
_TICKS = [m * 10.0**e for e in range(-4, 7) for m in (1, 2, 5)]


# Families whose points are on an edge, so many percent of them: exactly, and in
# older runs only up to rounding, so nearly never exactly.
EXACTLY, ROUNDED = "on_edge", "edge_share"
# All points are on the boundary, and exponents spread.
BOUNDARY = "on_boundary"


def cost_curve(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The timed cells along the share of points on an edge (`percent`), and those
    with nothing but points on the boundary (`percent` NaN; `at` an edge or a
    vertex, `binades`), with their time over that of the multiply-add edge
    function in the same scene, ISA and shard (`times_edge`, NaN where it was not
    timed). Points exactly on an edge, if the run has any.
    """
    timed = cells[cells["loop"] == "one_triangle"]
    shares = EXACTLY if (timed["family"] == EXACTLY).any() else ROUNDED
    rows = timed[timed["family"].isin([shares, BOUNDARY])]
    rows = rows.assign(
        percent=parameter(rows, "percent"),
        at=rows["scene"].map(
            lambda scene: dict(parse_scene(scene).parameters).get("at", "")
        ),
        binades=parameter(rows, "binades"),
    )
    rows = rows[(rows["family"] == BOUNDARY) | rows["percent"].notna()]
    rows = rows.reset_index(drop=True)
    ratios = compared(
        speed,
        rows,
        "edge_over_own",
        lambda cell: str(cell["name"]).replace(f"/{cell['method']}/", f"/{EDGE}/"),
    ).set_index(["shard", "name"])
    keys = pd.MultiIndex.from_frame(rows[["shard", "name"]])
    over = ratios[["edge_over_own", "edge_over_own_low", "edge_over_own_high"]]
    over = over.reindex(keys).astype(float)
    return rows.assign(
        times_edge=(1 / over["edge_over_own"]).to_numpy(),
        times_edge_low=(1 / over["edge_over_own_high"]).to_numpy(),
        times_edge_high=(1 / over["edge_over_own_low"]).to_numpy(),
    )


def along_share(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of cost_curve that are along a share of points."""
    return table[table["family"] != BOUNDARY]


def worst_scenes(table: pd.DataFrame) -> pd.DataFrame:
    """What `exact` takes for a point where every point is on the boundary, in its
    slowest scene first, on the widest ISA of each scalar.
    """
    on_it = (table["family"] == BOUNDARY) | (table["percent"] == 100)
    own = table[on_it & (table["method"] == "exact")]
    parts = [_on_widest(own, scalar) for scalar in sorted(own["scalar"].unique())]
    slowest = [part.sort_values("ns", ascending=False) for part in parts]
    rows = pd.concat(slowest) if slowest else own
    return rows.assign(points=[points_of(row) for _, row in rows.iterrows()])


def points_of(row: pd.Series) -> str:
    """Where the points of the row's scene are."""
    if row["family"] == BOUNDARY:
        what = "at a vertex" if row["at"] == "vertex" else "exactly on an edge"
        over = counted(int(row["binades"]), "binade")
        return f"all points {what}, exponents over {over}"
    place = "exactly on an edge" if row["family"] == EXACTLY else "rounded onto an edge"
    return f"{row['percent']:g} % of the points {place}"


def worst_case(table: pd.DataFrame) -> pd.Series | None:
    """The row of `exact` that takes the most times as long as the multiply-add
    edge function, over all scenes, ISAs and scalars; None if none has a ratio.
    """
    own = table[(table["method"] == "exact") & table["times_edge"].notna()]
    return own.loc[own["times_edge"].idxmax()] if len(own) else None


def worst_words(table: pd.DataFrame) -> dict[str, Any] | None:
    """The worst case in phrases."""
    worst = worst_case(table)
    if worst is None:
        return None
    own = table[(table["method"] == "exact") & table["times_edge"].notna()]
    isas = sorted(own["isa"].unique(), key=palette.isa_rank)
    slowest = table.loc[table[table["method"] == "exact"]["ns"].idxmax()]
    return {
        "ratio": times(worst["times_edge"]),
        "interval": between(worst["times_edge_low"], worst["times_edge_high"]),
        "scalar": worst["scalar"],
        "isa": worst["isa"],
        "points": points_of(worst),
        "ns": f"{significant(worst['ns'])} ns",
        "isas": ", ".join(isas),
        "scenes": counted(own["scene"].nunique(), "scene"),
        "slowest": (
            f"{significant(slowest['ns'])} ns in {slowest['scalar']} on "
            f"{slowest['isa']}, {points_of(slowest)}"
        ),
        "exactly": bool((table["family"] != ROUNDED).any()),
    }


def curve_chart(table: pd.DataFrame, footer: str) -> Chart:
    """Time a point against the share on an edge, a panel a scalar, each on the
    widest ISA that most of the methods have. `table`: cost_curve, with rows along
    a share.
    """
    along = along_share(table)
    scalars = sorted(along["scalar"].unique())
    parts = {scalar: _on_widest(along, scalar) for scalar in scalars}
    shown = pd.concat(list(parts.values()))
    exactly = (shown["family"] == EXACTLY).any()
    place = "exactly on an edge" if exactly else "rounded onto an edge"
    low, high = float(shown["ns_low"].min()), float(shown["ns_high"].max())
    with style():
        figure = plt.figure(figsize=(_WIDTH, _HEIGHT))
        for column, scalar in enumerate(scalars):
            axes = figure.add_axes(
                ((0.9 + 5.15 * column) / _WIDTH, 0.175, 3.1 / _WIDTH, 0.6)
            )
            _panel(axes, parts[scalar], (low / 1.4, high * 1.4))
            isa = parts[scalar]["isa"].iloc[0]
            axes.set_title(f"{scalar}, {isa}", loc="left", fontsize=9, weight="bold")
            axes.set_xlabel(f"points {place}, % (log scale)", fontsize=8.5)
            if column == 0:
                axes.set_ylabel("ns per point (log scale)      ←  better")
        title = "The cost of exact answers as points come to lie on an edge"
        worst = worst_case(along)
        if worst is not None:
            title += (
                f": at most {times(worst['times_edge'])} the time of {EDGE} "
                f"({between(worst['times_edge_low'], worst['times_edge_high'])}; "
                f"{worst['scalar']}, {worst['isa']}, {worst['percent']:g} %)"
            )
        alt = f"{title}. " + " ".join(
            f"{row.method}, {row.scalar}, {row.percent:g} %: {significant(row.ns)} ns."
            for row in shown.itertuples()
        )
        return finish(figure, "cost_curve", title, alt, footer)


def _on_widest(table: pd.DataFrame, scalar: str) -> pd.DataFrame:
    rows = table[table["scalar"] == scalar]
    isa = widest_isa(rows)
    return rows[rows["isa"] == (isa if isa else rows["isa"].iloc[0])]


def places(percents: list[float]) -> dict[float, float]:
    """Where each share stands: on a logarithmic axis, 0 one step before."""
    positive = [math.log10(p) for p in percents if p > 0]
    zero = min(positive, default=0.0) - 1
    return {p: math.log10(p) if p > 0 else zero for p in sorted(percents)}


def _panel(axes: Any, rows: pd.DataFrame, limits: tuple[float, float]) -> None:
    at = places([float(p) for p in rows["percent"].unique()])
    axes.set_yscale("log")
    axes.set_ylim(*limits)
    labels = []
    for method in in_order(rows["method"]):
        own = rows[rows["method"] == method].sort_values("percent")
        look = palette.method_style(method)
        axes.errorbar(
            [at[p] for p in own["percent"]],
            own["ns"],
            yerr=[own["ns"] - own["ns_low"], own["ns_high"] - own["ns"]],
            fmt="o",
            color=look.colour,
            markersize=4.5,
            markerfacecolor="white" if look.variant else look.colour,
            elinewidth=1,
            capsize=2,
            zorder=3,
        )
        ring(axes, own, [at[p] for p in own["percent"]], own["ns"])
        drawn = own[own["percent"] > 0]
        axes.plot(
            [at[p] for p in drawn["percent"]],
            drawn["ns"],
            color=look.colour,
            linestyle=look.dash,
            linewidth=1.3,
            zorder=2,
        )
        last = own.iloc[-1]
        labels.append(
            Label(at[last["percent"]], last["ns"], method, look.colour, dash=look.dash)
        )
    ends = list(at.values())
    axes.set_xlim(min(ends) - 0.3, max(ends) + 0.2)
    if 0 in at:
        axes.axvspan(at[0] - 0.3, at[0] + 0.35, color="#F2F2F2", zorder=0)
    names = {place: f"{percent:g}" for percent, place in at.items()}
    ticks_at(axes.xaxis, lambda place: names.get(place, ""), ends)
    inside = [t for t in _TICKS if limits[0] <= t <= limits[1]]
    step = 1 if len(inside) <= 9 else 3
    decades = [t for t in inside if step == 1 or f"{t:e}".startswith("1.0")]
    ticks_at(axes.yaxis, lambda value: f"{value:g}", decades)
    label_column(axes, labels, size=8)
