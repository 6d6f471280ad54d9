"""Tables against small frames whose answers were worked out by hand."""

from __future__ import annotations

import math

import pandas as pd
import pytest

from analysis.accuracy import accuracy_tables
from analysis.read.cells import parse_cell
from analysis.read.run import ACCURACY_COLUMNS, SPEED_COLUMNS
from analysis.speed import tables

FRESH = "uniform:hit=50:n=4096:sets=fresh"
FIXED = "uniform:hit=50:n=4096:sets=fixed"


def speed_frame(times: dict[str, list[float]], shard: str = "speed-a") -> pd.DataFrame:
    """Cell name → ns of each repetition."""
    rows = []
    for name, values in times.items():
        cell = parse_cell(name)
        for repetition, ns in enumerate(values):
            rows.append(
                {
                    "shard": shard,
                    "name": name,
                    "loop": cell.loop,
                    "scene": str(cell.scene),
                    "family": cell.scene.family,
                    "method": cell.method,
                    "scalar": cell.scalar,
                    "isa": cell.isa,
                    "control": cell.control,
                    "repetition": repetition,
                    "ns": ns,
                    "items": 4096.0,
                    "working_set_bytes": 32768.0,
                    "bytes_per_item": 8.0,
                }
            )
    return pd.DataFrame(rows, columns=SPEED_COLUMNS)


def accuracy_frame(cells: dict[str, tuple[int, int, int, int]]) -> pd.DataFrame:
    """Cell name → (interior, false outside, exterior, false inside)."""
    rows = []
    for name, (interior, false_outside, exterior, false_inside) in cells.items():
        cell = parse_cell(name)
        rows.append(
            {
                "shard": "accuracy-a",
                "name": name,
                "loop": cell.loop,
                "scene": str(cell.scene),
                "family": cell.scene.family,
                "method": cell.method,
                "scalar": cell.scalar,
                "isa": cell.isa,
                "boundary_rule": "closed",
                "accepts": "triangle",
                "points": interior + exterior + 10,
                "interior": interior,
                "exterior": exterior,
                "boundary": 10,
                "degenerate": 0,
                "not_finite": 0,
                "false_outside": false_outside,
                "false_inside": false_inside,
                "boundary_accepted": 10,
                "false_outside_of": interior,
                "false_inside_of": exterior,
                "boundary_accepted_of": 10,
                "smallest_ulps": 0.5 if false_outside + false_inside else None,
                "largest_ulps": 2.0 if false_outside + false_inside else None,
                "weights_largest_ulps": 8.0,
                "weights_mean_ulps": 0.5,
                "weights_not_finite": 1,
                "weights_points": 100,
                "weights_largest_forward_ulps": 16.0,
                "weights_mean_forward_ulps": 0.25,
            }
        )
    return pd.DataFrame(rows, columns=ACCURACY_COLUMNS)


def name(method: str, isa: str, scene: str = FRESH, loop: str = "one_triangle") -> str:
    return f"{loop}/{scene}/{method}/f32/{isa}"


SPEED = speed_frame(
    {
        name("edge_function", "avx2"): [1.0, 3.0, 2.0],
        name("edge_function", "scalar"): [8.0, 8.0, 8.0],
        name("edge_function", "avx2", FIXED): [0.5, 0.5, 0.5],
        name("cross_product", "avx2"): [4.0, 4.0, 4.0],
        name("cross_product", "avx2") + "/twin": [5.0, 5.0, 5.0],
    }
)


def test_a_cell_is_its_median_and_its_speed() -> None:
    cells = tables.speed_cells(SPEED).set_index("name")
    cell = cells.loc[name("edge_function", "avx2")]
    assert (cell["ns"], cell["ns_low"], cell["ns_high"]) == (2.0, 1.0, 3.0)
    assert cell["items_per_second"] == 0.5e9
    assert cell["items_per_second_low"] == pytest.approx(1e9 / 3)
    assert cell["items_per_second_high"] == 1e9


def test_the_gain_over_scalar_is_a_ratio_inside_one_shard() -> None:
    cells = tables.speed_cells(SPEED).set_index("name")
    # 8/1, 8/3 and 8/2, three times each.
    assert cells.loc[name("edge_function", "avx2"), "times_scalar"] == 4.0
    assert cells.loc[name("edge_function", "scalar"), "times_scalar"] == 1.0
    assert math.isnan(cells.loc[name("cross_product", "avx2"), "times_scalar"])


