"""Kernels that are slower than the same method on the instruction set below.

There are two ladders: the hand-written vectors from one lane up, and the plain
loops that the compiler vectorised. A step is a kernel on a scene and the nearest
narrower one of the same method, scalar and loop, both timed in one shard: on every
scene of fresh input, whatever its family and size, by one CPU.

A step is counted as slower by a one-sided Mann–Whitney test of its repetitions,
those of all steps taken together (Benjamini and Hochberg), so that of the steps
counted no more than CHANCE are to be expected slower by chance.

An explanation is a rule on what the run holds, never a remark on a method.
"""

from __future__ import annotations

import dataclasses
from typing import Any, Final

import pandas as pd

from analysis.read.cells import parse_scene
from analysis.read.run import Run
from analysis.report.columns import near_interval, number, ratio, sentence, word
from analysis.report.exhibits import Exhibits
from analysis.report.wording import counted, listed, share
from analysis.speed import tables
from analysis.speed.ladder_reasons import UNEXPLAINED, Evidence, explanation
from analysis.trust.placement import usual_spread
from analysis.trust.stats import (
    CONFIDENCE,
    benjamini_hochberg,
    ratio_interval,
    ratio_p_value,
)

# Each with the ISAs below it, nearest first.
LADDER: Final = {
    "ssse3": ("scalar",),
    "sse4": ("ssse3", "scalar"),
    "avx2": ("sse4", "ssse3", "scalar"),
    "avx512": ("avx2", "sse4", "ssse3", "scalar"),
    "neon": ("scalar",),
    "sve": ("neon", "scalar"),
    "sve2": ("sve", "neon", "scalar"),
    "autovec_v3": ("autovec_v2",),
    "autovec_v4": ("autovec_v3", "autovec_v2"),
}
CHANCE: Final = 1 - CONFIDENCE
KERNEL: Final = ["loop", "scalar", "method", "isa"]
STEP: Final = [*KERNEL, "below"]
COLUMNS: Final = [*STEP, "scene", "ns", "ratio", "ratio_low", "ratio_high"]
# Of the row below, beside the cell's own.
_BELOW: Final = ("of_limit", "bound_by", "noise")
MOST_ROWS: Final = 40


@dataclasses.dataclass(frozen=True)
class Ladder:
    """What the report says of the steps; `rows`: kernel, step and reason."""

    steps: int
    kernels: int
    scenes: int
    slower: int
    slower_kernels: int
    chance: str
    unexplained: int
    unexplained_kernels: int
    unexplained_words: str
    rows: pd.DataFrame


