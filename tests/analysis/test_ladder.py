"""Kernels that are slower than the one below, against frames made by hand and
a run made up."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from analysis.read.load import load_run
from analysis.read.load_instructions import INSTRUCTIONS_COLUMNS
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed import ladder, tables
from analysis.speed.ladder_reasons import UNEXPLAINED, Evidence, explanation
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run
from tests.analysis.test_tables import name, speed_frame

# Repetitions that differ by a thousandth.
STEADY = [1 + k / 9000 for k in range(9)]
WIDE = [0.8 + k / 12 for k in range(9)]


def times(factor: float) -> list[float]:
    return [factor * time for time in STEADY]


SPEED = speed_frame(
    {
        name("edge_function", "scalar"): times(8.0),
        name("edge_function", "sse4"): times(2.0),
        name("edge_function", "avx2"): times(2.2),  # slower than sse4
        name("edge_function", "avx512"): times(1.0),
        name("cross_product", "avx2"): times(1.0),
        name("cross_product", "avx512"): WIDE,  # who knows
        name("cross_product", "autovec_v3"): times(9.0),  # not on the ladder
        name("cross_product", "avx2") + "/twin": times(0.5),
    }
)
CELLS = tables.speed_cells(SPEED)
STEPS = ladder.ladder_steps(SPEED, CELLS)


def executed(**per_item: float) -> pd.DataFrame:
    """Instructions an item of edge_function in the frame above, by ISA."""
    rows = [
        {
            "method": "edge_function",
            "scalar": "f32",
            "loop": "one_triangle",
            "isa": isa,
            "per_item": count,
            "per_call": 0.0,
        }
        for isa, count in per_item.items()
    ]
    return pd.DataFrame(rows, columns=INSTRUCTIONS_COLUMNS)


def slower(
    instructions: pd.DataFrame, spread: float = math.nan, **bound: Any
) -> pd.DataFrame:
    return ladder.slower_steps(STEPS.assign(**bound), CELLS, instructions, spread)


def test_a_step_goes_to_the_nearest_isa_below_that_was_timed() -> None:
    found = {(row["method"], row["isa"]): row["below"] for _, row in STEPS.iterrows()}
    assert found == {
        ("edge_function", "sse4"): "scalar",
        ("edge_function", "avx2"): "sse4",
        ("edge_function", "avx512"): "avx2",
        ("cross_product", "avx512"): "avx2",
    }


def test_only_a_step_that_a_test_tells_apart_is_slower() -> None:
    table = slower(executed())
    assert list(zip(table["method"], table["isa"])) == [("edge_function", "avx2")]
    row = table.iloc[0]
    assert row["ratio"] == pytest.approx(1.1, rel=1e-3)
    assert 1 < row["ratio_low"] <= row["ratio"] <= row["ratio_high"]
    unsure = STEPS.set_index(["method", "isa"]).loc[("cross_product", "avx512")]
    assert unsure["ratio"] > 1 and unsure["false_share"] > ladder.CHANCE


def test_loops_left_to_the_compiler_have_a_ladder_of_their_own() -> None:
    speed = speed_frame(
        {
            name("edge_function", "scalar"): times(1.0),
            name("edge_function", "avx2"): times(1.0),
            name("edge_function", "autovec_v2"): times(4.0),
            name("edge_function", "autovec_v4"): times(5.0),
        }
    )
    steps = ladder.ladder_steps(speed, tables.speed_cells(speed))
    found = {row["isa"]: row["below"] for _, row in steps.iterrows()}
    assert found == {"avx2": "scalar", "autovec_v4": "autovec_v2"}


def test_of_many_equal_steps_chance_makes_hardly_any_slower() -> None:
    random = np.random.default_rng(1)
    cells = {}
    for n in range(1, 301):
        scene = f"uniform:hit=50:n={n}:sets=fresh"
        for isa in ("avx2", "avx512"):
            samples = random.normal(1, 0.01, 9)
            cells[f"one_triangle/{scene}/exact/f32/{isa}"] = list(samples)
    speed = speed_frame(cells)
    steps = ladder.ladder_steps(speed, tables.speed_cells(speed))
    assert len(steps) == 300
    assert (steps["ratio_low"] > 1).sum() >= 3  # each by itself
    assert (steps["false_share"] <= ladder.CHANCE).sum() == 0


SCENES = {
    "one_triangle/uniform:hit=50:n=8:sets=fresh": (8.0, 9.0),
    "one_triangle/uniform:hit=50:n=4096:sets=fresh": (1.0, 0.5),
    "one_triangle/uniform:hit=50:bytes=64M:sets=fresh": (2.0, 2.4),
    "one_triangle/uniform:hit=50:bytes=64M:sets=fixed": (1.0, 9.0),
    "one_triangle/needle:aspect=12:sets=fresh": (1.0, 1.3),
    "one_triangle/offset:ratio=8:sets=fresh": (1.0, 1.4),
    "grid/grid_80x50:sets=fresh": (1.0, 1.5),
}


def on_many_scenes() -> tuple[pd.DataFrame, pd.DataFrame]:
    speed = speed_frame(
        {
            f"{place}/exact/f32/{isa}": times(factor)
            for place, factors in SCENES.items()
            for isa, factor in zip(("avx2", "avx512"), factors)
        }
    )
    items = [8.0 if ":n=8:" in name else 4096.0 for name in speed["name"]]
    speed = speed.assign(items=items)
    return speed, tables.speed_cells(speed)


def test_every_fresh_scene_is_a_step_and_a_kernel_has_a_row_for_each_reason() -> None:
    speed, cells = on_many_scenes()
    steps = ladder.ladder_steps(speed, cells)
    assert len(steps) == len(SCENES) - 1  # not the fixed one
    slower = ladder.slower_steps(steps, cells, executed(), math.nan)
    table = ladder.by_kernel(steps, slower)
    assert [
        (row["loop"], row["scene"], row["slower"], row["scenes"])
        for _, row in table.iterrows()
    ] == [
        ("grid", "grid_80x50:sets=fresh", 1, 1),
        ("one_triangle", "offset:ratio=8:sets=fresh", 3, 5),
        ("one_triangle", "uniform:hit=50:n=8:sets=fresh", 1, 5),
    ]
    assert list(table["reason"]) == [UNEXPLAINED, UNEXPLAINED, "short calls"]
    # 0.5 ns of 9 are what an item takes in the longer call.
    assert "calls of 8 items" in table["because"].iloc[2]
    assert "94.4\u00a0%" in table["because"].iloc[2]


def test_cells_that_several_cpus_shared_are_no_steps() -> None:
    speed, cells = on_many_scenes()
    assert not len(ladder.ladder_steps(speed, cells.assign(threads=2)))


def test_a_noisy_row_is_called_so_and_stays_unexplained() -> None:
    noisy = STEPS.assign(noise_below="wide")
    table = ladder.slower_steps(noisy, CELLS, executed(), math.nan)
    assert table["reason"].iloc[0] == UNEXPLAINED
    assert table["because"].iloc[0].endswith("noisy by itself")


@pytest.mark.parametrize(
    "instructions, spread, bound, begins",
    [
        (executed(), math.nan, {}, UNEXPLAINED),
        (executed(sse4=9, avx2=8), math.nan, {}, UNEXPLAINED),
        (executed(sse4=8, avx2=9), math.nan, {}, "compiled to more instructions"),
        (executed(avx2=9), math.nan, {}, UNEXPLAINED),
        (executed(sse4=8, avx2=8), 1.2, {}, "differs no more than"),
        (executed(sse4=8, avx2=8), 1.05, {}, "executes as many instructions"),
        (executed(), 1.05, {}, UNEXPLAINED),
        (
            executed(sse4=8, avx2=9),
            1.2,
            {"of_limit": 0.9, "bound_by": "memory", "bound_of": "L1"},
            "at 90.0\u00a0% of what L1 gives",
        ),
        (
            executed(sse4=8, avx2=9),
            1.2,
            {
                "of_limit": 0.9,
                "bound_by": "memory",
                "bound_of": "stores",
                "of_limit_below": 0.95,
                "bound_by_below": "memory",
            },
            "bound by memory: both are as fast as it allows, at 90.0\u00a0% and "
            "95.0\u00a0% of what stores allow",
        ),
        (
            executed(),
            math.nan,
            {"of_limit": 0.7, "bound_by": "memory", "bound_of": "L1"},
            UNEXPLAINED,
        ),
        (
            executed(),
            math.nan,
            {"of_limit": 0.9, "bound_by": "compute", "bound_of": "divide"},
            "at 90.0\u00a0% of the rate of division",
        ),
    ],
)
def test_a_reason_follows_from_the_figures_of_the_run(
    instructions: pd.DataFrame, spread: float, bound: dict[str, Any], begins: str
) -> None:
    because = slower(instructions, spread, **bound)["because"].iloc[0]
    assert because.startswith(begins)


@pytest.mark.parametrize(
    "isa, times_scalar, reason",
    [
        ("autovec_v4", 0.9, "not vectorised"),
        ("autovec_v4", 1.7, UNEXPLAINED),
        ("autovec_v4", math.nan, UNEXPLAINED),
        ("avx2", 0.9, UNEXPLAINED),
    ],
)
def test_a_plain_loop_as_fast_as_the_scalar_row_is_not_vectorised(
    isa: str, times_scalar: float, reason: str
) -> None:
    (step,) = STEPS[
        (STEPS["isa"] == "avx2") & (STEPS["method"] == "edge_function")
    ].to_dict("records")
    evidence = Evidence(CELLS.assign(isa=isa), executed(), math.nan)
    found = explanation(step | {"isa": isa, "times_scalar": times_scalar}, evidence)
    assert found[0] == reason


def test_the_page_counts_the_slower_kernels_and_names_them(tmp_path: Path) -> None:
    run = load_run(write_run(tmp_path, TWO_METHODS))
    plain = build(run)
    isas = [isa for isa in run.speed["isa"].unique() if isa in ladder.LADDER]
    widest = max(isas, key=list(ladder.LADDER).index)
    own = run.speed["isa"] == widest
    spoilt = dataclasses.replace(
        run, speed=run.speed.assign(ns=run.speed["ns"].where(~own, 1e6))
    )
    report = build(spoilt)
    assert report.ladder.slower > plain.ladder.slower
    page = render(report, "index.html.j2")
    told = report.ladder
    assert f"{told.slower} steps, of {told.slower_kernels} kernels, are slower" in page
    assert f"up to {told.chance} may be so by chance" in page
