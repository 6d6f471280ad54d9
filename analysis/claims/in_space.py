"""Claims about rays and triangles in space."""

from __future__ import annotations

from typing import Final

import pandas as pd

from analysis.claims.evidence import (
    Evidence,
    Finding,
    TimeRatio,
    judged,
    not_measured,
    time_ratio,
)
from analysis.rays.rays_claims import WATERTIGHT, kept_break_evens
from analysis.rays.rays_tables import BASE, KEPT, MAIN_LOOP, without_tuv
from analysis.report.method_families import FMA_SUFFIX
from analysis.report.wording import counted, with_interval
from analysis.speed.break_even import break_even_words
from analysis.speed.input_tables import of_comparisons
from analysis.speed.tables import speed_cells

# What is claimed: by how much less time, from how many rays a triangle; and by
# how much more.
FASTER: Final = (0.10, 0.46)
PAYS_FROM: Final = 5
DEARER: Final = 1.10
DEARER_IN_A_BROWSER: Final = 56.5 / 41
ABOUT: Final = 1.15  # what still is “about 10 %”


def transformed_beforehand(evidence: Evidence) -> Finding:
    """That Baldwin and Weber's test is 10 to 46 % faster than Möller and
    Trumbore's, and pays from about five rays a triangle.
    """
    ratio = _ratio(evidence, BASE, KEPT)
    if ratio is None:
        return not_measured(f"{KEPT} beside {BASE}")
    faster = ratio.ratio.low >= 1 + FASTER[0]
    why = (
        f"{BASE} takes {ratio.figure} times as long as {KEPT} in {ratio.place}, many rays "
        f"to a triangle; claimed are {1 + FASTER[0]:.2f} to {1 + FASTER[1]:.2f}."
    )
    rows = _break_evens(evidence, ratio.scalar)
    words = []
    for row in rows.to_dict("records"):
        place = f"on {row['isa']} {_of_form(row['method'])}"
        words.append(
            f"{place} a call of {counted(round(row['worst_n']), 'ray')} takes "
            f"{with_interval(row['worst'], row['worst_low'], row['worst_high'])} times as "
            f"long, and the transformation {_pays(row)}"
        )
    if words:
        why += f" With the set-up, {'; '.join(words)}."
    own = rows[(rows["isa"] == ratio.isa) & (rows["method"] == KEPT)]
    early = bool(len(own)) and bool((own["break_even_high"] <= 2 * PAYS_FROM).all())
    may_be = bool(len(own)) and bool((own["break_even_low"] < 2 * PAYS_FROM).all())
    if may_be and not early:
        why += (
            " The numbers of rays that were timed do not tell whether it pays from "
            f"twice {PAYS_FROM} or fewer."
        )
    pays = [_pays(row) for row in own.to_dict("records")]
    return Finding(
        judged(faster and early, faster or may_be),
        "; ".join([f"{ratio.figure} times as fast", *pays[:1]]),
        why,
    )


def watertight_costs(evidence: Evidence) -> Finding:
    """That the watertight test costs about 10 % over a precomputed one."""
    ratio = _ratio(evidence, WATERTIGHT, KEPT)
    if ratio is None:
        return not_measured(f"{WATERTIGHT} beside {KEPT}")
    why = (
        f"{WATERTIGHT} over {KEPT} in {ratio.place}, many rays to a triangle; claimed are "
        f"{DEARER:.2f} and, in a browser, {DEARER_IN_A_BROWSER:.2f}. A whole renderer "
        "spends time elsewhere too, which makes the share of either test smaller."
    )
    plain = _ratio(evidence, WATERTIGHT, BASE)
    if plain:
        why += f" Over {BASE} it is {plain.figure}."
    return Finding(
        judged(ratio.ratio.high <= ABOUT, ratio.ratio.high <= DEARER_IN_A_BROWSER),
        f"{ratio.figure} times as long",
        why,
    )


def _ratio(evidence: Evidence, top: str, bottom: str) -> TimeRatio | None:
    speed = evidence.run.rays.speed
    return time_ratio(speed, _cells(evidence), top, bottom, loop=MAIN_LOOP)


def _break_evens(evidence: Evidence, scalar: str) -> pd.DataFrame:
    rays = evidence.run.rays
    table = kept_break_evens(rays, speed_cells(rays.speed))
    return table[table["scalar"] == scalar]


def _cells(evidence: Evidence) -> pd.DataFrame:
    return of_comparisons(without_tuv(speed_cells(evidence.run.rays.speed)))


def _pays(row: pd.Series) -> str:
    """pays from 1 234 (1 100 to 1 400) rays, or why no number can be given."""
    words = break_even_words(row)
    phrases = {
        "never": "never pays",
        "always": "always pays",
        "not shown": "is not shown to pay at any number of rays",
    }
    return phrases.get(words, f"pays from {words} rays")


def _of_form(method: str) -> str:
    fused = method.endswith(FMA_SUFFIX)
    return "with multiply-add" if fused else "without multiply-add"
