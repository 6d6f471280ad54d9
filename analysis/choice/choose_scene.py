"""A scene as somebody who has to choose a method describes it, checked."""

from __future__ import annotations

import dataclasses
import math
import shlex
from typing import Final

from analysis.choice.extent import DIGITS, INTEGER_RANGE, LARGEST, Extent

SCALARS: Final = (*DIGITS, *INTEGER_RANGE)
NEEDS: Final = ("class", "weights", "watertight", "exact")


class SceneError(ValueError):
    """The description makes no sense: what, in which option, what to do."""


@dataclasses.dataclass(frozen=True)
class Scene:
    """low, high: all coordinates of triangles and points lie between. altitude:
    no triangle has a smaller one. edges: the longest edge of the smallest and
    of the largest triangle. points: a triangle is asked about so many; below 1,
    a point is asked about by many triangles. hit: the share inside. grid: the
    points are the pixels, (column, row). precision: all coordinates are whole
    multiples of it (0: unknown). tolerance: within this distance from an edge
    either answer will do. aspect: no triangle has a larger ratio of
    its longest edge to its smallest altitude (0: as `altitude` and `edges` say).
    """

    scalar: str
    low: float
    high: float
    altitude: float
    edges: tuple[float, float]
    points: float
    hit: float
    grid: tuple[int, int] | None = None
    need: str = "class"
    precision: float = 0.0
    tolerance: float = 0.0
    aspect: float = 0.0

    @property
    def whole(self) -> bool:
        """Whether all coordinates are whole numbers."""
        return self.scalar in INTEGER_RANGE or (
            self.precision >= 1 and float(self.precision).is_integer()
        )

    def extent(self, scalar: str = "") -> Extent:
        """What is known of it to an error bound, stored in `scalar`."""
        low, high = self.low, self.high
        if self.grid:
            low = min(low, 0.0)
            high = max(high, *(float(side - 1) for side in self.grid))
        step = 1.0 if self.whole and not self.precision else self.precision
        return Extent(
            scalar=scalar or self.scalar,
            low=low,
            high=high,
            altitude=self.altitude,
            longest=self.edges[1],
            # Pixels are whole, and need not be multiples of more than 1.
            quantum=min(step, 1.0) if self.grid else step,
        )

    def extents(self, scalar: str = "") -> tuple[Extent, ...]:
        """Those of which a bound has to hold: of the smallest triangles and of
        the largest, where their slimness is known apart from their size.
        """
        every = self.extent(scalar)
        if not self.aspect:
            return (every,)
        return tuple(
            dataclasses.replace(every, longest=edge, altitude=edge / self.aspect)
            for edge in dict.fromkeys(self.edges)
        )


@dataclasses.dataclass(frozen=True)
class Described:
    """The options as they were given; None where they were not."""

    scalar: str
    coordinates: tuple[float, float]
    altitude: float | None = None
    aspect: float | None = None
    edge: tuple[float, ...] | None = None
    points: float = 4096.0
    hit: float = 0.5
    grid: tuple[int, int] | None = None
    need: str = "class"
    precision: float = 0.0
    tolerance: float = 0.0

    @property
    def command(self) -> str:
        """What makes this choice again."""
        low, high = self.coordinates
        words = ["python3", "-m", "analysis", "choose", "--scalar", self.scalar]
        words += ["--coordinates", _number(low), _number(high)]
        if self.altitude is not None:
            words += ["--altitude", _number(self.altitude)]
        if self.aspect is not None:
            words += ["--aspect", _number(self.aspect)]
        if self.edge is not None:
            words += ["--edge", *map(_number, self.edge)]
        words += ["--points-per-triangle", _number(self.points)]
        words += ["--hit-rate", _number(self.hit)]
        if self.grid is not None:
            words += ["--grid", *map(str, self.grid)]
        words += ["--need", self.need]
        if self.precision:
            words += ["--precision", _number(self.precision)]
        if self.tolerance:
            words += ["--tolerance", _number(self.tolerance)]
        return shlex.join(words)


def _number(value: float) -> str:
    return f"{value:g}" if float(f"{value:g}") == value else repr(value)


