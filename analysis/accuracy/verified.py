"""What `pitbench verify` found in runs of its own, longer than a sweep has time for:
report/verified/*.json, which fit harness/schema/verify.schema.json.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any, Final

import pandas as pd

from analysis.accuracy import failure_columns
from analysis.read.read_json import LoadError, read_json
from analysis.report.exhibits import Exhibits
from analysis.report.wording import counted, grouped, listed, rate_of_items, short_share
from analysis.speed.tables import sort_cells
from analysis.trust.stats import wilson

FOLDER: Final = Path(__file__).resolve().parents[2] / "report" / "verified"
SAME: Final = "of this run"
OTHERS: Final = "others"
_KEPT: Final = ("method", "scalar", "points", "boundary_points", "answers", "wrong")
COLUMNS: Final = [
    *_KEPT,
    *("error_rate", "error_rate_low", "error_rate_high"),
    *("isas", "loops", "kernels", "revision", "truth_per_second"),
]


def verified(kernel_hash: str, folder: Path = FOLDER) -> pd.DataFrame:
    """One row a file that is about points. `points` counts each once, however many
    kernels answered it, and the interval is that of the points, each wrong answer
    taken for a point of its own. `kernels`: whether they are those of a run with this
    hash. Raises LoadError, of a build with changes too: nobody could tell what was
    verified.
    """
    rows = []
    for path in sorted(folder.glob("*.json")):
        document = read_json(path, "verify")
        if document["of"] != "points":
            continue
        context = document["context"]
        if context["dirty"]:
            raise LoadError(
                f"{path}: is of a build with changes that were not committed; "
                "commit, build and verify again"
            )
        points = document["points"]
        rate = wilson(min(document["wrong"], points), points)
        rows.append(
            {
                **{key: document[key] for key in _KEPT},
                "error_rate": rate.value,
                "error_rate_low": rate.low,
                "error_rate_high": rate.high,
                "isas": listed(document["isas"]),
                "loops": listed(document["loops"]),
                "kernels": SAME if context["kernel_hash"] == kernel_hash else OTHERS,
                "revision": context["revision"],
                "truth_per_second": document["truth_points_per_second"],
            }
        )
    return sort_cells(pd.DataFrame(rows, columns=COLUMNS), ["scalar", "method"])


def add_verified(exhibits: Exhibits, table: pd.DataFrame) -> None:
    if len(table):
        exhibits.table(
            "verified",
            "Exact methods held against truth at length, apart from the sweep, on "
            "scenes of hard input, by pitbench verify: the answers of all the instruction "
            "sets and loops named. The bound is that of the points, each counted once.",
            table,
            failure_columns.VERIFIED,
        )


def verified_words(table: pd.DataFrame) -> dict[str, Any] | None:
    """What a sentence says of it; None if nothing was verified. Of several methods in
    one scalar the fewest points and the largest bound.
    """
    if not len(table):
        return None
    of_scalar = table.groupby("scalar")
    highest = of_scalar["error_rate_high"].max()
    points = of_scalar["points"].min()
    wrong = int(table["wrong"].sum())
    same = table["kernels"] == SAME
    return {
        "methods": listed(list(dict.fromkeys(table["method"]))),
        "points": listed([f"{grouped(int(n))} ({s})" for s, n in points.items()]),
        "answers": counted(int(table["answers"].sum()), "answer"),
        "wrong": wrong,
        "wrong_words": grouped(wrong),
        "at_most": listed([f"{short_share(v)} ({s})" for s, v in highest.items()]),
        "kernels": "the kernels of this run"
        if same.all()
        else "kernels that are not all those of this run"
        if same.any()
        else "other kernels than those of this run",
        "truth": rate_of_items(float(table["truth_per_second"].median())),
    }
