"""Claims about formulas: tried in exact fractions, and on the run's own rows."""

from __future__ import annotations

import functools
from collections.abc import Callable
from fractions import Fraction

import pandas as pd

from analysis.claims.evidence import (
    FAILS,
    HOLDS,
    PARTLY,
    Evidence,
    Finding,
    at_widest,
    error_share,
    judged,
    not_measured,
    share_figure,
)
from analysis.claims.lattice import (
    RIGHT_ANGLED,
    SKEWED,
    TRIANGLES,
    Point,
    Triangle,
    areas,
    contains,
    dot,
    minus,
    on_boundary,
    points,
    solve,
    weights,
)
from analysis.report.wording import counted, grouped, share, significant

INVERSE, SIDES = "barycentric_inverse", "cross_product_det"
GRAM = "uv_projection"
SOLVE, PUBLISHED = "cross_solve", "cross_solve_published"
COLOURS = 255  # steps of a channel

Coordinates = tuple[Fraction, Fraction]


def same_weights(evidence: Evidence) -> Finding:
    """That barycentric weights are cross products over the determinant."""
    tried = [(t, p) for t in TRIANGLES for p in points(t)]
    same = sum(_by_matrix(t, p) == list(weights(t, p)) for t, p in tried)
    why = (
        f"In exact fractions the weights by the inverse of the 3×3 matrix are the cross "
        f"products over the determinant for {grouped(same)} of {grouped(len(tried))} "
        "points."
    )
    near = _near(evidence)
    shares = [error_share(near, method) for method in (INVERSE, SIDES)]
    if shares[0] is None or shares[1] is None:
        return Finding(judged(same == len(tried), False), "–", why)
    inverse, sides = shares[0], shares[1]
    apart = inverse.low > sides.high or sides.low > inverse.high
    text = f"{INVERSE} {share_figure(inverse)}, {SIDES} {share_figure(sides)}"
    if apart:
        why += (
            " In floating point they are two methods: they round differently, and are "
            "wrong near an edge at different rates."
        )
    return Finding(
        judged(same == len(tried) and not apart, same == len(tried)), text, why
    )


def example_of_percents(evidence: Evidence) -> Finding:
    """That (8, 2)·0.5 + (7, 1)·1.0 is (11, 3), and 1.0 is 140 %."""
    first, second = (Fraction(8), Fraction(2)), (Fraction(7), Fraction(1))
    half, one = Fraction(1, 2), Fraction(1)
    made = [half * u + one * v for u, v in zip(first, second)]
    right = made == [11, 3] and 100 * one == 140
    text = f"({made[0]}, {made[1]}); {100 * half} % and {100 * one} %"
    return Finding(judged(right, False), text, "The sum, worked out.")


def projection_alone(evidence: Evidence) -> Finding:
    """That dot products with the two edges give U and V."""
    wrong = _misjudged(SKEWED, _projected)
    square = _misjudged(RIGHT_ANGLED, _projected)
    gram = sum(_misjudged(t, _by_gram)[0] for t in TRIANGLES)
    why = (
        f"Dot products over the squared lengths of the edges are U and V where the edges "
        f"stand at a right angle ({grouped(square[0])} of {grouped(square[1])} points "
        f"answered wrongly) and not elsewhere: for the edges (8, 2) and (7, 1) "
        f"{share(wrong[0] / wrong[1])} of them are. With the inverse of the Gram matrix, "
        f"as {GRAM} has it, {'none is' if gram == 0 else counted(gram, 'point') + ' are'}, "
        "whatever the angle."
    )
    verdict = judged(wrong[0] == 0, square[0] == 0 and gram == 0)
    return Finding(verdict, f"{share(wrong[0] / wrong[1])} wrong without it", why)


def within_zero_and_one(evidence: Evidence) -> Finding:
    """That dividing the cross product by its first component makes every
    component of a point inside lie in [0, 1], and of no other.
    """
    kept = inside = added = 0
    for t in TRIANGLES:
        for p in points(t):
            equation = _equation(t, p)
            said = equation is not None and all(0 <= part <= 1 for part in equation)
            inside += contains(t, p)
            kept += said and contains(t, p)
            added += said and not contains(t, p)
    why = (
        f"In exact fractions it keeps {share(kept / inside)} of the points inside, those "
        "whose second and third weights are no larger than the first: the third of the "
        f"triangle nearest to vertex A; it adds {grouped(added) if added else 'none'}."
    )
    near = _near(evidence)
    own = near[near["method"] == PUBLISHED]
    text = f"keeps {share(kept / inside)}"
    if len(own):
        refused = own["false_outside"].astype(float).sum()
        of = own["interior"].astype(float).sum()
        why += (
            f" The kernel {PUBLISHED} refused {share(refused / of)} of "
            f"{grouped(int(of))} points inside and near an edge."
        )
    return Finding(judged(kept == inside and added == 0, False), text, why)


