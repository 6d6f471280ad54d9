"""The goals: what is reached follows from the intervals, and what was not timed is
left out and said to be.
"""

from __future__ import annotations

import dataclasses
import math
import re
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.read.load import load_run
from analysis.read.run import Run
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed import goals
from analysis.speed.bounds import with_bounds
from analysis.speed.goal_kernels import Measured
from analysis.speed.tables import speed_cells
from analysis.trust.stats import Interval
from tests.analysis.synthetic import write_run
from tests.analysis.test_input_tables import frame

SCENE = "uniform:hit=50:bytes={}:sets=fresh"
SIZES = {"24k": 24e3, "512k": 512e3, "4M": 4e6, "64M": 640e6}
TIMES = {"exact": 1.0, "edge_function_fma": 0.98, "edge_slope_fma": 0.5}


@pytest.fixture(scope="module")
def run(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return load_run(write_run(tmp_path_factory.mktemp("goals") / "run"))


def cell(loop: str, size: str, method: str, scalar: str, isa: str) -> str:
    return f"{loop}/{SCENE.format(size)}/{method}/{scalar}/{isa}"


def measured(run: Run, **changed: float) -> tuple[Run, pd.DataFrame]:
    """The run with cells of every level, each method with a time of its own."""
    times = {
        cell("one_triangle", size, method, scalar, isa): time
        for size in SIZES
        for method, time in (TIMES | changed).items()
        for scalar in goals.FLOATS
        for isa in goals.EXACT_ISAS
    }
    speed = frame(times)
    sizes = [SIZES[name.split("bytes=")[1].split(":")[0]] for name in speed["name"]]
    speed = speed.assign(working_set_bytes=sizes, scene_bytes=sizes)
    own = dataclasses.replace(run, speed=speed)
    return own, with_bounds(speed_cells(speed), run.limits, run.operations)


def found(run: Run, **changed: float) -> goals.Goals:
    own, cells = measured(run, **changed)
    return goals.goals(own, cells, {})


def row(table: pd.DataFrame, **wanted: Any) -> pd.Series:
    own = table
    for key, value in wanted.items():
        own = own[own[key] == value]
    assert len(own) == 1, own
    return own.iloc[0]


@pytest.mark.parametrize(
    ("low", "high", "wanted", "said"),
    [
        (1.31, 1.4, 1.3, goals.REACHED),
        (1.3, 1.4, 1.3, goals.REACHED),
        (1.2, 1.3, 1.3, goals.UNDECIDED),
        (1.1, 1.29, 1.3, goals.NOT_REACHED),
        (1.1, 1.29, math.nan, goals.NO_GOAL),
    ],
)
def test_an_outcome_follows_from_the_interval(
    low: float, high: float, wanted: float, said: str
) -> None:
    assert goals.outcome(Interval((low + high) / 2, low, high, 0.95), wanted) == said


def test_the_fastest_is_held_against_the_edge_function(run: Run) -> None:
    first = row(
        found(run).table,
        scalar="f32",
        against="edge_function_fma",
        isa="avx512",
        where="L1",
        method="edge_slope_fma",
    )
    assert first["value"] == pytest.approx(0.98 / 0.5, rel=0.02)
    assert first["value_low"] <= first["value"] <= first["value_high"]
    assert first["outcome"] == goals.REACHED
    slow = found(run, edge_slope_fma=0.97).table
    again = row(
        slow,
        scalar="f32",
        against="edge_function_fma",
        isa="avx512",
        where="L1",
        method="edge_slope_fma",
    )
    assert again["outcome"] == goals.NOT_REACHED


def test_exact_is_held_against_the_edge_function_and_the_fastest_inexact(
    run: Run,
) -> None:
    table = found(run).table
    own = table[(table["method"] == "exact") & (table["scalar"] == "f64")]
    assert len(own) == 8  # four goals on two instruction sets
    against_edge = row(own, against="edge_function_fma", isa="avx2")
    assert against_edge["value"] == pytest.approx(0.98, rel=0.02)
    rival = "the fastest inexact, edge_slope_fma"
    for where in ("L1", "L3", "DRAM"):
        beside = row(own, against=rival, isa="avx512", where=where)
        assert beside["value"] == pytest.approx(0.5, rel=0.02)
        assert beside["outcome"] == goals.NOT_REACHED
        assert beside["goal"].endswith("(an aim)") == (where == "L1")


# 8 bytes from memory take 1/8 of a cycle a vector of 64 bytes: 1 a cycle at 3.5 GHz.
def test_from_memory_the_share_of_the_bandwidth_is_what_counts(run: Run) -> None:
    table = found(run).table
    far = row(table, scalar="f32", against="loads from DRAM")
    assert far["where"] == "DRAM" and far["wanted"] == goals.OF_A_BOUND
    bytes_per_item = measured(run)[1]["bytes_per_item"].iloc[0]
    expected = bytes_per_item / 8 / 3.5 / far["ns"]
    assert far["value"] == pytest.approx(expected)


def test_a_beaten_bound_decides_nothing(run: Run) -> None:
    table = found(run, edge_slope_fma=1e-4).table
    far = row(table, scalar="f32", against="loads from DRAM")
    assert far["outcome"] == goals.WRONG_BOUND


def test_methods_that_are_unfit_are_not_the_fastest(run: Run) -> None:
    own, cells = measured(run)
    unfit = {"f32": frozenset({"edge_slope_fma"})}
    best = Measured(own, cells, unfit).best("one_triangle", "f32", "L1")
    assert best is not None and best["method"] == "edge_function_fma"
    other = Measured(own, cells, unfit).best("one_triangle", "f64", "L1")
    assert other is not None and other["method"] == "edge_slope_fma"


def test_what_was_not_timed_is_left_out_and_said(run: Run) -> None:
    few = found(run)
    assert not few.table["goal"].str.contains("published scene").any()
    assert "row spans to bits on avx512" in few.missing_words()
    assert "Many triangles" in few.missing_words()
    counts = few.counts()
    assert counts["set"] == sum(
        counts[key] for key in ("reached", "missed", "undecided")
    )


def test_the_published_scene_is_held_against_its_points(run: Run) -> None:
    cells = with_bounds(speed_cells(run.speed), run.limits, run.operations)
    table = goals.goals(run, cells, {}).table
    spans = row(table, method="row_spans")
    assert spans["value"] == pytest.approx(40.0, rel=0.03)
    assert spans["outcome"] == goals.REACHED and spans["unit"] == "triangle"
    lanes = row(table, method="edge_lanes")
    assert math.isnan(lanes["wanted"]) and lanes["outcome"] == goals.NO_GOAL


def test_the_page_counts_the_goals_and_shows_them(run: Run) -> None:
    report = build(run)
    page = render(report, "index.html.j2")
    counts = report.goals.counts()
    assert f"{counts['reached']} " in page and 'id="goals-section"' in page
    assert re.search(r"\d goals? (is|are) left out, since this run did not time", page)
    assert report.exhibits.get(goals.KEY) is not None


def test_a_run_without_limits_has_the_goals_that_need_none(run: Run) -> None:
    own, _ = measured(run)
    without = goals.goals(own, speed_cells(own.speed), {})
    assert set(without.table["where"]) == {"L1"}
    assert without.table["of_limit"].isna().all()
    assert "its bound" in without.missing_words()
