"""Seeded scenes of every kind, with points where methods err, as the tests of
the error bounds ask real kernels about: near edges, beyond sharp corners, on
the far side of a range.
"""

from __future__ import annotations

import dataclasses
import subprocess
from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

from analysis.choice.extent import Extent

PROGRAM = Path(__file__).resolve().parent.parent.parent / "build" / "pitbench"
TYPES = {"f32": np.float32, "f64": np.float64}
HEADER = "ax,ay,bx,by,cx,cy,px,py"
_TRIANGLES = 40  # a scene

Rows = npt.NDArray[Any]


@dataclasses.dataclass(frozen=True)
class HardScene:
    """rows: ax, ay, bx, by, cx, cy, px, py of every case. by_aspect: what is known
    of them from the slimness of the slimmest and the sizes of all.
    """

    extent: Extent
    by_aspect: tuple[Extent, ...]
    rows: Rows


def hard_scene(seed: int, scalar: str, points: int) -> HardScene:
    """One scene, its extent that of what was drawn: a place and a size of the
    range over many binades, triangles of one size and slimness within, points
    that seek trouble. What rounds to triangles without area is drawn again.
    """
    random = np.random.default_rng(seed)
    while True:
        scene = _drawn(random, scalar, points)
        if scene is not None:
            return scene


