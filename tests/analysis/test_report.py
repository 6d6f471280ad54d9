"""The report says what the data says, and says it the same way every time."""

from __future__ import annotations

import dataclasses
import html
import os
import re
import subprocess
import sys
from pathlib import Path

import pandas as pd
import pytest

from analysis.accuracy import failure_prose
from analysis.read.load import load_run
from analysis.report import prose
from analysis.report.page import render, write_page
from analysis.report.report import Report, build
from analysis.report.verdicts import advise
from analysis.report.wording import grouped
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import Options, write_run

FOUR = dataclasses.replace(
    TWO_METHODS,
    methods=(
        "cross_product",
        "edge_function",
        "uv_projection",
        "cross_solve_published",
    ),
)


def text_of(folder: Path, options: Options) -> str:
    """The words of the page of a run with these options."""
    report = build(load_run(write_run(folder, options)))
    page = render(report, "index.html.j2")
    body = re.sub(r"<(svg|style|script).*?</\1>", " ", page, flags=re.DOTALL)
    words = html.unescape(re.sub(r"<[^>]+>", " ", body)).replace("\u00a0", " ")
    return re.sub(r"\s+([.,;:)])", r"\1", re.sub(r"\s+", " ", words))


def test_the_prose_follows_the_data(tmp_path: Path) -> None:
    before = text_of(tmp_path / "a", FOUR)
    # As invented: edge_function is the fastest, cross_product the most right.
    assert "edge_function was the fastest" in before
    assert "cross_product erred least there" in before
    slower = dataclasses.replace(FOUR, speed_factor=(("edge_function", 3.0),))
    after = text_of(tmp_path / "b", slower)
    assert "cross_product was both the fastest" in after
    assert "edge_function was the fastest" not in after
    tied = dataclasses.replace(FOUR, speed_factor=(("cross_product", 1.6 / 1.9),))
    equal = text_of(tmp_path / "c", tied)
    assert "the fastest, at" in equal and "was the fastest, at" not in equal
    assert "among the fastest, at" in equal


def test_a_method_without_errors_is_said_to_make_none(tmp_path: Path) -> None:
    exact = dataclasses.replace(FOUR, error_factor=(("cross_product", 0.0),))
    assert "cross_product made no error there at all" in text_of(tmp_path / "a", exact)


def test_a_method_of_another_question_is_never_advised(tmp_path: Path) -> None:
    quick = dataclasses.replace(FOUR, speed_factor=(("cross_solve_published", 0.01),))
    report = build(load_run(write_run(tmp_path / "a", quick)))
    assert report.advice is not None
    assert report.advice.fastest == "edge_function"
    words = text_of(tmp_path / "b", quick)
    assert "cross_solve_published decides another question" in words


def test_a_formula_of_another_question_is_told_once(tmp_path: Path) -> None:
    report = build(load_run(write_run(tmp_path / "a", FOUR)))
    alone = report.verdicts.replace(
        "cross_solve_published", "cross_solve_published_fma"
    )
    both = pd.concat([report.verdicts, alone]).drop_duplicates("method")
    for table, told in (
        (both, ["cross_solve_published"]),
        (alone, ["cross_solve_published_fma"]),
    ):
        words = prose.facts(dataclasses.replace(report, verdicts=table))
        assert [method for method, _ in words["advice"]["not_whole"]] == told


def test_a_method_that_errs_on_everyday_points_is_never_advised(
    tmp_path: Path,
) -> None:
    run = load_run(write_run(tmp_path / "a", FOUR))
    evenly = run.accuracy.assign(
        family="uniform", scene="uniform:hit=50:bytes=24k:sets=fresh", false_outside=0
    )
    wrong = (evenly["method"] == "edge_function") * evenly["exterior"] // 100
    both = pd.concat([run.accuracy, evenly.assign(false_inside=wrong)])
    report = build(dataclasses.replace(run, accuracy=both))
    assert report.advice is not None
    assert report.advice.fastest == "cross_product"
    own = report.verdicts.set_index("method")
    assert own.loc["cross_product", "time_over_best"] == 1.0
    assert own.loc["edge_function", "time_over_best"] < 1.0
    page = render(report, "index.html.j2")
    page = html.unescape(page).replace("\u00a0", " ")
    assert "and err on no more than 100 in a million of points spread evenly" in page


