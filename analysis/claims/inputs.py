"""What this run says of three claims about inputs, each verdict computed:
that hoisting the edges pays, that a matrix inverse pays for many points only,
and that an early way out saves time.
"""

from __future__ import annotations

import dataclasses

import pandas as pd

from analysis.claims.evidence import FAILS, HOLDS, PARTLY, UNTESTED
from analysis.read.run import Cache
from analysis.report.wording import between, counted, grouped, listed, times
from analysis.speed.break_even import (
    break_even_words,
    CROSS,
    INVERSE,
    UNHOISTED,
    break_evens,
    claimed,
)
from analysis.speed.input_tables import along_hit_rates, data_caches


@dataclasses.dataclass(frozen=True)
class Claim:
    source: str
    claim: str
    verdict: str
    why: str
    figure: str = "–"  # what the verdict rests on, in short


def claims(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    early: pd.DataFrame,
    caches: tuple[Cache, ...],
) -> list[Claim]:
    """`early`: input_tables.early_out."""
    return [
        hoisting(claimed(speed, cells, UNHOISTED, CROSS), caches),
        inverse(break_evens(speed, cells)),
        early_way_out(early),
    ]


def hoisting(table: pd.DataFrame, caches: tuple[Cache, ...]) -> Claim:
    """`table`: the time without hoisting over that with it, at every n."""
    claim = "Hoisting the edge vectors out of the loop pays"
    nearest = data_caches(caches)[0][1] if data_caches(caches) else 0
    table = table[table["working_set_bytes"] <= nearest]
    if not len(table):
        return Claim("qTriangle", claim, UNTESTED, "No such cell was timed.")
    rows = table.loc[table.groupby(["scalar", "isa"], sort=False)["n"].idxmax()]
    pays = rows["ratio_low"] > 1
    words = [f"{_ratio(row)} on {row['isa']} ({row['scalar']})" for row in _rows(rows)]
    why = (
        f"With the points in the nearest cache ({_numbers(rows['n'])} a call), "
        f"computing the edges anew for every point takes {listed(words)} times as "
        "long as cross_product, which has them from its set-up; the compiler is "
        "kept from hoisting by itself, as it otherwise would."
    )
    verdict = HOLDS if pays.all() else PARTLY if pays.any() else FAILS
    if verdict == PARTLY:
        gains = [f"{r['isa']} ({r['scalar']})" for r in _rows(rows[pays])]
        why += f" It pays on {listed(gains)}."
    return Claim("qTriangle", claim, verdict, why, listed(words))


def inverse(table: pd.DataFrame) -> Claim:
    """`table`: break_even.break_evens."""
    claim = "A matrix inverse per triangle is expensive, and pays for many points only"
    rows = table[(table["method"] == INVERSE) & (table["against"] == CROSS)]
    if not len(rows):
        return Claim("qTriangle", claim, UNTESTED, "No such cell was timed.")
    dear = rows["worst_low"] > 1
    pays = dear & rows["break_even_high"].notna()
    words = []
    for row in _rows(rows):
        start = (
            f"on {row['isa']} ({row['scalar']}) a call of {_points(row['worst_n'])} "
            f"takes {_times(row, 'worst')} as long as with {CROSS}, and "
        )
        if row["break_even_high"] != row["break_even_high"]:
            words.append(f"{start}it never takes less beyond doubt")
        else:
            words.append(f"{start}one of {break_even_words(row)} or more less")
    why = "; ".join(words)
    verdict = HOLDS if pays.all() else PARTLY if dear.any() else FAILS
    if verdict == PARTLY:
        gains = [f"{r['isa']} ({r['scalar']})" for r in _rows(rows[pays])]
        why += (
            f". Dear at first: {_share(dear)}; won back beyond doubt: "
            f"{listed(gains) if gains else 'nowhere'}"
        )
    evens = [
        f"{break_even_words(row)} on {row['isa']} ({row['scalar']})"
        for row in _rows(rows)
    ]
    return Claim(
        "qTriangle",
        claim,
        verdict,
        f"{why[:1].upper()}{why[1:]}.",
        f"pays from {listed(evens)} points",
    )


def early_way_out(early: pd.DataFrame) -> Claim:
    """`early`: input_tables.early_out."""
    claim = "An early way out saves time"
    fresh = early[early["sets"] == "fresh"]
    fresh = along_hit_rates(fresh)
    if not len(fresh):
        return Claim("common advice", claim, UNTESTED, "No such cell was timed.")
    parts = []
    for (scalar, isa), rows in fresh.groupby(["scalar", "isa"], sort=False):
        saves = rows[rows["over_plain_high"] < 1]
        costs = rows[rows["over_plain_low"] > 1]
        worst = rows.loc[rows["over_plain"].idxmax()]
        words = f"on {isa} ({scalar}) "
        if len(saves):
            best = rows.loc[rows["over_plain"].idxmin()]
            words += (
                f"it saves time with {_percents(saves['hit'])} of the points inside "
                f"({_times(best, 'over_plain')} the time at best), "
            )
        else:
            words += "it never saves time, "
        words += (
            f"costs some with {_percents(costs['hit'])} "
            f"({_times(worst, 'over_plain')} at worst)"
            if len(costs)
            else "and never costs any"
        )
        parts.append(words)
    saves_at = fresh["over_plain_high"] < 1
    verdict = HOLDS if saves_at.all() else PARTLY if saves_at.any() else FAILS
    best, worst = (
        fresh.loc[at]
        for at in (fresh["over_plain"].idxmin(), fresh["over_plain"].idxmax())
    )
    return Claim(
        "common advice",
        claim,
        verdict,
        "On fresh input, " + "; ".join(parts) + ".",
        f"{_times(best, 'over_plain')} to {_times(worst, 'over_plain')} the time",
    )


def _points(n: float) -> str:
    return counted(round(n), "point")


def _ratio(row: pd.Series) -> str:
    ends = between(row["ratio_low"], row["ratio_high"])
    return f"{times(row['ratio'])} ({ends})".replace("\u00a0×", "")


def _times(row: pd.Series, key: str) -> str:
    return f"{times(row[key])} ({between(row[f'{key}_low'], row[f'{key}_high'])})"


def _rows(table: pd.DataFrame) -> list[pd.Series]:
    return [row for _, row in table.iterrows()]


def _numbers(values: pd.Series) -> str:
    return listed([grouped(int(n)) for n in sorted(set(values))])


def _percents(values: pd.Series) -> str:
    return listed([f"{hit:g}" for hit in sorted(values)]) + " %"


def _share(mask: pd.Series) -> str:
    return f"{int(mask.sum())} of {counted(len(mask), 'case')}"
