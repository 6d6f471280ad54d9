"""Tables of speed: from the frames of a run to frames that can be shown.

Every function takes frames and returns a new one. Columns that end in _low
and _high hold the 95 % interval of the column before them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.charts.palette import is_autovec, isa_rank, loop_rank, method_rank
from analysis.read.cells import WEIGHTS_SUFFIX, parse_scene
from analysis.trust.row_noise import row_noise
from analysis.trust.stats import Interval, median_interval, ratio_interval

# Fits into the first-level data cache of every CPU of the last decade (32 KiB),
# and is long enough that a call's own cost does not show.
REFERENCE_BYTES = 24 * 1024

CELL_KEYS = ["loop", "scene", "method", "scalar", "isa"]


def sort_cells(frame: pd.DataFrame, by: Sequence[str] = CELL_KEYS) -> pd.DataFrame:
    """The rows in the order that people expect, not that of the alphabet."""
    ranks: dict[str, Callable[[str], object]] = {
        "loop": loop_rank,
        "scene": scene_rank,
        "method": method_rank,
        "isa": isa_rank,
    }
    keys = [
        [ranks[column](v) if column in ranks else v for v in frame[column]]
        for column in by
    ]
    order = sorted(range(len(frame)), key=lambda i: [key[i] for key in keys])
    return frame.iloc[order].reset_index(drop=True)


def scene_rank(scene: str) -> tuple[object, ...]:
    """Sorts by family, then by the parameters as numbers where they are some."""
    parsed = parse_scene(scene)
    values = []
    for key, text in parsed.parameters:
        number = parsed.number(key)
        plain = math.isnan(number)
        values.append((key, plain, 0.0 if plain else number, text))
    return (parsed.family, tuple(values))


def parameter(frame: pd.DataFrame, key: str) -> pd.Series:
    """The scenes' parameter `key` as numbers, NaN where there is none."""
    return frame["scene"].map(lambda scene: parse_scene(scene).number(key))


def samples(speed: pd.DataFrame) -> dict[tuple[str, str], npt.NDArray[np.float64]]:
    """(shard, cell name) → ns per item of each repetition, as they ran."""
    in_order = speed.sort_values("repetition", kind="stable")
    ns = in_order["ns"].to_numpy(dtype=np.float64)
    places = in_order.groupby(["shard", "name"]).indices
    return {key: ns[at] for key, at in sorted(places.items())}


_KEPT = ("threads", "items", "working_set_bytes", "bytes_per_item", "scene_bytes")
TIMED_COLUMNS: Final = [
    *("shard", "name", "family", *CELL_KEYS),
    *("ns", "ns_low", "ns_high"),
    *("items_per_second", "items_per_second_low", "items_per_second_high"),
    *("repetitions", "coverage", "noise"),
    *("times_scalar", "times_scalar_low", "times_scalar_high"),
    *_KEPT,
]


def speed_cells(speed: pd.DataFrame) -> pd.DataFrame:
    """One row a timed cell (controls left out): its median time, its speed,
    how many times as fast it is as the scalar row of the same shard, and why
    it is noisy, if it is (`noise`, empty else).
    """
    by_cell = samples(speed)
    rows = []
    plain = speed[speed["control"] == ""].drop_duplicates(["shard", "name"])
    for first in plain.sort_values(["shard", "name"]).to_dict("records"):
        shard, name = first["shard"], first["name"]
        own = by_cell[shard, name]
        time = median_interval(own)
        scalar_name = "/".join([*name.split("/")[:4], "scalar"])
        row = {key: first[key] for key in ["shard", "name", "family", *CELL_KEYS]}
        row |= {
            "ns": time.value,
            "ns_low": time.low,
            "ns_high": time.high,
            "items_per_second": 1e9 / time.value,
            "items_per_second_low": 1e9 / time.high,
            "items_per_second_high": 1e9 / time.low,
            "repetitions": len(own),
            "coverage": time.coverage,
            "noise": row_noise(own),
        }
        row |= _ratio("times_scalar", by_cell.get((shard, scalar_name)), own)
        row |= {key: first[key] for key in _KEPT}
        rows.append(row)
    return sort_cells(pd.DataFrame(rows, columns=TIMED_COLUMNS))


def _ratio(
    column: str,
    top: npt.NDArray[np.float64] | None,
    bottom: npt.NDArray[np.float64] | None,
) -> dict[str, float]:
    """NaN where one of the two was not timed in this shard."""
    if top is None or bottom is None:
        values = (math.nan, math.nan, math.nan)
    elif top is bottom:  # a cell over itself
        values = (1.0, 1.0, 1.0)
    else:
        values = ratio_interval(top, bottom)[:3]
    return dict(zip((column, f"{column}_low", f"{column}_high"), values))


