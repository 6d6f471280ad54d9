"""A run's files as typed objects and data frames.

`load_run` takes a folder results/<run>/ and either returns all of it or
raises LoadError, which names the file and the field that does not fit.
"""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import pandas as pd

from analysis import fields
from analysis.load_accuracy import AccuracyRows
from analysis.load_maps import load_maps
from analysis.maps import Maps
from analysis.read_json import LoadError, read_json
from analysis.run import (
    REFUSED_COLUMNS,
    SPEED_COLUMNS,
    Cache,
    Machine,
    MethodEntry,
    Run,
    Shard,
)

__all__ = ["LoadError", "load_run"]


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
    same_run = fields.SameRun(machine_file, machine_json)

    shards: list[Shard] = []
    speed: list[dict[str, Any]] = []
    refused: list[dict[str, Any]] = []
    seen: dict[str, Path] = {}
    for path in speed_files:
        document = read_json(path, "speed")
        context = document["context"]["pitbench"]
        same_run.check(path, "$.context.pitbench", context)
        shards.append(_shard(fields.shard_name(path), context))
        _add_speed_rows(path, document["benchmarks"], speed, refused, seen)
    accuracy = AccuracyRows()
    for path in accuracy_files:
        document = read_json(path, "accuracy")
        same_run.check(path, "$.context", document["context"])
        accuracy.add_file(path, document)
    if not speed or not accuracy:
        kind = "speed" if not speed else "accuracy"
        raise LoadError(f"{folder}: the {kind}-*.json hold no result")
    methods, scenes = _catalogue(folder / "methods.json")
    judged, worst = accuracy.frames()
    maps = folder / "maps.json"
    return Run(
        name=folder.resolve().name,
        profile=same_run.profile,
        machine=_machine(machine_json),
        shards=tuple(shards),
        speed=pd.DataFrame(speed, columns=SPEED_COLUMNS),
        refused=pd.DataFrame(refused, columns=REFUSED_COLUMNS),
        accuracy=judged,
        worst=worst,
        methods=methods,
        scenes=scenes,
        maps=load_maps(maps, same_run) if maps.exists() else Maps(),
    )


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
        cell = fields.cell(path, f"{field}.name", str(name))
        if seen.setdefault(str(cell), path) != path:
            raise LoadError(
                f"{path}: {field}.name: {cell} is already in {seen[str(cell)].name}"
            )
        row_columns = {
            "shard": fields.shard_name(path),
            "name": str(cell),
            **fields.cell_columns(cell),
        }
        if row.get("error_occurred"):
            if str(cell) not in refused_here:
                refused_here.add(str(cell))
                refused.append({**row_columns, "reason": row["error_message"]})
            continue
        repetition = fields.whole(
            path, f"{field}.repetition_index", row["repetition_index"]
        )
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
    known = [field.name for field in dataclasses.fields(MethodEntry)]
    methods = tuple(
        MethodEntry(**{key: entry[key] for key in known if key in entry})
        for entry in document["methods"]
    )
    return methods, tuple((s["name"], s["describes"]) for s in document["scenes"])
