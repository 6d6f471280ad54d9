"""The report's exhibits of what goes wrong: tables, heat maps and pictures."""

from __future__ import annotations

from collections.abc import Callable

import pandas as pd

from analysis.accuracy import accuracy_tables, failure_columns
from analysis.accuracy.accuracy_charts import errors_along
from analysis.accuracy.cost_curve import (
    BOUNDARY,
    EXACTLY,
    along_share,
    curve_chart,
    worst_scenes,
)
from analysis.accuracy.flags_axis import MESH
from analysis.accuracy.gradients import gradients_chart
from analysis.accuracy.hardness import HARDNESSES, Hardness
from analysis.accuracy.heat_maps import heat_map
from analysis.accuracy.ulp_maps import answers_chart, claims_chart
from analysis.charts.chart_frame import Chart
from analysis.read.maps import UlpMap
from analysis.read.run import Run
from analysis.report import columns
from analysis.report.exhibits import Exhibits
from analysis.speed import tables
from analysis.trust.noisy_marks import noise_note

MOST_WORST = 60
Draw = Callable[[list[UlpMap], str, str], Chart]

LANE = (
    " Marks in the grey lane made no error at all; the whisker above them ends at "
    "the largest rate that this leaves possible."
)
# Families whose rates are also drawn as lines with their intervals; of the others
# the heat maps say enough.
_WITH_CURVES = ("near_edge", "needle", "offset")


def add_overview(exhibits: Exhibits, overviews: dict[str, pd.DataFrame]) -> None:
    for scalar, table in overviews.items():
        if not len(table):
            continue
        isas = table["isa"].mode()
        exhibits.table(
            f"overview-{scalar}",
            f"What goes wrong, {scalar} on {isas.iloc[0] if len(isas) else ''}: the "
            "share of answers that fail in each way, all scenes of the run that ask "
            "for it together. Where answers are wrong, the upper number is the share "
            "of the points outside that were called inside (false inside), the lower "
            "that of the points inside that were called outside. White: none of so "
            "many. A dash: not measured. Point at a number for its count and "
            "interval. Special values are zeros of either sign, subnormal and the "
            "largest numbers; the corpus is cases from bug reports. Holes and double hits are those "
            "beyond what the method's boundary rule brings about – an open triangle "
            "leaves its edges to nobody, two closed ones share theirs – as the exact "
            "method of that rule shows it on the same points; so they are at least "
            "this many. Half-open ones are allowed the holes of the open rule and "
            "the double hits of the closed one.",
            table,
            failure_columns.OVERVIEW,
        )


def add_flags(exhibits: Exhibits, table: pd.DataFrame) -> None:
    if len(table):
        exhibits.table(
            "flags_axis",
            "What a compiler's flag changes: each form with multiply-add, or with a "
            "warning, beside the plain one. ⚠: kept as a warning. Holes and double "
            f"hits are shares of the points of {MESH}, which lie at the shared edge "
            "of two triangles, beyond those that the boundary rule brings about.",
            table,
            failure_columns.FLAGS_AXIS,
        )


def add_errors(exhibits: Exhibits, run: Run, scalars: list[str], footer: str) -> None:
    """For each family its curves, then its heat map; then the worst inputs."""
    isa = str(tables.widest_isa(run.accuracy))
    for hardness in HARDNESSES:
        parts: dict[str, pd.DataFrame] = {}
        for scalar in scalars:
            along = accuracy_tables.errors_along(
                run.accuracy, hardness.family, hardness.key, scalar, isa
            )
            if len(along):
                parts[scalar] = along
        if not parts:
            continue
        joined = pd.concat(
            [part.assign(scalar=scalar) for scalar, part in parts.items()]
        )
        if hardness.family in _WITH_CURVES:
            zeros = bool((joined["error_rate"] == 0).any())
            exhibits.figure(
                errors_along(parts, hardness, isa, footer),
                f"Error rate against {hardness.axis} ({isa}), a row a family of "
                "methods, the others in grey. Bands are Wilson intervals."
                + LANE * zeros,
                joined,
            )
        if hardness.family != "near_edge":
            exhibits.figure(
                heat_map(parts, hardness, isa, footer), _heat_caption(hardness), joined
            )
    _add_worst(exhibits, run)


def _heat_caption(hardness: Hardness) -> str:
    return (
        f"Error rate of each method by {hardness.axis}. A colour a decade; white: "
        "no error among the points of that scene."
    )


