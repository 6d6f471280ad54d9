"""What a kernel writes for an item, and how long its stores take at least.

Every kernel writes bits, a call's own in whole bytes (kernels/kernels.h): one an
item; in loop grid one a pixel, each row of pixels in bytes of its own; in loop
one_ray the nearest triangle alone, once a call. Some write the weights, or t, u and
v, as well.
"""

from __future__ import annotations

import math
import re
from typing import Any, Final

from analysis.read.cells import TUV_SUFFIX, WEIGHTS_SUFFIX
from analysis.read.limits import Limits

SCALAR_BYTES: Final = {"f32": 4, "f64": 8, "i32": 4, "i16": 2, "u8": 1}
STORES: Final = "stores"
_GRID: Final = re.compile(r"grid\w*_(\d+)x(\d+)\Z")
# What is written once a call counts for nothing.
_ONCE: Final = ("one_ray",)


def grid_size(family: str) -> tuple[int, int]:
    """Columns and rows, which the name of the scene gives; 0 and 0 if it has none."""
    found = _GRID.match(family)
    return (int(found[1]), int(found[2])) if found else (0, 0)


def bits_written(cell: dict[str, Any]) -> float:
    """The bytes of answers that an item has; 0 where they are not known."""
    if cell["loop"] in _ONCE:
        return 0.0
    if cell["loop"] == "grid":
        columns, rows = grid_size(str(cell["family"]))
        return float(math.ceil(columns / 8) * rows)
    items = float(cell["items"])
    return math.ceil(items / 8) / items if items > 0 else 0.0


def numbers_written(cell: dict[str, Any]) -> float:
    """The bytes of numbers that an item has beside its answer."""
    if not cell["loop"].endswith((WEIGHTS_SUFFIX, TUV_SUFFIX)):
        return 0.0
    return 3.0 * SCALAR_BYTES.get(cell["scalar"], 0)


def store_ns(cell: dict[str, Any], limits: Limits) -> float:
    """The least time of an item's stores, all of them into the nearest level; NaN
    where their rate is not known.

    Numbers are stored by vectors of the kernel's own ISA. Bits may be cleared and
    copied by the C library, which takes the widest registers that the machine has,
    so they count at its highest rate.
    """
    nearest = limits.levels[0].name
    bits, numbers = bits_written(cell), numbers_written(cell)
    time = 1e9 * bits / limits.fastest_store(nearest) if bits else 0.0
    if numbers:
        rate = limits.bandwidth(cell["isa"], cell["scalar"], nearest, "store")
        time += 1e9 * numbers / rate
    return time
