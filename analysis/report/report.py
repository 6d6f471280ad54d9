"""Everything a report shows: exhibits in their order, and the facts that its
prose is made of. Pure: from a run to a Report, nothing is written here.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence

import pandas as pd

from analysis.accuracy import accuracy_tables, failure_exhibits
from analysis.accuracy.cost_curve import cost_curve
from analysis.accuracy.exact_tables import exact_errors, exact_speed
from analysis.accuracy.failure_exhibits import LANE
from analysis.accuracy.flags_axis import flags_axis
from analysis.accuracy.overview import overview
from analysis.accuracy.recipes import add_recipes
from analysis.accuracy.verified import add_verified, verified
from analysis.charts.hero_chart import hero, named
from analysis.charts.palette import method_rank
from analysis.choice import choice_exhibits
from analysis.claims.evidence import Evidence
from analysis.claims.ledger import add_ledger, ledger
from analysis.cpus import cpus_exhibits
from analysis.peers.peers_exhibits import add_peers, hero_rows
from analysis.peers.peers_tables import Parted, part
from analysis.rays.rays_costs import add_ray_costs
from analysis.rays.rays_exhibits import RayChapter, add_rays
from analysis.rays.rays_failures import add_ray_failures
from analysis.rays.rays_input import add_ray_input
from analysis.read.run import Run
from analysis.report import columns
from analysis.report.exhibits import Exhibits
from analysis.report.verdicts import Advice, advise, unfit, verdicts
from analysis.report.wording import counted, grouped, listed
from analysis.speed import (
    cost_exhibits,
    goals,
    grid_tables,
    ladder,
    limit_exhibits,
    tables,
)
from analysis.speed.bounds import with_bounds
from analysis.speed.charts import fixed_against_fresh, loops, scaling
from analysis.speed.input_exhibits import InputChapter, add_input, input_chapter
from analysis.speed.input_tables import most_telling, of_comparisons
from analysis.speed.layout_tables import add_layouts
from analysis.trust import noise
from analysis.trust.noisy_marks import noise_note
from analysis.trust.placement import usual_spread
from analysis.trust.trust_exhibits import add_trust

MAIN_LOOP = "one_triangle"
MOST_CELLS = 5000  # of the table of all cells: a page of them has two megabytes
LIBRARIES = (
    " Thin diamonds are calls into other libraries, which the frontier leaves out."
)


@dataclasses.dataclass(frozen=True)
class Report:
    run: Run
    exhibits: Exhibits
    noise: noise.Verdict
    timed: pd.DataFrame  # every cell
    cells: pd.DataFrame  # those that methods are compared by
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
    verified: pd.DataFrame  # by pitbench verify, apart from the run
    exact_speed: pd.DataFrame
    cost_curve: pd.DataFrame
    placement_spreads: pd.DataFrame
    input: InputChapter
    costs: cost_exhibits.Costs
    cpus: cpus_exhibits.Cpus
    ladder: ladder.Ladder
    goals: goals.Goals
    parted: Parted
    peers: pd.DataFrame  # of the table of other libraries
    grid: pd.DataFrame  # the published scene
    layouts: pd.DataFrame  # points with x and y side by side
    rays: RayChapter
    guidance: choice_exhibits.Guidance
    claims: pd.DataFrame  # the ledger of published ones


def build(whole: Run, stored: Sequence[Run] = ()) -> Report:
    """The report of a run. Other libraries have a section and a place in the
    hero chart; everything else is about the kernels alone. `stored`: the runs
    of other CPUs to compare it with.
    """
    parted = part(whole)
    run = parted.ours
    timed = with_bounds(tables.speed_cells(run.speed), run.limits, run.operations)
    cells = of_comparisons(timed)
    judged = _judge(run, timed)
    scalars = [s for s in ("f32", "f64") if s in set(cells["scalar"])]
    scalar = scalars[0] if scalars else str(cells["scalar"].iloc[0])
    isa = tables.widest_isa(tables.reference_cells(cells, scalar, MAIN_LOOP))
    left_out = unfit(run.accuracy, run.methods, scalar)
    table = verdicts(run.speed, cells, run.accuracy, scalar, left_out)
    footer = footer_of(run, judged)
    exhibits = Exhibits()
    _add_heroes(exhibits, parted, cells, scalars, footer)
    if len(table):
        exhibits.table(
            "verdicts",
            f"Every method at its best: {scalar} on {isa}, one triangle, fresh "
            "input. “Needles” and “far away” give the largest error rate "
            "along the scenes of that family.",
            table,
            limit_exhibits.verdict_columns(table),
        )
    overviews = {scalar: overview(run.accuracy, scalar) for scalar in scalars}
    flags = flags_axis(run.accuracy, run.speed, cells, run.methods, scalars)
    promised = exact_errors(run.accuracy)
    warned = {entry.key for entry in run.methods if entry.warning}
    price = exact_speed(run.speed, cells, warned)
    failure_exhibits.add_overview(exhibits, overviews)
    failure_exhibits.add_flags(exhibits, flags)
    add_recipes(exhibits, run.accuracy)
    _add_scaling(exhibits, cells, scalars, footer)
    limit_exhibits.add_limits(exhibits, run, cells, scalars, footer)
    failure_exhibits.add_errors(exhibits, run, scalars, footer)
    failure_exhibits.add_pictures(exhibits, run, scalars, footer)
    curve = cost_curve(run.speed, cells)
    at_length = verified(run.machine.kernel_hash)
    failure_exhibits.add_exact(exhibits, promised, price, curve, footer)
    add_verified(exhibits, at_length)
    beside = add_peers(exhibits, parted, MAIN_LOOP)
    _add_fixed(exhibits, run, cells, scalar, footer)
    chapter = input_chapter(run, timed)
    add_input(exhibits, chapter, run, timed, footer)
    _add_loops(exhibits, cells, scalar, footer)
    layouts = add_layouts(exhibits, run.speed, timed)
    grid = grid_tables.published_scene(run.speed, cells, dict(run.writes))
    _add_grid_and_weights(exhibits, run, cells, grid)
    costs = cost_exhibits.add(exhibits, run, cells, scalars, scalar, footer)
    versions = dict(run.machine.libraries)
    rays = add_rays(exhibits, run.rays, scalars, footer, parted.peers.rays, versions)
    add_ray_failures(exhibits, run, scalars, footer)
    add_ray_input(exhibits, run, scalars, footer)
    add_ray_costs(exhibits, run, scalars)
    compared = cpus_exhibits.add(exhibits, run, stored, scalar, footer)
    guidance = choice_exhibits.add(exhibits, run, timed, footer)
    claims = ledger(Evidence(run, cells, timed))
    add_ledger(exhibits, claims)
    spreads = add_trust(exhibits, run.speed, judged, footer)
    every = timed
    if parted.timed:
        calls = tables.speed_cells(parted.peers.speed)
        every = tables.sort_cells(pd.concat([timed, calls], ignore_index=True))
    _add_whole_tables(exhibits, whole, every)
    _add_machine(exhibits, run, judged)
    return Report(
        run=run,
        exhibits=exhibits,
        noise=judged,
        timed=timed,
        cells=cells,
        verdicts=table,
        advice=advise(table, left_out, usual_spread(run.speed)) if len(table) else None,
        agreement=accuracy_tables.isa_agreement(run.accuracy),
        scalar=scalar,
        isa=isa,
        scene=tables.reference_scene(cells, MAIN_LOOP),
        accuracy_loop=accuracy_tables.accuracy_loop(run.accuracy),
        overviews=overviews,
        flags=flags,
        exact_errors=promised,
        verified=at_length,
        exact_speed=price,
        cost_curve=curve,
        placement_spreads=spreads,
        input=chapter,
        costs=costs,
        cpus=compared,
        ladder=ladder.add(exhibits, run, timed),
        goals=goals.add(
            exhibits,
            run,
            timed,
            {s: unfit(run.accuracy, run.methods, s) for s in scalars},
        ),
        parted=parted,
        peers=beside,
        grid=grid,
        layouts=layouts,
        rays=rays,
        guidance=guidance,
        claims=claims,
    )


def _judge(run: Run, timed: pd.DataFrame) -> noise.Verdict:
    """The noise verdict, of the shards of rays as well."""
    rays = run.rays
    if not len(rays.speed):
        return noise.judge(run.speed, run.shards, timed)
    every = pd.concat([run.speed, rays.speed], ignore_index=True)
    cells = pd.concat([timed, tables.speed_cells(rays.speed)], ignore_index=True)
    return noise.judge(every, run.every_shard, cells)


def short_revision(run: Run) -> str:
    return run.machine.revision[:12] + (" (dirty)" if run.machine.dirty else "")


def footer_of(run: Run, judged: noise.Verdict) -> str:
    return "  ·  ".join(
        [
            run.machine.name,
            run.machine.compiler,
            f"revision {short_revision(run)}",
            f"profile {run.profile}"
            + (f", ISAs up to {run.isa_up_to}" if run.isa_up_to else ""),
            f"noise: {judged.word}",
        ]
    )


def _add_heroes(
    exhibits: Exhibits,
    parted: Parted,
    cells: pd.DataFrame,
    scalars: list[str],
    footer: str,
) -> None:
    for scalar in scalars:
        marks = accuracy_tables.speed_against_error(cells, parted.ours.accuracy, scalar)
        marks = marks.dropna(subset=["error_rate"])
        beside = hero_rows(parted, cells, scalar)
        every = marks if beside is None else pd.concat([marks, beside])
        if len(marks):
            exhibits.figure(
                hero(marks, scalar, footer, beside),
                f"Speed against error, {scalar}. Each mark is one method compiled for "
                "one instruction set, at the median of its repetitions; whiskers are "
                "95 % intervals. The black line is the frontier: nothing lies below "
                "it and to its right."
                + LIBRARIES * (beside is not None and bool(len(beside)))
                + LANE * bool((every["error_rate"] == 0).any())
                + noise_note(marks[marks["method"].isin(named(marks))]),
                every,
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
                + noise_note(rows)
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
    reference = str(tables.reference_scene(cells, MAIN_LOOP))
    one_scene = main[main["scene"] == reference.replace("sets=fresh", "sets=fixed")]
    if len(one_scene):
        exhibits.figure(
            fixed_against_fresh(one_scene, scalar, footer),
            "The same kernel on other input at every call, over the same input again "
            "and again. Whiskers are 95 % intervals." + noise_note(one_scene),
            one_scene,
        )
    if len(every):
        exhibits.table(
            "fixed",
            "Fresh against fixed, every cell that has both.",
            every,
            columns.FIXED,
        )


def _add_loops(
    exhibits: Exhibits, cells: pd.DataFrame, scalar: str, footer: str
) -> None:
    rows = tables.loops_compared(cells, scalar)
    if rows["loop"].nunique() > 1:
        exhibits.figure(
            loops(rows, scalar, footer),
            "Time an item in each loop. What an item is differs: a point in "
            "one_triangle, a triangle in one_point, a pair of both in pairs."
            + noise_note(rows),
            rows,
        )
        exhibits.table(
            "loops",
            f"The three loops, {scalar}. The bytes are those that an item reads.",
            rows,
            columns.LOOPS,
        )


def _add_grid_and_weights(
    exhibits: Exhibits, run: Run, cells: pd.DataFrame, grid: pd.DataFrame
) -> None:
    if len(grid):
        exhibits.table(
            "grid",
            "Time a triangle on the published scene: its pixels as a list of points, "
            "and known to be a grid. × i32 points: how many times as fast as the "
            "edge functions on the points in 32-bit integers, on the same ISA.",
            grid,
            limit_exhibits.grid_columns(grid),
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
        )


def _add_whole_tables(exhibits: Exhibits, run: Run, cells: pd.DataFrame) -> None:
    shown = most_telling(cells, MOST_CELLS)
    caption = "Every timed cell."
    if len(shown) < len(cells):
        caption = (
            f"{counted(len(shown), 'timed cell')} of {grouped(len(cells))}: first those "
            "that methods are compared by, with half of the points inside, then others. "
            "The CSV has all."
        )
    shown_columns = limit_exhibits.cells_columns(shown)
    caption += limit_exhibits.understated(shown)
    exhibits.table("cells", caption, shown, shown_columns, csv=cells)
    judged = accuracy_tables.accuracy_cells(run.accuracy)
    exhibits.table(
        "accuracy",
        "What was judged, the scenes of a family pooled, in the loop that has most of "
        "them; instruction sets that gave the same counts are taken once. The CSV has "
        "every judged cell: each loop, scene and instruction set.",
        accuracy_tables.families_pooled(run.accuracy),
        columns.ACCURACY,
        csv=accuracy_tables.accuracy_cells(run.accuracy),
    )
    if len(run.refused):
        exhibits.table(
            "refused",
            "Cells that were not timed because their answers were not right.",
            tables.sort_cells(run.refused),
            columns.REFUSED,
        )


def _add_machine(exhibits: Exhibits, run: Run, judged: noise.Verdict) -> None:
    shards, shown = limit_exhibits.shards(run, judged.shards)
    exhibits.table(
        "shards",
        "Each shard of the speed measurement, and how quiet it was.",
        shards,
        shown,
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
