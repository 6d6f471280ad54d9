"""The report's exhibits of what the machine can do and how near methods come."""

from __future__ import annotations

import pandas as pd

from analysis.read.run import Run
from analysis.report import columns
from analysis.report.exhibits import Column, Exhibits
from analysis.speed import limit_columns, limit_tables
from analysis.speed.bounds import COUNTED_FOR
from analysis.speed.roofline import marks, roofline


def add_limits(
    exhibits: Exhibits,
    run: Run,
    cells: pd.DataFrame,
    scalars: list[str],
    footer: str,
) -> None:
    """`cells`: with bounds (analysis/speed/bounds.py)."""
    limits = run.limits
    if limits is None:
        return
    for scalar in scalars:
        shown = marks(cells, scalar)
        if len(shown):
            exhibits.figure(
                roofline(shown, limits, scalar, footer),
                f"The roofline, {scalar}: operations a second over operations a byte "
                "read. No mark can lie above the roof of its instruction set, nor "
                "above the slope of the level that its data lie in. The roofs were "
                "measured in this run. Each mark is a method at the widest "
                "instruction set, on the loop's reference scene; beside its name what it "
                "reaches of its own bound.",
                shown,
            )
    near = limit_tables.with_instructions(
        limit_tables.at_the_widest(cells), run.instructions, run.shards
    )
    if len(near):
        exhibits.table(
            "of_limit",
            "How near each method comes to its bound, at the widest instruction set.",
            near,
            limit_columns.NEAR,
        )
    wrong = limit_tables.wrong_bounds(cells)
    if len(wrong):
        exhibits.table(
            "wrong_bounds",
            "Cells that were faster than their bound, which is therefore wrong.",
            wrong,
            limit_columns.WRONG,
        )
    exhibits.table(
        "limit_rates",
        "The most operations a second of each kind, every lane counted, and how many "
        "that is a cycle of the highest clock seen beside them: the best of the "
        "repetitions.",
        limit_tables.rates(limits),
        limit_columns.rate_columns(limits),
    )
    exhibits.table(
        "limit_bandwidths",
        "The most bytes a second from each level of memory: the best of the "
        "repetitions and of one, two and six arrays read at once.",
        limit_tables.bandwidths(limits),
        limit_columns.bandwidth_columns(limits),
    )


def cells_columns(cells: pd.DataFrame) -> tuple[Column, ...]:
    """The columns of the table of all cells, with the bounds where known."""
    if "bound_ns" not in cells:
        return columns.CELLS
    return (*columns.CELLS, limit_columns.BOUND, limit_columns.OF_LIMIT)


def understated(cells: pd.DataFrame) -> str:
    """What a caption says of rows whose bound is too low; empty if there are none."""
    if "bound_ns" not in cells or set(cells["isa"]) <= set(COUNTED_FOR):
        return ""
    return (
        " On other instruction sets than AVX-512, whose operations were counted, the "
        "share of the limit is understated."
    )


def grid_columns(table: pd.DataFrame) -> tuple[Column, ...]:
    if "bound_ns" not in table:
        return columns.GRID
    last = columns.GRID[-1:]
    return (*columns.GRID[:-1], limit_columns.BOUND, limit_columns.OF_LIMIT, *last)


def verdict_columns(table: pd.DataFrame) -> tuple[Column, ...]:
    if "of_limit" not in table:
        return columns.VERDICTS
    last = columns.VERDICTS[-1:]
    return (*columns.VERDICTS[:-1], limit_columns.OF_LIMIT, *last)


def shards(run: Run, table: pd.DataFrame) -> tuple[pd.DataFrame, tuple[Column, ...]]:
    """The table of shards and its columns, with the throughput where known."""
    wider = limit_tables.with_throughput(table, run.every_shard)
    if not wider["per_cycle_before"].notna().any():
        return table, columns.SHARDS
    return wider, (*columns.SHARDS, *limit_columns.THROUGHPUT)
