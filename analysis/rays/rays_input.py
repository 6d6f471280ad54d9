"""The exhibits of what the input does to methods for rays: from how many rays a
set-up pays, what a way out and what culling saves. Tables, charts and statistics
are those of points.
"""

from __future__ import annotations

from typing import Final

import pandas as pd

from analysis.rays.rays_claims import ray_break_evens
from analysis.rays.rays_tables import without_tuv
from analysis.read.run import Run
from analysis.report import columns
from analysis.report.columns import number, with_interval, word
from analysis.report.exhibits import Exhibits
from analysis.speed.break_even import WHOLE_VECTOR, break_even_words, ratios_by_size
from analysis.speed.input_charts import RAYS, hit_chart, size_chart
from analysis.speed.input_tables import (
    along_hit_rates,
    by_hit_rate,
    culling,
    early_out,
    of_comparisons,
)
from analysis.speed.tables import fixed_against_fresh, speed_cells

CULLING: Final = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    word("loop", "loop"),
    number("ns", "ns/item"),
    with_interval("over_two_sided", "× two-sided", "over the same without culling"),
)


def add_ray_input(
    exhibits: Exhibits, run: Run, scalars: list[str], footer: str
) -> None:
    """Break-even, the way out, repeated input and culling."""
    rays = run.rays
    if not len(rays.speed):
        return
    cells = without_tuv(speed_cells(rays.speed))
    sizes = ratios_by_size(rays.speed, cells)
    evens = ray_break_evens(rays, cells)
    for scalar in scalars:
        own = sizes[sizes["scalar"] == scalar]
        if own["n"].nunique() > 1:
            exhibits.figure(
                size_chart(own, evens, scalar, run.machine.caches, footer, RAYS),
                f"Time by the rays that a triangle meets, {scalar}; every call sets up "
                "another triangle. Above: ns per ray. Below: the time of a call over "
                "that of the method that is cheapest to set up; where a line passes "
                "below 1 the set-up is won back. Whiskers are 95 % intervals.",
                own,
            )
    if len(evens):
        exhibits.table(
            "ray_break_even",
            "From how many rays a triangle the dearer set-up pays: against what takes "
            f"least for {WHOLE_VECTOR} rays, and for the pairs that a claim is about. "
            "In brackets the numbers of rays that were timed and between which it lies; "
            "where in between is a guess, as times jump there.",
            evens.assign(words=[break_even_words(row) for _, row in evens.iterrows()]),
            columns.break_even("ray"),
        )
    early = early_out(rays.speed, cells)
    for scalar in scalars:
        along = along_hit_rates(early[early["scalar"] == scalar])
        if along["hit"].nunique() > 1 and "fresh" in set(along["sets"]):
            rows = by_hit_rate(cells, along)
            exhibits.figure(
                hit_chart(rows, along, scalar, footer, RAYS),
                f"Time by the share of rays that hit, {scalar}. Dark: without "
                "branches; light: with a way out after each test. Fresh input has "
                "another triangle at every call, fixed always the same. Whiskers are "
                "95 % intervals.",
                rows,
            )
    if len(early):
        exhibits.table(
            "ray_early_out",
            "A way out after each test, over the same method without: below 1 it "
            "saves time.",
            early,
            columns.early_out("ray", "hit"),
        )
    fixed = fixed_against_fresh(rays.speed, cells)
    if len(fixed):
        exhibits.table(
            "ray_fixed",
            "Rays on fresh input against the same rays and triangle again and again, "
            "every cell that has both.",
            fixed,
            columns.FIXED,
        )
    culled = culling(rays.speed, of_comparisons(cells))
    if len(culled):
        exhibits.table(
            "ray_culled",
            "Hitting only what is seen from the front, over the same method for both "
            "sides, on the same rays.",
            culled,
            CULLING,
        )
