"""Whether two runs differ, cell by cell, or only by noise.

Cells are matched by name. Three things keep a difference from being claimed:

* Chance. Each cell has an exact test of its repetitions in both runs, and the
  many tests are corrected (stats.benjamini_hochberg): at most `level` of the
  claimed differences are false in expectation.
* What the runs themselves say they can tell apart. A kernel timed twice in one
  run must have a ratio of 1; where it strayed in a shard of either run, or the
  shard's clock moved or some of its time went to others, both shards' cells may
  differ by as much before anything is tested, and never by less than TOLERANCE,
  below which no difference matters here. On CPUs of one model the cells may
  also differ by as much as the clocks of their shards did.
* Where the code lies. Between two builds that differ, a kernel may also differ
  by what moving it changed: its own placement spread, as far as that is sure,
  or where it has none the median of those measured.

Repetitions say nothing of what differs between two starts of one program, nor
of a machine that was slower for all of a shard; the A/A pairs do not either.
Take a difference that all cells of a shard show for one of the day.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.read.cells import TWIN
from analysis.read.read_json import LoadError
from analysis.read.run import CLASSES, Run, Shard
from analysis.speed.tables import CELL_KEYS, samples, sort_cells, speed_cells
from analysis.trust import noise
from analysis.trust.controls import control_pairs
from analysis.trust.placement import placements, spreads
from analysis.trust.row_noise import TOLERANCE
from analysis.trust.stats import (
    benjamini_hochberg,
    median_interval,
    ratio_interval,
    ratio_p_value,
    wilson,
)

LEVEL: Final = 0.05
SLOWER, FASTER, NO_DIFFERENCE = "slower", "faster", "no difference"
CELL_COLUMNS: Final = [
    "shard",
    "name",
    *CELL_KEYS,
    "a_ns",
    "b_ns",
    "ratio",
    "ratio_low",
    "ratio_high",
] + ["within", "p", "adjusted", "verdict", "noise"]
# Points that truth counts: the same numbers of them mean the same input.
_POINTS: Final = ["points", "interior", "exterior", "boundary"] + [
    "degenerate",
    "not_finite",
]
ACCURACY_COLUMNS: Final = ["name", *CELL_KEYS, "kind", "a", "a_of", "b", "b_of"] + [
    "a_rate",
    "a_low",
    "a_high",
    "b_rate",
    "b_low",
    "b_high",
    "exact",
    "verdict",
]
WORSE, BETTER, OTHER = "more errors", "fewer errors", "another choice"
OTHER_INPUT: Final = "differs on other input"


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Of run B against run A; a ratio is the time of B over that of A."""

    a: Run
    b: Run
    level: float
    cells: pd.DataFrame  # CELL_COLUMNS, a row a cell of both
    only_a: int
    only_b: int
    accuracy: pd.DataFrame  # ACCURACY_COLUMNS, a row a class that differs
    judged: int  # cells whose answers both runs judged
    same_input: int  # of these, on the very same input
    noise_a: noise.Verdict
    noise_b: noise.Verdict
    same_build: bool

    @property
    def regressions(self) -> pd.DataFrame:
        """Cells that take longer in B, the worst first."""
        slower = self.cells[self.cells["verdict"] == SLOWER]
        return slower.sort_values("ratio", ascending=False, kind="stable")

    @property
    def improvements(self) -> pd.DataFrame:
        faster = self.cells[self.cells["verdict"] == FASTER]
        return faster.sort_values("ratio", kind="stable")

    @property
    def more_errors(self) -> pd.DataFrame:
        return self.accuracy[self.accuracy["verdict"] == WORSE]

    @property
    def worse(self) -> bool:
        return bool(len(self.regressions) or len(self.more_errors))


def compare(
    a: Run, b: Run, level: float = LEVEL, across_revisions: bool = False
) -> Comparison:
    """Raises LoadError where the runs cannot be compared."""
    if not across_revisions:
        refuse_other_kernels(a, b)
    same = same_build(a, b)
    cells = compared_cells(a, b, level, same)
    if cells.empty:
        raise LoadError(
            f"{a.name} and {b.name} have no cell in common: compare runs of one profile"
        )
    names_a, names_b = _plain_names(a.speed), _plain_names(b.speed)
    accuracy, judged, same_input = compared_accuracy(a, b, level)
    return Comparison(
        a=a,
        b=b,
        level=level,
        cells=cells,
        only_a=len(names_a - names_b),
        only_b=len(names_b - names_a),
        accuracy=accuracy,
        judged=judged,
        same_input=same_input,
        noise_a=noise.judge(a.speed, a.shards),
        noise_b=noise.judge(b.speed, b.shards),
        same_build=same,
    )


