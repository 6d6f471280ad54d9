"""The look of every method, ISA and loop, pinned for ever.

A method keeps its colour when others come and go. The hues are those of Okabe
and Ito (2008) and, for the methods still to come, of Tol's muted set; both
can be told apart with the common colour blindnesses. Variants of one formula
share its hue and differ in fill and dash, so that no more hues are needed
than an eye can tell.
"""

from __future__ import annotations

import dataclasses
from typing import Final


@dataclasses.dataclass(frozen=True)
class MethodStyle:
    colour: str
    variant: bool = False  # drawn hollow and dashed

    @property
    def dash(self) -> str:
        return "--" if self.variant else "-"


METHODS: Final = {
    "cross_product": MethodStyle("#0072B2"),
    "cross_product_early_out": MethodStyle("#0072B2", variant=True),
    "cross_product_unhoisted": MethodStyle("#56B4E9", variant=True),
    "cross_product_det": MethodStyle("#3D9BD4"),
    "cross_product_det_fma": MethodStyle("#3D9BD4", variant=True),
    "cross_product_fast_math": MethodStyle("#E31A1C", variant=True),
    "epsilon": MethodStyle("#8C510A"),
    "epsilon_fma": MethodStyle("#B5793A", variant=True),
    "cross_product_centered": MethodStyle("#44AA99"),
    "cross_product_centered_fma": MethodStyle("#44AA99", variant=True),
    "cross_product_centered_top_left": MethodStyle("#1F6F66", variant=True),
    "cross_product_centered_top_left_fma": MethodStyle("#2F9A8C", variant=True),
    "cross_product_kahan": MethodStyle("#117733"),
    "promoted_f64": MethodStyle("#332288"),
    "promoted_f64_fma": MethodStyle("#332288", variant=True),
    "promoted_f64_kahan": MethodStyle("#7A68D0"),
    "shewchuk_adaptive": MethodStyle("#CC6677"),
    "ozaki_adaptive": MethodStyle("#CC6677", variant=True),
    "double_double": MethodStyle("#661100"),
    "edge_function": MethodStyle("#D55E00"),
    "edge_function_fma": MethodStyle("#D55E00", variant=True),
    "edge_function_top_left": MethodStyle("#F0803C", variant=True),
    "edge_function_top_left_fma": MethodStyle("#E8A070", variant=True),
    "edge_slope": MethodStyle("#1B9EC9"),
    "edge_slope_fma": MethodStyle("#1B9EC9", variant=True),
    "barycentric_inverse": MethodStyle("#B5588C"),
    "barycentric_inverse_fma": MethodStyle("#B5588C", variant=True),
    "barycentric_determinant": MethodStyle("#009E73", variant=True),
    "barycentric_determinant_fma": MethodStyle("#5DBB63", variant=True),
    "barycentric_determinant_closed": MethodStyle("#009E73"),
    "barycentric_determinant_closed_fma": MethodStyle("#5DBB63"),
    "uv_projection": MethodStyle("#C98A00"),
    "uv_projection_fma": MethodStyle("#C98A00", variant=True),
    "cross_solve": MethodStyle("#222222"),
    "cross_solve_fma": MethodStyle("#6B6B6B", variant=True),
    "cross_solve_published": MethodStyle("#222222", variant=True),
    "cross_solve_published_fma": MethodStyle("#4A4A4A", variant=True),
    "exact": MethodStyle("#882255"),
    "exact_open": MethodStyle("#882255", variant=True),
    "exact_top_left": MethodStyle("#D6409F"),
    "snapped_i16": MethodStyle("#999933"),
    "snapped_u8": MethodStyle("#999933", variant=True),
    "byte_pairs": MethodStyle("#6A51A3"),
    "byte_spans": MethodStyle("#6A51A3", variant=True),
    "edge_lanes": MethodStyle("#A6761D", variant=True),
    "grid_incremental": MethodStyle("#1B7837", variant=True),
    "grid_clipped": MethodStyle("#1B7837"),
    "row_spans": MethodStyle("#B2182B", variant=True),
    "row_spans_batched": MethodStyle("#B2182B"),
    # Calls into other libraries: muted, one hue a library.
    "boost_covered_by": MethodStyle("#7B8FA6"),
    "boost_franklin": MethodStyle("#7B8FA6", variant=True),
    "cgal_cartesian": MethodStyle("#A68A7B", variant=True),
    "cgal_exact": MethodStyle("#8C6D5C"),
    "cgal_orientation": MethodStyle("#A68A7B"),
    "eigen_inverse": MethodStyle("#A67B97"),
    "geos_prepared": MethodStyle("#5E8C6A"),
    "geos_indexed": MethodStyle("#86A67B"),
    "geos_ray_crossing": MethodStyle("#86A67B", variant=True),
    "glm_cross": MethodStyle("#8F8AA8"),
    "glm_ray_triangle": MethodStyle("#8F8AA8", variant=True),
    "opencv_polygon_test": MethodStyle("#A69C5E"),
    "opencv_fill": MethodStyle("#A69C5E", variant=True),
}
UNKNOWN_METHOD: Final = MethodStyle("#8A8A8A")

