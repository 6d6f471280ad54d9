"""What the error bounds say of a scene, and of the program's methods. That real
kernels keep them: test_bounds_of_kernels.py.
"""

from __future__ import annotations

import dataclasses
import json
import math
import subprocess
from fractions import Fraction

import numpy as np
import pytest

from analysis.choice import error_bounds
from analysis.choice.error_bounds import (
    ALWAYS_EXACT,
    INTEGER_SPAN,
    bound,
    weights_bound,
)
from analysis.choice.error_families import FAMILIES
from analysis.choice.extent import Extent
from tests.analysis import hard_scenes
from tests.analysis.hard_scenes import PROGRAM, Rows, needs_program


@needs_program
def test_every_method_of_the_program_is_looked_at() -> None:
    listed = json.loads(
        subprocess.run(
            [str(PROGRAM), "list", "--json"], capture_output=True, check=True
        ).stdout
    )
    unknown = {
        method["key"]
        for method in listed["methods"]
        if not method.get("warning")
        and method["accepts"] == "triangle"
        and bound(method["key"], _stout("f32")).why == "no bound is proved for it"
    }
    whole = {*error_bounds.BYTES, "edge_lanes", *error_bounds.EXACT_GRIDS}
    assert unknown <= whole | {m["key"] for m in listed.get("ray_methods", [])}


def _stout(scalar: str, **other: float) -> Extent:
    values = {"low": 0.0, "high": 1.0, "altitude": 0.1, "longest": 1.0} | other
    return Extent(scalar, **values)


def test_distances_are_those_of_exact_arithmetic() -> None:
    rows = hard_scenes.hard_scene(7, "f64", 40).rows
    for row, found in zip(rows, hard_scenes.distances(rows)):
        a, b, c, p = (
            [Fraction(float(v)) for v in row[k : k + 2]] for k in (0, 2, 4, 6)
        )
        square = min(_square_distance(p, v, w) for v, w in ((a, b), (b, c), (c, a)))
        # The square root of a fraction, in more digits than are compared.
        exact = math.isqrt(int(square * 2**400)) / 2**200
        reach = float(np.abs(row).max()) * 2.0**-62
        assert float(found) == pytest.approx(exact, rel=1e-12, abs=reach)


def _square_distance(
    p: list[Fraction], v: list[Fraction], w: list[Fraction]
) -> Fraction:
    edge, way = [w[k] - v[k] for k in (0, 1)], [p[k] - v[k] for k in (0, 1)]
    length = edge[0] ** 2 + edge[1] ** 2
    at = (edge[0] * way[0] + edge[1] * way[1]) / length
    at = min(max(at, Fraction(0)), Fraction(1))
    return (way[0] - at * edge[0]) ** 2 + (way[1] - at * edge[1]) ** 2


@pytest.mark.parametrize("method", sorted(FAMILIES))
@pytest.mark.parametrize("scalar", ["f32", "f64"])
def test_a_bound_grows_as_triangles_get_thinner(method: str, scalar: str) -> None:
    found = [
        bound(method, _stout(scalar, altitude=2.0**-k)).distance for k in range(1, 24)
    ]
    assert found == sorted(found)
    assert found[0] > 0


@pytest.mark.parametrize("method", sorted(FAMILIES))
def test_a_triangle_that_may_have_no_area_has_no_bound(method: str) -> None:
    assert not bound(method, _stout("f32", altitude=0.0)).known


def test_far_from_the_origin_only_products_of_coordinates_suffer() -> None:
    near, far = _stout("f32"), _stout("f32", low=4096.0, high=4097.0)
    for method in ("edge_function", "barycentric_inverse"):
        there = bound(method, far).distance
        assert there > 100 * bound(method, near).distance
    # Their differences have 11 digits there, and the products 22: all exact.
    assert bound("cross_product", far).exact
    assert not bound("cross_product", near).exact


@pytest.mark.parametrize(
    ("method", "digits"),
    [("cross_product", 12), ("barycentric_determinant", 11), ("edge_function", 11)]
    + [("cross_product_kahan", 24), ("promoted_f64", 26)],
)
def test_whole_numbers_of_few_digits_are_exact_and_of_one_more_are_not(
    method: str, digits: int
) -> None:
    def found(high: float) -> bool:
        extent = Extent("f32", 0, high, 1, math.sqrt(2) * high, quantum=1)
        return bound(method, extent).exact

    assert found(2.0**digits)
    assert not found(2.0 ** (digits + 1))


