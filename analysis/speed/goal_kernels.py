"""The kernels that goals speak of, found among the cells of a run."""

from __future__ import annotations

from typing import Any, Final

import pandas as pd

from analysis.charts.palette import is_autovec, isa_rank
from analysis.read.cells import parse_scene
from analysis.read.run import Run
from analysis.report.method_families import is_exact
from analysis.report.verdicts import WHOLE
from analysis.report.wording import size_in_bytes
from analysis.speed.tables import parameter, reference_scene, samples
from analysis.trust.stats import Interval, ratio_interval

EDGE: Final = "edge_function_fma"
EXACT: Final = "exact"
Row = dict[str, Any]


class Measured:
    """alone: the cells of one CPU; widest: of the ISAs written by hand."""

    def __init__(
        self, run: Run, cells: pd.DataFrame, unfit: dict[str, frozenset[str]]
    ) -> None:
        self.alone = cells[~(cells["threads"] > 1)].reset_index(drop=True)
        isas = [isa for isa in self.alone["isa"].unique() if not is_autovec(isa)]
        self.two_widest = sorted(isas, key=isa_rank, reverse=True)[:2]
        self.widest = self.two_widest[0] if isas else ""
        self._samples = samples(run.speed)
        self._warned = {entry.key for entry in run.methods if entry.warning}
        part = {entry.key for entry in run.methods if entry.accepts != WHOLE}
        self._unfit = {
            scalar: part | self._warned | own for scalar, own in unfit.items()
        }
        self._others = part | self._warned
        uniform = self.alone[
            (self.alone["family"] == "uniform")
            & ~self.alone["scene"].str.contains("sets=fixed", regex=False)
        ]
        hit = parameter(uniform, "hit").astype(float)
        self._uniform = uniform[hit.isna() | (hit == 50)]

    def unfit(self, scalar: str) -> set[str]:
        """Methods that are not to be taken, however fast."""
        return self._unfit.get(scalar, self._others)

    def scene(self, loop: str, scalar: str, level: str) -> pd.DataFrame:
        """The cells of the scene whose data lie there: the reference scene in the
        nearest level; elsewhere that on which most methods were timed, the largest of
        several.
        """
        rows = self._uniform[
            (self._uniform["loop"] == loop) & (self._uniform["scalar"] == scalar)
        ]
        if level == "L1":
            return rows[rows["scene"] == reference_scene(self.alone, loop)]
        if "level" not in rows:
            return rows.iloc[:0]
        rows = rows[rows["level"] == level]
        if not len(rows):
            return rows
        sizes = rows.groupby("scene").agg(
            methods=("method", "nunique"), size=("working_set_bytes", "max")
        )
        chosen = sizes.sort_values(["methods", "size"]).index[-1]
        return rows[rows["scene"] == chosen]

    def cell(
        self, loop: str, scalar: str, level: str, method: str, isa: str = ""
    ) -> Row | None:
        rows = self.scene(loop, scalar, level)
        rows = rows[(rows["method"] == method) & (rows["isa"] == (isa or self.widest))]
        return dict(rows.iloc[0]) if len(rows) else None

    def best(self, loop: str, scalar: str, level: str) -> Row | None:
        """The fastest at the widest ISA of what may be taken."""
        rows = self.scene(loop, scalar, level)
        rows = rows[
            (rows["isa"] == self.widest) & ~rows["method"].isin(self.unfit(scalar))
        ]
        return dict(rows.loc[rows["ns"].idxmin()]) if len(rows) else None

    def fastest_inexact(self, scalar: str, level: str, isa: str) -> Row | None:
        """Of all that promises less, but for what is kept as a warning."""
        rows = self.scene("one_triangle", scalar, level)
        promises = rows["method"].map(is_exact).astype(bool)
        rows = rows[
            (rows["isa"] == isa) & ~promises & ~rows["method"].isin(self._warned)
        ]
        return dict(rows.loc[rows["ns"].idxmin()]) if len(rows) else None

    def times_as_fast(self, own: Row, other: Row) -> Interval:
        if own["name"] == other["name"]:
            return Interval(1.0, 1.0, 1.0, 1.0)
        return ratio_interval(
            self._samples[other["shard"], other["name"]],
            self._samples[own["shard"], own["name"]],
        )

    def size_words(self, cell: Row) -> str:
        return size_in_bytes(cell["working_set_bytes"])
