"""Bounds are what hand-worked examples say, and a beaten one is called wrong."""

from __future__ import annotations

import dataclasses
import json
import math
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.read.fields import SameRun
from analysis.read.limits import Limits, includes
from analysis.read.load import LoadError, load_run
from analysis.read.load_limits import load_limits
from analysis.read.load_operations import load_operations, no_operations
from analysis.read.run import Run
from analysis.speed.bounds import ALL, COLUMNS, beaten, with_bounds
from analysis.speed.limit_columns import bound_words, of_limit_words
from analysis.speed.limit_prose import limit_facts
from analysis.speed.limit_tables import (
    at_the_widest,
    bandwidths,
    rates,
    with_instructions,
    with_throughput,
)
from analysis.speed.roofline import marks, roofs
from analysis.speed.tables import speed_cells
from tests.analysis import synthetic
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic_limits import GHZ, limits as limits_document
from tests.analysis.synthetic_limits import operations as operations_document
from tests.analysis.test_tables import name, speed_frame

CONTEXT = {
    "profile": "quick",
    "filter": ".",
    "revision": synthetic.REVISION,
    "dirty": False,
    "seed": synthetic.SEED,
}
ISAS = tuple(synthetic.ISA_SPEED)


def same_run(folder: Path) -> SameRun:
    return SameRun(folder / "machine.json", CONTEXT)


def loaded(folder: Path, document: dict[str, Any]) -> Limits:
    path = folder / "limits.json"
    path.write_text(json.dumps(document))
    found = load_limits(folder, same_run(folder))
    assert found is not None
    return found


@pytest.fixture
def machine(tmp_path: Path) -> Limits:
    return loaded(tmp_path, limits_document(CONTEXT, ISAS))


def counts(folder: Path, **per_item: float) -> pd.DataFrame:
    """Operations of edge_function, f32, one_triangle; nothing a call."""
    document = operations_document(CONTEXT, ("edge_function",), ("f32",))
    row = document["rows"][0]
    row["per_call"] = dict.fromkeys(row["per_call"], 0)
    row["per_item"] = {kind: per_item.get(kind, 0) for kind in row["per_item"]}
    document["rows"] = [row]
    path = folder / "operations.json"
    path.write_text(json.dumps(document))
    return load_operations(path, same_run(folder))


def cell(
    ns: float = 1.0, isa: str = "avx512", size: float = 20000, scene_bytes: float = 0
) -> pd.DataFrame:
    """One cell of edge_function in one_triangle: 1000 points of 8 bytes."""
    frame = speed_frame({name("edge_function", isa): [ns] * 9})
    frame = frame.assign(items=1000.0, bytes_per_item=8.0, working_set_bytes=size)
    return speed_cells(frame.assign(scene_bytes=scene_bytes or math.nan))


def bound(
    cells: pd.DataFrame, machine: Limits, operations: pd.DataFrame
) -> dict[str, Any]:
    return dict(with_bounds(cells, machine, operations).iloc[0])


# 8 bytes of vectors of 64 at two, one, a half, an eighth a cycle.
@pytest.mark.parametrize(
    ("size", "cycles"),
    [(1000, 1 / 16), (100_000, 1 / 8), (4_000_000, 1 / 4), (1e9, 1.0)],
)
def test_memory_time_is_bytes_over_the_bandwidth_of_the_level(
    machine: Limits, size: float, cycles: float
) -> None:
    row = bound(cell(size=size), machine, no_operations())
    assert row["memory_ns"] == pytest.approx(cycles / GHZ)
    assert row["bound_ns"] == row["memory_ns"]
    assert row["of_limit"] == pytest.approx(cycles / GHZ / 1.0)


def test_a_scene_that_rotates_lies_where_all_of_it_fits(machine: Limits) -> None:
    assert bound(cell(size=4096), machine, no_operations())["level"] == "L1"
    rotating = cell(size=4096, scene_bytes=262144)
    assert bound(rotating, machine, no_operations())["level"] == "L2"


def test_without_counts_a_row_has_the_bound_of_memory_and_says_so(
    machine: Limits,
) -> None:
    row = bound(cell(), machine, no_operations())
    assert math.isnan(row["compute_ns"])
    assert bound_words(row) == "L1, memory alone"


