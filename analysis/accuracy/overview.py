"""The table on one page: what each method gets wrong, class by class."""

from __future__ import annotations

import math
from collections.abc import Callable

import pandas as pd

from analysis.accuracy.accuracy_tables import accuracy_loop, widest_of_each
from analysis.report.method_families import in_order
from analysis.trust.stats import wilson

# Exact methods whose holes or double hits are what a boundary rule brings about.
_BY_RULE = {
    ("open", "hole"): "exact_open",
    ("half_open", "hole"): "exact_open",
    ("closed", "double_hit"): "exact",
    ("half_open", "double_hit"): "exact",
}
# Families of scenes that are hard by a parameter: key, title.
HARD_FAMILIES = (
    ("near_edge", "near an edge"),
    ("near_vertex", "near a vertex"),
    ("needle", "needles"),
    ("offset", "far away"),
    ("scale", "tiny or huge"),
    ("exponent_spread", "exponents spread"),
    ("cancellation", "products cancel"),
    ("whole_numbers", "whole numbers"),
)
# What has its wrong answers in a column: key, title, the families. Scenes of
# special values are those of finite ones: NaN and infinity have their own class.
WRONG_ANSWERS = (
    *((family, title, (family,)) for family, title in HARD_FAMILIES),
    ("special", "special values", ("special",)),
    ("mesh", "meshes", ("mesh_pair", "mesh_fan", "mesh_triangulation")),
    ("corpus", "corpus", ("corpus",)),
)
# Classes of failure pooled over all scenes that have them: key, title, classes.
POOLED_CLASSES = (
    ("not_finite", "NaN or ∞ accepted", ("not_finite_accepted",)),
    ("hole", "holes", ("hole",)),
    ("double_hit", "double hits", ("double_hit",)),
    ("order", "other order", ("rotated_vertices", "swapped_vertices")),
    ("winding", "other winding", ("reversed_winding",)),
    ("signs", "other signs", ("negated",)),
    ("power_of_two", "other scale", ("scaled_by_power_of_two",)),
)
KEYS = (
    [key for key, _, _ in WRONG_ANSWERS]
    + ["degenerate", "boundary"]
    + [key for key, _, _ in POOLED_CLASSES]
)
# The two kinds of a wrong answer.
APART = [
    f"{key}_{kind}" for key, _, _ in WRONG_ANSWERS for kind in ("inside", "outside")
]


