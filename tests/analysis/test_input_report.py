"""The chapter on what the input does, of the synthetic run."""

from __future__ import annotations

from pathlib import Path

from analysis.read.load import load_run
from analysis.report.page import render
from analysis.report.report import Report, build
from analysis.speed.input_exhibits import input_facts
from tests.analysis.synthetic import Options, write_run


def test_the_chapter_stands_in_the_page_with_its_exhibits(
    report: Report, page: Path
) -> None:
    html = page.read_text()
    assert '<section id="input">' in html and 'href="#input"' in html
    for key in (
        "input-hit-f32",
        "early_out",
        "input-size-f32",
        "break_even",
        "threads",
    ):
        assert report.exhibits.get(key) is not None, key
        assert f'id="{key}"' in html, key


def test_the_verdicts_are_those_of_the_data(report: Report) -> None:
    verdicts = [claim.verdict for claim in report.input.claims]
    assert verdicts == ["holds", "holds", "holds with a condition"]
    html = render(report, "index.html.j2")
    for claim in report.input.claims:
        assert f"<strong>{claim.verdict}</strong>" in html


def test_the_title_of_a_chart_says_from_where_on_the_inverse_pays(
    report: Report,
) -> None:
    # 60 ns of set-up against 6, 1.7 ns a point against 1.9: 270 points.
    exhibit = report.exhibits.get("input-size-f32")
    assert exhibit is not None and exhibit.chart is not None
    row = report.input.evens.set_index(["isa", "method", "against"]).loc[
        ("scalar", "barycentric_inverse", "cross_product")
    ]
    assert row["break_even_low"] < 270 < row["break_even_high"]
    assert row["break_even_low"] <= 256 and row["break_even_high"] == 4096
    assert f"from {row['words']} points a call on scalar" in exhibit.chart.title


def test_what_is_not_in_a_run_is_not_in_its_report(tmp_path: Path) -> None:
    options = Options(
        methods=("cross_product", "edge_function"),
        isas=("scalar", "avx2"),
        scalars=("f32",),
        small=True,
    )
    report = build(load_run(write_run(tmp_path / "old", options)))
    assert input_facts(report.input) is None
    assert '<section id="input">' not in render(report, "index.html.j2")


def test_sweeps_are_no_comparison_of_methods(report: Report) -> None:
    assert not report.cells["scene"].str.contains(":n=").any()
    assert not report.cells["name"].str.contains("/threads:").any()
    assert report.timed["name"].str.contains("/threads:2").any()
    assert report.scene == "uniform:hit=50:bytes=24k:sets=fresh"