def refuse_other_kernels(a: Run, b: Run) -> None:
    """Raises LoadError unless both runs measured the same kernels: by their
    hash, or, where an older run has none, by a clean revision.
    """
    hashes = (a.machine.kernel_hash, b.machine.kernel_hash)
    if all(hashes):
        if hashes[0] == hashes[1]:
            return
        why = f"measured other kernels (hash {hashes[0][:12]} and {hashes[1][:12]})"
    else:
        revisions = {a.machine.revision, b.machine.revision}
        if len(revisions) == 1 and not (a.machine.dirty or b.machine.dirty):
            return
        why = (
            "may have measured other kernels (one does not tell their hash, and "
            f"they are of revision {_revision(a)} and {_revision(b)})"
        )
    raise LoadError(
        f"{a.name} and {b.name} {why}: what differs is then not the CPU alone. "
        "Measure both at one revision, or give --across-revisions to compare code"
    )


def _revision(run: Run) -> str:
    return run.machine.revision[:12] + (" (dirty)" if run.machine.dirty else "")


def same_build(a: Run, b: Run) -> bool:
    """Whether kernels of both lie in memory as the same compiler put them."""
    first, second = a.machine, b.machine
    same_code = (
        first.kernel_hash == second.kernel_hash
        if first.kernel_hash and second.kernel_hash
        else first.revision == second.revision and not first.dirty
    )
    return same_code and first.dirty == second.dirty and compiled_alike(a, b)


def compiled_alike(a: Run, b: Run) -> bool:
    """Whether the kernel files of both were compiled by one compiler, with the
    same flags.
    """
    flags = [
        {(source, isas): text for source, isas, text in run.machine.flags}
        for run in (a, b)
    ]
    return a.machine.compiler == b.machine.compiler and all(
        flags[0][file] == flags[1][file] for file in flags[0].keys() & flags[1].keys()
    )


def compared_cells(a: Run, b: Run, level: float, same: bool) -> pd.DataFrame:
    """CELL_COLUMNS, one row a cell that both runs timed, controls left out.
    `same`: whether both are of one build, so that code lies alike.
    """
    cells_a, cells_b = speed_cells(a.speed), speed_cells(b.speed)
    both = cells_a.merge(
        cells_b[["shard", "name", "ns", "noise"]], on="name", suffixes=("", "_b")
    )
    of_a, of_b = samples(a.speed), samples(b.speed)
    strayed = [strays(a), strays(b)]
    clocks = [{shard.name: shard.clock_ghz for shard in run.shards} for run in (a, b)]
    one_model = a.machine.same_cpu(b.machine)
    moved = {} if same else placement_limits([a.speed, b.speed])
    usual = float(np.median(list(moved.values()))) if moved else 0.0
    rows = []
    for cell in both.to_dict("records"):
        top = of_b[cell["shard_b"], cell["name"]]
        bottom = of_a[cell["shard"], cell["name"]]
        ratio = ratio_interval(top, bottom)
        stray = max(
            TOLERANCE,
            strayed[0][cell["shard"]],
            strayed[1][cell["shard_b"]],
        )
        if one_model:
            apart = clocks[1][cell["shard_b"]] / clocks[0][cell["shard"]]
            stray = max(stray, apart - 1, 1 / apart - 1)
        within = max(stray, moved.get(cell["name"], usual))
        rows.append(
            {
                **{key: cell[key] for key in ("shard", "name", *CELL_KEYS)},
                "a_ns": cell["ns"],
                "b_ns": cell["ns_b"],
                "ratio": ratio.value,
                "ratio_low": ratio.low,
                "ratio_high": ratio.high,
                "within": within,
                "p": ratio_p_value(top, bottom, within),
                "noise": _noise(cell["noise"], cell["noise_b"]),
            }
        )
    adjusted = benjamini_hochberg([row["p"] for row in rows])
    for row, value in zip(rows, adjusted):
        verdict = SLOWER if row["ratio"] > 1 else FASTER
        row |= {"adjusted": value}
        row |= {"verdict": verdict if value <= level else NO_DIFFERENCE}
    return sort_cells(pd.DataFrame(rows, columns=CELL_COLUMNS))


def _noise(a: str, b: str) -> str:
    return " and ".join(["A"] * bool(a) + ["B"] * bool(b))


def strays(run: Run) -> dict[str, float]:
    """Shard → by how much a time in it may be off: the most that a kernel timed
    twice differed in it (in the whole run, if the shard has no such pair), that
    its clock moved, or that a share of its time that went to others makes a
    repetition longer.
    """
    pairs = control_pairs(run.speed)
    twins = pairs[pairs["control"] == TWIN]
    apart = {
        shard: float(np.exp(np.abs(np.log(group["ratio"])).max())) - 1
        for shard, group in twins.groupby("shard")
    }
    most = max(apart.values(), default=0.0)
    return {
        shard.name: max(apart.get(shard.name, most), _moved(shard), _lost(shard))
        for shard in run.shards
    }


def _moved(shard: Shard) -> float:
    """By how much the clock changed from the start to the end of the shard."""
    return abs(shard.clock_after_ghz / shard.clock_before_ghz - 1)


