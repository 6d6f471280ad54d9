"""The facts that the report's prose is made of, as finished phrases.

The template holds sentences, this holds what varies in them: every number,
name, word of rank and verdict comes from the run's tables.
"""

from __future__ import annotations

import tomllib
from typing import Any

import pandas as pd

from analysis.accuracy.accuracy_tables import errors_along
from analysis.accuracy.failure_prose import METHODS_TEXT, failure_facts
from analysis.accuracy.hardness import HARDNESSES, Hardness
from analysis.charts import palette
from analysis.charts.hero_chart import named
from analysis.choice.choice_exhibits import guidance_facts
from analysis.claims.ledger import counted_verdicts
from analysis.peers.peers_exhibits import peers_facts
from analysis.rays.rays_chapter import ray_facts
from analysis.read.cells import parse_scene
from analysis.report import columns
from analysis.report.exhibits import Column
from analysis.report.findings import findings
from analysis.report.machine_prose import build_facts, machine_rows, times_facts
from analysis.report.report import MAIN_LOOP, Report, short_revision
from analysis.report.verdicts import NOTICED, WHOLE
from analysis.report.wording import (
    between,
    counted,
    listed,
    nanoseconds,
    share,
    share_between,
    significant,
    size_in_bytes,
    spoken,
    times,
)
from analysis.speed.goals import goal_facts
from analysis.speed.grid_tables import (
    across_edges,
    fastest_sentence,
    gain_sentence,
    grid_bound_facts,
)
from analysis.speed.input_exhibits import input_facts
from analysis.speed.layout_tables import layout_sentence
from analysis.speed.limit_prose import limit_facts
from analysis.speed.tables import reference_cells, samples, widest_isa
from analysis.trust.noise import TOLERANCE
from analysis.trust.stats import ratio_interval
from analysis.trust.trust_exhibits import trust_facts


def facts(report: Report) -> dict[str, Any]:
    """What the templates may use."""
    run, machine = report.run, report.run.machine
    return {
        "run": run.name,
        "profile": run.profile,
        "revision": short_revision(run),
        "dirty": machine.dirty,
        "machine": machine,
        "machine_rows": machine_rows(machine),
        "times": times_facts(run.times),
        "built": build_facts(run.built),
        "cells": counted(len(report.timed), "cell"),
        "judged": counted(len(run.accuracy), "cell"),
        "points_judged": counted(int(run.accuracy["points"].sum()), "answer"),
        "refused": len(run.refused),
        "refused_count": counted(len(run.refused), "cell"),
        "noise": report.noise,
        "trust": trust_facts(report.noise, report.placement_spreads),
        "tolerance": f"{100 * TOLERANCE:.0f} %",
        "repetitions": _repetitions(report),
        "coverage": _coverage(report),
        "methods": method_texts(report),
        "scenes": run.scenes,
        "rays": report.rays,
        "ray_facts": ray_facts(run, report.scalar),
        "layout": layout_sentence(report.layouts, report.isa),
        "grid": {
            "fastest": fastest_sentence(report.grid),
            "gain": gain_sentence(across_edges(run.speed, report.cells)),
            **grid_bound_facts(report.grid),
        },
        "scalar": report.scalar,
        "isa": report.isa,
        "scene": report.scene,
        "scene_words": scene_words(report),
        "accuracy_loop": report.accuracy_loop,
        "advice": advice(report),
        "findings": findings(report),
        "guidance": guidance_facts(report.guidance),
        "claims": {
            "count": len(report.claims),
            "verdicts": counted_verdicts(report.claims),
        },
        "uniform": uniform(report),
        "near_edge": near_edge(report),
        "hard": {h.family: hard(report, h) for h in HARDNESSES},
        "scaling": scaling(report),
        "autovec": autovec(report),
        "agreement": agreement(report),
        "shards": run.every_shard,
        "input": input_facts(report.input),
        "costs": report.costs,
        "cpus": report.cpus,
        "isa_up_to": run.isa_up_to,
        "ladder": report.ladder,
        "goals": goal_facts(report.goals),
        "traced": bool(len(run.instructions)),
        "peers": peers_facts(report.parted, report.peers),
        **failure_facts(report),
        "limit": limit_facts(run, report.cells, report.scalar, MAIN_LOOP),
        "verdict_columns": [column.title for column in columns.VERDICTS],
        "verdict_rows": [
            [_with_note(column, row) for column in columns.VERDICTS]
            for row in report.verdicts.to_dict("records")
            if row["method"] in worth_a_row(report)
        ],
        "verdicts_left_out": len(report.verdicts)
        - int(report.verdicts["method"].isin(worth_a_row(report)).sum()),
    }


