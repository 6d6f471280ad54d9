"""The exhibits of where methods for rays fail: leaks and double hits as pictures,
and published cases. The pictures are drawn as those of points are.
"""

from __future__ import annotations

from typing import Any, Final

import pandas as pd

from analysis.accuracy.ulp_maps import LEAKS, claims_chart
from analysis.rays.rays_leaks import cases_table, contraction, own_arithmetic
from analysis.read.run import Run
from analysis.report.columns import sentence, word
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import listed

CONTRACTION: Final = (
    word("scalar", "scalar"),
    word("method", "method"),
    Column(
        "hit without multiply-add",
        lambda row: f"{row['plain']} of {row['of']}",
        sort="plain",
    ),
    Column("with it", lambda row: f"{row['fused']} of {row['of']}", sort="fused"),
)
CASES: Final = (
    word("id", "case"),
    word("scalar", "scalar"),
    word("truth", "exact answer"),
    Column(
        "methods that hit", lambda row: f"{row['hits']} of {row['of']}", sort="hits"
    ),
    sentence("who", "the fewer of the two"),
    sentence("source", "from"),
)


def add_ray_failures(
    exhibits: Exhibits, run: Run, scalars: list[str], footer: str
) -> None:
    """The pictures of leaks, and what the methods say of published cases."""
    for scalar in scalars:
        maps = [
            m
            for m in run.maps.ray_maps
            if m.scalar == scalar and own_arithmetic(m.method)
        ]
        if not maps:
            continue
        side = len(maps[0].claimed)
        counts = pd.DataFrame(
            [
                {"method": m.method, "scalar": m.scalar, "isa": m.isa} | m.counts
                for m in maps
            ]
        )
        exhibits.figure(
            claims_chart(maps, scalar, footer, LEAKS),
            f"Who hits a closed sphere where several of its triangles meet. A pixel is "
            f"a ray from one point inside, {side} × {side} neighbouring directions "
            "around the one that leads to the vertex exactly, a step being the gap "
            "between numbers from ½ to 1. By exact arithmetic each ray crosses the "
            "sphere once. Above without multiply-add, below with it.",
            counts,
        )
    torn = contraction(run.maps.ray_cases)
    if len(torn):
        exhibits.table(
            "ray_contraction",
            "A square of two triangles and a ray exactly on its diagonal, from a bug "
            "report: how many of the two are hit. By exact arithmetic both are, each "
            "on its edge; a surface without gaps needs one.",
            torn,
            CONTRACTION,
        )
    cases = cases_table(run.maps.ray_cases)
    if len(cases):
        exhibits.table(
            "ray_cases",
            "Published cases of rays, and which methods hit.",
            cases.assign(who=[_fewer(row) for row in cases.to_dict("records")]),
            CASES,
            csv=cases.assign(
                hit_by=cases["hit_by"].map(" ".join),
                missed_by=cases["missed_by"].map(" ".join),
            ),
        )


def contraction_words(table: pd.DataFrame) -> str:
    """Who loses the ray of that square altogether once products are fused."""
    if not len(table):
        return ""
    lost = table[(table["plain"] > 0) & (table["fused"] == 0)]
    found = table[(table["plain"] == 0) & (table["fused"] > 0)]
    parts = [
        f"{listed([f'{row.method} ({row.scalar})' for row in rows.itertuples()])} {said}"
        for rows, said in (
            (lost, "without multiply-add hit, and with it miss both triangles"),
            (found, "without multiply-add miss both triangles, and with it hit"),
        )
        if len(rows)
    ]
    either = int(((table["plain"] > 0) & (table["fused"] > 0)).sum())
    if not parts:
        return "Here it costs no method the ray."
    return "; ".join(parts) + f". Of {len(table)}, {either} hit either way."


def _fewer(row: dict[str, Any]) -> str:
    """Those that are alone with what they say."""
    if not row["hit_by"] or not row["missed_by"]:
        return "all agree"
    few, word_ = min(
        ((row["hit_by"], "hit"), (row["missed_by"], "miss")), key=lambda p: len(p[0])
    )
    return f"{listed(few)} {word_}"
