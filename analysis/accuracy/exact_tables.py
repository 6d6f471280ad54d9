"""What the methods that promise exact answers keep, and what that costs."""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.report.method_families import is_exact
from analysis.speed.tables import CELL_KEYS, samples, sort_cells
from analysis.trust.stats import ratio_interval, wilson

EDGE = "edge_function_fma"  # what throughput is compared with
Samples = dict[tuple[str, str], npt.NDArray[np.float64]]


def exact_errors(accuracy: pd.DataFrame) -> pd.DataFrame:
    """Each exact method's wrong answers over all scenes, ISAs and loops.

    `of` counts answers, `points` what was asked: all ISAs are given the same
    points, and so are the two layouts of a loop, so their answers are no sample
    of more points. The interval is that of the points, and a point counts as
    wrong by the ISA that errs most in its scene.
    """
    own = accuracy[accuracy["method"].map(is_exact).astype(bool)]
    own = own.assign(
        wrong=_total(own, "false_inside", "false_outside"),
        judged=_total(own, "false_inside_of", "false_outside_of"),
        asked_by=own["loop"].str.removesuffix("_aos"),
    )
    rows = []
    for (scalar, method), cells in own.groupby(["scalar", "method"], sort=True):
        sums = {
            key: int(cells[key].astype(float).fillna(0).sum())
            for key in ("hole", "double_hit", "hole_of")
        }
        asked = cells.groupby(["asked_by", "scene"])[["wrong", "judged"]].max()
        points = int(asked["judged"].sum())
        rate = wilson(int(asked["wrong"].sum()), points)
        rows.append(
            {
                "method": method,
                "scalar": scalar,
                "scenes": cells["scene"].nunique(),
                "isas": cells["isa"].nunique(),
                "wrong": int(cells["wrong"].sum()),
                "of": int(cells["judged"].sum()),
                "points": points,
                "error_rate": rate.value,
                "error_rate_low": rate.low,
                "error_rate_high": rate.high,
                "holes": sums["hole"],
                "double_hits": sums["double_hit"],
                "queries": sums["hole_of"],
            }
        )
    columns = ["method", "scalar", "scenes", "isas", "wrong", "of", "points"]
    columns += ["error_rate", "error_rate_low", "error_rate_high"]
    columns += ["holes", "double_hits", "queries"]
    frame = pd.DataFrame(rows, columns=columns)
    return sort_cells(frame, ["scalar", "method"])


def _total(cells: pd.DataFrame, *keys: str) -> pd.Series:
    return cells[list(keys)].astype(float).fillna(0).sum(axis=1)


def exact_speed(
    speed: pd.DataFrame, cells: pd.DataFrame, warned: set[str]
) -> pd.DataFrame:
    """One row an exact method × scalar × ISA × fresh uniform scene: its
    throughput over that of the multiply-add edge function (`of_edge`) and
    over the fastest method that promises less (`of_fastest`; those that are
    kept as a warning do not count), both of the same shard, so from
    repetitions shuffled into each other.
    """
    by_cell = samples(speed)
    fresh = cells[
        (cells["loop"] == "one_triangle")
        & (cells["family"] == "uniform")
        & ~cells["scene"].str.contains("sets=fixed", regex=False)
    ]
    keys = ["shard", "scene", "scalar", "isa"]
    rows = []
    for _, group in fresh.groupby(keys, sort=True):
        promises = group["method"].map(is_exact).astype(bool)
        others = group[~promises & ~group["method"].isin(warned)]
        for _, own in group[promises].iterrows():
            row = {key: own[key] for key in ["family", *CELL_KEYS, "ns"]}
            edge = others[others["method"] == EDGE]
            row |= _ratio("of_edge", by_cell, own, edge)
            best = others[others["ns"] == others["ns"].min()].head(1)
            row |= _ratio("of_fastest", by_cell, own, best)
            row["fastest"] = best["method"].iloc[0] if len(best) else "–"
            rows.append(row)
    columns = ["family", *CELL_KEYS, "ns"]
    for name in ("of_edge", "of_fastest"):
        columns += [name, f"{name}_low", f"{name}_high"]
    frame = pd.DataFrame(rows, columns=[*columns, "fastest"])
    return sort_cells(frame, ["method", "scalar", "isa", "scene"])


def _ratio(
    column: str, by_cell: Samples, own: pd.Series, other: pd.DataFrame
) -> dict[str, float]:
    """Throughputs are to each other as times the other way round."""
    values: tuple[float, ...] = (math.nan,) * 3
    if len(other):
        top = by_cell[own["shard"], other["name"].iloc[0]]
        values = ratio_interval(top, by_cell[own["shard"], own["name"]])[:3]
    return dict(zip((column, f"{column}_low", f"{column}_high"), values))


def worst_ratios(table: pd.DataFrame, column: str) -> dict[str, pd.Series]:
    """Scalar → the row of the method `exact` with the smallest ratio."""
    own = table[(table["method"] == "exact") & table[column].notna()]
    return {
        scalar: rows.loc[rows[column].idxmin()]
        for scalar, rows in own.groupby("scalar")
    }
