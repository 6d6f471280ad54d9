"""Tables of speed: from the frames of a run to frames that can be shown.

Every function takes frames and returns a new one. Columns that end in _low
and _high hold the 95 % interval of the column before them.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.cells import WEIGHTS_SUFFIX, parse_scene
from analysis.palette import is_autovec, isa_rank, loop_rank, method_rank
from analysis.stats import median_interval, ratio_interval

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
    """(shard, cell name) → ns per item of each repetition."""
    return {
        key: group["ns"].to_numpy(dtype=np.float64)
        for key, group in speed.groupby(["shard", "name"], sort=True)
    }


def speed_cells(speed: pd.DataFrame) -> pd.DataFrame:
    """One row a timed cell (twins left out): its median time, its speed, and
    how many times as fast it is as the scalar row of the same shard.
    """
    by_cell = samples(speed)
    rows = []
    plain = speed[~speed["twin"].astype(bool)]
    for (shard, name), group in plain.groupby(["shard", "name"], sort=True):
        first = group.iloc[0]
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
        }
        row |= _ratio("times_scalar", by_cell.get((shard, scalar_name)), own)
        row |= {
            key: first[key] for key in ("items", "working_set_bytes", "bytes_per_item")
        }
        rows.append(row)
    columns = list(rows[0]) if rows else []
    return sort_cells(pd.DataFrame(rows, columns=columns))


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


def reference_scene(cells: pd.DataFrame, loop: str = "one_triangle") -> str | None:
    """The scene on which methods are compared: uniform and fresh, the hit rate
    nearest to one half, a call's arrays nearest in size to REFERENCE_BYTES.
    """
    of_loop = cells[(cells["loop"] == loop) & (cells["family"] == "uniform")]
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
    table = compared(
        speed,
        weighted.reset_index(drop=True),
        "bits_over_weights",
        lambda cell: str(cell["name"]).replace(f"{WEIGHTS_SUFFIX}/", "/", 1),
    )
    ratios = {
        "weights_over_bits": 1 / table["bits_over_weights"],
        "weights_over_bits_low": 1 / table["bits_over_weights_high"],
        "weights_over_bits_high": 1 / table["bits_over_weights_low"],
    }
    old = ["bits_over_weights", "bits_over_weights_low", "bits_over_weights_high"]
    return table.drop(columns=old).assign(**ratios)


def grid_cells(cells: pd.DataFrame) -> pd.DataFrame:
    """The rows of the loop over a pixel grid; an item is a triangle."""
    return cells[cells["loop"] == "grid"].reset_index(drop=True)
