"""What the exact methods keep, and what that costs, against small frames."""

from __future__ import annotations

import pandas as pd
import pytest

from analysis.accuracy.exact_tables import exact_errors, exact_speed, worst_ratios
from analysis.speed.tables import speed_cells
from analysis.trust.stats import wilson
from tests.analysis.test_tables import FIXED, FRESH, accuracy_frame, name, speed_frame

L3 = "uniform:hit=50:n=262144:sets=fresh"


def test_answers_are_summed_over_isas_but_points_are_counted_once() -> None:
    cells = {
        name("exact", isa, scene): (100, 0, 300, 0)
        for isa in ("avx2", "avx512")
        for scene in ("near_edge:ulps=1", "near_edge:ulps=2")
    }
    cells[name("edge_function", "avx2", "near_edge:ulps=1")] = (100, 50, 300, 50)
    cells[name("exactly_not", "avx2", "near_edge:ulps=1")] = (100, 50, 300, 50)
    table = exact_errors(accuracy_frame(cells))
    row = table.iloc[0]
    assert list(table["method"]) == ["exact"]
    assert (row["wrong"], row["of"], row["scenes"], row["isas"]) == (0, 1600, 2, 2)
    assert row["points"] == 800
    assert row["error_rate_high"] == wilson(0, 800).high


def test_a_loop_has_points_of_its_own_but_a_layout_has_not() -> None:
    cells = {
        name("exact", "avx2", "near_edge:ulps=1", loop): (100, 0, 300, 0)
        for loop in ("one_triangle", "one_triangle_aos", "pairs")
    }
    row = exact_errors(accuracy_frame(cells)).iloc[0]
    assert (row["of"], row["points"]) == (1200, 800)


def test_a_point_is_wrong_by_the_isa_that_errs_most() -> None:
    cells = {
        name("exact", "avx2", "near_edge:ulps=1"): (100, 3, 300, 0),
        name("exact", "avx512", "near_edge:ulps=1"): (100, 1, 300, 1),
    }
    row = exact_errors(accuracy_frame(cells)).iloc[0]
    assert (row["wrong"], row["points"]) == (5, 400)
    assert row["error_rate_high"] == wilson(3, 400).high


def test_a_broken_promise_is_counted() -> None:
    table = exact_errors(
        accuracy_frame({name("exact", "avx2", "near_edge:ulps=1"): (100, 1, 300, 2)})
    )
    assert table["wrong"].iloc[0] == 3


SPEED = speed_frame(
    {
        name("exact", "avx2"): [2.0, 2.0, 2.0],
        name("edge_function_fma", "avx2"): [1.9, 1.9, 1.9],
        name("snapped_u8", "avx2"): [1.0, 1.0, 1.0],
        name("cross_product_fast_math", "avx2"): [0.5, 0.5, 0.5],
        name("exact_open", "avx2"): [0.1, 0.1, 0.1],
        name("exact", "avx2", FIXED): [9.0, 9.0, 9.0],
        name("exact", "avx2", L3): [4.0, 4.0, 4.0],
        name("edge_function_fma", "avx2", L3): [2.0, 2.0, 2.0],
    }
)


def test_throughput_is_compared_in_the_same_scene_and_isa() -> None:
    table = exact_speed(SPEED, speed_cells(SPEED), {"cross_product_fast_math"})
    rows = table[table["method"] == "exact"].set_index("scene")
    assert set(rows.index) == {FRESH, L3}
    assert rows.loc[FRESH, "of_edge"] == pytest.approx(0.95)
    assert rows.loc[FRESH, "fastest"] == "snapped_u8"
    assert rows.loc[FRESH, "of_fastest"] == 0.5
    assert (rows.loc[L3, "of_edge"], rows.loc[L3, "fastest"]) == (
        0.5,
        "edge_function_fma",
    )
    worst = worst_ratios(table, "of_edge")
    assert worst["f32"]["scene"] == L3


def test_no_ratio_is_taken_between_shards() -> None:
    other = SPEED.assign(shard="speed-b")
    split = SPEED[SPEED["method"] == "exact"]
    rest = other[other["method"] != "exact"]
    both = pd.concat([split, rest])
    table = exact_speed(both, speed_cells(both), set())
    own = table[table["method"] == "exact"]
    assert own["of_edge"].isna().all() and set(own["fastest"]) == {"–"}
    assert worst_ratios(table, "of_edge") == {}
