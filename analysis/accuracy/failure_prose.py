"""The facts of the chapters on failures, as finished phrases."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any, Final

import pandas as pd

from analysis.accuracy.accuracy_tables import errors_along
from analysis.accuracy.cost_curve import worst_words
from analysis.accuracy.exact_tables import worst_ratios
from analysis.accuracy.failures import (
    CHANGES,
    counted_failures,
    plainest_examples,
    told_apart_nowhere,
)
from analysis.accuracy.flags_axis import MESH
from analysis.accuracy.hardness import hardness_of
from analysis.accuracy.overview import KEYS, failing_most, never_failing
from analysis.accuracy.verified import verified_words
from analysis.charts import palette, ramp
from analysis.report.method_families import in_order
from analysis.report.report import Report
from analysis.report.wording import (
    between,
    counted,
    grouped,
    listed,
    share,
    short_share,
    significant,
)
from analysis.speed.tables import widest_isa

# Right by their arithmetic for as long as no difference of coordinates rounds.
EXACT_BY_DIFFERENCES: Final = (
    "cross_product_kahan",
    "promoted_f64_kahan",
    "double_double",
)
METHODS_TEXT = Path(__file__).resolve().parents[2] / "report" / "methods.toml"


def failure_facts(report: Report) -> dict[str, Any]:
    """What the templates of these chapters may use."""
    return {
        "rate_colours": ramp.css(),
        "overview": overview_words(report),
        "flags": flags_words(report),
        "failures": failures(report),
        "examples_kept": bool(len(report.run.worst)),
        "exact": exact_words(report),
        "recipes": recipe_words(report),
        "mapped": [
            scalar for scalar in ("f32", "f64") if report.exhibits.get(f"ulps-{scalar}")
        ],
        "truths_apart": sum(c.binary != c.decimal for c in report.run.maps.two_truths),
        "truths": counted(len(report.run.maps.two_truths), "case"),
    }


def overview_words(report: Report) -> dict[str, Any] | None:
    """Which methods never fail, and which way of failing is the commonest."""
    table = report.overviews.get(report.scalar)
    if table is None or not len(table):
        return None
    clean = never_failing(table)
    whole = table[table["accepts"] == "triangle"]
    found = {key: failing_most(table, key) for key in KEYS}
    measured = {key: most for key, most in found.items() if most is not None}
    return {
        "methods": counted(len(whole), "method"),
        "clean": listed(clean),
        "clean_count": len(clean),
        "classes": counted(len(measured), "way", "ways"),
        "most": {
            key: {"method": method, "rate": share(rate), "none": rate == 0}
            for key, (method, rate) in measured.items()
        },
    }


def flags_words(report: Report) -> dict[str, Any] | None:
    """What multiply-add does to errors and to holes, over all methods."""
    table = report.flags
    table = table[(table["scalar"] == report.scalar) & (table["base"] != "–")]
    fused = table[table["warning"] == ""]
    if not len(table):
        return None
    torn = fused[(fused["base_hole_count"] == 0) & (fused["hole_count"] > 0)]
    warned = table[table["warning"] != ""]
    return {
        "scene": MESH,
        "pairs": counted(len(fused), "method"),
        "better": int((fused["error"] < fused["base_error"]).sum()),
        "worse": int((fused["error"] > fused["base_error"]).sum()),
        "torn": [
            {
                "method": row["base"],
                "holes": significant(1e6 * row["hole"]),
                "interval": between(1e6 * row["hole_low"], 1e6 * row["hole_high"]),
                "double_hits": significant(1e6 * row["double_hit"]),
                "double_hits_before": significant(1e6 * row["base_double_hit"]),
            }
            for row in torn.to_dict("records")
        ],
        "warned": [
            {"method": row["method"], "warning": row["warning"]}
            for row in warned.to_dict("records")
        ],
    }


def failures(report: Report) -> list[dict[str, Any]]:
    """Each method's failure in words, and an example or a count of this run."""
    texts = tomllib.loads(METHODS_TEXT.read_text(encoding="utf-8"))
    accuracy = report.run.accuracy
    rules = dict(zip(accuracy["method"], accuracy["boundary_rule"]))
    examples = plainest_examples(report.run.worst, rules)
    counts = counted_failures(accuracy)
    alike = told_apart_nowhere(accuracy)
    warnings = {entry.key: entry.warning for entry in report.run.methods}
    found = []
    for method in in_order(accuracy["method"]):
        example = examples.get(method)
        found.append(
            {
                "key": method,
                "colour": palette.method_style(method).colour,
                "fails": texts.get(method, {}).get("fails", ""),
                "warning": warnings.get(method, ""),
                "example": example,
                "distance": _distance(example.distance_ulps) if example else "",
                "answers": _answers(accuracy, method),
                "failing": failing_words(counts[method]),
                "alike": _alike_words(*alike[method]) if method in alike else None,
            }
        )
    return found


