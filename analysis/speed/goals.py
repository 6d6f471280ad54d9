"""The goals that this benchmark set itself for its kernels, and what this run says of
each: reached, not reached, or undecided.

A goal is a number that a ratio of throughputs, or the share of a bound, is to be no
less than. It is reached where the whole 95 % interval is no less, not reached where
all of it is less. Of a bound only the time has an interval; where a kernel beat it, the
bound is wrong and nothing is decided.

Which kernel is the best, and which scene lies in a level of memory, is taken from the
run (`Measured`); a goal whose kernels were not timed is among `missing`.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Iterator
from typing import Any, Final

import pandas as pd

from analysis.read.run import Run
from analysis.report.columns import number, sentence, word
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import NONE, counted, with_interval
from analysis.speed import grid_tables, layout_tables, limit_columns
from analysis.speed.goal_kernels import EDGE, EXACT, Measured
from analysis.trust.stats import Interval

FASTER_THAN_EDGE: Final = 1.3
OF_A_BOUND: Final = 0.9
BYTES_OVER_INTEGERS: Final = 4.0
SPANS_OVER_POINTS: Final = 30.0
OF_BYTES: Final = "byte_"  # what the names of methods on bytes begin with
EXACT_OVER_INEXACT: Final = 0.95
EXACT_ISAS: Final = ("avx2", "avx512")
FLOATS: Final = ("f32", "f64")
KEY: Final = "goals"

REACHED: Final = "reached"
NOT_REACHED: Final = "not reached"
UNDECIDED: Final = "undecided"
WRONG_BOUND: Final = "undecided: its bound is wrong"
NO_GOAL: Final = "shown beside"

_LIMIT: Final = (
    *("of_limit", "of_limit_low", "of_limit_high", "compute_ns"),
    *("bound_by", "bound_of", "beaten"),
)
_UNBOUND: Final[dict[str, Any]] = {"bound_by": "", "bound_of": "", "beaten": False}
COLUMNS: Final = [
    *("goal", "scalar", "isa", "where", "method", "unit", "ns", "ns_low", "ns_high"),
    *_LIMIT,
    *("against", "value", "value_low", "value_high", "wanted", "outcome"),
]
Row = dict[str, Any]


@dataclasses.dataclass(frozen=True)
class Goals:
    """What the report says of them."""

    table: pd.DataFrame
    missing: tuple[str, ...]  # goals whose kernels were not timed

    def counts(self) -> dict[str, int]:
        outcomes = self.table["outcome"]
        return {
            "set": int(self.table["wanted"].notna().sum()),
            "reached": int((outcomes == REACHED).sum()),
            "missed": int((outcomes == NOT_REACHED).sum()),
            "undecided": int(outcomes.isin([UNDECIDED, WRONG_BOUND]).sum()),
        }

    def missing_words(self) -> str:
        return "; ".join(dict.fromkeys(self.missing))


def outcome(value: Interval, wanted: float) -> str:
    if wanted != wanted:
        return NO_GOAL
    if value.low >= wanted:
        return REACHED
    return NOT_REACHED if value.high < wanted else UNDECIDED


def goals(run: Run, cells: pd.DataFrame, unfit: dict[str, frozenset[str]]) -> Goals:
    """`cells`: every timed one, with bounds if limits are known; `unfit`: by scalar,
    the methods that are not to be taken, however fast.
    """
    measured = Measured(run, cells, unfit)
    found = [
        *_one_triangle(measured),
        *_one_point(measured),
        *_side_by_side(run, measured),
        *_published_scene(run, measured),
        *_exact(measured),
    ]
    rows = [row for row in found if not isinstance(row, str)]
    missing = tuple(row for row in found if isinstance(row, str))
    return Goals(pd.DataFrame(rows, columns=COLUMNS), missing)


def _row(
    goal: str,
    where: str,
    cell: Row,
    against: str,
    value: Interval,
    wanted: float = math.nan,
    unit: str = "point",
) -> Row:
    return {
        "goal": goal,
        "where": where,
        "unit": unit,
        **{key: cell[key] for key in ("scalar", "isa", "method")},
        **{key: cell[key] for key in ("ns", "ns_low", "ns_high")},
        **{key: cell.get(key, _UNBOUND.get(key, math.nan)) for key in _LIMIT},
        "against": against,
        "value": value.value,
        "value_low": value.low,
        "value_high": value.high,
        "wanted": wanted,
        "outcome": outcome(value, wanted),
    }


def _of_bound(
    goal: str, where: str, cell: Row, against: str, part: str = "bound_ns"
) -> Row | None:
    """The share that a cell reaches of its bound, or of that of memory alone; None
    where limits are not known.
    """
    bound = cell.get(part, math.nan)
    if bound != bound:
        return None
    value = Interval(
        bound / cell["ns"], bound / cell["ns_high"], bound / cell["ns_low"], math.nan
    )
    row = _row(goal, where, cell, against, value, OF_A_BOUND)
    return {**row, "outcome": WRONG_BOUND} if cell["beaten"] else row


def _one_triangle(measured: Measured) -> Iterator[Row | str]:
    for scalar in FLOATS:
        goal = "One triangle, the fastest method"
        best = measured.best("one_triangle", scalar, "L1")
        edge = measured.cell("one_triangle", scalar, "L1", EDGE)
        if best is None or edge is None:
            yield f"{goal} in {scalar} from L1 against {EDGE}"
        else:
            value = measured.times_as_fast(best, edge)
            yield _row(goal, "L1", best, EDGE, value, FASTER_THAN_EDGE)
        row = best and _of_bound(goal, "L1", best, "its bound")
        yield row or f"{goal} in {scalar} from L1 against its bound"
        for level in ("L3", "DRAM"):
            best = measured.best("one_triangle", scalar, level)
            against = f"loads from {level}"
            row = best and _of_bound(goal, level, best, against, "memory_ns")
            yield row or f"{goal} in {scalar} against {against}"


def _one_point(measured: Measured) -> Iterator[Row | str]:
    for scalar in FLOATS:
        for level in ("L1", "L2"):
            goal = "Many triangles, one point, the fastest method"
            best = measured.best("one_point", scalar, level)
            row = best and _of_bound(goal, level, best, "its bound")
            yield (
                {**row, "unit": "triangle"}
                if row
                else f"{goal} in {scalar} from {level} against its bound"
            )


def _side_by_side(run: Run, measured: Measured) -> Iterator[Row | str]:
    table = layout_tables.layouts(run.speed, measured.alone)
    for scalar in FLOATS:
        goal = "Points with x and y side by side, the fastest method"
        own = table[
            (table["scalar"] == scalar)
            & (table["isa"] == measured.widest)
            & ~table["method"].isin(measured.unfit(scalar))
        ]
        if not len(own):
            yield f"{goal} in {scalar} against separate arrays"
        for _, group in own.groupby("working_set_bytes", sort=True):
            cell = group.loc[group["ns"].idxmin()].to_dict()
            value = Interval(
                1 / cell["side_by_side"],
                1 / cell["side_by_side_high"],
                1 / cell["side_by_side_low"],
                math.nan,
            )
            where = cell.get("level") or measured.size_words(cell)
            yield _row(goal, where, cell, "the same on separate arrays", value)


def _published_scene(run: Run, measured: Measured) -> Iterator[Row | str]:
    table = grid_tables.published_scene(run.speed, measured.alone, dict(run.writes))
    base = f"{grid_tables.BASE_METHOD} on points in {grid_tables.BASE_SCALAR}"
    known = table[table["times_points"].notna()] if len(table) else table
    goals_set = (
        ("The published scene as points, bytes as lanes", "points", OF_BYTES),
        ("The published scene as a grid, row spans to bits", "grid", "row_spans"),
        ("The published scene, edges of one point as lanes", "points", "edge_lanes"),
    )
    wanted = (BYTES_OVER_INTEGERS, SPANS_OVER_POINTS, math.nan)
    for (goal, track, method), least in zip(goals_set, wanted):
        isas = measured.two_widest if method == OF_BYTES else [measured.widest]
        for isa in isas:
            own = known[:0]
            if len(known):
                own = known[
                    (known["track"] == track)
                    & known["method"].str.startswith(method)
                    & (known["isa"] == isa)
                ]
            if not len(own):
                yield f"{goal} on {isa} against {base}"
                continue
            cell = own.loc[own["ns"].idxmin()].to_dict()
            value = Interval(
                cell["times_points"],
                cell["times_points_low"],
                cell["times_points_high"],
                math.nan,
            )
            yield _row(goal, track, cell, base, value, least, "triangle")


def _exact(measured: Measured) -> Iterator[Row | str]:
    for scalar in FLOATS:
        for isa in EXACT_ISAS:
            for level, rival in (
                ("L1", EDGE),
                ("L1", ""),
                ("L3", ""),
                ("DRAM", ""),
            ):
                goal = "Exact answers for every input"
                if not rival and level == "L1":
                    goal += " (an aim)"
                own = measured.cell("one_triangle", scalar, level, EXACT, isa)
                other = (
                    measured.cell("one_triangle", scalar, level, rival, isa)
                    if rival
                    else measured.fastest_inexact(scalar, level, isa)
                )
                against = rival or "the fastest inexact"
                if own is None or other is None:
                    yield f"{goal} in {scalar} on {isa} from {level} against {against}"
                    continue
                if not rival:
                    against += f", {other['method']}"
                value = measured.times_as_fast(own, other)
                yield _row(goal, level, own, against, value, EXACT_OVER_INEXACT)


def _value(row: Row) -> str:
    return with_interval(row["value"], row["value_low"], row["value_high"])


def _bound(row: Row) -> str:
    return limit_columns.bound_words(row) if row["bound_of"] else NONE


def _wanted(row: Row) -> str:
    return f"≥ {row['wanted']:g}" if row["wanted"] == row["wanted"] else NONE


SHOWN: Final = (
    sentence("goal", "kernel"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    word("where", "from"),
    word("method", "method"),
    number("ns", "ns/unit", "a point, or a triangle where many are asked about"),
    limit_columns.OF_LIMIT,
    Column("bound by", _bound, numeric=False, wraps=True),
    sentence("against", "against"),
    Column("× as fast", _value, sort="value", hint="of a bound: the share reached"),
    Column("goal", _wanted, sort="wanted"),
    sentence("outcome", "outcome"),
)


def add(
    exhibits: Exhibits, run: Run, cells: pd.DataFrame, unfit: dict[str, frozenset[str]]
) -> Goals:
    found = goals(run, cells, unfit)
    if len(found.table):
        exhibits.table(
            KEY,
            "The goals of this benchmark for its kernels: how many times as fast as the "
            "row that a goal names, or which share of a bound, with 95 % intervals, all "
            "of fresh input.",
            found.table,
            SHOWN,
        )
    return found


def goal_facts(found: Goals) -> dict[str, Any]:
    counts = found.counts()
    return {
        **counts,
        "set_words": counted(counts["set"], "goal"),
        "missing": found.missing_words(),
        "missing_words": counted(len(set(found.missing)), "goal"),
        "missing_count": len(set(found.missing)),
    }
