"""Everything a report shows: exhibits in their order, and the facts that its
prose is made of. Pure: from a run to a Report, nothing is written here.
"""

from __future__ import annotations

import dataclasses

import pandas as pd

from analysis import accuracy_tables, columns, failure_exhibits, noise, tables
from analysis.charts import fixed_against_fresh, loops, scaling
from analysis.cost_curve import cost_curve
from analysis.exact_tables import exact_errors, exact_speed
from analysis.exhibits import Exhibits
from analysis.failure_exhibits import LANE
from analysis.flags_axis import flags_axis
from analysis.hero_chart import hero
from analysis.overview import overview
from analysis.palette import method_rank
from analysis.run import Run
from analysis.verdicts import Advice, advise, unfit, verdicts
from analysis.wording import listed

# The page stays below its 5 MB whatever the profile; the CSV has every row.
MOST_ROWS = 500

MAIN_LOOP = "one_triangle"


@dataclasses.dataclass(frozen=True)
class Report:
    run: Run
    exhibits: Exhibits
    noise: noise.Verdict
    cells: pd.DataFrame
    verdicts: pd.DataFrame  # for `scalar`, at `isa`
    advice: Advice | None
    agreement: pd.DataFrame
    scalar: str  # of the main comparison
    isa: str | None  # the widest, of the main comparison
    scene: str | None
    accuracy_loop: str | None
    overviews: dict[str, pd.DataFrame]  # scalar → its table
    flags: pd.DataFrame
    exact_errors: pd.DataFrame
    exact_speed: pd.DataFrame
    cost_curve: pd.DataFrame


def build(run: Run) -> Report:
    """The report of a run."""
    cells = tables.speed_cells(run.speed)
    judged = noise.judge(run.speed, run.shards)
    scalars = [s for s in ("f32", "f64") if s in set(cells["scalar"])]
    scalar = scalars[0] if scalars else str(cells["scalar"].iloc[0])
    isa = tables.widest_isa(tables.reference_cells(cells, scalar, MAIN_LOOP))
    left_out = unfit(run.accuracy, run.methods, scalar)
    table = verdicts(run.speed, cells, run.accuracy, scalar, left_out)
    footer = _footer(run, judged)
    exhibits = Exhibits()
    _add_heroes(exhibits, run, cells, scalars, footer)
    if len(table):
        exhibits.table(
            "verdicts",
            f"Every method at its best: {scalar} on {isa}, one triangle, fresh "
            "input. “Needles” and “far away” give the largest error rate "
            "along the scenes of that family.",
            table,
            columns.VERDICTS,
        )
    overviews = {scalar: overview(run.accuracy, scalar) for scalar in scalars}
    flags = flags_axis(run.accuracy, run.speed, cells, run.methods, scalars)
    promised = exact_errors(run.accuracy)
    warned = {entry.key for entry in run.methods if entry.warning}
    price = exact_speed(run.speed, cells, warned)
    failure_exhibits.add_overview(exhibits, overviews)
    failure_exhibits.add_flags(exhibits, flags)
    _add_scaling(exhibits, cells, scalars, footer)
    failure_exhibits.add_errors(exhibits, run, scalars, footer)
    failure_exhibits.add_pictures(exhibits, run, scalars, footer)
    curve = cost_curve(run.speed, cells)
    failure_exhibits.add_exact(exhibits, promised, price, curve, footer)
    _add_fixed(exhibits, run, cells, scalar, footer)
    _add_loops(exhibits, cells, scalar, footer)
    _add_grid_and_weights(exhibits, run, cells)
    _add_whole_tables(exhibits, run, cells)
    _add_machine(exhibits, run, judged)
    return Report(
        run=run,
        exhibits=exhibits,
        noise=judged,
        cells=cells,
        verdicts=table,
        advice=advise(table, left_out) if len(table) else None,
        agreement=accuracy_tables.isa_agreement(run.accuracy),
        scalar=scalar,
        isa=isa,
        scene=tables.reference_scene(cells, MAIN_LOOP),
        accuracy_loop=accuracy_tables.accuracy_loop(run.accuracy),
        overviews=overviews,
        flags=flags,
        exact_errors=promised,
        exact_speed=price,
        cost_curve=curve,
    )


def short_revision(run: Run) -> str:
    return run.machine.revision[:12] + (" (dirty)" if run.machine.dirty else "")


def _footer(run: Run, judged: noise.Verdict) -> str:
    return "  ·  ".join(
        [
            run.machine.model,
            run.machine.compiler,
            f"revision {short_revision(run)}",
            f"profile {run.profile}",
            f"noise: {judged.word}",
        ]
    )


def _add_heroes(
    exhibits: Exhibits,
    run: Run,
    cells: pd.DataFrame,
    scalars: list[str],
    footer: str,
) -> None:
    for scalar in scalars:
        marks = accuracy_tables.speed_against_error(cells, run.accuracy, scalar)
        marks = marks.dropna(subset=["error_rate"])
        if len(marks):
            exhibits.figure(
                hero(marks, scalar, footer),
                f"Speed against error, {scalar}. Each mark is one method compiled for "
                "one instruction set, at the median of its repetitions; whiskers are "
                "95 % intervals. The black line is the frontier: nothing lies below "
                "it and to its right." + LANE * bool((marks["error_rate"] == 0).any()),
                marks,
            )


