"""The numbered figures and tables of a report, each with its data as CSV."""

from __future__ import annotations

import dataclasses
import math
import re
from collections.abc import Callable, Iterable, Sequence
from typing import Any

import pandas as pd

from analysis.charts.chart_frame import Chart
from analysis.report.page_order import stand_in

# What the page's script takes for a number at the beginning of a text.
_LEADING = re.compile(r"[-+]?\d+(\.\d+)?(e[-+]?\d+)?")


@dataclasses.dataclass(frozen=True)
class Column:
    """How a column is shown: the text of a row, and what it is sorted by (the
    column's own value unless `sort` names another).
    """

    title: str
    show: Callable[[Any], str]
    note: Callable[[Any], str] | None = None  # a second, smaller line
    sort: str | None = None
    numeric: bool = True
    hint: str = ""
    wraps: bool = False  # holds sentences, which may take several lines
    tint: Callable[[Any], str] | None = None  # a class of the page's style
    tip: Callable[[Any], str] | None = None  # shown when pointed at


@dataclasses.dataclass(frozen=True)
class ShownCell:
    text: str
    # What the page's script compares; empty: nothing is known. None: the text,
    # in a column of numbers the number that it begins with.
    sort: str | None
    note: str = ""
    tint: str = ""
    tip: str = ""


@dataclasses.dataclass(frozen=True)
class Exhibit:
    """A figure (with a chart) or a table (with columns), and its CSV."""

    kind: str  # "Figure" or "Table"
    key: str
    caption: str
    csv: pd.DataFrame
    chart: Chart | None = None
    columns: tuple[Column, ...] = ()
    rows: tuple[tuple[ShownCell, ...], ...] = ()
    left_out: int = 0

    @property
    def name(self) -> str:
        """What numbered() puts the number in: a page knows it at its end."""
        return stand_in(self.kind, self.key)

    @property
    def csv_path(self) -> str:
        return f"tables/{self.key}.csv"


class Exhibits:
    """Figures and tables by their keys; a page decides which it shows where."""

    def __init__(self, exhibits: Iterable[Exhibit] = ()) -> None:
        self._all = {exhibit.key: exhibit for exhibit in exhibits}

    def figure(self, chart: Chart, caption: str, data: pd.DataFrame) -> None:
        self._all[chart.key] = Exhibit("Figure", chart.key, caption, data, chart=chart)

    def table(
        self,
        key: str,
        caption: str,
        data: pd.DataFrame,
        columns: Sequence[Column],
        most_rows: int | None = None,
        csv: pd.DataFrame | None = None,
    ) -> None:
        """Shows the first `most_rows` rows in the page. The CSV has them all, or
        is `csv` where the page shows the data in another form.
        """
        shown = data if most_rows is None else data.head(most_rows)
        self._all[key] = Exhibit(
            "Table",
            key,
            caption,
            data if csv is None else csv,
            columns=tuple(columns),
            rows=_shown_rows(columns, shown.to_dict("records")),
            left_out=len(data) - len(shown),
        )

    def __iter__(self) -> Any:
        return iter(self._all.values())

    def get(self, key: str) -> Exhibit | None:
        return self._all.get(key)


def _shown_rows(
    columns: Sequence[Column], rows: list[dict[str, Any]]
) -> tuple[tuple[ShownCell, ...], ...]:
    return tuple(zip(*(_shown_column(column, rows) for column in columns)))


def _shown_column(column: Column, rows: list[dict[str, Any]]) -> list[ShownCell]:
    values = [_sorted_by(column, row) for row in rows]
    texts = [column.show(row) for row in rows]
    by_text = not column.numeric or _say(texts, values)
    return [
        ShownCell(
            text,
            None
            if by_text and (value is not None or not column.numeric)
            else _sort(value),
            column.note(row) if column.note else "",
            column.tint(row) if column.tint else "",
            column.tip(row) if column.tip else "",
        )
        for row, text, value in zip(rows, texts, values)
    ]


def _sorted_by(column: Column, row: dict[str, Any]) -> float | None:
    value = row[column.sort] if column.sort else math.nan
    known = isinstance(value, (int, float)) and math.isfinite(value)
    return float(value) if known else None


def _sort(value: float | None) -> str:
    """In a digit more than tables show."""
    if value is None:
        return ""
    if value.is_integer() and 0 <= value < 10**6:
        return str(int(value))
    return f"{value:.4g}".replace("e+0", "e")


def _say(texts: list[str], values: list[float | None]) -> bool:
    """Whether each text begins with the value, as far as its digits go, or each
    with a hundred times the value: so that the page need not hold both.
    """
    pairs = [(text, value) for text, value in zip(texts, values) if value is not None]
    for scale in (1.0, 100.0):
        if all(_says(text, scale * value) for text, value in pairs):
            return True
    return False


def _says(text: str, value: float) -> bool:
    found = _LEADING.match(text)
    return found is not None and math.isclose(
        float(found[0]), value, rel_tol=0.006, abs_tol=1e-12
    )


def csv_text(data: pd.DataFrame) -> str:
    """The frame as CSV, the same bytes for the same data."""
    text = data.to_csv(index=False, float_format="%.6g", lineterminator="\n")
    return str(text)
