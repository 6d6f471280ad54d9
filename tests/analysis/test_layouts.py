"""Points with x and y side by side, against a frame worked out by hand."""

from __future__ import annotations

import pandas as pd
import pytest

from analysis.speed.input_tables import of_comparisons
from analysis.speed.layout_tables import layout_sentence, layouts
from analysis.speed.tables import speed_cells
from tests.analysis.test_input_tables import frame, hit, sized

SMALL, LARGE = hit(50), sized(1 << 24)
TIMES = {
    f"one_triangle/{SMALL}/edge_function/f32/avx2": 0.10,
    f"one_triangle_aos/{SMALL}/edge_function/f32/avx2": 0.13,
    f"one_triangle/{LARGE}/edge_function/f32/avx2": 0.50,
    f"one_triangle_aos/{LARGE}/edge_function/f32/avx2": 0.50,
    # has nothing to be compared with
    f"one_triangle_aos/{SMALL}/edge_slope/f32/avx2": 0.11,
}
SPEED = frame(TIMES)
CELLS = speed_cells(SPEED)


def test_a_cell_is_compared_with_the_one_of_separate_arrays() -> None:
    table = layouts(SPEED, CELLS)
    ratios = dict(zip(table["scene"], table["side_by_side"]))
    assert ratios == {
        SMALL: pytest.approx(1.3, rel=0.001),
        LARGE: pytest.approx(1.0, rel=0.001),
    }
    small = table[table["scene"] == SMALL].iloc[0]
    assert small["side_by_side_low"] < 1.3 < small["side_by_side_high"]
    assert small["side_by_side_low"] > 1


def test_methods_are_compared_without_them() -> None:
    assert set(of_comparisons(CELLS)["loop"]) == {"one_triangle"}


def said(speed: pd.DataFrame) -> str:
    table = layouts(speed, speed_cells(speed))
    return layout_sentence(table, "avx2").replace("\u00a0", " ")


def test_the_sentence_follows_the_times() -> None:
    words = said(SPEED)
    assert "in f32 1.30 times as long on calls of 24.0 KiB" in words
    assert "and 1.00 times as long on calls of 128 MiB" in words
    assert "1 of 2 cells is slower for certain" in words
    assert layout_sentence(layouts(SPEED, CELLS), "avx512") == ""


def test_the_sentence_compares_each_scalar_with_itself() -> None:
    # The same scene has a few bytes more in f64: its triangle is larger.
    wider = {
        f"one_triangle/{SMALL}/edge_function/f64/avx2": 0.20,
        f"one_triangle_aos/{SMALL}/edge_function/f64/avx2": 0.40,
        f"one_triangle/{LARGE}/edge_function/f64/avx2": 1.00,
        f"one_triangle_aos/{LARGE}/edge_function/f64/avx2": 1.50,
    }
    speed = frame(TIMES | wider)
    wide = speed["scalar"] == "f64"
    speed.loc[wide, "working_set_bytes"] += 24.0
    words = said(speed)
    assert "in f32 1.30 times as long on calls of 24.0 KiB and 1.00 times" in words
    assert "in f64 2.00 times as long on calls of 24.0 KiB and 1.50 times" in words
