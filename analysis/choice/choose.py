"""Which method to take for a scene: the cheapest that is right for it.

Right means proved, not measured: the method's error bound (error_bounds.py) on
what the scene says of its coordinates is within the tolerance that it states,
which is 0 unless it states one; then only an exact method, or one that is exact
on such coordinates, will do. Among those the measured time decides, and where
its intervals cannot, or it differs no more than by where code lies in memory, the
stronger guarantee.

    scene → what could answer it, with times (choose_times.py)
          → which of these are right (error_bounds.py) → the cheapest
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Callable
from typing import Final

import numpy as np
import pandas as pd

from analysis.accuracy.accuracy_tables import error_rates
from analysis.accuracy.hardness import HARDNESSES
from analysis.charts.palette import method_rank
from analysis.choice.choose_scene import Scene
from analysis.choice.choose_times import ByCell, Timing, timings
from analysis.choice.error_bounds import Bound, bound_of_all, weights_bound
from analysis.read.run import MethodEntry
from analysis.speed.tables import parameter
from analysis.trust.stats import Interval, ratio_interval

RUNNERS_UP: Final = 3
TOP_LEFT: Final = "top_left"
CLOSED: Final = "closed"


@dataclasses.dataclass(frozen=True)
class Option:
    """A kernel that could answer the scene, and whether it is right for it."""

    timing: Timing
    bound: Bound
    boundary: str
    weights: float  # how far a weight may be off; infinite: it has none, or no bound
    right: bool

    @property
    def name(self) -> str:
        return self.timing.method

    @property
    def ns(self) -> float:
        return self.timing.ns


@dataclasses.dataclass(frozen=True)
class Measured:
    """How often the method erred on a family of scenes in the run."""

    where: str
    rate: float
    low: float
    high: float


@dataclasses.dataclass(frozen=True)
class Choice:
    """chosen: None if no method of the run will do. weigher: what gives the
    weights where no method that has them is right, and `chosen` decides.
    runners_up: the next cheapest that are right. nearly: the cheapest of all, if
    it is not right; best_inexact: that with the smallest bound among those that
    are not exact here.
    """

    scene: Scene
    chosen: Option | None
    weigher: Option | None
    runners_up: tuple[Option, ...]
    nearly: Option | None
    best_inexact: Option | None
    right: int
    candidates: int
    measured: tuple[Measured, ...] = ()
    alike: float = 1.0  # times that surely differ by no more than this are alike

    @property
    def nothing_inexact_is_safe(self) -> bool:
        inexact = self.best_inexact
        return inexact is None or not inexact.right

    def as_fast(self, option: Option) -> bool:
        """As the chosen one, as far as can be told."""
        assert self.chosen is not None
        return slower(option, self.chosen).low <= self.alike

    @property
    def ns(self) -> float:
        parts = [part.ns for part in (self.chosen, self.weigher) if part]
        return sum(parts) if parts else math.nan


def choose(
    scene: Scene,
    by_cell: ByCell,
    cells: pd.DataFrame,
    accuracy: pd.DataFrame,
    methods: tuple[MethodEntry, ...],
    isa: str | None = None,
    alike: float = 1.0,
) -> Choice:
    """The choice for a scene from the tables of a run. `alike`: what moving code
    changes there (trust.placement.usual_spread).
    """
    timed = timings(scene, by_cell, cells, methods, isa)
    plain: list[Timing] = []
    if scene.need == "weights":
        decided = dataclasses.replace(scene, need="class")
        plain = timings(decided, by_cell, cells, methods, isa)
    choice = decide(scene, timed, methods, plain, alike)
    if choice.chosen is None:
        return choice
    return dataclasses.replace(
        choice, measured=_measured(accuracy, scene, choice.chosen)
    )


def decide(
    scene: Scene,
    timed: list[Timing],
    methods: tuple[MethodEntry, ...],
    plain: list[Timing] | None = None,
    alike: float = 1.0,
) -> Choice:
    """The choice among kernels whose times are known. `plain`: those that give
    no weights; where weights are needed and no method that gives them is right,
    one of these decides and another weighs.
    """
    found = options(scene, timed, methods)
    right = ranked([option for option in found if option.right], alike)
    weigher = None
    if scene.need == "weights" and not right:
        weighers = ranked([o for o in found if math.isfinite(o.weights)], alike)
        weigher = weighers[0] if weighers else None
        decided = dataclasses.replace(scene, need="class")
        others = options(decided, plain or [], methods)
        right = ranked([o for o in others if o.right], alike) if weigher else []
        found = others + found
    chosen = right[0] if right else None
    inexact = [o for o in found if not o.bound.exact]
    faster = [o for o in found if not o.right and (chosen is None or o.ns < chosen.ns)]
    return Choice(
        scene=scene,
        chosen=chosen,
        weigher=weigher if chosen else None,
        runners_up=tuple(right[1 : 1 + RUNNERS_UP]),
        nearly=_least(faster, lambda o: (o.ns,)),
        best_inexact=_least(inexact, lambda o: (o.bound.distance, o.ns)),
        right=len(right),
        candidates=len({option.name for option in found}),
        alike=alike,
    )


def _least(
    found: list[Option], key: Callable[[Option], tuple[float, ...]]
) -> Option | None:
    return min(found, key=key) if found else None


def ranked(found: list[Option], alike: float = 1.0) -> list[Option]:
    """The cheapest first. Those that surely take no more than `alike` times as long
    as the cheapest one stand before the others, the strongest guarantee first. Of a
    method in several loops or scalars only the cheapest is listed.
    """
    once: dict[str, Option] = {}
    for option in sorted(found, key=lambda o: (o.ns, method_rank(o.name))):
        once.setdefault(option.name, option)
    if not once:
        return []
    best = next(iter(once.values()))
    equals = [o for o in once.values() if slower(o, best).low <= alike]
    rest = [o for o in once.values() if slower(o, best).low > alike]
    return sorted(equals, key=_guarantee) + rest


def slower(option: Option, than: Option) -> Interval:
    """How many times as long as another an option takes."""
    if option is than:
        return Interval(1.0, 1.0, 1.0, 1.0)
    return _ratio(option.timing.values, than.timing.values)


@functools.cache
def _ratio(top: tuple[float, ...], bottom: tuple[float, ...]) -> Interval:
    if min(len(top), len(bottom)) < 2:
        ratio = float(np.median(top) / np.median(bottom))
        return Interval(ratio, ratio, ratio, 1.0)
    return ratio_interval(np.array(top), np.array(bottom))


def _guarantee(option: Option) -> tuple[object, ...]:
    return (
        not option.bound.exact,
        option.bound.distance,
        option.timing.estimated,
        option.boundary != CLOSED,
        method_rank(option.name),
    )


def is_right(scene: Scene, found: Bound, boundary: str) -> bool:
    """Whether what is proved of a method is what the scene needs."""
    if scene.need == "watertight":
        # An exact answer by a rule that gives every edge and vertex away once.
        return found.exact and boundary == TOP_LEFT
    if scene.need == "exact":
        return found.exact
    return found.exact or found.distance <= scene.tolerance


def options(
    scene: Scene, found: list[Timing], methods: tuple[MethodEntry, ...]
) -> list[Option]:
    declared = {entry.key: entry for entry in methods}
    judged = []
    for timing in found:
        extents = scene.extents(timing.scalar)
        proved = bound_of_all(timing.method, extents)
        boundary = declared[timing.method].boundary
        judged.append(
            Option(
                timing=timing,
                bound=proved,
                boundary=boundary,
                weights=max(weights_bound(timing.method, e) for e in extents),
                right=is_right(scene, proved, boundary),
            )
        )
    return judged


def _measured(
    accuracy: pd.DataFrame, scene: Scene, chosen: Option
) -> tuple[Measured, ...]:
    """Its error rates near an edge, and on the needles and distances from the
    origin of the run that are nearest to the scene's.
    """
    own = accuracy[
        (accuracy["method"] == chosen.name)
        & (accuracy["scalar"] == chosen.timing.scalar)
    ]
    isa = own[own["isa"] == chosen.timing.isa]
    own = isa if len(isa) else own
    extent = scene.extent()
    wanted = {"near_edge": math.nan}
    if scene.altitude > 0:
        slim = scene.aspect or extent.longest / scene.altitude
        wanted["needle"] = math.log2(slim)
    if extent.largest > extent.width:
        wanted["offset"] = math.log2(extent.largest / extent.width)
    found = []
    for hardness in HARDNESSES:
        if hardness.family not in wanted:
            continue
        rows = own[own["family"] == hardness.family]
        where = "near an edge"
        if not math.isnan(wanted[hardness.family]) and len(rows):
            at = parameter(rows, hardness.key)
            nearest = at.loc[(at - wanted[hardness.family]).abs().idxmin()]
            rows, where = rows[at == nearest], hardness.words(nearest)
        if len(rows):
            found.append(_pooled(rows, where))
    if not found and len(own):
        found.append(_pooled(own, "on " + str(own["family"].iloc[0])))
    return tuple(found)


def _pooled(rows: pd.DataFrame, where: str) -> Measured:
    rates = error_rates(rows, ["method"]).iloc[0]
    return Measured(
        where,
        float(rates["error_rate"]),
        float(rates["error_rate_low"]),
        float(rates["error_rate_high"]),
    )
