"""The chart of CPUs compared: every method's time against the run at hand."""

from __future__ import annotations

from collections.abc import Sequence

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts.chart_frame import Chart, finish, style, ticks_at
from analysis.charts.palette import INK
from analysis.cpus.cpus_tables import HERE, written_isas
from analysis.report.wording import times

_DOT = "#6E8FB0"
_ROW = 0.21  # inches
_WIDEST_LABEL = 46  # letters


def cpus_chart(rows: pd.DataFrame, isas: pd.DataFrame, footer: str) -> Chart:
    """One row a run in a group an ISA: a dot a method at its ratio, a diamond
    at their median. `rows`: with_cycles_ratio, `isas`: isa_table of them.
    """
    shown = rows[(rows["run"] != HERE) & rows["ratio"].notna()]
    names = list(dict.fromkeys(shown["run"]))
    places: list[tuple[str, str, float]] = []
    heads: list[tuple[str, float]] = []
    height = 0.0
    for isa in written_isas(shown):
        present = [n for n in names if len(_of(shown, isa, n))]
        heads.append((isa, height))
        for index, name in enumerate(present):
            places.append((isa, name, height + index + 1))
        height += len(present) + 1.5
    inches = 1.75 + _ROW * height
    left = 0.05 + 0.0061 * max(len(_short(name)) for name in names)
    with style():
        figure, axes = plt.subplots(figsize=(10, inches))
        figure.subplots_adjust(
            left=left, right=0.97, top=1 - 0.62 / inches, bottom=0.95 / inches
        )
        axes.set_xscale("log")
        axes.axvline(1, color=INK, linewidth=1.2, zorder=1)
        for isa, name, at in places:
            _draw(axes, _of(shown, isa, name), _of(isas, isa, name), at)
        for isa, at in heads:
            axes.text(
                -0.005,
                at,
                isa,
                transform=axes.get_yaxis_transform(),
                ha="right",
                va="center",
                weight="bold",
                fontsize=9,
            )
        axes.set_yticks(
            [at for _, _, at in places],
            [_short(name) for _, name, _ in places],
            fontsize=8,
        )
        axes.tick_params(axis="y", length=0)
        axes.set_ylim(height - 0.4, -0.8)
        low = min(0.8, float(shown["ratio"].min()))
        high = max(1.25, float(shown["ratio"].max()))
        axes.set_xlim(low / 1.05, high * 1.05)
        _ticks(axes, low / 1.05, high * 1.05)
        axes.set_xlabel(
            "←  faster than this run      time over that of this run, same method "
            "and ISA (line: 1)"
        )
        figure.text(
            left,
            0.28 / inches,
            "small: a method · diamond: the median of the methods, with its interval",
            fontsize=8,
            color="#666666",
        )
        title = _title(isas)
        alt = f"{title}. " + " ".join(
            f"{row['isa']}, {row['run']}: {times(row['ratio'])}, methods from "
            f"{times(row['least'])} to {times(row['most'])}."
            for row in isas[isas["run"] != HERE].to_dict("records")
            if (row["isa"], row["run"]) in {(i, n) for i, n, _ in places}
        )
        return finish(figure, "cpus", title, alt, footer)


def _of(table: pd.DataFrame, isa: str, name: str) -> pd.DataFrame:
    return table[(table["isa"] == isa) & (table["run"] == name)]


def _draw(axes: plt.Axes, dots: pd.DataFrame, middle: pd.DataFrame, at: float) -> None:
    axes.plot(
        dots["ratio"],
        [at] * len(dots),
        linestyle="",
        marker="o",
        markersize=3.2,
        color=_DOT,
        alpha=0.55,
        markeredgewidth=0,
        zorder=2,
    )
    for row in middle.to_dict("records"):
        axes.plot(
            [row["ratio_low"], row["ratio_high"]],
            [at, at],
            color=INK,
            linewidth=1.4,
            zorder=3,
        )
        axes.plot(
            [row["ratio"]],
            [at],
            marker="D",
            markersize=5,
            color=INK,
            markerfacecolor="white",
            zorder=4,
        )


def _short(name: str) -> str:
    return name if len(name) <= _WIDEST_LABEL else name[: _WIDEST_LABEL - 1] + "…"


def _ticks(axes: plt.Axes, low: float, high: float) -> None:
    every = [m * 10.0**e for e in range(-3, 4) for m in (1, 1.25, 1.5, 2, 3, 5, 7)]
    every += [0.8, 0.6, 0.4]
    inside = sorted(t for t in every if low <= t <= high)
    if len(inside) > 12:
        inside = [t for t in inside if f"{t:e}"[0:3] in ("1.0", "2.0", "5.0")]
    ticks_at(axes.xaxis, lambda value: f"{value:g}", inside)


def _title(isas: pd.DataFrame) -> str:
    """What the fastest of the others does on the widest ISA that it shares."""
    shared = isas[(isas["run"] != HERE) & isas["ratio"].notna()]
    isa: Sequence[str] = written_isas(shared)
    top = shared[shared["isa"] == isa[-1]]
    first = top.loc[top["ratio"].idxmin()]
    return (
        f"CPUs compared: on {isa[-1]} the median method takes "
        f"{times(float(first['ratio']))} the time of this run on {first['run']}"
        + (", the fastest of the others" if len(top) > 1 else "")
    )
