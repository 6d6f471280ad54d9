"""What the made-up run says of each method: invented times and error rates."""

from __future__ import annotations

import dataclasses


@dataclasses.dataclass(frozen=True)
class Invented:
    """ns/point in scalar f32, wrong answers per point near an edge."""

    ns: float
    error: float
    boundary: str = "closed"
    accepts: str = "triangle"
    weights: bool = False
    warning: str = ""
    only_f32: bool = False


METHODS = {
    "cross_product": Invented(1.9, 0.0357),
    "cross_product_det": Invented(2.0, 0.0358),
    "cross_product_det_fma": Invented(1.8, 0.0223),
    "cross_product_centered": Invented(2.4, 0.0121),
    "cross_product_centered_fma": Invented(2.2, 0.0091),
    "cross_product_centered_top_left": Invented(2.7, 0.0121, "top_left"),
    "cross_product_kahan": Invented(3.0, 0.004),
    "cross_product_fast_math": Invented(1.7, 0.031, warning="may call NaN inside"),
    "edge_function": Invented(1.6, 0.313),
    "edge_function_fma": Invented(1.25, 0.216),
    "edge_function_top_left": Invented(1.9, 0.313, "top_left"),
    "barycentric_inverse": Invented(1.7, 0.382, weights=True),
    "barycentric_inverse_fma": Invented(1.5, 0.361, weights=True),
    "barycentric_determinant": Invented(2.2, 0.103, "half_open", weights=True),
    "barycentric_determinant_fma": Invented(2.0, 0.092, "half_open", weights=True),
    "barycentric_determinant_closed": Invented(2.3, 0.1035, weights=True),
    "barycentric_determinant_closed_fma": Invented(2.1, 0.0931, weights=True),
    "uv_projection": Invented(2.6, 0.288, weights=True),
    "uv_projection_fma": Invented(2.4, 0.27, weights=True),
    "cross_solve": Invented(3.1, 0.0, weights=True),
    "cross_solve_fma": Invented(2.9, 0.0021, weights=True),
    "cross_solve_published": Invented(4.4, 0.34, accepts="third_near_vertex_a"),
    "promoted_f64": Invented(3.6, 0.0001, only_f32=True),
    "promoted_f64_fma": Invented(3.4, 0.00007, only_f32=True),
    "promoted_f64_kahan": Invented(5.0, 0.0, only_f32=True),
    "epsilon": Invented(2.1, 0.41),
    "shewchuk_adaptive": Invented(5.5, 0.0),
    "double_double": Invented(19.0, 0.00002),
    "snapped_i16": Invented(1.4, 0.47, only_f32=True),
    "snapped_u8": Invented(1.0, 0.49, only_f32=True),
    "exact": Invented(1.3, 0.0),
    "exact_open": Invented(1.31, 0.0, "open"),
    "exact_top_left": Invented(1.33, 0.0, "top_left"),
}

# Those that are timed and judged on every ISA, as they were invented first.
EVERYWHERE = (
    "cross_product",
    "cross_product_det",
    "cross_product_det_fma",
    "edge_function",
    "edge_function_fma",
    "barycentric_inverse",
    "barycentric_determinant",
    "barycentric_determinant_closed",
    "uv_projection",
    "cross_solve",
    "cross_solve_published",
)
ELSEWHERE = ("scalar", "avx2", "avx512")


def has_row(method: str, scalar: str, isa: str) -> bool:
    """Whether the method has a kernel of the scalar on the ISA."""
    if METHODS[method].only_f32 and scalar != "f32":
        return False
    if isa.startswith("autovec"):
        return method in ("cross_product", "edge_function")
    return method in EVERYWHERE or isa in ELSEWHERE
