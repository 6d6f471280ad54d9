"""Why a kernel is slower than on the instruction set below: rules on the figures of
the run. The first that fits is taken; where none does, that is what is said.

A rule says what goes with the loss, not that nothing else adds to it.
"""

from __future__ import annotations

import math
from typing import Any, Final

import pandas as pd

from analysis.charts.palette import is_autovec
from analysis.read.cells import parse_scene
from analysis.report.wording import counted, share, significant
from analysis.speed.written import STORES

# From this share of its bound on, a kernel is at its bound.
AT_THE_BOUND: Final = 0.8
# From this share of a call's time on, what it does but once decides.
MOST_OF_A_CALL: Final = 0.5
# What gains less over the scalar row has no vectors; the narrowest have two lanes.
VECTORS_GAIN: Final = 1.25
# Counts of instructions that differ by no more than this share are the same, and
# explain a loss of up to this ratio.
SAME_COUNT: Final = 0.02
NEAR: Final = 1.1
UNEXPLAINED: Final = "unexplained"
_KERNEL: Final = ("loop", "scalar", "method", "isa")

Step = dict[str, Any]


class Evidence:
    """What the rules look at beside the step itself."""

    def __init__(
        self, cells: pd.DataFrame, instructions: pd.DataFrame, spread: float
    ) -> None:
        self.spread = spread
        self._executed = {
            tuple(row[key] for key in _KERNEL): (
                float(row["per_item"]),
                float(row["per_call"]),
            )
            for row in instructions.to_dict("records")
        }
        self._least: dict[tuple[Any, ...], tuple[float, float]] = {}
        for cell in cells.to_dict("records"):
            key = _but_for_its_size(cell)
            self._least[key] = min(
                self._least.get(key, (math.inf, math.inf)), (cell["ns"], cell["items"])
            )

    def instructions(self, step: Step, isa: str) -> float:
        """Executed for an item, those of a call spread over its items."""
        key = (step["loop"], step["scalar"], step["method"], isa)
        each, once = self._executed.get(key, (math.nan, math.nan))
        return each + (once / float(step["items"]) if once == once else 0.0)

    def once(self, step: Step) -> float:
        """The share of a call's time that is not its items': what longer calls of the
        kernel on such input do not take. NaN if none was timed.
        """
        ns, items = self._least[_but_for_its_size(step)]
        return 1 - ns / float(step["ns"]) if items > step["items"] else math.nan


def _but_for_its_size(cell: Step) -> tuple[Any, ...]:
    scene = parse_scene(cell["scene"])
    other = tuple(pair for pair in scene.parameters if pair[0] not in ("n", "bytes"))
    return (*(cell[key] for key in _KERNEL), scene.family, other)


def explanation(step: Step, evidence: Evidence) -> tuple[str, str]:
    """The rule that fits, in a word or two, and what it says of this step; both
    UNEXPLAINED if none does.
    """
    return (
        _memory(step)
        or _division(step)
        or _short_call(step, evidence)
        or _not_vectorised(step)
        or _instructions(step, evidence)
        or _placement(step, evidence)
        or _as_many_instructions(step, evidence)
        or _none(step)
    )


def _memory(step: Step) -> tuple[str, str] | None:
    of_limit = step.get("of_limit", math.nan)
    if not (of_limit >= AT_THE_BOUND and step.get("bound_by") == "memory"):
        return None
    what = "stores allow" if step["bound_of"] == STORES else f"{step['bound_of']} gives"
    below = step.get("of_limit_below", math.nan)
    if below >= AT_THE_BOUND and step.get("bound_by_below") == "memory":
        return (
            "both at the memory's limit",
            f"bound by memory: both are as fast as it allows, at {share(of_limit)} and "
            f"{share(below)} of what {what}",
        )
    return (
        "at the memory's limit",
        f"at {share(of_limit)} of what {what}: wider vectors do not make bytes "
        "arrive sooner",
    )


def _division(step: Step) -> tuple[str, str] | None:
    of_limit = step.get("of_limit", math.nan)
    if not (of_limit >= AT_THE_BOUND and step.get("bound_of") == "divide"):
        return None
    return ("division", f"at {share(of_limit)} of the rate of division")


def _short_call(step: Step, evidence: Evidence) -> tuple[str, str] | None:
    once = evidence.once(step)
    if not once >= MOST_OF_A_CALL:
        return None
    items = counted(round(step["items"]), "item")
    return (
        "short calls",
        f"calls of {items}: by the time an item takes in longer calls, {share(once)} "
        "of it is what a call does once, and lanes left empty",
    )


def _not_vectorised(step: Step) -> tuple[str, str] | None:
    times = step.get("times_scalar", math.nan)
    if not (is_autovec(step["isa"]) and times <= VECTORS_GAIN):
        return None
    return (
        "not vectorised",
        f"{significant(times)} × as fast as the scalar row: the compiler made no "
        "vectors of this loop, so wider ones bring nothing",
    )


def _instructions(step: Step, evidence: Evidence) -> tuple[str, str] | None:
    here = evidence.instructions(step, step["isa"])
    there = evidence.instructions(step, step["below"])
    if not here > there:
        return None
    return (
        "more instructions",
        f"compiled to more instructions an item: {significant(here)} against "
        f"{significant(there)}",
    )


def _placement(step: Step, evidence: Evidence) -> tuple[str, str] | None:
    if not step["ratio"] <= evidence.spread:
        return None
    here = evidence.instructions(step, step["isa"])
    there = evidence.instructions(step, step["below"])
    same = " and executes as many instructions an item" if here == there else ""
    return (
        "placement",
        "differs no more than a kernel does from itself elsewhere in memory "
        f"({significant(evidence.spread)} in the median){same}",
    )


def _as_many_instructions(step: Step, evidence: Evidence) -> tuple[str, str] | None:
    here = evidence.instructions(step, step["isa"])
    there = evidence.instructions(step, step["below"])
    if not (step["ratio"] <= NEAR and abs(here - there) <= SAME_COUNT * there):
        return None
    return (
        "as many instructions",
        f"executes as many instructions an item ({significant(here)} and "
        f"{significant(there)}): it is which they are, their order or their place",
    )


def _none(step: Step) -> tuple[str, str]:
    noisy = step.get("noise") or step.get("noise_below")
    mark = "; one of the two rows is noisy by itself" if noisy else ""
    return (UNEXPLAINED, f"{UNEXPLAINED}{mark}")
