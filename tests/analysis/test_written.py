"""What kernels write, and the bound that it is, worked out by hand."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.read.limits import Limits
from analysis.read.load import load_run
from analysis.read.load_operations import no_operations
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed import grid_tables, limit_exhibits
from analysis.speed.bounds import with_bounds
from analysis.speed.limit_columns import bound_words
from analysis.speed.limit_prose import limit_facts
from analysis.speed.tables import speed_cells
from analysis.speed.written import (
    STORES,
    bits_written,
    grid_size,
    numbers_written,
    store_ns,
)
from tests.analysis.synthetic import write_run
from tests.analysis.synthetic_limits import GHZ
from tests.analysis.test_bounds import cell, machine  # noqa: F401


def row(loop: str, family: str = "uniform", **other: Any) -> dict[str, Any]:
    return {
        "loop": loop,
        "family": family,
        "scalar": "f32",
        "isa": "avx2",
        "items": 1024.0,
    } | other


@pytest.mark.parametrize(
    ("written", "bits", "numbers"),
    [
        (row("one_triangle"), 1 / 8, 0),
        (row("one_triangle_aos"), 1 / 8, 0),
        (row("pairs_weights"), 1 / 8, 12),
        (row("pairs_weights", scalar="f64"), 1 / 8, 24),
        (row("ray_pairs_tuv", "rays_uniform"), 1 / 8, 12),
        (row("one_ray", "rays_uniform"), 0, 0),  # the nearest alone
        (row("one_triangle", items=1.0), 1, 0),  # whole bytes
        (row("one_triangle", items=9.0), 2 / 9, 0),
        (row("grid", "grid_80x50", items=32.0), 500, 0),
        (row("grid", "grid_9x3", items=32.0), 6, 0),  # a row begins with a byte
        (row("grid", "own_scene"), 0, 0),  # of a size not known
        (row("one_triangle", "grid_points_80x50", items=4000.0), 1 / 8, 0),
    ],
)
def test_bytes_written_for_an_item(
    written: dict[str, Any], bits: float, numbers: float
) -> None:
    assert bits_written(written) == bits
    assert numbers_written(written) == numbers


def test_the_size_of_a_grid_is_in_the_name_of_its_scene() -> None:
    assert grid_size("grid_80x50") == grid_size("grid_points_80x50") == (80, 50)
    assert grid_size("uniform") == (0, 0)


# A vector of 64 bytes a cycle on avx512, of 32 on avx2.
def test_bits_are_stored_at_the_highest_rate_and_numbers_at_that_of_the_isa(
    machine: Limits,  # noqa: F811
) -> None:
    assert store_ns(row("grid", "grid_80x50"), machine) == pytest.approx(500 / 64 / GHZ)
    both = store_ns(row("pairs_weights"), machine)
    assert both == pytest.approx((12 / 32 + 1 / 8 / 64) / GHZ)


def test_a_grid_is_bound_by_the_bits_it_writes(machine: Limits) -> None:  # noqa: F811
    grid = cell(ns=10.0).assign(
        loop="grid",
        family="grid_80x50",
        scene="grid_80x50:sets=fresh",
        scalar="i32",
        items=32.0,
        bytes_per_item=24.0,
    )
    found = dict(with_bounds(grid, machine, no_operations()).iloc[0])
    assert found["bound_ns"] == found["store_ns"] == pytest.approx(500 / 64 / GHZ)
    assert found["bound_of"] == STORES and found["bound_by"] == "memory"
    assert found["of_limit"] == pytest.approx(found["bound_ns"] / 10.0)
    assert bound_words(found) == "stores, memory alone"


def test_one_bit_does_not_outlast_the_loads_of_its_point(
    machine: Limits,  # noqa: F811
) -> None:
    found = with_bounds(cell(), machine, no_operations()).iloc[0]
    assert 0 < found["store_ns"] < found["memory_ns"]
    assert found["bound_of"] == "L1"


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_run(tmp_path_factory.mktemp("written") / "run")


def test_the_table_of_the_grid_has_the_bound_of_a_triangle(folder: Path) -> None:
    run = load_run(folder)
    cells = with_bounds(speed_cells(run.speed), run.limits, run.operations)
    table = grid_tables.published_scene(run.speed, cells, {})
    by_name = cells.set_index("name")
    for _, shown in table.iterrows():
        own = by_name.loc[shown["name"]]
        items = 4000 if shown["track"] == "points" else 1
        assert shown["bound_ns"] == pytest.approx(own["bound_ns"] * items)
        assert shown["of_limit"] == pytest.approx(shown["bound_ns"] / shown["ns"])
    facts = grid_tables.grid_bound_facts(table)
    assert "row_spans" in facts["uncounted"] and "byte_pairs" in facts["uncounted"]
    assert "avx2" in facts["understated"] and "avx512" not in facts["understated"]


def test_the_page_shows_it_and_says_what_it_leaves_out(folder: Path) -> None:
    report = build(load_run(folder))
    grid = report.exhibits.get("grid")
    assert grid is not None
    assert {"bound, ns", "% of limit"} <= {column.title for column in grid.columns}
    page = render(report, "index.html.j2")
    assert "their bound is no more than the time of their loads or stores" in page
    assert "the bound is lower than it could be" in page
    cells = report.exhibits.get("cells")
    assert (
        cells is not None and "the share of the limit is understated" in cells.caption
    )


def test_the_chapter_says_where_the_share_is_understated(folder: Path) -> None:
    run = load_run(folder)
    bounded = with_bounds(speed_cells(run.speed), run.limits, run.operations)
    for isa, counted in (("avx512", True), ("avx2", False)):
        cells = bounded[(bounded["isa"] == isa) & (bounded["loop"] == "one_triangle")]
        facts = limit_facts(run, cells, "f32", "one_triangle")
        assert facts is not None and facts["counted_for_it"] == counted
    assert limit_exhibits.understated(cells) and not limit_exhibits.understated(
        cells.assign(isa="avx512")
    )


def test_without_limits_there_is_no_bound_to_speak_of(folder: Path) -> None:
    run = load_run(folder)
    table = grid_tables.published_scene(run.speed, speed_cells(run.speed), {})
    assert "bound_ns" not in table
    assert not any(grid_tables.grid_bound_facts(table).values())
    assert not any(grid_tables.grid_bound_facts(pd.DataFrame()).values())
