"""What a run is called among others, and whether it may be believed."""

from __future__ import annotations

from pathlib import Path
from typing import Final

import pandas as pd

from analysis.charts.palette import isa_rank
from analysis.read.kernel_hash import kernel_hash
from analysis.read.run import Run
from analysis.trust import noise

ROOT: Final = Path(__file__).resolve().parents[2]


def label_of(run: Run) -> str:
    """What it was given, or what it is of."""
    if run.label:
        return run.label
    limit = f", ISAs up to {run.isa_up_to}" if run.isa_up_to else ""
    return run.machine.name + limit


def code_state(run: Run, code: str | None = None) -> str:
    """Whether the run measured the kernels that are in this folder now."""
    if not run.machine.kernel_hash:
        return "not told"
    code = kernel_hash(ROOT) if code is None else code
    return "current" if run.machine.kernel_hash == code else "stale"


def table(runs: list[Run]) -> pd.DataFrame:
    """One row a run: what it was measured on, and whether it may be believed."""
    code = kernel_hash(ROOT)
    columns = ["run", "label", "model", "isas", "profile", "revision", "kernels"]
    columns += ["clock_ghz", "noise", "cells", "compiler"]
    rows = []
    for run in runs:
        clocks = [shard.clock_ghz for shard in run.shards]
        rows.append(
            {
                "run": run.name,
                "label": label_of(run),
                "model": run.machine.name,
                "isas": widest(run),
                "profile": run.profile,
                "revision": run.machine.revision[:12],
                "kernels": code_state(run, code),
                "clock_ghz": sum(clocks) / len(clocks),
                "noise": noise.judge(run.speed, run.shards).word,
                "cells": run.speed.loc[run.speed["control"] == "", "name"].nunique(),
                "compiler": run.machine.compiler,
            }
        )
    return pd.DataFrame(rows, columns=columns)


def widest(run: Run) -> str:
    """The widest ISA of the rows, and whether that was a choice."""
    isas = [isa for isa in set(run.speed["isa"]) if not isa.startswith("autovec")]
    top = max(isas, key=isa_rank, default="")
    return f"{top} (restricted)" if run.isa_up_to else top
