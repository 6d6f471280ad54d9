"""Method × failure class, and what flags change, against small frames."""

from __future__ import annotations

import math

import pandas as pd
import pytest

from analysis.accuracy.failure_columns import failure_rate, wrong_answers
from analysis.accuracy.flags_axis import MESH, bases, flags_axis
from analysis.accuracy.overview import failing_most, never_failing, overview
from analysis.charts import ramp
from analysis.read.run import MethodEntry
from analysis.report.method_families import FAMILIES, by_family, family_of, in_order
from analysis.speed.tables import speed_cells
from analysis.trust.stats import wilson
from tests.analysis.synthetic_methods import METHODS
from tests.analysis.test_tables import FRESH, accuracy_frame, name, speed_frame

EDGE, NEEDLE = "near_edge:ulps=1", "needle:aspect=4"


def frame(boundary_rule: str = "closed", accepted: int = 10) -> pd.DataFrame:
    """One method on two scenes of a family, one of another, and a mesh."""
    cells = accuracy_frame(
        {
            name("edge_function", "avx2", EDGE): (100, 10, 300, 30),
            name("edge_function", "avx2", "near_edge:ulps=2"): (200, 2, 400, 18),
            name("edge_function", "avx2", NEEDLE): (50, 0, 50, 0),
            name("edge_function", "avx2", "mesh_pair:ulps=0"): (50, 0, 50, 0),
            name("edge_function", "scalar", EDGE): (100, 99, 300, 99),
        }
    )
    cells["boundary_rule"] = boundary_rule
    cells["boundary_accepted"] = accepted
    mesh = cells["family"] == "mesh_pair"
    cells.loc[mesh, ["hole", "hole_of", "double_hit", "double_hit_of"]] = [3, 40, 0, 40]
    cells[["rotated_vertices", "rotated_vertices_of"]] = [1, 100]
    cells[["swapped_vertices", "swapped_vertices_of"]] = [2, 100]
    return cells


def test_scenes_of_a_family_are_pooled_on_the_widest_isa() -> None:
    row = overview(frame(), "f32").iloc[0]
    assert row["isa"] == "avx2"
    assert (row["near_edge_count"], row["near_edge_of"]) == (60, 1000)
    assert row["near_edge"] == 0.06
    assert (row["near_edge_low"], row["near_edge_high"]) == wilson(60, 1000)[1:3]


def test_no_failure_is_told_from_not_measured() -> None:
    row = overview(frame(), "f32").iloc[0]
    assert (row["needle"], row["needle_of"]) == (0.0, 100)
    assert math.isnan(row["offset"]) and row["offset_of"] == 0


def test_classes_are_pooled_over_all_scenes_that_have_them() -> None:
    row = overview(frame(), "f32").iloc[0]
    assert (row["hole_count"], row["hole_of"]) == (3, 40)
    assert (row["order_count"], row["order_of"]) == (4 * 1 + 4 * 2, 4 * 200)


def test_swaps_are_counted_of_those_that_a_reversal_does_not_change() -> None:
    cells = frame()
    cells[["reversed_winding", "reversed_winding_of"]] = [30, 100]
    row = overview(cells, "f32").iloc[0]
    assert (row["order_count"], row["order_of"]) == (4 * 3, 4 * (100 + 100 - 30))
    assert (row["winding_count"], row["winding_of"]) == (4 * 30, 4 * 100)


def test_special_values_the_corpus_and_meshes_have_their_wrong_answers() -> None:
    cells = accuracy_frame(
        {
            name("m", "avx2", "special:kind=subnormal"): (100, 5, 300, 60),
            name("m", "avx2", "special:kind=largest"): (100, 0, 100, 0),
            name("m", "avx2", "special:kind=nan"): (100, 9, 300, 9),
            name("m", "avx2", "corpus"): (4, 0, 3, 1),
            name("m", "avx2", "mesh_pair:ulps=0"): (50, 7, 50, 0),
            name("m", "avx2", "mesh_fan:ulps=0"): (50, 0, 50, 2),
        }
    )
    cells["not_finite"] = [9 * (s == "special:kind=nan") for s in cells["scene"]]
    row = overview(cells, "f32").iloc[0]
    assert (row["special_count"], row["special_of"]) == (65, 600)
    assert (row["corpus_count"], row["corpus_of"]) == (1, 7)
    assert (row["mesh_count"], row["mesh_of"]) == (9, 200)
    assert failing_most(overview(cells, "f32"), "special") == ("m", 65 / 600)


