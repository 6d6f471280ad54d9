"""Kernels that are slower than the one below, against frames made by hand and
a run made up."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.read.load import load_run
from analysis.read.load_instructions import INSTRUCTIONS_COLUMNS
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed import ladder, tables
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
STEPS = ladder.ladder_steps(SPEED, tables.speed_cells(SPEED))


def executed(**per_item: float) -> pd.DataFrame:
    """Instructions an item of edge_function in the frame above, by ISA."""
    rows = [
        {
            "method": "edge_function",
            "scalar": "f32",
            "loop": "one_triangle",
            "isa": isa,
            "per_item": count,
        }
        for isa, count in per_item.items()
    ]
    return pd.DataFrame(rows, columns=INSTRUCTIONS_COLUMNS)


def slower(
    instructions: pd.DataFrame, spread: float = math.nan, **bound: Any
) -> pd.DataFrame:
    return ladder.slower_steps(STEPS.assign(**bound), instructions, spread)


def test_a_step_goes_to_the_nearest_isa_below_that_was_timed() -> None:
    found = {(row["method"], row["isa"]): row["below"] for _, row in STEPS.iterrows()}
    assert found == {
        ("edge_function", "sse4"): "scalar",
        ("edge_function", "avx2"): "sse4",
        ("edge_function", "avx512"): "avx2",
        ("cross_product", "avx512"): "avx2",
    }


def test_only_a_step_whose_interval_lies_above_1_is_slower() -> None:
    table = slower(executed())
    assert list(zip(table["method"], table["isa"])) == [("edge_function", "avx2")]
    row = table.iloc[0]
    assert row["ratio"] == pytest.approx(1.1, rel=1e-3)
    assert 1 < row["ratio_low"] <= row["ratio"] <= row["ratio_high"]
    unsure = STEPS.set_index(["method", "isa"]).loc[("cross_product", "avx512")]
    assert unsure["ratio"] > 1 > unsure["ratio_low"]


def test_chance_is_half_of_what_the_interval_leaves_out() -> None:
    # 9 and 9 repetitions: coverage of 96 % or so (stats.ratio_interval).
    assert list(STEPS["chance"]) == pytest.approx([0.02] * 4, abs=0.005)


@pytest.mark.parametrize(
    "instructions, spread, bound, begins",
    [
        (executed(), math.nan, {}, ladder.UNEXPLAINED),
        (executed(sse4=9, avx2=8), math.nan, {}, ladder.UNEXPLAINED),
        (executed(sse4=8, avx2=9), math.nan, {}, "compiled to more instructions"),
        (executed(avx2=9), math.nan, {}, ladder.UNEXPLAINED),
        (executed(sse4=8, avx2=8), 1.2, {}, "differs no more than"),
        (executed(), 1.05, {}, ladder.UNEXPLAINED),
        (
            executed(sse4=8, avx2=9),
            1.2,
            {"of_limit": 0.9, "bound_by": "memory", "bound_of": "L1"},
            "at 90.0\u00a0% of what L1 delivers",
        ),
        (
            executed(),
            math.nan,
            {"of_limit": 0.7, "bound_by": "memory", "bound_of": "L1"},
            ladder.UNEXPLAINED,
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
    text = f"{report.ladder.slower} of {report.ladder.steps} kernels are slower"
    assert text in page
