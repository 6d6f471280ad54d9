"""The chapter that compares CPUs: what it says follows its runs."""

from __future__ import annotations

import dataclasses
import functools
import re
from pathlib import Path

import pandas as pd
import pytest

from analysis.cpus import cpus_exhibits, cpus_tables
from analysis.cpus.cpus_chart import cpus_chart
from analysis.cpus.run_labels import ROOT
from analysis.cpus.stored_run import RUNS, load_stored, stored_names
from analysis.read.kernel_hash import kernel_hash
from analysis.read.load import load_run
from analysis.read.run import Run
from analysis.report.exhibits import Exhibits
from analysis.report.page import render
from analysis.report.report import build
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import Options, write_run

SMALL = dataclasses.replace(TWO_METHODS, profile="quick", kernel_hash="ab" * 32)
BOTH_TWICE = (("cross_product", 2.0), ("edge_function", 2.0))


def run_of(folder: Path, label: str = "", **changes: object) -> Run:
    options = dataclasses.replace(SMALL, **changes)  # type: ignore[arg-type]
    return dataclasses.replace(load_run(write_run(folder, options)), label=label)


@pytest.fixture(scope="module")
def own(tmp_path_factory: pytest.TempPathFactory) -> Run:
    return run_of(tmp_path_factory.mktemp("cpus") / "own")


@pytest.fixture(scope="module")
def slow(tmp_path_factory: pytest.TempPathFactory) -> Run:
    """Takes twice the time, on a CPU without AVX2."""
    folder = tmp_path_factory.mktemp("cpus") / "slow"
    return run_of(
        folder, "Slow CPU", chance=5, isas=("scalar",), speed_factor=BOTH_TWICE
    )


def chapter(run: Run, stored: list[Run]) -> str:
    page = render(build(run, stored), "index.html.j2")
    found = re.search(r'<section id="cpus">.*?</section>', page, re.DOTALL)
    assert found
    return found.group(0)


def test_without_a_stored_run_the_chapter_says_so(own: Run) -> None:
    text = chapter(own, [])
    assert "nothing to compare with yet" in text
    assert "machines add" in text and "<table" not in text and "<svg" not in text


def test_the_run_itself_is_nothing_to_compare_with(own: Run) -> None:
    assert "nothing to compare with yet" in chapter(own, [own])


def test_another_run_is_set_beside_it(own: Run, slow: Run) -> None:
    text = chapter(own, [slow])
    assert "1 run is set beside this one" in text
    said = re.search(
        r"Slow CPU: on <code>(\w+)</code> the median method takes (\S+)", text
    )
    assert (
        said and said.group(1) == "scalar" and said.group(2).startswith(("2.0", "1.9"))
    )
    assert 'id="cpus-isas"' in text and 'id="cpus-methods"' in text
    assert "every count is the same" in text


def test_ratios_and_cycles_follow_the_data(own: Run, slow: Run) -> None:
    found = cpus_tables.cpus(own, [slow], "f32")
    isas = cpus_tables.isa_table(found).set_index(["isa", "run"])
    row = isas.loc["scalar", "Slow CPU"]
    assert row["ratio"] == pytest.approx(2, rel=0.02)
    assert row["ratio_low"] <= row["ratio"] <= row["ratio_high"]
    # The same clock: twice the time is twice the cycles, and half of the limit.
    assert row["cycles_ratio"] == pytest.approx(2, rel=0.02)
    own_row = isas.loc["scalar", cpus_tables.HERE]
    assert row["of_limit"] == pytest.approx(own_row["of_limit"] / 2, rel=0.05)
    assert ("avx2", "Slow CPU") not in isas.index
    methods = cpus_tables.method_table(found)
    theirs = methods[methods["run"] == "Slow CPU"]
    assert set(theirs["isa"]) == {"scalar"}
    # Each on its widest: twice the time, on an ISA that is 11 times as slow,
    # and four times as slow with the branches of the scalar rows.
    assert theirs["ratio"].between(80, 95).all()


def test_a_higher_clock_is_no_more_work_in_a_cycle(own: Run, tmp_path: Path) -> None:
    half = tuple((method, 0.5) for method in SMALL.methods)
    fast = run_of(tmp_path / "fast", "Fast", chance=4, speed_factor=half)
    shards = tuple(
        dataclasses.replace(
            shard,
            clock_before_ghz=2 * shard.clock_before_ghz,
            clock_after_ghz=2 * shard.clock_after_ghz,
        )
        for shard in fast.shards
    )
    found = cpus_tables.cpus(own, [dataclasses.replace(fast, shards=shards)], "f32")
    isas = cpus_tables.isa_table(found).set_index(["isa", "run"])
    assert isas.loc["avx2", "Fast"]["ratio"] == pytest.approx(0.5, rel=0.02)
    assert isas.loc["avx2", "Fast"]["cycles_ratio"] == pytest.approx(1, rel=0.02)


