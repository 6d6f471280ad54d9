"""Tables of what the machine can do, and of how near the methods come."""

from __future__ import annotations

import math
from typing import Any, Final

import pandas as pd

from analysis.charts.palette import isa_rank
from analysis.read.cells import WEIGHTS_SUFFIX
from analysis.read.limits import Limits
from analysis.read.run import Shard
from analysis.speed.bounds import beaten
from analysis.speed.tables import CELL_KEYS, sort_cells, widest_isa

_KERNEL: Final = ("method", "scalar", "loop", "isa")
SCALARS: Final = ("f32", "f64", "i32", "i16", "u8")


def bandwidths(limits: Limits) -> pd.DataFrame:
    """One row an ISA and the scalars that it loads alike: the best bytes a
    second of each level (`load_L1` …) and of stores (`store_…`), each with how
    far the median of its repetitions lay below (`…_below`) and with its rate a
    cycle (`…_per_cycle`).
    """
    memory = limits.memory.assign(
        what=limits.memory["access"] + "_" + limits.memory["level"]
    )
    rows = []
    for (isa, scalars), own in memory.groupby(["isa", "scalars"], sort=False):
        row: dict[str, Any] = {"isa": isa, "scalars": " ".join(scalars)}
        for what, group in own.groupby("what", sort=False):
            best = group.loc[group["bytes_per_second"].idxmax()]
            row[what] = best["bytes_per_second"]
            row[f"{what}_below"] = 1 - best["median"] / best["bytes_per_second"]
            row[f"{what}_per_cycle"] = (
                best["bytes_per_second"] / 1e9 / best["clock_ghz"]
            )
        rows.append(row)
    return _by_isa(pd.DataFrame(rows))


def rates(limits: Limits) -> pd.DataFrame:
    """One row an ISA and scalar: the best operations a second of each kind, and how
    many that is a cycle (`…_per_cycle`).
    """
    rows = []
    for (isa, scalar), own in limits.operations.groupby(["isa", "scalar"], sort=False):
        row: dict[str, Any] = {"isa": isa, "scalar": scalar}
        for kind, group in own.groupby("operation", sort=True):
            best = group.loc[group["operations_per_second"].idxmax()]
            row[str(kind)] = best["operations_per_second"]
            row[f"{kind}_per_cycle"] = (
                best["operations_per_second"] / 1e9 / best["clock_ghz"]
            )
        rows.append(row)
    return _by_isa(pd.DataFrame(rows, columns=None if rows else ["isa", "scalar"]))


def _by_isa(table: pd.DataFrame) -> pd.DataFrame:
    place = (
        table["scalar"] if "scalar" in table else table["scalars"].str.split().str[0]
    )
    ranks = [
        (isa_rank(isa), SCALARS.index(scalar) if scalar in SCALARS else len(SCALARS))
        for isa, scalar in zip(table["isa"], place)
    ]
    order = sorted(range(len(table)), key=lambda index: ranks[index])
    return table.iloc[order].reset_index(drop=True)


def at_the_widest(
    cells: pd.DataFrame, families: tuple[str, ...] = ("uniform", "grid_80x50")
) -> pd.DataFrame:
    """How near each method comes at the widest ISA: every loop (but those that
    write weights) on the fresh scenes of these families.
    """
    if "bound_ns" not in cells:
        return cells.iloc[:0]
    shown = cells[
        cells["family"].isin(families)
        & ~cells["scene"].str.contains("sets=fixed", regex=False)
        & ~cells["loop"].str.endswith(WEIGHTS_SUFFIX)
    ]
    parts = []
    for _, own in shown.groupby(["loop", "scalar"], sort=True):
        parts.append(own[own["isa"] == widest_isa(own)])
    joined = pd.concat([shown.iloc[:0], *parts])
    return sort_cells(joined, ["loop", "scalar", "scene", "method"])


def with_instructions(
    table: pd.DataFrame, instructions: pd.DataFrame, shards: tuple[Shard, ...]
) -> pd.DataFrame:
    """The table of cells with `instructions`, what the compiled loop executes for
    an item, a call's own ones spread over its items, and `instructions_per_cycle`
    of the shard's clock; NaN where the loop was not traced or does not repeat.
    """
    clocks = {shard.name: shard.clock_ghz for shard in shards}
    steady = instructions[instructions["items_per_iteration"] > 0]
    executed = {
        tuple(row[key] for key in _KERNEL): (row["per_item"], row["per_call"])
        for row in steady.to_dict("records")
    }
    per_item, per_cycle = [], []
    for cell in table.to_dict("records"):
        each, once = executed.get(
            tuple(cell[key] for key in _KERNEL), (math.nan, math.nan)
        )
        per_item.append(each + once / cell["items"])
        cycles = cell["ns"] * clocks.get(cell["shard"], math.nan)
        per_cycle.append(per_item[-1] / cycles)
    return table.assign(instructions=per_item, instructions_per_cycle=per_cycle)


def most_at_once(shards: tuple[Shard, ...]) -> float:
    """The most independent operations a cycle that a shard saw; NaN if none tells."""
    rates = [rate for shard in shards for rate in _per_cycle(shard) if rate == rate]
    return max(rates, default=math.nan)


def wrong_bounds(cells: pd.DataFrame) -> pd.DataFrame:
    """The cells that were faster than their bound."""
    return sort_cells(beaten(cells), CELL_KEYS)


def with_throughput(table: pd.DataFrame, shards: tuple[Shard, ...]) -> pd.DataFrame:
    """The table of shards with what independent operations reached before and
    after each, a cycle of its clock, and how that changed; NaN where a shard's
    file does not tell.
    """
    found = {shard.name: _per_cycle(shard) for shard in shards}
    nothing = (math.nan, math.nan)
    before = [found.get(name, nothing)[0] for name in table["shard"]]
    after = [found.get(name, nothing)[1] for name in table["shard"]]
    return table.assign(
        per_cycle_before=before,
        per_cycle_after=after,
        throughput_change=[b / a - 1 for a, b in zip(before, after)],
    )


def _per_cycle(shard: Shard) -> tuple[float, float]:
    return (
        shard.throughput_before_gops / shard.clock_before_ghz,
        shard.throughput_after_gops / shard.clock_after_ghz,
    )
