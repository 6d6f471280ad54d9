"""Points and triangles in exact fractions, for claims that are about formulas.

What a text says of a formula can be true or not before any number is rounded;
these are triangles and points enough to find out.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from fractions import Fraction
from typing import Final

Point = tuple[Fraction, Fraction]
Triangle = tuple[Point, Point, Point]
Weights = tuple[Fraction, Fraction, Fraction]


def _triangle(*numbers: int) -> Triangle:
    x = [Fraction(number) for number in numbers]
    return (x[0], x[1]), (x[2], x[3]), (x[4], x[5])


# The first has the edges (8, 2) and (7, 1) of a published example, the second
# edges at a right angle; then both windings, a needle, an obtuse one.
SKEWED: Final = _triangle(0, 0, 8, 2, 7, 1)
RIGHT_ANGLED: Final = _triangle(0, 0, 8, 2, -1, 4)
TRIANGLES: Final = (
    SKEWED,
    RIGHT_ANGLED,
    _triangle(1, 1, 4, 8, 9, 3),
    _triangle(1, 1, 9, 3, 4, 8),
    _triangle(-6, 0, 6, 1, 5, 1),
    _triangle(-5, -3, 0, 6, 7, -4),
)
_STEP: Final = Fraction(1, 4)


def points(triangle: Triangle) -> Iterator[Point]:
    """A lattice over the triangle's box and a step around it, and the middles of
    its edges.
    """
    axes = []
    for k in range(2):
        low = min(vertex[k] for vertex in triangle) - _STEP
        high = max(vertex[k] for vertex in triangle) + _STEP
        axes.append([low + _STEP * i for i in range(int((high - low) / _STEP) + 1)])
    yield from itertools.product(*axes)
    for v, w in itertools.combinations(triangle, 2):
        yield (v[0] + w[0]) / 2, (v[1] + w[1]) / 2


def cross(v: Point, w: Point) -> Fraction:
    return v[0] * w[1] - v[1] * w[0]


def dot(v: Point, w: Point) -> Fraction:
    return v[0] * w[0] + v[1] * w[1]


def minus(v: Point, w: Point) -> Point:
    return v[0] - w[0], v[1] - w[1]


def weights(triangle: Triangle, p: Point) -> Weights:
    """The cross products of the ways to the vertices, over the determinant."""
    a, b, c = (minus(vertex, p) for vertex in triangle)
    parts = cross(b, c), cross(c, a), cross(a, b)
    whole = sum(parts, Fraction(0))
    return parts[0] / whole, parts[1] / whole, parts[2] / whole


def contains(triangle: Triangle, p: Point) -> bool:
    """The boundary included."""
    return min(weights(triangle, p)) >= 0


def on_boundary(triangle: Triangle, p: Point) -> bool:
    return min(weights(triangle, p)) == 0


def solve(matrix: list[list[Fraction]], right: list[Fraction]) -> list[Fraction]:
    """Gauss and Jordan; the matrix must have an inverse."""
    rows = [[*row, value] for row, value in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i, row in enumerate(rows):
            if i != k:
                rows[i] = [a - row[k] * b for a, b in zip(row, rows[k])]
    return [row[-1] for row in rows]
