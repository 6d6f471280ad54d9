"""The findings that a report begins with, as phrases: what the abstract's words
of rank hang on is decided here, from the tables of the run.
"""

from __future__ import annotations

from typing import Any

import pandas as pd

from analysis.charts import palette
from analysis.report.report import MAIN_LOOP, Report
from analysis.report.verdicts import WHOLE
from analysis.report.wording import between, times
from analysis.speed.tables import reference_cells


def findings(report: Report) -> dict[str, Any]:
    """`sets`: what the widest instruction set gives; `formulas`: how far apart
    the methods are on it; `trained`: what the same input again and again does.
    Each is None where the run does not tell.
    """
    sets, formulas = _sets(report), _formulas(report)
    return {
        "sets": sets and sets["words"],
        "formulas": formulas and formulas["words"],
        "sets_weigh_more": bool(
            sets and formulas and sets["median"] > formulas["ratio"]
        ),
        "trained": _trained(report),
    }


def _sets(report: Report) -> dict[str, Any] | None:
    rows = reference_cells(report.cells, report.scalar, MAIN_LOOP)
    rows = rows[(rows["isa"] == report.isa) & rows["times_scalar"].notna()]
    if not len(rows) or report.isa == "scalar":
        return None
    least = rows.loc[rows["times_scalar"].idxmin()]
    most = rows.loc[rows["times_scalar"].idxmax()]
    words = {"isa": report.isa, "methods": len(rows)}
    for name, row in (("least", least), ("most", most)):
        words[name] = times(row["times_scalar"])
        words[f"{name}_interval"] = between(
            row["times_scalar_low"], row["times_scalar_high"]
        )
        words[f"{name}_method"] = row["method"]
    return {"words": words, "median": float(rows["times_scalar"].median())}


def _formulas(report: Report) -> dict[str, Any] | None:
    rows = report.verdicts
    if not len(rows):
        return None
    whole = rows[rows["accepts"].fillna(WHOLE) == WHOLE]
    if len(whole) < 2:
        return None
    slowest = whole.loc[whole["time_over_best"].idxmax()]
    words = {
        "method": slowest["method"],
        "ratio": times(slowest["time_over_best"]),
        "interval": between(
            slowest["time_over_best_low"], slowest["time_over_best_high"]
        ),
    }
    return {"words": words, "ratio": float(slowest["time_over_best"])}


def _trained(report: Report) -> dict[str, str] | None:
    """The kernel that gains most by input it has seen before; None where the
    interval of none lies above 1.
    """
    exhibit = report.exhibits.get(f"fixed-{report.scalar}")
    if exhibit is None:
        return None
    rows = exhibit.csv[~exhibit.csv["isa"].map(palette.is_autovec).astype(bool)]
    surely: pd.DataFrame = rows[rows["fresh_over_fixed_low"] > 1]
    if not len(surely):
        return None
    row = surely.loc[surely["fresh_over_fixed"].idxmax()]
    return {
        "method": row["method"],
        "isa": row["isa"],
        "ratio": times(row["fresh_over_fixed"]),
        "interval": between(row["fresh_over_fixed_low"], row["fresh_over_fixed_high"]),
    }