def overview(accuracy: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """One row a method, on the widest ISA that it has and in each family's
    main loop; for each key of KEYS
    the rate, its interval, the count and of how many (`of` 0: not measured).
    Wrong answers also have these apart: `_inside` of the points that are
    outside, and `_outside` of those that are inside.

    `boundary` is how often the method breaks the rule that it declares: a
    closed one that rejects, an open one that accepts. Half-open and top-left
    ones accept a part of the boundary by their rule, so for them nothing is
    counted. `boundary_accepted` is the share accepted, for all. Holes and
    double hits are those beyond what the rule brings about (`beyond_rule`).
    """
    own = accuracy[accuracy["scalar"] == scalar]
    loops = {family: accuracy_loop(rows) for family, rows in own.groupby("family")}
    own = own[own["loop"] == own["family"].map(loops)]
    own = beyond_rule(own)
    isas = widest_of_each(own)
    rows = []
    for method in in_order(isas):
        cells = own[(own["method"] == method) & (own["isa"] == isas[method])]
        row: dict[str, object] = {
            "method": method,
            "isa": isas[method],
            "accepts": cells["accepts"].iloc[0],
            "boundary_rule": cells["boundary_rule"].iloc[0],
        }
        for key, count, of in _counts(cells):
            interval = wilson(count, of)
            row |= {
                key: interval.value,
                f"{key}_low": interval.low,
                f"{key}_high": interval.high,
                f"{key}_count": count,
                f"{key}_of": of,
            }
        for kind in ("hole", "double_hit"):
            row[f"{kind}_by_rule"] = int(cells[f"{kind}_by_rule"].sum())
        rows.append(row)
    columns = ["method", "isa", "accepts", "boundary_rule"]
    columns += [
        f"{key}{end}"
        for key in [*KEYS, *APART, "boundary_accepted"]
        for end in ("", "_low", "_high", "_count", "_of")
    ] + ["hole_by_rule", "double_hit_by_rule"]
    return pd.DataFrame(rows, columns=columns)


def beyond_rule(cells: pd.DataFrame) -> pd.DataFrame:
    """Cells of one scalar with their `hole` and `double_hit` less, scene by
    scene, what the boundary rule brings about, and that in `hole_by_rule` and
    `double_hit_by_rule`: as many as the exact method of the same rule has
    there, whichever its ISA; 0 where none was judged.
    """
    found = cells
    for kind in ("hole", "double_hit"):
        known: dict[tuple[str, str, str], float] = {}
        for rule in ("open", "half_open", "closed"):
            exact = cells[cells["method"] == _BY_RULE.get((rule, kind))]
            for _, row in exact.dropna(subset=[kind]).iterrows():
                known[rule, row["loop"], row["scene"]] = float(row[kind])
        places = zip(cells["boundary_rule"], cells["loop"], cells["scene"])
        allowed = pd.Series(
            [known.get(p, 0.0) for p in places], index=cells.index, dtype=float
        )
        counts = cells[kind].astype(float)
        by_rule = counts.where(counts.isna() | (counts <= allowed), allowed)
        found = found.assign(
            **{kind: counts - by_rule, f"{kind}_by_rule": by_rule.fillna(0)}
        )
    return found


def _counts(cells: pd.DataFrame) -> list[tuple[str, int, int]]:
    """(key, how many, of how many) of one method's cells."""
    found = []
    total: Callable[[pd.DataFrame, str], int] = lambda part, key: int(
        part[key].astype(float).fillna(0).sum()
    )
    for key, _, families in WRONG_ANSWERS:
        part = cells[cells["family"].isin(families)]
        if key == "special":
            part = part[part["not_finite"].astype(float).fillna(0) == 0]
        wrong = {kind: total(part, f"false_{kind}") for kind in ("inside", "outside")}
        asked = {kind: total(part, f"false_{kind}_of") for kind in wrong}
        found.append((key, sum(wrong.values()), sum(asked.values())))
        found += [(f"{key}_{kind}", wrong[kind], asked[kind]) for kind in wrong]
    flat = cells[cells["family"] == "degenerate"]
    found.append(
        ("degenerate", total(flat, "false_inside"), total(flat, "false_inside_of"))
    )
    accepted = total(cells, "boundary_accepted")
    on_boundary = total(cells, "boundary_accepted_of")
    rule = cells["boundary_rule"].iloc[0]
    broken = {"closed": on_boundary - accepted, "open": accepted}.get(rule, 0)
    ruled = on_boundary if rule in ("closed", "open") else 0
    found.append(("boundary", broken, ruled))
    for key, _, kinds in POOLED_CLASSES:
        count = sum(total(cells, kind) for kind in kinds)
        of = sum(total(cells, f"{kind}_of") for kind in kinds)
        if "swapped_vertices" in kinds:
            # Counted only where a reversal changes nothing, so of so many.
            swapped = cells[cells["swapped_vertices_of"].notna()]
            of -= total(swapped, "reversed_winding")
        found.append((key, count, of))
    found.append(("boundary_accepted", accepted, on_boundary))
    return found


def failing_most(table: pd.DataFrame, key: str) -> tuple[str, float] | None:
    """The method of the whole triangle with the largest rate, and the rate."""
    known = table[(table["accepts"] == "triangle") & (table[f"{key}_of"] > 0)]
    if not len(known):
        return None
    row = known.loc[known[key].idxmax()]
    return (str(row["method"]), float(row[key]))


def never_failing(table: pd.DataFrame) -> list[str]:
    """The methods that fail in no column that was measured, and in some were."""
    return [
        str(row["method"])
        for row in table.to_dict("records")
        if row["accepts"] == "triangle"
        and any(row[f"{key}_of"] for key in KEYS)
        and all(math.isnan(row[key]) or row[key] == 0 for key in KEYS)
    ]
