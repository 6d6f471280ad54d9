"""Kernels that are slower than the same method on the instruction set below.

The ladder is that of the hand-written vectors, from one lane up. A step is a
kernel and the nearest narrower one of the same method, scalar and loop, both
timed in one shard on the loop's reference scene. It is counted as slower where
the 95 % interval of the ratio lies above 1. Of steps that are in truth equal
the interval leaves 1 that way now and then, so what chance alone would count
stands beside the count.

An explanation is a rule on what the run holds, never a remark on a method.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Final

import pandas as pd

from analysis.read.run import Run
from analysis.report.columns import near_interval, number, ratio, sentence, word
from analysis.report.exhibits import Exhibits
from analysis.report.wording import share, significant
from analysis.speed import tables
from analysis.trust.placement import usual_spread
from analysis.trust.stats import ratio_interval

# Each with the ISAs below it, nearest first.
LADDER: Final = {
    "ssse3": ("scalar",),
    "sse4": ("ssse3", "scalar"),
    "avx2": ("sse4", "ssse3", "scalar"),
    "avx512": ("avx2", "sse4", "ssse3", "scalar"),
    "neon": ("scalar",),
    "sve": ("neon", "scalar"),
    "sve2": ("sve", "neon", "scalar"),
}
# From this share of its bound on, a kernel is at its bound.
AT_THE_BOUND: Final = 0.8
UNEXPLAINED: Final = "unexplained"
KERNEL: Final = ["loop", "scalar", "method", "isa"]
COLUMNS: Final = [*KERNEL, "below", "ns", "ratio", "ratio_low", "ratio_high"]


@dataclasses.dataclass(frozen=True)
class Ladder:
    """What the report says of the steps."""

    steps: int
    slower: int
    by_chance: str
    unexplained: int


def ladder_steps(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """One row a step: the time over that of the ISA `below`, `chance` that its
    interval lies above 1 though the two are equal, and the cell's other columns.
    """
    by_cell = tables.samples(speed)
    rows: list[dict[str, Any]] = []
    for loop in cells["loop"].unique():
        for scalar in cells["scalar"].unique():
            own = tables.reference_cells(cells, scalar, loop)
            for _, group in own.groupby(["shard", "method"], sort=True):
                kernels = {row["isa"]: row for row in group.to_dict("records")}
                rows += _steps_of(kernels, by_cell)
    extra = [c for c in cells.columns if c not in COLUMNS]
    frame = pd.DataFrame(rows, columns=[*COLUMNS, "chance", *extra])
    return tables.sort_cells(frame, ["loop", "scalar", "method", "isa"])


def _steps_of(
    kernels: dict[str, dict[str, Any]], by_cell: dict[tuple[str, str], Any]
) -> list[dict[str, Any]]:
    rows = []
    for isa, row in kernels.items():
        below = next((b for b in LADDER.get(isa, ()) if b in kernels), None)
        if below is None:
            continue
        shard = row["shard"]
        found = ratio_interval(
            by_cell[shard, row["name"]], by_cell[shard, kernels[below]["name"]]
        )
        rows.append(
            {
                **row,
                "below": below,
                "ratio": found.value,
                "ratio_low": found.low,
                "ratio_high": found.high,
                "chance": (1 - found.coverage) / 2,
            }
        )
    return rows


def slower_steps(
    steps: pd.DataFrame, instructions: pd.DataFrame, spread: float
) -> pd.DataFrame:
    """The steps whose interval lies above 1, each with why (`because`).

    `spread`: how many times as long a kernel takes in its slowest place in
    memory as in its fastest, NaN if that was not measured.
    """
    slower = steps[steps["ratio_low"] > 1]
    executed = {
        tuple(row[key] for key in KERNEL): float(row["per_item"])
        for row in instructions.to_dict("records")
    }
    because = [explanation(row, executed, spread) for row in slower.to_dict("records")]
    return slower.assign(because=because).reset_index(drop=True)


def explanation(
    step: dict[str, Any], executed: dict[tuple[Any, ...], float], spread: float
) -> str:
    """The first rule that the run's figures fit, else UNEXPLAINED."""
    of_limit = step.get("of_limit", math.nan)
    if of_limit >= AT_THE_BOUND and step.get("bound_by") == "memory":
        return (
            f"at {share(of_limit)} of what {step['bound_of']} delivers: wider "
            "vectors do not make bytes arrive sooner"
        )
    if of_limit >= AT_THE_BOUND and step.get("bound_of") == "divide":
        return f"at {share(of_limit)} of the rate of division"
    key = tuple(step[part] for part in KERNEL)
    here = executed.get(key, math.nan)
    there = executed.get((*key[:-1], step["below"]), math.nan)
    if here > there:
        return (
            f"compiled to more instructions an item: {significant(here)} against "
            f"{significant(there)}"
        )
    if step["ratio"] <= spread:
        same = " and executes as many instructions an item" if here == there else ""
        return (
            "differs no more than a kernel does from itself elsewhere in memory "
            f"({significant(spread)} in the median){same}"
        )
    return UNEXPLAINED


def add(exhibits: Exhibits, run: Run, cells: pd.DataFrame) -> Ladder:
    steps = ladder_steps(run.speed, cells)
    slower = slower_steps(steps, run.instructions, usual_spread(run.speed))
    if len(slower):
        exhibits.table(
            "slower_than_below",
            "Kernels whose time over that of the same method on the instruction set "
            "below has a 95 % interval above 1; each loop's reference scene.",
            slower,
            [
                word("loop", "loop"),
                word("scalar", "scalar"),
                word("method", "method"),
                word("isa", "ISA"),
                word("below", "ISA below"),
                number("ns", "ns/item"),
                ratio("ratio", "× below"),
                near_interval("ratio", "interval", "95 %"),
                sentence("because", "why"),
            ],
        )
    return Ladder(
        steps=len(steps),
        slower=len(slower),
        by_chance=significant(float(steps["chance"].sum())),
        unexplained=int((slower["because"] == UNEXPLAINED).sum()),
    )
