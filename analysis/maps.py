"""What the report's pictures are drawn from (maps.json), as arrays."""

from __future__ import annotations

import dataclasses

import numpy as np
import numpy.typing as npt

Bits = npt.NDArray[np.bool_]


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
class Maps:
    ulp_maps: tuple[UlpMap, ...] = ()
    gradients: tuple[Gradient, ...] = ()
    two_truths: tuple[TwoTruths, ...] = ()
