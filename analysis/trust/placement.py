"""What moving a kernel's code does to its time: the table, the words, the chart.

Cells `…/placed_<bytes>` are the same kernels as those of the plain rows, with
their code that many bytes past a cache line; the plain ones start on one, and
so do their loops.
"""

from __future__ import annotations

from typing import Any

import matplotlib.pyplot as plt
import pandas as pd

from analysis.charts import palette
from analysis.charts.chart_frame import Chart, finish, style
from analysis.report.wording import between, times
from analysis.speed.tables import samples, sort_cells
from analysis.trust.noisy_marks import noise_legend, ring
from analysis.trust.row_noise import row_noise
from analysis.trust.stats import CONFIDENCE, median_interval, ratio_interval

ALIGNED = "aligned"
_PLACED = "placed_"
_KEYS = ["loop", "scene", "method", "scalar", "isa"]
_MARKERS = ["o", "s", "D", "^", "v", "P", "X"]


def placements(speed: pd.DataFrame) -> pd.DataFrame:
    """One row a place of each kernel that was timed in several: its time, and
    that over the time of the aligned one (`over_aligned`), both of one shard.
    """
    placed = speed[speed["control"].str.startswith(_PLACED)]
    plain = [name.rpartition("/")[0] for name in placed["name"]]
    by_cell = samples(speed[speed["name"].isin({*placed["name"], *plain})])
    rows = []
    for (shard, name), group in placed.groupby(["shard", "name"], sort=True):
        base = by_cell.get((shard, name.rpartition("/")[0]))
        if base is None:
            continue
        first = group.iloc[0]
        place = str(first["control"]).removeprefix(_PLACED)
        kernel = {key: first[key] for key in _KEYS}
        for where, own in ((ALIGNED, base), (place, by_cell[shard, name])):
            time = median_interval(own)
            over = (1.0, 1.0, 1.0) if own is base else ratio_interval(own, base)[:3]
            rows.append(
                {
                    "shard": shard,
                    **kernel,
                    "place": where,
                    "ns": time.value,
                    "ns_low": time.low,
                    "ns_high": time.high,
                    "over_aligned": over[0],
                    "over_aligned_low": over[1],
                    "over_aligned_high": over[2],
                    "noise": row_noise(own),
                }
            )
    columns = ["shard", *_KEYS, "place", "ns", "ns_low", "ns_high"]
    columns += [f"over_aligned{end}" for end in ("", "_low", "_high")] + ["noise"]
    table = pd.DataFrame(rows, columns=columns).drop_duplicates(
        ["shard", *_KEYS, "place"]
    )
    rank = table["place"].map(lambda p: -1 if p == ALIGNED else int(p))
    return sort_cells(table.assign(_rank=rank), [*_KEYS, "_rank"]).drop(columns="_rank")


def spreads(speed: pd.DataFrame, table: pd.DataFrame) -> pd.DataFrame:
    """One row a kernel of `placements`: the slowest place's time over the
    fastest one's (`spread`), and the aligned one's over the fastest one's.

    Which place is the slowest and which the fastest is decided by the same
    noise that the interval is to tell from a difference; so it is as wide as
    one that holds for all pairs of places at once (Bonferroni).
    """
    by_cell = samples(speed)
    rows = []
    for key, group in table.groupby(["shard", *_KEYS], sort=False):
        kernel = dict(zip(["shard", *_KEYS], key))
        name = "/".join(str(kernel[k]) for k in _KEYS)
        slowest = group.loc[group["ns"].idxmax()]
        fastest = group.loc[group["ns"].idxmin()]
        pairs = len(group) * (len(group) - 1) / 2
        joint = 1 - (1 - CONFIDENCE) / max(pairs, 1)
        own = {
            place: by_cell[kernel["shard"], _cell(name, place)]
            for place in (ALIGNED, slowest["place"], fastest["place"])
        }
        best = own[fastest["place"]]
        spread = ratio_interval(own[slowest["place"]], best, joint)
        aligned = ratio_interval(own[ALIGNED], best, joint)
        itself = fastest["place"] == ALIGNED
        rows.append(
            {
                **kernel,
                "places": len(group),
                "fastest": fastest["place"],
                "slowest": slowest["place"],
                "spread": spread.value,
                "spread_low": spread.low,
                "spread_high": spread.high,
                "aligned": 1.0 if itself else aligned.value,
                "aligned_low": 1.0 if itself else aligned.low,
                "aligned_high": 1.0 if itself else aligned.high,
                "ns_fastest": fastest["ns"],
                "ns_slowest": slowest["ns"],
                "ns_aligned": group[group["place"] == ALIGNED]["ns"].iloc[0],
            }
        )
    columns = ["shard", *_KEYS, "places", "fastest", "slowest"]
    columns += [f"spread{end}" for end in ("", "_low", "_high")]
    columns += [f"aligned{end}" for end in ("", "_low", "_high")]
    columns += ["ns_fastest", "ns_slowest", "ns_aligned"]
    return pd.DataFrame(rows, columns=columns)


