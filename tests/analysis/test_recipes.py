"""The table of recipes that are called exact."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path

import pandas as pd
import pytest

from analysis.accuracy.recipes import RECIPES, add_recipes, recipes
from analysis.read.load import load_run
from analysis.report.exhibits import Exhibits

TABLE = pd.read_csv(RECIPES, dtype=str)
Corner = tuple[Fraction, Fraction]


def corner(row: pd.Series, name: str) -> Corner:
    x, y = (Fraction(float.fromhex(row[name + axis])) for axis in "xy")
    return x, y


def orientation(a: Corner, b: Corner, c: Corner) -> Fraction:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


@pytest.mark.parametrize("index", TABLE.index)
def test_what_is_called_true_is_true(index: int) -> None:
    row = TABLE.loc[index]
    a, b, c, p = (corner(row, name) for name in "abcp")
    turn = 1 if orientation(a, b, c) > 0 else -1
    sides = [turn * orientation(*edge, p) for edge in ((a, b), (b, c), (c, a))]
    least = min(sides)
    truth = "inside" if least > 0 else "boundary" if least == 0 else "outside"
    assert row["truth"] == truth
    assert orientation(a, b, c) != 0


def test_only_what_the_run_has_is_shown() -> None:
    found = recipes({"epsilon": {"f32"}, "exact": {"f32", "f64"}})
    assert set(zip(found["method"], found["scalar"])) == {("epsilon", "f32")}
    assert len(found) == 2
    assert recipes({}).empty


def test_a_recipe_says_the_contrary() -> None:
    every = recipes({method: {"f32", "f64"} for method in TABLE["method"]})
    assert len(every) == len(TABLE)
    said = set(zip(every["truth"], every["said"]))
    assert said == {
        ("inside", "outside"),
        ("outside", "inside"),
        ("boundary", "outside"),
    }


def test_a_run_without_recipes_has_no_table(small_run: Path) -> None:
    run = load_run(small_run)
    exhibits = Exhibits()
    add_recipes(exhibits, run.accuracy)
    assert exhibits.get("recipes") is None
    add_recipes(exhibits, run.accuracy.assign(method="epsilon"))
    table = exhibits.get("recipes")
    assert table is not None