def first_component_zero(evidence: Evidence) -> Finding:
    """That a point whose first component is 0 cannot be inside."""
    zero = interior = edge = 0
    for t in TRIANGLES:
        for p in points(t):
            if weights(t, p)[0] == 0:
                zero += 1
                edge += on_boundary(t, p)
                interior += contains(t, p) and not on_boundary(t, p)
    why = (
        f"The first component is 0 on the line through B and C. Of {grouped(zero)} such "
        f"points {grouped(interior) if interior else 'none'} lay in the interior and "
        f"{grouped(edge)} on the edge BC, which belongs to a closed triangle."
    )
    return Finding(
        judged(interior == 0 and edge == 0, interior == 0),
        f"{grouped(edge)} of {grouped(zero)} on the boundary",
        why,
    )


def gradient(evidence: Evidence) -> Finding:
    """That the weights make a gradient of colours."""
    sums = [
        sum(equation, Fraction(0))
        for t in TRIANGLES
        for p in points(t)
        if (equation := _equation(t, p)) is not None
    ]
    ones = sum(total == 1 for total in sums)
    why = (
        f"The vector that the text divides by its first component sums to 1 at "
        f"{grouped(ones)} of {grouped(len(sums))} points; divided by its sum it is the "
        "three weights."
    )
    cells = evidence.run.accuracy
    own = cells[
        (cells["method"] == SOLVE)
        & (cells["family"] == "uniform")
        & (cells["scalar"] == "f32")
    ]["weights_largest_ulps"].dropna()
    if not len(own):
        return not_measured("weights of " + SOLVE)
    steps = float(own.max()) * 2.0**-23 * COLOURS
    why += (
        f" Those of {SOLVE} were off by {significant(float(own.max()))} ulps of 1 at "
        f"most on uniform points in f32, {significant(steps)} steps of a colour channel."
    )
    fine = steps < 0.5
    return Finding(
        judged(fine and ones == len(sums), fine),
        f"{significant(steps)} of {COLOURS} steps",
        why,
    )


def closed_or_positive(evidence: Evidence) -> Finding:
    """That α ≥ 0, β ≥ 0, α + β ≤ 1 says inside, and that "all positive" does."""
    tried = [(t, p) for t in TRIANGLES for p in points(t)]
    wrong = summary = edge = 0
    for t, p in tried:
        alpha, beta = _by_gram(t, p)
        said = alpha >= 0 and beta >= 0 and alpha + beta <= 1
        wrong += said != contains(t, p)
        positive = alpha > 0 and beta > 0 and 1 - alpha - beta > 0
        summary += positive != contains(t, p)
        edge += on_boundary(t, p)
    why = (
        f"In exact fractions the three conditions answer {grouped(len(tried) - wrong)} of "
        f"{grouped(len(tried))} points as a closed triangle does. Read strictly, “all "
        f"positive” answers {grouped(summary)} otherwise, as many as lie on the boundary "
        f"({grouped(edge)}): it is the open triangle, and of two neighbours neither has "
        "their common edge."
    )
    return Finding(
        judged(wrong == 0 and summary == 0, wrong == 0 and summary == edge),
        f"{grouped(wrong)} wrong; {grouped(summary)} with “all positive”",
        why,
    )


def _near(evidence: Evidence) -> pd.DataFrame:
    rows = at_widest(evidence.run.accuracy, "f32")
    return rows[rows["family"] == "near_edge"]


@functools.cache
def _by_matrix(t: Triangle, p: Point) -> list[Fraction]:
    matrix = [[v[0] for v in t], [v[1] for v in t], [1, 1, 1]]
    return solve(matrix, [p[0], p[1], 1])


def _projected(t: Triangle, p: Point) -> Coordinates:
    e, f, way = minus(t[1], t[0]), minus(t[2], t[0]), minus(p, t[0])
    return Fraction(dot(way, e), dot(e, e)), Fraction(dot(way, f), dot(f, f))


@functools.cache
def _by_gram(t: Triangle, p: Point) -> Coordinates:
    e, f, way = minus(t[1], t[0]), minus(t[2], t[0]), minus(p, t[0])
    u, v = solve(
        [[dot(e, e), dot(e, f)], [dot(e, f), dot(f, f)]], [dot(e, way), dot(f, way)]
    )
    return u, v


def _misjudged(
    t: Triangle, coordinates: Callable[[Triangle, Point], Coordinates]
) -> tuple[int, int]:
    """Points answered wrongly, and all."""
    wrong = tried = 0
    for p in points(t):
        u, v = coordinates(t, p)
        tried += 1
        wrong += (u >= 0 and v >= 0 and u + v <= 1) != contains(t, p)
    return wrong, tried


def _equation(t: Triangle, p: Point) -> list[Fraction] | None:
    parts = areas(t, p)
    return [Fraction(part, parts[0]) for part in parts] if parts[0] != 0 else None