def usual_spread(speed: pd.DataFrame) -> float:
    """What moving a kernel's code changes, as a ratio: the median of the kernels
    that were timed in several places, 1 if none was. Of methods that differ by less
    neither is the faster one.
    """
    found = spreads(speed, placements(speed))["spread"]
    return float(found.median()) if len(found) else 1.0


def _cell(name: str, place: str) -> str:
    return name if place == ALIGNED else f"{name}/{_PLACED}{place}"


def placement_words(spread: pd.DataFrame) -> dict[str, Any] | None:
    """The spread that surely is the largest, in phrases: what a ratio has to exceed
    where `apart`, the number of kernels whose spread is no chance, is not 0.
    """
    if not len(spread):
        return None
    top = spread.loc[spread["spread_low"].idxmax()]
    surely = spread[spread["spread_low"] > 1]
    return {
        "kernels": len(spread),
        "places": int(spread["places"].max()),
        "method": top["method"],
        "isa": top["isa"],
        "scalar": top["scalar"],
        "ratio": times(top["spread"]),
        "interval": between(top["spread_low"], top["spread_high"]),
        "fastest": place_words(top["fastest"]),
        "slowest": place_words(top["slowest"]),
        "apart": len(surely),
    }


def place_words(place: str) -> str:
    return ALIGNED if place == ALIGNED else f"{place} bytes on"


def placement_chart(table: pd.DataFrame, spread: pd.DataFrame, footer: str) -> Chart:
    """The time in each place over that of the aligned kernel, a line a kernel.

    `table`: placements, `spread`: spreads of it; neither empty.
    """
    kernels = list(dict.fromkeys(zip(table["method"], table["isa"])))
    places = [p for p in table["place"].unique() if p != ALIGNED]
    with style():
        height = 1.95 + 0.34 * len(kernels)
        figure, axes = plt.subplots(figsize=(10, height))
        figure.subplots_adjust(
            left=0.3, right=0.97, top=1 - 0.75 / height, bottom=1.05 / height
        )
        for index, place in enumerate(places):
            rows = table[table["place"] == place]
            shift = (index - (len(places) - 1) / 2) * 0.7 / len(places)
            heights = [
                -kernels.index(k) - shift for k in zip(rows["method"], rows["isa"])
            ]
            axes.errorbar(
                rows["over_aligned"],
                heights,
                xerr=[
                    rows["over_aligned"] - rows["over_aligned_low"],
                    rows["over_aligned_high"] - rows["over_aligned"],
                ],
                fmt=_MARKERS[index % len(_MARKERS)],
                color=palette.INK,
                markersize=4.5,
                markerfacecolor="white",
                elinewidth=0.9,
                label=f"{place} bytes past a cache line",
            )
            ring(axes, rows, rows["over_aligned"], heights)
        axes.axvline(1, color=palette.INK, linewidth=1.2)
        axes.set_yticks(
            [-i for i in range(len(kernels))],
            [f"{method}, {isa}" for method, isa in kernels],
            fontsize=8,
        )
        axes.set_ylim(-len(kernels) + 0.4, 0.6)
        low = min(0.95, float(table["over_aligned_low"].min()))
        high = max(1.05, float(table["over_aligned_high"].max()))
        axes.set_xlim(low - 0.01, high + 0.01)
        axes.set_xlabel(
            "←  better      time over that of the same kernel, aligned (line: 1)"
        )
        handles = axes.get_legend_handles_labels()[0] + noise_legend(table)
        figure.legend(
            handles=handles,
            loc="lower left",
            bbox_to_anchor=(0.075, 0.26 / height),
            ncol=len(handles),
            fontsize=8,
            handletextpad=0.3,
            columnspacing=1.0,
        )
        words = placement_words(spread)
        assert words is not None
        of = f"{words['method']}, {words['isa']}"
        title = "The same instructions elsewhere: " + (
            f"the slowest place takes {words['ratio']} the time of the fastest "
            f"({words['interval']}; {of}), more than is sure of any other kernel"
            if words["apart"]
            else f"no place is surely slower than another ({words['ratio']}, "
            f"{words['interval']}; {of})"
        )
        alt = f"{title}. " + " ".join(
            f"{row.method}, {row.isa}, {place_words(row.place)}: "
            f"{times(row.over_aligned)}."
            for row in table[table["place"] != ALIGNED].itertuples()
        )
        return finish(figure, "placements", title, alt, footer)