# 16 lanes, two of each kind a cycle, four operations in all.
@pytest.mark.parametrize(
    ("per_item", "cycles", "kind"),
    [
        ({"multiply_add": 6}, 6 / 32, "multiply_add"),
        ({"multiply_add": 6, "compare": 3}, 6 / 32, "multiply_add"),
        ({"multiply": 6, "add": 6, "compare": 3}, 15 / 64, ALL),
        ({"divide": 1}, 1 / 3.2, "divide"),
        ({"min_max": 3, "add": 1}, 3 / 32, "min_max"),
        ({"multiply": 4, "multiply_add": 3}, 7 / 32, "multiply_multiply_add"),
        ({"logic": 1000, "load": 1000, "store": 1000, "add": 4}, 4 / 32, "add"),
        # Minima of integers have units of their own on some CPUs.
        ({"integer_min_max": 1000, "add": 4}, 4 / 32, "add"),
    ],
)
def test_compute_time_is_the_longest_of_each_kind_and_of_all(
    machine: Limits,
    tmp_path: Path,
    per_item: dict[str, float],
    cycles: float,
    kind: str,
) -> None:
    row = bound(cell(), machine, counts(tmp_path, **per_item))
    assert row["compute_ns"] == pytest.approx(cycles / GHZ)
    assert (row["bound_by"], row["bound_of"]) == ("compute", kind)
    assert row["bound_ns"] == row["compute_ns"]


def test_kinds_that_share_units_are_bound_together(tmp_path: Path) -> None:
    document = limits_document(CONTEXT, ISAS)
    for row in document["operations"]:
        if row["operation"] == "add_min_max_compare":
            row["operations_per_second"] /= 2  # no more than additions alone
    sharing = loaded(tmp_path, document)
    table = counts(tmp_path, multiply=6, add=6, compare=3)
    row = bound(cell(), sharing, table)
    assert row["compute_ns"] == pytest.approx(9 / 32 / GHZ)
    assert row["bound_of"] == "add_min_max_compare"
    assert bound_words(row) == "add, min and compare"
    # What is converted may be added as integers, in whatever units do that.
    whole = counts(tmp_path, add=6, compare=3, convert=1, integer_multiply=1)
    assert bound(cell(), sharing, whole)["bound_of"] != "add_min_max_compare"


def test_together_no_slower_than_one_of_them_alone(tmp_path: Path) -> None:
    document = limits_document(CONTEXT, ISAS)
    for row in document["operations"]:
        if row["operation"] == "add_min_max_compare":
            row["operations_per_second"] /= 8  # disturbed
    row = bound(cell(), loaded(tmp_path, document), counts(tmp_path, add=6, compare=3))
    assert row["compute_ns"] == pytest.approx(9 / 32 / GHZ)


def test_the_longer_of_memory_and_compute_bounds(
    machine: Limits, tmp_path: Path
) -> None:
    few = counts(tmp_path, add=1)  # 1/32 cycle, and 1/16 for the bytes
    row = bound(cell(), machine, few)
    assert (row["bound_by"], row["bound_of"]) == ("memory", "L1")
    assert bound_words(row) == "L1"
    assert row["bound_ns"] == pytest.approx(1 / 16 / GHZ)


def test_what_a_call_does_is_spread_over_its_items(
    machine: Limits, tmp_path: Path
) -> None:
    table = counts(tmp_path, add=6)
    table.loc[table["per"] == "call", "add"] = 2000.0  # two a point of a thousand
    row = bound(cell(), machine, table)
    assert row["compute_ns"] == pytest.approx(8 / 32 / GHZ)


def test_a_method_that_converts_is_bound_by_the_fastest_type(
    machine: Limits, tmp_path: Path
) -> None:
    whole = counts(tmp_path, add=64, convert=1, integer_multiply=1)
    row = bound(cell(), machine, whole)  # bytes: 64 lanes, two a cycle
    assert row["compute_ns"] == pytest.approx(64 / 128 / GHZ, rel=0.05)
    floats = counts(tmp_path, add=64, convert=1)
    assert bound(cell(), machine, floats)["compute_ns"] == pytest.approx(2 / GHZ)


def test_each_isa_has_its_own_bound_and_a_plain_loop_that_of_its_width(
    machine: Limits, tmp_path: Path
) -> None:
    table = counts(tmp_path, add=6)
    cycles = {"scalar": 3.0, "sse4": 3 / 4, "avx2": 3 / 8, "autovec_v3": 3 / 8}
    for isa, expected in cycles.items():
        row = bound(cell(isa=isa), machine, table)
        assert row["compute_ns"] == pytest.approx(expected / GHZ), isa


def test_a_wide_isa_can_do_what_a_narrower_one_does(tmp_path: Path) -> None:
    document = limits_document(CONTEXT, ISAS)
    for row in document["operations"]:
        if row["isa"] == "avx512":
            row["operations_per_second"] /= 10
    slow = loaded(tmp_path, document)
    assert slow.rate("avx512", "f32", "add") == slow.rate("avx2", "f32", "add")
    assert includes("sve") == ("scalar", "neon", "sve")
    assert "avx2" not in includes("sse4")


