"""Who lets rays out of a closed surface: leaks, double hits, and what
contraction has to do with them. Pure functions from frames to frames.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Final

import pandas as pd

from analysis.accuracy.overview import beyond_rule
from analysis.read.maps import RayCase
from analysis.report.method_families import FMA_SUFFIX, in_order, leaves_early
from analysis.speed.input_tables import CULLED
from analysis.trust.stats import wilson

SPHERE: Final = "rays_icosphere"
KINDS: Final = ("hole", "double_hit")
# The square of two triangles on whose diagonal a ray was reported to miss both
# once the compiler had contracted products and sums: how its ids begin.
CONTRACTED: Final = "oblikovati_2146"


def sphere_rates(accuracy: pd.DataFrame, scalar: str, isa: str) -> pd.DataFrame:
    """One row a method: the share of rays from inside the sphere that no triangle
    claims (`hole`) and that several do beyond what the boundary rule brings
    about (`double_hit`), each with its interval, its `_count` and of how many.
    """
    rows = accuracy[
        (accuracy["family"] == SPHERE)
        & (accuracy["scalar"] == scalar)
        & (accuracy["isa"] == isa)
    ].dropna(subset=["hole"])
    found: list[dict[str, Any]] = []
    judged = beyond_rule(rows) if len(rows) else rows
    for method in in_order(judged["method"]):
        own = judged[judged["method"] == method]
        row: dict[str, Any] = {"method": method}
        for kind in KINDS:
            count = int(own[kind].astype(float).sum())
            of = int(own[f"{kind}_of"].astype(float).sum())
            share = wilson(count, of)
            row |= {
                kind: share.value,
                f"{kind}_low": share.low,
                f"{kind}_high": share.high,
                f"{kind}_count": count,
                f"{kind}_of": of,
            }
        found.append(row)
    columns = ["method"]
    for kind in KINDS:
        columns += [kind, *(f"{kind}_{end}" for end in ("low", "high", "count", "of"))]
    return pd.DataFrame(found, columns=columns)


def own_arithmetic(method: str) -> bool:
    """Whether the method computes otherwise than one without its ending."""
    return CULLED not in method and not leaves_early(method.removesuffix(FMA_SUFFIX))


def contraction(cases: Sequence[RayCase]) -> pd.DataFrame:
    """One row a scalar × method of its own that has a form with multiply-add: how many of
    the triangles of CONTRACTED (`of`) it says are hit without (`plain`) and with
    it (`fused`).
    """
    found: list[dict[str, Any]] = []
    for scalar in dict.fromkeys(case.scalar for case in cases):
        own = [
            dict(case.answers)
            for case in cases
            if case.scalar == scalar and case.id.startswith(CONTRACTED)
        ]
        if not own:
            continue
        for method in in_order(own[0]):
            fused = method + FMA_SUFFIX
            if not own_arithmetic(method):
                continue
            if any({method, fused} - set(answers) for answers in own):
                continue
            found.append(
                {
                    "scalar": scalar,
                    "method": method,
                    "of": len(own),
                    "plain": sum(answers[method] for answers in own),
                    "fused": sum(answers[fused] for answers in own),
                }
            )
    return pd.DataFrame(found, columns=["scalar", "method", "of", "plain", "fused"])


def cases_table(cases: Sequence[RayCase]) -> pd.DataFrame:
    """One row a published case: the exact answer, who hits and who misses."""
    found = []
    for case in cases:
        answers = dict(case.answers)
        hits = [method for method in in_order(answers) if answers[method]]
        misses = [method for method in in_order(answers) if not answers[method]]
        found.append(
            {
                "id": case.id,
                "scalar": case.scalar,
                "source": case.source,
                "truth": case.truth,
                "hits": len(hits),
                "of": len(answers),
                "hit_by": hits,
                "missed_by": misses,
            }
        )
    columns = ["id", "scalar", "source", "truth", "hits", "of", "hit_by", "missed_by"]
    return pd.DataFrame(found, columns=columns)
