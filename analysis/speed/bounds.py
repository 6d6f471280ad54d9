"""How fast a cell could be at most on this machine, and how near it is.

An item cannot take less time than its bytes need to arrive, nor than those that it
writes need to be stored (memory; a set that is
a little too large for a cache counts as kept there in part), nor than its
operations need in the units that do them (compute): for each kind of operation, count ÷ rate of that kind; for kinds that may share units, their
total ÷ the highest rate of any of them and of them together; and for all kinds,
their total ÷ the highest rate of any mix. The bound is the largest of these
times. What a call does once is spread over its items, at the same rates, which
is less than one lane takes for it.

Where a method's operations were not counted only the memory is known, and the
bound is no more than that: the row says so.

A bound is no opinion: a cell that is faster than it, by more than noise, shows
that a limit or a count is wrong. Such rows are marked and shown as they are.
"""

from __future__ import annotations

import math
from typing import Any, Final

import pandas as pd

from analysis.read.cells import SIDE_BY_SIDE, WHOLE_ARRAYS
from analysis.read.limits import Limits
from analysis.read.load_operations import KINDS
from analysis.report.method_families import leaves_early
from analysis.speed.written import SCALAR_BYTES, STORES, store_ns
from analysis.trust.noise import TOLERANCE

COLUMNS: Final = [
    "level",  # which bounds how fast the working set is read
    "memory_ns",  # of loads or of stores, whichever take longer
    "store_ns",
    "compute_ns",  # NaN: operations not counted
    "bound_ns",
    "bound_by",  # "memory" or "compute"
    "bound_of",  # the level, "stores", or the kind of operation; "all operations"
    "of_limit",
    "of_limit_low",
    "of_limit_high",
    "beaten",
    "operations_per_item",
]
ALL: Final = "all operations"
# Arithmetic that every ISA does in the units for numbers. What else is counted
# may be done elsewhere: masks are combined in registers of their own, or many at
# once, and minima of integers have units that those of numbers do not have.
ARITHMETIC: Final = tuple(
    kind
    for kind in KINDS
    if kind not in ("integer_min_max", "logic", "convert", "load", "store")
)
# Kinds of which some CPUs do one in the units of another; the probe that does
# them at once. Where they share none, its rate is that of all their units.
TOGETHER: Final = {
    "add_min_max_compare": ("add", "min_max", "compare"),
    "multiply_multiply_add": ("multiply", "multiply_add"),
}
# Operations are counted once for all ISAs, in the shape that they have on these,
# where a comparison under a mask is one; others need more of them, so that their
# bound is too low.
COUNTED_FOR: Final = ("avx512", "autovec_v4")
_FLOATS: Final = ("f32", "f64")
Counts = dict[str, dict[str, Any]]  # of _PER, kind → operations
_PER: Final = ("item", "call")

# Of a row that no limit speaks of.
_UNBOUND: Final[dict[str, Any]] = {
    **dict.fromkeys(COLUMNS, math.nan),
    **dict.fromkeys(("level", "bound_by", "bound_of"), ""),
    "beaten": False,
}


def with_bounds(
    cells: pd.DataFrame, limits: Limits | None, operations: pd.DataFrame
) -> pd.DataFrame:
    """`cells` (tables.speed_cells) with the columns above; without limits, as
    it is.
    """
    if limits is None:
        return cells
    counted: dict[tuple[str, str, str], Counts] = {}
    for row in operations.to_dict("records"):
        key = (row["method"], row["scalar"], row["loop"])
        counted.setdefault(key, {})[row["per"]] = row
    # The limits are those of one CPU.
    rows = [
        (
            _bound(
                cell,
                limits,
                counted.get(
                    (cell["method"], cell["scalar"], _counted_as(cell["loop"]))
                ),
            )
            if not cell.get("threads", 1) > 1
            else _UNBOUND
        )
        for cell in cells.to_dict("records")
    ]
    bounds = pd.DataFrame(rows, columns=COLUMNS, index=cells.index)
    return pd.concat([cells, bounds], axis=1)


def _counted_as(loop: str) -> str:
    return WHOLE_ARRAYS if loop == SIDE_BY_SIDE else loop


