"""What a claim is tested on, and what a test finds."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from typing import Final

import pandas as pd

from analysis.accuracy.accuracy_tables import error_rates
from analysis.charts.palette import isa_rank
from analysis.read.run import Run
from analysis.report.wording import share, share_between, with_interval
from analysis.speed.tables import method_ratio, reference_cells, widest_isa
from analysis.trust.stats import CONFIDENCE, Interval

HOLDS: Final = "holds"
PARTLY: Final = "holds with a condition"
FAILS: Final = "does not hold"
UNTESTED: Final = "cannot be tested here"

MAIN_LOOP: Final = "one_triangle"


@dataclasses.dataclass(frozen=True)
class Evidence:
    """A run, its timed cells that methods are compared by (`cells`), and all
    that were timed (`timed`).
    """

    run: Run
    cells: pd.DataFrame
    timed: pd.DataFrame


@dataclasses.dataclass(frozen=True)
class Finding:
    """`figure`: what was found, with its interval where it was measured; `why`:
    what the verdict rests on, in a sentence or two.
    """

    verdict: str
    figure: str
    why: str


Test = Callable[[Evidence], Finding]


def not_measured(what: str) -> Finding:
    return Finding(UNTESTED, "–", f"This run has no {what}.")


def judged(holds: bool, partly: bool) -> str:
    return HOLDS if holds else PARTLY if partly else FAILS


@dataclasses.dataclass(frozen=True)
class TimeRatio:
    """The time of one method over that of another, of the same scene, scalar and
    ISA, from one interleaved shard.
    """

    ratio: Interval
    scalar: str
    isa: str

    @property
    def figure(self) -> str:
        return with_interval(self.ratio.value, self.ratio.low, self.ratio.high)

    @property
    def place(self) -> str:
        return f"{self.scalar} on {self.isa}"


def time_ratio(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    top: str,
    bottom: str,
    scalar: str = "f32",
    loop: str = MAIN_LOOP,
) -> TimeRatio | None:
    """On the reference scene, at the widest ISA that has both; None without."""
    rows = reference_cells(cells, scalar, loop)
    for isa in sorted(set(rows["isa"]), key=isa_rank, reverse=True):
        ratio = method_ratio(speed, rows[rows["isa"] == isa], top, bottom)
        if ratio:
            return TimeRatio(ratio, scalar, isa)
    return None


def at_widest(
    accuracy: pd.DataFrame, scalar: str, loop: str = MAIN_LOOP
) -> pd.DataFrame:
    """The judged cells of the scalar in the loop, at the widest ISA."""
    rows = accuracy[(accuracy["scalar"] == scalar) & (accuracy["loop"] == loop)]
    isa = widest_isa(rows) if len(rows) else None
    return rows[rows["isa"] == isa].reset_index(drop=True)


def error_share(cells: pd.DataFrame, method: str) -> Interval | None:
    """The share of wrong answers of a method, its cells pooled; None without."""
    own = cells[cells["method"] == method]
    if not len(own):
        return None
    rate = error_rates(own, ["method"]).iloc[0]
    low, high = rate["error_rate_low"], rate["error_rate_high"]
    return Interval(rate["error_rate"], low, high, CONFIDENCE)


def share_figure(share_of: Interval) -> str:
    """5.4 % (5.3 to 5.5 %)."""
    ends = share_between(share_of.low, share_of.high)
    return f"{share(share_of.value)} ({ends})"
