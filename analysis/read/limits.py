"""What the machine can do at most, by ISA and scalar (limits.json, and again after
the methods were timed, limits_after.json).

A limit is the best that a probe reached, and also the best that any narrower
ISA reached, since code for a wide one may use what a narrower one has; and data
nearby is read at least as fast as data far away. So every limit is one that
this machine kept in fact, and none is lower than another that it includes.
"""

from __future__ import annotations

import dataclasses
import functools
import math
from typing import Final

import pandas as pd

# Narrowest first: what code for the last of a row may use.
_CHAINS: Final = (
    ("scalar", "ssse3", "sse4", "avx2", "avx512"),
    ("scalar", "neon", "sve", "sve2"),
)
# A plain loop is compiled for what these ISAs have.
_AUTOVEC: Final = {
    "autovec_v2": "sse4",
    "autovec_v3": "avx2",
    "autovec_v4": "avx512",
}
MEMORY_COLUMNS: Final = ["isa", "scalars", "level", "access", "streams"] + [
    "bytes_per_second",
    "median",
    "lowest",
    "clock_ghz",
]
OPERATION_COLUMNS: Final = ["isa", "scalar", "operation"] + [
    "operations_per_second",
    "median",
    "lowest",
    "clock_ghz",
]


@dataclasses.dataclass(frozen=True)
class Level:
    """A place where a working set may lie."""

    name: str
    capacity: float  # bytes; infinite for the memory
    probed: float


@dataclasses.dataclass(frozen=True, eq=False)
class Limits:
    """levels: nearest first; memory, operations: the columns above, of which the
    clock is the highest that was seen before or after the file that a rate came
    from, since the best rate was reached at the highest clock; clocks_ghz: those
    seen, in their order; moved: of the two, if they were measured twice, the least
    and the largest ratio of the later to the earlier rate.
    """

    levels: tuple[Level, ...]
    memory: pd.DataFrame
    operations: pd.DataFrame
    clocks_ghz: tuple[float, ...]
    moved: dict[str, tuple[float, float]] = dataclasses.field(default_factory=dict)

    def shares(self, size: float) -> dict[str, float]:
        """Level → the share of a set of so many bytes, read over and over, that
        comes from there or from beyond. Of a set that nearer levels cannot hold
        they keep some at best: what is read in turn pushes out what comes next.
        From twice as large on, nothing is taken to be kept.
        """
        found, held = {}, 0.0
        for level in self.levels:
            left = (size - held) / held if held else 1.0
            if left > 0:
                found[level.name] = min(left, 1.0)
            held += level.capacity
        return found

    def reading(self, isa: str, scalar: str, size: float) -> tuple[str, float]:
        """The level that takes the longest to deliver its share of such a set, and
        the bytes of all of it that can be read a second; NaN if unknown.
        """
        shares = self.shares(size)
        rates = {
            level: self.bandwidth(isa, scalar, level) / share
            for level, share in shares.items()
        }
        known = {level: rate for level, rate in rates.items() if rate == rate}
        if not known:
            return list(shares)[-1], math.nan
        slowest = min(known, key=lambda level: known[level])
        return slowest, known[slowest]

    def bandwidth(
        self, isa: str, scalar: str, level: str, access: str = "load"
    ) -> float:
        """Bytes a second, NaN if nothing of the kind was measured."""
        names = [known.name for known in self.levels]
        farther = set(names[names.index(level) :]) if level in names else set()
        found = [
            value
            for (row_isa, scalars, row_level, row_access), value in self._memory.items()
            if row_isa in includes(isa)
            and scalar in scalars
            and row_level in farther
            and row_access == access
        ]
        return max(found, default=math.nan)

    def fastest_store(self, level: str) -> float:
        """Bytes a second that any ISA stores to the level, NaN if not measured."""
        found = [
            value
            for (_, _, row_level, access), value in self._memory.items()
            if (row_level, access) == (level, "store")
        ]
        return max(found, default=math.nan)

    def rate(self, isa: str, scalar: str, operation: str) -> float:
        """Operations a second, each lane one; NaN if it was not measured."""
        found = [
            self._operations.get((narrower, scalar, operation), math.nan)
            for narrower in includes(isa)
        ]
        return max((value for value in found if value == value), default=math.nan)

    def total_rate(self, isa: str, scalar: str) -> float:
        """The most operations a second, of whatever kinds."""
        found = [
            value
            for (row_isa, row_scalar, _), value in self._operations.items()
            if row_isa in includes(isa) and row_scalar == scalar
        ]
        return max(found, default=math.nan)

    @functools.cached_property
    def _memory(self) -> dict[tuple[str, tuple[str, ...], str, str], float]:
        """The best over the numbers of streams."""
        best: dict[tuple[str, tuple[str, ...], str, str], float] = {}
        for row in self.memory.to_dict("records"):
            key = (row["isa"], row["scalars"], row["level"], row["access"])
            best[key] = max(best.get(key, 0.0), row["bytes_per_second"])
        return best

    @functools.cached_property
    def _operations(self) -> dict[tuple[str, str, str], float]:
        return {
            (row["isa"], row["scalar"], row["operation"]): row["operations_per_second"]
            for row in self.operations.to_dict("records")
        }


@functools.cache
def includes(isa: str) -> tuple[str, ...]:
    """The ISAs whose instructions code for `isa` may use, itself included."""
    own = _AUTOVEC.get(isa, isa)
    for chain in _CHAINS:
        if own in chain:
            return chain[: chain.index(own) + 1]
    return (own,)
