"""What follows from speed and error together: one verdict a method, and which
to take. Every word of rank is decided here, from the tables.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.accuracy.accuracy_tables import hardest, speed_against_error
from analysis.accuracy.hardness import HARDNESSES
from analysis.charts.palette import method_rank
from analysis.read.run import MethodEntry
from analysis.report.wording import between, listed, share, times
from analysis.speed.tables import samples, widest_isa
from analysis.trust.placement import usual_spread
from analysis.trust.stats import Interval, ratio_interval, wilson

WHOLE = "triangle"  # the method decides the whole triangle

# The share of wrong answers on points spread evenly that somebody would notice:
# a wrong pixel in every picture of 100 × 100.
NOTICED = 1e-4

Samples = dict[tuple[str, str], npt.NDArray[np.float64]]


@dataclasses.dataclass(frozen=True)
class Advice:
    """Which method to take. most_right is the fastest of those that err as
    rarely as the best, as far as the intervals can tell; `alike` are those. Of
    several that are as fast it is the one that the report lists first.
    """

    fastest: str
    as_fast: tuple[str, ...]  # the others whose interval holds its time
    most_right: str
    as_right: tuple[str, ...]  # the others of `alike` that are as fast
    alike: tuple[str, ...]
    cost: float  # time of most_right over that of fastest
    cost_low: float
    cost_high: float


def unfit(
    accuracy: pd.DataFrame, entries: tuple[MethodEntry, ...], scalar: str
) -> frozenset[str]:
    """The methods that nobody should be sent to for their speed: those kept as
    a warning, and those that surely err on more than NOTICED of the points even
    where they are spread evenly. Surely: in some cell the low end of the Wilson
    interval lies above. (A single wrong answer in a million random points is a
    point that happened to lie near an edge, which says nothing of everyday
    input; the rates on hard input are for that.)
    """
    rows = accuracy[(accuracy["family"] == "uniform") & (accuracy["scalar"] == scalar)]
    wrong = (rows["false_inside"] + rows["false_outside"]).astype(int)
    of = (rows["interior"] + rows["exterior"] + rows["degenerate"]).astype(int)
    erring = {
        method
        for method, count, n in zip(rows["method"], wrong, of)
        if wilson(count, n).low > NOTICED
    }
    return frozenset(erring | {entry.key for entry in entries if entry.warning})


def verdicts(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    accuracy: pd.DataFrame,
    scalar: str,
    left_out: frozenset[str] = frozenset(),
) -> pd.DataFrame:
    """One row a method at the widest ISA: its time, that time over the fastest
    one's (of those that decide the whole triangle and are not left out, so
    that a method left out may take less than 1), its error rate
    near an edge, the largest one on needles and far away, and a verdict.
    """
    marks = speed_against_error(cells, accuracy, scalar)
    isa = widest_isa(marks)
    rows = marks[marks["isa"] == isa].reset_index(drop=True)
    if not len(rows):
        return rows.assign(verdict=[])
    by_cell = samples(speed)
    fastest = _fastest(rows, left_out)
    base = by_cell[fastest["shard"], fastest["name"]]
    same = usual_spread(speed)
    ratios = []
    for _, row in rows.iterrows():
        own = by_cell[row["shard"], row["name"]]
        itself = Interval(1.0, 1.0, 1.0, 1.0)
        ratios.append(itself if own is base else ratio_interval(own, base))
    extra = {
        f"worst_{hardness.family}": rows["method"].map(
            hardest(accuracy, hardness.family, hardness.key, scalar, str(isa))
        )
        for hardness in HARDNESSES
    }
    table = rows.assign(
        time_over_best=[ratio.value for ratio in ratios],
        time_over_best_low=[ratio.low for ratio in ratios],
        time_over_best_high=[ratio.high for ratio in ratios],
        **extra,
    )
    against = _Times(by_cell, same)
    texts = [_verdict(row, table, against) for _, row in table.iterrows()]
    return table.assign(verdict=texts)


@dataclasses.dataclass(frozen=True)
class _Times:
    """by_cell: the repetitions; same: up to this ratio times are alike, as moving
    code changes as much (trust.placement.usual_spread).
    """

    by_cell: Samples
    same: float

    def ratio(self, top: pd.Series, bottom: pd.Series) -> Interval:
        """How many times as long as `bottom` the row `top` takes."""
        above, below = (self.by_cell[r["shard"], r["name"]] for r in (top, bottom))
        return ratio_interval(above, below)

    def longer(self, top: pd.Series, bottom: pd.Series) -> bool:
        """Whether it surely takes longer."""
        return self.ratio(top, bottom).low > self.same


def _fastest(rows: pd.DataFrame, left_out: frozenset[str]) -> pd.Series:
    whole = rows[rows["accepts"].fillna(WHOLE) == WHOLE]
    fit = whole[~whole["method"].isin(left_out)]
    whole = fit if len(fit) else whole
    among = whole if len(whole) else rows
    return among.loc[among["ns"].idxmin()]


def advise(
    table: pd.DataFrame, left_out: frozenset[str] = frozenset(), same: float = 1.0
) -> Advice | None:
    """From the table of verdicts, made with the same methods left out; None if
    no answer was judged. `same`: up to this ratio times are alike.
    """
    known = table[(table["accepts"] == WHOLE) & table["error_rate"].notna()]
    fit = known[~known["method"].isin(left_out)]
    known = fit if len(fit) else known
    if not len(known):
        return None
    fastest = known.loc[known["ns"].idxmin()]
    best_high = known.loc[known["error_rate"].idxmin(), "error_rate_high"]
    alike = known[known["error_rate_low"] <= best_high]
    quickest = alike.loc[alike["ns"].idxmin()]
    until = quickest["time_over_best"] * same
    equals = sorted(
        alike[alike["time_over_best_low"] <= until]["method"], key=method_rank
    )
    most_right = alike[alike["method"] == equals[0]].iloc[0]
    return Advice(
        fastest=fastest["method"],
        as_fast=tuple(
            known[
                (known["time_over_best_low"] <= same)
                & (known["method"] != fastest["method"])
            ]["method"]
        ),
        most_right=most_right["method"],
        as_right=tuple(equals[1:]),
        alike=tuple(sorted(alike["method"], key=method_rank)),
        cost=most_right["time_over_best"],
        cost_low=most_right["time_over_best_low"],
        cost_high=most_right["time_over_best_high"],
    )


def _verdict(row: pd.Series, table: pd.DataFrame, against: _Times) -> str:
    if pd.isna(row["error_rate"]):
        return "its answers were not judged in this run"
    if row["accepts"] != WHOLE:
        refused = row["false_outside"] / max(row["interior"], 1)
        return (
            "decides another question: only the third of the triangle nearest to "
            f"vertex A, and so refuses {share(refused)} of the interior points near an edge"
        )
    whole = table[(table["accepts"] == WHOLE) & table["error_rate"].notna()]
    better = whole[
        (whole["ns"] <= row["ns"])
        & (whole["error_rate"] <= row["error_rate"])
        & [
            other["error_rate"] < row["error_rate"] or against.longer(row, other)
            for _, other in whole.iterrows()
        ]
    ]
    if len(better):
        order = better.sort_values(["error_rate", "ns"])
        first = order.iloc[0]
        equals = [
            other
            for _, other in order.iterrows()
            if other["error_rate"] == first["error_rate"]
            and not against.longer(other, first)
        ]
        best = min(equals, key=lambda other: method_rank(other["method"]))
        return _beaten(row, best, against)
    return _on_frontier(row, whole, against)


def _beaten(row: pd.Series, by: pd.Series, against: _Times) -> str:
    quicker = against.ratio(row, by)
    fast = (
        "takes as long"
        if quicker.low <= against.same
        else f"is {times(quicker.value)} as fast ({between(quicker.low, quicker.high)})"
    )
    if by["error_rate"] == row["error_rate"]:
        right = "errs as often"
    elif by["error_rate_high"] >= row["error_rate_low"]:
        right = "errs no more often"
    elif by["error_rate"] == 0:
        right = "does not err there"
    else:
        # At most as far apart as the ends of the two intervals are.
        low = row["error_rate_low"] / by["error_rate_high"]
        high = row["error_rate_high"] / by["error_rate_low"]
        ratio = times(row["error_rate"] / by["error_rate"])
        right = f"errs {ratio} less often ({between(low, high)})"
    return f"{by['method']} {fast} and {right}"


def _on_frontier(row: pd.Series, whole: pd.DataFrame, against: _Times) -> str:
    fastest = row["ns"] == whole["ns"].min()
    rightest = row["error_rate"] == whole["error_rate"].min()
    if fastest:
        others = whole[whole["method"] != row["method"]]
        equals = [
            str(other["method"])
            for _, other in others.iterrows()
            if not against.longer(other, row)
        ]
        fast = f"as fast as {listed(equals)}" if equals else "the fastest"
        if rightest:
            return f"{fast}, and none errs less"
        if equals:
            return f"{fast}, as far as the intervals can tell; others take longer"
        return f"{fast}; whatever errs less takes longer"
    errs = "does not err near an edge" if row["error_rate"] == 0 else "errs least"
    if rightest:
        return f"{errs}; whatever is faster errs more"
    least = whole["error_rate"].min()
    if least == 0:
        return "on the frontier: whatever is faster errs more"
    ratio = times(row["error_rate"] / least)
    return f"on the frontier: whatever is faster errs more ({ratio} the least)"
