"""Fields of a run's files: what must hold between them, beyond the schemas."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any, Final

from analysis.read.cells import Cell, CellNameError, parse_cell
from analysis.read.read_json import LoadError

# More than a double holds exactly is no count that a program made.
_LARGEST_INTEGER: Final = 2**64


class SameRun:
    """Refuses a file of another revision, seed or profile than the others."""

    def __init__(self, machine_file: Path, machine: dict[str, Any]) -> None:
        self._expected = {k: machine[k] for k in ("revision", "dirty", "seed")}
        self._first = {key: machine_file for key in self._expected}

    @property
    def profile(self) -> str:
        return str(self._expected["profile"])

    def check(self, path: Path, field: str, context: dict[str, Any]) -> None:
        for key in ("revision", "dirty", "seed", "profile"):
            expected = self._expected.setdefault(key, context[key])
            first = self._first.setdefault(key, path)
            if context[key] != expected:
                raise LoadError(
                    f"{path}: {field}.{key}: is {context[key]!r}, but {first.name} "
                    f"has {expected!r}: two runs are mixed in this folder"
                )


def shard_name(path: Path) -> str:
    return re.sub(r"\.json\Z", "", path.name)


def cell(path: Path, field: str, name: str) -> Cell:
    try:
        return parse_cell(name)
    except CellNameError as error:
        raise LoadError(f"{path}: {field}: {error}") from None


def cell_columns(parsed: Cell) -> dict[str, Any]:
    return {
        "loop": parsed.loop,
        "scene": str(parsed.scene),
        "family": parsed.scene.family,
        "method": parsed.method,
        "scalar": parsed.scalar,
        "isa": parsed.isa,
    }


def whole(path: Path, field: str, value: float) -> int:
    if value > _LARGEST_INTEGER:
        raise LoadError(f"{path}: {field}: {value} is too large for a count")
    return int(value)


def double(path: Path, field: str, value: float) -> float:
    """What may be written as an integer of any length, as distances in ulps are."""
    try:
        return float(value)
    except OverflowError:
        raise LoadError(f"{path}: {field}: {value} is beyond any double") from None
