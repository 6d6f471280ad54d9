"""What a run says of the prices of methods for rays, as numbers with intervals:
the functions that prose and claims are made of.

Ratios are between cells of one shard, so of one run. `cells`: tables.speed_cells
of the rays' speed, loops that write t, u and v left out.
"""

from __future__ import annotations

from typing import Final

import pandas as pd

from analysis.rays.rays_tables import BASE, KEPT, MAIN_LOOP
from analysis.read.run import RayRun
from analysis.report.method_families import FMA_SUFFIX
from analysis.speed.break_even import break_evens
from analysis.speed.tables import method_ratio, reference_cells
from analysis.trust.stats import Interval

WATERTIGHT: Final = "watertight"
# Methods that keep more of a triangle than its vertices and edges.
PRECOMPUTED: Final = (KEPT, "plane_project", "plane_gram")
# The pairs that a published claim is about: (the precomputed one, the other).
PAIRS: Final = ((KEPT, BASE), (KEPT + FMA_SUFFIX, BASE + FMA_SUFFIX))


def time_over(
    rays: RayRun, cells: pd.DataFrame, method: str, other: str, scalar: str, isa: str
) -> Interval | None:
    """The time of a method over that of another on the reference scene of one
    triangle and many rays; None if one of them was not timed there.
    """
    rows = reference_cells(cells, scalar, MAIN_LOOP)
    return method_ratio(rays.speed, rows[rows["isa"] == isa], method, other)


def fastest_of(
    cells: pd.DataFrame, methods: tuple[str, ...], scalar: str, isa: str
) -> str | None:
    """Of these methods and their forms with multiply-add the one that takes
    least time on the reference scene.
    """
    rows = reference_cells(cells, scalar, MAIN_LOOP)
    every = {*methods, *(method + FMA_SUFFIX for method in methods)}
    rows = rows[rows["method"].isin(every) & (rows["isa"] == isa)]
    return str(rows.loc[rows["ns"].idxmin(), "method"]) if len(rows) else None


def watertight_over_precomputed(
    rays: RayRun, cells: pd.DataFrame, scalar: str, isa: str
) -> tuple[str, Interval] | None:
    """The time of the watertight test, as published, over that of the fastest
    precomputed method: that method, and the ratio.
    """
    other = fastest_of(cells, PRECOMPUTED, scalar, isa)
    if other is None:
        return None
    ratio = time_over(rays, cells, WATERTIGHT, other, scalar, isa)
    return None if ratio is None else (other, ratio)


def ray_break_evens(rays: RayRun, cells: pd.DataFrame) -> pd.DataFrame:
    """From how many rays a triangle on the dearer set-up pays, as
    break_even.break_evens has it, for PAIRS and against what is cheapest.
    """
    return break_evens(rays.speed, cells, PAIRS)


def kept_break_evens(rays: RayRun, cells: pd.DataFrame) -> pd.DataFrame:
    """Those of PAIRS alone: the precomputed transformation against the test that
    keeps nothing, both with multiply-add or both without.
    """
    table = ray_break_evens(rays, cells)
    pairs = zip(table["method"], table["against"])
    ours = pd.Series([pair in PAIRS for pair in pairs], index=table.index, dtype=bool)
    return table[ours].reset_index(drop=True)
