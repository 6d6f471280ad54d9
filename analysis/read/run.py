"""What a run is made of: typed objects and data frames of fixed columns."""

from __future__ import annotations

import dataclasses
import math
from typing import Final

import pandas as pd

from analysis.models.arm_models import no_arm_models
from analysis.models.llvm_mca import no_models
from analysis.read.limits import Limits
from analysis.read.load_instructions import no_emulated, no_instructions
from analysis.read.load_operations import no_operations
from analysis.read.maps import Maps

CELL_COLUMNS: Final = ["loop", "scene", "family", "method", "scalar", "isa"]
SPEED_COLUMNS: Final = ["shard", "name", *CELL_COLUMNS] + [
    "control",  # empty but for cells timed again (analysis/read/cells.py)
    "threads",  # CPUs that shared each call, 1 where the name does not tell
    "repetition",
    "ns",
    "items",
    "working_set_bytes",
    "bytes_per_item",
    "scene_bytes",  # all calls together
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
    kernel_hash: str = ""  # analysis/read/kernel_hash.py; older files have none
    identity: str = ""  # the numbers that the CPU calls itself by; older have none
    design: str = ""  # by them (analysis/read/microarchitecture.py), if known

    @property
    def name(self) -> str:
        """The CPU's name, and its design where the name does not tell."""
        told = not self.design or self.design.lower() in self.model.lower()
        return self.model if told else f"{self.model}, {self.design}"

    def same_cpu(self, other: Machine) -> bool:
        """Whether both are CPUs of one model, as far as their files tell."""
        designs = {self.design, other.design} - {""}
        return (
            self.model == other.model
            and len(designs) <= 1
            and self.caches == other.caches
        )


@dataclasses.dataclass(frozen=True)
class Shard:
    """The context of one speed file; NaN where an older one does not tell."""

    name: str
    filter: str
    cpu: int
    clock_before_ghz: float
    clock_after_ghz: float
    steal_percent: float
    load_average: float
    wall_seconds: float = math.nan  # of the timing itself
    cpu_seconds: float = math.nan  # of these, how long it had the CPU
    preemptions: float = math.nan
    throughput_before_gops: float = math.nan  # older files have none
    throughput_after_gops: float = math.nan
    quiet_share: float = math.nan  # of the slices timed

    @property
    def clock_ghz(self) -> float:
        return (self.clock_before_ghz + self.clock_after_ghz) / 2


@dataclasses.dataclass(frozen=True)
class SweepTimes:
    """How long measuring took (times.json)."""

    seconds: float  # of all starts together
    starts: int
    shards: tuple[tuple[str, float], ...]  # (name, seconds), longest first


@dataclasses.dataclass(frozen=True)
class Build:
    """How long the first build of the program's folder took (build.json)."""

    seconds: int
    compiled: int  # files
    from_cache: int  # files that the compiler's cache had


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
    finite_only: bool = False  # never asked about NaN and infinity


@dataclasses.dataclass(frozen=True)
class RayMethodEntry:
    """What a method of rays declares of itself (methods.json)."""

    key: str
    source: str
    formula: str
    boundary: str
    fma: bool
    culls_backface: bool
    warning: str = ""


@dataclasses.dataclass(frozen=True)
class RayRun:
    """What a run says of rays and triangles in space: frames of the same columns
    as those of points and triangles in the plane.
    """

    speed: pd.DataFrame
    refused: pd.DataFrame
    accuracy: pd.DataFrame
    worst: pd.DataFrame
    tuv: pd.DataFrame  # columns TUV_COLUMNS
    methods: tuple[RayMethodEntry, ...] = ()
    shards: tuple[Shard, ...] = ()


TUV_COLUMNS: Final = [
    *CELL_COLUMNS,
    "rays",
    "missed",
    *(f"{name}_{kind}_ulps" for name in "tuv" for kind in ("largest", "mean")),
]


def no_rays() -> RayRun:
    """Of a run that knows none."""
    return RayRun(
        speed=pd.DataFrame(columns=SPEED_COLUMNS),
        refused=pd.DataFrame(columns=REFUSED_COLUMNS),
        accuracy=pd.DataFrame(columns=ACCURACY_COLUMNS),
        worst=pd.DataFrame(columns=WORST_COLUMNS),
        tuv=pd.DataFrame(columns=TUV_COLUMNS),
    )


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
    limits: Limits | None = None  # older runs have none
    operations: pd.DataFrame = dataclasses.field(default_factory=no_operations)
    instructions: pd.DataFrame = dataclasses.field(default_factory=no_instructions)
    not_traced: str = ""  # why there are no instructions
    emulated: pd.DataFrame = dataclasses.field(default_factory=no_emulated)
    not_emulated: str = ""  # why there are no loops of another architecture
    modelled: pd.DataFrame = dataclasses.field(default_factory=no_models)
    modelled_arm: pd.DataFrame = dataclasses.field(default_factory=no_arm_models)
    nearest_model: str | None = None  # the model of the CPU of the run
    not_modelled: str = ""  # why there are no modelled cycles
    writes: tuple[tuple[str, str], ...] = ()  # (loop, what its kernels write)
    rays: RayRun = dataclasses.field(default_factory=no_rays)
    isa_up_to: str = ""  # the widest ISA of the rows, where the sweep had a limit
    times: SweepTimes | None = None  # older runs have none
    built: Build | None = None  # only ./reproduce notes it
    label: str = ""  # what a stored run was called, if it was given a name

    @property
    def every_shard(self) -> tuple[Shard, ...]:
        """Those of points and those of rays."""
        return (*self.shards, *self.rays.shards)
