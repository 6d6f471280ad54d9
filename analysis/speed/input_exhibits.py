"""The exhibits and the facts of the chapter on what the input does."""

from __future__ import annotations

import dataclasses
from typing import Any

import pandas as pd

from analysis.claims.inputs import Claim, claims
from analysis.read.run import Run
from analysis.report import columns
from analysis.report.exhibits import Exhibits
from analysis.report.wording import between, counted, nanoseconds, times
from analysis.speed.break_even import (
    WHOLE_VECTOR,
    break_even_words,
    break_evens,
    ratios_by_size,
)
from analysis.speed.input_charts import hit_chart, size_chart
from analysis.speed.input_tables import (
    along_hit_rates,
    by_hit_rate,
    by_threads,
    early_out,
    home,
)
from analysis.speed.longer_calls import add_longer_calls, longer_calls, longer_words


@dataclasses.dataclass(frozen=True)
class InputChapter:
    """early, sizes, evens, longer and threads may be empty: not in this run."""

    early: pd.DataFrame
    sizes: pd.DataFrame
    evens: pd.DataFrame
    longer: pd.DataFrame
    threads: pd.DataFrame
    claims: tuple[Claim, ...]

    @property
    def empty(self) -> bool:
        return not (len(self.early) or len(self.sizes) or len(self.threads))


def input_chapter(run: Run, cells: pd.DataFrame) -> InputChapter:
    """`cells`: every timed cell of the run, those of sweeps included."""
    early = early_out(run.speed, cells)
    evens = break_evens(run.speed, cells)
    threads = by_threads(run.speed, cells)
    caches = run.machine.caches
    return InputChapter(
        early=early,
        sizes=ratios_by_size(run.speed, cells),
        evens=evens.assign(
            words=[break_even_words(row) for _, row in evens.iterrows()]
        ),
        longer=longer_calls(run.speed, cells),
        threads=threads.assign(
            home=[home(size, caches) for size in threads["working_set_bytes"]]
        ),
        claims=tuple(claims(run.speed, cells, early, caches)),
    )


def add_input(
    exhibits: Exhibits,
    chapter: InputChapter,
    run: Run,
    cells: pd.DataFrame,
    footer: str,
) -> None:
    """Adds what the chapter has something to show in."""
    scalars = ("f32", "f64")
    for scalar in scalars:
        early = along_hit_rates(chapter.early[chapter.early["scalar"] == scalar])
        if early["hit"].nunique() > 1 and "fresh" in set(early["sets"]):
            rows = by_hit_rate(cells, early)
            exhibits.figure(
                hit_chart(rows, early, scalar, footer),
                f"Time by the share of points inside, {scalar}. Solid: cross_product; "
                "dashed: with a way out after each edge. Fresh input has another "
                "triangle at every call, fixed always the same. Whiskers are 95 % "
                "intervals.",
                rows,
            )
    if len(chapter.early):
        exhibits.table(
            "early_out",
            "A way out after each edge, over the same method without: below 1 it "
            "saves time.",
            chapter.early,
            columns.EARLY_OUT,
        )
    for scalar in scalars:
        sizes = chapter.sizes[chapter.sizes["scalar"] == scalar]
        if sizes["n"].nunique() > 1:
            exhibits.figure(
                size_chart(sizes, chapter.evens, scalar, run.machine.caches, footer),
                f"Time by the points of a call, {scalar}; every call sets up another "
                "triangle. Above: ns per point; dotted lines stand where the points "
                "fill a cache. Below: the time of a call over that of the method that "
                "is cheapest to set up; where a line passes below 1 the set-up is "
                "won back. Whiskers are 95 % intervals.",
                sizes,
            )
    if len(chapter.evens):
        exhibits.table(
            "break_even",
            "From how many points a call the dearer set-up pays: against what takes "
            f"least for {WHOLE_VECTOR} points, and for the pairs that a claim is about. "
            "In brackets the numbers of points that were timed and between which it lies; "
            "where in between is a guess, as times jump there.",
            chapter.evens,
            columns.BREAK_EVEN,
        )
    add_longer_calls(exhibits, chapter.longer)
    if len(chapter.threads):
        exhibits.table(
            "threads",
            "Several CPUs, each with its part of the points of every call. Their time "
            "is the mean over the CPUs, so another program on one of them makes the "
            "gain look smaller than it is.",
            chapter.threads,
            columns.THREADS,
        )


def input_facts(chapter: InputChapter) -> dict[str, Any] | None:
    """The chapter in phrases; None where the run has nothing for it."""
    if chapter.empty:
        return None
    return {
        "claims": chapter.claims,
        "fixed": _fixed(chapter.early),
        "tails": _tails(chapter.sizes),
        "longer": longer_words(chapter.longer),
        "threads": _threads(chapter.threads),
    }


def _fixed(early: pd.DataFrame) -> list[dict[str, str]]:
    """For each ISA, one lane at a time first: the way out at its worst on fresh
    input, and there on fixed.
    """
    found = []
    rated = along_hit_rates(early)
    for (scalar, isa), rows in rated.groupby(["scalar", "isa"], sort=False):
        by_sets = {sets: part.set_index("hit") for sets, part in rows.groupby("sets")}
        if set(by_sets) != {"fresh", "fixed"}:
            continue
        hit = by_sets["fresh"]["over_plain"].idxmax()
        if hit not in by_sets["fixed"].index:
            continue
        words = {sets: part.loc[hit] for sets, part in by_sets.items()}
        found.append(
            {
                "scalar": str(scalar),
                "isa": str(isa),
                "hit": f"{hit:g} %",
                "fresh": _ratio(words["fresh"], "over_plain"),
                "fixed": _ratio(words["fixed"], "over_plain"),
            }
        )
    return found


def _tails(sizes: pd.DataFrame) -> list[dict[str, str]]:
    """Where a call of fewer points takes longer than one of a whole vector, by
    the method that is cheapest to set up.
    """
    found = []
    for (scalar, isa), rows in sizes.groupby(["scalar", "isa"], sort=False):
        own = rows[rows["method"] == rows["cheapest"]].set_index("n")
        whole = [n for n in own.index if n >= WHOLE_VECTOR]
        if not whole or own.index.min() >= WHOLE_VECTOR:
            continue
        few, many = own.index.min(), min(whole)
        calls = {n: float(own.loc[n, "ns"]) * n for n in (few, many)}
        if calls[few] > calls[many]:
            found.append(
                {
                    "place": f"{isa} ({scalar})",
                    "few": counted(int(few), "point"),
                    "few_ns": nanoseconds(calls[few]),
                    "many": str(int(many)),
                    "many_ns": nanoseconds(calls[many]),
                    "method": str(own["method"].iloc[0]),
                }
            )
    return found


def _threads(table: pd.DataFrame) -> dict[str, str] | None:
    """What all CPUs together gain, at least and at most."""
    if not len(table) or table["threads"].max() < 2:
        return None
    every = table[table["threads"] == table["threads"].max()]
    least = every.loc[every["speed_up"].idxmin()]
    most = every.loc[every["speed_up"].idxmax()]
    return {
        "cpus": str(int(every["threads"].iloc[0])),
        "least": _ratio(least, "speed_up"),
        "least_of": f"{least['method']}, {least['scalar']}, {least['isa']}",
        "least_home": str(least["home"]),
        "most": _ratio(most, "speed_up"),
        "most_of": f"{most['method']}, {most['scalar']}, {most['isa']}",
    }


def _ratio(row: pd.Series, key: str) -> str:
    return f"{times(row[key])} ({between(row[f'{key}_low'], row[f'{key}_high'])})"
