"""A made-up run, as large as a real one, for tests and for working on charts.

Nothing in it was measured: the CPU is called synthetic, and the timings and
error rates are invented so that every section of the report has something to
show. Run as a program, it writes one:

    python3 -m tests.analysis.synthetic FOLDER
"""

from __future__ import annotations

import dataclasses
import json
import random
import sys
from pathlib import Path
from typing import Any, Final

from tests.analysis import (
    synthetic_accuracy,
    synthetic_costs,
    synthetic_input,
    synthetic_limits,
    synthetic_maps,
)
from tests.analysis.synthetic_methods import EVERYWHERE, METHODS, has_row

REVISION = "5f17ce7ab1e0" + "0" * 28
SEED = 20240607

ISA_SPEED = {
    "scalar": 1.0,
    "autovec_v2": 3.0,
    "autovec_v3": 7.0,
    "autovec_v4": 17.0,
    "ssse3": 4.6,
    "sse4": 4.7,
    "avx2": 11.0,
    "avx512": 26.0,
}
LOOPS = {"one_triangle": 1.0, "one_point": 1.5, "pairs": 1.9}


@dataclasses.dataclass(frozen=True)
class Options:
    """What of the run differs from the plain one."""

    profile: str = "quick"
    twin_ratio: float = 1.0
    doubled_ratio: float = 2.0
    cpu_share: float = 0.999
    slowest_place: float = 1.12  # × the time of the aligned kernel
    clock_after: float = 3.49
    steal_percent: float = 0.1
    methods: tuple[str, ...] = tuple(METHODS)
    isas: tuple[str, ...] = tuple(ISA_SPEED)
    scalars: tuple[str, ...] = ("f32", "f64")
    small: bool = False  # one loop, one accuracy scene
    speed_factor: tuple[tuple[str, float], ...] = ()  # (method, × its time)
    error_factor: tuple[tuple[str, float], ...] = ()
    repetitions: int = 9
    methods_json: bool = True
    limits_json: bool = True
    operations_json: bool = True
    judged_isas: tuple[str, ...] | None = None  # by default the first and the last
    chance: int = 0  # other noise of the same run
    model: str = "Synthetic CPU (nothing here was measured)"
    identity: dict[str, Any] | None = None  # older runs have none
    kernel_hash: str = ""
    revision: str = REVISION
    dirty: bool = False
    isa_up_to: str = ""


# On the pixels of the grid: method, scalar, ns a point in the ISA `scalar`.
POINT_LIST = (
    ("edge_function", "i32", 1.1),
    ("edge_function", "i16", 0.5),
    ("byte_pairs", "u8", 0.25),
    ("edge_lanes", "i32", 0.6),
)


def write_run(folder: Path, options: Options = Options()) -> Path:
    """Writes the files of a synthetic run into `folder` and returns it."""
    folder.mkdir(parents=True, exist_ok=True)
    for name, document in documents(options).items():
        text = json.dumps(document, indent=1, sort_keys=True)
        (folder / name).write_text(text, encoding="utf-8")
    return folder


def documents(options: Options = Options()) -> dict[str, Any]:
    """File name → JSON document of a synthetic run."""
    files: dict[str, Any] = {"machine.json": machine(options)}
    if options.methods_json:
        files["methods.json"] = catalogue(options)
    loops = ["one_triangle"] if options.small else list(LOOPS)
    for loop in loops:
        for scalar in options.scalars:
            files[f"speed-{loop}-{scalar}.json"] = speed(options, loop, scalar)
    if not options.small:
        files["speed-grid.json"] = speed(options, "grid", "i32")
        files["speed-input-f32.json"] = speed(options, "input", "f32")
    for family in ["near_edge"] if options.small else synthetic_accuracy.SCENES:
        for scalar in options.scalars:
            name = f"accuracy-{family}-{scalar}.json"
            files[name] = accuracy(options, family, scalar)
    context = accuracy(options, "corpus", "f32")["context"]
    files["maps.json"] = synthetic_maps.document(
        context, options.methods, options.scalars
    )
    if options.limits_json:
        files["limits.json"] = synthetic_limits.limits(context, options.isas)
        files["limits_after.json"] = files["limits.json"]
    files |= synthetic_costs.documents(
        context, options.methods, options.scalars, options.isas
    )
    if not options.operations_json:
        del files["operations.json"]
    files["sweep.json"] = sweep(options, files)
    files["times.json"] = times(files)
    files["build.json"] = BUILD
    return files


BUILD: Final = {
    "schema": "pitbench-build-1",
    "seconds": 125,
    "compiled": 410,
    "from_cache": 0,
}


