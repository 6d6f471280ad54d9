"""The published scene: triangles against the pixels of a grid, as two tracks.

On the track `points` the pixels are given as an array of points, whose layout
a kernel knows nothing of; on the track `grid` it knows that they are a grid.
Both are timed in one shard, so that any row may be compared with any other.
"""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.charts.palette import is_autovec, isa_rank, method_rank
from analysis.report import wording
from analysis.report.wording import listed, significant, with_interval
from analysis.speed.bounds import COUNTED_FOR
from analysis.speed.tables import samples
from analysis.speed.written import grid_size
from analysis.trust.stats import ratio_interval

POINTS = "grid_points_80x50"
GRID = "grid_80x50"
# What every row is compared with: the points as 32-bit integers, by the plain
# formula, on the row's own ISA.
BASE_METHOD, BASE_SCALAR = "edge_function", "i32"
ACROSS_EDGES = "edge_lanes"

Samples = npt.NDArray[np.float64]

_BOUND_TIMES = ("memory_ns", "compute_ns", "bound_ns")
_BOUNDS = (
    *("bound_by", "bound_of", "beaten"),
    *("of_limit", "of_limit_low", "of_limit_high"),
)
_TRACKS = {POINTS: "points", GRID: "grid"}


def pixels(family: str) -> int:
    """Columns times rows, which the name of the scene gives."""
    return math.prod(grid_size(family))


def published_scene(
    speed: pd.DataFrame, cells: pd.DataFrame, writes: dict[str, str]
) -> pd.DataFrame:
    """One row a kernel on fresh triangles: time a triangle (`ns`) and a pixel
    (`pixel_ns`), what it writes (by loop, from `writes`), and how many times as fast it is as the base
    (`times_points`, NaN where that was not timed in the same shard). An older
    run that has no track `points` gives the other alone.
    """
    chosen = cells[
        cells["family"].isin(list(_TRACKS))
        & ~cells["scene"].str.contains("sets=fixed", regex=False)
    ]
    by_cell = samples(speed)
    rows = []
    for _, cell in chosen.iterrows():
        track = _TRACKS[cell["family"]]
        # An item is a point on the one track and a triangle on the other.
        items = pixels(cell["family"]) if track == "points" else 1
        row: dict[str, Any] = {
            "track": track,
            **{key: cell[key] for key in ("method", "scalar", "isa", "shard", "name")},
            "noise": cell["noise"],
            "writes": writes.get(cell["loop"], wording.NONE),
        }
        for end in ("", "_low", "_high"):
            row[f"ns{end}"] = cell[f"ns{end}"] * items
            row[f"pixel_ns{end}"] = row[f"ns{end}"] / pixels(cell["family"])
        if "bound_ns" in cells:
            row |= {key: cell[key] for key in _BOUNDS}
            row |= {key: cell[key] * items for key in _BOUND_TIMES}
        own = by_cell[cell["shard"], cell["name"]] * items
        row |= _times_points(by_cell.get((cell["shard"], _base(cell, chosen))), own)
        rows.append(row)
    return _in_order(pd.DataFrame(rows))


