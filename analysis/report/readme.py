"""README.md's chart and table, written between markers from a run."""

from __future__ import annotations

import re
from pathlib import Path

from analysis.read.read_json import LoadError
from analysis.report.page import render
from analysis.report.report import Report
from analysis.report.whole_file import write_whole

BEGIN = "<!-- begin: measured -->"
END = "<!-- end: measured -->"
CHART = Path("report") / "readme" / "hero.png"


def replaced(readme: str, measured: str) -> str:
    """`readme` with what stands between the markers replaced. LoadError if
    the markers are not there, once each and in order.
    """
    pattern = re.compile(f"{re.escape(BEGIN)}.*?{re.escape(END)}", re.DOTALL)
    found = pattern.findall(readme)
    if len(found) != 1 or readme.count(BEGIN) != 1 or readme.count(END) != 1:
        raise LoadError(f"needs one line '{BEGIN}' and after it one line '{END}'")
    return pattern.sub(lambda _: f"{BEGIN}\n{measured.strip()}\n{END}", readme)


def write_readme(report: Report, readme: Path) -> Path:
    """Rewrites the measured part of `readme` and the chart that it shows."""
    hero = report.exhibits.get(f"hero-{report.scalar}")
    if hero is None or hero.chart is None or report.advice is None:
        raise LoadError(
            f"run {report.run.name}: has no speed and error rate of the same methods "
            "to show"
        )
    try:
        text = readme.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise LoadError(f"{readme}: cannot be read: {error}") from None
    try:
        text = replaced(text, render(report, "readme.md.j2"))
    except LoadError as error:
        raise LoadError(f"{readme}: {error}") from None
    write_whole(readme.parent / CHART, hero.chart.png)
    write_whole(readme, text.encode())
    return readme
