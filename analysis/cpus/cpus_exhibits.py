"""The chapter that sets several CPUs side by side: exhibits and phrases."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any, Final

import pandas as pd

from analysis.cpus import cpus_tables as tables
from analysis.cpus.compare import LEVEL
from analysis.cpus.cpus_chart import cpus_chart
from analysis.cpus.run_labels import code_state
from analysis.read.run import Run
from analysis.report import wording
from analysis.report.columns import Row, number, percent, whole, with_interval, word
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import between, counted, listed, significant, times


@dataclasses.dataclass(frozen=True)
class Cpus:
    """What the chapter says."""

    stored: int  # runs kept, the run at hand left out
    state: str  # of the run at hand's kernels: current, stale, not told
    scalar: str
    stale: tuple[str, ...]  # runs of other kernels than the code has now
    other_code: tuple[str, ...]  # runs of other kernels than the run at hand
    noisy: tuple[str, ...]
    isas: tuple[dict[str, str], ...]  # a sentence a run, on its widest shared ISA
    answers: str
    agreement: str
    own_model: str


_NS: Final = Column(
    "ns/point",
    lambda row: significant(row["ns"]),
    lambda row: between(row["ns_low"], row["ns_high"])
    + (", noisy" if row["noise"] else ""),
    "ns",
    hint="95 % interval below",
)


def _share(row: Row) -> str:
    value = row["of_limit"]
    if value != value:
        return wording.NONE
    return f"{significant(100 * value)}{wording.JOIN}%"


_OF_LIMIT: Final = Column("% of limit", _share, sort="of_limit", hint="of its own CPU")
_RATIO: Final = with_interval(
    "ratio", "× this run's time", "95 % interval of the repetitions"
)
_CYCLES: Final = number("cycles", "cycles/point", "time × the clock of its shard")
_BOTH_CYCLES: Final = Column(
    "cycles/point",
    lambda row: significant(row["cycles"]),
    lambda row: (
        ""
        if row["cycles_ratio"] != row["cycles_ratio"] or row["run"] == tables.HERE
        else f"{times(row['cycles_ratio'])} this run's"
    ),
    "cycles",
    hint="time × the clock of its shard; below, over that of this run",
)
_PER_CLOCK: Final = number(
    "cycles_ratio", "× this run's cycles", "per clock: below 1 does more in a cycle"
)


def add(
    exhibits: Exhibits, run: Run, stored: Sequence[Run], scalar: str, footer: str
) -> Cpus:
    """Adds the exhibits if there is a run to compare with."""
    others = tables.others_of(run, stored)
    if not others:
        return Cpus(0, code_state(run), scalar, (), (), (), (), "", "", "")
    found = tables.cpus(run, others, scalar)
    overview = tables.overview(found)
    exhibits.table(
        "cpus-runs",
        "The runs that are compared. “Stale” ones measured other kernels than the "
        "code has now.",
        overview,
        [
            word("run", "run"),
            word("model", "CPU"),
            word("isas", "widest ISA"),
            number("clock_ghz", "clock, GHz", "median of its shards, measured"),
            word("profile", "profile"),
            word("revision", "revision"),
            word("kernels", "kernels"),
            word("noise", "noise"),
            word("folder", "kept as"),
        ],
    )
    rows = tables.with_cycles_ratio(found)
    isas = tables.isa_table(found)
    shared = rows[(rows["run"] != tables.HERE) & rows["ratio"].notna()]
    if len(tables.written_isas(shared)):
        exhibits.figure(
            cpus_chart(rows, isas, footer),
            f"The same methods on other CPUs, {scalar}, one triangle, fresh input: "
            "time over that of this run, for each instruction set that both have. "
            "Repetitions of two runs know nothing of what differs from day to day.",
            rows,
        )
    exhibits.table(
        "cpus-isas",
        f"By instruction set, {scalar}: medians over the methods; the interval is that "
        "of the median method.",
        isas,
        [
            word("isa", "ISA"),
            word("run", "run"),
            whole("methods", "methods"),
            _RATIO,
            number("least", "least"),
            number("most", "most"),
            _PER_CLOCK,
            _CYCLES,
            _OF_LIMIT,
        ],
    )
    methods = tables.method_table(found)
    exhibits.table(
        "cpus-methods",
        f"By method, {scalar}: each on the widest instruction set of its run, over the "
        "same method on the widest of this run.",
        methods,
        [
            word("method", "method"),
            word("run", "run"),
            word("isa", "ISA"),
            _NS,
            _RATIO,
            _BOTH_CYCLES,
            _OF_LIMIT,
        ],
        most_rows=100,
    )
    answers = tables.answers(found, LEVEL)
    exhibits.table(
        "cpus-answers",
        "Answers against those of this run: cells that both judged, those with the very "
        "same input, and of these the ones with another count of anything.",
        answers.merge(overview[["run", "groups", "apart"]], on="run"),
        [
            word("run", "run"),
            whole("judged", "judged in both"),
            whole("same_input", "same input"),
            whole("differ", "other counts"),
            word("methods", "methods"),
            whole("groups", "cells on several ISAs"),
            whole("apart", "not the same on all"),
        ],
    )
    models = tables.models(found, scalar)
    if len(models):
        exhibits.table(
            "cpus-modelled",
            f"Modelled, not measured, {scalar}: cycles that llvm-mca gives over cycles "
            "measured here, median over the methods. The row of this CPU's own model "
            "is the model's error, which the others share to an unknown part.",
            models,
            [
                word("model", "model"),
                word("isa", "ISA"),
                whole("methods", "methods"),
                with_interval("ratio", "modelled / measured here"),
                number("least", "least"),
                number("most", "most"),
                Column(
                    "model of",
                    lambda row: "this CPU" if row["own"] else "another CPU",
                    numeric=False,
                ),
            ],
        )
    return Cpus(
        stored=len(others),
        state=found[0].state,
        scalar=scalar,
        stale=tuple(cpu.name for cpu in found if cpu.state == "stale"),
        other_code=tuple(c.name for c in found[1:] if _other_code(found[0].run, c.run)),
        noisy=tuple(cpu.name for cpu in found if cpu.noise == "noisy"),
        isas=tuple(_sentences(isas)),
        answers=_answers_words(answers),
        agreement=_agreement_words(overview),
        own_model=_own_model(models),
    )


def _other_code(own: Run, other: Run) -> bool:
    first, second = own.machine, other.machine
    if first.kernel_hash and second.kernel_hash:
        return first.kernel_hash != second.kernel_hash
    return first.revision != second.revision


def _sentences(isas: pd.DataFrame) -> list[dict[str, str]]:
    """A run's median ratio on the widest ISA that it shares with this one."""
    others = isas[(isas["run"] != tables.HERE) & isas["ratio"].notna()]
    found = []
    for name, group in others.groupby("run", sort=False):
        written = tables.written_isas(group)
        if not written:
            continue
        row: dict[str, Any] = group[group["isa"] == written[-1]].iloc[0].to_dict()
        found.append(
            {
                "run": str(name),
                "isa": written[-1],
                "ratio": times(row["ratio"]),
                "interval": between(row["ratio_low"], row["ratio_high"]),
                "least": times(row["least"]),
                "most": times(row["most"]),
                "cycles": times(row["cycles_ratio"]),
            }
        )
    return found


