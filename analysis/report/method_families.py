"""Which methods are variants of one idea, and how they stand beside each other.

A chart of all methods at once cannot be read; one panel a family can.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable
from typing import Final

from analysis.charts.palette import method_rank

FMA_SUFFIX: Final = "_fma"


@dataclasses.dataclass(frozen=True)
class Family:
    title: str
    starts: tuple[str, ...]  # a method belongs to the longest start that fits


FAMILIES: Final = (
    Family("Cross products of the edges", ("cross_product",)),
    Family(
        "Cross products about the point, compensated",
        ("cross_product_centered", "cross_product_kahan"),
    ),
    Family("Edge functions", ("edge_function",)),
    Family("Barycentric weights", ("barycentric_",)),
    Family("Projections and solutions", ("uv_projection", "cross_solve")),
    Family(
        "Exact, and recipes called exact",
        ("promoted_", "double_double", "shewchuk_", "ozaki_", "exact"),
    ),
    Family(
        "Tolerances, snapping, loosened arithmetic",
        ("epsilon", "snapped_", "cross_product_fast_math"),
    ),
)
_OTHERS: Final = Family("Others", ("",))

# Those that a chart of all methods names: one or two of each idea that people
# know, by which the others can be told.
CLASSICS: Final = (
    "cross_product",
    "edge_function",
    "edge_function_fma",
    "barycentric_inverse",
    "barycentric_determinant",
    "uv_projection",
    "cross_solve",
    "cross_solve_published",
    "promoted_f64",
    "snapped_u8",
    "exact",
)


def family_of(method: str) -> Family:
    def fit(family: Family) -> int:
        return max((len(s) for s in family.starts if method.startswith(s)), default=-1)

    return max((*FAMILIES, _OTHERS), key=fit)


def by_family(methods: Iterable[str]) -> list[tuple[Family, list[str]]]:
    """The families that have a method, each with its methods in order."""
    ordered = in_order(methods)
    found = [(f, [m for m in ordered if family_of(m) == f]) for f in FAMILIES]
    found.append((_OTHERS, [m for m in ordered if family_of(m) == _OTHERS]))
    return [(family, members) for family, members in found if members]


def in_order(methods: Iterable[str]) -> list[str]:
    """In their lasting order, a method's multiply-add form right behind it."""
    every = set(methods)

    def place(method: str) -> tuple[tuple[int, str], bool]:
        base = method.removesuffix(FMA_SUFFIX)
        fused = base != method and base in every
        return (method_rank(base if fused else method), fused)

    return sorted(every, key=place)


def leaves_early(method: str) -> bool:
    """Whether the method stops at the first edge that a point fails."""
    return method.removesuffix(FMA_SUFFIX).endswith("_early_out")


def is_exact(method: str) -> bool:
    """Whether the method promises the exact answer for every finite input."""
    return method == "exact" or method.startswith("exact_")