# Narrowest first: the order of every axis, legend and table.
ISAS: Final = {
    "scalar": "o",
    "autovec_v2": "<",
    "autovec_v3": "v",
    "autovec_v4": ">",
    "ssse3": "p",
    "sse4": "s",
    "avx2": "D",
    "avx512": "*",
    "neon": "h",
    "sve": "P",
    "sve2": "X",
    "library": "d",
}
LIBRARY: Final = "library"  # none of the CPU's: a call into another library
UNKNOWN_ISA: Final = "."

# Methods of rays, which stand in charts of their own.
RAY_METHODS: Final = {
    "moller_trumbore": MethodStyle("#0072B2"),
    "moller_trumbore_fma": MethodStyle("#0072B2", variant=True),
    "moller_trumbore_early_out": MethodStyle("#56B4E9"),
    "moller_trumbore_early_out_fma": MethodStyle("#56B4E9", variant=True),
    "moller_trumbore_culled": MethodStyle("#332288"),
    "moller_trumbore_culled_fma": MethodStyle("#332288", variant=True),
    "baldwin_weber": MethodStyle("#D55E00"),
    "baldwin_weber_fma": MethodStyle("#D55E00", variant=True),
    "plane_project": MethodStyle("#117733"),
    "plane_project_fma": MethodStyle("#117733", variant=True),
    "plane_gram": MethodStyle("#C98A00"),
    "plane_gram_fma": MethodStyle("#C98A00", variant=True),
    "watertight": MethodStyle("#B5588C"),
    "watertight_fma": MethodStyle("#B5588C", variant=True),
    "watertight_culled": MethodStyle("#882255"),
    "watertight_culled_fma": MethodStyle("#882255", variant=True),
    "exact_perturbed": MethodStyle("#009E73"),
    # Calls into other libraries, as above; hollow: robust, or rounded.
    "embree_single": MethodStyle("#7B8FA6"),
    "embree_single_robust": MethodStyle("#7B8FA6", variant=True),
    "embree_packet4": MethodStyle("#6F8A93"),
    "embree_packet4_robust": MethodStyle("#6F8A93", variant=True),
    "embree_packet8": MethodStyle("#5F7F86"),
    "embree_packet8_robust": MethodStyle("#5F7F86", variant=True),
    "embree_packet16": MethodStyle("#4F7178"),
    "embree_packet16_robust": MethodStyle("#4F7178", variant=True),
    "cgal_do_intersect": MethodStyle("#8C6D5C"),
    "cgal_intersection": MethodStyle("#A68A7B"),
    "cgal_cartesian_do_intersect": MethodStyle("#8C6D5C", variant=True),
    "cgal_cartesian_intersection": MethodStyle("#A68A7B", variant=True),
}

LOOPS: Final = {
    "one_triangle": ("o", "#222222"),
    "one_triangle_aos": ("v", "#6A6A6A"),
    "one_point": ("s", "#0072B2"),
    "pairs": ("D", "#D55E00"),
    "grid": ("^", "#009E73"),
    "one_triangle_rays": ("o", "#222222"),
    "one_ray": ("s", "#0072B2"),
    "ray_pairs": ("D", "#D55E00"),
}
UNKNOWN_LOOP: Final = ("x", "#8A8A8A")

INK: Final = "#222222"
FAINT: Final = "#9A9A9A"
GRID: Final = "#E3E3E3"


def method_style(method: str) -> MethodStyle:
    return METHODS.get(method, RAY_METHODS.get(method, UNKNOWN_METHOD))


def isa_marker(isa: str) -> str:
    return ISAS.get(isa, UNKNOWN_ISA)


def loop_style(loop: str) -> tuple[str, str]:
    return LOOPS.get(loop, UNKNOWN_LOOP)


def isa_rank(isa: str) -> tuple[int, str]:
    """Sorts ISAs from narrow to wide, those without a place last."""
    names = list(ISAS)
    return (names.index(isa) if isa in ISAS else len(names), isa)


def method_rank(method: str) -> tuple[int, str]:
    """Sorts methods as they are listed here, those without a place last."""
    names = [*METHODS, *RAY_METHODS]
    return (names.index(method) if method in names else len(names), method)


def loop_rank(loop: str) -> tuple[int, str]:
    names = list(LOOPS)
    base = loop.removesuffix("_weights").removesuffix("_tuv")
    return (names.index(base) if base in LOOPS else len(names), loop)


def is_autovec(isa: str) -> bool:
    """Whether the rows are a plain loop that the compiler vectorised."""
    return isa.startswith("autovec")
