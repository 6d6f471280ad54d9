"""Other libraries beside the kernels: what of a run is theirs, and the table
that compares them.

Their rows carry the ISA `library`. Everything else in the report is about the
kernels of pitbench alone, so the two are parted first.
"""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.accuracy.accuracy_tables import accuracy_loop, error_rates
from analysis.charts.palette import LIBRARY, method_rank
from analysis.read.run import MethodEntry, RayRun, Run
from analysis.report.wording import share
from analysis.speed.tables import CELL_KEYS, reference_scene, samples
from analysis.trust.stats import ratio_interval

EXACT = "exact"
WHOLE = "triangle"
GRID = "grid"
# The families of hard scenes whose pooled error rate is a column.
FAMILIES = ("near_edge", "needle", "offset")
RATIOS = ("times_best", "times_exact")
# The frames of a run in which both stand.
FRAMES: Final = ("speed", "refused", "accuracy", "worst")


@dataclasses.dataclass(frozen=True)
class Parted:
    """A run without the libraries' rows, and a run of these alone."""

    ours: Run
    peers: Run

    @property
    def timed(self) -> bool:
        """Whether a call of a library was timed."""
        return bool(len(self.peers.speed))


def part(run: Run) -> Parted:
    """The rows of the kernels, and those of other libraries; of rays as well."""

    def only(libraries: bool) -> Run:
        return dataclasses.replace(
            run,
            methods=_methods(run, libraries),
            rays=part_of_rays(run.rays, libraries),
            **_frames(run, FRAMES, libraries),
        )

    return Parted(only(False), only(True))


def part_of_rays(rays: RayRun, libraries: bool) -> RayRun:
    return dataclasses.replace(
        rays,
        methods=_methods(rays, libraries),
        **_frames(rays, (*FRAMES, "tuv"), libraries),
    )


def _frames(
    run: Run | RayRun, names: tuple[str, ...], libraries: bool
) -> dict[str, pd.DataFrame]:
    """The rows of libraries, or all others; a frame without one as it is."""
    chosen = {}
    for name in names:
        frame: pd.DataFrame = getattr(run, name)
        wanted = (frame["isa"] == LIBRARY) == libraries
        chosen[name] = frame if wanted.all() else frame[wanted].reset_index(drop=True)
    return chosen


def _methods(run: Run | RayRun, libraries: bool) -> tuple[Any, ...]:
    keys = {
        str(method)
        for frame in (run.speed, run.refused, run.accuracy)
        for method in frame[frame["isa"] == LIBRARY]["method"]
    }
    return tuple(m for m in run.methods if (m.key in keys) == libraries)


def peers_table(
    parted: Parted, ours: pd.DataFrame, peers: pd.DataFrame, loop: str
) -> pd.DataFrame:
    """One row a call × scalar, on the loop's reference scene (for calls that
    have only loop grid, on the grid): its time, that time over the fastest
    kernel's and over that of the fastest kernel of the method `exact`, both of
    the same shard, and its error rates. NaN where there is nothing to compare
    with. `ours`, `peers`: speed_cells of the two halves.
    """
    by_cell = samples(pd.concat([parted.ours.speed, parted.peers.speed]))
    entries = {entry.key: entry for entry in parted.peers.methods}
    versions = dict(parted.peers.machine.libraries)
    warned = {entry.key for entry in parted.ours.methods if entry.warning}
    partial = set(
        parted.ours.accuracy[parted.ours.accuracy["accepts"] != WHOLE]["method"]
    )
    rivals = ours[~ours["method"].isin(warned | partial)]
    rows = []
    for _, cell in _reference(peers, ours, loop).iterrows():
        library = str(cell["method"]).partition("_")[0]
        entry = entries.get(cell["method"])
        row = {key: cell[key] for key in ["shard", "name", "family", *CELL_KEYS]}
        row |= {key: cell[key] for key in ("ns", "ns_low", "ns_high")}
        again = str(cell["name"]).replace("sets=fresh", "sets=fixed")
        fixed = peers[peers["name"] == again]["ns"]
        row["fixed_ns"] = fixed.iloc[0] if len(fixed) else math.nan
        row |= {
            "library": entry.source if entry else library,
            "version": versions.get(library, ""),
            "called": entry.formula if entry else "",
        }
        same = rivals[
            (rivals["shard"] == cell["shard"])
            & (rivals["scene"] == cell["scene"])
            & (rivals["loop"] == cell["loop"])
        ]
        row |= _over("times_best", by_cell, cell, same)
        row |= _over("times_exact", by_cell, cell, same[same["method"] == EXACT])
        judged = parted.peers.accuracy
        judged = judged[
            (judged["method"] == cell["method"]) & (judged["scalar"] == cell["scalar"])
        ]
        row |= _errors(judged, cell["loop"])
        row["remarks"] = remarks(judged, entry)
        rows.append(row)
    frame = pd.DataFrame(rows, columns=COLUMNS)
    order = sorted(
        range(len(frame)),
        key=lambda i: (method_rank(frame["method"][i]), frame["scalar"][i]),
    )
    return frame.iloc[order].reset_index(drop=True)


