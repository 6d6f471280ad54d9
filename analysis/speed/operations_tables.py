"""What a point costs: operations counted, instructions executed, and what was
claimed of both.
"""

from __future__ import annotations

import dataclasses
from typing import Any, Final

import pandas as pd

from analysis.charts.palette import isa_rank, method_rank
from analysis.read.load_operations import KINDS
from analysis.report.wording import counted, listed

# What the table shows; the rest is in its CSV.
SHOWN: Final = KINDS[: KINDS.index("compare") + 1]
_WORDS: Final = {
    "add": "addition",
    "multiply": "multiplication",
    "multiply_add": "multiply-add",
    "compare": "comparison",
}


@dataclasses.dataclass(frozen=True)
class Claim:
    """What was published of a method's cost a point."""

    number: int
    source: str
    text: str
    method: str
    counts: dict[str, int]
    # Operations besides, that what the claim is about does not need; negative
    # where it counts some that need not be done.
    allowed: dict[str, int] = dataclasses.field(default_factory=dict)
    remark: str = ""  # on the difference, where there is one


CLAIMS: Final = [
    Claim(
        1,
        "qTriangle 2018",
        "the cross-product test costs 9 subtractions, 6 multiplications and "
        "3 comparisons a point",
        "cross_product_det",
        {"add": 9, "multiply": 6, "compare": 3},
    ),
    Claim(
        2,
        "qTriangle 2019",
        "it costs 6 subtractions, 6 multiplications and 3 comparisons",
        "cross_product",
        {"add": 6, "multiply": 6, "compare": 3},
        allowed={"add": 1, "multiply_add": 1},
        remark="The addition and the multiply-add keep a point at infinity outside, "
        "which the claim does not ask for. The code printed beside the claim "
        "subtracts the products, and so costs what the text of 2018 says.",
    ),
    Claim(
        3,
        "qTriangle 2019",
        "the inverse-matrix test costs 6 additions, 9 multiplications and "
        "3 comparisons",
        "barycentric_inverse",
        {"add": 6, "multiply": 9, "compare": 3},
        allowed={"multiply": -3},
        remark="The third column of the matrix is multiplied by 1, which as a "
        "product written out counts, and which no code need compute.",
    ),
]


def cost_table(
    operations: pd.DataFrame,
    instructions: pd.DataFrame,
    scalar: str,
    loop: str = "one_triangle",
) -> pd.DataFrame:
    """One row a method: `call_add` … and `item_add` … of every kind, and
    `instructions` an item on `isa`, the widest that was traced (NaN where the
    method was not).
    """
    rows = operations[(operations["scalar"] == scalar) & (operations["loop"] == loop)]
    sides = [
        rows[rows["per"] == per]
        .set_index("method")[KINDS]
        .add_prefix(f"{per}_")
        .astype(float)
        for per in ("call", "item")
    ]
    table = pd.concat(sides, axis=1).rename_axis("method").reset_index()
    isa = traced_isa(instructions, scalar, loop)
    traced = instructions[
        (instructions["scalar"] == scalar)
        & (instructions["loop"] == loop)
        & (instructions["isa"] == isa)
    ].set_index("method")
    per_item = traced["per_item"].astype(float).reindex(table["method"])
    return (
        table.assign(isa=isa, instructions=per_item.to_numpy())
        .sort_values("method", key=lambda keys: keys.map(method_rank))
        .reset_index(drop=True)
    )


def traced_isa(
    instructions: pd.DataFrame, scalar: str, loop: str = "one_triangle"
) -> str | None:
    """The widest ISA whose kernels were traced."""
    rows = instructions[
        (instructions["scalar"] == scalar) & (instructions["loop"] == loop)
    ]
    return str(max(rows["isa"], key=isa_rank)) if len(rows) else None


def ledger(operations: pd.DataFrame) -> list[dict[str, Any]]:
    """The claims with what was counted and the verdict, those whose method was
    counted."""
    points = operations[
        (operations["loop"] == "one_triangle")
        & (operations["scalar"] == "f32")
        & (operations["per"] == "item")
    ].set_index("method")
    found = []
    for claim in CLAIMS:
        if claim.method not in points.index:
            continue
        counts = claimable(points.loc[claim.method])
        verdict = judge(claim, counts)
        found.append(
            {
                "number": claim.number,
                "source": claim.source,
                "text": claim.text,
                "method": claim.method,
                "counted": in_words(counts),
                "verdict": verdict,
                "remark": claim.remark if verdict != "holds" else "",
            }
        )
    return found


def claimable(row: pd.Series) -> dict[str, int]:
    """The counts in the words of the claims, which know no minimum: that of two
    numbers, compared once, takes the place of comparing both.
    """
    counts = {kind: int(row[kind]) for kind in SHOWN}
    counts["compare"] += counts.pop("min_max")
    return counts


def judge(claim: Claim, counts: dict[str, int]) -> str:
    """ "holds" where just that was counted, "holds with a condition" where it was
    but for what is allowed besides, else "does not hold".
    """
    more = {kind: count - claim.counts.get(kind, 0) for kind, count in counts.items()}
    if not any(more.values()):
        return "holds"
    if all(extra == claim.allowed.get(kind, 0) for kind, extra in more.items()):
        return "holds with a condition"
    return "does not hold"


def in_words(counts: dict[str, int]) -> str:
    return listed(
        [
            counted(count, _WORDS.get(kind, kind))
            for kind, count in counts.items()
            if count
        ]
    )
