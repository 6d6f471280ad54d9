"""The published scene as two tracks, from an invented run."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pandas as pd
import pytest

from analysis.read.load import load_run
from analysis.speed import grid_tables, tables
from tests.analysis.synthetic import ISA_SPEED, write_run


@pytest.fixture(scope="module")
def speed(tmp_path_factory: pytest.TempPathFactory) -> pd.DataFrame:
    run = load_run(write_run(tmp_path_factory.mktemp("run") / "run"))
    assert dict(run.writes) == {"one_triangle": "a bit each", "grid": "rows of bits"}
    return run.speed


@pytest.fixture(scope="module")
def cells(speed: pd.DataFrame) -> pd.DataFrame:
    return tables.speed_cells(speed)


@pytest.fixture(scope="module")
def scene(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    writes = {"one_triangle": "a bit each", "grid": "rows of bits"}
    return grid_tables.published_scene(speed, cells, writes)


def row(scene: pd.DataFrame, track: str, method: str, scalar: str) -> pd.Series:
    own = scene[
        (scene["track"] == track)
        & (scene["method"] == method)
        & (scene["scalar"] == scalar)
        & (scene["isa"] == "avx512")
    ]
    assert len(own) == 1
    return own.iloc[0]


def test_pixels_of_a_scene_are_columns_times_rows() -> None:
    assert grid_tables.pixels("grid_80x50") == 4000
    assert grid_tables.pixels("grid_points_80x50") == 4000
    assert grid_tables.pixels("grid_7x3") == 21


def test_both_tracks_are_counted_in_triangles(scene: pd.DataFrame) -> None:
    rate = ISA_SPEED["avx512"]
    points = row(scene, "points", "edge_function", "i32")
    assert points["ns"] == pytest.approx(1.1 / rate * 4000, rel=0.05)
    assert points["pixel_ns"] == pytest.approx(1.1 / rate, rel=0.05)
    grid = row(scene, "grid", "row_spans", "i32")
    assert grid["ns"] == pytest.approx(110.0 / rate, rel=0.05)
    assert grid["pixel_ns"] == pytest.approx(110.0 / rate / 4000, rel=0.05)


def test_every_row_is_compared_with_the_i32_points_of_its_isa(
    scene: pd.DataFrame,
) -> None:
    for track, method, scalar, expected in (
        ("points", "edge_function", "i32", 1.0),
        ("points", "edge_function", "i16", 1.1 / 0.5),
        ("points", "byte_pairs", "u8", 1.1 / 0.25),
        ("grid", "row_spans", "i32", 4400.0 / 110.0),
    ):
        found = row(scene, track, method, scalar)
        assert found["times_points"] == pytest.approx(expected, rel=0.03), method
        assert found["times_points_low"] <= found["times_points"]
        assert found["times_points"] <= found["times_points_high"]


def test_fixed_triangles_are_left_out_and_what_is_written_is_said(
    scene: pd.DataFrame,
) -> None:
    assert not scene["name"].str.contains("fixed").any()
    assert set(scene[scene["track"] == "points"]["writes"]) == {"a bit each"}
    assert set(scene[scene["track"] == "grid"]["writes"]) == {"rows of bits"}


def test_within_a_track_and_isa_the_fastest_comes_last(scene: pd.DataFrame) -> None:
    for _, group in scene.groupby(["track", "isa"], sort=False):
        assert list(group["ns"]) == sorted(group["ns"], reverse=True)
    assert list(scene["track"].unique()) == ["points", "grid"]


def test_a_run_without_points_has_no_ratio_and_no_sentence(
    speed: pd.DataFrame,
) -> None:
    old = speed[~speed["family"].str.contains("points")]
    old_cells = tables.speed_cells(old)
    table = grid_tables.published_scene(old, old_cells, {})
    assert set(table["track"]) == {"grid"}
    assert np.isnan(table["times_points"]).all()
    assert grid_tables.fastest_sentence(table) == ""
    gains = grid_tables.across_edges(old, old_cells)
    assert grid_tables.gain_sentence(gains) == ""


def test_a_run_without_the_scene_has_no_table(speed: pd.DataFrame) -> None:
    none = speed[~speed["family"].str.startswith("grid")]
    table = grid_tables.published_scene(none, tables.speed_cells(none), {})
    assert not len(table)
    assert grid_tables.fastest_sentence(table) == ""


def test_points_as_lanes_gain_what_the_times_say(
    speed: pd.DataFrame, cells: pd.DataFrame
) -> None:
    gains = grid_tables.across_edges(speed, cells).set_index("isa")
    assert "scalar" not in gains.index
    assert gains.loc["avx512", "gain"] == pytest.approx(
        0.6 / 1.1 * ISA_SPEED["avx512"], rel=0.03
    )
    sentence = grid_tables.gain_sentence(gains.reset_index())
    assert "on avx512" in sentence and "qTriangle" in sentence


def test_the_fastest_of_each_track_is_named(scene: pd.DataFrame) -> None:
    sentence = grid_tables.fastest_sentence(scene)
    assert sentence.startswith("On avx512 ")
    assert "byte_pairs in u8" in sentence and "row_spans in i32" in sentence
