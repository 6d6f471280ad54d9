"""accuracy-*.json as two tables: one row a cell, and one row a worst input."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any

import pandas as pd

from analysis.read import fields
from analysis.read.read_json import LoadError
from analysis.read.run import ACCURACY_COLUMNS, WORST_COLUMNS

_COUNTS = ("points", "interior", "exterior", "boundary", "degenerate", "not_finite")
_WEIGHTS = ("largest_ulps", "mean_ulps", "not_finite", "points")
_FORWARD = ("largest_forward_ulps", "mean_forward_ulps")


def _asked(worst: dict[str, Any]) -> str:
    """The point, or the ray."""
    if "p" in worst:
        return " ".join(worst["p"])
    return f"{' '.join(worst['origin'])} along {' '.join(worst['direction'])}"


class AccuracyRows:
    """Collects the cells of one file after the other: `key` is where they stand
    in it.
    """

    def __init__(self, key: str = "cells") -> None:
        self._key = key
        self._cells: list[dict[str, Any]] = []
        self._worst: list[tuple[Any, ...]] = []
        self._seen: dict[str, Path] = {}

    def add_file(self, path: Path, document: dict[str, Any]) -> None:
        for index, row in enumerate(document.get(self._key, [])):
            self._add_cell(path, f"$.{self._key}[{index}]", row)

    def __len__(self) -> int:
        return len(self._cells)

    def frames(self) -> tuple[pd.DataFrame, pd.DataFrame]:
        """The cells, with `<class>` (a count), `<class>_of`, `_low`, `_high`,
        `_smallest` and `_largest` for each class, NaN where it does not apply;
        and the worst inputs.
        """
        return (
            pd.DataFrame(self._cells, columns=ACCURACY_COLUMNS),
            pd.DataFrame(self._worst, columns=WORST_COLUMNS),
        )

    def _add_cell(self, path: Path, field: str, row: dict[str, Any]) -> None:
        cell = fields.cell(path, f"{field}.name", row["name"])
        name = str(cell)
        if name in self._seen:
            raise LoadError(
                f"{path}: {field}.name: {name} is already in {self._seen[name].name}"
            )
        self._seen[name] = path
        columns = fields.cell_columns(cell)
        for key in ("loop", "scene", "method", "scalar", "isa"):
            if row[key] != columns[key]:
                raise LoadError(
                    f"{path}: {field}.{key}: is {row[key]!r}, but the name says "
                    f"{columns[key]!r}"
                )
        counts = {
            key: fields.whole(path, f"{field}.{key}", row.get(key, 0))
            for key in _COUNTS
        }
        classes = self._classes(path, field, row["classes"], counts)
        weights = row.get("weights") or {}
        ends = [row["classes"].get(k) for k in ("false_inside", "false_outside")]
        spans = [end["distance_ulps"] for end in ends if end and end["distance_ulps"]]
        self._cells.append(
            {
                "shard": fields.shard_name(path),
                "name": name,
                **columns,
                "boundary_rule": row["boundary_rule"],
                "accepts": row.get("accepts", "triangle"),
                **counts,
                **classes,
                "smallest_ulps": min((s["smallest"] for s in spans), default=None),
                "largest_ulps": max((s["largest"] for s in spans), default=None),
                **{f"weights_{key}": weights.get(key) for key in _WEIGHTS + _FORWARD},
            }
        )
        place = (name, *columns.values())
        for kind, share in row["classes"].items():
            for at, worst in enumerate(share["worst"]):
                where = f"{field}.classes.{kind}.worst[{at}].distance_ulps"
                far = worst["distance_ulps"]
                self._worst.append(
                    (
                        *place,
                        kind,
                        math.nan if far is None else fields.double(path, where, far),
                        worst["said"],
                        *(" ".join(worst[key]) for key in ("a", "b", "c")),
                        _asked(worst),
                    )
                )

    def _classes(
        self,
        path: Path,
        field: str,
        classes: dict[str, Any],
        counts: dict[str, int],
    ) -> dict[str, Any]:
        points = {
            "false_outside": counts["interior"],
            "false_inside": counts["exterior"] + counts["degenerate"],
            "boundary_accepted": counts["boundary"],
        }
        found: dict[str, Any] = {"false_outside": 0, "false_inside": 0}
        found |= {"boundary_accepted": 0}
        for kind, share in classes.items():
            where = f"{path}: {field}.classes.{kind}"
            count = fields.whole(path, f"{field}.classes.{kind}.count", share["count"])
            of = fields.whole(path, f"{field}.classes.{kind}.of", share["of"])
            expected = points.get(kind, of)
            if of != expected:
                raise LoadError(
                    f"{where}.of: is {of}, but the cell has {expected} such points"
                )
            if count > of:
                raise LoadError(f"{where}.count: {count} of {of}")
            span = share["distance_ulps"] or {}
            found[kind] = count
            found[f"{kind}_of"] = of
            found[f"{kind}_low"] = share["low"]
            found[f"{kind}_high"] = share["high"]
            for end in ("smallest", "largest"):
                if end in span:
                    place = f"{field}.classes.{kind}.distance_ulps.{end}"
                    span_end = fields.double(path, place, span[end])
                    found[f"{kind}_{end}"] = span_end
        return found
