"""The exhibits and words on how far the run's numbers can be trusted."""

from __future__ import annotations

from typing import Any

import pandas as pd

from analysis.read.cells import DOUBLED, TWIN
from analysis.report import columns
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import counted
from analysis.trust.controls import TITLES
from analysis.trust.controls import NEGLIGIBLE
from analysis.trust.noise import MOST_NOISY_ROWS, Verdict
from analysis.trust.noisy_marks import noise_note
from analysis.trust.placement import (
    placement_chart,
    placement_words,
    placements,
    place_words,
    spreads,
)
from analysis.trust.row_noise import TOLERANCE

PAIRS = (
    Column("pair", lambda row: TITLES[row["control"]], numeric=False),
    columns.word("shard", "shard"),
    columns.word("name", "cell"),
    columns.number("expected", "expected"),
    columns.ratio("ratio", "ratio"),
    columns.near_interval("ratio", "interval"),
    Column("coverage", lambda row: f"{100 * row['coverage']:.2f} %", sort="coverage"),
    Column("holds", lambda row: "no" if row["trouble"] else "yes", numeric=False),
)
PLACEMENTS = (
    columns.word("method", "method"),
    columns.word("isa", "ISA"),
    columns.word("scene", "scene"),
    Column("fastest at", lambda row: place_words(row["fastest"]), numeric=False),
    Column("slowest at", lambda row: place_words(row["slowest"]), numeric=False),
    columns.number("ns_fastest", "ns, fastest"),
    columns.number("ns_slowest", "ns, slowest"),
    columns.number("ns_aligned", "ns, aligned"),
    columns.with_interval("spread", "slowest ÷ fastest", "joint interval"),
    columns.with_interval("aligned", "aligned ÷ fastest", "joint interval"),
)


def add_trust(
    exhibits: Exhibits, speed: pd.DataFrame, judged: Verdict, footer: str
) -> pd.DataFrame:
    """Adds the exhibits and returns the spreads by placement."""
    if len(judged.pairs):
        exhibits.table(
            "pairs",
            "The pairs of which the ratio is known: the same kernel timed twice (A/A) "
            "and twice its work timed as if it were one (2×). The intervals of "
            "the A/A pairs are so wide that with 95 % they all hold 1 at once; to "
            f"miss it by {100 * NEGLIGIBLE} % is no trouble.",
            judged.pairs,
            PAIRS,
        )
    table = placements(speed)
    spread = spreads(speed, table)
    if len(spread):
        exhibits.figure(
            placement_chart(table, spread, footer),
            "The same kernels, their code so many bytes past a cache line and their "
            "loops where that puts them, over those that are aligned. Whiskers are "
            "95 % intervals of the ratio." + noise_note(table),
            table,
        )
        exhibits.table(
            "placements_spread",
            "The slowest and the fastest place of each kernel. The joint intervals "
            "hold for all pairs of its places at once with 95 %.",
            spread,
            PLACEMENTS,
        )
    return spread


def trust_facts(judged: Verdict, spread: pd.DataFrame) -> dict[str, Any]:
    """The verdict's figures in phrases."""
    return {
        "pairs": {
            "twins": _pairs(judged.pairs, TWIN),
            "doubled": _pairs(judged.pairs, DOUBLED),
        },
        "rows": counted(judged.rows, "row"),
        "noisy_rows": judged.noisy_rows,
        "noisy_share": _percent(judged.noisy_rows / judged.rows if judged.rows else 0),
        "most_noisy": f"{100 * MOST_NOISY_ROWS:.0f} %",
        "tolerance": f"{100 * TOLERANCE:.0f} %",
        "negligible": f"{100 * NEGLIGIBLE} %",
        "placement": placement_words(spread),
    }


def _percent(value: float) -> str:
    return f"{100 * value:.1f} %"


def _pairs(pairs: pd.DataFrame, control: str) -> dict[str, Any] | None:
    """How the pairs of a kind came out; None if there are none."""
    own = pairs[pairs["control"] == control]
    if not len(own):
        return None
    expected = own["expected"].iloc[0]
    holds = (own["ratio_low"] <= expected) & (expected <= own["ratio_high"])
    near = (own["ratio_low"] <= expected * (1 + NEGLIGIBLE)) & (
        own["ratio_high"] >= expected * (1 - NEGLIGIBLE)
    )
    return {
        "count": len(own),
        "counted": counted(len(own), "pair"),
        "least": f"{own['ratio'].min():.3f}",
        "most": f"{own['ratio'].max():.3f}",
        "lowest": f"{own['ratio_low'].min():.3f}",
        "highest": f"{own['ratio_high'].max():.3f}",
        "holding": int(holds.sum()),
        "near": int(near.sum()),
        "excluding_one": int(((own["ratio_low"] > 1) | (own["ratio_high"] < 1)).sum()),
        "troubled": int((own["trouble"] != "").sum()),
    }
