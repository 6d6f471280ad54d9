"""From how many points on a method's set-up pays.

Every call sets its method up once, on another triangle than the call before, so
the time of a call is set-up and points together, and of two methods the one
that does more beforehand must win that back. Where their times are equal lies
between two of the numbers of points that were timed. The time of a call is taken
to run straight from the one to the other. That is a guess, since both methods'
times jump where a call comes to fill a vector or goes round the loop once more:
so the interval reaches to the timed numbers themselves. What it cannot hold is a
stretch that no timed number lies in: where both ends of it are won already,
nothing shows that the middle is not.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.report.wording import grouped
from analysis.speed.input_tables import by_size
from analysis.speed.tables import samples, sort_cells
from analysis.trust.stats import ratio_interval

INVERSE, CROSS = "barycentric_inverse", "cross_product"
UNHOISTED = "cross_product_unhoisted"
# Compared besides what is cheapest to set up: what published texts claim.
CLAIMED = ((INVERSE, CROSS), (CROSS, UNHOISTED))

# Fewer points than the widest vector has lanes would be a tail, which costs
# more than most set-ups.
WHOLE_VECTOR = 16

RATIO = ["ratio", "ratio_low", "ratio_high"]


def paid_from(
    n: Sequence[float], ratios: Sequence[float], others: Sequence[float], best: int
) -> float:
    """The n from which on the ratio is 1 or less without a break up to the n
    with the index `best`; NaN if it is above 1 there.

    `n` ascending and positive, `ratios` of the times of two methods' calls, and
    `others`, the times of those that they are over; of the same length. Found
    backwards, since for a few points two methods may be as good as equal.
    """
    first = _first_paid(ratios, best)
    if first is None:
        return math.nan
    if first == 0:
        return n[0]
    before, after = n[first - 1], n[first]
    lost = (ratios[first - 1] - 1) * others[first - 1]
    won = (1 - ratios[first]) * others[first]
    return float(before + (after - before) * lost / (lost + won))


def paid_between(
    n: Sequence[float], lows: Sequence[float], highs: Sequence[float], best: int
) -> tuple[float, float]:
    """The timed n between which paid_from lies, by the `lows` and the `highs` of
    the intervals of the ratios: the last at which the call surely takes longer (the
    first of all where there is none), and that from which on it surely does not.
    NaN for what is not before `best`.

    A call that does not fill its vectors says nothing about one that does, so it
    does not end the interval; but all calls of less than WHOLE_VECTOR are alike,
    and that number, where it was timed, speaks for what follows.
    """
    first_low, first_high = _first_paid(lows, best), _first_paid(highs, best)
    low = math.nan if first_low is None else n[max(first_low - 1, 0)]
    if first_high is None:
        return low, math.nan
    won = n[first_high : best + 1]
    whole = next((at for at in won if at % WHOLE_VECTOR == 0), won[-1])
    alike = won[0] < WHOLE_VECTOR == whole
    return low, won[0] if alike else whole


def _first_paid(ratios: Sequence[float], best: int) -> int | None:
    if ratios[best] > 1:
        return None
    first = best
    while first > 0 and ratios[first - 1] <= 1:
        first -= 1
    return first


def ratios_by_size(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The sweep over n with the time of each call over that of the method that
    takes least for WHOLE_VECTOR points (`cheapest`), which has the ratio 1.
    """
    rows = by_size(cells)
    by_cell = samples(speed)
    found = []
    for _, group in rows.groupby(["shard", "scalar", "isa"], sort=False):
        cheapest = _cheapest(group)
        bases = group[group["method"] == cheapest].set_index("n")["name"]
        for _, row in group.iterrows():
            base = bases.get(row["n"])
            own: dict[str, Any] = {**row.to_dict(), "cheapest": cheapest}
            own |= _ratio(by_cell, row["shard"], row["name"], base)
            found.append(own)
    columns = [*rows.columns, "cheapest", *RATIO]
    return pd.DataFrame(found, columns=columns)


