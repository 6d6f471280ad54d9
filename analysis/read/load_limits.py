"""limits.json as Limits."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pandas as pd

from analysis.read.fields import SameRun
from analysis.read.limits import MEMORY_COLUMNS, OPERATION_COLUMNS, Level, Limits
from analysis.read.read_json import LoadError, read_json


def load_limits(path: Path, same_run: SameRun) -> Limits:
    """Raises LoadError, which names the file and the field."""
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
    _refuse_twice(path, "memory", document, ("isa", "scalars", "level", "access"))
    _refuse_twice(path, "operations", document, ("isa", "scalar", "operation"))
    memory = [{**row, "scalars": tuple(row["scalars"])} for row in document["memory"]]
    return Limits(
        levels=levels,
        memory=pd.DataFrame(memory, columns=MEMORY_COLUMNS),
        operations=pd.DataFrame(document["operations"], columns=OPERATION_COLUMNS),
        clock_ghz=(context["clock_before_ghz"] + context["clock_after_ghz"]) / 2,
    )


def _level(entry: dict[str, Any]) -> Level:
    capacity = entry["capacity_bytes"]
    return Level(
        name=entry["name"],
        capacity=math.inf if capacity is None else float(capacity),
        probed=float(entry["probed_bytes"]),
    )


def _refuse_twice(
    path: Path, part: str, document: dict[str, Any], keys: tuple[str, ...]
) -> None:
    """A limit that is there twice says two things."""
    seen = set()
    for index, row in enumerate(document[part]):
        key = (*(str(row[k]) for k in keys), row.get("streams"))
        if key in seen:
            raise LoadError(f"{path}: $.{part}[{index}]: the limit is there twice")
        seen.add(key)
