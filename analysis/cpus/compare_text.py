"""A comparison of two runs as lines for a terminal."""

from __future__ import annotations

import pandas as pd

from analysis.cpus.compare import Comparison, clock_ratio, compiled_alike, summary
from analysis.cpus.run_labels import code_state, label_of
from analysis.read.run import Run
from analysis.report.wording import (
    between,
    counted,
    share,
    significant,
    times,
    with_interval,
)

MOST = 20  # rows of a list; the rest are counted


def lines(found: Comparison, most: int = MOST) -> list[str]:
    a, b = found.a, found.b
    return [
        *_run_lines("A", a, found.noise_a.word),
        *_run_lines("B", b, found.noise_b.word),
        "",
        *_caveats(found),
        f"{counted(len(found.cells), 'cell')} in both, {found.only_a} only in A, "
        f"{found.only_b} only in B. A ratio is the time of B over that of A; with its "
        "95 % interval.",
        "A difference is real if the repetitions tell it from all that A/A pairs, "
        f"clocks, lost time{'' if found.same_build else ' and moved code'} account "
        f"for, {_within(found)}, with at most {significant(100 * found.level)} % of false "
        "claims among all (Benjamini-Hochberg).",
        "",
        *_list("slower in B", found.regressions, most),
        *_list("faster in B", found.improvements, most),
        *_summary("instruction set", found, "isa"),
        *_summary("method", found, "method"),
        *_accuracy(found, most),
    ]


def _run_lines(letter: str, run: Run, noise: str) -> list[str]:
    clocks = [shard.clock_ghz for shard in run.shards]
    state = code_state(run)
    return [
        f"{letter}: {run.name}: {label_of(run)}",
        f"   {run.machine.compiler}, revision {run.machine.revision[:12]}"
        f"{' (dirty)' if run.machine.dirty else ''}, kernels {state}, profile "
        f"{run.profile}, {min(clocks):.2f} to {max(clocks):.2f} GHz, noise: {noise}",
    ]


def _caveats(found: Comparison) -> list[str]:
    a, b = found.a, found.b
    said = []
    if found.noise_a.noisy or found.noise_b.noisy:
        said.append("! A noisy run tells less apart, and may tell it wrong.")
    if not compiled_alike(a, b):
        said.append("! Compiled otherwise: another compiler, or other flags.")
    if a.profile != b.profile:
        said.append(f"! Profiles differ: {a.profile} and {b.profile}.")
    if a.isa_up_to != b.isa_up_to:
        said.append(
            "! ISAs are restricted: "
            f"{a.isa_up_to or 'not in A'}, {b.isa_up_to or 'not in B'}."
        )
    clock = clock_ratio(a, b)
    if a.machine.same_cpu(b.machine) and abs(clock - 1) > 0.03:
        said.append(f"! The clock of B was {times(clock)} that of A.")
    return [*said, ""] if said else []


def _within(found: Comparison) -> str:
    least, most = found.cells["within"].min(), found.cells["within"].max()
    if least == most:
        return f"{significant(100 * least)} %"
    return f"{significant(100 * least)} to {significant(100 * most)} % by shard"


def _list(title: str, rows: pd.DataFrame, most: int) -> list[str]:
    shown = [
        f"  {row['ratio']:6.3f}  "
        f"{between(row['ratio_low'], row['ratio_high']):16}  {row['name']}"
        + (f"  (noisy in {row['noise']})" if row["noise"] else "")
        for row in rows.head(most).to_dict("records")
    ]
    more = [f"  and {len(rows) - most} more"] if len(rows) > most else []
    return [f"{counted(len(rows), 'cell')} {title}", *shown, *more, ""]


def _summary(title: str, found: Comparison, key: str) -> list[str]:
    rows = summary(found.cells, key).to_dict("records")
    width = max(len(str(row[key])) for row in rows)
    return (
        [f"By {title}: median ratio of its cells, slower / faster / all"]
        + [
            f"  {row[key]:{width}}  "
            f"{with_interval(row['ratio'], row['ratio_low'], row['ratio_high']):24}  "
            f"{row['slower']} / {row['faster']} / {row['cells']}"
            for row in rows
        ]
        + [""]
    )


def _accuracy(found: Comparison, most: int) -> list[str]:
    head = (
        f"Answers: {counted(found.judged, 'cell')} judged in both, {found.same_input} "
        "on the very same input, where any difference is one. "
        f"{counted(len(found.accuracy), 'count')} differ"
    )
    shown = [
        f"  {row['verdict']}: {row['kind']} {row['a']} of {row['a_of']} → "
        f"{row['b']} of {row['b_of']} ({share(row['a_rate'])} → "
        f"{share(row['b_rate'])})  "
        f"{row['name']}"
        for row in found.accuracy.head(most).to_dict("records")
    ]
    more = len(found.accuracy) - most
    return [head, *shown, *([f"  and {more} more"] if more > 0 else [])]