def break_evens(
    speed: pd.DataFrame,
    cells: pd.DataFrame,
    claimed_pairs: Sequence[tuple[str, str]] = CLAIMED,
) -> pd.DataFrame:
    """One row a method × scalar × ISA against what is cheapest to set up, and
    one for each of `claimed_pairs`. Of rays as of points.

    best: the ratio where the method is most surely the better one, for
    WHOLE_VECTOR points or more, at best_n.
    worst: the largest ratio for no more points than that, at worst_n; most: the
    ratio for the most points.
    break_even: the n from which on, up to best_n, the call takes less. low and
    high: paid_between, the timed n that it lies between. NaN for never.
    """
    rows = by_size(cells)
    by_cell = samples(speed)
    found = []
    for (shard, scalar, isa), group in rows.groupby(
        ["shard", "scalar", "isa"], sort=False
    ):
        cheapest = _cheapest(group)
        methods = list(dict.fromkeys(group["method"]))
        pairs = [(method, cheapest) for method in methods if method != cheapest]
        pairs += [
            pair
            for pair in claimed_pairs
            if set(pair) <= set(methods) and pair not in pairs
        ]
        names = {m: part.set_index("n")["name"] for m, part in group.groupby("method")}
        times = {m: part.set_index("n")["ns"] for m, part in group.groupby("method")}
        for method, other in pairs:
            at = sorted(set(names[method].index) & set(names[other].index))
            if not at:
                continue
            ratios = pd.DataFrame(
                [_ratio(by_cell, shard, names[method][n], names[other][n]) for n in at]
            )
            row = {"scalar": scalar, "isa": isa, "method": method, "against": other}
            # Where even the upper end is lowest: the same for all three, so
            # that they cannot but be in order.
            enough = [n >= min(WHOLE_VECTOR, at[-1]) for n in at]
            best = int(ratios["ratio_high"][enough].idxmin())
            value, lows, highs = (list(ratios[column]) for column in RATIO)
            calls = [n * times[other][n] for n in at]
            row["break_even"] = paid_from(at, value, calls, best)
            row["break_even_low"], row["break_even_high"] = paid_between(
                at, lows, highs, best
            )
            worst = int(ratios["ratio"][: best + 1].idxmax())
            for name, index in (("worst", worst), ("best", best), ("most", -1)):
                for column in RATIO:
                    key = column.replace("ratio", name)
                    row[key] = float(ratios[column].iloc[index])
                row[f"{name}_n"] = at[index]
            found.append(row)
    ends = ["break_even", "break_even_low", "break_even_high"]
    for name in ("worst", "best", "most"):
        ends += [name, f"{name}_low", f"{name}_high", f"{name}_n"]
    columns = ["scalar", "isa", "method", "against", *ends]
    return sort_cells(
        pd.DataFrame(found, columns=columns), ["scalar", "isa", "method", "against"]
    )


def claimed(
    speed: pd.DataFrame, cells: pd.DataFrame, method: str, other: str
) -> pd.DataFrame:
    """The ratios of the two at every n, scalar and ISA that has both."""
    rows = by_size(cells)
    by_cell = samples(speed)
    keys = ["shard", "scalar", "isa", "n"]
    found = []
    for key, group in rows.groupby(keys, sort=False):
        names = group.set_index("method")["name"]
        if {method, other} <= set(names.index):
            ratio = _ratio(by_cell, group["shard"].iloc[0], names[method], names[other])
            own = group[group["method"] == method].iloc[0]
            size = {"working_set_bytes": own["working_set_bytes"]}
            found.append({**dict(zip(keys, key)), **size, **ratio})
    return pd.DataFrame(found, columns=[*keys, "working_set_bytes", *RATIO])


def _cheapest(group: pd.DataFrame) -> str:
    """What takes least for WHOLE_VECTOR points or the next larger number."""
    enough = group[group["n"] >= min(WHOLE_VECTOR, group["n"].max())]
    smallest = enough[enough["n"] == enough["n"].min()]
    return str(smallest.loc[smallest["ns"].idxmin(), "method"])


def _ratio(
    by_cell: dict[tuple[str, str], npt.NDArray[np.float64]],
    shard: str,
    name: str,
    base: str | None,
) -> dict[str, float]:
    if base is None:
        return dict(zip(RATIO, (math.nan,) * 3))
    if name == base:
        return dict(zip(RATIO, (1.0,) * 3))
    return dict(zip(RATIO, ratio_interval(by_cell[shard, name], by_cell[shard, base])))


def break_even_words(row: pd.Series) -> str:
    """1 234 (1 024 to 2 048): the points of a call, and the timed numbers of them
    that it lies between.
    """
    if row["break_even_high"] != row["break_even_high"]:
        if row["break_even_low"] != row["break_even_low"]:
            return "never"
        return "not shown"
    if row["break_even_high"] == row["break_even_low"]:
        return "always"
    low, high = _whole(row["break_even_low"]), _whole(row["break_even_high"])
    return f"{_whole(row['break_even'])} ({low} to {high})"


def _whole(n: float) -> str:
    return grouped(round(n)) if n == n else ""