def _lost(shard: Shard) -> float:
    """A share s of lost time makes a repetition 1 / (1 − s) times as long."""
    kept = shard.cpu_seconds / shard.wall_seconds
    kept = min(kept, 1 - shard.steal_percent / 100) if kept == kept else 1.0
    return 1 / kept - 1 if 0 < kept < 1 else 0.0


def placement_limits(speeds: list[pd.DataFrame]) -> dict[str, float]:
    """Cell → what moving its code surely changes, the larger of the runs."""
    found: dict[str, float] = {}
    for speed in speeds:
        for row in spreads(speed, placements(speed)).to_dict("records"):
            name = "/".join(str(row[key]) for key in CELL_KEYS)
            found[name] = max(found.get(name, 0.0), row["spread_low"] - 1)
    return found


def _plain_names(speed: pd.DataFrame) -> set[str]:
    return set(speed.loc[speed["control"] == "", "name"])


def summary(cells: pd.DataFrame, key: str) -> pd.DataFrame:
    """One row an ISA, or a method (`key`): how many cells are slower, faster or
    neither, the median of their ratios and the interval of that median.
    """
    rows = []
    for value, group in cells.groupby(key, sort=True):
        middle = median_interval(group["ratio"].to_numpy(dtype=np.float64))
        rows.append(
            {
                key: value,
                "cells": len(group),
                "slower": int((group["verdict"] == SLOWER).sum()),
                "faster": int((group["verdict"] == FASTER).sum()),
                "ratio": middle.value,
                "ratio_low": middle.low,
                "ratio_high": middle.high,
            }
        )
    columns = [key, "cells", "slower", "faster", "ratio", "ratio_low", "ratio_high"]
    return sort_cells(pd.DataFrame(rows, columns=columns), [key])


def compared_accuracy(a: Run, b: Run, level: float) -> tuple[pd.DataFrame, int, int]:
    """The classes of failures that differ (ACCURACY_COLUMNS); of how many cells;
    and how many of these were on the same input.

    Input is made from the seed, so of one seed and of as many points of each
    kind it is the same, and then any difference in a count is one. Else two
    shares differ if their intervals, which hold all at once with 1 − level
    (Bonferroni), do not overlap; but intervals count points, many of which share
    a triangle, so that this tells of the input and is no verdict on a kernel.
    """
    both = a.accuracy.merge(
        b.accuracy.drop(columns=CELL_KEYS), on="name", suffixes=("", "_b")
    )
    alike: npt.NDArray[np.bool_] = np.full(
        len(both), a.machine.seed == b.machine.seed, dtype=bool
    )
    for key in _POINTS:
        alike &= (both[key] == both[f"{key}_b"]).to_numpy()
    tests = 2 * sum(int(both[f"{kind}_of"].notna().sum()) for kind in CLASSES)
    confidence = 1 - level / max(tests, 1)
    rows = []
    for kind in CLASSES:
        counts = both[[kind, f"{kind}_of", f"{kind}_b", f"{kind}_of_b"]]
        counts = counts.astype(float)
        ones, twos = counts[kind], counts[f"{kind}_b"]
        share_a = ones / counts[f"{kind}_of"]
        differs = (share_a != twos / counts[f"{kind}_of_b"]) & share_a.notna()
        differs &= counts[f"{kind}_of_b"] > 0
        for index in np.flatnonzero(differs.to_numpy()):
            n, of, n_b, of_b = (int(value) for value in counts.iloc[index])
            exact = bool(alike[index]) and of == of_b
            if not exact and _overlap(
                wilson(n, of, confidence), wilson(n_b, of_b, confidence)
            ):
                continue
            first, second = wilson(n, of), wilson(n_b, of_b)
            worse = WORSE if second.value > first.value else BETTER
            cell = both.iloc[index]
            rows.append(
                {
                    **{key: cell[key] for key in ("name", *CELL_KEYS)},
                    "kind": kind,
                    **{"a": n, "a_of": of, "b": n_b, "b_of": of_b},
                    "a_rate": first.value,
                    "a_low": first.low,
                    "a_high": first.high,
                    "b_rate": second.value,
                    "b_low": second.low,
                    "b_high": second.high,
                    "exact": exact,
                    "verdict": _verdict(exact, kind, worse),
                }
            )
    table = sort_cells(pd.DataFrame(rows, columns=ACCURACY_COLUMNS))
    table = table.sort_values("exact", ascending=False, kind="stable")
    return table.reset_index(drop=True), len(both), int(alike.sum())


def _verdict(exact: bool, kind: str, worse: str) -> str:
    """Which points of the boundary are inside is a method's own choice."""
    if not exact:
        return OTHER_INPUT
    return OTHER if kind == "boundary_accepted" else worse


def _overlap(first: Any, second: Any) -> bool:
    return bool(first.low <= second.high and second.low <= first.high)


def clock_ratio(a: Run, b: Run) -> float:
    """The median clock of B over that of A; NaN without shards."""
    clocks = [[shard.clock_ghz for shard in run.shards] for run in (a, b)]
    if not all(clocks):
        return math.nan
    return float(np.median(clocks[1]) / np.median(clocks[0]))
