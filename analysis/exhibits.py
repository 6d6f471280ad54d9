"""The numbered figures and tables of a report, each with its data as CSV."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence
from typing import Any

import pandas as pd

from analysis.chart_frame import Chart


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
    sort: str  # what the page's script compares; empty: nothing is known
    note: str = ""
    tint: str = ""
    tip: str = ""


@dataclasses.dataclass(frozen=True)
class Exhibit:
    """A figure (with a chart) or a table (with columns), and its CSV."""

    kind: str  # "Figure" or "Table"
    number: int
    key: str
    caption: str
    csv: pd.DataFrame
    chart: Chart | None = None
    columns: tuple[Column, ...] = ()
    rows: tuple[tuple[ShownCell, ...], ...] = ()
    left_out: int = 0

    @property
    def name(self) -> str:
        return f"{self.kind} {self.number}"

    @property
    def csv_path(self) -> str:
        return f"tables/{self.key}.csv"


class Exhibits:
    """Numbers exhibits in the order in which they are added, which is the
    order in which the page shows them.
    """

    def __init__(self) -> None:
        self._all: dict[str, Exhibit] = {}

    def figure(self, chart: Chart, caption: str, data: pd.DataFrame) -> None:
        number = 1 + sum(e.kind == "Figure" for e in self)
        self._all[chart.key] = Exhibit(
            "Figure", number, chart.key, caption, data, chart=chart
        )

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
        number = 1 + sum(e.kind == "Table" for e in self)
        self._all[key] = Exhibit(
            "Table",
            number,
            key,
            caption,
            data if csv is None else csv,
            columns=tuple(columns),
            rows=tuple(
                tuple(_shown(column, row) for column in columns)
                for row in shown.to_dict("records")
            ),
            left_out=len(data) - len(shown),
        )

    def __iter__(self) -> Any:
        return iter(self._all.values())

    def get(self, key: str) -> Exhibit | None:
        return self._all.get(key)


def _shown(column: Column, row: dict[str, Any]) -> ShownCell:
    text = column.show(row)
    note = column.note(row) if column.note else ""
    tint = column.tint(row) if column.tint else ""
    tip = column.tip(row) if column.tip else ""
    if not column.numeric:
        return ShownCell(text, text, note, tint, tip)
    value = row[column.sort] if column.sort else math.nan
    known = isinstance(value, (int, float)) and math.isfinite(value)
    sort = f"{value:.9g}" if known else ""
    return ShownCell(text, sort, note, tint, tip)


def csv_text(data: pd.DataFrame) -> str:
    """The frame as CSV, the same bytes for the same data."""
    text = data.to_csv(index=False, float_format="%.6g", lineterminator="\n")
    return str(text)
