"""What a run's files say of rays, apart from what they say of points."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import pandas as pd

from analysis.read import fields
from analysis.read.cells import TUV_SUFFIX
from analysis.read.load_accuracy import AccuracyRows
from analysis.read.run import (
    REFUSED_COLUMNS,
    SPEED_COLUMNS,
    TUV_COLUMNS,
    RayMethodEntry,
    RayRun,
    Shard,
)

RAY_LOOPS = ("one_triangle_rays", "one_ray", "ray_pairs")


def is_ray_loop(loop: str) -> bool:
    return loop.removesuffix(TUV_SUFFIX) in RAY_LOOPS


class RayRows:
    """Takes the rows of rays out of those of a run."""

    def __init__(self) -> None:
        self._accuracy = AccuracyRows("ray_cells")
        self._tuv: list[dict[str, Any]] = []

    def add_accuracy(self, path: Path, document: dict[str, Any]) -> None:
        self._accuracy.add_file(path, document)
        for index, row in enumerate(document.get("ray_cells", [])):
            errors = row.get("tuv")
            if errors is None:
                continue
            cell = fields.cell(path, f"$.ray_cells[{index}].name", row["name"])
            sizes = {
                f"{name}_{kind}_ulps": errors[name][f"{kind}_ulps"]
                for name in "tuv"
                for kind in ("largest", "mean")
            }
            counts = {key: errors[key] for key in ("rays", "missed")}
            self._tuv.append({**fields.cell_columns(cell), **counts, **sizes})

    def run(
        self,
        speed: list[dict[str, Any]],
        refused: list[dict[str, Any]],
        shards: list[Shard],
        methods: tuple[RayMethodEntry, ...],
    ) -> RayRun:
        judged, worst = self._accuracy.frames()
        ours = {row["shard"] for row in (*speed, *refused)}
        return RayRun(
            speed=pd.DataFrame(speed, columns=SPEED_COLUMNS),
            refused=pd.DataFrame(refused, columns=REFUSED_COLUMNS),
            accuracy=judged,
            worst=worst,
            tuv=pd.DataFrame(self._tuv, columns=TUV_COLUMNS),
            methods=methods,
            shards=tuple(shard for shard in shards if shard.name in ours),
        )


def parted(
    rows: list[dict[str, Any]],
) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Rows of points, and rows of rays."""
    points = [row for row in rows if not is_ray_loop(row["loop"])]
    return points, [row for row in rows if is_ray_loop(row["loop"])]


def ray_methods(document: dict[str, Any]) -> tuple[RayMethodEntry, ...]:
    """Of methods.json; empty where it knows none."""
    known = [field.name for field in dataclasses.fields(RayMethodEntry)]
    return tuple(
        RayMethodEntry(**{key: entry[key] for key in known if key in entry})
        for entry in document.get("ray_methods", [])
    )
