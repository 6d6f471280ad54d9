"""Runs that are kept to compare CPUs: report/runs/NAME/, a run made small.

Kept: machine.json, sweep.json, times.json, build.json and methods.json; limits and
operations, as they were; every repetition of every timed cell, to five digits; the
counts of every judged cell, once for all ISAs that gave the same; the contexts of
the speed shards; how many instructions the compiled kernels execute; and what llvm-mca made
of the loops. Left out, since no comparison uses it: iterations and mean times; the
worst inputs and the distances of wrong answers, which are the same on every
machine that gives the same counts; the maps; and the instructions themselves.

`load_stored` gives a Run like any other, whose frames have the same columns.
"""

from __future__ import annotations

import dataclasses
import gzip
import json
import math
from pathlib import Path
from typing import Any, Final

import numpy as np
import pandas as pd

from analysis.models.arm_models import ARM_COLUMNS
from analysis.models.llvm_mca import DESIGNS, MODELLED_COLUMNS
from analysis.read import fields, load
from analysis.read.load_instructions import INSTRUCTIONS_COLUMNS
from analysis.read.load_limits import load_limits
from analysis.read.load_operations import load_operations, no_operations
from analysis.read.read_json import LoadError, read_json
from analysis.read.run import (
    ACCURACY_COLUMNS,
    CLASSES,
    REFUSED_COLUMNS,
    SPEED_COLUMNS,
    WORST_COLUMNS,
    Machine,
    Run,
    Shard,
)
from analysis.report.whole_file import write_whole
from analysis.trust.stats import wilson

MEASURED: Final = "measured.json.gz"
RUNS: Final = Path(__file__).resolve().parents[2] / "report" / "runs"
# Copied whole if they are there: file of the run → file kept.
COPIED: Final = {
    "machine.json": "machine.json",
    "sweep.json": "sweep.json",
    "times.json": "times.json",
    "build.json": "build.json",
    "methods.json": "methods.json",
    "limits.json": "limits.json.gz",
    "limits_after.json": "limits_after.json.gz",
    "operations.json": "operations.json.gz",
}
_DIGITS: Final = 5
_SIZES: Final = ("items", "working_set_bytes", "bytes_per_item", "scene_bytes")
_POINTS: Final = ["points", "interior", "exterior", "boundary", "degenerate"] + [
    "not_finite"
]
_WEIGHTS: Final = ["weights_largest_ulps", "weights_mean_ulps"] + [
    "weights_not_finite",
    "weights_points",
    "weights_largest_forward_ulps",
    "weights_mean_forward_ulps",
]
_SHARD_NUMBERS: Final = [
    "cpu",
    "clock_before_ghz",
    "clock_after_ghz",
    "steal_percent",
    "load_average",
    "wall_seconds",
    "cpu_seconds",
    "preemptions",
    "throughput_before_gops",
    "throughput_after_gops",
    "quiet_share",  # runs kept earlier have none
]
_KERNEL: Final = ["method", "scalar", "loop", "isa"]
_EXECUTED: Final = ["per_call", "per_item", "items_per_iteration"]


def measured(run: Run, label: str, anonymous: bool) -> dict[str, Any]:
    """The document of MEASURED for a run; the models are those it has."""
    places = {shard.name: index for index, shard in enumerate(run.shards)}
    in_order = run.speed.sort_values("repetition", kind="stable")
    speed = [
        {
            "shard": places[shard],
            "cell": name,
            "sizes": [_plain(group[size].iloc[0]) for size in _SIZES],
            "ns": [_rounded(ns) for ns in group["ns"]],
        }
        for (shard, name), group in in_order.groupby(["shard", "name"], sort=True)
    ]
    return {
        "schema": "pitbench-stored-1",
        "label": label,
        "anonymous": anonymous,
        "context": {
            "revision": run.machine.revision,
            "dirty": run.machine.dirty,
            "seed": run.machine.seed,
            "profile": run.profile,
        },
        "shards": [_shard_document(shard) for shard in run.shards],
        "speed": speed,
        "refused": [
            {
                "shard": places[row["shard"]],
                "cell": row["name"],
                "reason": row["reason"],
            }
            for row in run.refused.to_dict("records")
        ],
        "classes": CLASSES,
        "accuracy": _accuracy_documents(run.accuracy),
        "instructions": _instruction_documents(run),
        "not_traced": run.not_traced,
        "modelled": run.modelled.to_dict("records"),
        "modelled_arm": run.modelled_arm.to_dict("records"),
        "nearest_model": run.nearest_model,
        "not_modelled": run.not_modelled,
    }


def write_packed(path: Path, document: Any) -> None:
    """As compressed JSON, the same bytes for the same document."""
    write_whole(path, packed(document))


def packed(document: Any) -> bytes:
    """A document as write_packed() writes it."""
    text = json.dumps(document, separators=(",", ":"), sort_keys=True, allow_nan=False)
    return gzip.compress(text.encode(), compresslevel=9, mtime=0)


def is_stored(folder: Path) -> bool:
    return (folder / MEASURED).exists()