def failing_words(counts: dict[str, int]) -> str:
    """What of a method's answers was wrong and how; empty if nothing was."""
    inside, outside = counts["false_inside"], counts["false_outside"]
    changed = sum(counts[kind] for kind in CHANGES)
    holes, doubled = counts["hole"], counts["double_hit"]
    accepted = counts["not_finite_accepted"]
    parts = [
        (
            inside + outside,
            f"{grouped(inside + outside)} were wrong ({grouped(inside)} false "
            f"inside, {grouped(outside)} false outside)",
        ),
        (holes, f"{counted(holes, 'hole')} came about on meshes"),
        (doubled, f"{counted(doubled, 'double hit')} beyond the boundary rule"),
        (changed, f"{grouped(changed)} changed with how the question was put"),
        (accepted, f"{grouped(accepted)} accepted NaN or ∞"),
    ]
    return "; ".join(words for count, words in parts if count)


def _alike_words(base: str, cells: int) -> dict[str, str]:
    return {"base": base, "cells": counted(cells, "cell")}


def recipe_words(report: Report) -> dict[str, Any] | None:
    """Which of EXACT_BY_DIFFERENCES err where exponents spread, and from where."""
    hardness = hardness_of("exponent_spread")
    accuracy = report.run.accuracy
    if not len(accuracy):
        return None
    along = errors_along(
        accuracy,
        hardness.family,
        hardness.key,
        report.scalar,
        str(widest_isa(accuracy)),
    )
    known = [m for m in EXACT_BY_DIFFERENCES if m in set(along["method"])]
    first = along[along["error_rate"] > 0].groupby("method")["at"].min()
    if not known:
        return None
    return {
        "all": listed(known),
        "erring": listed(
            [f"{m} from {hardness.words(first[m])} on" for m in known if m in first]
        ),
        "sound": listed([m for m in known if m not in first]),
        "sound_count": sum(m not in first for m in known),
    }


def _distance(ulps: float) -> str:
    if ulps != ulps:
        return ""
    return f"{significant(ulps)} ulps from the boundary"


def _answers(accuracy: pd.DataFrame, method: str) -> str:
    """How many of the method's answers were judged."""
    return counted(
        int(accuracy[accuracy["method"] == method]["points"].sum()), "answer"
    )


def exact_words(report: Report) -> dict[str, Any] | None:
    """What the exact methods kept of their promise, and its price."""
    errors, speed = report.exact_errors, report.exact_speed
    if not len(errors):
        return None
    of_scalar = errors.groupby("scalar")
    highest = of_scalar["error_rate_high"].max()
    return {
        "methods": listed(in_order(errors["method"])),
        "wrong": int(errors["wrong"].sum()),
        "wrong_words": grouped(int(errors["wrong"].sum())),
        "of": counted(int(errors["of"].sum()), "answer"),
        # All of them were asked about the same points.
        "points": counted(int(of_scalar["points"].max().sum()), "point"),
        "scenes": counted(int(errors["scenes"].max()), "scene"),
        "at_most": listed([f"{short_share(v)} ({s})" for s, v in highest.items()]),
        "verified": verified_words(report.verified),
        "worst_case": worst_words(report.cost_curve),
        "ratios": {
            column: [
                {
                    "scalar": scalar,
                    "ratio": f"{row[column]:.3f}",
                    "interval": between(row[f"{column}_low"], row[f"{column}_high"]),
                    "isa": row["isa"],
                    "scene": row["scene"],
                    "fastest": row["fastest"],
                }
                for scalar, row in worst_ratios(speed, column).items()
            ]
            for column in ("of_edge", "of_fastest")
        },
    }
