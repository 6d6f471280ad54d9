"""A run's files as typed objects and data frames.

`load_run` takes a folder results/<run>/ and either returns all of it or
raises LoadError, which names the file and the field that does not fit.
"""

from __future__ import annotations

import dataclasses
import re
from pathlib import Path
from typing import Any, Final

import pandas as pd

from analysis.cells import Cell, CellNameError, parse_cell
from analysis.read_json import LoadError, read_json
from analysis.run import (
    ACCURACY_COLUMNS,
    REFUSED_COLUMNS,
    SPEED_COLUMNS,
    WORST_COLUMNS,
    Cache,
    Machine,
    MethodEntry,
    Run,
    Shard,
)

__all__ = ["LoadError", "load_run"]

# More than a double holds exactly is no count that a program made.
_LARGEST_INTEGER: Final = 2**64


def load_run(folder: Path) -> Run:
    """Everything in results/<run>/. Raises LoadError."""
    if not folder.is_dir():
        raise LoadError(f"{folder}: no such folder; give the results/<run>/ of a sweep")
    speed_files = sorted(folder.glob("speed-*.json"))
    accuracy_files = sorted(folder.glob("accuracy-*.json"))
    for files, kind in ((speed_files, "speed"), (accuracy_files, "accuracy")):
        if not files:
            raise LoadError(
                f"{folder}: no {kind}-*.json in it; no speed is shown without its "
                "error rate, nor the reverse (is the sweep finished?)"
            )
    machine_file = folder / "machine.json"
    machine_json = read_json(machine_file, "machine")
    reference = {k: machine_json[k] for k in ("revision", "dirty", "seed")}
    came_from: dict[str, Path] = {"revision": machine_file}

    shards: list[Shard] = []
    speed: list[dict[str, Any]] = []
    refused: list[dict[str, Any]] = []
    accuracy: list[dict[str, Any]] = []
    worst: list[dict[str, Any]] = []
    seen: dict[str, Path] = {}
    for path in speed_files:
        document = read_json(path, "speed")
        context = document["context"]["pitbench"]
        _check_same_run(path, "$.context.pitbench", context, reference, came_from)
        shards.append(_shard(_shard_name(path), context))
        _add_speed_rows(path, document["benchmarks"], speed, refused, seen)
    seen.clear()
    for path in accuracy_files:
        document = read_json(path, "accuracy")
        _check_same_run(path, "$.context", document["context"], reference, came_from)
        for index, cell in enumerate(document["cells"]):
            _add_accuracy_row(path, index, cell, accuracy, worst, seen)
    if not speed or not accuracy:
        kind = "speed" if not speed else "accuracy"
        raise LoadError(f"{folder}: the {kind}-*.json hold no result")
    methods, scenes = _catalogue(folder / "methods.json")
    return Run(
        name=folder.resolve().name,
        profile=str(reference["profile"]),
        machine=_machine(machine_json),
        shards=tuple(shards),
        speed=pd.DataFrame(speed, columns=SPEED_COLUMNS),
        refused=pd.DataFrame(refused, columns=REFUSED_COLUMNS),
        accuracy=pd.DataFrame(accuracy, columns=ACCURACY_COLUMNS),
        worst=pd.DataFrame(worst, columns=WORST_COLUMNS),
        methods=methods,
        scenes=scenes,
    )


def _check_same_run(
    path: Path,
    field: str,
    context: dict[str, Any],
    reference: dict[str, Any],
    came_from: dict[str, Path],
) -> None:
    """Refuses a file of another revision, seed or profile than the others."""
    for key in ("revision", "dirty", "seed", "profile"):
        expected = reference.setdefault(key, context[key])
        first = came_from.setdefault(
            key, path if key == "profile" else _first(came_from)
        )
        if context[key] != expected:
            raise LoadError(
                f"{path}: {field}.{key}: is {context[key]!r}, but {first.name} has "
                f"{expected!r}: two runs are mixed in this folder"
            )


def _first(came_from: dict[str, Path]) -> Path:
    return came_from["revision"]


def _shard_name(path: Path) -> str:
    return re.sub(r"\.json\Z", "", path.name)


def _shard(name: str, context: dict[str, Any]) -> Shard:
    return Shard(
        name=name,
        filter=context["filter"],
        cpu=int(context["cpu"]),
        clock_before_ghz=float(context["clock_before_ghz"]),
        clock_after_ghz=float(context["clock_after_ghz"]),
        steal_percent=float(context["steal_percent"]),
        load_average=float(context["load_average"]),
    )


def _cell(path: Path, field: str, name: str) -> Cell:
    try:
        return parse_cell(name)
    except CellNameError as error:
        raise LoadError(f"{path}: {field}: {error}") from None


def _cell_columns(cell: Cell) -> dict[str, Any]:
    return {
        "loop": cell.loop,
        "scene": str(cell.scene),
        "family": cell.scene.family,
        "method": cell.method,
        "scalar": cell.scalar,
        "isa": cell.isa,
    }