def times(files: dict[str, Any]) -> dict[str, Any]:
    """Two seconds a shard, measured in two starts, and half a minute of waiting."""
    shards = {name: 2.0 for name in files["sweep.json"]["shards"]}
    return {
        "schema": "pitbench-times-1",
        "starts": 2,
        "seconds": 30.0 + 2.0 * len(shards),
        "shards": shards,
    }


def sweep(options: Options, files: dict[str, Any]) -> dict[str, Any]:
    shards = [name.removesuffix(".json") for name in files]
    return {
        "schema": "pitbench-sweep-1",
        "profile": options.profile,
        "program_sha256": "5a" * 32,
        "shards": sorted(set(shards) - {"machine", "methods"}),
        **({"isa_up_to": options.isa_up_to} if options.isa_up_to else {}),
    }


def machine(options: Options) -> dict[str, Any]:
    caches = [(1, "Data", 49152), (2, "Unified", 1 << 20), (3, "Unified", 1 << 25)]
    flags = "-std=c++20 -O3 -DNDEBUG -ffp-contract=off -Wall -Wextra"
    return {
        "schema": "pitbench-machine-1",
        "cpu": {
            "model": options.model,
            **({"identity": options.identity} if options.identity else {}),
            "microcode": "0x0",
            "cores": 2,
            "threads": 2,
            "smt": None,
            "governor": None,
            "virtual": True,
            "hypervisor": "none",
            "caches": [
                {"level": level, "type": kind, "bytes": size, "shared_by": 1}
                for level, kind, size in caches
            ],
            "isas": list(options.isas),
        },
        "os": {"kernel": "6.1.0-synthetic", "distribution": "Debian GNU/Linux 12"},
        "compiler": {
            "id": "GNU",
            "version": "12.2.0",
            "flags": {
                f"kernels/methods/{method}.cc": {
                    "scalar": flags + " -fno-tree-vectorize",
                    "simd": flags,
                }
                for method in options.methods
            },
        },
        "libraries": {"highway": "1.0.3", "eigen": "3.4.0"},
        "revision": options.revision,
        "dirty": options.dirty,
        "seed": SEED,
        "memory_bytes": 8 << 30,
        **({"kernel_hash": options.kernel_hash} if options.kernel_hash else {}),
    }


def catalogue(options: Options) -> dict[str, Any]:
    return {
        "methods": [
            {
                "key": key,
                "source": "invented",
                "formula": f"the formula of {key}",
                "boundary": METHODS[key].boundary,
                "accepts": METHODS[key].accepts,
                "fma": key.endswith("_fma"),
                "weights": METHODS[key].weights,
                "warning": METHODS[key].warning,
            }
            for key in options.methods
        ],
        "isas": [{"name": isa, "runs_here": True} for isa in options.isas],
        "loops": [*LOOPS, "grid"],
        "scalars": ["f32", "f64", "i32"],
        "scenes": [
            {
                "name": "uniform",
                "parameters": "hit:n:sets",
                "describes": "spread evenly",
            },
            {"name": "near_edge", "parameters": "ulps", "describes": "beside an edge"},
        ],
        "kernels": 321,
        "writes": {"one_triangle": "a bit each", "grid": "rows of bits"},
    }


def speed_context(options: Options, pattern: str) -> dict[str, Any]:
    return {
        "date": "2024-06-07T12:00:00+00:00",
        "num_cpus": 2,
        "library_build_type": "debug",
        "pitbench": {
            "schema": "pitbench-speed-1",
            "profile": options.profile,
            "filter": pattern,
            "revision": options.revision,
            "dirty": options.dirty,
            "seed": SEED,
            "cpu": 1,
            "clock_before_ghz": 3.5,
            "clock_after_ghz": options.clock_after,
            "throughput_before_gops": 21.0,
            "throughput_after_gops": 20.9,
            "quiet_share": 0.93,
            "steal_percent": options.steal_percent,
            "load_average": 0.7,
            "wall_seconds": 8.0,
            "cpu_seconds": 8.0 * options.cpu_share,
            "preemptions": 12,
        },
    }


