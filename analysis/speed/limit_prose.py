"""The words of the chapter on the machine's limits: phrases made of the data."""

from __future__ import annotations

from typing import Any, Final

import pandas as pd

from analysis.read.run import Run
from analysis.report.wording import counted, listed, nanoseconds, significant
from analysis.speed import limit_columns, limit_tables
from analysis.speed.bounds import ALL, COUNTED_FOR, beaten
from analysis.speed.tables import reference_cells, widest_isa
from analysis.speed.written import STORES
from analysis.trust.noise import TOLERANCE

# Why a bound is too low on ISAs but those that operations are counted for.
UNDERSTATED: Final = (
    "operations are counted once, as AVX-512 has them, where a comparison that keeps "
    "or spoils a value, or one under a mask, is one operation. Other sets need more "
    "for the same, which is not counted. And bits are taken to be stored at the rate "
    "of the widest set that runs here, since the C library clears and copies with it."
)


def limit_facts(
    run: Run, cells: pd.DataFrame, scalar: str, loop: str
) -> dict[str, Any] | None:
    """None where the run has no limits."""
    limits = run.limits
    if limits is None:
        return None
    rows = reference_cells(cells, scalar, loop)
    isa = widest_isa(rows)
    rows = limit_tables.with_instructions(
        rows[rows["isa"] == isa], run.instructions, run.shards
    )
    wrong = beaten(cells)
    with_counts = int(cells["compute_ns"].notna().sum())
    rate = {
        kind: limits.rate(str(isa), scalar, kind)
        for kind in ("add", "multiply_add", "mixed")
    }
    return {
        "isa": isa,
        "bandwidths": listed(
            [
                f"{significant(value / 1e9)} GB/s from {level.name}"
                for level in limits.levels
                if (value := limits.bandwidth(str(isa), scalar, level.name)) == value
            ]
        ),
        "rates": listed(
            [
                f"{significant(value / 1e9)} billion {words}"
                for words, value in (
                    ("additions", rate["add"]),
                    ("multiply-adds", rate["multiply_add"]),
                    ("of both in equal parts", rate["mixed"]),
                )
                if value == value
            ]
        ),
        "moved": listed(
            [
                f"{words} {low:.2f} to {high:.2f}"
                for words, part in (
                    ("bandwidths", "memory"),
                    ("operations", "operations"),
                )
                if part in limits.moved
                for low, high in [limits.moved[part]]
            ]
        ),
        "clock": _clock_moved(limits.clocks_ghz),
        "cells": counted(len(cells), "cell"),
        "with_counts": with_counts,
        "without_counts": len(cells) - with_counts,
        "without_words": counted(len(cells) - with_counts, "cell"),
        "tolerance": f"{100 * TOLERANCE:.0f} %",
        "beaten": len(wrong),
        "beaten_words": counted(len(wrong), "cell"),
        "beaten_methods": listed(sorted(set(wrong["method"]))),
        "fastest": _reached(rows, rows["ns"].idxmin()) if len(rows) else None,
        "nearest": _nearest(rows),
        "counted_for_it": isa in COUNTED_FOR,
        "understated": UNDERSTATED,
        "at_once": _number(limit_tables.most_at_once(run.shards)),
        "loop": loop,
    }


def _clock_moved(clocks: tuple[float, ...]) -> str:
    """The clocks in their order, if they are further apart than what the noise
    verdict lets a shard's be, else nothing.
    """
    if not max(clocks) / min(clocks) - 1 > TOLERANCE:
        return ""
    seen = [f"{clock:.2f}" for clock in clocks]
    return f"{listed(seen)} GHz ({100 * (max(clocks) / min(clocks) - 1):.1f} % apart)"


def _number(value: float) -> str:
    return significant(value) if value == value else ""


def _reached(rows: pd.DataFrame, index: Any) -> dict[str, Any]:
    row = rows.loc[index].to_dict()
    kind = str(row["bound_of"])
    by = (
        (STORES if kind == STORES else f"loads from {kind}")
        if row["bound_by"] == "memory"
        else (
            "the number of its operations"
            if kind == ALL
            else f"its operations of the kind “{limit_columns.OPERATIONS[kind]}”"
        )
    )
    return {
        "method": row["method"],
        "ns": nanoseconds(row["ns"]),
        "bound": nanoseconds(row["bound_ns"]),
        "by": by,
        "of_limit": f"{significant(100 * row['of_limit'])} %",
        "beaten": bool(row["beaten"]),
        "instructions": _number(row["instructions"]),
        "per_cycle": _number(row["instructions_per_cycle"]),
    }


def _nearest(rows: pd.DataFrame) -> dict[str, Any] | None:
    """The method nearest to its bound, of those with a sound and whole one."""
    sound = rows[~rows["beaten"].astype(bool) & rows["compute_ns"].notna()]
    return _reached(rows, sound["of_limit"].idxmax()) if len(sound) else None
