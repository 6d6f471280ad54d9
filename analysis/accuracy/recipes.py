"""The recipes that people call exact: where each is right, and an input just
outside where it is wrong (report/recipes.csv, which tests/recipes_test.cc runs).
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import Final

import pandas as pd

from analysis.report import columns
from analysis.report.exhibits import Exhibits
from analysis.report.wording import power_of_two

RECIPES: Final = Path(__file__).resolve().parents[2] / "report" / "recipes.csv"
_CORNERS: Final = ("a", "b", "c", "p")


def recipes(scalars_of: dict[str, set[str]], path: Path = RECIPES) -> pd.DataFrame:
    """One row an input, of the methods and scalars of the run: `scalars_of` has
    the scalars by method. All of these methods are closed, so that they say the
    contrary of what is true inside and outside, and that the boundary is outside.
    """
    table = pd.read_csv(path, dtype=str)
    ours = [
        scalar in scalars_of.get(method, ())
        for method, scalar in zip(table["method"], table["scalar"])
    ]
    table = table[ours].reset_index(drop=True)
    given = table.apply(
        lambda row: " ".join(f"({row[c + 'x']}, {row[c + 'y']})" for c in _CORNERS),
        axis=1,
        result_type="reduce",
    )
    return table.assign(
        right_where=table["right_where"].map(_powers),
        input=given,
        said=table["truth"].map(lambda t: "inside" if t == "outside" else "outside"),
    )


def _powers(text: str) -> str:
    return re.sub(r"2\^(-?\d+)", lambda found: power_of_two(float(found[1])), text)


def add_recipes(exhibits: Exhibits, accuracy: pd.DataFrame) -> None:
    """`accuracy`: rows of the run that have method and scalar."""
    of = accuracy.groupby("method")["scalar"].agg(set).to_dict()
    table = recipes(of)
    if len(table):
        exhibits.table(
            "recipes",
            "Recipes that are called exact: where each is right for every input, and "
            "an input just outside that, as hexadecimal floating-point numbers, for "
            "which it is wrong on every instruction set. The tests run both.",
            table,
            [
                columns.word("method", "recipe"),
                columns.word("scalar", "scalar"),
                columns.sentence("right_where", "right where"),
                columns.sentence("outside", "outside"),
                columns.word("said", "says"),
                columns.word("truth", "is"),
                columns.sentence("input", "of A, B, C and P"),
            ],
        )
