"""What a ray costs: operations counted, and how near each method comes to what
the machine allows.
"""

from __future__ import annotations

from typing import Final

import pandas as pd

from analysis.rays.rays_tables import MAIN_LOOP, without_tuv
from analysis.read.run import Run
from analysis.report.exhibits import Exhibits
from analysis.speed import cost_exhibits, limit_columns, limit_tables, operations_tables
from analysis.speed.bounds import with_bounds
from analysis.speed.tables import speed_cells

FAMILY: Final = "rays_uniform"
REFERENCE: Final = "hit=50:bytes=24k"  # half of the rays hit, sets in L1


def bounded(run: Run) -> pd.DataFrame:
    """The timed cells of rays with their bounds (bounds.py): those columns are
    missing if the run measured no limits.
    """
    return with_bounds(speed_cells(run.rays.speed), run.limits, run.operations)


def near_the_limit(cells: pd.DataFrame) -> pd.DataFrame:
    """Every loop and method at the widest instruction set, on the reference
    scene; without cells whose bound is not known.
    """
    reference = cells[cells["scene"].str.contains(REFERENCE, regex=False)]
    return limit_tables.at_the_widest(without_tuv(reference), (FAMILY,))


def add_ray_costs(exhibits: Exhibits, run: Run, scalars: list[str]) -> None:
    """`scalars`: those that the report shows, the first in tables of one."""
    if not len(run.rays.speed):
        return
    scalar = scalars[0] if scalars else "f32"
    counted = operations_tables.cost_table(
        run.operations, run.instructions, scalar, MAIN_LOOP
    )
    isa = operations_tables.traced_isa(run.instructions, scalar, MAIN_LOOP)
    if len(counted):
        exhibits.table(
            "ray_operations",
            f"Operations of every method for rays, one triangle, {scalar}: per ray "
            "and, below, per triangle (the set-up). Of methods that are always "
            "right it is what their filter takes, which decides every ray here."
            + (f" Instructions: executed per ray, compiled for {isa}." if isa else "")
            + " The CSV has logic, conversions, loads and stores as well.",
            counted,
            cost_exhibits.cost_columns(isa, "ray"),
        )
    near = limit_tables.with_instructions(
        near_the_limit(bounded(run)), run.instructions, run.every_shard
    )
    if len(near):
        exhibits.table(
            "ray_of_limit",
            "How near each method for rays comes to its bound, at the widest "
            "instruction set, half of the rays hitting.",
            near,
            limit_columns.NEAR,
        )
    wrong = limit_tables.wrong_bounds(bounded(run))
    if len(wrong):
        exhibits.table(
            "ray_wrong_bounds",
            "Cells of rays that were faster than their bound, which is therefore "
            "wrong.",
            wrong,
            limit_columns.WRONG,
        )
