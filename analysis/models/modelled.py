"""Cycles that llvm-mca models for CPUs that were not measured: their table, how
far the model is off on the CPU that was, and a chart of their own.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any, Final

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts.chart_frame import Chart, finish, style
from analysis.charts.palette import GRID, INK, isa_rank, method_rank
from analysis.models.llvm_mca import MODELS
from analysis.read.run import Run
from analysis.report.wording import listed, significant, times
from analysis.speed.tables import reference_cells

LOOP: Final = "one_triangle"


@dataclasses.dataclass(frozen=True)
class Family:
    """Models that share a chart: column of the table → what its mark is."""

    key: str  # behind the name of the chart
    who: str
    isas: Mapping[str, str]
    marks: Mapping[str, str]
    colours: Mapping[str, str]
    between: str = ", "  # models that share a mark
    beside: str = ""  # before the words on the error
    unknown: str = (
        "The model of the CPU\nof this run is not known,\nso neither is its error."
    )


# None of the colours of methods and instruction sets, and only hollow marks:
# nothing here was measured.
_MARKS: Final = dict(zip(MODELS, ("o", "s", "D", "^", "v", "h")))
_COLOURS: Final = dict(
    zip(MODELS, ("#7A7A7A", "#4D4D4D", "#1A1A1A", "#B08A8A", "#A05A5A", "#8B2E2E"))
)
X86: Final = Family("", "CPUs that are not here", MODELS, _MARKS, _COLOURS)


def model_table(modelled: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """One row a method, a column of cycles an item for each model."""
    rows = modelled[(modelled["scalar"] == scalar) & (modelled["loop"] == LOOP)]
    if rows.empty:
        return pd.DataFrame(columns=["method"])
    table = rows.pivot(index="method", columns="model", values="cycles")
    table = table[[name for name in MODELS if name in table.columns]]
    table.columns.name = None
    return table.reset_index().sort_values(
        "method", key=lambda keys: keys.map(method_rank), ignore_index=True
    )


def model_error(run: Run, cells: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """`modelled` cycles an item on the model of the CPU of the run, `measured`
    ones (time × the clock of the shard), and `off`, the first over the second;
    the smallest scene of the loop. Empty where that CPU has no model.
    """
    columns = ["method", "isa", "modelled", "measured", "off"]
    own = run.modelled[
        (run.modelled["model"] == run.nearest_model)
        & (run.modelled["scalar"] == scalar)
        & (run.modelled["loop"] == LOOP)
    ]
    timed = reference_cells(cells, scalar, LOOP)
    if own.empty or timed.empty:
        return pd.DataFrame(columns=columns)
    clock = {
        shard.name: (shard.clock_before_ghz + shard.clock_after_ghz) / 2
        for shard in run.shards
    }
    timed = timed.assign(measured=timed["ns"] * timed["shard"].map(clock))
    both = own.rename(columns={"cycles": "modelled"}).merge(
        timed[["method", "isa", "measured"]], on=["method", "isa"]
    )
    both = both.assign(off=both["modelled"] / both["measured"])
    return both.sort_values(
        "method", key=lambda keys: keys.map(method_rank), ignore_index=True
    )[columns]


def left_out(run: Run) -> str:
    """Which CPUs of MODELS have no cycles in the run and why, in a sentence; empty
    where all have some, where nothing could be modelled (run.not_modelled), or where
    nobody asked.
    """
    asked = len(run.modelled) or run.nearest_model is not None
    known = set(run.modelled["model"])
    missing: dict[str, list[str]] = {}
    for model, isa in MODELS.items():
        if model not in known:
            missing.setdefault(isa, []).append(model)
    if run.not_modelled or not missing or not asked:
        return ""
    parts = [
        f"{listed(models)}, whose loops " f"are of {isa}, which {_why_not(isa, run)}"
        for isa, models in missing.items()
    ]
    return f"Not modelled {'is' if len(known) == len(MODELS) - 1 else 'are'} " + (
        f"{'; and '.join(parts)}."
    )


def _why_not(isa: str, run: Run) -> str:
    """Ends a sentence: a model reads the instructions of loops that ran here."""
    if isa not in run.machine.isas:
        return "the CPU of this run does not have, so that none could be traced"
    if run.isa_up_to and isa_rank(isa) > isa_rank(run.isa_up_to):
        return f"this run left out: it was held to {run.isa_up_to}"
    return "has none here that was traced and repeats"


@dataclasses.dataclass(frozen=True)
class Error:
    """How far the model is off, in phrases."""

    model: str
    least: str
    least_method: str
    median: str
    most: str
    most_method: str
    methods: int


def error_words(error: pd.DataFrame, model: str | None) -> Error | None:
    if error.empty or model is None:
        return None
    least, most = error.loc[error["off"].idxmin()], error.loc[error["off"].idxmax()]
    return Error(
        model=model,
        least=times(least["off"]),
        least_method=least["method"],
        median=times(error["off"].median()),
        most=times(most["off"]),
        most_method=most["method"],
        methods=len(error),
    )


def model_chart(
    table: pd.DataFrame,
    scalar: str,
    error: Error | None,
    footer: str,
    family: Family = X86,
) -> Chart:
    """Cycles an item, a row a method, a hollow mark a model."""
    models = [name for name in family.isas if name in table.columns]
    shown = table.iloc[::-1].reset_index(drop=True)
    height = max(1.45 + 0.23 * len(shown), 4.6)
    with style():
        figure = plt.figure(figsize=(11.0, height))
        axes = figure.add_axes(
            (0.27, 0.78 / height, 0.5, (height - 0.78 - 0.55) / height)
        )
        _draw(axes, shown, models, family)
        axes.legend(
            title="modelled, not measured",
            loc="upper left",
            bbox_to_anchor=(1.02, 1.0),
            fontsize=8.5,
            title_fontsize=8.5,
            alignment="left",
        )
        beside = (
            family.unknown
            if error is None
            else family.beside
            + f"On the CPU of this run the\nmodel {error.model} gave\n"
            f"{error.least} to {error.most} the\nmeasured cycles\n"
            f"(median {error.median})."
        )
        figure.text(
            0.785,
            1 - 2.75 / height,
            beside,
            ha="left",
            va="top",
            fontsize=8.5,
            color="#8B2E2E",
            bbox={"facecolor": "#FFF6F4", "edgecolor": "#C9A0A0", "pad": 5},
        )
        title = f"MODELLED by llvm-mca: cycles a point on {family.who}, {scalar}"
        alt = f"{title}. " + " ".join(
            f"{row['method']}: "
            + ", ".join(f"{name} {significant(row[name])}" for name in models)
            + "."
            for row in table.to_dict("records")
        )
        return finish(figure, f"modelled{family.key}-{scalar}", title, alt, footer)


def alike(
    table: pd.DataFrame, models: list[str], isas: Mapping[str, str] = MODELS
) -> list[list[str]]:
    """The models in their order, those together that give the same for every
    method by the same loops: one mark stands for them.
    """
    groups: list[list[str]] = []
    for name in models:
        for group in groups:
            if isas[group[0]] == isas[name] and table[group[0]].equals(
                table[name].rename(group[0])
            ):
                group.append(name)
                break
        else:
            groups.append([name])
    return groups


def _draw(axes: Any, shown: pd.DataFrame, models: list[str], family: Family) -> None:
    axes.set_facecolor("#FBF9F9")
    for names in alike(shown, models, family.isas):
        name = names[0]
        axes.plot(
            shown[name],
            range(len(shown)),
            linestyle="none",
            marker=family.marks[name],
            markersize=6,
            markerfacecolor="none",
            markeredgecolor=family.colours[name],
            markeredgewidth=1.2,
            label=f"{family.between.join(names)} ({family.isas[name]})",
        )
    axes.set_xscale("log")
    low, high = axes.get_xlim()
    ticks = [m * 10.0**e for e in range(-3, 5) for m in (1, 2, 5)]
    axes.set_xticks([tick for tick in ticks if low <= tick <= high])
    axes.set_xticks([], minor=True)
    axes.xaxis.set_major_formatter(lambda value, _: f"{value:g}")
    axes.set_xlabel("modelled cycles a point (log scale)      ←  better")
    axes.set_yticks(range(len(shown)))
    axes.set_yticklabels(shown["method"], fontsize=8, color=INK)
    axes.set_ylim(-0.7, len(shown) - 0.3)
    axes.grid(axis="y", color=GRID, linewidth=0.5)
