"""The chapter on rays says what the data says, on frames worked out by hand."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import pytest

from analysis.accuracy.ulp_maps import LEAKS, claim_classes, claims_chart, fma_below
from analysis.rays.rays_chapter import ray_facts
from analysis.rays.rays_claims import (
    fastest_of,
    kept_break_evens,
    time_over,
    watertight_over_precomputed,
)
from analysis.rays.rays_failures import contraction_words
from analysis.rays.rays_guidance import Priced, guidance, priced
from analysis.rays.rays_leaks import cases_table, contraction, sphere_rates
from analysis.read.load import load_run
from analysis.read.maps import RayCase, RayMap
from analysis.read.run import ACCURACY_COLUMNS, RayMethodEntry, RayRun, no_rays
from analysis.speed.input_tables import by_size, culling, of_comparisons
from analysis.speed.tables import speed_cells
from tests.analysis.test_input_tables import frame

REFERENCE = "rays_uniform:hit=50:bytes=24k:sets=fresh"
TIMES = {
    "moller_trumbore": 0.4,
    "moller_trumbore_fma": 0.35,
    "moller_trumbore_early_out": 0.6,
    "moller_trumbore_culled": 0.2,
    "baldwin_weber": 0.3,
    "watertight": 0.9,
    "exact": 1.2,
}
# Leaks and double hits among 1000 rays.
LEAKING = {
    "moller_trumbore": (30, 70),
    "moller_trumbore_fma": (50, 60),
    "moller_trumbore_culled": (0, 0),
    "baldwin_weber": (40, 90),
    "watertight": (0, 20),
    "exact": (0, 20),
}


def name(method: str, scene: str = REFERENCE) -> str:
    return f"one_triangle_rays/{scene}/{method}/f32/avx2"


def timed(times: dict[str, float]) -> dict[str, float]:
    """With a sweep in which the transformation costs 8 ns a call and saves half
    a ns a ray: as much for 16 rays.
    """
    found = {name(method): ns for method, ns in times.items()}
    for n in (1, 4, 16, 64, 256):
        scene = f"rays_uniform:hit=50:n={n}:sets=fresh"
        found[name("moller_trumbore", scene)] = 1.0
        found[name("baldwin_weber", scene)] = 0.5 + 8 / n
    return found


def judged(leaking: dict[str, tuple[int, int]], wrong: int = 0) -> pd.DataFrame:
    rows: list[dict[str, Any]] = []
    for method, (holes, doubles) in leaking.items():
        row = dict.fromkeys(ACCURACY_COLUMNS, 0) | {
            "loop": "ray_pairs",
            "scene": "rays_icosphere:ulps=0",
            "family": "rays_icosphere",
            "method": method,
            "scalar": "f32",
            "isa": "avx2",
            "boundary_rule": "closed",
            "accepts": "triangle",
            "points": 5000,
            "interior": 1000,
            "exterior": 4000,
            "false_outside": wrong if method == "exact" else holes,
            "hole": holes,
            "hole_of": 1000,
            "double_hit": doubles,
            "double_hit_of": 1000,
        }
        rows.append(row)
    return pd.DataFrame(rows, columns=ACCURACY_COLUMNS)


def rays(times: dict[str, float], leaking: dict[str, tuple[int, int]]) -> RayRun:
    culls = RayMethodEntry("moller_trumbore_culled", "", "", "closed", False, True)
    return dataclasses.replace(
        no_rays(),
        speed=frame(timed(times)),
        accuracy=judged(leaking),
        methods=(culls,),
    )


def prices(run: RayRun) -> Priced:
    every = speed_cells(run.speed)
    found = priced(run, of_comparisons(every), every, "f32")
    assert found is not None
    return found


def said(
    times: dict[str, float] = TIMES,
    leaking: dict[str, tuple[int, int]] = LEAKING,
) -> str:
    return " ".join(guidance(prices(rays(times, leaking)))).replace("\u00a0", " ")


def test_leaks_are_counted_and_double_hits_beyond_the_rule() -> None:
    table = sphere_rates(judged(LEAKING), "f32", "avx2").set_index("method")
    assert table.loc["moller_trumbore", "hole"] == 0.03
    assert table.loc["moller_trumbore", "double_hit_count"] == 50  # 20 by the rule
    assert table.loc["exact", "double_hit_count"] == 0
    assert not len(sphere_rates(judged(LEAKING), "f64", "avx2"))


def test_the_fastest_is_said_with_its_leaks() -> None:
    words = said()
    assert "Where a lost ray does no harm, take baldwin_weber" in words
    assert "4.00 % (2.95 to 5.40 %) escaped it" in words
    # The one that culls is faster and answers another question.
    assert "take moller_trumbore_culled" not in words
    faster = said({**TIMES, "moller_trumbore": 0.1})
    assert "take moller_trumbore: the fastest" in faster
    assert "3.00 % (" in faster


def test_without_leaks_the_fastest_is_all_that_is_needed() -> None:
    words = said(leaking={**LEAKING, "baldwin_weber": (0, 0)})
    assert "Take baldwin_weber: the fastest" in words
    assert "a lost ray does no harm" not in words
    assert "For a closed surface" not in words


def test_for_a_closed_surface_the_cheapest_that_leaks_nothing() -> None:
    words = said()
    assert "For a closed surface take watertight: of 2 methods" in words
    assert "3.00 (" in words  # 0.9 over 0.3
    assert "For a closed surface take exact" in said({**TIMES, "exact": 0.5})
    every = {method: (1, 0) for method in LEAKING}
    assert "rays escaped every method" in said(leaking=every)


def test_exact_answers_are_promised_only_where_none_was_wrong() -> None:
    assert "none of 5000 answers on all scenes of this run was wrong" in said()
    run = dataclasses.replace(rays(TIMES, LEAKING), accuracy=judged(LEAKING, wrong=3))
    words = " ".join(guidance(prices(run)))
    assert "3 of 5000 answers" in words
    assert "which the method does not allow" in words
    without = {k: v for k, v in TIMES.items() if k != "exact"}
    assert "every answer has to be right" not in said(without)


def test_the_price_of_watertight_follows_the_times() -> None:
    assert "watertight takes 3.00" in said()
    assert "the price of not losing rays" in said()
    assert "costs nothing here" in said({**TIMES, "watertight": 0.25})
    torn = said(leaking={**LEAKING, "watertight": (2, 20)})
    assert "and yet rays escaped it" in torn
    without = {k: v for k, v in TIMES.items() if k != "watertight"}
    assert "watertight takes" not in said(without)


def test_contraction_is_said_to_leak_more_or_less() -> None:
    assert "With multiply-add 1 of 1 method let more rays out and 0 fewer" in said()
    torn = said(leaking={**LEAKING, "moller_trumbore": (0, 0)})
    assert "moller_trumbore let none out without it and some with it" in torn
    none = {k: v for k, v in LEAKING.items() if not k.endswith("_fma")}
    assert "With multiply-add" not in said(leaking=none)


def test_a_way_out_that_costs_is_said_to_cost() -> None:
    assert "saves time in 0 of 1 case on fresh input and costs some in 1" in said()
    quick = said({**TIMES, "moller_trumbore_early_out": 0.2})
    assert "saves time in 1 of 1 case" in quick


def test_the_set_up_pays_where_it_is_won_back() -> None:
    run = rays(TIMES, LEAKING)
    cells = speed_cells(run.speed)
    assert sorted(set(by_size(cells)["n"])) == [1, 4, 16, 64, 256]
    table = kept_break_evens(run, cells)
    row = table[table["isa"] == "avx2"].iloc[0]
    assert row["break_even"] == pytest.approx(16, rel=0.05)
    assert row["break_even_low"] <= row["break_even"] <= row["break_even_high"]
    assert "baldwin_weber in place of moller_trumbore pays from" in said()
    slow = frame({k: 9.0 if "baldwin" in k else 1.0 for k in timed(TIMES)})
    never = prices(dataclasses.replace(run, speed=slow))
    assert "pays nowhere beyond doubt" in " ".join(guidance(never))


def test_ratios_are_those_of_the_reference_scene_of_one_shard() -> None:
    run = rays(TIMES, LEAKING)
    cells = of_comparisons(speed_cells(run.speed))
    ratio = time_over(run, cells, "watertight", "baldwin_weber", "f32", "avx2")
    assert ratio is not None and ratio.low < ratio.value < ratio.high
    assert ratio.value == pytest.approx(3, rel=0.001)
    assert time_over(run, cells, "watertight", "plane_gram", "f32", "avx2") is None
    assert fastest_of(cells, ("moller_trumbore",), "f32", "avx2") == (
        "moller_trumbore_fma"
    )
    found = watertight_over_precomputed(run, cells, "f32", "avx2")
    assert found is not None and found[0] == "baldwin_weber"
    half = culling(run.speed, cells).set_index("method")["over_two_sided"]
    assert half["moller_trumbore_culled"] == pytest.approx(0.5, rel=0.001)


def square(plain: tuple[bool, bool], fused: tuple[bool, bool]) -> list[RayCase]:
    return [
        RayCase(
            f"oblikovati_2146_{half}",
            "https://example.org",
            "f32",
            "boundary",
            (("plane_gram", plain[k]), ("plane_gram_fma", fused[k]), ("exact", True)),
        )
        for k, half in enumerate(("lower", "upper"))
    ]


def test_a_ray_lost_to_contraction_is_named() -> None:
    table = contraction(square((True, False), (False, False)))
    assert table.to_dict("records") == [
        {"scalar": "f32", "method": "plane_gram", "of": 2, "plain": 1, "fused": 0}
    ]
    assert contraction_words(table).startswith(
        "plane_gram (f32) without multiply-add hit, and with it miss both"
    )
    assert contraction_words(table).endswith("Of 1, 0 hit either way.")
    kept = contraction(square((True, True), (True, False)))
    assert contraction_words(kept) == "Here it costs no method the ray."
    assert contraction_words(contraction([])) == ""


def test_each_case_says_who_hits() -> None:
    table = cases_table(square((True, True), (False, True)))
    assert list(table["hits"]) == [2, 3]
    assert table.loc[0, "missed_by"] == ["plane_gram_fma"]


def ray_map(method: str) -> RayMap:
    claimed = np.array([[1, 1], [0, 1]], dtype=bool)
    twice = np.array([[0, 1], [0, 1]], dtype=bool)
    on_edge = np.array([[0, 0], [0, 1]], dtype=bool)
    return RayMap(method, "f32", "avx2", claimed, twice, on_edge, {})


def test_a_ray_claimed_by_none_or_by_several_shows() -> None:
    classes = claim_classes(ray_map("exact"))
    shown = [[LEAKS.classes[at][0] for at in row] for row in classes]
    assert shown == [
        ["claimed once", "a double hit: claimed by several"],
        ["a leak: claimed by none", "on an edge, claimed by several"],
    ]


def test_forms_with_multiply_add_stand_below_those_without() -> None:
    methods = ("exact", "watertight_fma", "watertight", "moller_trumbore")
    maps = [ray_map(method) for method in methods]
    chart = claims_chart(maps, "f32", "", LEAKS)
    assert "0 of 4 methods give every ray to exactly one triangle" in chart.title
    ordered, columns = fma_below(maps)
    assert [entry.method for entry in ordered] == [
        "watertight",
        "exact",
        "moller_trumbore",
        "watertight_fma",
    ]
    assert columns == 3


def test_a_run_without_rays_has_nothing_to_say(small_run: Path) -> None:
    facts = ray_facts(load_run(small_run), "f32")
    assert facts.guidance == () and facts.leaks == () and facts.contraction == ""
