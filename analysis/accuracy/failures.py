"""The smallest input of the run on which each method fails."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Mapping
from types import MappingProxyType

import numpy as np
import pandas as pd

# What is asked first: a plainly wrong answer, then a hole, then an answer that
# changes with how the same question is put.
_KINDS = (
    ("false_inside", "false_outside"),
    ("hole", "double_hit"),
    ("rotated_vertices", "swapped_vertices", "reversed_winding", "negated"),
    ("scaled_by_power_of_two", "not_finite_accepted"),
)
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


def smallest_examples(
    worst: pd.DataFrame, rules: Mapping[str, str] = MappingProxyType({})
) -> dict[str, Example]:
    """Method → its smallest example: of the plainest kind that it has, from
    the plainest scenes, the one that takes the fewest characters. `rules`:
    method → its boundary rule; what that brings about is no failure.
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
