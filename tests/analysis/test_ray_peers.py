"""Other libraries in the chapter on rays, against small frames made by hand."""

from __future__ import annotations

import dataclasses
import math

import pandas as pd
import pytest

from analysis.peers.peers_tables import part_of_rays
from analysis.rays.ray_peers import (
    names,
    sources,
    table_of_libraries,
    words_of_libraries,
)
from analysis.rays.rays_exhibits import add_rays
from analysis.read.run import ACCURACY_COLUMNS, RayMethodEntry, RayRun, no_rays
from analysis.report.exhibits import Exhibits
from analysis.speed.tables import speed_cells
from tests.analysis.test_input_tables import frame

SCENE = "rays_uniform:hit=50:bytes=24k:sets=fresh"
VERSIONS = {"embree": "3.13.5", "cgal": "5.5.1"}
CALLS = ("embree_single", "cgal_intersection")


def name(method: str, isa: str, loop: str = "one_triangle_rays") -> str:
    return f"{loop}/{SCENE}/{method}/f32/{isa}"


SPEED = frame(
    {
        name("moller_trumbore", "avx2"): 0.5,
        name("moller_trumbore", "scalar"): 4.0,
        name("watertight", "avx2"): 1.0,
        name("watertight", "scalar"): 8.0,
        name("embree_single", "library"): 20.0,
        name("cgal_intersection", "library"): 50.0,
        name("cgal_intersection", "library", "ray_pairs"): 60.0,
    }
)


def judged(method: str, isa: str, family: str, holes: float = math.nan) -> dict:
    loop = "ray_pairs" if family == "rays_icosphere" else "one_triangle_rays"
    row = dict.fromkeys(ACCURACY_COLUMNS, 0)
    of = 1000 if family == "rays_icosphere" else math.nan
    return row | {
        "name": f"{loop}/{family}:ulps=1/{method}/f32/{isa}",
        **{"loop": loop, "scene": f"{family}:ulps=1", "family": family},
        **{"method": method, "scalar": "f32", "isa": isa},
        **{"points": 2000, "interior": 1000, "exterior": 1000},
        **{"accepts": "triangle", "boundary_rule": "closed"},
        **{"smallest_ulps": 1.0, "largest_ulps": 1.0},
        **{"hole": holes, "hole_of": of, "double_hit": holes, "double_hit_of": of},
    }


def whole() -> RayRun:
    methods = {"moller_trumbore": "avx2", "watertight": "avx2"}
    methods |= dict.fromkeys(CALLS, "library")
    rows = []
    for method, isa in methods.items():
        leaks = 3 if method == "embree_single" else 0
        rows.append(judged(method, isa, "rays_icosphere", leaks))
        rows.append(judged(method, isa, "rays_near_edge"))
    entries = tuple(
        RayMethodEntry(key, key.partition("_")[0].title(), key, "closed", False, False)
        for key in methods
    )
    rows.append(judged("exact", "avx2", "rays_icosphere"))
    rows[-1] |= {"hole": 0, "double_hit": 2}
    accuracy = pd.DataFrame(rows, columns=ACCURACY_COLUMNS)
    return dataclasses.replace(
        no_rays(), speed=SPEED, accuracy=accuracy, methods=entries
    )


OURS = part_of_rays(whole(), libraries=False)
LIBRARIES = part_of_rays(whole(), libraries=True)
TABLE = table_of_libraries(OURS, LIBRARIES, speed_cells(OURS.speed), ["f32", "f64"])


def test_every_row_of_rays_is_a_kernels_or_a_librarys() -> None:
    for frame_name in ("speed", "accuracy"):
        parts = [getattr(one, frame_name) for one in (OURS, LIBRARIES)]
        assert sum(map(len, parts)) == len(getattr(whole(), frame_name))
        assert set(parts[1]["isa"]) == {"library"}
        assert "library" not in set(parts[0]["isa"])
    assert [entry.key for entry in LIBRARIES.methods] == list(CALLS)
    assert [entry.key for entry in OURS.methods] == ["moller_trumbore", "watertight"]


def test_a_call_is_compared_with_the_base_on_the_widest_instruction_set() -> None:
    row = TABLE.set_index("method").loc["embree_single"]
    assert row["times_base"] == pytest.approx(40, rel=0.01)
    assert row["times_base_low"] <= row["times_base"] <= row["times_base_high"]


def test_leaks_are_of_a_million_and_a_loop_that_is_not_timed_is_nan() -> None:
    rows = TABLE.set_index("method")
    assert rows.loc["embree_single", "holes"] == pytest.approx(3000)
    assert rows.loc["cgal_intersection", "holes"] == 0
    # Three double hits, of which the closed boundary brings about two.
    assert rows.loc["embree_single", "double_hits"] == pytest.approx(1000)
    assert math.isnan(rows.loc["embree_single", "ray_pairs_ns"])
    assert rows.loc["cgal_intersection", "ray_pairs_ns"] == pytest.approx(60, rel=0.01)


def test_the_text_names_versions_the_fastest_and_who_leaks() -> None:
    said = words_of_libraries(TABLE, LIBRARIES, VERSIONS, "f32")
    assert said is not None
    assert said.libraries == "Embree 3.13.5 and Cgal 5.5.1"
    assert said.fastest == "embree_single"
    assert (said.leak_free, said.leaking) == (
        ("cgal_intersection",),
        ("embree_single",),
    )
    assert words_of_libraries(TABLE.iloc[:0], LIBRARIES, VERSIONS, "f32") is None
    assert names(LIBRARIES, {}) == ["Embree", "Cgal"]
    assert [row["source"] for row in sources(LIBRARIES, VERSIONS)] == [
        "Embree 3.13.5",
        "Cgal 5.5.1",
    ]


def test_the_chapter_shows_them_only_where_there_are_some() -> None:
    shown, alone = Exhibits(), Exhibits()
    chapter = add_rays(shown, OURS, ["f32"], "", LIBRARIES, VERSIONS)
    assert chapter.peers is not None
    marks = shown.get("rays-f32").csv
    assert set(marks[marks["isa"] == "library"]["method"]) == set(CALLS)
    assert not marks[marks["isa"] == "library"]["on_frontier"].any()
    assert "diamonds" in shown.get("rays-f32").caption
    assert set(CALLS) < set(shown.get("ray_methods").csv["method"])
    assert set(CALLS) < set(shown.get("ray_sources").csv["key"])
    none = part_of_rays(OURS, libraries=True)
    assert add_rays(alone, OURS, ["f32"], "", none, VERSIONS).peers is None
    assert not set(CALLS) & set(alone.get("ray_methods").csv["method"])
    assert "library" not in alone.get("ray_methods").caption
