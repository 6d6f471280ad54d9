"""How limits and bounds are shown in tables."""

from __future__ import annotations

from typing import Any, Final

from analysis.read.limits import Limits
from analysis.report import wording
from analysis.report.columns import number, percent, word
from analysis.report.exhibits import Column
from analysis.report.wording import significant

Row = dict[str, Any]

OPERATIONS: Final = {
    "add": "add",
    "multiply": "multiply",
    "multiply_add": "multiply-add",
    "mixed": "both at once",
    "multiply_multiply_add": "multiply and multiply-add",
    "add_min_max_compare": "add, min and compare",
    "divide": "divide",
    "min_max": "min, max",
    "compare": "compare",
    "integer_multiply": "integer multiply",
}


def bound_words(row: Row) -> str:
    """What a cell's bound is made of."""
    if row["bound_by"] == "compute":
        name = str(row["bound_of"])
        return OPERATIONS.get(name, name)
    alone = "" if row["compute_ns"] == row["compute_ns"] else ", memory alone"
    return f"{row['bound_of']}{alone}"


def of_limit_words(row: Row) -> str:
    """The share of the limit that a cell reaches; a beaten bound is no limit."""
    if row["of_limit"] != row["of_limit"]:
        return wording.NONE
    reached = f"{significant(100 * row['of_limit'])}{wording.JOIN}%"
    return f"{reached}, bound beaten" if row["beaten"] else reached


def _of_limit_interval(row: Row) -> str:
    if row["of_limit"] != row["of_limit"]:
        return ""
    low, high = 100 * row["of_limit_low"], 100 * row["of_limit_high"]
    return f"{significant(low)} to {significant(high)}{wording.JOIN}%"


BOUND: Final = Column(
    "bound, ns",
    lambda row: significant(row["bound_ns"]),
    bound_words,
    "bound_ns",
    hint="the least time that the machine's limits allow, and the limit that it is; "
    "memory alone: the operations were not counted",
)
OF_LIMIT: Final = Column(
    "% of limit",
    of_limit_words,
    _of_limit_interval,
    "of_limit",
    hint="bound over time; 95 % interval of the time below",
)
NEAR: Final = (
    word("loop", "loop"),
    word("scalar", "scalar"),
    word("method", "method"),
    number("ns", "ns/item"),
    BOUND,
    OF_LIMIT,
    word("level", "read from"),
    number(
        "instructions_per_cycle",
        "instructions a cycle",
        "that the compiled loop executes, of any kind; a dash: it was not traced",
    ),
    number(
        "memory_ns",
        "memory, ns",
        "bytes read over the level's bandwidth, or bytes written over that of stores: "
        "the longer of the two",
    ),
    number("compute_ns", "compute, ns", "a dash: operations not counted"),
    word("isa", "ISA"),
    word("scene", "scene"),
)
WRONG: Final = (
    word("loop", "loop"),
    word("scene", "scene"),
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    number("ns", "ns/item"),
    BOUND,
    OF_LIMIT,
)
THROUGHPUT: Final = (
    number(
        "per_cycle_before",
        "operations a cycle before",
        "independent operations that fill the execution ports, over the clock",
    ),
    number("per_cycle_after", "after"),
    percent(
        "throughput_change",
        "change",
        "a busy neighbour on the same core lowers it; the clock alone does not show it",
    ),
)


def bandwidth_columns(limits: Limits) -> tuple[Column, ...]:
    shown = [_speed(f"load_{x.name}", f"load {x.name}") for x in limits.levels]
    nearest = limits.levels[0].name
    return (
        word("isa", "ISA"),
        word("scalars", "scalars"),
        *shown,
        _speed(f"store_{nearest}", f"store {nearest}"),
    )


def rate_columns(limits: Limits) -> tuple[Column, ...]:
    measured = set(limits.operations["operation"])
    return (
        word("isa", "ISA"),
        word("scalar", "scalar"),
        *(
            _speed(kind, title, "G/s", "a cycle")
            for kind, title in OPERATIONS.items()
            if kind in measured
        ),
    )


def _speed(key: str, title: str, unit: str = "GB/s", each: str = "B a cycle") -> Column:
    """Giga-somethings a second, and below it how many a cycle."""

    def show(row: Row) -> str:
        value = row.get(key, float("nan"))
        return significant(value / 1e9) if value == value else wording.NONE

    def note(row: Row) -> str:
        value = row.get(f"{key}_per_cycle", float("nan"))
        return f"{significant(value)} {each}" if value == value else ""

    return Column(f"{title}, {unit}", show, note, key)
