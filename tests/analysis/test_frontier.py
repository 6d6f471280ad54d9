"""The page's chart of speed against error shows what the tables say."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.accuracy.accuracy_tables import speed_against_error
from analysis.report.frontier_data import frontier_data, script_text
from analysis.report.report import Report
from analysis.trust.stats import pareto_frontier
from tests.analysis.browser import Browser

MARKS = "document.querySelectorAll('#frontier-plot .mark').length"
SAID = "document.getElementById('frontier-row').textContent"
ROWS = (
    "[...document.querySelectorAll('#frontier-table tbody tr')]"
    ".map((row) => [...row.cells].map((cell) => cell.textContent))"
)
# The middle of the k-th mark in the order of drawing, in the window.
MIDDLE = """
(k) => {
  const box = document.querySelectorAll("#frontier-plot .mark")[k].getBoundingClientRect();
  return [box.x + box.width / 2, box.y + box.height / 2];
}
"""


def pick(browser: Browser, **values: str) -> None:
    for name, value in values.items():
        browser.run(
            f"(() => {{ const s = document.getElementById('frontier-{name}');"
            f"s.value = '{value}'; s.dispatchEvent(new Event('change')); }})()"
        )


def rows_of(report: Report, scalar: str, family: str) -> pd.DataFrame:
    """The rows of the tables that a pick is about, libraries apart."""
    accuracy = report.parted.ours.accuracy
    rows = speed_against_error(report.cells, accuracy, scalar, family=family)
    return rows.dropna(subset=["error_rate"])


@pytest.fixture(scope="module")
def browser() -> Iterator[Browser]:
    with Browser() as browser:
        yield browser


@pytest.fixture
def opened(browser: Browser, page: Path) -> Browser:
    browser.errors.clear()
    browser.look(1200, 900)
    browser.open(page.as_uri())
    browser.run(
        "document.getElementById('frontier').scrollIntoView({behavior: 'instant'})"
    )
    return browser


def test_a_pick_shows_the_marks_and_the_frontier_of_its_rows(
    opened: Browser, report: Report
) -> None:
    data = frontier_data(report.parted, report.cells)
    seen = set()
    for scalar, family in (("f32", "near_edge"), ("f64", "needle")):
        rows = rows_of(report, scalar, family)
        for isa in ("all", "scalar"):
            pick(opened, scalar=scalar, family=family, isa=isa)
            part = rows if isa == "all" else rows[rows["isa"] == isa]
            front = part[
                pareto_frontier(
                    list(part["items_per_second"]), list(part["error_rate"])
                )
            ]
            libraries = sum(
                speed[1] == "library" and answer is not None and isa == "all"
                for speed, answer in zip(
                    data["scalars"][scalar]["speeds"],
                    data["scalars"][scalar]["answers"][family],
                )
            )
            assert opened.run(MARKS) == len(part) + libraries > 0
            shown = {(row[0], row[1]) for row in opened.run(ROWS)}
            assert shown == set(zip(front["method"], front["isa"]))
            seen.add(
                opened.run("document.querySelector('#frontier-plot svg').ariaLabel")
            )
    assert len(seen) == 4
    assert opened.errors == []


def test_the_keyboard_goes_from_the_slowest_mark_to_the_fastest(
    opened: Browser, report: Report
) -> None:
    pick(opened, scalar="f32", family="near_edge", isa="avx512")
    rows = rows_of(report, "f32", "near_edge")
    rows = rows[rows["isa"] == "avx512"].sort_values("items_per_second")
    opened.run("document.getElementById('frontier-plot').focus()")
    assert "on the frontier" in opened.run(SAID)
    opened.press("Home", 36)
    heard = [opened.run(SAID)]
    for _ in range(len(rows) - 1):
        opened.press("ArrowRight", 39)
        heard.append(opened.run(SAID))
    assert len(set(heard)) == len(rows)
    said = {text.split(" on ")[0]: text for text in heard}
    assert set(said) == set(rows["method"])
    assert heard[0].startswith(rows["method"].iloc[0])
    for row in rows.itertuples():
        errors = (
            f"{int(row.wrong):,} of"
            if row.wrong
            else f"no wrong answer in {int(row.of):,}"
        )
        assert errors in said[row.method]
    opened.press("Escape", 27)
    assert opened.run(SAID) == ""


def test_hovering_says_the_time_that_the_table_of_cells_has(
    opened: Browser, report: Report
) -> None:
    pick(opened, scalar="f32", family="near_edge", isa="scalar")
    cells = report.exhibits.get("cells")
    titles = [column.title for column in cells.columns]
    shown = [dict(zip(titles, [cell.text for cell in row])) for row in cells.rows]
    scene = frontier_data(report.parted, report.cells)["scalars"]["f32"]["scene"]
    heard = set()
    for k in range(opened.run(MARKS)):
        opened.point_at(*opened.run(f"({MIDDLE})({k})"))
        text = opened.run(SAID)
        method = text.split(" on ")[0]
        wanted = {"method": method, "isa": "scalar", "scalar": "f32", "scene": scene}
        wanted |= {"loop": "one_triangle"}
        by_name = {key.lower(): key for key in titles}
        (row,) = [
            r
            for r in shown
            if all(r[by_name[key]] == value for key, value in wanted.items())
        ]
        assert f": {row['ns/item']} ns a point ({row['interval']})" in text
        heard.add(method)
    assert len(heard) > 3


def test_a_phone_shows_the_chart_without_scrolling_sideways(opened: Browser) -> None:
    opened.look(360, 740)
    # It is drawn anew in one of the next frames, however busy the machine is.
    opened.run(
        """new Promise((done) => {
        const look = (left) => left === 0 || document.documentElement.scrollWidth
          <= document.documentElement.clientWidth
          ? done() : setTimeout(look, 100, left - 1);
        look(100);
      })"""
    )
    assert opened.run("document.documentElement.scrollWidth") <= opened.run(
        "document.documentElement.clientWidth"
    )
    assert opened.run("document.querySelector('#frontier-plot svg').clientWidth") < 360


def test_the_data_cannot_close_its_script_element() -> None:
    text = script_text({"noise": "</script><!--"})
    assert "<" not in text
    assert json.loads(text) == {"noise": "</script><!--"}


def test_a_run_without_hard_scenes_has_no_section(report: Report) -> None:
    none: Any = report.cells.iloc[:0]
    assert frontier_data(report.parted, none)["scalars"] == {}
