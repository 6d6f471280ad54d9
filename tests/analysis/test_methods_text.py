"""What report/methods.toml says of the methods holds on their worst inputs."""

from __future__ import annotations

import math
import tomllib
from fractions import Fraction

import pandas as pd
import pytest

from analysis.accuracy.failure_prose import METHODS_TEXT
from analysis.choice.error_bounds import SNAP_STEPS, SNAPPED

WORST = METHODS_TEXT.parent.parent / "tests" / "worst_inputs.csv"
TEXTS = tomllib.loads(METHODS_TEXT.read_text(encoding="utf-8"))
Point = tuple[Fraction, Fraction]


def squared_distance(p: Point, a: Point, b: Point) -> Fraction:
    """From p to the edge ab."""
    ux, uy, vx, vy = b[0] - a[0], b[1] - a[1], p[0] - a[0], p[1] - a[1]
    along = min(max((ux * vx + uy * vy) / (ux * ux + uy * uy), Fraction()), Fraction(1))
    return (vx - along * ux) ** 2 + (vy - along * uy) ** 2


def steps_from_boundary(row: pd.Series) -> float:
    """Of the grid over the triangle's box, the larger of its two steps."""
    numbers = [Fraction(float.fromhex(text)) for text in row["ax":"py"]]
    a, b, c, p = ((numbers[i], numbers[i + 1]) for i in (0, 2, 4, 6))
    near = min(squared_distance(p, *edge) for edge in ((a, b), (b, c), (c, a)))
    sides = (
        max(q[i] for q in (a, b, c)) - min(q[i] for q in (a, b, c)) for i in (0, 1)
    )
    return math.sqrt(near) * SNAP_STEPS / float(max(sides))


@pytest.mark.parametrize("method", SNAPPED)
def test_a_snapped_answer_errs_within_root_2_steps_and_not_within_one(
    method: str,
) -> None:
    worst = pd.read_csv(WORST)
    rows = worst[worst["method"] == method]
    steps = [steps_from_boundary(row) for _, row in rows.iterrows()]
    assert 1 < max(steps) <= math.sqrt(2)
    told = TEXTS[method]["fails"]
    assert "within √2 steps" in told or told.startswith("As snapped_i16")
    assert "within one step" not in told
