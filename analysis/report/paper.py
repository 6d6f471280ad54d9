"""The report on paper: the chapters of the page with the exhibits that carry
them, tables cut to the rows that matter, as a PDF of 15 to 25 pages.

The same report gives the same bytes: nothing in the PDF tells when or where it
was made.
"""

from __future__ import annotations

import dataclasses
import logging
import os
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final

import weasyprint

from analysis.accuracy.ulp_maps import answers_chart
from analysis.report.exhibits import Exhibit, Exhibits, ShownCell
from analysis.report.page import filled
from analysis.report.paper_svg import for_paper
from analysis.report.prose import facts, worth_a_row
from analysis.report.report import Report, footer_of
from analysis.report.report_data import Beside

TEMPLATE: Final = "paper.html.j2"


@dataclasses.dataclass(frozen=True)
class Cut:
    """What a table keeps: the rows in whose first column stands a method that
    the report names, then the first `rows`; and not the columns of these titles.
    """

    named: bool = False
    rows: int | None = None
    without: tuple[str, ...] = ()
    notes: bool = True  # whether second lines stay that hold no number of their own


WHOLE: Final = Cut()
# What the paper shows; {scalar} is that of the main comparison. In the order of
# nothing: the chapters say where each stands. What a run has not is left out.
SHOWN: Final[dict[str, Cut]] = {
    "hero-{scalar}": WHOLE,
    "scaling-{scalar}": WHOLE,
    "roofline-{scalar}": WHOLE,
    "goals": Cut(notes=False, without=("bound by",)),
    "input-hit-{scalar}": WHOLE,
    "input-size-{scalar}": WHOLE,
    "threads": Cut(notes=False),
    "grid": Cut(rows=12, without=("interval", "noise")),
    "operations": Cut(named=True, notes=False),
    "peers": Cut(rows=14),
    "overview-{scalar}": Cut(named=True, notes=False),
    "errors-near_edge": WHOLE,
    "heat-needle": WHOLE,
    "ulps-{scalar}": WHOLE,
    "recipes": Cut(without=("of A, B, C and P",)),
    "verdicts": Cut(named=True, without=("% of limit",)),
    "exact_errors": WHOLE,
    "verified": Cut(without=("loops",)),
    "cost_curve": WHOLE,
    "choice_map": WHOLE,
    "typical_scenes": Cut(without=("command",)),
    "rays-{scalar}": WHOLE,
    "ray_methods": Cut(rows=18),
    "ledger": Cut(without=("how it is tested",)),
    "cpus-runs": Cut(without=("folder", "revision")),
    "cpus": WHOLE,
    "cpus-isas": Cut(rows=12),
    "cpus-methods": Cut(named=True, rows=14),
    "cpus-answers": WHOLE,
}


def paper(report: Report, data: Beside = Beside()) -> bytes:
    """The PDF, with links to the data that will lie beside it."""
    methods = worth_a_row(report)
    words = {**facts(report), "beside": data, "paper": True, "named": methods}
    return pdf(page_of(words, _with_fewer_maps(report, methods)))


def page_of(words: dict[str, Any], every: Exhibits) -> str:
    """The paper as a page, before it is cut into sheets."""
    shown = selected(every, str(words["scalar"]), words["named"])
    return filled(TEMPLATE, words, shown, every)


def _with_fewer_maps(report: Report, methods: set[str]) -> Exhibits:
    """The exhibits, with the maps of neighbouring points of these methods only."""
    key = f"ulps-{report.scalar}"
    exhibit = report.exhibits.get(key)
    maps = [
        entry
        for entry in report.run.maps.ulp_maps
        if entry.scalar == report.scalar and entry.method in methods
    ]
    if exhibit is None or not maps:
        return report.exhibits
    fewer = dataclasses.replace(
        exhibit,
        chart=answers_chart(maps, report.scalar, footer_of(report.run, report.noise)),
        caption=f"{exhibit.caption} The page shows all methods.",
    )
    return Exhibits(fewer if e.key == key else e for e in report.exhibits)


def selected(every: Exhibits, scalar: str, methods: set[str]) -> Exhibits:
    cuts = {key.format(scalar=scalar): cut for key, cut in SHOWN.items()}
    return Exhibits(
        cut(exhibit, cuts[exhibit.key], methods)
        for exhibit in every
        if exhibit.key in cuts
    )


def cut(exhibit: Exhibit, wanted: Cut, methods: set[str]) -> Exhibit:
    """The table without the rows and columns that are not wanted; the rows that
    go are counted in `left_out`. A figure stays as it is.
    """
    rows = exhibit.rows
    if wanted.named:
        # A method's name may have a mark behind it.
        rows = tuple(row for row in rows if row[0].text.split()[0] in methods)
    rows = rows[: wanted.rows]
    places = [
        place
        for place, column in enumerate(exhibit.columns)
        if column.title not in wanted.without
    ]
    return dataclasses.replace(
        exhibit,
        columns=tuple(exhibit.columns[place] for place in places),
        rows=tuple(
            tuple(row[at] if wanted.notes else _without_note(row[at]) for at in places)
            for row in rows
        ),
        left_out=exhibit.left_out + len(exhibit.rows) - len(rows),
    )


def _without_note(cell: ShownCell) -> ShownCell:
    """Without its second line, unless that is a number in a colour of its own."""
    return cell if "under-" in cell.tint else dataclasses.replace(cell, note="")


def pdf(page: str) -> bytes:
    """The sheets of a page that needs nothing but itself and the fonts."""
    logging.getLogger("weasyprint").setLevel(logging.ERROR)
    with _no_clock():
        made = weasyprint.HTML(string=for_paper(page), url_fetcher=_own).write_pdf()
    return bytes(made)


@contextmanager
def _no_clock() -> Iterator[None]:
    """fontTools writes the time into a font that it cuts, unless it is told."""
    before = os.environ.get("SOURCE_DATE_EPOCH")
    os.environ["SOURCE_DATE_EPOCH"] = "0"
    try:
        yield
    finally:
        if before is None:
            del os.environ["SOURCE_DATE_EPOCH"]
        else:
            os.environ["SOURCE_DATE_EPOCH"] = before


def _own(url: str) -> dict[str, Any]:
    """Pictures that the page itself holds, and nothing else."""
    if not url.startswith("data:"):
        raise ValueError(f"{url}: the paper takes nothing from elsewhere")
    return dict(weasyprint.default_url_fetcher(url))