def test_false_inside_and_false_outside_stand_apart() -> None:
    row = overview(frame(), "f32").iloc[0]
    assert (row["near_edge_inside_count"], row["near_edge_inside_of"]) == (48, 700)
    assert (row["near_edge_outside_count"], row["near_edge_outside_of"]) == (12, 300)
    low, high = wilson(12, 300)[1:3]
    assert row["near_edge_outside"] == 0.04
    assert (row["near_edge_outside_low"], row["near_edge_outside_high"]) == (low, high)


@pytest.mark.parametrize(
    ("rule", "accepted", "broken", "of"),
    [("closed", 7, 12, 40), ("open", 7, 28, 40), ("half_open", 5, 0, 0)],
)
def test_a_boundary_rule_is_broken_only_where_it_says_something(
    rule: str, accepted: int, broken: int, of: int
) -> None:
    row = overview(frame(rule, accepted), "f32").iloc[0]
    assert (row["boundary_count"], row["boundary_of"]) == (broken, of)
    assert row["boundary_accepted_count"] == 4 * accepted


def test_a_family_that_only_another_loop_has_is_counted_all_the_same() -> None:
    cells = {
        name("a", "avx2", EDGE): (100, 10, 300, 30),
        name("a", "avx2", "near_edge:ulps=2"): (100, 0, 300, 0),
        name("a", "avx2", EDGE, "pairs"): (100, 99, 300, 99),
        name("a", "avx2", NEEDLE, "pairs"): (100, 1, 300, 1),
    }
    row = overview(accuracy_frame(cells), "f32").iloc[0]
    assert (row["near_edge_count"], row["near_edge_of"]) == (40, 800)
    assert (row["needle_count"], row["needle_of"]) == (2, 400)


def test_who_fails_most_and_who_never() -> None:
    clean = {
        name("exact", "avx2", EDGE): (100, 0, 300, 0),
        name("edge_function", "avx2", EDGE): (100, 10, 300, 30),
        name("cross_product", "avx2", EDGE): (100, 0, 300, 1),
    }
    table = overview(accuracy_frame(clean), "f32")
    assert never_failing(table) == ["exact"]
    assert failing_most(table, "near_edge") == ("edge_function", 0.1)
    assert failing_most(table, "needle") is None


def test_a_method_of_another_question_is_neither() -> None:
    cells = accuracy_frame({name("a", "avx2", EDGE): (100, 0, 300, 0)})
    table = overview(cells.assign(accepts="third_near_vertex_a"), "f32")
    assert never_failing(table) == []
    assert failing_most(table, "near_edge") is None


def test_a_cell_shows_its_rate_of_how_many_and_its_colour() -> None:
    row = overview(frame(), "f32").iloc[0].to_dict()
    shown = failure_rate("near_edge", "near an edge")
    assert shown.show(row) == "6.0\u00a0%"
    assert shown.tint is not None and shown.tip is not None and shown.note is not None
    assert shown.tint(row) == "rate4"
    assert shown.tip(row).startswith("60 of 1000: 6.00\u00a0% (4.")
    none = failure_rate("needle", "needles")
    assert none.note is not None and none.tint is not None
    assert (none.show(row), none.note(row)) == ("0", "of 100")
    assert none.tint(row) == "rate-none"
    unknown = failure_rate("offset", "far away")
    assert unknown.note is not None and unknown.tint is not None
    assert (unknown.show(row), unknown.note(row), unknown.tint(row)) == ("–", "", "")


def test_a_cell_shows_false_inside_over_false_outside_each_in_its_colour() -> None:
    row = overview(frame(), "f32").iloc[0].to_dict()
    shown = wrong_answers("near_edge", "near an edge")
    assert shown.tint is not None and shown.tip is not None and shown.note is not None
    assert (shown.show(row), shown.note(row)) == ("6.9\u00a0%", "4.0\u00a0%")
    assert shown.tint(row) == "rate4 under-rate4"
    tip = shown.tip(row)
    assert tip.startswith("false inside: 48 of 700: ") and "outside: 12 of 300" in tip
    row |= {"near_edge_inside_count": 0, "near_edge_inside": 0.0}
    assert shown.tint(row) == "rate-none under-rate4"
    row |= {"near_edge_outside_count": 3, "near_edge_outside": 3e-6}
    assert shown.tint(row) == "rate-none under-rate0"
    none = wrong_answers("needle", "needles")
    assert none.note is not None and none.tint is not None and none.tip is not None
    assert (none.show(row), none.note(row)) == ("0", "of 100")
    assert none.tint(row) == "rate-none"
    assert none.tip(row).startswith("0 of 100")


def test_every_colour_of_a_second_line_is_in_the_style() -> None:
    style = ramp.css()
    for level, colour in enumerate(ramp.COLOURS):
        assert f"td.rate{level} {{ background: {colour};" in style
        assert f"td.under-rate{level} small {{ background: {colour};" in style


