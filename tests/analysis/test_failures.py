"""The smallest failing input of each method, in words that can be read."""

from __future__ import annotations

import numpy as np
import pandas as pd
import pytest
from hypothesis import given
from hypothesis import strategies as st

from analysis.accuracy.failure_prose import failing_words
from analysis.accuracy.failures import (
    counted_failures,
    decimal,
    plainest_examples,
    told_apart_nowhere,
)
from analysis.read.run import WORST_COLUMNS
from tests.analysis.test_tables import accuracy_frame, name

LONG = "0x1.99999ap-4 0x1.333334p-2"


def worst(*rows: tuple[str, str, str, str]) -> pd.DataFrame:
    """(method, family, kind, p) with corners of one length."""
    return pd.DataFrame(
        [
            ["n", "one_triangle", family, family, method, "f32", "avx2", kind, 1.5]
            + ["inside", "0x0p+0 0x0p+0", "0x1p+0 0x0p+0", "0x1p+0 0x1p-13", p]
            for method, family, kind, p in rows
        ],
        columns=WORST_COLUMNS,
    )


def point(table: pd.DataFrame, method: str = "m") -> str:
    return plainest_examples(table)[method].corners[3][1]


def test_the_shortest_input_is_taken() -> None:
    table = worst(
        ("m", "near_edge", "false_inside", LONG),
        ("m", "near_edge", "false_inside", "0x1p-1 0x1p-2"),
        ("other", "near_edge", "false_inside", "0x0p+0 0x0p+0"),
    )
    assert point(table) == "(0x1p-1, 0x1p-2)"


def test_a_plain_scene_stands_before_a_shorter_input() -> None:
    table = worst(
        ("m", "scale", "false_inside", "0x1p-1 0x1p-2"),
        ("m", "corpus", "false_inside", LONG),
    )
    assert point(table) == f"({LONG.replace(' ', ', ')})"


def test_a_wrong_answer_stands_before_one_that_only_changes() -> None:
    table = worst(
        ("m", "corpus", "reversed_winding", "0x1p-1 0x1p-2"),
        ("m", "scale", "false_outside", LONG),
    )
    found = plainest_examples(table)["m"]
    assert found.what == "inside by exact arithmetic, called outside"


def test_a_method_that_never_failed_has_no_example() -> None:
    assert plainest_examples(worst()) == {}


def test_corners_are_named_and_given_in_both_ways() -> None:
    example = plainest_examples(worst(("m", "corpus", "hole", "0x1p-1 -0x1.8p+1")))["m"]
    assert example.corners[3] == ("p", "(0x1p-1, -0x1.8p+1)", "(0.5, -3)")
    assert example.distance_ulps == 1.5


@pytest.mark.parametrize(
    ("text", "scalar", "expected"),
    [
        ("0x1.99999ap-4", "f32", "0.1"),
        ("0x1.99999ap-4", "f64", "0.10000000149011612"),
        ("0x1p-149", "f32", "1e-45"),
        ("-0x1.8p+0", "f32", "-1.5"),
        ("17", "i32", "17"),
        ("-inf", "f32", "-inf"),
        ("nan", "f64", "nan"),
    ],
)
def test_decimals_are_the_shortest(text: str, scalar: str, expected: str) -> None:
    assert decimal(text, scalar) == expected


@given(st.floats(width=32, allow_nan=False, allow_infinity=False))
def test_a_decimal_is_read_back_as_the_same_number(value: float) -> None:
    assert np.float32(decimal(value.hex(), "f32")) == np.float32(value)


@given(st.floats(allow_nan=False, allow_infinity=False))
def test_a_decimal_of_f64_is_read_back_as_the_same_number(value: float) -> None:
    assert float(decimal(value.hex(), "f64")) == value


EDGE, MESH = "near_edge:ulps=1", "mesh_pair:ulps=0"


def test_failures_are_counted_over_all_cells_but_not_what_the_rule_brings() -> None:
    cells = accuracy_frame(
        {
            name("edge_function", "avx2", EDGE): (100, 10, 300, 3),
            name("edge_function", "scalar", EDGE): (100, 10, 300, 3),
            name("edge_function", "avx2", MESH): (50, 0, 50, 0),
            name("exact", "avx2", MESH): (50, 0, 50, 0),
        }
    )
    cells.loc[cells["family"] == "mesh_pair", ["double_hit", "double_hit_of"]] = [7, 40]
    own = (cells["family"] == "mesh_pair") & (cells["method"] == "edge_function")
    cells.loc[own, "double_hit"] = 9
    cells.loc[own, ["negated", "negated_of"]] = [4, 40]
    counts = counted_failures(cells)
    assert failing_words(counts["edge_function"]) == (
        "26 were wrong (6 false inside, 20 false outside); 2 double hits beyond the "
        "boundary rule; 4 changed with how the question was put"
    )
    assert failing_words(counts["exact"]) == ""


def test_a_form_whose_counts_are_all_the_same_is_told() -> None:
    cells = {
        name(method, isa, EDGE): (100, 10, 300, 3)
        for method in ("edge_function", "edge_function_fma", "lone_fma")
        for isa in ("avx2", "avx512")
    }
    same = accuracy_frame(cells)
    assert told_apart_nowhere(same) == {"edge_function_fma": ("edge_function", 2)}
    cells[name("edge_function_fma", "avx2", EDGE)] = (100, 10, 300, 4)
    assert told_apart_nowhere(accuracy_frame(cells)) == {}