def _bound(
    cell: dict[str, Any], limits: Limits, counts: Counts | None
) -> dict[str, Any]:
    size = cell.get("scene_bytes", math.nan)
    whole = size if size == size else cell["working_set_bytes"]
    level, rate = limits.reading(cell["isa"], cell["scalar"], whole)
    load, store = load_ns(cell, rate), store_ns(cell, limits)
    by_stores = store == store and not store <= load
    memory = store if by_stores else load
    compute, kind = compute_ns(cell, limits, counts)
    by_compute = compute == compute and not compute < memory
    bound = compute if by_compute else memory
    return {
        "level": level,
        "memory_ns": memory,
        "store_ns": store,
        "compute_ns": compute,
        "bound_ns": bound,
        "bound_by": "compute" if by_compute else "memory",
        "bound_of": kind if by_compute else STORES if by_stores else level,
        "of_limit": bound / cell["ns"],
        "of_limit_low": bound / cell["ns_high"],
        "of_limit_high": bound / cell["ns_low"],
        "beaten": bool(bound / cell["ns_high"] > 1 + TOLERANCE),
        "operations_per_item": total(counts["item"]) if counts else math.nan,
    }


def load_ns(cell: dict[str, Any], rate: float) -> float:
    """The time that an item's bytes take at `rate` bytes a second."""
    return float(1e9 * cell["bytes_per_item"] / rate)


def compute_ns(
    cell: dict[str, Any], limits: Limits, counts: Counts | None
) -> tuple[float, str]:
    """The time that an item's operations take, and the kind that takes it; NaN
    if they were not counted, none of their rates is known, or the method may
    leave before it has done them all.
    """
    if counts is None or leaves_early(cell["method"]):
        return math.nan, ""
    isa, items = cell["isa"], cell["items"]
    types = lane_types(cell["scalar"], counts["item"])

    def time(kind: str, each: float, once: float) -> float:
        rate = _fastest(limits, isa, types, kind)
        count = float(each + max(once, 0.0) / items)
        # 0 bounds nothing: the rate is not known.
        return 1e9 * count / rate if rate == rate else 0.0

    times = {
        kind: time(kind, counts["item"][kind], counts["call"][kind])
        for kind in ARITHMETIC
    }
    # Integers, which may be what is added, have no such probes.
    together = TOGETHER if set(types) <= set(_FLOATS) else {}
    for probe, kinds in together.items():
        each, once = (sum(counts[per][kind] for kind in kinds) for per in _PER)
        times[probe] = time(probe, each, once)
    times[ALL] = time(ALL, total(counts["item"]), total(counts["call"]))
    longest = max(times, key=lambda kind: times[kind])
    return (times[longest], longest) if times[longest] > 0 else (math.nan, "")


def lane_types(scalar: str, counts: dict[str, Any]) -> tuple[str, ...]:
    """The number types that the counted operations may be of. A method that
    converts computes in another type than it is given, and the counts do not
    say in which: a bound has to allow the one that is fastest.
    """
    if not counts["convert"]:
        return (scalar,)
    if scalar in _FLOATS and not counts["integer_multiply"]:
        return _FLOATS
    return tuple(SCALAR_BYTES)


def total(counts: dict[str, Any]) -> float:
    return float(sum(counts[kind] for kind in ARITHMETIC))


def _fastest(limits: Limits, isa: str, types: tuple[str, ...], kind: str) -> float:
    found = [_rate(limits, isa, scalar, kind) for scalar in types]
    return max((rate for rate in found if rate == rate), default=math.nan)


def _rate(limits: Limits, isa: str, scalar: str, kind: str) -> float:
    """Integers are multiplied by integer multiplication, whatever it is called."""
    if kind == ALL:
        return limits.total_rate(isa, scalar)
    rate = limits.rate(isa, scalar, kind)
    if kind in TOGETHER and rate == rate:
        alone = [limits.rate(isa, scalar, one) for one in TOGETHER[kind]]
        return max([rate, *(one for one in alone if one == one)])
    if rate != rate and kind == "multiply":
        return limits.rate(isa, scalar, "integer_multiply")
    return rate


def beaten(cells: pd.DataFrame) -> pd.DataFrame:
    """The rows whose bound is wrong: they were faster."""
    if "beaten" not in cells:
        return cells.iloc[:0]
    return cells[cells["beaten"].astype(bool)]
