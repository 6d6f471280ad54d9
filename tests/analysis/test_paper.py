"""The report on paper: of few pages, whole in itself, the same every time."""

from __future__ import annotations

import dataclasses
import html
import re
from pathlib import Path

import pytest
import weasyprint
from weasyprint.formatting_structure.boxes import TableBox

from analysis.cpus.stored_run import fingerprint, load_stored
from analysis.read.load import load_run
from analysis.report.exhibits import Exhibits
from analysis.report.findings import findings
from analysis.report.page import render
from analysis.report.paper import Cut, cut, page_of, paper
from analysis.report.paper_svg import for_paper
from analysis.report.prose import facts, worth_a_row
from analysis.report.report import Report, build
from analysis.report.report_data import Beside, beside
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run


def sheets(report: Report) -> str:
    """The paper before it is cut into sheets."""
    words = {**facts(report), "beside": Beside(), "paper": True}
    words["named"] = worth_a_row(report)
    return page_of(words, report.exhibits)


@pytest.fixture(scope="module")
def printed(report: Report) -> bytes:
    return paper(report)


def test_the_paper_is_short_and_knows_no_place(printed: bytes) -> None:
    assert printed.startswith(b"%PDF-")
    assert 8 <= len(re.findall(rb"/Type /Page\b(?!s)", printed)) <= 25
    assert b"file:" not in printed
    # Links lead to the files beside it.
    assert b"/URI (tables/verdicts.csv)" in printed
    assert b"/URI (index.html)" in printed


def test_its_exhibits_are_numbered_as_they_stand_and_lead_to_their_data(
    report: Report,
) -> None:
    page = sheets(report)
    for kind in ("Figure", "Table"):
        captions = re.findall(rf"<b>{kind} (\d+)\.</b>", page)
        assert len(captions) >= 5
        assert captions == [str(n) for n in range(1, len(captions) + 1)]
    shown = re.findall(r'(?:figure|table \w*|table )"? id="([^"]+)"', page)
    assert len(shown) >= 10
    for key in shown:
        assert f'href="tables/{key}.csv"' in page
    assert not re.search("[\x02\x03]", page)


def test_it_has_the_chapters_of_the_page_in_their_order(report: Report) -> None:
    whole = re.findall(r'<section id="(\w+)', render(report, "index.html.j2"))
    short = re.findall(r'<section id="(\w+)', sheets(report))
    assert short == [name for name in whole if name in short]
    order = ["question", "methods", "measured", "bias", "isa", "errors", "failures"]
    order += ["result", "choose", "cpus", "reproduce"]
    assert [name for name in short if name in order] == order


def test_links_inside_the_paper_lead_somewhere(report: Report) -> None:
    page = sheets(report)
    ids = set(re.findall(r' id="([^"]+)"', page))
    assert set(re.findall(r'<a href="#([^"]+)"', page)) - ids == set()


def test_a_cut_table_says_how_many_rows_are_in_its_file(report: Report) -> None:
    table = report.exhibits.get("verdicts")
    assert table is not None
    short = cut(table, Cut(named=True, without=("verdict",)), {"exact"})
    assert [row[0].text for row in short.rows] == ["exact"]
    assert short.left_out == len(table.rows) - 1
    assert len(short.rows[0]) == len(short.columns) == len(table.columns) - 1
    assert short.csv is table.csv
    bare = cut(table, Cut(rows=2, notes=False), set())
    assert all(cell.note == "" for row in bare.rows for cell in row)
    wrong = report.exhibits.get("overview-f32")
    assert wrong is not None
    notes = [
        [cell.note for cell in row] for row in cut(wrong, Cut(notes=False), set()).rows
    ]
    assert notes == [
        [cell.note * ("under-" in cell.tint) for cell in row] for row in wrong.rows
    ]
    assert any(note for row in notes for note in row)
    assert f"<b>{len(table.rows) - len(worth_a_row(report))} rows more" in sheets(
        report
    )


