"""limits.json, and limits_after.json if it is there, as Limits."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any, Final

import pandas as pd

from analysis.read.fields import SameRun
from analysis.read.limits import MEMORY_COLUMNS, OPERATION_COLUMNS, Level, Limits
from analysis.read.read_json import LoadError, read_json


FILES: Final = ("limits.json", "limits_after.json")
# What names a limit; a limit is named once in a file.
_MEMORY_KEYS: Final = ["isa", "scalars", "level", "access", "streams"]
_OPERATION_KEYS: Final = ["isa", "scalar", "operation"]


def load_limits(folder: Path, same_run: SameRun, packed: str = "") -> Limits | None:
    """Those of the run in `folder`, None if it has none; `packed`: what follows the
    files' names, ".gz" in a stored run. Of what was measured twice the better counts.
    Raises LoadError, which names the file and the field.
    """
    first, after = (folder / (name + packed) for name in FILES)
    if not first.exists():
        return None
    limits = _limits(first, same_run)
    return (
        _joined(limits, _limits(after, same_run), after) if after.exists() else limits
    )


def _joined(first: Limits, again: Limits, path: Path) -> Limits:
    if first.levels != again.levels:
        raise LoadError(f"{path}: $.levels: other levels than in {FILES[0]}")
    parts = [
        ("memory", _MEMORY_KEYS, "bytes_per_second"),
        ("operations", _OPERATION_KEYS, "operations_per_second"),
    ]
    better, moved = {}, {}
    for part, keys, rate in parts:
        tables = [getattr(limits, part) for limits in (first, again)]
        ordered = pd.concat(tables).sort_values(rate, ascending=False, kind="stable")
        better[part] = ordered.drop_duplicates(keys).sort_index(kind="stable")
        before, later = (table.set_index(keys)[rate] for table in tables)
        ratios = (later / before).dropna()
        if len(ratios):
            moved[part] = (float(ratios.min()), float(ratios.max()))
    return dataclasses.replace(
        first,
        memory=better["memory"].reset_index(drop=True),
        operations=better["operations"].reset_index(drop=True),
        clocks_ghz=first.clocks_ghz + again.clocks_ghz,
        moved=moved,
    )


def _limits(path: Path, same_run: SameRun) -> Limits:
    document = read_json(path, "limits")
    context = document["context"]
    same_run.check(path, "$.context", context)
    levels = tuple(_level(entry) for entry in document["levels"])
    for index in range(1, len(levels)):
        if levels[index].capacity <= levels[index - 1].capacity:
            raise LoadError(
                f"{path}: $.levels[{index}].capacity_bytes: {levels[index].name} is no "
                f"larger than {levels[index - 1].name}"
            )
    names = {level.name for level in levels}
    for index, row in enumerate(document["memory"]):
        if row["level"] not in names:
            raise LoadError(
                f"{path}: $.memory[{index}].level: {row['level']} is not in $.levels"
            )
    _refuse_twice(path, "memory", document, _MEMORY_KEYS)
    _refuse_twice(path, "operations", document, _OPERATION_KEYS)
    memory = [{**row, "scalars": tuple(row["scalars"])} for row in document["memory"]]
    clocks = (float(context["clock_before_ghz"]), float(context["clock_after_ghz"]))
    frames = [
        pd.DataFrame(rows, columns=columns).assign(clock_ghz=max(clocks))
        for rows, columns in (
            (memory, MEMORY_COLUMNS),
            (document["operations"], OPERATION_COLUMNS),
        )
    ]
    return Limits(
        levels=levels,
        memory=frames[0],
        operations=frames[1],
        clocks_ghz=clocks,
    )


def _level(entry: dict[str, Any]) -> Level:
    capacity = entry["capacity_bytes"]
    return Level(
        name=entry["name"],
        capacity=math.inf if capacity is None else float(capacity),
        probed=float(entry["probed_bytes"]),
    )


def _refuse_twice(
    path: Path, part: str, document: dict[str, Any], keys: list[str]
) -> None:
    """A limit that is there twice says two things."""
    seen = set()
    for index, row in enumerate(document[part]):
        key = tuple(str(row[k]) for k in keys)
        if key in seen:
            raise LoadError(f"{path}: $.{part}[{index}]: the limit is there twice")
        seen.add(key)