def open_run(text: str, runs: Path = RUNS) -> Run:
    """A run by its folder, or by its name in `runs`. Raises LoadError."""
    folder = Path(text)
    if not folder.is_dir() and (runs / text).is_dir():
        folder = runs / text
    if not folder.is_dir():
        known = ", ".join(stored_names(runs)) or "no run"
        raise LoadError(
            f"{text}: neither a folder of a run nor a name in {runs.name}/, which "
            f"holds {known}"
        )
    return load_stored(folder) if is_stored(folder) else load.load_run(folder)


def stored_names(runs: Path = RUNS) -> list[str]:
    return sorted(path.parent.name for path in runs.glob(f"*/{MEASURED}"))


def stored_runs(runs: Path = RUNS) -> list[Run]:
    """All runs kept there, by name. Raises LoadError."""
    return [load_stored(runs / name) for name in stored_names(runs)]


def load_stored(folder: Path) -> Run:
    """The run kept in report/runs/NAME/. Raises LoadError."""
    machine_file, path = folder / "machine.json", folder / MEASURED
    machine_json = read_json(machine_file, "machine")
    same_run = fields.SameRun(machine_file, machine_json)
    document = read_json(path, "stored")
    same_run.check(path, "$.context", document["context"])
    shards = tuple(
        load.shard_of(entry["name"], {**entry, "filter": entry["filter"]})
        for entry in document["shards"]
    )
    counts = folder / "operations.json.gz"
    methods, scenes, writes = load.catalogue(folder / "methods.json")
    return Run(
        name=folder.resolve().name,
        profile=same_run.profile,
        machine=_machine(machine_json, document["nearest_model"]),
        shards=shards,
        speed=_speed_frame(path, document, shards),
        refused=_refused_frame(path, document, shards),
        accuracy=_accuracy_frame(path, document),
        worst=pd.DataFrame(columns=WORST_COLUMNS),
        methods=methods,
        scenes=scenes,
        limits=load_limits(folder, same_run, packed=".gz"),
        operations=(
            load_operations(counts, same_run) if counts.exists() else no_operations()
        ),
        instructions=_instructions_frame(path, document),
        not_traced=document.get(
            "not_traced", "when this run was kept, no count of instructions was"
        ),
        modelled=pd.DataFrame(document["modelled"], columns=MODELLED_COLUMNS),
        modelled_arm=pd.DataFrame(document["modelled_arm"], columns=ARM_COLUMNS),
        nearest_model=document["nearest_model"],
        not_modelled=document["not_modelled"],
        writes=writes,
        isa_up_to=load.isa_limit(folder),
        times=load.sweep_times(folder),
        built=load.build_of(folder),
        label=document["label"],
    )


def _machine(document: dict[str, Any], nearest_model: str | None) -> Machine:
    """Older files do not tell of which design the CPU is, but their model does."""
    machine = load.machine_of(document)
    if machine.design or nearest_model is None:
        return machine
    return dataclasses.replace(machine, design=DESIGNS.get(nearest_model, ""))


def fingerprint(run: Run) -> frozenset[tuple[str, int, float]]:
    """What tells a run from all others, stored or not: its timings."""
    return frozenset(
        (name, int(repetition), _rounded(ns))
        for name, repetition, ns in zip(
            run.speed["name"], run.speed["repetition"], run.speed["ns"]
        )
    )


def _rounded(ns: float) -> float:
    return float(f"{ns:.{_DIGITS}g}")


def _plain(value: float) -> float | int | None:
    """A number as JSON has it, short; None for NaN."""
    if value != value:
        return None
    return int(value) if float(value).is_integer() else float(value)


def _nan(value: float | None) -> float:
    return math.nan if value is None else float(value)


def _shard_document(shard: Shard) -> dict[str, Any]:
    numbers = {key: _plain(getattr(shard, key)) for key in _SHARD_NUMBERS}
    known = {key: value for key, value in numbers.items() if value is not None}
    return {"name": shard.name, "filter": shard.filter, **known}


def _accuracy_documents(accuracy: pd.DataFrame) -> list[dict[str, Any]]:
    """One a cell, with all the ISAs that gave the same."""
    joined: dict[str, dict[str, Any]] = {}
    for row in accuracy.to_dict("records"):
        counts = [
            (
                None
                if row[f"{kind}_of"] != row[f"{kind}_of"]
                else [int(row[kind]), int(row[f"{kind}_of"])]
            )
            for kind in CLASSES
        ]
        weights = [_plain(_nan(row[key])) for key in _WEIGHTS]
        document = {
            "shard": row["shard"],
            "cell": row["name"].rpartition("/")[0],
            "rule": row["boundary_rule"],
            "accepts": row["accepts"],
            "points": [int(row[key]) for key in _POINTS],
            "counts": counts,
            **({"weights": weights} if any(w is not None for w in weights) else {}),
        }
        key = json.dumps(document, sort_keys=True)
        joined.setdefault(key, {**document, "isas": []})["isas"].append(row["isa"])
    return list(joined.values())