def test_no_table_reaches_beyond_its_sheet(report: Report) -> None:
    tables = re.sub(r"<figure.*?</figure>", "", sheets(report), flags=re.S)
    known = 0
    for sheet in weasyprint.HTML(string=for_paper(tables)).render().pages:
        for box in sheet._page_box.descendants():
            if isinstance(box, TableBox):
                known += 1
                wide = box.element.get("class", "")
                assert 20 <= box.position_x, wide  # pixels: 5 mm
                assert box.position_x + box.margin_width() <= sheet.width - 20, wide
    assert known >= 10


def test_marks_are_drawn_where_they_are_used() -> None:
    page = (
        '<defs><path id="a" d="M0 0V3"/></defs>'
        '<g fill-opacity="0" stroke="#111"><use href="#a" x="4" y="-5.5"/></g>'
        '<use href="#a" x="1" y="2" fill="#222" fill-opacity="0"/>'
    )
    assert for_paper(page) == (
        '<defs><path id="a" d="M0 0V3"/></defs>'
        '<g fill="none" stroke="#111"><path d="M0 0V3" transform="translate(4 -5.5)"/></g>'
        '<path fill="none" d="M0 0V3" transform="translate(1 2)"/>'
    )


def test_no_mark_is_left_to_be_used_by_reference(report: Report) -> None:
    page = for_paper(sheets(report))
    assert "<use" in sheets(report) and "<use" not in page
    assert 'fill-opacity="0"' not in page


def test_stale_kernels_are_told_on_page_and_paper(small_run: Path) -> None:
    run = load_run(small_run)
    assert "Stale:" not in render(build(run), "index.html.j2")
    other = dataclasses.replace(run.machine, kernel_hash="0" * 64)
    report = build(dataclasses.replace(run, machine=other))
    for page in (render(report, "index.html.j2"), sheets(report)):
        assert "<strong>Stale:</strong> this run measured other kernels" in page


def test_the_abstract_has_three_findings_that_follow_the_data(report: Report) -> None:
    page = html.unescape(sheets(report))
    abstract = page[page.index('<ol class="abstract">') : page.index("</ol>")]
    assert abstract.count("<li>") == 3
    words = findings(report)
    assert words["trained"] is not None and "flatters" in abstract
    key = f"fixed-{report.scalar}"
    fixed = report.exhibits.get(key)
    assert fixed is not None
    even = fixed.csv.assign(fresh_over_fixed=1.0, fresh_over_fixed_low=0.99)
    other = Exhibits(
        dataclasses.replace(e, csv=even) if e.key == key else e for e in report.exhibits
    )
    untrained = dataclasses.replace(report, exhibits=other)
    assert findings(untrained)["trained"] is None
    assert "flatters" not in sheets(untrained)


def test_what_weighs_more_follows_the_data(report: Report) -> None:
    alike = report.verdicts.assign(time_over_best=1.01)
    apart = report.verdicts.assign(time_over_best=1000.0)
    for verdicts, more in ((alike, True), (apart, False)):
        changed = dataclasses.replace(report, verdicts=verdicts)
        assert findings(changed)["sets_weigh_more"] is more
        assert ("instruction set weighs more" in sheets(changed)) is more


def test_the_data_beside_a_report_is_a_run_again(tmp_path: Path) -> None:
    source = write_run(tmp_path / "a", TWO_METHODS)
    run = load_run(source)
    found = beside(run, source, source / "report")
    for name, content in found.files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    assert fingerprint(load_stored(tmp_path / "data")) == fingerprint(run)
    assert "../machine.json" in found.raw
    # Elsewhere nothing of the run's own files is promised.
    assert beside(run, source, tmp_path / "other").raw == ()
    again = beside(load_stored(tmp_path / "data"), tmp_path / "data", tmp_path / "b")
    assert dict(again.files) == dict(found.files)
