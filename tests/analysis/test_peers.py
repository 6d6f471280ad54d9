"""Other libraries in a run: parted from the kernels, compared, drawn."""

from __future__ import annotations

import copy
import dataclasses
import json
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.peers.peers_tables import part, remarks
from analysis.read.load import load_run
from analysis.read.run import MethodEntry, Run
from analysis.report.page import write_page
from analysis.report.report import Report, build
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run

SLOWER = 20.0  # than cross_product on avx2
CALLS = {
    "geos_indexed": "locate(Coordinate)",
    "cgal_exact": "bounded_side(point)",
}


def with_peers(folder: Path) -> Path:
    """A small run in which the calls were measured too: cross_product on avx2
    again, slower; geos_indexed errs as it does, cgal_exact never."""
    for path in sorted(folder.glob("speed-*.json")):
        document = json.loads(path.read_text())
        document["benchmarks"] += [
            peer_row(row, call)
            for row in document["benchmarks"]
            if row["name"].endswith("/cross_product/f32/avx2")
            for call in CALLS
        ]
        path.write_text(json.dumps(document))
    for path in sorted(folder.glob("accuracy-*.json")):
        document = json.loads(path.read_text())
        document["cells"] += [
            peer_cell(cell, call)
            for cell in document["cells"]
            if cell["name"].endswith("/cross_product/f32/avx2")
            for call in CALLS
        ]
        path.write_text(json.dumps(document))
    catalogue = json.loads((folder / "methods.json").read_text())
    for call, words in CALLS.items():
        entry = catalogue["methods"][0] | {"key": call, "formula": words}
        entry["source"] = call.partition("_")[0].upper()
        catalogue["methods"].append(entry)
    catalogue["methods"][-1]["finite_only"] = True
    (folder / "methods.json").write_text(json.dumps(catalogue))
    machine = json.loads((folder / "machine.json").read_text())
    machine["libraries"] |= {"geos": "3.11.1", "cgal": "5.5.1"}
    machine["compiler"]["flags"]["peers/geos.cc"] = {
        "library": "-DX -O3 -O3 -Wall -fPEER"
    }
    (folder / "machine.json").write_text(json.dumps(machine))
    return folder


def peer_row(row: dict[str, Any], call: str) -> dict[str, Any]:
    name = row["name"].replace("/cross_product/f32/avx2", f"/{call}/f32/library")
    slower = {"real_time": row["real_time"] * SLOWER}
    slower["items_per_second"] = row["items_per_second"] / SLOWER
    return row | slower | {"name": name, "run_name": name}


def peer_cell(cell: dict[str, Any], call: str) -> dict[str, Any]:
    found = copy.deepcopy(cell)
    found["name"] = found["name"].replace(
        "/cross_product/f32/avx2", f"/{call}/f32/library"
    )
    found |= {"method": call, "isa": "library", "degenerate": 0}
    found["exterior"] += cell["degenerate"]
    if call == "cgal_exact":
        for kind in ("false_inside", "false_outside"):
            found["classes"][kind] |= {"count": 0, "distance_ulps": None, "worst": []}
    return found


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return with_peers(write_run(tmp_path_factory.mktemp("peers"), TWO_METHODS))


@pytest.fixture(scope="module")
def run(folder: Path) -> Run:
    return load_run(folder)


@pytest.fixture(scope="module")
def report(run: Run) -> Report:
    return build(run)


def test_no_row_is_lost_or_in_both_parts(run: Run) -> None:
    parted = part(run)
    assert parted.timed
    for name in ("speed", "refused", "accuracy", "worst"):
        whole, ours, peers = (
            getattr(r, name) for r in (run, parted.ours, parted.peers)
        )
        assert len(whole) == len(ours) + len(peers)
        assert "library" not in set(ours["isa"])
        assert set(peers["isa"]) <= {"library"}
    assert {m.key for m in parted.peers.methods} == set(CALLS)
    assert {m.key for m in parted.ours.methods} == set(TWO_METHODS.methods)


