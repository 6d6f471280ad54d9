"""The peers' table in the report, and the facts of its section."""

from __future__ import annotations

import dataclasses
from typing import Any

import pandas as pd

from analysis.accuracy.accuracy_tables import speed_against_error
from analysis.charts.palette import LIBRARY
from analysis.peers.peers_tables import GRID, Parted, peers_table
from analysis.read.run import RayRun, Run
from analysis.report.columns import (
    above_interval,
    number,
    rate_above_interval,
    sentence,
    word,
)
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import between, counted, listed, nanoseconds, times
from analysis.speed import tables


def _against(key: str, title: str) -> Column:
    """A ratio of times, its interval, and pointed at, what it is compared with."""
    return dataclasses.replace(
        above_interval(key, title, hint="95 % interval below"),
        tip=lambda row: str(row[f"{key}_kernel"]),
    )


def _call(row: dict[str, Any]) -> str:
    return f"{row['library']} {row['version']}: {row['called']}"


COLUMNS = (
    Column(
        "call", lambda row: str(row["method"]), note=_call, numeric=False, wraps=True
    ),
    Column(
        "scalar",
        lambda row: str(row["scalar"]),
        note=lambda row: "grid" if row["loop"] == GRID else "",
        numeric=False,
    ),
    above_interval("ns", "ns/item"),
    number("fixed_ns", "same points again", hint="ns, with trained branches"),
    _against("times_best", "× our fastest"),
    _against("times_exact", "× our exact"),
    rate_above_interval("near_edge", "near an edge"),
    rate_above_interval("needle", "needles"),
    rate_above_interval("offset", "far away"),
    rate_above_interval("grid", "on the grid"),
    word("boundary_rule", "boundary"),
    sentence("remarks", "remarks"),
)
# What the compiler is told about the code that it makes.
_CODE_FLAGS = ("-O", "-m", "-f")
CAPTION = (
    "Other libraries on the same cells, held against truth in the same way. Their "
    "time over that of the fastest kernel here, and of the fastest kernel that is "
    "exact, of the same shard and so from repetitions shuffled into each other. "
    "Error rates are of scenes without degenerate triangles, which a library may "
    "answer by its own rule; remarks give those, and points on the boundary, apart."
)


def hero_rows(
    parted: Parted, ours: pd.DataFrame, scalar: str, family: str = "near_edge"
) -> pd.DataFrame | None:
    """speed_against_error of the libraries, on the scene of the kernels; None
    where the run has none. `ours`: speed_cells of the kernels.
    """
    if not parted.timed:
        return None
    return beside(parted.ours, parted.peers, ours, scalar, "one_triangle", family)


def beside(
    kernels: Run | RayRun,
    libraries: Run | RayRun,
    ours: pd.DataFrame,
    scalar: str,
    loop: str,
    family: str,
) -> pd.DataFrame:
    """The same, of points or of rays."""
    peers = tables.speed_cells(libraries.speed)
    joined = pd.concat([ours, peers], ignore_index=True)
    judged = pd.concat([kernels.accuracy, libraries.accuracy], ignore_index=True)
    rows = speed_against_error(joined, judged, scalar, loop, family)
    rows = rows[rows["isa"] == LIBRARY].dropna(subset=["error_rate"])
    return rows.assign(on_frontier=False).reset_index(drop=True)


def add_peers(exhibits: Exhibits, parted: Parted, loop: str) -> pd.DataFrame:
    """The table, where the run has libraries; returned empty where not."""
    if not parted.timed:
        return pd.DataFrame()
    ours = tables.speed_cells(parted.ours.speed)
    table = peers_table(parted, ours, tables.speed_cells(parted.peers.speed), loop)
    if len(table):
        exhibits.table("peers", CAPTION, table, COLUMNS)
    return table


def peers_facts(parted: Parted, table: pd.DataFrame) -> dict[str, Any] | None:
    """What the section's sentences need; None where there is no such section."""
    if not len(table):
        return None
    versions = dict(zip(table["library"], table["version"]))
    flags = {
        " ".join(
            word for word in dict.fromkeys(text.split()) if word.startswith(_CODE_FLAGS)
        )
        for _, isa_set, text in parted.peers.machine.flags
        if isa_set == LIBRARY
    }
    known = table.dropna(subset=["times_best"])
    main = known[known["loop"] != GRID]
    return {
        "libraries": listed([f"{name} {v}".strip() for name, v in versions.items()]),
        "calls": counted(table["method"].nunique(), "call"),
        "flags": sorted(flags),
        "fastest": _extreme(main, "idxmin"),
        "slowest": _extreme(main, "idxmax"),
        "never_wrong": _never_wrong(main),
        "trained": _trained(main),
        "finite_only": listed(
            [entry.key for entry in parted.peers.methods if entry.finite_only]
        ),
        "refused": [
            {"name": name, "reason": reason}
            for name, reason in zip(
                parted.peers.refused["name"], parted.peers.refused["reason"]
            )
        ],
    }


def _extreme(table: pd.DataFrame, which: str) -> dict[str, str] | None:
    if not len(table):
        return None
    row = table.loc[getattr(table["times_best"], which)()]
    return {
        "method": row["method"],
        "scalar": row["scalar"],
        "ratio": times(row["times_best"]),
        "interval": between(row["times_best_low"], row["times_best_high"]),
        "kernel": row["times_best_kernel"],
    }


def _trained(table: pd.DataFrame) -> dict[str, str] | None:
    """The call that gains most where the points do not change, if one does."""
    gains = (table["ns"] / table["fixed_ns"]).dropna()
    if not len(gains) or gains.max() <= 1:
        return None
    row = table.loc[gains.idxmax()]
    return {
        "method": row["method"],
        "scalar": row["scalar"],
        "fixed": nanoseconds(row["fixed_ns"]),
        "fresh": nanoseconds(row["ns"]),
    }


def _never_wrong(table: pd.DataFrame) -> list[dict[str, str]]:
    """Of the calls that were right on all hard scenes, the fastest a scalar."""
    hard = table[["near_edge", "needle", "offset"]]
    right = table[(hard.fillna(1) == 0).all(axis=1)]
    found = []
    for scalar, rows in right.groupby("scalar", sort=True):
        best = rows.loc[rows["times_exact"].fillna(rows["times_best"]).idxmin()]
        found.append(
            {
                "scalar": str(scalar),
                "methods": listed(list(rows["method"])),
                "count": str(len(rows)),
                "best": best["method"],
                "ratio": times(best["times_exact"]),
                "interval": between(best["times_exact_low"], best["times_exact_high"]),
                "kernel": best["times_exact_kernel"],
            }
        )
    return found
