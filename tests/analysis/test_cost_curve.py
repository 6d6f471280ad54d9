"""The cost of exact answers along the share of points on an edge."""

from __future__ import annotations

import math

import pandas as pd
import pytest

from analysis.accuracy.cost_curve import (
    cost_curve,
    curve_chart,
    places,
    worst_case,
    worst_scenes,
    worst_words,
)
from analysis.accuracy.failure_exhibits import add_exact
from analysis.report.exhibits import Exhibits
from analysis.speed.tables import speed_cells
from tests.analysis.test_tables import FRESH, name, speed_frame

STEADY = [1 + k / 900 for k in range(9)]


def cell(method: str, percent: int, isa: str = "avx2", scalar: str = "f32") -> str:
    return at_scene(method, f"on_edge:percent={percent}:sets=fresh", isa, scalar)


def at_scene(method: str, scene: str, isa: str = "avx2", scalar: str = "f32") -> str:
    return name(method, isa, scene).replace("/f32/", f"/{scalar}/")


def frame(times: dict[str, float], shard: str = "speed-a") -> pd.DataFrame:
    return speed_frame(
        {at: [factor * t for t in STEADY] for at, factor in times.items()}, shard
    )


def curve(speed: pd.DataFrame) -> pd.DataFrame:
    return cost_curve(speed, speed_cells(speed))


TIMES = {
    cell("edge_function_fma", 0): 1.0,
    cell("edge_function_fma", 10): 1.0,
    cell("edge_function_fma", 100): 2.0,
    cell("exact", 0): 1.1,
    cell("exact", 10): 4.0,
    cell("exact", 100): 6.0,
    cell("shewchuk_adaptive", 10): 9.0,
    name("exact", "avx2", FRESH): 7.0,
}


def test_each_cell_is_over_the_edge_function_of_its_own_scene() -> None:
    table = curve(frame(TIMES)).set_index(["method", "percent"])
    assert len(table) == 7  # the uniform scene is none of them
    for percent, ratio in ((0, 1.1), (10, 4.0), (100, 3.0)):
        row = table.loc["exact", percent]
        assert row["times_edge"] == pytest.approx(ratio, rel=0.003)
        assert row["times_edge_low"] < row["times_edge"] < row["times_edge_high"]
    assert table.loc["edge_function_fma", 10]["times_edge"] == 1.0


def test_without_the_edge_function_in_the_shard_there_is_a_time_but_no_ratio() -> None:
    both = pd.concat(
        [frame(TIMES), frame({cell("exact", 10, "avx512"): 3.0}, "speed-b")]
    )
    alone = curve(both).set_index("isa").loc["avx512"]
    assert alone["ns"] == pytest.approx(3.0, rel=0.01)
    assert math.isnan(alone["times_edge"])


def test_the_worst_case_is_of_exact_by_ratio_and_not_by_time() -> None:
    worst = worst_case(curve(frame(TIMES)))
    assert worst is not None
    assert (worst["method"], worst["percent"]) == ("exact", 10)


def test_the_worst_case_looks_at_every_scalar_and_isa() -> None:
    more = {
        **TIMES,
        cell("edge_function_fma", 100, "avx512", "f64"): 1.0,
        cell("exact", 100, "avx512", "f64"): 5.0,
    }
    words = worst_words(curve(frame(more)))
    assert words is not None
    assert (words["scalar"], words["isa"], words["points"]) == (
        "f64",
        "avx512",
        "100 % of the points exactly on an edge",
    )
    assert words["ratio"].startswith("5.0") and words["interval"].startswith("4.9")
    assert words["isas"] == "avx2, avx512" and words["scenes"] == "3 scenes"
    assert words["exactly"]


