"""Several runs side by side: the run at hand, and those kept in report/runs/.

All on one scene, the reference scene of the run at hand. A ratio is the time
on a CPU over that of the run at hand, for the same method; its interval is
that of the repetitions and knows nothing of what differs between two starts.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, Final

import numpy as np
import pandas as pd

from analysis.accuracy.accuracy_tables import isa_agreement
from analysis.charts.palette import is_autovec, isa_rank, method_rank
from analysis.cpus.compare import compared_accuracy
from analysis.cpus.run_labels import code_state, label_of, widest
from analysis.cpus.stored_run import fingerprint
from analysis.models.modelled import LOOP
from analysis.peers.peers_tables import part
from analysis.read.run import Run
from analysis.speed.bounds import with_bounds
from analysis.speed.tables import (
    reference_scene,
    samples,
    speed_cells,
    widest_isa,
)
from analysis.trust import noise
from analysis.trust.stats import Values, median_interval, ratio_interval

HERE: Final = "this run"
ROW_COLUMNS: Final = ["run", "method", "isa", "ns", "ns_low", "ns_high", "cycles"] + [
    "of_limit",
    "ratio",
    "ratio_low",
    "ratio_high",
    "cycles_ratio",
    "noise",
]
_EDGE: Final = ("", "_low", "_high")


@dataclasses.dataclass(frozen=True)
class Cpu:
    """A run among others: what it is called, and its rows on the scene."""

    name: str  # HERE, or the label of a stored run
    run: Run
    noise: str
    state: str  # of its kernels against the code: current, stale, not told
    rows: pd.DataFrame
    times: dict[tuple[str, str], Values]  # (method, ISA) → its repetitions


def others_of(run: Run, stored: Sequence[Run]) -> list[Run]:
    """The stored runs but the run at hand itself."""
    own = fingerprint(run)
    return [kept for kept in stored if fingerprint(part(kept).ours) != own]


def cpus(run: Run, stored: Sequence[Run], scalar: str) -> list[Cpu]:
    """The run at hand first, then the others by name."""
    scene: str | None = None
    found: list[Cpu] = []
    labels = [HERE, *_labels(stored)]
    for name, each in zip(labels, [run, *stored], strict=True):
        ours = part(each).ours
        timed = speed_cells(ours.speed)
        cells = timed[(timed["scalar"] == scalar) & (timed["threads"] == 1)]
        if not found:
            scene = reference_scene(cells, LOOP)
        cells = cells[(cells["loop"] == LOOP) & (cells["scene"] == scene)]
        cells = with_bounds(cells, ours.limits, ours.operations)
        by_cell = samples(ours.speed)
        times: dict[tuple[str, str], Values] = {
            (row["method"], row["isa"]): by_cell[row["shard"], row["name"]]
            for row in cells.to_dict("records")
        }
        base = found[0].times if found else times
        found.append(
            Cpu(
                name,
                each,
                noise.judge(ours.speed, each.shards, timed).word,
                code_state(each),
                _rows(name, each, cells, times, base),
                times,
            )
        )
    return found


def _labels(runs: Sequence[Run]) -> list[str]:
    """The label of each, with its folder's name where two are the same."""
    labels = [label_of(run) for run in runs]
    return [
        label if labels.count(label) == 1 else f"{label} ({run.name})"
        for label, run in zip(labels, runs)
    ]


def _rows(
    name: str,
    run: Run,
    cells: pd.DataFrame,
    times: dict[tuple[str, str], Values],
    base: dict[tuple[str, str], Values],
) -> pd.DataFrame:
    """ROW_COLUMNS of one run: against the same method and ISA of the run at
    hand (`base`), NaN where it has no such row.
    """
    clock = {shard.name: shard.clock_ghz for shard in run.shards}
    rows = []
    for cell in cells.to_dict("records"):
        kernel = (cell["method"], cell["isa"])
        rows.append(
            {
                "run": name,
                **{k: cell[k] for k in ("method", "isa", "ns", "ns_low", "ns_high")},
                "cycles": cell["ns"] * clock[cell["shard"]],
                "of_limit": cell.get("of_limit", np.nan),
                **_ratio(name, times[kernel], base.get(kernel)),
                "noise": cell["noise"],
            }
        )
    return pd.DataFrame(rows, columns=ROW_COLUMNS)


def _ratio(name: str, top: Values, bottom: Values | None) -> dict[str, float]:
    values: tuple[float, ...] = (np.nan,) * 3
    if name == HERE:
        values = (1.0,) * 3
    elif bottom is not None:
        values = ratio_interval(top, bottom)[:3]
    return {f"ratio{end}": value for end, value in zip(_EDGE, values)}


def with_cycles_ratio(found: Sequence[Cpu]) -> pd.DataFrame:
    """The rows of all, with the cycles over those of the run at hand."""
    table = pd.concat([cpu.rows for cpu in found], ignore_index=True)
    own = found[0].rows.set_index(["method", "isa"])["cycles"]
    keys = pd.MultiIndex.from_frame(table[["method", "isa"]])
    return table.assign(cycles_ratio=table["cycles"] / own.reindex(keys).to_numpy())