def across_edges(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """For each ISA that has both, how many times as fast the same formula is
    with points as lanes as with the edges of one point as lanes (`gain`).
    """
    own = cells[cells["family"] == POINTS]
    by_cell = samples(speed)
    rows = []
    for _, cell in own[own["method"] == ACROSS_EDGES].iterrows():
        bottom = by_cell.get((cell["shard"], _base(cell, own)))
        if bottom is None:
            continue
        top = by_cell[cell["shard"], cell["name"]]
        gain = ratio_interval(top, bottom)
        rows.append(
            {
                "isa": cell["isa"],
                "gain": gain.value,
                "gain_low": gain.low,
                "gain_high": gain.high,
            }
        )
    table = pd.DataFrame(rows, columns=["isa", "gain", "gain_low", "gain_high"])
    order = sorted(range(len(table)), key=lambda i: isa_rank(table["isa"].iloc[i]))
    return table.iloc[order].reset_index(drop=True)


def _base(cell: pd.Series, rows: pd.DataFrame) -> str:
    """The name of the base on the cell's ISA, empty if there is none."""
    same = rows[
        (rows["family"] == POINTS)
        & (rows["method"] == BASE_METHOD)
        & (rows["scalar"] == BASE_SCALAR)
        & (rows["isa"] == cell["isa"])
        & (rows["shard"] == cell["shard"])
    ]
    return str(same["name"].iloc[0]) if len(same) else ""


def _times_points(points: Samples | None, own: Samples) -> dict[str, float]:
    keys = ("times_points", "times_points_low", "times_points_high")
    if points is None:
        return dict.fromkeys(keys, math.nan)
    # The base's samples are ns a point.
    values = ratio_interval(points * pixels(POINTS), own)[:3]
    return dict(zip(keys, values))


def _in_order(table: pd.DataFrame) -> pd.DataFrame:
    """Track by track, ISA by ISA from wide to narrow, the slowest first."""
    if not len(table):
        return table
    tracks = list(_TRACKS.values())
    keys = [
        (
            tracks.index(row["track"]),
            -isa_rank(row["isa"])[0],
            -row["ns"],
            method_rank(row["method"]),
        )
        for _, row in table.iterrows()
    ]
    order = sorted(range(len(table)), key=lambda i: keys[i])
    return table.iloc[order].reset_index(drop=True)


def gain_sentence(gains: pd.DataFrame) -> str:
    """What lanes across points gain over lanes across edges; empty if nothing
    was timed both ways.
    """
    if not len(gains):
        return ""
    parts = [
        f"{with_interval(row['gain'], row['gain_low'], row['gain_high'])} × on "
        f"{row['isa']}"
        for _, row in gains.iterrows()
    ]
    return (
        "With the three edges of one point as the lanes of a register, as "
        "qTriangle has them, a register never holds more than one point, however "
        "wide the instruction set; with points as lanes the same formula on the "
        f"same points is faster: {listed(parts)}."
    )


def grid_bound_facts(table: pd.DataFrame) -> dict[str, str]:
    """`uncounted`: the methods that only memory bounds; `understated`: the ISAs on
    which a bound is too low (bounds.COUNTED_FOR). Empty where bounds are not known.
    """
    if not len(table) or "bound_ns" not in table:
        return dict.fromkeys(("uncounted", "understated"), "")
    uncounted = table[table["compute_ns"].isna()]["method"].unique()
    isas = sorted(table["isa"].unique(), key=isa_rank)
    return {
        "uncounted": listed(sorted(uncounted, key=method_rank)),
        "understated": listed([isa for isa in isas if isa not in COUNTED_FOR]),
    }


def fastest_sentence(table: pd.DataFrame) -> str:
    """The fastest of each track on the widest ISA, against the base; empty for
    a run without the base.
    """
    if not len(table):
        return ""
    known = table[table["times_points"].notna() & ~table["isa"].map(is_autovec)]
    if not len(known):
        return ""
    isa = max(known["isa"], key=isa_rank)
    parts = []
    for track, given in (("points", "given as points"), ("grid", "known as a grid")):
        rows = known[(known["track"] == track) & (known["isa"] == isa)]
        if len(rows):
            best = rows.loc[rows["ns"].idxmin()]
            ratio = with_interval(
                best["times_points"],
                best["times_points_low"],
                best["times_points_high"],
            )
            parts.append(
                f"{given}, {best['method']} in {best['scalar']} with "
                f"{significant(best['ns'])} ns a triangle, {ratio} × as fast as "
                f"{BASE_METHOD} on points in {BASE_SCALAR}"
            )
    return f"On {isa} the fastest are: {'; '.join(parts)}."
