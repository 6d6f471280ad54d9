"""The exhibits of the Arm CPUs that llvm-mca models: a chart of their own and
the table that says what stands behind each model.
"""

from __future__ import annotations

import dataclasses
from typing import Final

import pandas as pd

from analysis.charts.palette import method_rank
from analysis.models import modelled
from analysis.models.arm_models import ARM_MODELS
from analysis.models.modelled import Error, Family
from analysis.read.run import Run
from analysis.report.columns import number, word
from analysis.report.exhibits import Exhibits
from analysis.report.wording import times

_COLOURS: Final = dict(
    zip(ARM_MODELS, ("#7A7A7A", "#4D4D4D", "#1A1A1A", "#B08A8A", "#8B2E2E", "#8B2E2E"))
)
_MARKS: Final = {"neon": "o", "sve": "s", "sve2": "D"}
_COLUMNS: Final = {
    f"{model} {isa}": (model, isa) for model, isas in ARM_MODELS.items() for isa in isas
}
ARM: Final = Family(
    key="-arm",
    who="Arm CPUs",
    isas={
        column: f"{ARM_MODELS[model][isa]} bit"
        for column, (model, isa) in _COLUMNS.items()
    },
    marks={column: _MARKS[isa] for column, (_, isa) in _COLUMNS.items()},
    colours={column: _COLOURS[model] for column, (model, _) in _COLUMNS.items()},
    between=",\n",
    beside="No measured row to compare\nwith: nothing ran on an Arm\nCPU. ",
    unknown="No measured row to compare\nwith: nothing ran on an Arm\nCPU.",
)


@dataclasses.dataclass(frozen=True)
class Arm:
    """What the chapter says of them."""

    modelled: bool
    not_emulated: str
    shared: list[tuple[str, str]]  # (model, the older CPU whose tables it has)
    slower_sve: str  # how SVE compares with NEON on one CPU, in a phrase


def arm_table(run: Run, scalar: str) -> pd.DataFrame:
    """One row a method, a column of cycles a point for each model and ISA."""
    rows = run.modelled_arm[run.modelled_arm["scalar"] == scalar]
    if rows.empty:
        return pd.DataFrame(columns=["method"])
    rows = rows.assign(column=rows["model"] + " " + rows["isa"])
    table = rows.pivot(index="method", columns="column", values="cycles")
    table = table[[column for column in _COLUMNS if column in table.columns]]
    table.columns.name = None
    return table.reset_index().sort_values(
        "method", key=lambda keys: keys.map(method_rank), ignore_index=True
    )


def models_table(run: Run, scalar: str) -> pd.DataFrame:
    """One row a model and ISA: the length of its vectors, how many methods were
    modelled, whose tables LLVM has for it, and the median over the methods of
    its cycles over those of NEON on the same CPU (`over_neon`).
    """
    cycles = arm_table(run, scalar)
    rows = []
    for column, (model, isa) in _COLUMNS.items():
        if column not in cycles:
            continue
        own = run.modelled_arm[
            (run.modelled_arm["model"] == model) & (run.modelled_arm["isa"] == isa)
        ]
        neon = cycles.get(f"{model} neon")
        rows.append(
            {
                "model": model,
                "isa": isa,
                "vector_bits": own["vector_bits"].iloc[0],
                "methods": int(cycles[column].notna().sum()),
                "tables": own["tables"].iloc[0] or "its own",
                "over_neon": (
                    (cycles[column] / neon).median()
                    if neon is not None and isa != "neon"
                    else float("nan")
                ),
                "measured": "none",
            }
        )
    columns = ["model", "isa", "vector_bits", "methods", "tables"]
    return pd.DataFrame(rows, columns=[*columns, "over_neon", "measured"])


def add_chart(
    exhibits: Exhibits, run: Run, scalar: str, error: Error | None, footer: str
) -> None:
    table = arm_table(run, scalar)
    if table.empty:
        return
    family = dataclasses.replace(
        ARM, beside=ARM.beside + _borrowed(run), unknown=ARM.unknown + _borrowed(run)
    )
    exhibits.figure(
        modelled.model_chart(table, scalar, error, footer, family),
        f"Modelled, not measured: cycles a point that llvm-mca gives for the loops "
        f"compiled for arm64, {scalar}, one triangle: the cycles of an iteration by "
        "the points that it decides with vectors as long as the CPU's.",
        table,
    )


def _borrowed(run: Run) -> str:
    """Lines for the chart on CPUs that LLVM has no tables of."""
    rows = run.modelled_arm[run.modelled_arm["tables"] != ""]
    return "".join(
        f"\n{model}: no tables of its own,\nthose of {own['tables'].iloc[0]}.\n"
        for model, own in rows.groupby("model")
    )


def add_table(exhibits: Exhibits, run: Run, scalar: str) -> Arm:
    table = models_table(run, scalar)
    if len(table):
        exhibits.table(
            "models_arm",
            f"The models of Arm CPUs, {scalar}. Cycles over NEON: the median over "
            "the methods, on the same CPU.",
            table,
            [
                word("model", "CPU modelled"),
                word("isa", "instruction set"),
                number("vector_bits", "vectors", "bits"),
                number("methods", "methods"),
                word("tables", "LLVM's tables are of"),
                number("over_neon", "cycles over NEON"),
                word("measured", "measured row"),
            ],
        )
    sve = table[table["over_neon"].notna()]
    return Arm(
        modelled=bool(len(table)),
        not_emulated=run.not_emulated,
        shared=[
            (row["model"], row["tables"])
            for row in table.to_dict("records")
            if row["tables"] != "its own"
        ],
        slower_sve=", ".join(
            f"{times(row['over_neon'])} on {row['model']} "
            f"({row['isa']}, {row['vector_bits']} bits)"
            for row in sve.to_dict("records")
        ),
    )
