"""A run's files as typed objects and data frames.

`load_run` takes a folder results/<run>/ and either returns all of it or
raises LoadError, which names the file and the field that does not fit.
"""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path
from typing import Any

import pandas as pd

from analysis.read import fields
from analysis.read.load_accuracy import AccuracyRows
from analysis.read.load_instructions import Traces, load_instructions
from analysis.read.load_limits import load_limits
from analysis.read.load_maps import load_maps
from analysis.read.load_operations import load_operations, no_operations
from analysis.read.load_rays import RayRows, parted, ray_methods
from analysis.read.maps import Maps
from analysis.read.microarchitecture import design, identity_words
from analysis.read.read_json import LoadError, read_json
from analysis.read.run import (
    REFUSED_COLUMNS,
    SPEED_COLUMNS,
    Build,
    Cache,
    Machine,
    MethodEntry,
    Run,
    Shard,
    SweepTimes,
)

__all__ = ["LoadError", "load_run"]

Pairs = tuple[tuple[str, str], ...]


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
        shards.append(shard_of(fields.shard_name(path), context))
        _add_speed_rows(path, document["benchmarks"], speed, refused, seen)
    accuracy = AccuracyRows()
    rays = RayRows()
    for path in accuracy_files:
        document = read_json(path, "accuracy")
        same_run.check(path, "$.context", document["context"])
        accuracy.add_file(path, document)
        rays.add_accuracy(path, document)
    speed, ray_speed = parted(speed)
    refused, ray_refused = parted(refused)
    declared_in = folder / "methods.json"
    declared = (
        ray_methods(read_json(declared_in, "methods")) if declared_in.exists() else ()
    )
    of_rays = rays.run(ray_speed, ray_refused, shards, declared)
    of_points = tuple(shard for shard in shards if shard not in of_rays.shards)
    for rows, files in ((speed, speed_files), (accuracy, accuracy_files)):
        if not rows:
            names = ", ".join(path.name for path in files)
            raise LoadError(
                f"{folder}: no result of the points in {names}; run the sweep again"
            )
    methods, scenes, writes = catalogue(declared_in)
    judged, worst = accuracy.frames()
    maps = folder / "maps.json"
    counts = folder / "operations.json"
    traces = folder / "instructions.json"
    traced = load_instructions(traces, same_run) if traces.exists() else Traces()
    return Run(
        name=folder.resolve().name,
        profile=same_run.profile,
        machine=machine_of(machine_json),
        shards=of_points,
        speed=pd.DataFrame(speed, columns=SPEED_COLUMNS),
        refused=pd.DataFrame(refused, columns=REFUSED_COLUMNS),
        accuracy=judged,
        worst=worst,
        methods=methods,
        scenes=scenes,
        maps=load_maps(maps, same_run) if maps.exists() else Maps(),
        limits=load_limits(folder, same_run),
        operations=(
            load_operations(counts, same_run) if counts.exists() else no_operations()
        ),
        instructions=traced.traced,
        not_traced=traced.not_traced,
        emulated=traced.emulated,
        not_emulated=traced.not_emulated,
        writes=writes,
        rays=of_rays,
        isa_up_to=isa_limit(folder),
        times=sweep_times(folder),
        built=build_of(folder),
    )


def isa_limit(folder: Path) -> str:
    """The widest ISA that the sweep was told to hold, empty if it was not."""
    path = folder / "sweep.json"
    return str(read_json(path, "sweep").get("isa_up_to", "")) if path.exists() else ""


def sweep_times(folder: Path) -> SweepTimes | None:
    """How long the sweep took, if it told."""
    path = folder / "times.json"
    if not path.exists():
        return None
    document = read_json(path, "times")
    shards = [(name, float(taken)) for name, taken in document["shards"].items()]
    return SweepTimes(
        seconds=float(document["seconds"]),
        starts=int(document["starts"]),
        shards=tuple(sorted(shards, key=lambda shard: (-shard[1], shard[0]))),
    )


def build_of(folder: Path) -> Build | None:
    """How long the program's build took, if that was noted."""
    path = folder / "build.json"
    if not path.exists():
        return None
    document = read_json(path, "build")
    return Build(
        **{field.name: int(document[field.name]) for field in dataclasses.fields(Build)}
    )


def shard_of(name: str, context: dict[str, Any]) -> Shard:
    return Shard(
        name=name,
        filter=context["filter"],
        cpu=int(context["cpu"]),
        clock_before_ghz=float(context["clock_before_ghz"]),
        clock_after_ghz=float(context["clock_after_ghz"]),
        steal_percent=float(context["steal_percent"]),
        load_average=float(context["load_average"]),
        wall_seconds=float(context.get("wall_seconds", math.nan)),
        cpu_seconds=float(context.get("cpu_seconds", math.nan)),
        preemptions=float(context.get("preemptions", math.nan)),
        throughput_before_gops=float(context.get("throughput_before_gops", math.nan)),
        throughput_after_gops=float(context.get("throughput_after_gops", math.nan)),
        quiet_share=float(context.get("quiet_share", math.nan)),
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
                "control": cell.control,
                "threads": cell.threads or 1,
                "repetition": repetition,
                "ns": 1e9 / _double(path, f"{field}.items_per_second", row),
                "items": _double(path, f"{field}.items", row),
                "working_set_bytes": _double(path, f"{field}.working_set_bytes", row),
                "bytes_per_item": _double(path, f"{field}.bytes_per_item", row),
                "scene_bytes": float(row.get("scene_bytes", math.nan)),
            }
        )


def _double(path: Path, field: str, row: dict[str, Any]) -> float:
    """The last part of `field` of the row, as a double that can be inverted."""
    value = row[field.rpartition(".")[2]]
    if value > 1e300 or 0 < value < 1e-300:
        raise LoadError(f"{path}: {field}: {value} is beyond any measurement")
    return float(value)


def machine_of(document: dict[str, Any]) -> Machine:
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
        kernel_hash=document.get("kernel_hash", ""),
        identity=identity_words(cpu.get("identity")),
        design=design(cpu.get("identity")),
    )


def catalogue(
    path: Path,
) -> tuple[tuple[MethodEntry, ...], Pairs, Pairs]:
    """The methods, the scenes and what each loop writes in methods.json, empty
    if there is no such file.
    """
    if not path.exists():
        return (), (), ()
    document = read_json(path, "methods")
    known = [field.name for field in dataclasses.fields(MethodEntry)]
    methods = tuple(
        MethodEntry(**{key: entry[key] for key in known if key in entry})
        for entry in document["methods"]
    )
    scenes = tuple((s["name"], s["describes"]) for s in document["scenes"])
    return methods, scenes, tuple(document.get("writes", {}).items())