def test_decimal_precision_promises_nothing_of_binary_digits() -> None:
    extent = _stout("f32", high=100.0, altitude=1.0, longest=100.0)
    decimal = dataclasses.replace(extent, quantum=0.1)
    binary = dataclasses.replace(extent, quantum=0.125)
    assert bound("cross_product", binary).exact
    assert not bound("cross_product", decimal).exact
    # But it does keep edges from being too steep.
    assert not bound("edge_slope", extent).known
    assert bound("edge_slope", decimal).known


@pytest.mark.parametrize("scalar", sorted(INTEGER_SPAN))
def test_integers_are_exact_up_to_their_span(scalar: str) -> None:
    span = INTEGER_SPAN[scalar]
    method = "byte_pairs" if scalar == "u8" else "edge_function"
    whole = Extent(scalar, 0, span - 1, 0, 2.0 * span)
    assert bound(method, whole).exact
    assert not bound(method, dataclasses.replace(whole, high=span)).known


def test_what_is_exact_everywhere_is_exact_for_triangles_without_area() -> None:
    for method in ALWAYS_EXACT:
        assert bound(method, _stout("f64", altitude=0.0)).exact


def test_overflow_and_underflow_leave_no_bound() -> None:
    for method in FAMILIES:
        if method.startswith("promoted"):
            continue
        huge = Extent("f32", 0, 2.0**70, 2.0**66, 2.0**70)
        tiny = Extent("f32", 0, 2.0**-70, 2.0**-72, 2.0**-70)
        assert not bound(method, huge).known, method
        assert not bound(method, tiny).known, method
    assert bound(
        "promoted_f64", Extent("f32", 0, 2.0**70, 2.0**66, 2.0**70)
    ).known


WEIGHTS = ["barycentric_determinant", "cross_solve", "barycentric_inverse"] + [
    "uv_projection"
]


@pytest.mark.parametrize("method", WEIGHTS)
@pytest.mark.parametrize("seed", range(12))
def test_weights_computed_in_f32_stay_within_their_bound(
    method: str, seed: int
) -> None:
    scene = hard_scenes.hard_scene(seed, "f32", 2000)
    limit = weights_bound(method, scene.extent)
    if not math.isfinite(limit):
        assert not bound(method, scene.extent).known
        return
    exact = _weights("barycentric_determinant", scene.rows.astype(np.longdouble))
    inside = (exact >= 0).all(axis=0)
    computed = _weights(method, scene.rows)[:, inside]
    assert np.abs(computed - exact[:, inside]).max() <= limit


def _weights(method: str, rows: Rows) -> Rows:
    """The weights of A, B, C by the formulas of kernels/methods, in the type of
    the rows: what a kernel without FMA computes.
    """
    ax, ay, bx, by, cx, cy, x, y = rows.T
    one = rows.dtype.type(1)
    if method == "cross_solve":
        xa, ya, xb, yb, xc, yc = ax - x, ay - y, bx - x, by - y, cx - x, cy - y
        wa, wb, wc = xb * yc - xc * yb, xc * ya - xa * yc, xa * yb - xb * ya
        scale = one / ((wa + wb) + wc)
        return np.array([wa * scale, wb * scale, wc * scale])
    if method == "barycentric_inverse":
        a = ((by - cy), (cx - bx), bx * cy - cx * by)
        b = ((cy - ay), (ax - cx), cx * ay - ax * cy)
        c = ((ay - by), (bx - ax), ax * by - bx * ay)
        scale = one / (a[0] * ax + a[1] * ay + a[2])
        every = [tuple(v * scale for v in row) for row in (a, b, c)]
        return np.array([(r[0] * x + r[1] * y) + r[2] for r in every])
    ux, uy, vx, vy = bx - ax, by - ay, cx - ax, cy - ay
    dx, dy = x - ax, y - ay
    if method == "uv_projection":
        bb, bc, cc = ux * ux + uy * uy, ux * vx + uy * vy, vx * vx + vy * vy
        scale = one / (bb * cc - bc * bc)
        on_b, on_c = dx * ux + dy * uy, dx * vx + dy * vy
        wb = (cc * scale) * on_b + (-bc * scale) * on_c
        wc = (-bc * scale) * on_b + (bb * scale) * on_c
    else:
        scale = one / (ux * vy - uy * vx)
        wb, wc = (dx * vy - dy * vx) * scale, (ux * dy - uy * dx) * scale
    return np.array([one - (wb + wc), wb, wc])