@pytest.mark.parametrize(
    ("rate", "level"),
    [(1e-9, 0), (1e-5, 0), (1.1e-5, 1), (1e-3, 2), (0.0101, 4), (0.1, 4), (1.0, 5)],
)
def test_a_colour_is_a_decade(rate: float, level: int) -> None:
    assert ramp.level(rate) == level


def test_more_failures_are_darker_and_none_is_white() -> None:
    def lightness(rate: float) -> float:
        red, green, blue = ramp.colour(rate)
        return 0.2126 * red + 0.7152 * green + 0.0722 * blue

    rates = [0.0, *(10 ** (e / 4) for e in range(-24, 1))]
    steps = [lightness(rate) for rate in rates]
    assert all(one > other for one, other in zip(steps, steps[1:]))
    assert ramp.colour(0.0) == (255, 255, 255)
    assert ramp.colour(math.nan) == ramp.rgb(ramp.UNKNOWN)


def test_a_multiply_add_form_stands_behind_its_method() -> None:
    ordered = in_order(["uv_projection_fma", "cross_solve", "uv_projection", "zz_fma"])
    assert ordered == ["uv_projection", "uv_projection_fma", "cross_solve", "zz_fma"]


def test_every_method_has_a_family_and_no_panel_is_crowded() -> None:
    groups = by_family(METHODS)
    assert sorted(m for _, members in groups for m in members) == sorted(METHODS)
    assert all(family in FAMILIES for family, _ in groups)
    assert max(len(members) for _, members in groups) <= 10
    assert family_of("brand_new").title == "Others"


def entry(key: str, warning: str = "") -> MethodEntry:
    return MethodEntry(key, "", "", "closed", "triangle", False, False, warning)


def test_forms_are_found_by_their_names() -> None:
    entries = (entry("cross_product_fast_math", "not for NaN"), entry("lone", "odd"))
    methods = ["cross_product", "cross_product_fast_math", "lone", "other_fma"]
    assert bases([*methods, "edge_function", "edge_function_fma"], entries) == {
        "edge_function_fma": ("edge_function", ""),
        "cross_product_fast_math": ("cross_product", "not for NaN"),
        "lone": ("", "odd"),
    }


def test_a_flag_changes_errors_and_time_side_by_side() -> None:
    accuracy = accuracy_frame(
        {
            name("edge_function", "avx2", EDGE): (100, 10, 300, 30),
            name("edge_function_fma", "avx2", EDGE): (100, 4, 300, 0),
        }
    )
    speed = speed_frame(
        {
            name("edge_function", "avx2", FRESH): [4.0, 4.0, 4.0],
            name("edge_function_fma", "avx2", FRESH): [2.0, 3.0, 2.0],
            name("edge_function", "scalar", FRESH): [9.0, 9.0, 9.0],
            name("edge_function_fma", "scalar", FRESH): [9.0, 9.0, 9.0],
        }
    )
    table = flags_axis(accuracy, speed, speed_cells(speed), (), ["f32"])
    row = table.iloc[0]
    assert (row["method"], row["base"]) == ("edge_function_fma", "edge_function")
    assert (row["base_error"], row["error"]) == (0.1, 0.01)
    assert row["time"] == 0.5
    assert row["hole_of"] == 0


def test_holes_of_a_flag_are_those_of_one_scene_whatever_else_a_profile_has() -> None:
    cells = accuracy_frame(
        {
            name(method, "avx2", scene): (50, 0, 50, 0)
            for method in ("edge_function", "edge_function_fma")
            for scene in (EDGE, MESH, "mesh_pair:ulps=4096", "mesh_fan:ulps=0")
        }
    )
    asked = cells["family"].str.startswith("mesh")
    cells.loc[asked, ["hole", "hole_of", "double_hit", "double_hit_of"]] = [
        0,
        40,
        0,
        40,
    ]
    cells.loc[asked & (cells["scene"] != MESH), "hole"] = 30
    torn = (cells["scene"] == MESH) & (cells["method"] == "edge_function_fma")
    cells.loc[torn, ["hole", "double_hit"]] = [4, 2]
    speed = speed_frame({name("edge_function", "avx2", FRESH): [4.0]})
    table = flags_axis(cells, speed, speed_cells(speed), (), ["f32"])
    row = table.iloc[0]
    assert (row["hole_count"], row["hole_of"], row["hole"]) == (4, 40, 0.1)
    assert (row["base_hole_count"], row["base_hole_of"]) == (0, 40)
    assert (row["double_hit_count"], row["base_double_hit_count"]) == (2, 0)
    without = cells[cells["scene"] != MESH]
    row = flags_axis(without, speed, speed_cells(speed), (), ["f32"]).iloc[0]
    assert (row["hole_count"], row["hole_of"]) == (0, 0) and math.isnan(row["hole"])