def isa_table(found: Sequence[Cpu]) -> pd.DataFrame:
    """One row an ISA and run: of the methods with a row in the run at hand too,
    the median ratio and its interval, the median ratio of cycles, and over all
    its methods the median cycles and share of the limit.
    """
    table = with_cycles_ratio(found)
    order = [cpu.name for cpu in found]
    rows = []
    for (isa, name), group in table.groupby(["isa", "run"], sort=False):
        known = group.dropna(subset=["ratio"])
        middle: tuple[float, ...] = (np.nan,) * 3
        if name == HERE:
            middle = (1.0,) * 3
        elif len(known):
            middle = median_interval(known["ratio"].to_numpy(dtype=np.float64))[:3]
        rows.append(
            {
                "isa": isa,
                "run": name,
                "methods": len(group),
                "compared": len(known),
                **{f"ratio{end}": value for end, value in zip(_EDGE, middle)},
                "least": known["ratio"].min(),
                "most": known["ratio"].max(),
                "cycles_ratio": known["cycles_ratio"].median(),
                "cycles": group["cycles"].median(),
                "of_limit": group["of_limit"].median(),
            }
        )
    columns = ["isa", "run", "methods", "compared", "ratio", "ratio_low", "ratio_high"]
    columns += ["least", "most", "cycles_ratio", "cycles", "of_limit"]
    rows.sort(key=lambda row: (isa_rank(str(row["isa"])), order.index(str(row["run"]))))
    return pd.DataFrame(rows, columns=columns)


def method_table(found: Sequence[Cpu]) -> pd.DataFrame:
    """One row a method and run, each on the widest ISA of its run; the ratios are
    over the run at hand on its own widest ISA.
    """
    tops = [_at_widest(cpu.rows) for cpu in found]
    own = tops[0].set_index("method")
    order = [cpu.name for cpu in found]
    rows = []
    for cpu, top in zip(found, tops):
        for row in top.to_dict("records"):
            method = row["method"]
            mine = own.loc[method] if method in own.index else None
            bottom = None if mine is None else found[0].times[method, mine["isa"]]
            row |= _ratio(cpu.name, cpu.times[method, row["isa"]], bottom)
            if mine is not None:
                row |= {"cycles_ratio": row["cycles"] / mine["cycles"]}
            rows.append(row)
    rows.sort(key=lambda r: (method_rank(str(r["method"])), order.index(str(r["run"]))))
    return pd.DataFrame(rows, columns=ROW_COLUMNS)


def _at_widest(rows: pd.DataFrame) -> pd.DataFrame:
    return rows[rows["isa"] == widest_isa(rows)]


def overview(found: Sequence[Cpu]) -> pd.DataFrame:
    """One row a run: what it is of, and how far it may be believed."""
    rows = []
    for cpu in found:
        clocks = [shard.clock_ghz for shard in cpu.run.shards]
        agreement = isa_agreement(part(cpu.run).ours.accuracy)
        rows.append(
            {
                "run": cpu.name,
                "model": cpu.run.machine.name,
                "isas": widest(cpu.run),
                "clock_ghz": float(np.median(clocks)),
                "profile": cpu.run.profile,
                "revision": cpu.run.machine.revision[:12],
                "kernels": cpu.state,
                "noise": cpu.noise,
                "groups": len(agreement),
                "apart": int((~agreement["agree"].astype(bool)).sum()),
                "folder": cpu.run.name,
            }
        )
    return pd.DataFrame(rows)


def answers(found: Sequence[Cpu], level: float) -> pd.DataFrame:
    """Counts of failures that differ from those of the run at hand, by run."""
    parts = []
    for cpu in found[1:]:
        table, judged, same = compared_accuracy(found[0].run, cpu.run, level)
        exact = table[table["exact"].astype(bool)]
        parts.append(
            {
                "run": cpu.name,
                "judged": judged,
                "same_input": same,
                "differ": exact["name"].nunique(),
                "methods": ", ".join(sorted(set(exact["method"]), key=method_rank)),
            }
        )
    columns = ["run", "judged", "same_input", "differ", "methods"]
    return pd.DataFrame(parts, columns=columns)


def models(found: Sequence[Cpu], scalar: str) -> pd.DataFrame:
    """Modelled, not measured: one row a model of a CPU, the median over methods
    of its cycles over those measured here on the same ISA.
    """
    own = found[0].rows[["method", "isa", "cycles"]]
    modelled = found[0].run.modelled
    modelled = modelled[(modelled["scalar"] == scalar) & (modelled["loop"] == LOOP)]
    both = modelled.merge(own, on=["method", "isa"], suffixes=("", "_here"))
    rows = []
    for (model, isa), group in both.groupby(["model", "isa"], sort=True):
        ratio = (group["cycles"] / group["cycles_here"]).astype(float)
        middle = median_interval(ratio.to_numpy(dtype=np.float64))
        rows.append(
            {
                "model": model,
                "isa": isa,
                "methods": len(group),
                **{f"ratio{end}": v for end, v in zip(_EDGE, middle[:3])},
                "least": ratio.min(),
                "most": ratio.max(),
                "own": model == found[0].run.nearest_model,
            }
        )
    columns = ["model", "isa", "methods", "ratio", "ratio_low", "ratio_high"]
    return pd.DataFrame(rows, columns=[*columns, "least", "most", "own"])


def written_isas(table: pd.DataFrame) -> list[str]:
    """The ISAs with hand-written vectors, narrowest first."""
    isas = {isa for isa in table["isa"] if not is_autovec(isa)}
    return sorted(isas, key=isa_rank)