def test_no_ratio_reaches_over_two_shards() -> None:
    other = {name("cross_product", "scalar"): [9.0, 9.0, 9.0]}
    both = pd.concat([SPEED, speed_frame(other, "speed-b")])
    cells = tables.speed_cells(both).set_index("name")
    assert math.isnan(cells.loc[name("cross_product", "avx2"), "times_scalar"])


def test_controls_are_no_cells_of_their_own() -> None:
    base = name("cross_product", "avx2")
    more = {base + end: [9.0] * 3 for end in ("/doubled", "/placed_16")}
    assert len(tables.speed_cells(pd.concat([SPEED, speed_frame(more)]))) == 4


def test_repetitions_are_taken_as_they_ran_and_not_as_they_stand() -> None:
    cell = name("edge_function", "avx2")
    frame = speed_frame({cell: [1.0, 2.0, 3.0]}).iloc[::-1]
    assert list(tables.samples(frame)["speed-a", cell]) == [1.0, 2.0, 3.0]


def test_fresh_over_fixed() -> None:
    table = tables.fixed_against_fresh(SPEED, tables.speed_cells(SPEED))
    assert list(table["fresh_over_fixed"]) == [4.0]
    assert (table["fresh_over_fixed_low"] == 2.0).all()


def test_the_cost_of_weights_is_the_time_with_over_the_time_without() -> None:
    speed = speed_frame(
        {
            name("cross_solve", "avx2"): [2.0, 2.0],
            name("cross_solve", "avx2", loop="one_triangle_weights"): [3.0, 3.0],
        }
    )
    table = tables.cost_of_weights(speed, tables.speed_cells(speed))
    assert list(table["weights_over_bits"]) == [1.5]


def test_the_reference_scene_is_fresh_half_inside_and_in_the_nearest_cache() -> None:
    scenes = [
        "uniform:hit=50:n=1024:sets=fresh",
        "uniform:hit=10:n=4096:sets=fresh",
        FRESH,
        FIXED,
        "near_edge:ulps=1",
    ]
    speed = speed_frame({name("a", "avx2", scene): [1.0] for scene in scenes})
    far = speed["scene"].str.contains("n=1024")
    speed.loc[far, "working_set_bytes"] = 8192.0
    assert tables.reference_scene(tables.speed_cells(speed)) == FRESH


def test_the_widest_isa_is_one_that_most_methods_have() -> None:
    cells = pd.DataFrame(
        [["a", "avx2"], ["b", "avx2"], ["a", "sse4"], ["b", "sse4"], ["a", "avx512"]]
        + [["a", "autovec_v4"], ["b", "autovec_v4"]],
        columns=["method", "isa"],
    )
    assert tables.widest_isa(cells) == "avx2"


def test_scenes_are_sorted_by_number() -> None:
    scenes = ["near_edge:ulps=16", "near_edge:ulps=2", "near_edge:ulps=0.5"]
    assert sorted(scenes, key=tables.scene_rank) == scenes[::-1]


HARD = {
    name("edge_function", "avx2", "near_edge:ulps=1"): (100, 10, 300, 30),
    name("edge_function", "avx2", "near_edge:ulps=2"): (200, 2, 400, 18),
    name("cross_product", "avx2", "near_edge:ulps=1"): (100, 0, 300, 0),
}


def test_error_rates_pool_counts_not_rates() -> None:
    rates = accuracy_tables.error_rates(accuracy_frame(HARD), ["method"])
    row = rates.set_index("method").loc["edge_function"]
    assert (row["wrong"], row["of"]) == (60, 1000)
    assert row["error_rate"] == 0.06
    assert row["scenes"] == 2
    assert row["boundary_accepted"] == 20


def test_boundary_points_are_neither_right_nor_wrong() -> None:
    rates = accuracy_tables.error_rates(accuracy_frame(HARD), ["method"])
    assert rates.set_index("method").loc["cross_product", "of"] == 400


def test_a_family_is_pooled_with_the_same_counts_of_isas_once() -> None:
    one, two = "near_edge:ulps=1", "near_edge:ulps=2"
    cells = {
        name("a", "scalar", one): (9, 1, 9, 1),
        name("a", "avx2", one): (9, 1, 9, 1),
        name("a", "scalar", two): (20, 3, 5, 0),
        name("b", "scalar", one): (9, 1, 9, 1),
        name("b", "avx512", one): (9, 0, 9, 0),
    }
    table = accuracy_tables.families_pooled(accuracy_frame(cells)).set_index("method")
    assert dict(table["wrong"]) == {"a": 2 + 3, "b": 2 + 0}
    assert dict(table["of"]) == {"a": 18 + 25, "b": 36}
    assert dict(table["scenes"]) == {"a": 2, "b": 1}


