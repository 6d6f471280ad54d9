"""Calls that take longer than one of more points.

Where points do not fill a vector they are copied first, and that may cost more
than the points it spares. Of other such calls the times do not tell why.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np
import numpy.typing as npt
import pandas as pd

from analysis.report.columns import number, whole, with_interval, word
from analysis.report.exhibits import Exhibits
from analysis.report.wording import counted, listed, nanoseconds
from analysis.report.wording import with_interval as ratio_words
from analysis.speed.break_even import WHOLE_VECTOR
from analysis.speed.input_tables import by_size
from analysis.speed.tables import samples, widest_isa
from analysis.trust.stats import CONFIDENCE, Interval, ratio_interval

KEY: Final = "longer_calls"
MOST_ROWS: Final = 30
_LONGER: Final = ("longer", "longer_low", "longer_high")
COLUMNS: Final = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    whole("n", "points"),
    number("call_ns", "ns/call"),
    whole("more_n", "more points"),
    number("more_ns", "ns/call of these"),
    with_interval("longer", "× theirs", "interval of all larger numbers at once"),
)


def longer_calls(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """One row a method, scalar and n of the sweep over n whose call surely takes
    longer than one of more points, at the widest ISA of the scalar, the largest n
    first: against that larger number (`more_n`) against which it is surest.

    Which one that is the same noise decides as the interval of the ratio (`longer`);
    so that is as wide as one that holds for all larger numbers at once (Bonferroni).
    """
    rows = by_size(cells)
    by_cell = samples(speed)
    found: list[dict[str, Any]] = []
    for (shard, scalar), group in rows.groupby(["shard", "scalar"], sort=False):
        isa = widest_isa(group)
        for method, own in group[group["isa"] == isa].groupby("method", sort=False):
            calls = own.sort_values("n").to_dict("records")
            times = [call["n"] * by_cell[shard, call["name"]] for call in calls]
            for index, call in enumerate(calls[:-1]):
                longer = _surest(times[index], times[index + 1 :])
                if longer is None:
                    continue
                more = calls[index + 1 + longer[0]]
                found.append(
                    {
                        "method": method,
                        "scalar": scalar,
                        "isa": isa,
                        "n": call["n"],
                        "call_ns": call["ns"] * call["n"],
                        "more_n": more["n"],
                        "more_ns": more["ns"] * more["n"],
                        **dict(zip(_LONGER, longer[1])),
                    }
                )
    columns = ["method", "scalar", "isa", "n", "call_ns", "more_n", "more_ns"]
    table = pd.DataFrame(found, columns=[*columns, *_LONGER])
    return table.sort_values("n", ascending=False, kind="stable", ignore_index=True)


def _surest(
    call: npt.NDArray[np.float64], others: list[npt.NDArray[np.float64]]
) -> tuple[int, Interval] | None:
    """Which of the others the call surely takes longer than, and how many times as
    long; of several the one whose interval begins highest.
    """
    joint = 1 - (1 - CONFIDENCE) / len(others)
    ratios = [ratio_interval(call, other, joint) for other in others]
    best = max(range(len(ratios)), key=lambda at: ratios[at].low)
    return (best, ratios[best]) if ratios[best].low > 1 else None


def add_longer_calls(exhibits: Exhibits, table: pd.DataFrame) -> None:
    if len(table):
        exhibits.table(
            KEY,
            "Calls that surely take longer than one of more points, every method at "
            "the widest instruction set, set-up included, each against the larger "
            "number of points against which it is surest.",
            table,
            COLUMNS,
            most_rows=MOST_ROWS,
        )


def longer_words(table: pd.DataFrame) -> str:
    """How many there are, and those among them that fill a vector, in sentences;
    empty where there are none.
    """
    if not len(table):
        return ""
    one = len(table) == 1
    words = (
        f"At the widest instruction set {counted(len(table), 'timed number')} of points "
        f"surely {'takes' if one else 'take'} longer than a larger one, counted for each "
        "method and scalar."
    )
    filled = table[table["n"] % WHOLE_VECTOR == 0]
    if not len(filled):
        return f"{words} None of them fills vectors of {WHOLE_VECTOR}."
    worst = filled.loc[
        filled.groupby(["method", "scalar"], sort=False)["longer"].idxmax()
    ]
    parts = [
        f"{row['method']} ({row['scalar']}, {row['isa']}), of which "
        f"{counted(int(row['n']), 'point')} take {nanoseconds(row['call_ns'])} and "
        f"{int(row['more_n'])} take {nanoseconds(row['more_ns'])}, "
        f"a ratio of {ratio_words(row['longer'], row['longer_low'], row['longer_high'])}"
        for row in worst.to_dict("records")
    ]
    return (
        f"{words} Of these {len(filled)} {'fills' if len(filled) == 1 else 'fill'} "
        f"vectors of {WHOLE_VECTOR}: {listed(parts)}. "
        "Copying does not explain that, and why they take so long these times do not "
        "tell."
    )