def compared(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    column: str,
    other: Callable[[pd.Series], str],
) -> pd.DataFrame:
    """`cells` with the time of the cell that `other` names, of the same shard,
    over the row's own time; rows without such a cell are left out.
    """
    by_cell = samples(speed)
    rows = []
    for _, cell in cells.iterrows():
        top = by_cell.get((cell["shard"], other(cell)))
        if top is not None:
            own = by_cell[cell["shard"], cell["name"]]
            rows.append({**cell.to_dict(), **_ratio(column, top, own)})
    extra = [column, f"{column}_low", f"{column}_high"]
    return pd.DataFrame(rows, columns=[*cells.columns, *extra])


def times_other(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    column: str,
    other: Callable[[pd.Series], str],
) -> pd.DataFrame:
    """As `compared`, the other way round: the row's own time over that of the
    cell that `other` names.
    """
    table = compared(speed, cells, "inverse", other)
    ratios = {
        column: 1 / table["inverse"],
        f"{column}_low": 1 / table["inverse_high"],
        f"{column}_high": 1 / table["inverse_low"],
    }
    old = ["inverse", "inverse_low", "inverse_high"]
    return table.drop(columns=old).assign(**ratios)


def method_ratio(
    speed: pd.DataFrame, rows: pd.DataFrame, method: str, other: str
) -> Interval | None:
    """The time of a method over that of another. `rows`: timed cells of one scene,
    scalar and ISA; None if one of the two is not among them.
    """
    own = rows[rows["method"] == method].reset_index(drop=True)
    table = times_other(
        speed,
        own,
        "over",
        lambda cell: str(cell["name"]).replace(f"/{method}/", f"/{other}/"),
    )
    if not len(table):
        return None
    row = table.iloc[0]
    keys = ("over", "over_low", "over_high", "coverage")
    return Interval(*(float(row[key]) for key in keys))


def reference_scene(cells: pd.DataFrame, loop: str = "one_triangle") -> str | None:
    """The scene on which methods are compared: uniform and fresh, the hit rate
    nearest to one half, a call's arrays nearest in size to REFERENCE_BYTES.
    """
    of_loop = cells[
        (cells["loop"] == loop) & cells["family"].isin(["uniform", "rays_uniform"])
    ]
    sizes: dict[str, float] = {}
    for scene, group in of_loop.groupby("scene", sort=True):
        if "sets=fixed" not in scene:
            sizes[scene] = float(group["working_set_bytes"].median())

    def distance(scene: str) -> tuple[float, float, str]:
        hit, size = parse_scene(scene).number("hit"), sizes[scene]
        return (
            abs(hit - 50) if hit == hit else math.inf,
            abs(math.log2(size / REFERENCE_BYTES)) if size > 0 else math.inf,
            scene,
        )

    return min(sizes, key=distance) if sizes else None


def widest_isa(cells: pd.DataFrame) -> str | None:
    """Of the ISAs that most methods have a row for, the widest one; plain
    loops left to the compiler do not count.
    """
    counts: dict[str, int] = {}
    for isa, group in cells.groupby("isa"):
        if not is_autovec(isa):
            counts[isa] = group["method"].nunique()
    if not counts:
        return None
    return max(counts, key=lambda isa: (counts[isa], isa_rank(isa)))


def reference_cells(cells: pd.DataFrame, scalar: str, loop: str) -> pd.DataFrame:
    """The rows of the loop's reference scene, every method × ISA."""
    scene = reference_scene(cells, loop)
    chosen = cells[
        (cells["loop"] == loop)
        & (cells["scene"] == scene)
        & (cells["scalar"] == scalar)
    ]
    return chosen.reset_index(drop=True)


def fixed_against_fresh(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """Cells on fixed sets, with how many times as long fresh ones take."""
    fixed = cells[cells["scene"].str.contains("sets=fixed", regex=False)]
    return compared(
        speed,
        fixed.reset_index(drop=True),
        "fresh_over_fixed",
        lambda cell: str(cell["name"]).replace("sets=fixed", "sets=fresh"),
    )


def loops_compared(cells: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """Each method's time an item in each loop, at the widest ISA, on the
    loop's reference scene.
    """
    loops = [
        loop
        for loop in cells["loop"].unique()
        if not loop.endswith(WEIGHTS_SUFFIX) and loop != "grid"
    ]
    parts = [reference_cells(cells, scalar, loop) for loop in loops]
    joined = pd.concat([cells.iloc[:0], *parts], ignore_index=True)
    isa = widest_isa(joined)
    return sort_cells(joined[joined["isa"] == isa], ["method", "loop"])


def cost_of_weights(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """Cells that also write weights, with their time over that of the same
    cell without (`weights_over_bits`).
    """
    weighted = cells[cells["loop"].str.endswith(WEIGHTS_SUFFIX)]
    return times_other(
        speed,
        weighted.reset_index(drop=True),
        "weights_over_bits",
        lambda cell: str(cell["name"]).replace(f"{WEIGHTS_SUFFIX}/", "/", 1),
    )