def test_errors_along_a_parameter_are_in_its_order() -> None:
    along = accuracy_tables.errors_along(
        accuracy_frame(HARD), "near_edge", "ulps", "f32", "avx2"
    )
    edge = along[along["method"] == "edge_function"]
    assert list(edge["at"]) == [1.0, 2.0]
    assert list(edge["error_rate"]) == [0.1, pytest.approx(20 / 600)]


def test_a_method_without_a_row_on_the_isa_is_shown_on_its_widest() -> None:
    cells = {
        name("edge_function", "avx2", "near_edge:ulps=1"): (100, 10, 300, 30),
        name("edge_function", "avx512", "near_edge:ulps=1"): (100, 90, 300, 0),
        name("loop_only", "autovec_v2", "near_edge:ulps=1"): (100, 1, 300, 0),
        name("loop_only", "autovec_v4", "near_edge:ulps=1"): (100, 0, 300, 2),
    }
    along = accuracy_tables.errors_along(
        accuracy_frame(cells), "near_edge", "ulps", "f32", "avx2"
    )
    assert dict(zip(along["method"], along["wrong"])) == {
        "edge_function": 40,
        "loop_only": 2,
    }


def test_a_scene_on_the_boundary_only_has_no_error_rate() -> None:
    cells = {name("a", "avx2", "near_edge:ulps=0"): (0, 0, 0, 0)}
    along = accuracy_tables.errors_along(
        accuracy_frame(cells), "near_edge", "ulps", "f32", "avx2"
    )
    assert len(along) == 0


def test_speed_against_error_joins_the_two_and_draws_the_frontier() -> None:
    marks = accuracy_tables.speed_against_error(
        tables.speed_cells(SPEED), accuracy_frame(HARD), "f32"
    )
    found = {
        (row.method, row.isa): (row.ns, row.error_rate, row.on_frontier)
        for row in marks.itertuples()
    }
    assert found["edge_function", "avx2"] == (2.0, 0.06, True)
    assert found["cross_product", "avx2"] == (4.0, 0.0, True)
    ns, rate, on_frontier = found["edge_function", "scalar"]
    assert ns == 8.0 and math.isnan(rate) and not on_frontier


def test_isas_that_answer_apart_are_found() -> None:
    scene = "near_edge:ulps=1"
    same = {name("a", isa, scene): (9, 1, 9, 1) for isa in ("scalar", "avx2")}
    apart = {
        name("b", "scalar", scene): (9, 1, 9, 1),
        name("b", "avx2", scene): (9, 2, 9, 0),
    }
    table = accuracy_tables.isa_agreement(accuracy_frame(same | apart))
    assert dict(zip(table["method"], table["agree"])) == {"a": True, "b": False}


def test_weights_are_pooled_by_points() -> None:
    frame = accuracy_frame(HARD)
    frame.loc[0, ["weights_largest_ulps", "weights_mean_ulps"]] = [32.0, 2.0]
    frame.loc[0, "weights_points"] = 300
    table = accuracy_tables.weights_accuracy(frame).set_index("method")
    row = table.loc["edge_function"]
    assert (row["largest_ulps"], row["points"]) == (32.0, 400)
    assert row["mean_ulps"] == (2.0 * 300 + 0.5 * 100) / 400
    assert row["not_finite"] == 2
    assert (row["largest_forward_ulps"], row["mean_forward_ulps"]) == (16.0, 0.25)


def test_a_wrong_answer_of_many_isas_is_one_row() -> None:
    worst = pd.DataFrame(
        [
            [
                "x",
                "one_triangle",
                "s",
                "s",
                "m",
                "f32",
                isa,
                "false_inside",
                d,
                "inside",
                *"abcp",
            ]
            for isa, d in (("scalar", 2.0), ("avx2", 2.0), ("avx512", 7.0))
        ],
        columns=["name", "loop", "scene", "family", "method", "scalar", "isa"]
        + ["kind", "distance_ulps", "said", "a", "b", "c", "p"],
    )
    table = accuracy_tables.worst_answers(worst)
    assert list(table["isa"]) == ["avx512", "scalar, avx2"]