def worth_a_row(report: Report) -> set[str]:
    """The methods of a short table: those that the hero chart names, and
    those that the advice is about.
    """
    hero = report.exhibits.get(f"hero-{report.scalar}")
    advised = report.advice
    found = named(hero.csv) if hero else set(report.verdicts["method"])
    return found | ({advised.fastest, advised.most_right} if advised else set())


def advice(report: Report) -> dict[str, Any] | None:
    """Which method to take, in phrases."""
    if report.advice is None:
        return None
    table = report.verdicts.set_index("method")
    taken = report.advice

    def words(method: str) -> dict[str, str]:
        row = table.loc[method]
        return {
            "method": method,
            "ns": nanoseconds(row["ns"]),
            "interval": between(row["ns_low"], row["ns_high"]),
            "points": spoken(row["items_per_second"]),
            "errors": share(row["error_rate"]),
            "errors_interval": share_between(
                row["error_rate_low"], row["error_rate_high"]
            ),
        }

    told = {taken.most_right, *taken.as_right, *taken.as_fast}
    others = [method for method in taken.alike if method not in told]
    least = table.loc[taken.most_right, "error_rate"]
    published = table[table["accepts"].fillna(WHOLE) != WHOLE]
    return {
        "same": taken.fastest == taken.most_right,
        "fastest": words(taken.fastest),
        "most_right": words(taken.most_right),
        "cost": times(taken.cost),
        "cost_interval": between(taken.cost_low, taken.cost_high),
        "as_right": listed(list(taken.as_right)),
        "as_right_count": len(taken.as_right),
        "alike": listed(others),
        "as_fast": listed(list(taken.as_fast)),
        "as_fast_count": len(taken.as_fast),
        "alike_count": len(others),
        "never_errs": bool(least == 0),
        # One sentence for a formula: its twin by multiply-add stands in the table.
        "not_whole": [
            (method, row["verdict"])
            for method, row in published.iterrows()
            if method.removesuffix("_fma") == method
            or method.removesuffix("_fma") not in published.index
        ],
    }


def uniform(report: Report) -> dict[str, Any] | None:
    """How often the methods err where points are spread evenly."""
    accuracy = report.run.accuracy
    rows = accuracy[(accuracy["family"] == "uniform") & (accuracy["accepts"] == WHOLE)]
    if not len(rows):
        return None
    rows = rows.assign(wrong=rows["false_outside"] + rows["false_inside"])
    wrong = rows.groupby("method")["wrong"].sum()
    erring = sorted(wrong[wrong > 0].index, key=palette.method_rank)
    return {
        "methods": counted(len(wrong), "method"),
        "points": counted(int(rows["points"].sum()), "answer"),
        "wrong": counted(int(wrong.sum()), "wrong answer"),
        "erring": listed(erring),
        "erring_count": len(erring),
        "noticed": share(NOTICED),
    }


def near_edge(report: Report) -> dict[str, str] | None:
    """How the error rates on the hard scenes are pooled."""
    rows = report.run.accuracy
    rows = rows[(rows["family"] == "near_edge") & (rows["scalar"] == report.scalar)]
    if not len(rows):
        return None
    distances = sorted({parse_scene(s).number("ulps") for s in rows["scene"]})
    per_cell = rows.groupby(["method", "isa", "loop"])["points"].sum()
    return {
        "scenes": counted(rows["scene"].nunique(), "scene"),
        "distances": listed([f"{value:g}" for value in distances]),
        "points": counted(int(per_cell.max()), "point"),
    }


def hard(report: Report, hardness: Hardness) -> dict[str, Any] | None:
    """Which methods err most and least along a family of scenes."""
    along = errors_along(
        report.run.accuracy,
        hardness.family,
        hardness.key,
        report.scalar,
        str(widest_isa(report.run.accuracy)),
    )
    along = along[along["accepts"] == WHOLE] if len(along) else along
    if not len(along):
        return None
    worst = along.groupby("method")["error_rate"].max()
    top = along.loc[along["error_rate"].idxmax()]
    clean = sorted(worst[worst == 0].index, key=palette.method_rank)
    return {
        "most_method": top["method"],
        "most": share(top["error_rate"]),
        "most_at": hardness.words(top["at"]),
        "methods": len(worst),
        "clean": listed(clean),
        "clean_count": len(clean),
        "first": hardness.words(along["at"].min()),
        "last": hardness.words(along["at"].max()),
    }


