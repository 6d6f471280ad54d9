"""What a compiler's flag changes: each method beside its form with the flag."""

from __future__ import annotations

import math
from collections.abc import Iterable
from typing import Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.accuracy.overview import overview
from analysis.read.run import MethodEntry
from analysis.report.method_families import FMA_SUFFIX, in_order
from analysis.speed.tables import reference_cells, samples
from analysis.trust.stats import ratio_interval

# Holes and double hits are those of one scene, since a profile chooses how far
# from the edge it looks and pooled rates would follow it.
MESH: Final = "mesh_pair:ulps=0"
_SHOWN = {"error": "near_edge", "hole": "hole", "double_hit": "double_hit"}
# Forms whose name does not say what they are a form of.
_FORM_OF = {"cross_product_fast_math": "cross_product_det"}
_ENDS = ("", "_low", "_high", "_count", "_of")


def bases(
    methods: Iterable[str], entries: tuple[MethodEntry, ...]
) -> dict[str, tuple[str, str]]:
    """Method → (the method that it is a form of, its warning): multiply-add
    forms by their name, those with a warning by the longest name they extend.
    """
    every = set(methods)
    warnings = {entry.key: entry.warning for entry in entries if entry.warning}
    found: dict[str, tuple[str, str]] = {}
    for method in in_order(every):
        fused = method.removesuffix(FMA_SUFFIX)
        if fused != method and fused in every:
            found[method] = (fused, warnings.get(method, ""))
        elif method in warnings:
            shorter = [m for m in every if method.startswith(f"{m}_")]
            base = _FORM_OF.get(method, "")
            if base not in every:
                base = max(shorter, key=len, default="")
            found[method] = (base, warnings[method])
    return found


def flags_axis(
    accuracy: pd.DataFrame,
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    entries: tuple[MethodEntry, ...],
    scalars: list[str],
) -> pd.DataFrame:
    """One row a form of a method and scalar: its failures and those of the
    method that it is a form of, and its time over that one's (on its ISA).
    Errors are those near an edge, holes and double hits those on MESH.
    """
    by_cell = samples(speed)
    rows = []
    for scalar in scalars:
        table = _on_mesh(accuracy, scalar)
        timed = reference_cells(cells, scalar, "one_triangle")
        forms = bases(table.index, entries)
        for method, (base, warning) in forms.items():
            own = table.loc[method]
            row: dict[str, object] = {"method": method, "base": base or "–"}
            row |= {"scalar": scalar, "isa": own["isa"], "warning": warning}
            for name, key in _SHOWN.items():
                for end in _ENDS:
                    row[f"{name}{end}"] = own[f"{key}{end}"]
                    row[f"base_{name}{end}"] = (
                        table.loc[base][f"{key}{end}"] if base else _nothing(end)
                    )
            row |= _time(timed, by_cell, method, base)
            rows.append(row)
    columns = ["method", "base", "scalar", "isa"]
    columns += [
        f"{b}{name}{end}" for name in _SHOWN for b in ("base_", "") for end in _ENDS
    ]
    return pd.DataFrame(
        rows, columns=[*columns, "time", "time_low", "time_high", "warning"]
    )


def _on_mesh(accuracy: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """The overview by method, with the holes and double hits of MESH alone."""
    table = overview(accuracy, scalar).set_index("method")
    mesh = overview(accuracy[accuracy["scene"] == MESH], scalar).set_index("method")
    of_mesh = [
        f"{key}{end}" for key in ("hole", "double_hit") for end in (*_ENDS, "_by_rule")
    ]
    found = mesh.reindex(index=table.index)[of_mesh]
    counts = [
        column for column in of_mesh if column.endswith(("_count", "_of", "rule"))
    ]
    found[counts] = found[counts].fillna(0).astype(int)
    return table.drop(columns=of_mesh).join(found)


def _nothing(end: str) -> float:
    return 0 if end in ("_count", "_of") else math.nan


def _time(
    timed: pd.DataFrame,
    by_cell: dict[tuple[str, str], npt.NDArray[np.float64]],
    method: str,
    base: str,
) -> dict[str, float]:
    """On the widest ISA that both were timed on in one shard."""
    own = timed[timed["method"] == method]
    other = timed[timed["method"] == base]
    both = own.merge(other, on=["shard", "isa"], suffixes=("", "_base"))
    nothing = {"time": math.nan, "time_low": math.nan, "time_high": math.nan}
    if not len(both):
        return nothing
    last = both.loc[both["ns"].idxmin()]
    ratio = ratio_interval(
        by_cell[last["shard"], last["name"]],
        by_cell[last["shard"], last["name_base"]],
    )
    return {"time": ratio.value, "time_low": ratio.low, "time_high": ratio.high}
