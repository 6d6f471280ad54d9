"""What the input does to speed: how many points a call has, how many of them
are inside, and how many CPUs share them. Of rays the same, where one that hits is
"inside".

The cells of these sweeps are not those that methods are compared by elsewhere;
`of_comparisons` leaves them out.
"""

from __future__ import annotations

import pandas as pd

from analysis.read.cells import SIDE_BY_SIDE, parse_cell, parse_scene
from analysis.read.run import Cache
from analysis.speed.tables import (
    REFERENCE_BYTES,
    compared,
    parameter,
    sort_cells,
    times_other,
)

EARLY_OUT = "_early_out"  # behind the key of the method without it
CULLED = "_culled"  # in the key of a method that hits fronts alone
# Of points and of rays.
_UNIFORM = ("uniform", "rays_uniform")
_LOOPS = ("one_triangle", "one_triangle_rays")


def of_comparisons(cells: pd.DataFrame) -> pd.DataFrame:
    """The cells without those of a sweep over the number of points, those that
    several CPUs shared and those of points laid out otherwise; all of them where
    there are no others.
    """
    other = cells["loop"] == SIDE_BY_SIDE
    kept = cells[~(_counted(cells) | _shared(cells) | other)]
    return kept.reset_index(drop=True) if len(kept) else cells


def most_telling(cells: pd.DataFrame, most: int) -> pd.DataFrame:
    """No more than `most` of the cells, in the order they had: those first that
    methods are compared by, and of these the ones with half of the points inside.
    """
    compared = cells["name"].isin(of_comparisons(cells)["name"])
    hit = parameter(cells, "hit").astype(float)
    rank = 2 * ~compared + (hit.notna() & (hit != 50))
    kept = rank.sort_values(kind="stable").index[:most]
    return cells.loc[sorted(kept)].reset_index(drop=True)


def by_size(cells: pd.DataFrame) -> pd.DataFrame:
    """The sweep over the number of points of a call (`n`), on fresh input."""
    rows = cells[_counted(cells) & ~_shared(cells) & cells["loop"].isin(_LOOPS)]
    rows = rows[~rows["scene"].str.contains("sets=fixed", regex=False)]
    rows = rows.assign(n=parameter(rows, "n").astype(float))
    return sort_cells(rows, ["scalar", "isa", "method", "scene"])


def early_out(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The rows with a way out after each edge, on points in the nearest cache:
    their time over that of the same method without (`over_plain`), by the share
    of points inside (`hit`, in percent) and by `sets`.
    """
    rows = cells[
        cells["method"].str.endswith(EARLY_OUT)
        & cells["loop"].isin(_LOOPS)
        & cells["family"].isin(_UNIFORM)
        & (cells["working_set_bytes"] <= 2 * REFERENCE_BYTES)
        & ~_counted(cells)
    ]
    table = compared(
        speed,
        rows.reset_index(drop=True),
        "plain_over_own",
        lambda cell: str(cell["name"]).replace(f"{EARLY_OUT}/", "/", 1),
    )
    table = table.assign(
        hit=parameter(table, "hit").astype(float),
        sets=[parse_scene(scene).get("sets") or "fresh" for scene in table["scene"]],
        over_plain=1 / table["plain_over_own"].astype(float),
        over_plain_low=1 / table["plain_over_own_high"].astype(float),
        over_plain_high=1 / table["plain_over_own_low"].astype(float),
    )
    old = ["plain_over_own", "plain_over_own_low", "plain_over_own_high"]
    return sort_cells(
        table.drop(columns=old), ["method", "scalar", "isa", "sets", "hit"]
    )


def culling(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The methods that cull: their time over that of the same method for both
    sides, on the same rays (`over_two_sided`).
    """
    rows = cells[cells["method"].str.contains(CULLED, regex=False)]
    return times_other(
        speed,
        rows.reset_index(drop=True),
        "over_two_sided",
        lambda cell: str(cell["name"]).replace(CULLED, "", 1),
    )


def along_hit_rates(table: pd.DataFrame) -> pd.DataFrame:
    """The rows of `table` (early_out) of the ISAs that met the most hit rates."""
    rates = table.groupby(["scalar", "isa"])["hit"].transform("nunique")
    return table[rates == rates.max()].reset_index(drop=True)


def by_hit_rate(cells: pd.DataFrame, table: pd.DataFrame) -> pd.DataFrame:
    """The cells of `table` (early_out) and those that they are compared with."""
    plain = {str(name).replace(f"{EARLY_OUT}/", "/", 1) for name in table["name"]}
    rows = cells[cells["name"].isin(plain | set(table["name"]))]
    rows = rows.assign(
        hit=parameter(rows, "hit").astype(float),
        sets=[parse_scene(scene).get("sets") or "fresh" for scene in rows["scene"]],
    )
    return sort_cells(rows, ["method", "scalar", "isa", "sets", "hit"])


def by_threads(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The cells that several CPUs shared: their throughput over that of one of
    them (`speed_up`) and the bytes that they read in a second (`bandwidth`).
    """
    rows = cells[_shared(cells)].reset_index(drop=True)
    table = compared(
        speed,
        rows,
        "speed_up",
        lambda cell: f"{str(cell['name']).rpartition('/')[0]}/threads:1",
    )
    bandwidth = 1e9 * table["bytes_per_item"].astype(float)
    table = table.assign(
        threads=[int(parse_cell(name).threads or 1) for name in table["name"]],
        bandwidth=bandwidth / table["ns"].astype(float),
        bandwidth_low=bandwidth / table["ns_high"].astype(float),
        bandwidth_high=bandwidth / table["ns_low"].astype(float),
    )
    return sort_cells(table, ["scene", "scalar", "method", "isa", "threads"])


def data_caches(caches: tuple[Cache, ...]) -> list[tuple[str, int]]:
    """("L1", bytes), … of the caches that hold data, nearest first."""
    found = {c.level: c.bytes for c in caches if c.type != "Instruction"}
    return [(f"L{level}", found[level]) for level in sorted(found)]


def home(size: float, caches: tuple[Cache, ...]) -> str:
    """Where arrays of so many bytes stay from call to call."""
    fits = [name for name, held in data_caches(caches) if size <= held]
    return fits[0] if fits else "DRAM"


def _counted(cells: pd.DataFrame) -> pd.Series:
    """Whether a scene gives the number of points, and not that of bytes."""
    counted = parameter(cells, "n").astype(float).notna()
    return cells["family"].isin(_UNIFORM) & counted


def _shared(cells: pd.DataFrame) -> pd.Series:
    return cells["name"].str.contains("/threads:", regex=False).astype(bool)
