"""Renders a report and writes it: the page, its tables and its charts.

Every file is written whole beside its place and then renamed, the page last,
so a stop at any moment leaves no half file and no page without its data.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import jinja2
from markupsafe import Markup

from analysis.charts.chart_font import font_faces
from analysis.report.exhibits import Exhibits, csv_text
from analysis.report.formula import on_page, on_paper
from analysis.report.frontier_data import frontier_data, script_text
from analysis.report.page_order import CONTENTS, numbered, with_contents
from analysis.report.prose import facts
from analysis.report.report import Report
from analysis.report.report_data import Beside
from analysis.report.whole_file import write_whole

TEMPLATES = Path(__file__).resolve().parents[2] / "report" / "templates"


def render(report: Report, template: str, beside: Beside = Beside()) -> str:
    """The template filled with the facts and the exhibits of the report, and
    with links to what lies beside it.
    """
    words = {
        **facts(report),
        "paper": False,
        "beside": beside,
        "frontier": lambda: Markup(
            script_text(frontier_data(report.parted, report.cells))
        ),
    }
    return filled(template, words, report.exhibits, report.exhibits)


def filled(
    template: str, words: dict[str, Any], shown: Exhibits, every: Exhibits
) -> str:
    """The template filled with these words and the exhibits to be shown, of
    every exhibit that has a file.
    """
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        autoescape=lambda name: bool(name and ".html" in name),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["inline_svg"] = _inline_svg
    environment.filters["formula"] = on_paper if words.get("paper") else on_page
    environment.globals["ref"] = lambda key: _reference(shown, every, key)
    environment.globals["exhibit"] = shown.get
    environment.globals["contents"] = CONTENTS
    environment.globals["most_columns"] = max(
        (len(exhibit.columns) for exhibit in shown), default=0
    )
    environment.globals["font_faces"] = lambda: Markup(
        font_faces(exhibit.chart.svg for exhibit in shown if exhibit.chart)
    )
    page = environment.get_template(template).render(**words)
    return with_contents(numbered(page))


def write_page(report: Report, folder: Path, beside: Beside = Beside()) -> Path:
    """Writes index.html, tables/ and charts/ into `folder`, and what is to lie
    beside them; the page's path.
    """
    html = render(report, "index.html.j2", beside)
    for exhibit in report.exhibits:
        write_whole(folder / exhibit.csv_path, csv_text(exhibit.csv).encode())
        if exhibit.chart:
            stem = folder / "charts" / exhibit.key
            svg = _standalone_svg(exhibit.chart.svg)
            write_whole(stem.with_suffix(".svg"), svg.encode())
            write_whole(stem.with_suffix(".png"), exhibit.chart.png)
    for name, content in beside.files.items():
        write_whole(folder / name, content)
    if beside.pdf is not None:
        write_whole(folder / "report.pdf", beside.pdf)
    page = folder / "index.html"
    write_whole(page, html.encode())
    return page


def _reference(shown: Exhibits, every: Exhibits, key: str) -> Markup:
    """A link to a figure or table by its number; where it is not shown, to its
    file.
    """
    exhibit = every.get(key)
    if exhibit is None:
        return Markup("(not in this run)")
    if shown.get(key) is None:
        return Markup('<a href="{0}">{0}</a>').format(exhibit.csv_path)
    return Markup('<a href="#{}">{}</a>').format(key, exhibit.name)


def _inline_svg(svg: str, alt: str) -> Markup:
    """The picture as an element of the page, with its words for those who do
    not see it. `svg` is ours and is not escaped; `alt` is.
    """
    opening = Markup('<svg role="img" aria-label="{}"').format(alt)
    return opening + Markup(svg[len("<svg") :])


def _standalone_svg(svg: str) -> str:
    return '<?xml version="1.0" encoding="utf-8"?>\n' + svg
