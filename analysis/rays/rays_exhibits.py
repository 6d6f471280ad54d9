"""The chapter on rays and triangles in space."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Final

import pandas as pd

from analysis.accuracy.accuracy_tables import speed_against_error
from analysis.charts.hero_chart import Words, hero, named
from analysis.peers.peers_exhibits import beside
from analysis.rays.ray_peers import (
    CAPTION,
    DIAMONDS,
    RayPeers,
    sources,
    table_of_libraries,
    words_of_libraries,
)
from analysis.rays.rays_tables import (
    BASE,
    KEPT,
    MAIN_LOOP,
    methods_compared,
    without_tuv,
)
from analysis.read.run import RayRun, no_rays
from analysis.report import columns
from analysis.report.columns import (
    number,
    rate_with_interval,
    sentence,
    with_interval,
    word,
)
from analysis.report.exhibits import Exhibits
from analysis.speed.input_tables import of_comparisons
from analysis.speed.tables import sort_cells, speed_cells
from analysis.trust.noisy_marks import noise_note

RAYS: Final = Words(
    "rays",
    "rays",
    "wrong answers for rays near an edge",
    (BASE, KEPT, "watertight", "plane_gram", "plane_project", "exact"),
)
CULLED: Final = (
    " Methods that hit only what they see from the front answer another question; "
    "the table has them."
)
METHODS: Final = (
    word("method", "method"),
    number("ns", "ns/ray"),
    with_interval("times_base", f"× {BASE}"),
    number("one_ray_ns", "ns/triangle, one ray", "the nearest of many triangles"),
    number("ray_pairs_ns", "ns/pair"),
    rate_with_interval("error_rate", "wrong near an edge"),
    number("holes", "leaks in a million", "rays from inside that no triangle claims"),
    number(
        "double_hits",
        "double hits in a million",
        "rays that several claim, beyond what the rule for edges brings about",
    ),
    number("t_worst", "t, ulps", "largest error of t where it hits, in ulps of t"),
    number("u_worst", "u", "largest error, in ulps of 1"),
    number("v_worst", "v", "largest error, in ulps of 1"),
)
# Where calls into other libraries stand among them.
BESIDE: Final = (METHODS[0], word("scalar", "scalar"), word("isa", "ISA"), *METHODS[1:])
SOURCES: Final = (
    word("key", "method"),
    word("boundary", "boundary"),
    sentence("formula", "what is computed"),
    sentence("source", "from"),
)


@dataclasses.dataclass(frozen=True)
class RayChapter:
    """What the prose of the chapter is made of."""

    isa: str = ""
    cells: int = 0
    refused: int = 0
    peers: RayPeers | None = None


def add_rays(
    exhibits: Exhibits,
    rays: RayRun,
    scalars: list[str],
    footer: str,
    libraries: RayRun | None = None,
    versions: Mapping[str, str] | None = None,
) -> RayChapter:
    """Adds the chapter's exhibits, if the run knows rays; beside the kernels, what
    the run knows of other libraries, of those versions.
    """
    if not len(rays.speed) or not len(rays.accuracy):
        return RayChapter()
    every = speed_cells(rays.speed)
    cells = of_comparisons(without_tuv(every))
    # Methods that cull answer another question, half of it by looking from which
    # side a ray comes; no rate of errors is fair between them and the others.
    culls = {entry.key for entry in rays.methods if entry.culls_backface}
    two_sided = cells[~cells["method"].isin(culls)].reset_index(drop=True)
    scalar = next((s for s in scalars if s in set(cells["scalar"])), "")
    others = libraries or no_rays()
    for one in scalars:
        marks = speed_against_error(
            two_sided, rays.accuracy, one, MAIN_LOOP, "rays_near_edge"
        ).dropna(subset=["error_rate"])
        calls = marks.iloc[:0]
        if len(others.speed):
            calls = beside(rays, others, two_sided, one, MAIN_LOOP, "rays_near_edge")
        if len(marks):
            exhibits.figure(
                hero(marks, one, footer, calls, words=RAYS),
                f"Speed against error for rays, {one}: one triangle, many rays, half "
                "of which hit; errors are those of rays aimed at an edge and then off "
                "by some ulps. Whiskers are 95 % intervals."
                + CULLED * bool(culls)
                + DIAMONDS * bool(len(calls))
                + noise_note(marks[marks["method"].isin(named(marks, RAYS))]),
                pd.concat([marks, calls]) if len(calls) else marks,
            )
    table = methods_compared(rays, cells, scalar)
    of_libraries = table.iloc[:0]
    if len(others.speed):
        of_libraries = table_of_libraries(rays, others, cells, scalars)
    chapter = RayChapter(
        isa=str(table["isa"].iloc[0]) if len(table) else "",
        cells=len(every),
        refused=len(rays.refused),
        peers=words_of_libraries(of_libraries, others, dict(versions or {}), scalar),
    )
    exhibits.table(
        "ray_methods",
        f"The methods for rays at their best, {scalar} on {chapter.isa}. Leaks and "
        "double hits are those of rays from inside the icosphere, half of them aimed at "
        "its edges and a quarter at its vertices, or some ulps beside; the errors of t, u and v are the "
        "largest of all scenes, grazing rays and needles among them."
        + CAPTION * bool(len(of_libraries)),
        pd.concat([table, of_libraries]) if len(of_libraries) else table,
        BESIDE if len(of_libraries) else METHODS,
    )
    if rays.methods:
        entries = [dataclasses.asdict(entry) for entry in rays.methods]
        exhibits.table(
            "ray_sources",
            "What each method for rays computes.",
            pd.DataFrame(entries + sources(others, dict(versions or {}))),
            SOURCES,
        )
    if len(rays.refused):
        exhibits.table(
            "ray_refused",
            "Cells of rays that were not timed because their answers were not right.",
            sort_cells(rays.refused),
            columns.REFUSED,
        )
    return chapter
