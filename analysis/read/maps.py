"""What the report's pictures are drawn from (maps.json), as arrays."""

from __future__ import annotations

import dataclasses
from typing import Protocol

import numpy as np
import numpy.typing as npt

Bits = npt.NDArray[np.bool_]
Counts = npt.NDArray[np.intp]


@dataclasses.dataclass(frozen=True)
class UlpMap:
    """What a method says of the points (0.5 + i·u, 0.5 + j·u), j the row, in
    two triangles that share the diagonal i = j: `lower` holds i > j exactly,
    `upper` i < j.
    """

    method: str
    scalar: str
    isa: str
    lower: Bits
    upper: Bits
    counts: dict[str, int]

    @property
    def claims(self) -> Counts:
        """How many triangles claim each point."""
        return self.lower.astype(np.intp) + self.upper

    @property
    def on_edge(self) -> Bits:
        j, i = np.indices(self.lower.shape)
        return np.asarray(i == j)


@dataclasses.dataclass(frozen=True)
class RayMap:
    """How many of the triangles around a vertex of a closed surface claim each
    ray of a window of directions, j the row: `claimed` one or more, `twice` two
    or more. `on_edge`: the rays that exactly meet an edge or a vertex.
    """

    method: str
    scalar: str
    isa: str
    claimed: Bits
    twice: Bits
    on_edge: Bits
    counts: dict[str, int]

    @property
    def claims(self) -> Counts:
        """As many as 2 where there are more."""
        return self.claimed.astype(np.intp) + self.twice


class ClaimMap(Protocol):
    """What a picture of claims is drawn from."""

    @property
    def method(self) -> str:
        ...

    @property
    def claims(self) -> Counts:
        ...

    @property
    def on_edge(self) -> Bits:
        ...


@dataclasses.dataclass(frozen=True)
class Gradient:
    """The weights that a method computes on a grid of points over a triangle."""

    method: str
    scalar: str
    isa: str
    scene: str
    corners: tuple[tuple[float, float], ...]
    weights: npt.NDArray[np.float32]  # height × width × 3, NaN where none
    inside: Bits


@dataclasses.dataclass(frozen=True)
class TwoTruths:
    """A case from a report: exact for the binary numbers, and for the decimals
    that somebody typed.
    """

    id: str
    source: str
    scalar: str
    binary: str
    decimal: str


@dataclasses.dataclass(frozen=True)
class RayCase:
    """A published case of a ray: the exact answer and who hits."""

    id: str
    source: str
    scalar: str
    truth: str
    answers: tuple[tuple[str, bool], ...]  # (method, whether it hits)


@dataclasses.dataclass(frozen=True)
class Maps:
    ulp_maps: tuple[UlpMap, ...] = ()
    gradients: tuple[Gradient, ...] = ()
    two_truths: tuple[TwoTruths, ...] = ()
    ray_maps: tuple[RayMap, ...] = ()  # older runs have none
    ray_cases: tuple[RayCase, ...] = ()