def test_stale_and_other_kernels_are_marked(own: Run, tmp_path: Path) -> None:
    now = kernel_hash(ROOT)
    current = run_of(tmp_path / "current", "Now", chance=2, kernel_hash=now)
    text = chapter(current, [own])
    assert "Not of the kernels that this run measured" in text
    assert re.search(r"Stale, of other kernels than the code has now: \S", text)
    page = render(build(current), "index.html.j2")
    assert "<strong>Stale:</strong>" not in page
    assert "<strong>Stale:</strong>" in render(build(own), "index.html.j2")


def test_a_restricted_run_is_marked_on_its_page(tmp_path: Path) -> None:
    run = run_of(tmp_path / "run", isa_up_to="avx2")
    page = render(build(run), "index.html.j2")
    assert "<strong>Restricted:</strong>" in page and "--isa-up-to avx2" in page
    assert "ISAs up to avx2" in page


def test_other_answers_on_the_same_input_are_told(own: Run, tmp_path: Path) -> None:
    worse = (("edge_function", 1.5),)
    other = run_of(tmp_path / "b", "Other", chance=3, error_factor=worse)
    text = chapter(own, [other])
    assert re.search(r"counts differ on Other in \d+ of \d+ \(edge_function\)", text)


def test_two_runs_of_one_label_are_told_apart(own: Run, tmp_path: Path) -> None:
    runs = [run_of(tmp_path / f"r{k}", "Same", chance=k) for k in (1, 2)]
    names = [cpu.name for cpu in cpus_tables.cpus(own, runs, "f32")]
    assert names == [cpus_tables.HERE, "Same (r1)", "Same (r2)"]


def test_modelled_cpus_are_in_a_part_of_their_own(own: Run, slow: Run) -> None:
    rows = [
        {"method": m, "scalar": "f32", "loop": "one_triangle", "isa": "avx2"}
        | {"model": "znver3", "cycles": 1.0}
        for m in SMALL.methods
    ]
    modelled = dataclasses.replace(own, modelled=pd.DataFrame(rows))
    text = chapter(modelled, [slow])
    part = text[text.index("<h3>Modelled CPUs</h3>") :]
    assert "Nothing in this part was measured" in part and "znver3" in part
    assert "znver3" not in text[: text.index("<h3>Modelled CPUs</h3>")]
    assert "Modelled CPUs" not in chapter(own, [slow])


def test_the_chart_of_ten_runs_has_a_row_for_each_and_is_the_same_twice(
    own: Run, tmp_path: Path
) -> None:
    runs = [run_of(tmp_path / f"r{k}", f"CPU {k}", chance=k) for k in range(1, 10)]
    found = cpus_tables.cpus(own, runs, "f32")
    rows, isas = cpus_tables.with_cycles_ratio(found), cpus_tables.isa_table(found)
    first, second = (cpus_chart(rows, isas, "footer") for _ in range(2))
    assert (first.svg, first.png) == (second.svg, second.png)
    for k in range(1, 10):
        assert first.alt.count(f"CPU {k}:") == 2  # scalar and avx2


def test_exhibits_are_only_added_where_there_is_something(own: Run) -> None:
    exhibits = Exhibits()
    cpus_exhibits.add(exhibits, own, [], "f32", "footer")
    assert list(exhibits) == []


@functools.cache
def stored(name: str) -> Run:
    return load_stored(RUNS / name)


@pytest.mark.parametrize("name", stored_names())
def test_every_run_of_the_repository_fits_its_schema_and_is_small(name: str) -> None:
    run = stored(name)
    assert not run.machine.dirty and run.machine.revision != "unknown"
    files = [path for path in (RUNS / name).rglob("*") if path.is_file()]
    assert sum(path.stat().st_size for path in files) < 1.5e6


def test_the_report_over_all_runs_of_the_repository_builds(tmp_path: Path) -> None:
    own = load_run(write_run(tmp_path / "run", Options(kernel_hash="ab" * 32)))
    others = [stored(name) for name in stored_names()]
    text = chapter(own, others)
    assert ("nothing to compare with yet" in text) == (not others)
