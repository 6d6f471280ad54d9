"""What a run is made of: typed objects and data frames of fixed columns."""

from __future__ import annotations

import dataclasses
from typing import Final

import pandas as pd

from analysis.maps import Maps

CELL_COLUMNS: Final = ["loop", "scene", "family", "method", "scalar", "isa"]
SPEED_COLUMNS: Final = ["shard", "name", *CELL_COLUMNS] + [
    "twin",
    "repetition",
    "ns",
    "items",
    "working_set_bytes",
    "bytes_per_item",
]
REFUSED_COLUMNS: Final = ["shard", "name", *CELL_COLUMNS, "reason"]
# The ways in which answers fail; what is counted in a cell, of how many, is in
# harness/schema/accuracy.schema.json.
CLASSES: Final = [
    "false_inside",
    "false_outside",
    "boundary_accepted",
    "not_finite_accepted",
    "reversed_winding",
    "rotated_vertices",
    "swapped_vertices",
    "negated",
    "scaled_by_power_of_two",
    "hole",
    "double_hit",
]
ACCURACY_COLUMNS: Final = (
    ["shard", "name", *CELL_COLUMNS]
    + ["boundary_rule", "accepts", "points", "interior", "exterior", "boundary"]
    + ["degenerate", "not_finite", "smallest_ulps", "largest_ulps"]
    + [
        "weights_largest_ulps",
        "weights_mean_ulps",
        "weights_not_finite",
        "weights_points",
        "weights_largest_forward_ulps",
        "weights_mean_forward_ulps",
    ]
    + [
        kind + part
        for kind in CLASSES
        for part in ("", "_of", "_low", "_high", "_smallest", "_largest")
    ]
)
WORST_COLUMNS: Final = [
    "name",
    *CELL_COLUMNS,
    "kind",
    "distance_ulps",
    "said",
    "a",
    "b",
    "c",
    "p",
]


@dataclasses.dataclass(frozen=True)
class Cache:
    level: int
    type: str
    bytes: int
    shared_by: int


@dataclasses.dataclass(frozen=True)
class Machine:
    """machine.json: what the run was measured on, and with which build."""

    model: str
    microcode: str
    cores: int
    threads: int
    smt: bool | None
    governor: str | None
    virtual: bool
    hypervisor: str | None
    caches: tuple[Cache, ...]
    isas: tuple[str, ...]
    kernel: str
    distribution: str
    compiler: str
    flags: tuple[tuple[str, str, str], ...]  # (kernel source file, ISA set, flags)
    libraries: tuple[tuple[str, str], ...]
    revision: str
    dirty: bool
    seed: int
    memory_bytes: int


@dataclasses.dataclass(frozen=True)
class Shard:
    """The context of one speed file."""

    name: str
    filter: str
    cpu: int
    clock_before_ghz: float
    clock_after_ghz: float
    steal_percent: float
    load_average: float


@dataclasses.dataclass(frozen=True)
class MethodEntry:
    """What a method declares of itself (methods.json)."""

    key: str
    source: str
    formula: str
    boundary: str
    accepts: str
    fma: bool
    weights: bool
    warning: str = ""  # why the method is kept only to show what it costs


@dataclasses.dataclass(frozen=True)
class Run:
    """All results of one machine at one revision.

    speed: one row a repetition; refused: one row a cell that was not timed;
    accuracy: one row a cell, each class of failure as a count, of how many and
    its interval; worst: one row a failing input and its class (`kind`).
    `scene` is the text, `family` its first word.
    """

    name: str
    profile: str
    machine: Machine
    shards: tuple[Shard, ...]
    speed: pd.DataFrame
    refused: pd.DataFrame
    accuracy: pd.DataFrame
    worst: pd.DataFrame
    methods: tuple[MethodEntry, ...]
    scenes: tuple[tuple[str, str], ...]  # (name, what it describes)
    maps: Maps = Maps()
