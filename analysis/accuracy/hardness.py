"""The families of scenes whose parameter makes their members harder."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Iterable
from typing import Final

from analysis.report.wording import plain, power_of_two


@dataclasses.dataclass(frozen=True)
class Hardness:
    """A family of scenes and the parameter that makes its members harder."""

    family: str
    key: str
    axis: str
    what: str
    harder: str  # "falls", "grows" or "leaves 1": where the parameter is hard
    scale: str  # "log"; "power": an exponent of two; "linear"
    worded: str  # a value of it in a sentence

    def words(self, value: float) -> str:
        """A value of the parameter as a sentence has it."""
        text = self.worded.format(self.named(value))
        return text.removesuffix("s") if self.named(value) == "1" else text

    def named(self, value: float) -> str:
        return power_of_two(value) if self.scale == "power" else plain(value)

    def places(self, values: Iterable[float]) -> Callable[[float], float]:
        """Where a value stands on the axis: of a logarithmic one at its
        logarithm, and 0, which has none, one step before the smallest.
        """
        if self.scale != "log":
            return lambda value: value
        smallest = min((value for value in values if value > 0), default=1.0)
        return lambda v: math.log2(v) if v > 0 else math.log2(smallest) - 1

    @property
    def axis_label(self) -> str:
        scale = "" if self.scale == "linear" else " (log scale)"
        harder = "   ← harder →" if self.harder == "leaves 1" else "   harder →"
        return f"{self.axis}{scale}{harder}"


HARDNESSES: Final = (
    Hardness(
        "near_edge",
        "ulps",
        "distance from the edge, in ulps",
        "distance from the edge",
        "falls",
        "log",
        "{} ulps",
    ),
    Hardness(
        "near_vertex",
        "ulps",
        "distance from a vertex, in ulps",
        "distance from a vertex",
        "falls",
        "log",
        "{} ulps",
    ),
    Hardness(
        "needle",
        "aspect",
        "length of the triangle over height",
        "aspect of a needle",
        "grows",
        "power",
        "an aspect of {}",
    ),
    Hardness(
        "offset",
        "ratio",
        "distance from the origin over size",
        "distance from the origin",
        "grows",
        "power",
        "{} sizes",
    ),
    Hardness(
        "scale",
        "exponent",
        "size of the triangle",
        "size of the triangle",
        "leaves 1",
        "power",
        "a size of {}",
    ),
    Hardness(
        "exponent_spread",
        "binades",
        "binades over which the coordinates spread",
        "spread of the exponents",
        "grows",
        "linear",
        "{} binades",
    ),
    Hardness(
        "cancellation",
        "binades",
        "binades from the ends of an edge to a point near its middle",
        "cancellation",
        "grows",
        "linear",
        "{} binades",
    ),
    Hardness(
        "whole_numbers",
        "bits",
        "bits of the whole numbers that are the coordinates",
        "bits of whole numbers",
        "grows",
        "linear",
        "{} bits",
    ),
)


def hardness_of(family: str) -> Hardness:
    return next(h for h in HARDNESSES if h.family == family)
