"""The error analyses, one a family of methods: by how much G the computed edge
functions may miss the exact ones, and when they do not. error_bounds.py says what
G means and makes a distance of it.

u is the unit roundoff, M the largest coordinate, L the longest edge, R the
distance from the point to the farthest vertex. Roundings are counted whether or
not some are fused: with FMA one less is made, never one more. What the texts say
of a kernel's arithmetic is in kernels/methods/, one file a formula.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Final

from analysis.choice.extent import DIGITS, SMALLEST, Extent

EPSILON: Final = {"f32": 1e-6, "f64": 1e-9}  # kernels/methods/epsilon.cc
# For second-order terms, and for what underflows in range.
SLACK: Final = 1.01


@dataclasses.dataclass(frozen=True)
class Family:
    """Methods with one error analysis. `polynomial`: g0, g1, g2 of G, over u
    but for what epsilon adds. `whole`: whether all of it is exact on multiples
    of the extent's step.
    """

    formula: str  # of X, where it is small against L
    polynomial: Callable[[Extent], tuple[float, float, float]]
    whole: Callable[[Extent], bool] = lambda extent: False
    needs: str = ""  # when `whole` holds, in words
    powers: int = 2  # lengths are multiplied so often
    wide: bool = False  # computes in f64 whatever the input is


def fits(scale: float, product: float, extent: Extent, wide: bool = False) -> bool:
    """Whether whole multiples of step² up to scale·product are exact numbers."""
    step, inside = extent.step, "f64" if wide else extent.scalar
    if step * step < SMALLEST[inside]:
        return False
    return scale * product <= 2.0 ** DIGITS[inside] * step * step


# Of each edge e from v: fl(e)·fl(P − v), two products, three factors 1 + δ each;
# their comparison, and the sign of their difference, are exact.
# G = γ₃·(|ex·dy| + |ey·dx|) ≤ 3u·|e|·|P − v|.
EDGE_CROSS = Family(
    "6u·L²/h",
    lambda s: (0.0, 3 * s.longest, 0.0),
    lambda s: fits(1, s.width**2, s),
    "the products of any two differences have at most {digits} bits",
)

# (v − P) × (w − P): as above, but both factors are seen from P.
CENTERED = Family(
    "6u·L²/h",
    lambda s: (0.0, 0.0, 3.0),
    EDGE_CROSS.whole,
    EDGE_CROSS.needs,
)

# The same, and all three ≤ 0 is accepted as well. The three E add up to twice
# the area and are all ≤ G then, so none is below −2G: as if G were 6u·R².
SOLVE = Family(
    "12u·L²/h",
    lambda s: (0.0, 0.0, 6.0),
    EDGE_CROSS.whole,
    EDGE_CROSS.needs,
)

# The sign of the products' difference is exact (Jeannerod, Louvet and Muller
# 2013), so that only the differences from P count: 1 + θ₂ a product.
KAHAN = Family(
    "4u·L²/h",
    lambda s: (0.0, 0.0, 2.0),
    lambda s: fits(1, s.step * s.width, s),
    "every difference has at most {digits} bits",
)

# In f64: as CENTERED with u = 2⁻⁵³, f32 input being exact in f64.
WIDE = dataclasses.replace(
    CENTERED,
    formula="6·2⁻⁵³·L²/h",
    whole=lambda s: fits(1, s.width**2, s, wide=True),
    wide=True,
)
WIDE_KAHAN = dataclasses.replace(
    KAHAN,
    formula="4·2⁻⁵³·L²/h",
    whole=lambda s: fits(1, s.step * s.width, s, wide=True),
    wide=True,
)

# A = fl(vy − wy), B likewise, C = −fl(fl(A·vx) + fl(B·vy)), for those rounded A
# and B. A's and B's own error tilts the line about v: u·|e|·|P − v|. Products
# and sum of C: 2u·|e|·|v|; of A·x + B·y: 2u·|e|·|P|; the last sum keeps the sign.
# |P|, |v| ≤ √2·M.
EDGE_FUNCTION = Family(
    "8√2·u·M·L/h",
    lambda s: (4 * math.sqrt(2) * s.largest * s.longest, s.longest, 0.0),
    lambda s: fits(4, s.width * s.largest, s),
    "four times a difference times a coordinate has at most {digits} bits",
)

# y = s·x + c, each line's s and c rounded from f64 (f32), the product and the
# sum. In y: u·(|s·x| + |c| + |s·x| + |y|), divided by √(1 + s²) a distance:
# u·(1 + √2 + 1 + 1)·M. In f64 s is not rounded again, but c = vy − s·vx has a
# product more, which is as much; and s itself errs by 3u, about the vertex v.
EDGE_SLOPE = Family(
    "2·(3 + √2)·u·M·L/h",
    lambda s: (
        (3 + math.sqrt(2)) * s.largest * s.longest,
        3 * s.longest if s.scalar == "f64" else 0.0,
        0.0,
    ),
)

# U and V as EDGE_CROSS, but on BC it is U + V ≤ Area that decides: U and V with
# 4 roundings each, one for their sum, Area with 4:
# 5u·|P − A|·(|AB| + |AC|) + 4u·|AB|·|AC|.
DETERMINANT = Family(
    "28u·L²/h",
    lambda s: (4 * s.longest**2, 10 * s.longest, 0.0),
    lambda s: fits(4, s.width**2, s),
    "four times the product of any two differences has at most {digits} bits",
)

# A and B as differences (δ), times the reciprocal (δ; its own error is common to
# all), times x (δ), their sum (δ): 4u·|e|·|P|. C = bx·cy − cx·by of the
# coordinates themselves: u·(|bx·cy| + |cx·by|) ≤ 2u·M², and 2u·|C| after that.
INVERSE = Family(
    "u·(12√2·M·L + 4·M²)/h",
    lambda s: (
        6 * math.sqrt(2) * s.largest * s.longest + 2 * s.largest**2,
        0.0,
        0.0,
    ),
)


# Numerators are (2·area)·E. b·b and the like: 4 roundings; times the reciprocal
# of the Gram determinant: 1; (P − A)·b: 4; product 1; sums 2: 12u. Each numerator
# has two terms of size |b|·|c|²·|P − A|, and for u + v ≤ 1 both numerators count,
# and the determinant, 22u·|b|²·|c|²: 48u·L³·R + 22u·L⁴ in all, over twice the
# area, which is at least L·h.
# The determinant's relative error ρ = 20u·(L/h)² makes that 1/(1 − ρ) as much.
def _gram(s: Extent) -> tuple[float, float, float]:
    slim = s.longest / s.altitude
    grown = 1 / (1 - 20 * s.unit * slim**2)
    return (22 * s.longest**2 * slim * grown, 48 * s.longest * slim * grown, 0.0)


GRAM = Family("140u·L³/h²", _gram, powers=4)

# EDGE_CROSS, and a point may be beyond by the area ε.
EPSILON_FAMILY = Family(
    "(6u·L² + 2·ε)/h",
    lambda s: (SLACK * EPSILON[s.scalar] / s.unit, 4 * s.longest, 0.0),
    lambda s: EDGE_CROSS.whole(s) and s.step ** 2 > EPSILON[s.scalar],
    EDGE_CROSS.needs + ", and 1 of them is more than ε",
)

FAMILIES: Final = {
    "cross_product": EDGE_CROSS,
    "cross_product_early_out": EDGE_CROSS,
    "cross_product_unhoisted": EDGE_CROSS,
    "cross_product_det": EDGE_CROSS,
    "cross_product_det_fma": EDGE_CROSS,
    "epsilon": EPSILON_FAMILY,
    "epsilon_fma": EPSILON_FAMILY,
    "cross_product_centered": CENTERED,
    "cross_product_centered_fma": CENTERED,
    "cross_product_centered_top_left": CENTERED,
    "cross_product_centered_top_left_fma": CENTERED,
    "cross_product_kahan": KAHAN,
    "promoted_f64": WIDE,
    "promoted_f64_fma": WIDE,
    "promoted_f64_kahan": WIDE_KAHAN,
    "edge_function": EDGE_FUNCTION,
    "edge_function_fma": EDGE_FUNCTION,
    "edge_function_top_left": EDGE_FUNCTION,
    "edge_function_top_left_fma": EDGE_FUNCTION,
    "edge_slope": EDGE_SLOPE,
    "edge_slope_fma": EDGE_SLOPE,
    "barycentric_determinant": DETERMINANT,
    "barycentric_determinant_fma": DETERMINANT,
    "barycentric_determinant_closed": DETERMINANT,
    "barycentric_determinant_closed_fma": DETERMINANT,
    "barycentric_inverse": INVERSE,
    "barycentric_inverse_fma": INVERSE,
    "uv_projection": GRAM,
    "uv_projection_fma": GRAM,
    "cross_solve": SOLVE,
    "cross_solve_fma": SOLVE,
}