def _instruction_documents(run: Run) -> list[dict[str, Any]]:
    """One a kernel of a loop that was timed, in the order of their names."""
    traced = run.instructions[run.instructions["loop"].isin(set(run.speed["loop"]))]
    return [
        {
            "kernel": [row[key] for key in _KERNEL],
            "counts": [_plain(row[key]) for key in _EXECUTED],
        }
        for row in traced.sort_values(_KERNEL).to_dict("records")
    ]


def _instructions_frame(path: Path, document: dict[str, Any]) -> pd.DataFrame:
    """As load_instructions has them, the instructions themselves left out."""
    rows: list[dict[str, Any]] = []
    seen: set[str] = set()
    for index, entry in enumerate(document.get("instructions", [])):
        kernel = "/".join(entry["kernel"])
        _refuse_twice(path, f"$.instructions[{index}].kernel", kernel, seen)
        counts = dict(zip(_EXECUTED, entry["counts"]))
        rows.append({**dict(zip(_KERNEL, entry["kernel"])), **counts, "iteration": ()})
    frame = pd.DataFrame(rows, columns=INSTRUCTIONS_COLUMNS)
    return frame.astype({"per_call": float, "per_item": float})


def _cell_row(path: Path, field: str, shard: str, name: str) -> dict[str, Any]:
    cell = fields.cell(path, field, name)
    return {"shard": shard, "name": name, **fields.cell_columns(cell)}


def _speed_frame(
    path: Path, document: dict[str, Any], shards: tuple[Shard, ...]
) -> pd.DataFrame:
    rows: list[dict[str, Any]] = []
    seen: set[str] = set()
    for index, entry in enumerate(document["speed"]):
        field = f"$.speed[{index}]"
        _refuse_twice(path, f"{field}.cell", entry["cell"], seen)
        cell = fields.cell(path, f"{field}.cell", entry["cell"])
        shard = _shard_at(path, field, entry["shard"], shards)
        sizes = dict(zip(_SIZES, map(_nan, entry["sizes"])))
        row = {
            **_cell_row(path, f"{field}.cell", shard, entry["cell"]),
            "control": cell.control,
            "threads": cell.threads or 1,
            **sizes,
        }
        rows += [
            {**row, "repetition": repetition, "ns": float(ns)}
            for repetition, ns in enumerate(entry["ns"])
        ]
    return pd.DataFrame(rows, columns=SPEED_COLUMNS)


def _refused_frame(
    path: Path, document: dict[str, Any], shards: tuple[Shard, ...]
) -> pd.DataFrame:
    rows = [
        {
            **_cell_row(
                path,
                f"$.refused[{index}].cell",
                _shard_at(path, f"$.refused[{index}]", entry["shard"], shards),
                entry["cell"],
            ),
            "reason": entry["reason"],
        }
        for index, entry in enumerate(document["refused"])
    ]
    return pd.DataFrame(rows, columns=REFUSED_COLUMNS)


def _accuracy_frame(path: Path, document: dict[str, Any]) -> pd.DataFrame:
    classes = document["classes"]
    cells: list[dict[str, Any]] = []
    counts: list[dict[str, Any]] = []  # of an entry: its cells share them
    entry_of: list[int] = []  # of each cell
    seen: set[str] = set()
    for index, entry in enumerate(document["accuracy"]):
        field = f"$.accuracy[{index}]"
        if len(entry["counts"]) != len(classes):
            raise LoadError(
                f"{path}: {field}.counts: {len(entry['counts'])} of them for "
                f"{len(classes)} classes"
            )
        shared: dict[str, Any] = {
            "boundary_rule": entry["rule"],
            "accepts": entry["accepts"],
            **dict(zip(_POINTS, entry["points"])),
            **dict(zip(_WEIGHTS, entry.get("weights", [None] * len(_WEIGHTS)))),
        }
        for kind, counted in zip(classes, entry["counts"]):
            if counted is None:
                continue
            count, of = counted
            if count > of:
                raise LoadError(f"{path}: {field}.counts: {kind}: {count} of {of}")
            share = wilson(count, of)
            shared |= {kind: count, f"{kind}_of": of}
            shared |= {f"{kind}_low": share.low, f"{kind}_high": share.high}
        for isa in entry["isas"]:
            name = f"{entry['cell']}/{isa}"
            _refuse_twice(path, f"{field}.cell", name, seen)
            cells.append(_cell_row(path, f"{field}.cell", entry["shard"], name))
            entry_of.append(index)
        counts.append(shared)
    of_cells = pd.DataFrame(cells)
    of_entries = pd.DataFrame(counts).replace({None: np.nan}).take(entry_of)
    frame = pd.concat([of_cells, of_entries.reset_index(drop=True)], axis="columns")
    return frame.reindex(columns=ACCURACY_COLUMNS)


def _refuse_twice(path: Path, field: str, name: str, seen: set[str]) -> None:
    if name in seen:
        raise LoadError(f"{path}: {field}: {name} is there twice")
    seen.add(name)


def _shard_at(path: Path, field: str, at: int, shards: tuple[Shard, ...]) -> str:
    if at >= len(shards):
        raise LoadError(f"{path}: {field}.shard: {at}, but there are {len(shards)}")
    return shards[at].name
