"""The chapter on choosing a method: what `choose` answers for the run."""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable
from typing import Any, Final

import pandas as pd

from analysis.choice.choice_chart import choice_map, choices
from analysis.choice.choose import Choice, choose
from analysis.choice.choose_scene import Described, checked
from analysis.choice.choose_text import guarantee, kernel, reasons
from analysis.choice.typical_scenes import TYPICAL
from analysis.read.run import Run
from analysis.report.columns import sentence
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import (
    NONE,
    between,
    counted,
    listed,
    nanoseconds,
    significant,
)
from analysis.speed.tables import samples
from analysis.trust.placement import usual_spread

# Stout triangles in a unit square, as random numbers have their digits; many
# points a triangle. What is asked is what differs.
_PLAIN: Final = Described(
    scalar="f32",
    coordinates=(0, 1),
    aspect=16,
    edge=(0.1, 1),
    precision=2.0**-24,
)
NEEDS: Final = (
    (
        "an answer may be wrong within a thousandth of the square's side from an edge",
        dataclasses.replace(_PLAIN, tolerance=1e-3),
    ),
    ("every answer has to be right", dataclasses.replace(_PLAIN, need="exact")),
    (
        "every point of a mesh has to be in exactly one triangle",
        dataclasses.replace(_PLAIN, need="watertight"),
    ),
    (
        "the weights are needed too, and the answer as in the first case",
        dataclasses.replace(_PLAIN, need="weights", tolerance=1e-3),
    ),
)


@dataclasses.dataclass(frozen=True)
class Guidance:
    """What the chapter says. needs: in words, the command and the choice, for
    the same triangles; typical: one row a typical scene; map: of the chart.
    """

    needs: tuple[tuple[str, str, Choice], ...]
    typical: pd.DataFrame
    map: pd.DataFrame


TYPICAL_COLUMNS: Final = (
    Column(
        "scene",
        lambda row: str(row["scene"]),
        lambda row: str(row["words"]),
        numeric=False,
        wraps=True,
    ),
    sentence("take", "take"),
    Column(
        "ns/point",
        lambda row: significant(row["ns"]) if row["ns"] == row["ns"] else NONE,
        lambda row: str(row["interval"]),
        "ns",
        hint="95 % interval below",
    ),
    sentence("guarantee", "guarantee"),
    sentence("command", "command"),
)


def add(exhibits: Exhibits, run: Run, cells: pd.DataFrame, footer: str) -> Guidance:
    by_cell, alike = samples(run.speed), usual_spread(run.speed)

    def choice_of(given: Described) -> Choice:
        return choose(
            checked(given), by_cell, cells, run.accuracy, run.methods, alike=alike
        )

    chart = choices(by_cell, cells, run.methods, alike)
    if len(chart):
        exhibits.figure(
            choice_map(chart, footer),
            "The cheapest method that is right, by what its error bound proves and "
            "what this run measured it to take. Edges of length 1 in a square of "
            "side 1, coordinates of as many binary digits as the number type has; "
            "the tolerance is the distance from an edge within which either answer "
            "will do, in sides of the square. Where no method of this run is right, "
            "the map is grey.",
            chart,
        )
    typical = typical_table(choice_of, run.name)
    exhibits.table(
        "typical_scenes",
        "Twelve scenes as they occur, their sizes being assumptions, and what to take "
        "for each. Times are of this run, nearest to the scene; the command makes the "
        "answer again and says more.",
        typical,
        TYPICAL_COLUMNS,
    )
    needs = tuple((words, d.command, choice_of(d)) for words, d in NEEDS)
    return Guidance(needs, typical, chart)


def typical_table(choice_of: Callable[[Described], Choice], run: str) -> pd.DataFrame:
    rows = []
    for typical in TYPICAL:
        choice = choice_of(typical.scene)
        chosen = choice.chosen
        bound = chosen.bound.distance if chosen else math.nan
        rows.append(
            {
                "scene": typical.name,
                "words": typical.words,
                "take": _take(choice),
                "ns": choice.ns,
                "interval": _interval(choice),
                "guarantee": guarantee(choice) if chosen else NONE,
                "exact": bool(chosen and chosen.bound.exact),
                "right_beyond": bound,
                "otherwise": reasons(choice)[-1],
                "command": typical.scene.command.replace(
                    " choose ", f" choose {run} ", 1
                ),
            }
        )
    return pd.DataFrame(rows)


def _take(choice: Choice) -> str:
    if choice.chosen is None:
        return "nothing of this run"
    if choice.weigher is None:
        return kernel(choice.chosen)
    return f"{kernel(choice.chosen)}, and {kernel(choice.weigher)} for the weights"


def _interval(choice: Choice) -> str:
    parts = [part for part in (choice.chosen, choice.weigher) if part]
    ends = [part.timing.interval for part in parts]
    low, high = sum(end[0] for end in ends), sum(end[1] for end in ends)
    if not low < high:
        return ""
    noisy = any(part.timing.noise for part in parts)
    estimated = any(part.timing.estimated for part in parts)
    return between(low, high) + ", estimated" * estimated + ", noisy" * noisy


def guidance_facts(guidance: Guidance) -> dict[str, Any]:
    """The chapter's phrases."""
    typical = guidance.typical
    taken = typical[typical["ns"].notna()]
    return {
        "needs": [
            {
                "words": words,
                "take": choice.chosen.name if choice.chosen else "",
                "weigher": choice.weigher.name if choice.weigher else "",
                "isa": choice.chosen.timing.isa if choice.chosen else "",
                "ns": nanoseconds(choice.ns),
                "interval": _interval(choice),
                "guarantee": guarantee(choice) if choice.chosen else "",
                "command": command,
            }
            for words, command, choice in guidance.needs
        ],
        "scenes": counted(len(typical), "scene"),
        "count": len(typical),
        "answered": len(taken),
        "exact": int(taken["exact"].sum()),
        "methods": listed(sorted({str(take).split(" (")[0] for take in taken["take"]})),
    }
