"""How points are laid out in memory: x and y in arrays of their own, or side by
side in one, as most programs hold them.
"""

from __future__ import annotations

from typing import Final

import pandas as pd

from analysis.read.cells import SIDE_BY_SIDE, WHOLE_ARRAYS
from analysis.report.columns import PLACE, number, with_interval
from analysis.report.exhibits import Exhibits
from analysis.report.wording import counted, size_in_bytes
from analysis.speed.tables import sort_cells, times_other

COLUMNS: Final = (
    *PLACE[1:],
    number("working_set_bytes", "bytes a call"),
    number("ns", "ns/point, side by side"),
    with_interval("side_by_side", "× separate arrays"),
)
KEY: Final = "layouts"


def layouts(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """The cells of points with x and y side by side, with their time over that
    of the same method on separate arrays (`side_by_side`).
    """
    rows = cells[cells["loop"] == SIDE_BY_SIDE].reset_index(drop=True)
    table = times_other(
        speed,
        rows,
        "side_by_side",
        lambda cell: str(cell["name"]).replace(
            f"{SIDE_BY_SIDE}/", f"{WHOLE_ARRAYS}/", 1
        ),
    )
    return sort_cells(table, ["scene", "scalar", "isa", "method"])


def add_layouts(
    exhibits: Exhibits, speed: pd.DataFrame, cells: pd.DataFrame
) -> pd.DataFrame:
    """Adds the table, if the run has such cells; what it shows."""
    table = layouts(speed, cells)
    if len(table):
        exhibits.table(
            KEY,
            "Points with x and y side by side in one array: time over that of the "
            "same method with x and y in arrays of their own, same points, same run.",
            table,
            COLUMNS,
        )
    return table


def layout_sentence(table: pd.DataFrame, isa: str | None) -> str:
    """What the layout costs at an instruction set, by scalar and by where the points
    lie; empty where nothing was measured.
    """
    rows = table[table["isa"] == isa]
    if not len(rows):
        return ""
    parts = [
        f"in {scalar} {_by_length(own)}"
        for scalar, own in rows.groupby("scalar", sort=True)
    ]
    slower = int((rows["side_by_side_low"] > 1).sum())
    return (
        f"On {isa} it takes {', '.join(parts)}; {slower} of "
        f"{counted(len(rows), 'cell')} {'is' if slower == 1 else 'are'} slower for "
        "certain."
    )


def _by_length(rows: pd.DataFrame) -> str:
    """Of one scalar: the least and the largest ratio of any method on the scene
    whose calls have the fewest bytes, and on that of the most.
    """
    sizes = rows.groupby("scene", sort=False)["working_set_bytes"].max()
    parts = []
    for scene in dict.fromkeys([sizes.idxmin(), sizes.idxmax()]):
        ratios = rows.loc[rows["scene"] == scene, "side_by_side"]
        low, high = f"{ratios.min():.2f}", f"{ratios.max():.2f}"
        span = low if low == high else f"{low} to {high}"
        parts.append(f"{span} times as long on calls of {size_in_bytes(sizes[scene])}")
    return " and ".join(parts)