def _answers_words(answers: pd.DataFrame) -> str:
    """Whether CPUs give other answers on the same input."""
    same = answers[answers["same_input"] > 0]
    if same.empty:
        return (
            "no run was judged on the input of this one, so answers cannot be compared"
        )
    apart = same[same["differ"] > 0]
    cells = counted(int(same["same_input"].sum()), "cell")
    if apart.empty:
        return f"in all {cells} with the very same input every count is the same"
    each = [
        f"{row['run']} in {row['differ']} of {row['same_input']} ({row['methods']})"
        for row in apart.to_dict("records")
    ]
    return f"of {cells} with the very same input, counts differ on {listed(each)}"


def _agreement_words(overview: pd.DataFrame) -> str:
    """Whether the answers depend on the ISA, and with it on having FMA."""
    apart = overview[overview["apart"] > 0]
    if apart.empty:
        return "in every run, all instruction sets give the same counts"
    each = [
        f"{row['run']}: {row['apart']} of {row['groups']}"
        for row in apart.to_dict("records")
    ]
    return f"counts depend on the instruction set in some cells ({listed(each)})"


def _own_model(models: pd.DataFrame) -> str:
    own = models[models["own"].astype(bool)]
    if own.empty:
        return ""
    return f"{own.iloc[0]['model']} ({times(own.iloc[0]['ratio'])})"