def test_a_call_is_compared_with_the_fastest_kernel_of_its_shard(
    report: Report,
) -> None:
    row = report.peers.set_index("method").loc["geos_indexed"]
    ours = report.cells[report.cells["scene"] == row["scene"]]
    best = ours.loc[ours["ns"].idxmin()]
    assert best["method"] != "cross_product"
    assert row["times_best_kernel"] == f"{best['method']} on {best['isa']}"
    assert row["times_best"] == pytest.approx(row["ns"] / best["ns"], rel=0.02)
    assert row["times_best_low"] <= row["times_best"] <= row["times_best_high"]
    assert row["times_exact"] != row["times_exact"]  # the run has no exact kernel


def test_a_kernel_kept_as_a_warning_is_no_rival(run: Run) -> None:
    warned = tuple(
        (
            dataclasses.replace(m, warning="may call NaN inside")
            if m.key == "edge_function"
            else m
        )
        for m in run.methods
    )
    table = build(dataclasses.replace(run, methods=warned)).peers
    assert set(table["times_best_kernel"]) == {"cross_product on avx2"}
    assert table["times_best"].between(0.99 * SLOWER, 1.01 * SLOWER).all()


def test_library_version_call_and_errors_come_from_the_run(report: Report) -> None:
    table = report.peers.set_index("method")
    assert table.loc["geos_indexed", ["library", "version", "called"]].tolist() == [
        "GEOS",
        "3.11.1",
        "locate(Coordinate)",
    ]
    assert table.loc["geos_indexed", "near_edge"] > 0
    assert table.loc["cgal_exact", "near_edge"] == 0
    assert "not asked about NaN and ∞" in table.loc["cgal_exact", "remarks"]


def test_scenes_with_degenerate_triangles_do_not_count_as_errors(run: Run) -> None:
    everywhere = run.accuracy.assign(degenerate=20)
    table = build(dataclasses.replace(run, accuracy=everywhere)).peers
    assert table["near_edge"].isna().all()


def test_the_grid_counts_its_few_degenerate_triangles(run: Run) -> None:
    call = {"method": "geos_indexed", "isa": "library"}
    grid = {"loop": "grid", "scene": "grid_80x50:sets=fresh", "family": "grid_80x50"}
    ours = run.accuracy[run.accuracy["isa"] == "avx2"].head(1)
    added = pd.concat([run.accuracy, ours.assign(**call, **grid, degenerate=20)])
    table = build(dataclasses.replace(run, accuracy=added)).peers
    assert table.set_index("method").loc["geos_indexed", "grid"] > 0


def test_everything_but_their_section_is_as_without_them(
    report: Report, small_run: Path
) -> None:
    alone = build(load_run(small_run))
    pd.testing.assert_frame_equal(report.verdicts, alone.verdicts)
    pd.testing.assert_frame_equal(report.cells, alone.cells)
    assert report.isa == alone.isa
    assert report.advice == alone.advice


def test_they_stand_in_the_hero_chart_off_the_frontier(report: Report) -> None:
    hero = report.exhibits.get("hero-f32")
    marks = hero.csv[hero.csv["isa"] == "library"]
    assert set(marks["method"]) == set(CALLS)
    assert not marks["on_frontier"].any()
    assert all(call in hero.chart.svg for call in CALLS)
    assert "library" in hero.chart.svg
    assert "diamonds" in hero.caption


def test_the_page_has_their_section_only_with_them(
    report: Report, small_run: Path, tmp_path: Path
) -> None:
    text = write_page(report, tmp_path / "with").read_text()
    assert 'id="peers"' in text
    assert "GEOS 3.11.1" in text
    assert "<code>-O3 -fPEER</code>" in text
    alone = write_page(build(load_run(small_run)), tmp_path / "without").read_text()
    assert 'id="peers"' not in alone
    assert 'href="#peers"' not in alone


def entry(finite_only: bool) -> MethodEntry:
    return MethodEntry(
        "geos_x", "GEOS", "", "closed", "triangle", False, False, "", finite_only
    )


def test_remarks_say_what_the_classes_show(run: Run) -> None:
    cells = part(run).peers.accuracy
    cells = cells[cells["method"] == "geos_indexed"].assign(
        boundary_accepted=60, boundary_accepted_of=80, hole=1, hole_of=50
    )
    text = remarks(cells, entry(False))
    assert "boundary rule broken: 25.0 %" in text.replace("\u202f", " ").replace(
        "\xa0", " "
    )
    assert "holes: 2.00 %" in text.replace("\u202f", " ").replace("\xa0", " ")
    assert "not asked" not in text
    assert "not asked" in remarks(cells, entry(True))