COLUMNS = (
    ["library", "version", "called", "shard", "name", "family", *CELL_KEYS]
    + ["ns", "ns_low", "ns_high", "fixed_ns"]
    + [f"{ratio}{end}" for ratio in RATIOS for end in ("", "_low", "_high", "_kernel")]
    + [f"{family}{end}" for family in FAMILIES for end in ("", "_low", "_high", "_of")]
    + ["grid", "grid_low", "grid_high", "grid_of"]
    + ["boundary_rule", "remarks"]
)


def _reference(peers: pd.DataFrame, ours: pd.DataFrame, loop: str) -> pd.DataFrame:
    """The cells that are shown."""
    main = peers[
        (peers["loop"] == loop) & (peers["scene"] == reference_scene(ours, loop))
    ]
    grid = peers[(peers["loop"] == GRID) & peers["scene"].str.endswith("sets=fresh")]
    return pd.concat([main, grid], ignore_index=True)


def _over(
    column: str,
    by_cell: dict[tuple[str, str], npt.NDArray[np.float64]],
    cell: pd.Series,
    rivals: pd.DataFrame,
) -> dict[str, float | str]:
    """The cell's time over the fastest rival's, and which that is."""
    best = rivals.nsmallest(1, "ns")
    if not len(best):
        values: tuple[float, ...] = (math.nan,) * 3
        name = ""
    else:
        rival = best.iloc[0]
        values = ratio_interval(
            by_cell[cell["shard"], cell["name"]],
            by_cell[rival["shard"], rival["name"]],
        )[:3]
        name = f"{rival['method']} on {rival['isa']}"
    names = (column, f"{column}_low", f"{column}_high", f"{column}_kernel")
    return dict(zip(names, (*values, name)))


def _errors(judged: pd.DataFrame, loop: str) -> dict[str, object]:
    """Error rates by family, in the family's main loop, and the rule. Scenes
    with degenerate triangles are left out, as the remarks tell those apart; but
    not the grid, whose random triangles are degenerate now and then.
    """
    sound = judged[judged["degenerate"] == 0]
    row: dict[str, object] = {
        "boundary_rule": judged["boundary_rule"].iloc[0] if len(judged) else ""
    }
    wanted = {family: family for family in FAMILIES} | {"grid": "grid_80x50"}
    for key, family in wanted.items():
        cells = judged if key == GRID else sound
        cells = cells[cells["family"] == family]
        cells = cells[cells["loop"] == accuracy_loop(cells)]
        rates = error_rates(cells, ["method"])
        known = len(rates) == 1
        for end, source in (
            ("", "error_rate"),
            ("_low", "error_rate_low"),
            ("_high", "error_rate_high"),
            ("_of", "of"),
        ):
            row[f"{key}{end}"] = rates[source].iloc[0] if known else math.nan
    return row


def remarks(judged: pd.DataFrame, entry: MethodEntry | None) -> str:
    """What else its answers show, as phrases; `judged`: the cells of one call
    and scalar.
    """
    cells = judged[judged["loop"] == accuracy_loop(judged)]

    def total(key: str) -> int:
        return int(cells[key].astype(float).fillna(0).sum())

    found = []
    if entry is not None and entry.finite_only:
        found.append("not asked about NaN and ∞")
    elif total("not_finite_accepted"):
        rate = total("not_finite_accepted") / total("not_finite_accepted_of")
        found.append(f"NaN or ∞ inside: {share(rate)}")
    flat = cells[cells["family"] == "degenerate"]
    inside = int(flat["false_inside"].astype(float).fillna(0).sum())
    if inside:
        of = int(flat["false_inside_of"].astype(float).fillna(0).sum())
        found.append(f"degenerate inside: {share(inside / of)}")
    accepted, of = total("boundary_accepted"), total("boundary_accepted_of")
    rule = cells["boundary_rule"].iloc[0] if len(cells) else ""
    broken = {"closed": of - accepted, "open": accepted}.get(str(rule), 0)
    if broken and of:
        found.append(f"boundary rule broken: {share(broken / of)}")
    if total("hole"):
        found.append(f"holes: {share(total('hole') / total('hole_of'))} of queries")
    return "; ".join(found)