VERTEX = "on_boundary:at=vertex:binades=240:sets=fresh"
EDGE = "on_boundary:at=edge:binades=0:sets=fresh"
BOUNDARY = {
    **TIMES,
    at_scene("edge_function_fma", VERTEX): 1.0,
    at_scene("exact", VERTEX): 90.0,
    at_scene("edge_function_fma", EDGE): 1.0,
    at_scene("exact", EDGE): 5.0,
    at_scene("exact", EDGE, "scalar"): 100.0,
}


def test_the_worst_case_is_that_of_points_on_the_boundary() -> None:
    words = worst_words(curve(frame(BOUNDARY)))
    assert words is not None
    assert words["points"] == "all points at a vertex, exponents over 240 binades"
    assert words["ratio"].startswith("90.")
    # The longest time needs no ratio.
    assert "in f32 on scalar, all points exactly on an edge" in words["slowest"]


def test_the_worst_scenes_are_those_without_a_point_inside_longest_first() -> None:
    table = worst_scenes(curve(frame(BOUNDARY)))
    assert list(table["ns"].round()) == [90.0, 6.0, 5.0]
    assert set(table["isa"]) == {"avx2"} and set(table["method"]) == {"exact"}
    assert table["points"].iloc[1] == "100 % of the points exactly on an edge"
    assert not len(worst_scenes(curve(frame({name("exact", "avx2", FRESH): 1.0}))))


def test_the_chart_has_no_scene_without_a_share() -> None:
    chart = curve_chart(curve(frame(BOUNDARY)), "footer")
    assert "90" not in chart.alt.replace("\u00a0", " ") and "nan" not in chart.alt


def captions(speed: pd.DataFrame) -> dict[str, str]:
    exhibits = Exhibits()
    add_exact(exhibits, pd.DataFrame(), pd.DataFrame(), curve(speed), "footer")
    return {exhibit.key: exhibit.caption for exhibit in exhibits}


def test_the_captions_say_where_the_points_are() -> None:
    found = captions(frame(BOUNDARY))
    assert "exactly on an edge" in found["cost_curve"]
    assert "every point is on the boundary" in found["exact_worst"]
    old = {at.replace("on_edge", "edge_share"): t for at, t in TIMES.items()}
    found = captions(frame(old))
    assert "rounded onto an edge" in found["cost_curve"]
    assert "exact_worst" not in found


def test_points_that_were_rounded_onto_an_edge_are_not_said_to_be_on_it() -> None:
    old = {at.replace("on_edge", "edge_share"): t for at, t in TIMES.items()}
    words = worst_words(curve(frame(old)))
    assert words is not None and not words["exactly"]
    assert words["points"] == "10 % of the points rounded onto an edge"
    both = curve(frame({**old, **TIMES}))
    assert set(both["family"]) == {"on_edge"}


def test_without_a_ratio_there_is_no_worst_case() -> None:
    table = curve(frame({cell("exact", 10): 3.0}))
    assert worst_case(table) is None and worst_words(table) is None
    assert worst_case(curve(frame({name("exact", "avx2", FRESH): 1.0}))) is None


def test_no_share_stands_left_of_nothing() -> None:
    at = places([100.0, 0.0, 1.0, 10.0])
    assert list(at) == [0.0, 1.0, 10.0, 100.0]
    assert list(at.values()) == [-1.0, 0.0, 1.0, 2.0]
    assert places([0.0]) == {0.0: -1.0}


def test_the_chart_says_the_worst_case_and_every_time() -> None:
    chart = curve_chart(curve(frame(TIMES)), "footer")
    text = (chart.title + chart.alt).replace("\u00a0", " ")
    assert "at most 4.00 × the time of edge_function_fma (3.9" in text
    assert "f32, avx2, 10 %" in text
    assert "shewchuk_adaptive, f32, 10 %: 9.0" in text


def test_a_chart_without_a_ratio_claims_none() -> None:
    chart = curve_chart(curve(frame({cell("exact", 10): 3.0})), "footer")
    assert "at most" not in chart.title and "exact, f32, 10 %: 3.0" in chart.alt