def test_a_method_with_a_warning_is_never_advised(tmp_path: Path) -> None:
    run = load_run(write_run(tmp_path / "a", FOUR))
    warned = [
        dataclasses.replace(entry, warning="odd" * (entry.key == "edge_function"))
        for entry in run.methods
    ]
    report = build(dataclasses.replace(run, methods=tuple(warned)))
    assert report.advice is not None
    assert report.advice.fastest == "cross_product"


def test_each_verdict_names_what_is_better(tmp_path: Path) -> None:
    report = build(load_run(write_run(tmp_path / "a", FOUR)))
    said = dict(zip(report.verdicts["method"], report.verdicts["verdict"]))
    assert said["edge_function"] == "the fastest; whatever errs less takes longer"
    assert said["cross_product"] == "errs least; whatever is faster errs more"
    assert said["uv_projection"].startswith("cross_product is 1.3")


def test_a_tie_in_speed_is_said(tmp_path: Path) -> None:
    # 1.9 ns and 1.6 ns a point, made equal.
    tie = dataclasses.replace(FOUR, speed_factor=(("cross_product", 1.6 / 1.9),))
    report = build(load_run(write_run(tmp_path / "a", tie)))
    assert report.advice is not None
    assert {report.advice.fastest, *report.advice.as_fast} == {
        "cross_product",
        "edge_function",
    }


def test_none_of_a_tie_is_called_the_fastest(tmp_path: Path) -> None:
    tie = dataclasses.replace(FOUR, speed_factor=(("cross_product", 1.6 / 1.9),))
    report = build(load_run(write_run(tmp_path / "a", tie)))
    said = dict(zip(report.verdicts["method"], report.verdicts["verdict"]))
    assert not any("the fastest" in text for text in said.values())
    both = said["edge_function"] + said["cross_product"]
    assert "as fast as" in both or "takes as long" in both


def test_every_ratio_of_times_in_the_prose_has_its_interval(report: Report) -> None:
    page = html.unescape(render(report, "index.html.j2")).replace("\u00a0", " ")
    said = re.findall(r"<code>avx512</code>: [^<]*", page)
    assert len(re.findall(r"× \([0-9.]+ to [0-9.]+; ", said[0])) == 2
    assert re.search(r"takes [0-9.]+ × the time \([0-9.]+ to [0-9.]+\) of the", page)
    for verdict in report.verdicts["verdict"]:
        text = verdict.replace("\u00a0", " ")
        for after in re.findall(r"[0-9.]+ × as fast(.*)", text):
            assert re.match(r" \([0-9.]+ to [0-9.]+\)", after), text


def test_without_judged_answers_there_is_no_advice(report: Report) -> None:
    assert advise(report.verdicts.assign(error_rate=float("nan"))) is None


@pytest.mark.parametrize(
    ("options", "says"),
    [
        (FOUR, "This run is quiet."),
        (dataclasses.replace(FOUR, twin_ratio=1.2), "This run is noisy."),
        (
            dataclasses.replace(FOUR, clock_after=3.0),
            "the clock went from 3.50 to 3.00",
        ),
        (dataclasses.replace(FOUR, steal_percent=7.5), "took 7.5 % of the time"),
        (dataclasses.replace(FOUR, cpu_share=0.5), "had its CPU for 50.0 %"),
        (dataclasses.replace(FOUR, doubled_ratio=1.0), "a real difference is missed"),
        (FOUR, "1 of the intervals exclude 1"),
    ],
)
def test_noise_stands_at_the_top(tmp_path: Path, options: Options, says: str) -> None:
    words = text_of(tmp_path / "a", options)
    assert says in words[: words.index("What is being asked")]


def test_refused_cells_are_listed_with_their_reason(page: Path) -> None:
    text = page.read_text()
    assert "15 cells did not pass" in text
    assert "17 of 4096 answers differ from truth" in text


def test_the_command_of_every_shard_is_given(report: Report) -> None:
    text = html.unescape(render(report, "index.html.j2"))
    assert (
        "build/pitbench speed --profile quick --filter '^pairs/.*/f64/' "
        "--out speed-pairs-f64.json" in text
    )
    assert "./reproduce report" in text