def _add_worst(exhibits: Exhibits, run: Run) -> None:
    wrong = run.worst[run.worst["kind"].isin(["false_inside", "false_outside"])]
    worst = accuracy_tables.worst_answers(wrong)
    if len(worst):
        exhibits.table(
            "worst",
            "For each method and scalar, the wrong answers farthest from the boundary. "
            "The coordinates can be given as they are to pitbench classify.",
            worst,
            columns.WORST,
            MOST_WORST,
        )


def add_pictures(exhibits: Exhibits, run: Run, scalars: list[str], footer: str) -> None:
    pictures: tuple[tuple[Draw, str], ...] = (
        (
            answers_chart,
            "What each method says of neighbouring floating-point numbers: a pixel "
            "is a point (0.5 + i·u, 0.5 + j·u), u the gap between two of them, x to "
            "the right and y upwards, asked of a triangle of size 36 whose edge runs "
            "through the diagonal. The exact answer is inside below it.",
        ),
        (
            claims_chart,
            "The same points asked of that triangle and of its neighbour beyond the "
            "diagonal. By exact arithmetic each point beside the diagonal is inside "
            "exactly one.",
        ),
    )
    for draw, caption in pictures:
        for scalar in scalars:
            maps = [m for m in run.maps.ulp_maps if m.scalar == scalar]
            if maps:
                counts = pd.DataFrame(
                    [
                        {"method": m.method, "scalar": m.scalar, "isa": m.isa}
                        | m.counts
                        for m in maps
                    ]
                )
                exhibits.figure(draw(maps, scalar, footer), caption, counts)
    for scalar in scalars:
        gradients = [g for g in run.maps.gradients if g.scalar == scalar]
        if gradients:
            exhibits.figure(
                gradients_chart(gradients, scalar, footer),
                "Triangles with a red, a green and a blue corner: each pixel is the "
                "corners' colours mixed by the weights that the method computed there.",
                pd.DataFrame(
                    [
                        {"method": g.method, "scalar": g.scalar, "scene": g.scene}
                        | {"isa": g.isa, "pixels_inside": int(g.inside.sum())}
                        for g in gradients
                    ]
                ),
            )
    if run.maps.two_truths:
        truths = pd.DataFrame([vars(case) for case in run.maps.two_truths])
        differ = truths["binary"] != truths["decimal"]
        exhibits.table(
            "two_truths",
            "Cases from reports: what is exact for the binary numbers that a program "
            "gets, and for the decimals that somebody typed.",
            truths.assign(differ=["differ" if d else "" for d in differ]),
            failure_columns.TWO_TRUTHS,
        )


def add_exact(
    exhibits: Exhibits,
    errors: pd.DataFrame,
    speed: pd.DataFrame,
    curve: pd.DataFrame,
    footer: str,
) -> None:
    if len(errors):
        exhibits.table(
            "exact_errors",
            "Wrong answers of the exact methods, all scenes, loops and instruction "
            "sets of this run together. All instruction sets answer the same points, "
            "so the bound is that of the points, each counted once. Where no answer is wrong, the holes of the "
            "open form and the double hits of the closed one are those that its "
            "boundary rule brings about on shared edges.",
            errors,
            failure_columns.EXACT_ERRORS,
        )
    along = along_share(curve)
    if len(along):
        exactly = (along["family"] == EXACTLY).any()
        what = (
            "that lie exactly on an edge, which no bound decides"
            if exactly
            else "that were rounded onto an edge, so nearly never exactly on it"
        )
        exhibits.figure(
            curve_chart(curve, footer),
            f"Time a point against the share of points {what}. "
            "0 has a place of its own, in grey, since the axis is logarithmic. "
            "Whiskers are 95 % intervals of the median." + noise_note(along),
            along,
        )
    worst = worst_scenes(curve)
    if (worst["family"] == BOUNDARY).any():
        exhibits.table(
            "exact_worst",
            "What exact takes where every point is on the boundary, the longest "
            "first: on edges of plain triangles, and where the coordinates' exponents "
            "spread over up to nearly all that the number type has.",
            worst,
            failure_columns.EXACT_WORST,
        )
    if len(speed):
        exhibits.table(
            "exact_speed",
            "Throughput of the exact methods over that of methods that promise less, "
            "on the same input and in the same shard; 1 is as fast, more is faster.",
            speed,
            failure_columns.EXACT_SPEED,
        )
