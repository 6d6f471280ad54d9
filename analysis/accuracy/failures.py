"""How often each method fails in a run, and an input on which it does."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
import pandas as pd

from analysis.accuracy.overview import beyond_rule
from analysis.read.run import CLASSES
from analysis.report.method_families import FMA_SUFFIX

# What is asked first: a plainly wrong answer, then a hole, then an answer that
# changes with how the same question is put.
_KINDS = (
    ("false_inside", "false_outside"),
    ("hole", "double_hit"),
    ("rotated_vertices", "swapped_vertices", "reversed_winding", "negated"),
    ("scaled_by_power_of_two", "not_finite_accepted"),
)
CHANGES = (*_KINDS[2], "scaled_by_power_of_two")
# Scenes whose inputs a reader can follow stand before the others.
_PLAIN_FAMILIES = ("corpus", "near_edge", "near_vertex")

# What a boundary rule brings about for points on a shared edge.
_BY_RULE = {
    "closed": ("double_hit",),
    "open": ("hole",),
    "half_open": ("hole", "double_hit"),
}

_WORDS = {
    "false_inside": "outside by exact arithmetic, called inside",
    "false_outside": "inside by exact arithmetic, called outside",
    "hole": "inside the mesh, claimed by none of its triangles",
    "double_hit": "claimed by more than one triangle of a mesh",
    "not_finite_accepted": "not all numbers, called inside",
    "reversed_winding": "another answer when the winding is reversed",
    "rotated_vertices": "another answer when the vertices are rotated",
    "swapped_vertices": "another answer when two vertices are swapped",
    "negated": "another answer when all coordinates are negated",
    "scaled_by_power_of_two": "another answer when scaled by a power of two",
}


@dataclasses.dataclass(frozen=True)
class Example:
    """A failing input; each corner as (name, hex floats, decimals)."""

    scalar: str
    scene: str
    what: str
    distance_ulps: float
    corners: tuple[tuple[str, str, str], ...]


def plainest_examples(
    worst: pd.DataFrame, rules: Mapping[str, str] = MappingProxyType({})
) -> dict[str, Example]:
    """Method → of the failing inputs that its cells keep, which are the two
    farthest from the boundary of each kind, that of the plainest kind, from the
    plainest scenes, that takes the fewest characters. `rules`: method → its
    boundary rule; what that brings about is no failure.
    """
    by_rule = [
        distance == 0 and kind in _BY_RULE.get(rules.get(method, ""), ())
        for method, kind, distance in zip(
            worst["method"], worst["kind"], worst["distance_ulps"]
        )
    ]
    worst = worst[~pd.Series(by_rule, index=worst.index, dtype=bool)]
    ranks = {kind: rank for rank, kinds in enumerate(_KINDS) for kind in kinds}
    known = worst[worst["kind"].isin(ranks)]
    sizes = sum(known[key].str.len() for key in ("a", "b", "c", "p"))
    keyed = known.assign(
        rank=known["kind"].map(ranks),
        far=~known["family"].isin(_PLAIN_FAMILIES),
        size=sizes,
    )
    order = ["method", "rank", "far", "size", "scalar", "scene", "kind"]
    order += ["a", "b", "c", "p", "loop", "isa"]
    first = keyed.sort_values(order).drop_duplicates("method")
    return {row["method"]: _example(row) for row in first.to_dict("records")}


def counted_failures(accuracy: pd.DataFrame) -> dict[str, dict[str, int]]:
    """Method → kind of failure → how many of all its answers, holes and double
    hits beyond what its boundary rule brings about.
    """
    kinds = [kind for group in _KINDS for kind in group]
    parts = [beyond_rule(part) for _, part in accuracy.groupby("scalar")]
    if not parts:
        return {}
    counts = pd.concat(parts)[["method", *kinds]].set_index("method")
    sums = counts.astype(float).fillna(0).groupby(level=0).sum().astype(int)
    return {str(method): dict(row) for method, row in sums.to_dict("index").items()}


def told_apart_nowhere(accuracy: pd.DataFrame) -> dict[str, tuple[str, int]]:
    """Form by multiply-add → the method that it is a form of, if all counts of
    the two are the same in every cell that both have, and how many these are.
    """
    keys = ["scalar", "loop", "scene", "isa"]
    counts = accuracy[["method", *keys, *CLASSES]].set_index("method")
    counts[CLASSES] = counts[CLASSES].astype(float).fillna(-1)
    found = {}
    for method in sorted(set(counts.index)):
        base = method.removesuffix(FMA_SUFFIX)
        if base == method or base not in counts.index:
            continue
        both = counts.loc[[method]].merge(
            counts.loc[[base]], on=keys, suffixes=("", "_base")
        )
        base_counts = both[[f"{kind}_base" for kind in CLASSES]]
        if len(both) and (both[CLASSES].to_numpy() == base_counts.to_numpy()).all():
            found[method] = (base, len(both))
    return found


def _example(row: dict[str, object]) -> Example:
    scalar = str(row["scalar"])
    return Example(
        scalar=scalar,
        scene=str(row["scene"]),
        what=_WORDS[str(row["kind"])],
        distance_ulps=float(str(row["distance_ulps"])),
        corners=tuple(
            (
                name,
                f"({', '.join(str(row[key]).split())})",
                f"({', '.join(decimal(x, scalar) for x in str(row[key]).split())})",
            )
            for name, key in (("A", "a"), ("B", "b"), ("C", "c"), ("p", "p"))
        ),
    )


def decimal(text: str, scalar: str) -> str:
    """The shortest decimal that is read back as the same number: 0x1p-1 → 0.5."""
    if "0x" not in text:
        return text
    value = float.fromhex(text)
    if scalar == "f32":
        shortest = np.format_float_positional(np.float32(value), trim="-")
        long = np.format_float_scientific(np.float32(value), trim="-")
    else:
        shortest = np.format_float_positional(value, trim="-")
        long = np.format_float_scientific(value, trim="-")
    if not math.isfinite(value):
        return str(value)
    return shortest if len(shortest) <= len(long) + 3 else long
