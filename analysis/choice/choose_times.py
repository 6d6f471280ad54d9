"""What a point costs a scene: every kernel of a run that could answer it, with
the time that was measured nearest to the scene.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from collections.abc import Iterator, Mapping
from typing import Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.charts.palette import is_autovec
from analysis.choice.choose_scene import Scene
from analysis.choice.extent import DIGITS, INTEGER_RANGE
from analysis.read.cells import WEIGHTS_SUFFIX
from analysis.read.run import MethodEntry
from analysis.report.method_families import FMA_SUFFIX
from analysis.speed.grid_tables import GRID, POINTS, pixels
from analysis.speed.tables import parameter, reference_scene
from analysis.trust.stats import median_interval

# From so many points on, a triangle's set-up is lost among them.
MANY: Final = 1024
_NEAR: Final = 2.0  # a size that is no more times as large stands for another
_VARIANTS: Final = (FMA_SUFFIX, "_top_left", "_open", "_closed")  # share a set-up
_LIBRARY: Final = "library"

Samples = npt.NDArray[np.float64]
ByCell = Mapping[tuple[str, str], Samples]


@dataclasses.dataclass(frozen=True)
class Timing:
    """A kernel and what it takes a point. `values`: of each repetition, ns."""

    method: str
    scalar: str
    loop: str
    isa: str
    scene: str
    values: tuple[float, ...]
    noise: str = ""
    estimated: bool = False  # from the time of many points, and of a set-up

    @functools.cached_property
    def ns(self) -> float:
        return float(np.median(self.values))

    @functools.cached_property
    def interval(self) -> tuple[float, float]:
        if len(self.values) < 2:
            return (self.ns, self.ns)
        found = median_interval(np.array(self.values))
        return (found.low, found.high)


def timings(
    scene: Scene,
    by_cell: ByCell,
    cells: pd.DataFrame,
    methods: tuple[MethodEntry, ...],
    isa: str | None = None,
) -> list[Timing]:
    """One a method × scalar × loop, from tables.samples and tables.speed_cells
    of a run: on the ISA, or where none is given on that
    which takes the least time. Methods that are kept as a warning, that decide
    something else, and other libraries are left out.
    """
    fit = {
        entry.key
        for entry in methods
        if not entry.warning and entry.accepts == "triangle"
    }
    mine = cells[
        cells["method"].isin(list(fit))
        & (cells["isa"] != _LIBRARY)
        & (cells["isa"].eq(isa) if isa else ~cells["isa"].map(is_autovec).astype(bool))
    ]
    found: dict[tuple[str, str, str], Timing] = {}
    for timing in _every(scene, by_cell, mine):
        key = (timing.method, timing.scalar, timing.loop)
        if key not in found or timing.ns < found[key].ns:
            found[key] = timing
    return sorted(found.values(), key=lambda timing: (timing.ns, timing.method))


def stored_as(scene: Scene) -> list[str]:
    """The scalars that hold every coordinate, whole numbers also as others."""
    if scene.scalar not in INTEGER_RANGE:
        return [scene.scalar]
    extent = scene.extent()
    whole = [
        scalar
        for scalar, (least, most) in INTEGER_RANGE.items()
        if least <= extent.low and extent.high <= most
    ]
    return whole + [s for s in DIGITS if extent.largest <= 2.0 ** DIGITS[s]]


def _every(scene: Scene, by_cell: ByCell, cells: pd.DataFrame) -> Iterator[Timing]:
    for scalar in stored_as(scene):
        rows = cells[cells["scalar"] == scalar]
        if scalar in INTEGER_RANGE:
            yield from _whole_points(scene, by_cell, rows)
        else:
            yield from _float_points(scene, by_cell, rows, cells)
    if scene.grid and scene.whole:
        yield from _grids(by_cell, cells[cells["family"] == GRID])


def _float_points(
    scene: Scene,
    by_cell: ByCell,
    rows: pd.DataFrame,
    cells: pd.DataFrame,
) -> Iterator[Timing]:
    suffix = WEIGHTS_SUFFIX if scene.need == "weights" else ""
    points = float(math.prod(scene.grid)) if scene.grid else scene.points
    if points < 1:
        yield from _at_reference(by_cell, rows, f"one_point{suffix}")
        return
    loop = f"one_triangle{suffix}"
    if points >= MANY:
        yield from _at_reference(by_cell, rows, loop, scene.hit)
        return
    yield from _at_reference(by_cell, rows, f"pairs{suffix}")
    yield from _few_points(by_cell, rows, loop, points, set_ups(cells))


def _at_reference(
    by_cell: ByCell,
    rows: pd.DataFrame,
    loop: str,
    hit: float | None = None,
) -> Iterator[Timing]:
    """On the loop's reference scene, or its like with the hit rate nearest to
    `hit` where the method was timed on that.
    """
    scene = reference_scene(rows, loop)
    if scene is None:
        return
    of_loop = rows[rows["loop"] == loop]
    chosen = of_loop[of_loop["scene"] == scene]
    if hit is not None:
        alike = of_loop[
            of_loop["scene"].map(lambda s: _but_for_hit(s) == _but_for_hit(scene))
        ]
        away = (parameter(alike, "hit") - 100 * hit).abs()
        nearest = alike.assign(away=away).sort_values("away", kind="stable")
        chosen = nearest.drop_duplicates(["method", "isa"])
    for row in chosen.to_dict("records"):
        yield _timing(row, by_cell[row["shard"], row["name"]])


def _but_for_hit(scene: str) -> str:
    parts = [part for part in scene.split(":") if not part.startswith("hit=")]
    return ":".join(parts)


def _few_points(
    by_cell: ByCell,
    rows: pd.DataFrame,
    loop: str,
    points: float,
    known: dict[tuple[str, str], float],
) -> Iterator[Timing]:
    """As timed with about as many points a triangle; else what many take, and
    the set-up shared out, as far as it is known.
    """
    sized = _sized(rows, loop)
    for timing in _at_reference(by_cell, rows, loop):
        own = sized[(sized["method"] == timing.method) & (sized["isa"] == timing.isa)]
        ratio = (own["n"] / points).map(math.log2).abs()
        if len(own) and ratio.min() <= math.log2(_NEAR):
            row = own.loc[ratio.idxmin()].to_dict()
            yield _timing(row, by_cell[row["shard"], row["name"]])
            continue
        set_up = known.get((_base(timing.method, known), timing.isa))
        if set_up is not None:
            longer = tuple(value + set_up / points for value in timing.values)
            yield dataclasses.replace(timing, values=longer, estimated=True)


def _sized(rows: pd.DataFrame, loop: str) -> pd.DataFrame:
    """Its cells that were timed with so many points a call, column `n`."""
    sized = rows[
        (rows["loop"] == loop) & (rows["family"] == "uniform") & ~_is_fixed(rows)
    ]
    return sized.assign(n=parameter(sized, "n")).dropna(subset=["n"])


def set_ups(cells: pd.DataFrame) -> dict[tuple[str, str], float]:
    """(method, ISA) → what a call takes beside its points, in ns: from those of
    few points, over what as many take among many. Where several scalars were
    timed so, the first one's stands for all.
    """
    found: dict[tuple[str, str], float] = {}
    for scalar in DIGITS:
        rows = cells[cells["scalar"] == scalar]
        reference = reference_scene(rows, "one_triangle")
        many = rows[(rows["loop"] == "one_triangle") & (rows["scene"] == reference)]
        slope = {(row.method, row.isa): row.ns for row in many.itertuples()}
        few = _sized(rows, "one_triangle")
        few = few[few["n"] < MANY]
        for key, group in few.groupby(["method", "isa"], sort=True):
            if key in slope and key not in found:
                over = (group["n"] * (group["ns"] - slope[key])).median()
                found[key] = max(float(over), 0.0)
    return found


def _base(method: str, known: dict[tuple[str, str], float]) -> str:
    """The variant of a method that shares its set-up and is known."""
    timed = {name for name, _ in known}
    for variant in _VARIANTS:
        if method not in timed:
            method = method.replace(variant, "")
    return method


def _whole_points(
    scene: Scene, by_cell: ByCell, rows: pd.DataFrame
) -> Iterator[Timing]:
    """Whole numbers as a list of points, which only the loop one_triangle has."""
    points = math.prod(scene.grid) if scene.grid else scene.points
    if scene.need == "weights" or points < 1:
        return
    chosen = rows[(rows["family"] == POINTS) & ~_is_fixed(rows)]
    for row in chosen.to_dict("records"):
        yield _timing(row, by_cell[row["shard"], row["name"]])


def _grids(by_cell: ByCell, rows: pd.DataFrame) -> Iterator[Timing]:
    """Their times are those of a triangle: here, of each of its pixels."""
    for row in rows[~_is_fixed(rows)].to_dict("records"):
        own = by_cell[row["shard"], row["name"]] / pixels(row["family"])
        yield _timing(row, own)


def _is_fixed(rows: pd.DataFrame) -> pd.Series:
    return rows["scene"].str.contains("sets=fixed", regex=False)


def _timing(row: dict[str, object], values: Samples) -> Timing:
    return Timing(
        method=str(row["method"]),
        scalar=str(row["scalar"]),
        loop=str(row["loop"]),
        isa=str(row["isa"]),
        scene=str(row["scene"]),
        values=tuple(float(value) for value in values),
        noise=str(row["noise"]),
    )