def _drawn(random: Any, scalar: str, points: int) -> HardScene | None:
    digits = {"f32": 24, "f64": 53}[scalar]
    width = 2.0 ** random.uniform(-12, 12)
    # A quarter at the origin, the others up to where few digits are left.
    away = random.choice([0, random.uniform(0, 0.8 * digits)], p=[0.25, 0.75])
    low = width * random.choice([-0.5, 2.0**away if away else 0.0])
    quantum = 0.0
    if random.random() < 0.25:  # whole multiples of a power of two
        quantum = 2.0 ** (np.floor(np.log2(width)) - int(random.integers(3, 12)))
        low = np.round(low / quantum) * quantum
    size = width * 2.0 ** -random.choice([0, random.uniform(0, 6)])
    slim = 2.0 ** random.uniform(0, random.choice([2, 0.45 * digits]))
    slim = min(slim, size / quantum) if quantum else slim
    triangles = _triangles(random, low, width, size, slim)
    rows = np.repeat(triangles, -(-points // _TRIANGLES), axis=0)[:points]
    rows = np.hstack([rows, _points(random, rows, low, width, digits)])
    rows = np.clip(rows, low, low + width)
    if quantum:
        rows = np.round(rows / quantum) * quantum
    rows = rows.astype(TYPES[scalar])
    heights = _altitudes(rows)
    # The thinnest triangle, not a thinner one by accident, gives the bound.
    rows = rows[heights > np.median(heights) / 4]
    if len(rows) < points / 2:
        return None
    rows = rows[np.arange(points) % len(rows)]
    extent = _extent(scalar, rows, quantum)
    return HardScene(extent, _by_aspect(extent, rows), rows)


def _triangles(random: Any, low: float, width: float, size: float, slim: float) -> Rows:
    """A longest edge of about `size` in any direction, and an apex over it at
    about size/slim; in half of the scenes some are up to 16 times as large.
    """
    size = size * 2.0 ** random.uniform(0, random.choice([0, 4]), (40, 1))
    size = np.minimum(size, width)
    centre = low + size / 2 + (width - size) * random.uniform(0, 1, (40, 2))
    angle = random.uniform(0, 2 * np.pi, 40)
    along = np.stack([np.cos(angle), np.sin(angle)], 1) * size * 0.45
    across = np.stack([-along[:, 1], along[:, 0]], 1) * 1.7 / slim
    apex = centre + along * random.uniform(-1, 1, (40, 1)) + across
    return np.hstack([centre - along, centre + along, apex])


def _points(random: Any, rows: Rows, low: float, width: float, digits: int) -> Rows:
    """A third on edges and moved off them a little, a third beyond a corner
    along its bisector or along an edge, and the rest anywhere.
    """
    count = len(rows)
    corners = rows.reshape(count, 3, 2)
    first = random.integers(0, 3, count)
    every = np.arange(count)
    a = corners[every, first]
    b = corners[every, (first + 1) % 3]
    c = corners[every, (first + 2) % 3]
    off = 2.0 ** random.uniform(-digits - 2, 0, (count, 1))
    sign = random.choice([-1, 1], (count, 1))
    edge = b - a
    length = np.linalg.norm(edge, axis=1, keepdims=True)
    normal = np.stack([-edge[:, 1], edge[:, 0]], 1) / np.maximum(length, 1e-300)
    reach = np.maximum(length, np.abs(rows).max(axis=1, keepdims=True) * 2.0**-digits)
    on_edge = a + edge * random.uniform(0, 1, (count, 1))
    near = on_edge + normal * sign * off * reach * 2.0 ** random.uniform(-8, 0)
    middle = a - (b + c) / 2
    beyond = a + random.choice([0, 1], (count, 1)) * middle * off
    beyond = beyond + (a - b) * off * random.uniform(0, 1, (count, 1))
    anywhere = random.uniform(low, low + width, (count, 2))
    kind = random.integers(0, 5, (count, 1))
    return np.select([kind < 2, kind < 4], [near, beyond], anywhere)


def _altitudes(rows: Rows) -> Rows:
    """Twice the area over the longest edge, in more digits than the rows have."""
    r = rows.astype(np.longdouble)
    ab, ac = r[:, 2:4] - r[:, 0:2], r[:, 4:6] - r[:, 0:2]
    area = np.abs(ab[:, 0] * ac[:, 1] - ab[:, 1] * ac[:, 0])
    longest = _longest(rows)
    return np.where(longest > 0, area / np.maximum(longest, 1e-300), 0)


def _longest(rows: Rows) -> Rows:
    r = rows.astype(np.longdouble)
    edges = [r[:, i : i + 2] - r[:, j : j + 2] for i, j in ((2, 0), (4, 2), (0, 4))]
    return np.max([np.hypot(e[:, 0], e[:, 1]) for e in edges], axis=0)


def _extent(scalar: str, rows: Rows, quantum: float) -> Extent:
    return Extent(
        scalar=scalar,
        low=float(rows.min()),
        high=float(rows.max()),
        altitude=float(_altitudes(rows).min()) * (1 - 1e-12),
        longest=float(_longest(rows).max()) * (1 + 1e-12),
        quantum=quantum,
    )


def _by_aspect(extent: Extent, rows: Rows) -> tuple[Extent, ...]:
    longest = _longest(rows)
    aspect = float((longest / _altitudes(rows)).max()) * (1 + 1e-12)
    ends = (float(longest.min()) * (1 - 1e-12), extent.longest)
    return tuple(
        dataclasses.replace(extent, longest=end, altitude=end / aspect) for end in ends
    )


def distances(rows: Rows) -> Rows:
    """From each point to its triangle's boundary, in eleven digits (of two) more
    than f64 has.
    """
    r = rows.astype(np.longdouble)
    p = r[:, 6:8]
    found = []
    for i, j in ((0, 2), (2, 4), (4, 0)):
        v, edge = r[:, i : i + 2], r[:, j : j + 2] - r[:, i : i + 2]
        way = p - v
        square = (edge * edge).sum(axis=1)
        along = np.clip((edge * way).sum(axis=1) / square, 0, 1)
        cross = np.abs(edge[:, 0] * way[:, 1] - edge[:, 1] * way[:, 0])
        gap = way - edge * along[:, None]
        within = (along > 0) & (along < 1)
        to_line = cross / np.sqrt(square)
        found.append(np.where(within, to_line, np.hypot(gap[:, 0], gap[:, 1])))
    return np.min(found, axis=0)


def write_cases(path: Path, rows: Rows) -> None:
    """In as many digits as tell every number from its neighbours."""
    digits = 9 if rows.dtype == np.float32 else 17
    np.savetxt(path, rows, f"%.{digits - 1}e", ",", header=HEADER, comments="")


def answers(method: str, scalar: str, path: Path) -> npt.NDArray[np.str_]:
    """What the program says of every case."""
    call = [str(PROGRAM), "classify", "--method", method, "--scalar", scalar]
    ran = subprocess.run([*call, str(path)], capture_output=True, text=True)
    if ran.returncode:
        raise AssertionError(ran.stderr)
    return np.array(ran.stdout.split())


def wrong(said: npt.NDArray[np.str_], truth: npt.NDArray[np.str_]) -> Rows:
    """Where an answer is wrong; boundaries are each method's own affair."""
    return ((truth == "inside") & (said == "outside")) | (
        (truth == "outside") & (said == "inside")
    )


SCENES = 300  # for each scalar
POINTS = 2000  # in each scene

needs_program = pytest.mark.skipif(
    not PROGRAM.exists(), reason=f"{PROGRAM} is not built"
)


class Asked:
    """All scenes of a scalar as one file of cases, and what kernels say of them.
    which: the scene of each case.
    """

    def __init__(self, scalar: str, path: Path) -> None:
        self.scalar = scalar
        self.path = path
        self.scenes = [hard_scene(k, scalar, POINTS) for k in range(SCENES)]
        rows = np.vstack([scene.rows for scene in self.scenes])
        write_cases(path, rows)
        counts = [len(scene.rows) for scene in self.scenes]
        self.which = np.repeat(np.arange(SCENES), counts)
        self.distance = distances(rows).astype(np.float64)
        self.truth = answers("truth", scalar, path)
        self._said: dict[str, Rows] = {}

    def said(self, method: str) -> Rows:
        if method not in self._said:
            self._said[method] = answers(method, self.scalar, self.path)
        return self._said[method]

    def wrong(self, method: str) -> Rows:
        return wrong(self.said(method), self.truth)
