"""Renders a report and writes it: the page, its tables and its charts.

Every file is written whole beside its place and then renamed, the page last,
so a stop at any moment leaves no half file and no page without its data.
"""

from __future__ import annotations

import os
from pathlib import Path

import jinja2
from markupsafe import Markup

from analysis.exhibits import Exhibits, csv_text
from analysis.prose import facts
from analysis.report import Report

TEMPLATES = Path(__file__).resolve().parent.parent / "report" / "templates"


def render(report: Report, template: str) -> str:
    """The template filled with the facts and the exhibits of the report."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(TEMPLATES),
        autoescape=lambda name: bool(name and ".html" in name),
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )
    environment.filters["inline_svg"] = _inline_svg
    environment.globals["ref"] = lambda key: _reference(report.exhibits, key)
    environment.globals["exhibit"] = report.exhibits.get
    return environment.get_template(template).render(**facts(report))


def write_page(report: Report, folder: Path) -> Path:
    """Writes index.html, tables/ and charts/ into `folder`; the page's path."""
    html = render(report, "index.html.j2")
    for exhibit in report.exhibits:
        write_whole(folder / exhibit.csv_path, csv_text(exhibit.csv).encode())
        if exhibit.chart:
            stem = folder / "charts" / exhibit.key
            svg = _standalone_svg(exhibit.chart.svg)
            write_whole(stem.with_suffix(".svg"), svg.encode())
            write_whole(stem.with_suffix(".png"), exhibit.chart.png)
    page = folder / "index.html"
    write_whole(page, html.encode())
    return page


def write_whole(path: Path, content: bytes) -> None:
    """Writes beside the place and renames, so that no reader sees a part."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        partial.write_bytes(content)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def _reference(exhibits: Exhibits, key: str) -> Markup:
    """A link to a figure or table, by its number."""
    exhibit = exhibits.get(key)
    if exhibit is None:
        return Markup("(not in this run)")
    return Markup('<a href="#{}">{}</a>').format(key, exhibit.name)


def _inline_svg(svg: str, alt: str) -> Markup:
    """The picture as an element of the page, with its words for those who do
    not see it. `svg` is ours and is not escaped; `alt` is.
    """
    opening = Markup('<svg role="img" aria-label="{}"').format(alt)
    return opening + Markup(svg[len("<svg") :])


def _standalone_svg(svg: str) -> str:
    return '<?xml version="1.0" encoding="utf-8"?>\n' + svg
