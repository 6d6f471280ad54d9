"""The numbers of the page's chart of speed against error, as its script wants
them: the rows of the hero chart, for every scalar and every hard scene.

A row of speeds stands once a scalar; what a family of scenes says of it stands
beside, at the same place. Both carry the words of the tables, so that the
script does not round anything itself.
"""

from __future__ import annotations

import json
from typing import Any, Final

import pandas as pd

from analysis.accuracy.accuracy_tables import speed_against_error
from analysis.accuracy.overview import HARD_FAMILIES
from analysis.charts import palette
from analysis.charts.hero_chart import POINTS
from analysis.peers.peers_exhibits import hero_rows
from analysis.peers.peers_tables import Parted
from analysis.report.wording import between, share, significant
from analysis.trust.stats import pareto_frontier

ON_FRONTIER: Final = 1  # no other row is faster without erring more
ON_OWN_FRONTIER: Final = 2  # none of the same ISA is


def frontier_data(parted: Parted, cells: pd.DataFrame) -> dict[str, Any]:
    """The data, ready for JSON; without scalars where nothing is comparable.

    `cells`: the timed cells of the kernels that methods are compared by.
    Speeds are [method, isa, ns, low, high, words, interval's words, noise]; an
    answer is [wrong, of, low, high, words, flags], or None where the row was
    not judged on the family.
    """
    found: dict[str, Any] = {}
    present = set(cells["scalar"])
    for scalar in [s for s in ("f32", "f64") if s in present]:
        families = {
            family: rows
            for family, _ in HARD_FAMILIES
            if len(rows := _rows(parted, cells, scalar, family))
        }
        if families:
            found[scalar] = _scalar(families)
    rows_of = [row for one in found.values() for row in one["speeds"]]
    methods = sorted({row[0] for row in rows_of}, key=palette.method_rank)
    isas = sorted({row[1] for row in rows_of}, key=palette.isa_rank)
    return {
        "methods": {
            method: [
                palette.method_style(method).colour,
                palette.method_style(method).variant,
            ]
            for method in methods
        },
        "isas": {isa: palette.isa_marker(isa) for isa in isas},
        "classics": list(POINTS.classics),
        "families": dict(HARD_FAMILIES),
        "scalars": found,
    }


def script_text(data: dict[str, Any]) -> str:
    """The data as JSON that can stand in a script element."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return text.replace("<", "\\u003c")


def _rows(
    parted: Parted, cells: pd.DataFrame, scalar: str, family: str
) -> pd.DataFrame:
    """The rows of the hero chart with another family's errors."""
    marks = speed_against_error(cells, parted.ours.accuracy, scalar, family=family)
    marks = marks.dropna(subset=["error_rate"])
    if not len(marks):
        return marks
    own = pd.Series(False, index=marks.index)
    for _, rows in marks.groupby("isa"):
        own[rows.index] = pareto_frontier(
            list(rows["items_per_second"]), list(rows["error_rate"])
        )
    marks = marks.assign(on_own_frontier=own)
    beside = hero_rows(parted, cells, scalar, family)
    if beside is None or not len(beside):
        return marks
    return pd.concat([marks, beside.assign(on_own_frontier=False)])


def _scalar(families: dict[str, pd.DataFrame]) -> dict[str, Any]:
    """One scalar's speeds, and each family's answers in the same order."""
    every = pd.concat(families.values()).drop_duplicates(["method", "isa"])
    speeds = [
        [row.method, row.isa]
        + [_short(ns) for ns in (row.ns, row.ns_low, row.ns_high)]
        + [significant(row.ns), between(row.ns_low, row.ns_high), row.noise]
        for row in every.itertuples()
    ]
    answers = {}
    for family, rows in families.items():
        known = {(row.method, row.isa): _answer(row) for row in rows.itertuples()}
        answers[family] = [known.get((row[0], row[1])) for row in speeds]
    return {
        "scene": str(every["scene"].iloc[0]),
        "loop": str(every["loop"].iloc[0]),
        "speeds": speeds,
        "answers": answers,
    }


def _answer(row: Any) -> list[Any]:
    flags = ON_FRONTIER * bool(row.on_frontier)
    flags += ON_OWN_FRONTIER * bool(row.on_own_frontier)
    low, high = _short(row.error_rate_low), _short(row.error_rate_high)
    return [int(row.wrong), int(row.of), low, high, share(row.error_rate), flags]


def _short(value: float) -> float:
    """Four digits place a mark to a tenth of a pixel."""
    return float(f"{value:.4g}")
