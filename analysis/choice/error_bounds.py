"""How far from an edge a method can still be wrong: for every method a proven
bound, in units of the coordinates. The error analyses are in error_families.py.

What is known of a scene (extent.py): every coordinate lies in [low, high],
no triangle has an altitude below h nor an edge above L. A point has the
*distance* to the nearest point of the triangle's boundary. `bound` answers with
a number X: every point that is farther than X from the boundary is decided
rightly, whatever triangle and point the extent allows.

From an edge function to a distance. Let E_k be the exact edge functions (twice
the area of an edge and the point; L_k times the distance from its line), and
let the method accept if its computed values are ≥ 0, each of which has the sign
of some number within G of E_k. Then it can only be wrong within X = 2·G/h:

  A point inside, farther than X from every edge, has E_k > L_k·X ≥ h·X > G: an
  edge is no shorter than the altitude from its end.
  A point outside that is accepted has every E_k ≥ −G. If the nearest point of
  the triangle lies within an edge, it is no farther than G/L_k ≤ G/h. If it is
  a vertex with sides s ≤ t and angle α, the point lies between the outward
  normals of the two sides, so within (180° − α)/2 of one of them, and its
  distance from that side's line, at most G/s, is at least sin(α/2) times its
  distance from the vertex. For α ≥ 90° that makes √2·G/s ≤ √2·G/h; else
  sin(α/2) ≥ sin(α)/2 ≥ h/(2·s), the altitude on t being s·sin α: 2·G/h.

Where it comes from. fl(a ∘ b) = (a ∘ b)(1 + δ), |δ| ≤ u; a product of k such
factors is 1 + θ_k, |θ_k| ≤ γ_k = k·u/(1 − k·u) (Higham 2002, chapter 3). A
difference of two given coordinates is computed to within u of *itself*, however
far from the origin; that is why the cross products know nothing of M, the
largest coordinate. |ex·dy| + |ey·dx| ≤ |e|·|d| (Cauchy and Schwarz). A point at
distance X has no vertex farther away than R = L + X. So G is a polynomial in R,

  G = g0 + g1·R + g2·R²,

and X = 2·G(L + X)/h is solved for its smallest root. g2 > 0 brings a second
root, beyond which nothing is proved; there no point may be.

Second-order terms are covered by SLACK, and so are products that underflow, as
long as h² is above what `_in_range` asks. That rounding may move a weight by
u·(M/h)² is what RoundingMayDecide says of all methods alike
(harness/truth/weights.h); this is the same, method by method, as a distance.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Final

from analysis.choice.error_families import (
    DETERMINANT,
    EDGE_SLOPE,
    FAMILIES,
    GRAM,
    INVERSE,
    SLACK,
    SOLVE,
    Family,
)
from analysis.choice.extent import DIGITS, LARGEST, SMALLEST_NORMAL, Extent

# Adaptive expansions and double-double: their products and the errors of these
# neither overflow nor underflow (kernels/methods/shewchuk_adaptive.cc).
EXPANSION_RANGE: Final = {
    "f32": (2.0**-50, 2.0**62),
    "f64": (2.0**-484, 2.0**510),
}
SNAP_STEPS: Final = 127  # kernels/methods/snapped.cc
# Coordinates that differ by less are exact (kernels/methods/edge_function.cc,
# byte_pairs.cc and byte_spans.cc: from 0 to 127).
BYTES: Final = frozenset({"byte_pairs", "byte_spans"})
INTEGER_SPAN: Final = {"i32": 2**15, "i16": 2**7, "u8": 2**7}


@dataclasses.dataclass(frozen=True)
class Bound:
    """Right for every point farther than `distance` from an edge. `exact`: for
    all points, by the method's own boundary rule. `why`: what follows on the word
    exact; else the formula, or what stands in the way of a bound.
    """

    distance: float
    exact: bool
    why: str

    @property
    def known(self) -> bool:
        return math.isfinite(self.distance)


def _exact(why: str) -> Bound:
    return Bound(0.0, True, why)


def _none(why: str) -> Bound:
    return Bound(math.inf, False, why)


ALWAYS_EXACT: Final = ("exact", "exact_open", "exact_top_left")
ADAPTIVE: Final = ("shewchuk_adaptive", "ozaki_adaptive")
EXPANSIONS: Final = (*ADAPTIVE, "double_double")
SNAPPED: Final = ("snapped_i16", "snapped_u8")
# On whole numbers of any size: beyond their fast range they fall back on exact
# arithmetic (kernels/methods/incremental.cc, row_spans.cc).
EXACT_GRIDS: Final = (
    "grid_incremental",
    "grid_clipped",
    "row_spans",
    "row_spans_batched",
)


def bound(method: str, extent: Extent) -> Bound:
    """The proven bound of a method, or why there is none."""
    if extent.scalar in INTEGER_SPAN:
        return _integer_bound(method, extent)
    if method in ALWAYS_EXACT:
        return _exact("for every finite input")
    if method in EXPANSIONS:
        return _expansion_bound(method, extent)
    if method in SNAPPED:
        return _snapped_bound(extent)
    family = FAMILIES.get(method)
    if family is None:
        return _none("no bound is proved for it")
    return _rounded_bound(method, family, extent)


def bound_of_all(method: str, extents: Sequence[Extent]) -> Bound:
    """For a scene of triangles of several sizes: what holds for all of them.
    Where triangles from size l to L have one largest ratio of edge to altitude,
    the extents of l and of L are enough: for any X, 2·G(L + X)/h is then a sum of
    terms c·L, c and c/L, so convex in L, and largest at an end.
    """
    return max((bound(method, e) for e in extents), key=lambda found: found.distance)


def _integer_bound(method: str, extent: Extent) -> Bound:
    span = INTEGER_SPAN[extent.scalar]
    if method in EXACT_GRIDS:
        return _exact("on whole numbers of any size")
    if extent.width >= span:
        return _none(f"coordinates differ by more than {span - 1}")
    if method in BYTES and not 0 <= extent.low <= extent.high < span:
        return _none(f"coordinates are not all from 0 to {span - 1}")
    return _exact(
        f"since whole numbers that differ by less than {span} do not overflow"
    )


def _expansion_bound(method: str, extent: Extent) -> Bound:
    low, high = EXPANSION_RANGE[extent.scalar]
    if extent.least_magnitude < low or extent.largest > high:
        return _none("coordinates other than 0 may be too small or too large for it")
    if method in ADAPTIVE:
        return _exact("in its range, which these coordinates keep")
    if extent.steps(extent.width) <= 2.0 ** (DIGITS[extent.scalar] - 1):
        return _exact("since every difference is exact")
    return _none("its products may have more bits than it keeps")


def _snapped_bound(extent: Extent) -> Bound:
    """The point and each vertex move by at most half a step in x and in y, so
    what is decided is right unless the boundary is within half a step and half
    a step: the diagonal of a step, of a box of diagonal at most √2·L.
    """
    if not _in_range(extent, 2):
        return _none(_OUT_OF_RANGE)
    distance = SLACK * math.sqrt(2) * extent.longest / SNAP_STEPS
    return Bound(distance, False, f"X = √2·L/{SNAP_STEPS}")


_OUT_OF_RANGE: Final = (
    "triangles may be so small or so large that products of their sides leave "
    "the range of the numbers"
)


def _in_range(extent: Extent, powers: int) -> bool:
    """Whether products of `powers` lengths do not overflow, nor, where they are
    twice an area or its square, lose digits by underflow.
    """
    scalar = extent.scalar
    span = 4 * max(extent.width, extent.largest)
    if powers * math.log2(max(span, 1)) + 3 > math.log2(LARGEST[scalar]):
        return False
    if extent.altitude <= 0:
        return False
    least = math.log2(SMALLEST_NORMAL[scalar] / extent.unit) + 1
    least = max(least, -math.log2(LARGEST[scalar]) + 3)  # reciprocals
    return powers * math.log2(extent.altitude) > least


def _rounded_bound(method: str, family: Family, extent: Extent) -> Bound:
    inside = dataclasses.replace(extent, scalar="f64") if family.wide else extent
    if family.whole(extent) and _in_range(
        dataclasses.replace(inside, altitude=max(extent.step, extent.altitude)), 2
    ):
        digits = DIGITS[inside.scalar]
        return _exact(f"since nothing is rounded: {family.needs.format(digits=digits)}")
    if extent.altitude <= 0:
        return _none("triangles may have no area, up to rounding")
    if not _in_range(inside, family.powers):
        return _none(_OUT_OF_RANGE)
    slim = extent.longest / extent.altitude
    # Twice the area is at least L·h, its rounding error at most 3u·L²: else even
    # the winding may be wrong. The determinants of GRAM and INVERSE are larger.
    area = {GRAM: 80 * slim**2, INVERSE: _inverse_area(extent)}.get(family, 3 * slim)
    if SLACK * area * inside.unit >= 1:
        return _none("triangles may be so thin that rounding decides their winding")
    if family is EDGE_SLOPE and not _slopes_fit(extent):
        return _none(
            "an edge may be so steep that its slope overflows; a --precision "
            "would exclude it"
        )
    distance = _smallest_root(
        tuple(inside.unit * g for g in family.polynomial(extent)), extent
    )
    if not math.isfinite(distance):
        return _none("rounding may be as large as the triangles")
    return Bound(distance, False, f"X = {family.formula}")


def _inverse_area(extent: Extent) -> float:
    """The error of the determinant from coordinates over u and twice the area:
    4u·(|A·ax| + |B·ay|), and 2u·M² + 3u·|C| of its third term, |C| ≤ √2·M·L. The smallest of all triangles has twice the area L·h with
    L ≥ 2·h/√3.
    """
    m, h = extent.largest, extent.altitude
    return (7 * math.sqrt(2) * m * h + math.sqrt(3) * m * m) / (h * h)


def _slopes_fit(extent: Extent) -> bool:
    """Whether s·x is finite for the steepest edge that is not vertical."""
    steepest = math.log2(extent.width) - math.log2(extent.least_difference)
    across = math.log2(max(extent.largest, 1))
    return steepest + across + 3 < math.log2(LARGEST[extent.scalar])


def _smallest_root(g: tuple[float, ...], extent: Extent) -> float:
    """X = 2·SLACK·G(L + X)/h; infinite if there is none, or if points may lie
    beyond the second one.
    """
    k0, k1, k2 = (2 * SLACK * value / extent.altitude for value in g)
    size = extent.longest
    falling = 1 - k1 - 2 * k2 * size
    least = k0 + k1 * size + k2 * size * size
    square = falling * falling - 4 * k2 * least
    if falling <= 0 or square < 0:
        return math.inf
    both = falling + math.sqrt(square)
    if k2 > 0 and extent.diameter > both / (2 * k2):
        return math.inf
    return 2 * least / both


def weights_bound(method: str, extent: Extent) -> float:
    """How far a weight of a point in the triangle may be from the exact one;
    infinite where nothing is proved. Numerator and denominator with the
    roundings above, each over twice the area, which is at least L·h; a weight
    is at most 1; w_a = 1 − (w_b + w_c) has the errors of both.
    """
    family = FAMILIES.get(method)
    if family is None or not bound(method, extent).known or extent.altitude <= 0:
        return math.inf
    u, slim = extent.unit, extent.longest / extent.altitude
    if family is DETERMINANT:
        return SLACK * u * (16 * slim + 7)
    if family is SOLVE:
        return SLACK * u * (16 * slim + 6)
    if family is GRAM:
        grown = 1 / (1 - 20 * u * slim**2)
        return SLACK * u * (90 * slim**2 * grown + 7)
    if family is INVERSE:
        far = extent.largest / extent.altitude
        least = u * _inverse_area(extent)
        return SLACK * u * (14 * math.sqrt(2) * far + 4 * far**2 + 4) / (1 - least)
    return math.inf
