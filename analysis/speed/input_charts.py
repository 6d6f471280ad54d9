"""The charts of what the input does: time against the number of points, and
against the share of them that is inside.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Sequence
from typing import Any, Final

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts import palette
from analysis.charts.chart_frame import (
    Chart,
    Label,
    finish,
    label_column,
    style,
    ticks_at,
)
from analysis.read.run import Cache
from analysis.report.method_families import in_order
from analysis.report.wording import (
    counted,
    listed,
    significant,
    size_in_bytes,
    times,
)
from analysis.speed.break_even import CROSS, INVERSE, break_even_words
from analysis.speed.input_tables import EARLY_OUT, data_caches

_WIDTH = 11.0
_LEFT, _STEP, _PANEL = 0.9, 5.15, 3.1  # inches
_STEPS = [m * 10.0**e for e in range(-4, 7) for m in (1, 2, 5)]


@dataclasses.dataclass(frozen=True)
class InputWords:
    """What the charts are about."""

    key: str
    item: str
    inside: str  # what the share is of
    said: str  # in short
    way_out: str
    claim: tuple[str, str]  # (dear to set up, what it has to win against)


POINTS: Final = InputWords(
    "input", "point", "points inside", "inside", "each edge", (INVERSE, CROSS)
)
RAYS: Final = InputWords(
    "ray-input",
    "ray",
    "rays that hit",
    "hit",
    "each test",
    ("baldwin_weber", "moller_trumbore"),
)


def size_chart(
    table: pd.DataFrame,
    evens: pd.DataFrame,
    scalar: str,
    caches: tuple[Cache, ...],
    footer: str,
    words: InputWords = POINTS,
) -> Chart:
    """Time an item against the items of a call above, and over that of what is
    cheapest to set up below; on scalar code and on the widest vectors.

    `table`: break_even.ratios_by_size, with rows of `scalar`; `evens`:
    break_even.break_evens.
    """
    rows = table[table["scalar"] == scalar]
    isas = sorted(rows["isa"].unique(), key=palette.isa_rank)
    isas = list(dict.fromkeys([isas[0], isas[-1]]))
    shown = rows[rows["isa"].isin(isas)]
    height = 7.6
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        for column, isa in enumerate(isas):
            part = shown[shown["isa"] == isa]
            left = (_LEFT + _STEP * column) / _WIDTH
            above = figure.add_axes((left, 0.505, _PANEL / _WIDTH, 0.34))
            below = figure.add_axes((left, 0.085, _PANEL / _WIDTH, 0.34))
            for axes, value in ((above, "ns"), (below, "ratio")):
                _lines(axes, part, value)
                _limits(axes, shown if value == "ns" else part, value)
                _sizes(axes, part)
                _cache_lines(axes, part, caches, named=value == "ns")
                label_column(axes, _ends(part, value), size=7.5)
            below.axhline(1, color=palette.INK, linewidth=0.8, zorder=1)
            above.text(
                0,
                1.075,
                f"{scalar}, {isa}",
                transform=above.transAxes,
                fontsize=9,
                weight="bold",
            )
            below.set_xlabel(
                f"{words.item}s a call (log scale, k = 1024)", fontsize=8.5
            )
            if column == 0:
                above.set_ylabel(
                    f"ns per {words.item} (log scale)   ←  better", fontsize=8.5
                )
            below.set_ylabel(
                f"call ÷ {part['cheapest'].iloc[0]} (log scale)", fontsize=8, labelpad=2
            )
        title = f"Set-up included, {scalar}: {_who_pays(evens, scalar, isas, words)}"
        ends = [shown["n"].min(), shown["n"].max()]
        alt = f"{title}. " + " ".join(
            f"{row.method}, {row.isa}, {counted(int(row.n), words.item)}: "
            f"{significant(row.ns)} ns each."
            for row in shown[shown["n"].isin(ends)].itertuples()
        )
        return finish(figure, f"{words.key}-size-{scalar}", title, alt, footer)


def _who_pays(
    evens: pd.DataFrame, scalar: str, isas: Sequence[str], words: InputWords
) -> str:
    """From where on the dear set-up that texts name has won its time back."""
    dear, other = words.claim
    rows = evens[
        (evens["scalar"] == scalar)
        & (evens["method"] == dear)
        & (evens["against"] == other)
    ].set_index("isa")
    found = [
        (
            f"from {break_even_words(rows.loc[isa])} {words.item}s a call on {isa}"
            if rows.loc[isa, "break_even_high"] == rows.loc[isa, "break_even_high"]
            else f"nowhere beyond doubt on {isa}"
        )
        for isa in isas
        if isa in rows.index
    ]
    if not found:
        return f"time by the {words.item}s of a call"
    return f"{dear} takes less than {other} {listed(found)}"


def _lines(axes: Any, part: pd.DataFrame, value: str) -> None:
    for method in in_order(part["method"]):
        own = part[part["method"] == method].sort_values("n").dropna(subset=[value])
        look = palette.method_style(method)
        axes.errorbar(
            own["n"],
            own[value],
            yerr=[
                own[value] - own[f"{value}_low"],
                own[f"{value}_high"] - own[value],
            ],
            fmt="o",
            linestyle=look.dash,
            color=look.colour,
            markersize=3,
            markerfacecolor="white" if look.variant else look.colour,
            elinewidth=0.8,
            linewidth=1.1,
            zorder=3,
        )


def _limits(axes: Any, rows: pd.DataFrame, value: str) -> None:
    low, high = float(rows[f"{value}_low"].min()), float(rows[f"{value}_high"].max())
    axes.set_xscale("log", base=2)
    axes.set_yscale("log")
    axes.set_ylim(low / 1.15, high * 1.15)
    ticks = [t for t in _STEPS if low / 1.15 <= t <= high * 1.15]
    if len(ticks) > 9:
        ticks = [t for t in ticks if f"{t:e}".startswith("1.0")]
    if value == "ratio":
        ticks = [t for t in _RATIOS if low / 1.15 <= t <= high * 1.15]
    ticks_at(axes.yaxis, lambda tick: f"{tick:g}", ticks)


_RATIOS = [0.1, 0.2, 0.4, 0.6, 0.8, 1, 1.25, 1.6, 2, 3, 4, 6, 10, 20, 50, 100]


def _sizes(axes: Any, part: pd.DataFrame) -> None:
    ends = [int(math.log2(part["n"].min())), int(math.log2(part["n"].max()))]
    axes.set_xlim(2.0 ** (ends[0] - 0.7), 2.0 ** (ends[1] + 0.7))
    step = 4 if ends[1] - ends[0] > 12 else 2
    ticks = [2.0**k for k in range(ends[0], ends[1] + 1, step)]
    ticks_at(axes.xaxis, _short, ticks)
    axes.tick_params(axis="x", labelsize=8)


def _short(n: float) -> str:
    for unit, size in (("M", 2**20), ("k", 2**10)):
        if n >= size:
            return f"{n / size:g} {unit}"
    return f"{n:g}"


def _cache_lines(
    axes: Any, part: pd.DataFrame, caches: tuple[Cache, ...], named: bool
) -> None:
    """Where the points of a call fill a cache."""
    per_point = float(part.loc[part["n"].idxmax(), "bytes_per_item"])
    low, high = axes.get_xlim()
    for name, size in data_caches(caches):
        at = size / per_point
        if not low < at < high:
            continue
        axes.axvline(at, color=palette.FAINT, linewidth=0.9, linestyle=":", zorder=1)
        if named:
            axes.text(
                at,
                1.01,
                f"{name}\n{size_in_bytes(size)}",
                transform=axes.get_xaxis_transform(),
                fontsize=6.5,
                color="#666666",
                ha="center",
                va="bottom",
                linespacing=1.0,
            )


def _ends(part: pd.DataFrame, value: str) -> list[Label]:
    labels = []
    for method in in_order(part["method"]):
        own = part[part["method"] == method].sort_values("n").dropna(subset=[value])
        if len(own):
            last, look = own.iloc[-1], palette.method_style(method)
            labels.append(
                Label(last["n"], last[value], method, look.colour, dash=look.dash)
            )
    return labels


def hit_chart(
    table: pd.DataFrame,
    ratios: pd.DataFrame,
    scalar: str,
    footer: str,
    words: InputWords = POINTS,
) -> Chart:
    """Time an item against the share of those inside, on fresh input and on
    fixed, with a way out after each edge and without.

    `table`: input_tables.by_hit_rate; `ratios`: early_out; both of `scalar`.
    """
    kinds = [kind for kind in ("fresh", "fixed") if kind in set(table["sets"])]
    rates = sorted(table["hit"].unique())
    low, high = float(table["ns_low"].min()), float(table["ns_high"].max())
    with style():
        figure = plt.figure(figsize=(_WIDTH, 4.9))
        for column, kind in enumerate(kinds):
            axes = figure.add_axes(
                ((_LEFT + _STEP * column) / _WIDTH, 0.165, _PANEL / _WIDTH, 0.62)
            )
            part = table[table["sets"] == kind]
            labels = _hit_lines(axes, part, rates)
            axes.set_yscale("log")
            axes.set_ylim(low / 1.2, high * 1.2)
            ticks_at(
                axes.yaxis,
                lambda tick: f"{tick:g}",
                [t for t in _STEPS if low / 1.2 <= t <= high * 1.2],
            )
            ticks_at(
                axes.xaxis, lambda at: f"{rates[round(at)]:g}", list(range(len(rates)))
            )
            axes.set_xlim(-0.4, len(rates) - 0.6)
            axes.set_xlabel(f"{words.inside}, %", fontsize=8.5)
            axes.set_title(f"{kind} input", loc="left", fontsize=9, weight="bold")
            if column == 0:
                axes.set_ylabel(f"ns per {words.item} (log scale)      ←  better")
            label_column(axes, labels, size=7.5)
        fresh = ratios[ratios["sets"] == "fresh"]
        worst = fresh.loc[fresh["over_plain"].idxmax()]
        best = fresh.loc[fresh["over_plain"].idxmin()]
        title = (
            f"A way out after {words.way_out}, {scalar}, on fresh input: "
            f"{times(best['over_plain'])} the time without at best ({best['isa']}, "
            f"{best['hit']:g} % {words.said}), {times(worst['over_plain'])} at worst "
            f"({worst['isa']}, {worst['hit']:g} %)"
        )
        alt = f"{title}. " + " ".join(
            f"{row.isa}, {row.sets}, {row.hit:g} % {words.said}: {times(row.over_plain)}."
            for row in ratios.itertuples()
        )
        return finish(figure, f"{words.key}-hit-{scalar}", title, alt, footer)


def _hit_lines(axes: Any, part: pd.DataFrame, rates: Sequence[float]) -> list[Label]:
    labels = []
    for isa in sorted(part["isa"].unique(), key=palette.isa_rank):
        for method in in_order(part["method"]):
            own = part[(part["isa"] == isa) & (part["method"] == method)]
            if not len(own):
                continue
            own = own.sort_values("hit")
            look = palette.method_style(method)
            at = [rates.index(hit) for hit in own["hit"]]
            axes.errorbar(
                at,
                own["ns"],
                yerr=[own["ns"] - own["ns_low"], own["ns_high"] - own["ns"]],
                fmt=palette.isa_marker(isa),
                linestyle=look.dash,
                color=look.colour,
                markersize=5,
                markerfacecolor="white" if look.variant else look.colour,
                elinewidth=0.9,
                linewidth=1.1,
                zorder=3,
            )
            words = f"{isa}, early out" if method.endswith(EARLY_OUT) else isa
            last = float(own["ns"].iloc[-1])
            labels.append(Label(at[-1], last, words, look.colour, dash=look.dash))
    return labels