def ladder_steps(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """One row a step: the time over that of the ISA `below`, `p` that repetitions are
    as far apart if it is not slower, `false_share` (the least share of false claims at
    which it is claimed to be slower), and the cell's other columns.
    """
    by_cell = tables.samples(speed)
    fresh = cells[~cells["scene"].str.contains("sets=fixed", regex=False)]
    alone = fresh[~(fresh["threads"] > 1)]
    rows: list[dict[str, Any]] = []
    for _, group in alone.groupby(
        ["shard", "loop", "scene", "scalar", "method"], sort=True
    ):
        kernels = {row["isa"]: row for row in group.to_dict("records")}
        rows += _steps_of(kernels, by_cell)
    extra = [c for c in cells.columns if c not in COLUMNS]
    extra += [f"{key}_below" for key in _BELOW if key in cells.columns]
    frame = pd.DataFrame(rows, columns=[*COLUMNS, "p", *extra])
    frame = frame.assign(false_share=benjamini_hochberg(list(frame["p"])))
    return tables.sort_cells(frame, ["loop", "scalar", "method", "isa", "scene"])


def _steps_of(
    kernels: dict[str, dict[str, Any]], by_cell: dict[tuple[str, str], Any]
) -> list[dict[str, Any]]:
    rows = []
    for isa, row in kernels.items():
        below = next((b for b in LADDER.get(isa, ()) if b in kernels), None)
        if below is None:
            continue
        other, shard = kernels[below], row["shard"]
        own = by_cell[shard, row["name"]]
        narrower = by_cell[shard, other["name"]]
        found = ratio_interval(own, narrower)
        two_sided = ratio_p_value(own, narrower)
        rows.append(
            {
                **row,
                **{f"{key}_below": other[key] for key in _BELOW if key in other},
                "below": below,
                "ratio": found.value,
                "ratio_low": found.low,
                "ratio_high": found.high,
                "p": two_sided / 2 if found.value > 1 else 1.0,
            }
        )
    return rows


def slower_steps(
    steps: pd.DataFrame,
    cells: pd.DataFrame,
    instructions: pd.DataFrame,
    spread: float,
) -> pd.DataFrame:
    """The steps that are slower, each with why: `reason`, the same for all that a rule
    explains, and `because`, with the figures of the step.

    `spread`: how many times as long a kernel takes in its slowest place in
    memory as in its fastest, NaN if that was not measured.
    """
    slower = steps[steps["false_share"] <= CHANCE]
    evidence = Evidence(cells, instructions, spread)
    found = [explanation(row, evidence) for row in slower.to_dict("records")]
    return slower.assign(
        reason=[reason for reason, _ in found],
        because=[because for _, because in found],
    ).reset_index(drop=True)


def by_kernel(steps: pd.DataFrame, slower: pd.DataFrame) -> pd.DataFrame:
    """One row a kernel, ISA below and reason: the scene on which it is slowest by
    comparison, with its figures, on how many scenes it is slower for that reason
    (`slower`), of how many that both were timed on (`scenes`). What is unexplained
    comes first, then what is slower by most.
    """
    timed = steps.groupby(STEP)["scene"].count()
    rows = []
    for key, group in slower.groupby([*STEP, "reason"], sort=True):
        worst = group.loc[group["ratio"].idxmax()].to_dict()
        rows.append({**worst, "slower": len(group), "scenes": int(timed[key[:-1]])})
    columns = [*slower.columns, "slower", "scenes"]
    table = pd.DataFrame(rows, columns=columns)
    order = sorted(
        range(len(table)),
        key=lambda i: (
            table["reason"].iloc[i] != UNEXPLAINED,
            -table["ratio"].iloc[i],
        ),
    )
    return table.iloc[order].reset_index(drop=True)


def short_scene(scene: str) -> str:
    """Without what all fresh scenes have in their names."""
    return scene.replace(":sets=fresh", "")


def add(exhibits: Exhibits, run: Run, cells: pd.DataFrame) -> Ladder:
    """`cells`: every timed one, with bounds."""
    steps = ladder_steps(run.speed, cells)
    slower = slower_steps(steps, cells, run.instructions, usual_spread(run.speed))
    table = by_kernel(steps, slower)
    if len(table):
        exhibits.table(
            "slower_than_below",
            "Kernels that are slower than the same method on the instruction set "
            "below: the scene on which they are so by most, on how many scenes for the "
            "same reason, of how many. The unexplained come first.",
            table.assign(scene=[short_scene(scene) for scene in table["scene"]]),
            [
                word("loop", "loop"),
                word("scalar", "scalar"),
                word("method", "method"),
                word("isa", "ISA"),
                word("below", "ISA below"),
                word("scene", "worst scene"),
                number("ns", "ns/item"),
                ratio("ratio", "× below"),
                near_interval("ratio", "interval", "95 %"),
                number("slower", "slower on", "scenes, for this reason"),
                number("scenes", "of scenes"),
                sentence("because", "why"),
            ],
            most_rows=MOST_ROWS,
            csv=slower,
        )
    return _told(steps, slower, table)


def _told(steps: pd.DataFrame, slower: pd.DataFrame, table: pd.DataFrame) -> Ladder:
    unexplained = slower[slower["reason"] == UNEXPLAINED]
    families = [parse_scene(scene).family for scene in unexplained["scene"]]
    most = unexplained.assign(family=families).groupby(["isa", "below"], sort=True)
    return Ladder(
        steps=len(steps),
        kernels=_kernels(steps),
        scenes=steps["scene"].nunique(),
        slower=len(slower),
        slower_kernels=_kernels(slower),
        chance=share(CHANCE),
        unexplained=len(unexplained),
        unexplained_kernels=_kernels(unexplained),
        unexplained_words=listed(
            [
                f"{counted(len(group), 'time')} {isa} against {below} (worst "
                f"{group['ratio'].max():.2f})"
                for (isa, below), group in most
            ]
        ),
        rows=table,
    )


def _kernels(steps: pd.DataFrame) -> int:
    return len(steps[STEP].drop_duplicates())