def speed(options: Options, loop: str, scalar: str) -> dict[str, Any]:
    more = f" {options.chance}" if options.chance else ""
    chance = random.Random(f"{SEED} {loop} {scalar}{more}")
    rows: list[dict[str, Any]] = []
    for name, ns, items in timed_cells(options, loop, scalar):
        if ns is None:
            rows.append(
                {
                    "name": name,
                    "run_name": name,
                    "run_type": "iteration",
                    "error_occurred": True,
                    "error_message": "17 of 4096 answers differ from truth",
                }
            )
            continue
        for repetition in range(options.repetitions):
            noise = 1 + chance.expovariate(150) + 0.004 * chance.random()
            rows.append(
                {
                    "name": name,
                    "run_name": name,
                    "run_type": "iteration",
                    "repetitions": options.repetitions,
                    "repetition_index": repetition,
                    "threads": 1,
                    "iterations": 10000,
                    "real_time": ns * items * noise,
                    "mean_time": ns * items * noise * 1.1,
                    "time_unit": "ns",
                    "items_per_second": 1e9 / (ns * noise),
                    "items": items,
                    "working_set_bytes": 8 * items if loop == "input" else 32768.0,
                    "bytes_per_item": 8.0 if scalar == "f32" else 16.0,
                    "scene_bytes": 38912.0,
                }
            )
    chance.shuffle(rows)
    return {
        "context": speed_context(options, f"^{loop}/.*/{scalar}/"),
        "benchmarks": rows,
    }


def timed_cells(
    options: Options, loop: str, scalar: str
) -> list[tuple[str, float | None, float]]:
    """(name, ns per item or None where the cell is refused, items a call)."""
    if loop == "input":
        return synthetic_input.cells(scalar)
    if loop == "grid":
        isas = {
            isa: rate
            for isa, rate in ISA_SPEED.items()
            if isa in options.isas and not isa.startswith("autovec")
        }
        return [
            (f"grid/grid_80x50:sets={s}/{method}/i32/{isa}", ns / rate, 16.0)
            for s in ("fresh", "fixed")
            for method, ns in (("edge_function", 4100.0), ("row_spans", 110.0))
            for isa, rate in isas.items()
        ] + [
            (
                f"one_triangle/grid_points_80x50:sets=fresh/{method}/{scalar}/{isa}",
                ns / (rate if method != "edge_lanes" else 1.0),
                4000.0,
            )
            for method, scalar, ns in POINT_LIST
            for isa, rate in isas.items()
            if method != "edge_lanes" or isa != "scalar"
        ]
    factors = dict(options.speed_factor)
    cells: list[tuple[str, float | None, float]] = []
    for key in options.methods:
        for isa in options.isas:
            if not has_row(key, scalar, isa):
                continue
            ns = METHODS[key].ns * LOOPS[loop] * factors.get(key, 1.0)
            ns *= (1.0 if scalar == "f32" else 1.9) / ISA_SPEED[isa]
            tail = f"{key}/{scalar}/{isa}"
            scene = "uniform:hit=50:bytes=24k:sets="
            for sets in ("fresh", "fixed") if key in EVERYWHERE else ("fresh",):
                branchy = 4.0 if sets == "fresh" and isa == "scalar" else 1.0
                cells.append((f"{loop}/{scene}{sets}/{tail}", ns * branchy, 4096.0))
            if METHODS[key].weights and not isa.startswith("autovec"):
                name = f"{loop}_weights/{scene}fresh/{tail}"
                cells.append((name, ns * 1.8, 4096.0))
    isa, key = options.isas[-1], options.methods[0]
    twin = f"{loop}/uniform:hit=50:bytes=24k:sets=fresh/{key}/{scalar}/{isa}/twin"
    base = next(ns for name, ns, _ in cells if name + "/twin" == twin)
    assert base is not None
    cells.append((twin, base * options.twin_ratio, 4096.0))
    doubled = twin.replace("/twin", "/doubled")
    cells.append((doubled, base * options.doubled_ratio, 4096.0))
    if loop == "one_triangle" and scalar == "f32":
        steps = (options.slowest_place - 1) / 3
        for step in range(4):
            placed = twin.replace("/twin", f"/placed_{16 * step}")
            cells.append((placed, base * (1 + step * steps), 4096.0))
    if scalar == "f64" and loop == "pairs":
        cells = [
            (name, None if "/uv_projection/" in name else ns, items)
            for name, ns, items in cells
        ]
    return cells


def accuracy(options: Options, family: str, scalar: str) -> dict[str, Any]:
    judged = options.judged_isas
    if judged is None:
        judged = tuple(dict.fromkeys([options.isas[0], options.isas[-1]]))
    kernels = [
        (key, isa)
        for key in options.methods
        for isa in judged
        if has_row(key, scalar, isa)
    ]
    return {
        "context": {
            "schema": "pitbench-accuracy-2",
            "profile": options.profile,
            "filter": f"{family}.*/{scalar}/",
            "revision": options.revision,
            "dirty": options.dirty,
            "seed": SEED,
        },
        "cells": synthetic_accuracy.cells(
            family, scalar, kernels, dict(options.error_factor), SEED
        ),
    }


if __name__ == "__main__":
    print(write_run(Path(sys.argv[1])))
