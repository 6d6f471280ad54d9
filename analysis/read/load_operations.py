"""operations.json: how many operations each method takes, as a data frame."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pandas as pd

from analysis.read.fields import SameRun, double
from analysis.read.read_json import LoadError, read_json

KINDS: Final = [
    "add",
    "multiply",
    "multiply_add",
    "divide",
    "min_max",
    "integer_min_max",
    "compare",
    "integer_multiply",
    "logic",
    "convert",
    "load",
    "store",
]
OPERATIONS_COLUMNS: Final = ["method", "scalar", "loop", "per"] + KINDS


def no_operations() -> pd.DataFrame:
    """What a run without the file has."""
    return pd.DataFrame(columns=OPERATIONS_COLUMNS)


def load_operations(path: Path, same_run: SameRun | None = None) -> pd.DataFrame:
    """Two rows for each method, scalar and loop: `per` is "call" (the set-up,
    and whatever else does not grow with the items) or "item" (a point, a
    triangle, a pair; in loop grid a triangle with its pixels).

    Raises LoadError, which names the file and the field.
    """
    document = read_json(path, "operations")
    if same_run is not None:
        same_run.check(path, "$.context", document["context"])
    rows = []
    seen: set[tuple[str, str, str]] = set()
    for index, row in enumerate(document["rows"]):
        key = (row["method"], row["scalar"], row["loop"])
        if key in seen:
            raise LoadError(f"{path}: $.rows[{index}]: {'/'.join(key)} is there twice")
        seen.add(key)
        for per in ("call", "item"):
            field = f"$.rows[{index}].per_{per}"
            # Without minima of integers apart in older runs.
            counts = {
                kind: double(path, f"{field}.{kind}", row[f"per_{per}"].get(kind, 0))
                for kind in KINDS
            }
            rows.append(
                {"method": key[0], "scalar": key[1], "loop": key[2], "per": per}
                | counts
            )
    return pd.DataFrame(rows, columns=OPERATIONS_COLUMNS)