def scaling(report: Report) -> list[dict[str, str]]:
    """For each ISA: the slowest and the fastest method's gain over scalar."""
    rows = reference_cells(report.cells, report.scalar, MAIN_LOOP)
    rows = rows.dropna(subset=["times_scalar"])
    found = []
    for isa in sorted(rows["isa"].unique(), key=palette.isa_rank):
        if isa == "scalar" or palette.is_autovec(isa):
            continue
        own = rows[rows["isa"] == isa]
        step = {"isa": isa}
        for end, index in (
            ("least", own["times_scalar"].idxmin()),
            ("most", own["times_scalar"].idxmax()),
        ):
            row = own.loc[index]
            step[end] = times(row["times_scalar"])
            step[f"{end}_interval"] = between(
                row["times_scalar_low"], row["times_scalar_high"]
            )
            step[f"{end}_method"] = row["method"]
        found.append(step)
    return found


def autovec(report: Report) -> list[dict[str, str]]:
    """For each method with plain-loop rows: the best of them against the
    best hand-vectorised row of the same method.
    """
    rows = reference_cells(report.cells, report.scalar, MAIN_LOOP)
    rows = rows.assign(plain=rows["isa"].map(palette.is_autovec).astype(bool))
    by_cell = samples(report.run.speed)
    found = []
    for method in sorted(
        rows[rows["plain"]]["method"].unique(), key=palette.method_rank
    ):
        own = rows[rows["method"] == method]
        loop = own[own["plain"]]
        vector = own[~own["plain"]]
        if len(loop) and len(vector):
            best_loop = loop.loc[loop["ns"].idxmin()]
            best = vector.loc[vector["ns"].idxmin()]
            ratio = ratio_interval(
                by_cell[best_loop["shard"], best_loop["name"]],
                by_cell[best["shard"], best["name"]],
            )
            found.append(
                {
                    "method": method,
                    "loop_isa": best_loop["isa"],
                    "isa": best["isa"],
                    "ratio": times(ratio.value),
                    "interval": between(ratio.low, ratio.high),
                }
            )
    return found


def agreement(report: Report) -> dict[str, Any] | None:
    """Whether the ISAs give the same answers."""
    table = report.agreement
    if not len(table):
        return None
    apart = table[~table["agree"].astype(bool)]
    return {
        "groups": counted(len(table), "group"),
        "apart": len(apart),
        "apart_count": counted(len(apart), "group"),
        "methods": listed(sorted(apart["method"].unique(), key=palette.method_rank)),
    }


def method_texts(report: Report) -> list[dict[str, Any]]:
    """The methods of the run in words, in their lasting order."""
    texts = tomllib.loads(METHODS_TEXT.read_text(encoding="utf-8"))
    declared = {entry.key: entry for entry in report.run.methods}
    measured = set(report.timed["method"]) | set(report.run.accuracy["method"])
    rules = dict(
        zip(report.run.accuracy["method"], report.run.accuracy["boundary_rule"])
    )
    found = []
    for key in sorted(measured, key=palette.method_rank):
        entry = declared.get(key)
        text = texts.get(key, {})
        found.append(
            {
                "key": key,
                "colour": palette.method_style(key).colour,
                "title": text.get("title", key),
                "idea": text.get("idea", ""),
                "formula": entry.formula if entry else text.get("formula", ""),
                "source": entry.source if entry else "",
                "cost": text.get("cost", ""),
                "boundary": (entry.boundary if entry else rules.get(key, "")).replace(
                    "_", "-"
                ),
                "weights": entry.weights if entry else False,
            }
        )
    return found


def scene_words(report: Report) -> str:
    """The reference scene in words."""
    rows = reference_cells(report.cells, report.scalar, MAIN_LOOP)
    if report.scene is None or not len(rows):
        return ""
    items, size = rows["items"].median(), rows["working_set_bytes"].median()
    hit = parse_scene(report.scene).get("hit")
    words = f"{counted(round(items), 'point')} a call ({size_in_bytes(size)})"
    return words + (f", {hit} % of them inside" if hit else "")


def _with_note(column: Column, row: dict[str, Any]) -> str:
    note = column.note(row) if column.note else ""
    return column.show(row) + (f" ({note})" if note else "")


def _repetitions(report: Report) -> str:
    counts = sorted(set(report.cells["repetitions"]))
    return listed([str(count) for count in counts])


def _coverage(report: Report) -> str:
    return f"{100 * report.cells['coverage'].min():.1f} %"
