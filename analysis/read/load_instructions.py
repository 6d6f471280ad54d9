"""instructions.json: what compiled kernels execute, as a data frame."""

from __future__ import annotations

from pathlib import Path
from typing import Final, NamedTuple

import pandas as pd

from analysis.read.fields import SameRun, double
from analysis.read.read_json import LoadError, read_json

INSTRUCTIONS_COLUMNS: Final = ["method", "scalar", "loop", "isa"] + [
    "per_call",
    "per_item",
    "items_per_iteration",
    "iteration",
]
EMULATED_COLUMNS: Final = [*INSTRUCTIONS_COLUMNS, "vector_bits"]
_NOT_ASKED: Final = "this run did not ask for the loops of kernels for arm64"


def no_instructions() -> pd.DataFrame:
    """What a run without the file has."""
    return pd.DataFrame(columns=INSTRUCTIONS_COLUMNS)


def no_emulated() -> pd.DataFrame:
    return pd.DataFrame(columns=EMULATED_COLUMNS)


class Traces(NamedTuple):
    """One row a kernel; `iteration` is a tuple of hex strings, an instruction
    each. And why there is none, where none could be traced, or emulated.
    """

    traced: pd.DataFrame = no_instructions()
    not_traced: str = "this run has no instructions.json"
    emulated: pd.DataFrame = no_emulated()  # of another architecture than the run's
    not_emulated: str = _NOT_ASKED


def load_instructions(path: Path, same_run: SameRun | None = None) -> Traces:
    """What was traced, and what was emulated.

    Raises LoadError, which names the file and the field.
    """
    document = read_json(path, "instructions")
    if same_run is not None:
        same_run.check(path, "$.context", document["context"])
    rows = []
    seen: set[tuple[str, ...]] = set()
    for index, row in enumerate(document["rows"]):
        key = (row["method"], row["scalar"], row["loop"], row["isa"])
        if key in seen:
            raise LoadError(f"{path}: $.rows[{index}]: {'/'.join(key)} is there twice")
        seen.add(key)
        if (row["items_per_iteration"] == 0) != (not row["iteration"]):
            raise LoadError(
                f"{path}: $.rows[{index}].items_per_iteration: is "
                f"{row['items_per_iteration']}, with {len(row['iteration'])} "
                "instructions"
            )
        rows.append(
            {**row, "iteration": tuple(row["iteration"])}
            | {
                key: double(path, f"$.rows[{index}].{key}", row[key])
                for key in ("per_call", "per_item")
            }
        )
    frame = pd.DataFrame(rows, columns=EMULATED_COLUMNS)
    here = frame["vector_bits"].isna()
    return Traces(
        frame.loc[here, INSTRUCTIONS_COLUMNS].reset_index(drop=True),
        str(document["reason"]),
        frame[~here].astype({"vector_bits": int}).reset_index(drop=True),
        str(document.get("not_emulated", _NOT_ASKED)),
    )