def _add_speed_rows(
    path: Path,
    rows: list[dict[str, Any]],
    speed: list[dict[str, Any]],
    refused: list[dict[str, Any]],
    seen: dict[str, Path],
) -> None:
    repetitions: set[tuple[str, int]] = set()
    refused_here: set[str] = set()
    for index, row in enumerate(rows):
        field = f"$.benchmarks[{index}]"
        if row.get("run_type") == "aggregate":
            continue
        name = row["run_name"] if "run_name" in row else row["name"]
        cell = _cell(path, f"{field}.name", str(name))
        if seen.setdefault(str(cell), path) != path:
            raise LoadError(
                f"{path}: {field}.name: {cell} is already in {seen[str(cell)].name}"
            )
        row_columns = {
            "shard": _shard_name(path),
            "name": str(cell),
            **_cell_columns(cell),
        }
        if row.get("error_occurred"):
            if str(cell) not in refused_here:
                refused_here.add(str(cell))
                refused.append({**row_columns, "reason": row["error_message"]})
            continue
        repetition = _whole(path, f"{field}.repetition_index", row["repetition_index"])
        if (str(cell), repetition) in repetitions:
            raise LoadError(
                f"{path}: {field}.repetition_index: {repetition} of {cell} is there "
                "twice"
            )
        repetitions.add((str(cell), repetition))
        speed.append(
            {
                **row_columns,
                "twin": cell.twin,
                "repetition": repetition,
                "ns": 1e9 / _double(path, f"{field}.items_per_second", row),
                "items": _double(path, f"{field}.items", row),
                "working_set_bytes": _double(path, f"{field}.working_set_bytes", row),
                "bytes_per_item": _double(path, f"{field}.bytes_per_item", row),
            }
        )


def _add_accuracy_row(
    path: Path,
    index: int,
    row: dict[str, Any],
    accuracy: list[dict[str, Any]],
    worst: list[dict[str, Any]],
    seen: dict[str, Path],
) -> None:
    field = f"$.cells[{index}]"
    cell = _cell(path, f"{field}.name", row["name"])
    if str(cell) in seen:
        raise LoadError(
            f"{path}: {field}.name: {cell} is already in {seen[str(cell)].name}"
        )
    seen[str(cell)] = path
    columns = _cell_columns(cell)
    for key in ("loop", "scene", "method", "scalar", "isa"):
        if row[key] != columns[key]:
            raise LoadError(
                f"{path}: {field}.{key}: is {row[key]!r}, but the name says "
                f"{columns[key]!r}"
            )
    counts = {
        key: _whole(path, f"{field}.{key}", row[key])
        for key in ("points", "interior", "exterior", "boundary", "degenerate")
    }
    of = {
        "false_outside": counts["interior"],
        "false_inside": counts["exterior"] + counts["degenerate"],
        "boundary_accepted": counts["boundary"],
    }
    shares: dict[str, int] = {}
    for key, expected in of.items():
        if row[key]["of"] != expected:
            raise LoadError(
                f"{path}: {field}.{key}.of: is {row[key]['of']}, but the cell has "
                f"{expected} such points"
            )
        shares[key] = _whole(path, f"{field}.{key}.count", row[key]["count"])
        if shares[key] > expected:
            raise LoadError(
                f"{path}: {field}.{key}.count: {shares[key]} of {expected} points"
            )
    distance = row["error_distance_ulps"] or {}
    weights = row["weights"] or {}
    accuracy.append(
        {
            "shard": _shard_name(path),
            "name": str(cell),
            **columns,
            "boundary_rule": row["boundary_rule"],
            "accepts": row["accepts"],
            **counts,
            **shares,
            "smallest_ulps": distance.get("smallest"),
            "largest_ulps": distance.get("largest"),
            "weights_largest_ulps": weights.get("largest_ulps"),
            "weights_mean_ulps": weights.get("mean_ulps"),
            "weights_not_finite": weights.get("not_finite"),
            "weights_points": weights.get("points"),
        }
    )
    for answer in row["worst"]:
        worst.append(
            {
                "name": str(cell),
                **columns,
                "kind": answer["kind"],
                "distance_ulps": float(answer["distance_ulps"]),
                **{key: " ".join(answer[key]) for key in ("a", "b", "c", "p")},
            }
        )


def _whole(path: Path, field: str, value: float) -> int:
    if value > _LARGEST_INTEGER:
        raise LoadError(f"{path}: {field}: {value} is too large for a count")
    return int(value)


def _double(path: Path, field: str, row: dict[str, Any]) -> float:
    """The last part of `field` of the row, as a double that can be inverted."""
    value = row[field.rpartition(".")[2]]
    if value > 1e300 or 0 < value < 1e-300:
        raise LoadError(f"{path}: {field}: {value} is beyond any measurement")
    return float(value)


def _machine(document: dict[str, Any]) -> Machine:
    cpu, compiler = document["cpu"], document["compiler"]
    return Machine(
        model=cpu["model"],
        microcode=cpu["microcode"],
        cores=int(cpu["cores"]),
        threads=int(cpu["threads"]),
        smt=cpu["smt"],
        governor=cpu["governor"],
        virtual=cpu["virtual"],
        hypervisor=cpu["hypervisor"],
        caches=tuple(Cache(**cache) for cache in cpu["caches"]),
        isas=tuple(cpu["isas"]),
        kernel=document["os"]["kernel"],
        distribution=document["os"]["distribution"],
        compiler=f"{compiler['id']} {compiler['version']}",
        flags=tuple(
            (source, isa_set, flags)
            for source, sets in sorted(compiler["flags"].items())
            for isa_set, flags in sorted(sets.items())
        ),
        libraries=tuple(sorted(document["libraries"].items())),
        revision=document["revision"],
        dirty=document["dirty"],
        seed=int(document["seed"]),
        memory_bytes=int(document["memory_bytes"]),
    )


def _catalogue(
    path: Path,
) -> tuple[tuple[MethodEntry, ...], tuple[tuple[str, str], ...]]:
    """The methods and scenes in methods.json, empty if there is no such file."""
    if not path.exists():
        return (), ()
    document = read_json(path, "methods")
    fields = [field.name for field in dataclasses.fields(MethodEntry)]
    methods = tuple(
        MethodEntry(**{key: entry[key] for key in fields})
        for entry in document["methods"]
    )
    return methods, tuple((s["name"], s["describes"]) for s in document["scenes"])