def _add_scaling(
    exhibits: Exhibits, cells: pd.DataFrame, scalars: list[str], footer: str
) -> None:
    for scalar in scalars:
        rows = tables.reference_cells(cells, scalar, MAIN_LOOP)
        rows = rows.dropna(subset=["times_scalar"])
        if len(rows):
            exhibits.figure(
                scaling(rows, scalar, footer),
                f"Speed by instruction set, {scalar}, over the scalar row of the same "
                "method. Hollow marks are a plain loop that the compiler vectorised. "
                "Whiskers are 95 % intervals of the ratio."
                + _without_scalar(cells, rows, scalar),
                rows,
            )


def _without_scalar(cells: pd.DataFrame, shown: pd.DataFrame, scalar: str) -> str:
    """A sentence on the methods that have nothing to be compared with."""
    every = tables.reference_cells(cells, scalar, MAIN_LOOP)["method"]
    missing = sorted(set(every) - set(shown["method"]), key=method_rank)
    if not missing:
        return ""
    return f" Without a scalar row, and so not shown: {listed(missing)}."


def _add_fixed(
    exhibits: Exhibits, run: Run, cells: pd.DataFrame, scalar: str, footer: str
) -> None:
    every = tables.fixed_against_fresh(run.speed, cells)
    main = every[
        (every["loop"] == MAIN_LOOP)
        & (every["scalar"] == scalar)
        & (every["family"] == "uniform")
    ]
    if len(main):
        one_scene = main[main["scene"] == main["scene"].iloc[0]]
        exhibits.figure(
            fixed_against_fresh(one_scene, scalar, footer),
            "The same kernel on other input at every call, over the same input again "
            "and again. Whiskers are 95 % intervals.",
            one_scene,
        )
    if len(every):
        exhibits.table(
            "fixed",
            "Fresh against fixed, every cell that has both.",
            every,
            columns.FIXED,
            MOST_ROWS,
        )


def _add_loops(
    exhibits: Exhibits, cells: pd.DataFrame, scalar: str, footer: str
) -> None:
    rows = tables.loops_compared(cells, scalar)
    if rows["loop"].nunique() > 1:
        exhibits.figure(
            loops(rows, scalar, footer),
            "Time an item in each loop. What an item is differs: a point in "
            "one_triangle, a triangle in one_point, a pair of both in pairs.",
            rows,
        )
        exhibits.table(
            "loops",
            f"The three loops, {scalar}. The bytes are those that an item reads.",
            rows,
            columns.LOOPS,
        )


def _add_grid_and_weights(exhibits: Exhibits, run: Run, cells: pd.DataFrame) -> None:
    grid = tables.grid_cells(cells)
    if len(grid):
        exhibits.table(
            "grid", "Time a triangle on the published pixel grid.", grid, columns.GRID
        )
    weights = accuracy_tables.weights_accuracy(run.accuracy)
    if len(weights):
        exhibits.table(
            "weights",
            "Error of the barycentric weights against exact ones, in ulps of 1 (their "
            "sum), by family of scenes; weights that came out infinite or NaN are "
            "counted apart.",
            weights,
            columns.WEIGHTS,
        )
    cost = tables.cost_of_weights(run.speed, cells)
    if len(cost):
        exhibits.table(
            "weights_cost",
            "Writing the three weights beside the bit: time over that of the same "
            "cell without.",
            cost,
            columns.WEIGHTS_COST,
            MOST_ROWS,
        )


def _add_whole_tables(exhibits: Exhibits, run: Run, cells: pd.DataFrame) -> None:
    exhibits.table("cells", "Every timed cell.", cells, columns.CELLS, MOST_ROWS)
    judged = accuracy_tables.accuracy_cells(run.accuracy)
    exhibits.table(
        "accuracy",
        "Every judged cell, one row for all instruction sets that gave the same "
        "counts; the CSV has one row for each.",
        accuracy_tables.same_counts_joined(judged),
        columns.ACCURACY,
        MOST_ROWS,
        csv=judged,
    )
    if len(run.refused):
        exhibits.table(
            "refused",
            "Cells that were not timed because their answers were not right.",
            tables.sort_cells(run.refused),
            columns.REFUSED,
            MOST_ROWS,
        )


def _add_machine(exhibits: Exhibits, run: Run, judged: noise.Verdict) -> None:
    exhibits.table(
        "shards",
        "Each shard of the speed measurement, and how quiet it was.",
        judged.shards,
        columns.SHARDS,
    )
    flags = pd.DataFrame(
        [list(entry) for entry in run.machine.flags],
        columns=["source", "isas", "flags"],
    )
    grouped = (
        flags.groupby(["isas", "flags"], sort=True)["source"]
        .agg(lambda sources: ", ".join(sorted(sources)))
        .reset_index()
    )
    if len(grouped):
        exhibits.table(
            "flags",
            "The compiler's full flags for each kernel file.",
            grouped[["source", "isas", "flags"]],
            columns.FLAGS,
        )