def test_near_memory_is_no_slower_than_far_memory(tmp_path: Path) -> None:
    document = limits_document(CONTEXT, ISAS)
    for row in document["memory"]:
        if row["level"] == "L1":
            row["bytes_per_second"] /= 100
    odd = loaded(tmp_path, document)
    assert odd.bandwidth("avx2", "f32", "L1") == odd.bandwidth("avx2", "f32", "L2")


def test_the_best_number_of_streams_counts(machine: Limits) -> None:
    expected = GHZ * 1e9 * 64 * 2
    assert machine.bandwidth("avx512", "f64", "L1") == pytest.approx(expected)


# 6 additions on 16 lanes, two a cycle: 0.0536 ns.
@pytest.mark.parametrize(
    ("ns", "wrong"), [(0.06, False), (0.0536, False), (0.0525, False), (0.05, True)]
)
def test_a_bound_that_is_beaten_beyond_noise_is_wrong(
    machine: Limits, tmp_path: Path, ns: float, wrong: bool
) -> None:
    cells = with_bounds(cell(ns=ns), machine, counts(tmp_path, add=6))
    assert list(cells["beaten"]) == [wrong]
    assert len(beaten(cells)) == wrong
    assert ("bound beaten" in of_limit_words(dict(cells.iloc[0]))) == wrong


def test_an_interval_that_reaches_the_bound_beats_nothing(
    machine: Limits, tmp_path: Path
) -> None:
    frame = speed_frame({name("edge_function", "avx512"): [0.04] * 5 + [0.055] * 4})
    frame = frame.assign(items=1000.0, bytes_per_item=8.0, working_set_bytes=1000.0)
    cells = with_bounds(speed_cells(frame), machine, counts(tmp_path, add=6))
    assert cells["of_limit"].iloc[0] > 1.3
    assert not cells["beaten"].iloc[0]


def test_without_limits_cells_stay_as_they_are() -> None:
    cells = cell()
    assert list(with_bounds(cells, None, no_operations())) == list(cells)
    assert not len(beaten(cells))


def test_tables_show_each_isa_once(machine: Limits) -> None:
    table = rates(machine).set_index(["isa", "scalar"])
    assert table.loc[("avx2", "f64"), "multiply_add"] == pytest.approx(GHZ * 8e9)
    assert math.isnan(table.loc[("sse4", "f32"), "multiply_add"])
    walks = bandwidths(machine)
    assert list(walks["isa"]) == ["scalar"] * 5 + ["ssse3", "sse4", "avx2", "avx512"]
    assert walks["load_L2_below"].iloc[-1] == pytest.approx(0.03)


def test_roofs_that_add_nothing_are_left_out(machine: Limits) -> None:
    assert [isa for isa, _ in roofs(machine, "f32")] == [
        "scalar",
        "ssse3",
        "avx2",
        "avx512",
    ]


def test_a_mark_stands_at_its_operations_a_byte(
    machine: Limits, tmp_path: Path
) -> None:
    cells = with_bounds(cell(ns=0.1), machine, counts(tmp_path, add=6, compare=2))
    mark = marks(cells, "f32").iloc[0]
    assert mark["intensity"] == 1.0  # 8 operations on 8 bytes
    assert mark["operations_per_second"] == pytest.approx(80e9)
    assert len(marks(with_bounds(cell(), machine, no_operations()), "f32")) == 0


def test_a_run_without_limits_or_counts_still_loads(tmp_path: Path) -> None:
    old = dataclasses.replace(TWO_METHODS, limits_json=False, operations_json=False)
    run = load_run(synthetic.write_run(tmp_path / "old", old))
    assert run.limits is None
    assert not len(run.operations)
    assert not len(at_the_widest(speed_cells(run.speed)))


def test_older_speed_files_tell_no_throughput(small_run: Path) -> None:
    path = next(small_run.glob("speed-*.json"))
    document = json.loads(path.read_text())
    for key in ("throughput_before_gops", "throughput_after_gops"):
        del document["context"]["pitbench"][key]
    for row in document["benchmarks"]:
        del row["scene_bytes"]
    path.write_text(json.dumps(document))
    run = load_run(small_run)
    assert math.isnan(run.shards[0].throughput_before_gops)
    assert run.speed["scene_bytes"].isna().all()