def checked(given: Described) -> Scene:
    """The scene, or SceneError."""
    low, high = given.coordinates
    _check_range(given.scalar, low, high)
    width = high - low
    edges = _edges(given, width)
    altitude = given.altitude
    if altitude is None and given.aspect is None:
        raise SceneError(
            "--altitude or --aspect is missing: how thin triangles may be decides "
            "what rounding does; --altitude 0 if they may be degenerate"
        )
    if altitude is not None and given.aspect is not None:
        raise SceneError("--altitude and --aspect say the same: give one of them")
    if given.aspect is not None:
        if not given.aspect >= 2 / math.sqrt(3) * (1 - 1e-9):
            raise SceneError(
                f"--aspect {given.aspect:g}: the longest edge over the smallest "
                "altitude is at least 1.1547, that of equal sides"
            )
        altitude = edges[0] / given.aspect
    assert altitude is not None
    most = edges[1] * math.sqrt(3) / 2
    if not 0 <= altitude <= most * (1 + 1e-9):
        raise SceneError(
            f"--altitude {altitude:g}: must be from 0 to {most:g}; no triangle "
            f"whose edges are at most {edges[1]:g} long has a smallest one beyond it"
        )
    _check_rest(given, width)
    return Scene(
        scalar=given.scalar,
        low=low,
        high=high,
        altitude=altitude,
        edges=edges,
        points=given.points,
        hit=given.hit,
        grid=given.grid,
        need=given.need,
        precision=given.precision,
        tolerance=given.tolerance,
        aspect=given.aspect or 0.0,
    )


def _check_range(scalar: str, low: float, high: float) -> None:
    text = f"--coordinates {low:g} {high:g}"
    if scalar not in SCALARS:
        raise SceneError(f"--scalar {scalar}: give one of {', '.join(SCALARS)}")
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise SceneError(f"{text}: give two finite numbers, the smaller one first")
    if scalar in INTEGER_RANGE:
        least, most = INTEGER_RANGE[scalar]
        if not (float(low).is_integer() and float(high).is_integer()):
            raise SceneError(
                f"{text}: {scalar} holds whole numbers only; give such a range, or "
                "--scalar f32"
            )
        if low < least or high > most:
            raise SceneError(
                f"{text}: {scalar} holds numbers from {least} to {most}; give "
                "another --scalar"
            )
    elif max(abs(low), abs(high)) >= LARGEST[scalar]:
        raise SceneError(f"{text}: {scalar} has no numbers this large")


def _edges(given: Described, width: float) -> tuple[float, float]:
    most = math.sqrt(2) * width
    if given.edge is None:
        # A triangle as wide as the range, and the diagonal of the square.
        return (width, most)
    if len(given.edge) > 2:
        raise SceneError(
            f"--edge {' '.join(map(_number, given.edge))}: give one length, or the "
            "shortest and the longest"
        )
    edges = (given.edge[0], given.edge[-1])
    if not 0 < edges[0] <= edges[1] <= most * (1 + 1e-9):
        raise SceneError(
            f"--edge {' '.join(map(_number, given.edge))}: the lengths must be above "
            f"0, the shorter one first, and at most {most:g}, the diagonal of the "
            "range of --coordinates"
        )
    return edges


def _check_rest(given: Described, width: float) -> None:
    if not (given.points > 0 and math.isfinite(given.points)):
        raise SceneError(
            f"--points-per-triangle {given.points:g}: must be above 0; below 1 if a "
            "point is asked about by many triangles"
        )
    if not 0 <= given.hit <= 1:
        raise SceneError(
            f"--hit-rate {given.hit:g}: the share of points inside is from 0 to 1"
        )
    if given.need not in NEEDS:
        raise SceneError(f"--need {given.need}: give one of {', '.join(NEEDS)}")
    if not (given.precision >= 0 and math.isfinite(given.precision)):
        raise SceneError(
            f"--precision {given.precision:g}: give the step of which all "
            "coordinates are multiples, 1 for whole numbers"
        )
    if given.precision > width:
        raise SceneError(
            f"--precision {given.precision:g}: larger than the whole range of "
            f"--coordinates, {width:g}"
        )
    if not (given.tolerance >= 0 and math.isfinite(given.tolerance)):
        raise SceneError(
            f"--tolerance {given.tolerance:g}: a distance from an edge, 0 or more"
        )
    if given.tolerance and given.need in ("exact", "watertight"):
        raise SceneError(
            f"--tolerance {given.tolerance:g}: --need {given.need} allows no wrong "
            "answer; leave one of them out"
        )
    if given.grid is not None:
        if min(given.grid) < 1:
            raise SceneError(
                f"--grid {given.grid[0]} {given.grid[1]}: give the columns and rows, "
                "1 or more"
            )
        if given.need == "weights":
            raise SceneError(
                "--grid: its kernels write no weights; give --need class, or leave "
                "--grid out"
            )
