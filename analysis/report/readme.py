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


_MEASURED = re.compile(f"{re.escape(BEGIN)}.*?{re.escape(END)}", re.DOTALL)


def replaced(readme: str, measured: str) -> str:
    """`readme` with what stands between the markers replaced."""
    return _MEASURED.sub(lambda _: f"{BEGIN}\n{measured.strip()}\n{END}", readme)


def read_readme(readme: Path) -> str:
    """The text of the file. LoadError if it cannot be read or the markers are not
    there, once each and in order.
    """
    try:
        text = readme.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise LoadError(f"{readme}: cannot be read: {error}") from None
    once = text.count(BEGIN) == text.count(END) == 1
    if not once or not _MEASURED.search(text):
        raise LoadError(
            f"{readme}: needs one line '{BEGIN}' and after it one line '{END}'"
        )
    return text


def write_readme(report: Report, readme: Path) -> Path:
    """Rewrites the measured part of `readme` and the chart that it shows."""
    hero = report.exhibits.get(f"hero-{report.scalar}")
    if hero is None or hero.chart is None or report.advice is None:
        raise LoadError(
            f"run {report.run.name}: has no speed and error rate of the same methods "
            "to show"
        )
    text = replaced(read_readme(readme), render(report, "readme.md.j2"))
    write_whole(readme.parent / CHART, hero.chart.png)
    write_whole(readme, text.encode())
    return readme
