"""The exhibits of what a point costs: operations, instructions, and the cycles
that a model gives for other CPUs.
"""

from __future__ import annotations

import dataclasses
from typing import Any, Final

import pandas as pd

from analysis.models import arm_exhibits, arm_models, llvm_mca, modelled
from analysis.models.modelled import Error
from analysis.read.run import Run
from analysis.report.columns import number, word
from analysis.report.exhibits import Column, Exhibits
from analysis.speed import operations_tables

_TITLES: Final = {
    "add": "add",
    "multiply": "multiply",
    "multiply_add": "multiply-add",
    "divide": "divide",
    "min_max": "min, max",
    "integer_min_max": "integer min, max",
    "compare": "compare",
}


@dataclasses.dataclass(frozen=True)
class Costs:
    """What the chapters on cost say."""

    counted: bool  # whether operations were counted
    scalar: str
    isa: str | None  # whose instructions are shown
    ledger: list[dict[str, Any]]
    not_traced: str
    modelled: bool
    not_modelled: str
    left_out: str  # the CPUs that were not modelled and why, a sentence or nothing
    error: Error | None
    error_unknown: str  # why there is none, else empty
    models: list[str]
    arm: arm_exhibits.Arm


def with_models(run: Run) -> Run:
    """The run with what llvm-mca makes of its loops, or why there is nothing. Not of
    a stored run, which has what was made of them instead of the loops.
    """
    if run.instructions.empty:
        return dataclasses.replace(run, not_modelled=run.not_traced)
    try:
        return dataclasses.replace(
            run,
            modelled=llvm_mca.model(run.instructions, modelled.LOOP),
            modelled_arm=arm_models.model_arm(run.emulated),
            nearest_model=llvm_mca.model_of(run.machine.design),
        )
    except llvm_mca.NotModelled as reason:
        return dataclasses.replace(run, not_modelled=str(reason))


def add(
    exhibits: Exhibits,
    run: Run,
    cells: pd.DataFrame,
    scalars: list[str],
    scalar: str,
    footer: str,
) -> Costs:
    table = operations_tables.cost_table(run.operations, run.instructions, scalar)
    isa = operations_tables.traced_isa(run.instructions, scalar)
    if len(table):
        exhibits.table(
            "operations",
            f"Operations of every method for one triangle, {scalar}: per point and, "
            "below, per triangle (the set-up)."
            + (f" Instructions: executed per point, compiled for {isa}." if isa else "")
            + " The CSV has logic, conversions, loads and stores as well.",
            table,
            cost_columns(isa),
        )
    error = modelled.model_error(run, cells, scalar)
    words = modelled.error_words(error, run.nearest_model)
    for each in scalars:
        cycles = modelled.model_table(run.modelled, each)
        if cycles.empty:
            continue
        own = modelled.error_words(
            modelled.model_error(run, cells, each), run.nearest_model
        )
        exhibits.figure(
            modelled.model_chart(cycles, each, own, footer),
            f"Modelled, not measured: cycles a point that llvm-mca gives for the "
            f"compiled loop of each method, {each}, one triangle. It takes every "
            "load to be an L1 hit.",
            cycles,
        )
        arm_exhibits.add_chart(exhibits, run, each, own, footer)
    if len(error):
        exhibits.table(
            "model_error",
            f"The error of the model {run.nearest_model} on the CPU of this run, "
            f"{scalar}: modelled cycles a point over measured ones (time × clock).",
            error,
            [
                word("method", "method"),
                word("isa", "instruction set"),
                number("modelled", "modelled", "cycles a point"),
                number("measured", "measured", "cycles a point"),
                number("off", "modelled / measured"),
            ],
        )
    return Costs(
        counted=bool(len(table)),
        scalar=scalar,
        isa=isa,
        ledger=operations_tables.ledger(run.operations),
        not_traced=run.not_traced,
        modelled=bool(len(run.modelled)),
        not_modelled=run.not_modelled,
        left_out=modelled.left_out(run),
        error=words,
        error_unknown="" if words else _error_unknown(run.nearest_model),
        models=sorted(set(run.modelled["model"])),
        arm=arm_exhibits.add_table(exhibits, run, scalar),
    )


def _error_unknown(nearest: str | None) -> str:
    if nearest is None:
        return "the report was made on another machine, or LLVM has no model of it"
    isa = llvm_mca.MODELS[nearest]
    return f"its model {nearest} was given loops of {isa}, and this run timed none"


def cost_columns(isa: str | None, item: str = "point") -> list[Column]:
    """Of operations_tables.cost_table; `item`: what a call has many of."""
    columns = [word("method", "method")]
    columns += [_count(kind, _TITLES[kind], item) for kind in operations_tables.SHOWN]
    if isa:
        columns.append(number("instructions", "instructions", f"per {item}, {isa}"))
    return columns


def _count(kind: str, title: str, item: str) -> Column:
    """The count of an item, and below it that of the set-up."""

    def shown(count: float) -> str:
        return f"{count:.4g}" if count else "·"

    def set_up(row: dict[str, Any]) -> str:
        count = row[f"call_{kind}"]
        return f"set-up {shown(count)}" if count else ""

    return Column(
        title,
        lambda row: shown(row[f"item_{kind}"]),
        note=set_up,
        sort=f"item_{kind}",
        hint=f"per {item}; below, per triangle",
    )