def test_all_sections_are_in_the_page_of_a_full_run(page: Path) -> None:
    text = page.read_text()
    keys = ["hero-f32", "hero-f64", "verdicts", "scaling-f32", "scaling-f64"]
    keys += ["errors-near_edge", "errors-needle", "errors-offset", "worst"]
    keys += ["fixed-f32", "fixed", "loops-f32", "loops", "grid", "weights"]
    keys += ["overview-f32", "overview-f64", "flags_axis", "heat-needle"]
    keys += ["heat-offset", "heat-near_vertex", "heat-scale"]
    keys += ["heat-exponent_spread", "ulps-f32", "ulps-f64", "claims-f32"]
    keys += ["claims-f64", "gradients-f32", "two_truths", "exact_errors"]
    keys += ["exact_speed", "fails-exact", "fails-edge_function"]
    keys += ["pairs", "placements", "placements_spread", "trust"]
    keys += ["weights_cost", "cells", "accuracy", "refused", "shards", "flags"]
    assert [key for key in keys if f'id="{key}"' not in text] == []


def test_exhibits_are_numbered_as_they_stand_in_the_page(page: Path) -> None:
    for kind in ("Figure", "Table"):
        captions = re.findall(rf"<b>{kind} (\d+)\.</b>", page.read_text())
        assert captions == [str(n) for n in range(1, len(captions) + 1)]


def test_the_page_is_one_small_file_that_needs_no_network(page: Path) -> None:
    text = page.read_text()
    assert page.stat().st_size <= 5_000_000
    assert not re.search(r"(src|href)=\"(https?:)?//", text)
    assert "@import" not in text and "url(http" not in text


def test_every_picture_has_words_with_numbers(page: Path) -> None:
    labels = re.findall(r'<svg role="img" aria-label="([^"]*)"', page.read_text())
    assert len(labels) >= 9
    assert all(len(label) > 60 and re.search(r"\d", label) for label in labels)


def test_another_process_gives_the_same_bytes(small_run: Path) -> None:
    pages = []
    for seed in ("1", "2"):
        out = small_run / seed
        subprocess.run(
            [sys.executable, "-m", "analysis", "report", small_run, "--out", out]
            + ["--runs", small_run / "none"],
            env={**os.environ, "PYTHONHASHSEED": seed},
            check=True,
        )
        files = sorted(path for path in out.rglob("*") if path.is_file())
        pages.append({file.relative_to(out): file.read_bytes() for file in files})
    assert pages[0] == pages[1]
    assert {Path("report.pdf"), Path("data/measured.json.gz")} < set(pages[0])


@pytest.mark.parametrize(
    "change",
    [
        {},
        {"methods": ("cross_product",)},
        {"isas": ("scalar",)},
        {"scalars": ("f64",)},
        {"repetitions": 1},
        {"methods_json": False},
        {"error_factor": (("cross_product", 0.0), ("edge_function", 0.0))},
    ],
    ids=lambda change: next(iter(change), "plain"),
)
def test_a_run_with_little_in_it_still_has_a_page(
    tmp_path: Path, change: dict[str, object]
) -> None:
    options = dataclasses.replace(TWO_METHODS, **change)  # type: ignore[arg-type]
    report = build(load_run(write_run(tmp_path / "a", options)))
    assert write_page(report, tmp_path / "out").stat().st_size > 10_000


def test_no_failure_is_shown_as_none_of_so_many(page: Path) -> None:
    text = page.read_text()
    row = text[text.index('id="overview-f32-table"') :]
    row = row[row.index(">exact<") :]
    assert re.search(r'class="rate-none" title="0 of [^"]*">0<small>of \d', row)


