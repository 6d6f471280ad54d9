"""The chapter on rays, against small frames worked out by hand."""

from __future__ import annotations

import dataclasses

import pandas as pd
import pytest

from analysis.rays.rays_exhibits import add_rays
from analysis.rays.rays_tables import against_base
from analysis.read.load_rays import RayRows, is_ray_loop, parted
from analysis.read.run import RayMethodEntry, RayRun, no_rays
from analysis.report.exhibits import Exhibits
from analysis.speed.tables import speed_cells
from tests.analysis.test_input_tables import frame

REFERENCE = "rays_uniform:hit=50:bytes=24k:sets=fresh"


def name(method: str, scene: str = REFERENCE) -> str:
    return f"one_triangle_rays/{scene}/{method}/f32/avx2"


TIMES = {
    name("moller_trumbore"): 0.4,
    name("baldwin_weber"): 0.3,
    name("moller_trumbore_culled"): 0.35,
}
SPEED = frame(TIMES)


def rays(speed: pd.DataFrame = SPEED) -> RayRun:
    entry = RayMethodEntry("moller_trumbore_culled", "", "", "closed", False, True)
    return dataclasses.replace(no_rays(), speed=speed, methods=(entry,))


def test_rows_of_rays_are_taken_out_by_their_loop() -> None:
    rows = [{"loop": loop} for loop in ("one_triangle", "one_ray", "ray_pairs_tuv")]
    points, others = parted(rows)
    assert [row["loop"] for row in points] == ["one_triangle"]
    assert [row["loop"] for row in others] == ["one_ray", "ray_pairs_tuv"]
    assert not is_ray_loop("one_point")


def test_every_method_is_compared_with_the_branchless_one() -> None:
    table = against_base(SPEED, speed_cells(SPEED)).set_index("name")
    ratio = table.loc[name("baldwin_weber"), "times_base"]
    assert ratio == pytest.approx(0.75, rel=0.001)
    low = table.loc[name("baldwin_weber"), "times_base_low"]
    assert low < 0.75 < table.loc[name("baldwin_weber"), "times_base_high"]


def test_a_run_without_rays_has_no_chapter() -> None:
    exhibits = Exhibits()
    assert add_rays(exhibits, no_rays(), ["f32"], "").cells == 0
    assert not list(exhibits)
    assert not len(RayRows().run([], [], [], ()).accuracy)
