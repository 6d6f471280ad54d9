"""Points and triangles in whole numbers, for claims that are about formulas.

What a text says of a formula can be true or not before any number is rounded;
these are triangles and points enough to find out. A coordinate counts quarters,
so that all of them are whole; no formula that is tried here depends on the unit.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from fractions import Fraction
from typing import Final

Point = tuple[int, int]
Triangle = tuple[Point, Point, Point]
Weights = tuple[Fraction, Fraction, Fraction]
_UNIT: Final = 4


def _triangle(*numbers: int) -> Triangle:
    x = [number * _UNIT for number in numbers]
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


def points(triangle: Triangle) -> Iterator[Point]:
    """A lattice over the triangle's box and a step around it, and the middles of
    its edges.
    """
    axes = []
    for k in range(2):
        along = [vertex[k] for vertex in triangle]
        axes.append(range(min(along) - 1, max(along) + 2))
    yield from itertools.product(*axes)
    for v, w in itertools.combinations(triangle, 2):
        yield (v[0] + w[0]) // 2, (v[1] + w[1]) // 2


def cross(v: Point, w: Point) -> int:
    return v[0] * w[1] - v[1] * w[0]


def dot(v: Point, w: Point) -> int:
    return v[0] * w[0] + v[1] * w[1]


def minus(v: Point, w: Point) -> Point:
    return v[0] - w[0], v[1] - w[1]


def areas(triangle: Triangle, p: Point) -> tuple[int, int, int]:
    """The cross products of the ways to the vertices."""
    a, b, c = (minus(vertex, p) for vertex in triangle)
    return cross(b, c), cross(c, a), cross(a, b)


def weights(triangle: Triangle, p: Point) -> Weights:
    """The cross products over the determinant."""
    parts = areas(triangle, p)
    whole = sum(parts)
    return (
        Fraction(parts[0], whole),
        Fraction(parts[1], whole),
        Fraction(parts[2], whole),
    )


def contains(triangle: Triangle, p: Point) -> bool:
    """The boundary included."""
    return _least(triangle, p) >= 0


def on_boundary(triangle: Triangle, p: Point) -> bool:
    return _least(triangle, p) == 0


def _least(triangle: Triangle, p: Point) -> int:
    """Has the sign of the least weight."""
    parts = areas(triangle, p)
    return min(parts) if sum(parts) > 0 else -max(parts)


def solve(matrix: list[list[int]], right: list[int]) -> list[Fraction]:
    """Gauss and Jordan; the matrix must have an inverse."""
    rows = [[Fraction(x) for x in (*row, value)] for row, value in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next(i for i in range(k, len(rows)) if rows[i][k] != 0)
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [value / rows[k][k] for value in rows[k]]
        for i, row in enumerate(rows):
            if i != k:
                rows[i] = [a - row[k] * b for a, b in zip(row, rows[k])]
    return [row[-1] for row in rows]
