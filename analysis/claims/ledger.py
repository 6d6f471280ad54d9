"""The ledger: the words of every claim joined with what its test found."""

from __future__ import annotations

import tomllib
from functools import cache
from pathlib import Path
from typing import Any, Final

import pandas as pd

from analysis.claims import formulas, in_space, rightness, speeds
from analysis.claims.evidence import FAILS, HOLDS, PARTLY, UNTESTED, Evidence, Test
from analysis.report.columns import sentence
from analysis.report.exhibits import Column, Exhibits
from analysis.report.wording import counted, listed

WORDS: Final = Path(__file__).resolve().parents[2] / "report" / "claims.toml"

# By the number that the claim has in report/claims.toml.
TESTS: Final[dict[int, Test]] = {
    1: speeds.operations(1),
    2: speeds.operations(2),
    3: speeds.operations(3),
    4: speeds.hoisting,
    5: formulas.same_weights,
    6: speeds.inverse,
    7: speeds.each_step_widens,
    8: formulas.example_of_percents,
    9: rightness.collinear_vertices,
    10: formulas.projection_alone,
    11: speeds.published_program,
    12: formulas.within_zero_and_one,
    13: formulas.first_component_zero,
    14: formulas.gradient,
    15: formulas.closed_or_positive,
    16: rightness.normal_equations,
    17: in_space.transformed_beforehand,
    18: in_space.watertight_costs,
    19: speeds.adaptive_costs_little,
    20: rightness.double_double_range,
    21: rightness.epsilon_makes_robust,
    22: rightness.promotion_is_exact,
    23: speeds.early_way_out,
}
VERDICTS: Final = (HOLDS, PARTLY, FAILS, UNTESTED)
COLUMNS: Final = (
    Column("no.", lambda row: str(row["number"]), sort="number"),
    sentence("claim", "claim"),
    sentence("source", "source"),
    sentence("tested", "how it is tested"),
    sentence("figure", "found here"),
    Column("verdict", lambda row: str(row["verdict"]), numeric=False),
    sentence("why", "why"),
)


@cache
def words() -> list[dict[str, Any]]:
    """The entries of report/claims.toml, in their order: number, source, claim,
    tested.
    """
    entries = tomllib.loads(WORDS.read_text(encoding="utf-8"))["claim"]
    return [dict(entry) for entry in entries]


def ledger(evidence: Evidence) -> pd.DataFrame:
    """One row a claim: its words, `figure`, `verdict` (one of VERDICTS), `why`."""
    rows = []
    for entry in words():
        found = TESTS[entry["number"]](evidence)
        rows.append(
            {
                **entry,
                "figure": found.figure,
                "verdict": found.verdict,
                "why": found.why,
            }
        )
    return pd.DataFrame(
        rows,
        columns=["number", "claim", "source", "tested", "figure", "verdict", "why"],
    )


def add_ledger(exhibits: Exhibits, table: pd.DataFrame) -> None:
    exhibits.table(
        "ledger",
        "Published claims, each with what this run says of it. Intervals are those of "
        "95 %, but behind the number from which on something pays stand the timed "
        "numbers that it lies between. Every verdict is computed.",
        table,
        COLUMNS,
    )


def counted_verdicts(table: pd.DataFrame) -> str:
    """7 hold, 12 hold with a condition and 3 do not hold."""
    phrases = {
        HOLDS: ("holds", "hold"),
        PARTLY: ("holds with a condition", "hold with a condition"),
        FAILS: ("does not hold", "do not hold"),
        UNTESTED: ("cannot be tested here", "cannot be tested here"),
    }
    sums = table["verdict"].value_counts()
    return listed(
        [
            counted(int(sums[verdict]), *phrases[verdict])
            for verdict in VERDICTS
            if verdict in sums
        ]
    )