def test_every_method_has_its_failure_in_words_if_there_are_some(
    report: Report, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    texts = tmp_path / "methods.toml"
    texts.write_text("[edge_function]\nfails = 'The line C grows < far away.'\n")
    monkeypatch.setattr(failure_prose, "METHODS_TEXT", texts)
    words = {entry["key"]: entry for entry in failure_prose.failures(report)}
    assert words["edge_function"]["fails"] == "The line C grows < far away."
    assert words["cross_product"]["fails"] == ""
    assert words["cross_product"]["example"].corners[3][2] == "(2, 1)"
    assert words["exact"]["example"] is None
    page = render(report, "index.html.j2")
    assert "The line C grows &lt; far away." in page
    assert page.count("No failing input in") == sum(
        entry["example"] is None for entry in words.values()
    )


def test_without_examples_no_method_that_erred_is_called_without_failure(
    report: Report,
) -> None:
    stored = dataclasses.replace(report.run, worst=report.run.worst.head(0))
    bare = dataclasses.replace(report, run=stored)
    words = failure_prose.failures(bare)
    erring = [entry for entry in words if entry["failing"]]
    assert 0 < len(erring) < len(words)
    assert all(entry["example"] is None for entry in words)
    page = render(bare, "index.html.j2")
    assert page.count("No failing input in") == len(words) - len(erring)
    assert page.count("A stored run keeps no examples.") == len(erring)
    assert "two inputs, those farthest from the boundary" not in page


@pytest.mark.parametrize("method", failure_prose.EXACT_BY_DIFFERENCES)
def test_a_recipe_ends_where_exponents_spread_only_if_it_errs_there(
    report: Report, method: str
) -> None:
    accuracy = report.run.accuracy
    own = (accuracy["family"] == "exponent_spread") & (accuracy["method"] == method)
    assert own.any()
    counts = ["false_inside", "false_outside"]
    run = dataclasses.replace(report.run, accuracy=accuracy.copy())
    run.accuracy.loc[own, counts] = 0
    said = failure_prose.recipe_words(dataclasses.replace(report, run=run))
    assert said is not None
    assert method in said["sound"] and method not in said["erring"]
    far = own & (accuracy["scene"] == "exponent_spread:binades=28")
    run.accuracy.loc[far, counts] = [5, 1]
    said = failure_prose.recipe_words(dataclasses.replace(report, run=run))
    assert said is not None
    assert f"{method} from 28 binades on" in said["erring"]
    assert method not in said["sound"]


def test_a_warning_stands_beside_its_method(page: Path) -> None:
    text = html.unescape(page.read_text())
    assert "cross_product_fast_math ⚠" in text
    assert "A warning, not an offer:</strong> may call NaN inside" in text


def test_exact_answers_are_praised_only_if_they_are_exact(report: Report) -> None:
    kept = html.unescape(render(report, "index.html.j2"))
    assert "none was wrong." in kept
    table = report.exact_errors
    points = int(table.groupby("scalar")["points"].max().sum())
    assert points < int(table["of"].sum())
    assert f"answers to {grouped(points)} points of up to" in kept
    broken = dataclasses.replace(
        report, exact_errors=report.exact_errors.assign(wrong=1)
    )
    said = html.unescape(render(broken, "index.html.j2"))
    assert "the promise is broken" in said and "none was wrong" not in said


def test_a_hole_that_a_flag_tears_is_told_in_a_million(report: Report) -> None:
    table = report.flags.assign(base_hole_count=1)
    words = failure_prose.flags_words(dataclasses.replace(report, flags=table))
    assert words is not None and words["torn"] == []
    own = (table["method"] == "edge_function_fma") & (table["scalar"] == report.scalar)
    table.loc[own, ["base_hole_count", "hole_count", "hole"]] = [0, 5, 2.5e-4]
    words = failure_prose.flags_words(dataclasses.replace(report, flags=table))
    assert words is not None
    assert [(t["method"], t["holes"]) for t in words["torn"]] == [
        ("edge_function", "250")
    ]


def test_a_run_without_maps_has_no_pictures_of_them(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "a", TWO_METHODS)
    (folder / "maps.json").unlink()
    page = render(build(load_run(folder)), "index.html.j2")
    assert 'id="pictures"' not in page and 'href="#pictures"' not in page


def test_markup_in_the_data_is_shown_and_not_obeyed(tmp_path: Path) -> None:
    run = load_run(write_run(tmp_path / "a", TWO_METHODS))
    machine = dataclasses.replace(run.machine, model="<script>alert(1)</script>")
    page = render(build(dataclasses.replace(run, machine=machine)), "index.html.j2")
    assert "<script>alert(1)" not in page
    assert "&lt;script&gt;alert(1)" in page