def test_instructions_are_shown_a_cycle_where_the_loop_repeats(small_run: Path) -> None:
    run = load_run(small_run)
    shard = run.shards[0]
    cells = speed_cells(run.speed).head(2).assign(shard=shard.name, ns=2.0, items=100)
    traced = pd.DataFrame(
        [{key: cells.iloc[0][key] for key in ("method", "scalar", "loop", "isa")}]
    ).assign(per_item=12.0, per_call=50.0, items_per_iteration=8)
    table = with_instructions(cells, traced, run.shards)
    assert table["instructions"].iloc[0] == 12.5
    per_cycle = table["instructions_per_cycle"]
    assert per_cycle.iloc[0] == pytest.approx(12.5 / 2.0 / shard.clock_ghz)
    assert math.isnan(per_cycle.iloc[1])
    leaves_early = traced.assign(items_per_iteration=0)
    unknown = with_instructions(cells, leaves_early, run.shards)
    assert unknown["instructions_per_cycle"].isna().all()


def test_the_fastest_is_told_with_the_instructions_of_its_loop(
    small_run: Path,
) -> None:
    def facts(run: Run) -> dict[str, Any]:
        cells = with_bounds(speed_cells(run.speed), run.limits, run.operations)
        found = limit_facts(run, cells, "f32", "one_triangle")
        assert found is not None and found["fastest"] is not None
        return dict(found["fastest"])

    run = load_run(small_run)
    told = facts(run)
    doubled = run.instructions.assign(
        per_item=2 * run.instructions["per_item"],
        per_call=2 * run.instructions["per_call"],
    )
    twice = facts(dataclasses.replace(run, instructions=doubled))
    assert float(twice["per_cycle"]) == pytest.approx(
        2 * float(told["per_cycle"]), 0.01
    )
    untraced = facts(dataclasses.replace(run, instructions=run.instructions.iloc[:0]))
    assert untraced["per_cycle"] == untraced["instructions"] == ""


def test_throughput_is_shown_a_cycle_and_as_a_change(small_run: Path) -> None:
    run = load_run(small_run)
    shards = pd.DataFrame({"shard": [run.shards[0].name, "another"]})
    table = with_throughput(shards, run.shards)
    assert table["per_cycle_before"].iloc[0] == 6.0
    # The clock fell with it: 20.9 / 3.49 against 21 / 3.5.
    assert table["throughput_change"].iloc[0] == pytest.approx(-0.0019, abs=1e-4)
    assert math.isnan(table["per_cycle_before"].iloc[1])


def _twice(document: dict[str, Any]) -> None:
    document["operations"].append(document["operations"][0])


def _unknown_level(document: dict[str, Any]) -> None:
    document["levels"] = document["levels"][:1] + document["levels"][2:]


def _shrinking(document: dict[str, Any]) -> None:
    document["levels"][1]["capacity_bytes"] = 1000


def _other_revision(document: dict[str, Any]) -> None:
    document["context"]["revision"] = "another"


def _no_speed(document: dict[str, Any]) -> None:
    document["memory"][3]["bytes_per_second"] = 0


@pytest.mark.parametrize(
    ("spoil", "field"),
    [
        (_twice, r"\$\.operations\[\d+\]: the limit is there twice"),
        (_unknown_level, r"\$\.memory\[\d+\]\.level: L2 is not in"),
        (_shrinking, r"\$\.levels\[1\]\.capacity_bytes: L2 is no larger than L1"),
        (_other_revision, r"\$\.context\.revision: is 'another'"),
        (_no_speed, r"\$\.memory\[3\]\.bytes_per_second"),
    ],
)
def test_a_spoilt_file_is_refused_by_file_and_field(
    tmp_path: Path, spoil: Any, field: str
) -> None:
    document = limits_document(CONTEXT, ISAS)
    spoil(document)
    with pytest.raises(LoadError, match=rf"limits\.json: {field}"):
        loaded(tmp_path, document)


def test_the_columns_are_all_there(machine: Limits) -> None:
    assert set(COLUMNS) <= set(with_bounds(cell(), machine, no_operations()))


def test_operations_that_may_be_skipped_bound_nothing(
    machine: Limits, tmp_path: Path
) -> None:
    many = counts(tmp_path, multiply_add=600)
    leaving = cell().assign(method="edge_function_early_out")
    counted = many.assign(method="edge_function_early_out")
    row = bound(leaving, machine, counted)
    assert math.isnan(row["compute_ns"])
    assert row["bound_by"] == "memory"


def test_the_limits_of_one_cpu_say_nothing_of_several(
    machine: Limits, tmp_path: Path
) -> None:
    two = cell(ns=1e-9).assign(threads=2)
    row = bound(two, machine, counts(tmp_path, add=1))
    assert math.isnan(row["of_limit"]) and not row["beaten"]
