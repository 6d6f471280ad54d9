"""What rays cost and how near their methods come to the machine's limits."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pandas as pd
import pytest

from analysis.rays.rays_costs import add_ray_costs, bounded, near_the_limit
from analysis.read.limits import Limits
from analysis.read.load_operations import (
    KINDS,
    OPERATIONS_COLUMNS,
    no_operations,
)
from analysis.read.run import Run, no_rays
from analysis.report.exhibits import Exhibits
from analysis.report.method_families import leaves_early
from analysis.speed.bounds import with_bounds
from analysis.speed.tables import speed_cells
from analysis.speed.written import STORES
from tests.analysis.test_bounds import machine  # noqa: F401
from tests.analysis.test_costs import folder, run  # noqa: F401
from tests.analysis.test_input_tables import frame
from tests.analysis.test_rays import name

TIMES = {
    name("moller_trumbore"): 4.0,
    name("moller_trumbore_early_out"): 3.0,
    name("baldwin_weber"): 2.0,
    name("moller_trumbore", "rays_uniform:hit=50:n=4:sets=fresh"): 9.0,
    name("moller_trumbore", "rays_grazing:exponent=8"): 9.0,
}


def counted(method: str, **per_item: float) -> list[dict[str, object]]:
    key = {"method": method, "scalar": "f32", "loop": "one_triangle_rays"}
    nothing = dict.fromkeys(KINDS, 0.0)
    return [
        key | nothing | {"per": "call"},
        key | nothing | {"per": "item"} | per_item,
    ]


@pytest.fixture
def measured(run: Run, machine: Limits) -> Run:  # noqa: F811
    operations = pd.DataFrame(
        [
            *counted("moller_trumbore", multiply=27.0, add=18.0, divide=1.0),
            *counted("moller_trumbore_early_out", multiply=27.0, add=18.0),
        ],
        columns=OPERATIONS_COLUMNS,
    )
    return dataclasses.replace(
        run,
        rays=dataclasses.replace(no_rays(), speed=frame(TIMES)),
        limits=machine,
        operations=operations,
    )


def test_a_ray_is_bound_by_the_operations_counted_for_it(measured: Run) -> None:
    cells = bounded(measured).set_index("name")
    row = cells.loc[name("moller_trumbore")]
    assert row["operations_per_item"] == 46
    assert row["bound_ns"] == max(row["compute_ns"], row["memory_ns"])
    assert row["of_limit"] == pytest.approx(row["bound_ns"] / 4.0)
    uncounted = cells.loc[name("baldwin_weber")]
    assert uncounted["bound_by"] == "memory"
    assert uncounted["compute_ns"] != uncounted["compute_ns"]


def test_a_method_that_may_leave_early_is_bound_by_memory_alone(
    measured: Run,
) -> None:
    cells = bounded(measured).set_index("name")
    assert cells.loc[name("moller_trumbore_early_out"), "bound_by"] == "memory"
    assert leaves_early("moller_trumbore_early_out_fma")
    assert not leaves_early("moller_trumbore_fma")


def test_the_table_has_the_reference_scene_alone(measured: Run) -> None:
    near = near_the_limit(bounded(measured))
    assert sorted(near["method"]) == [
        "baldwin_weber",
        "moller_trumbore",
        "moller_trumbore_early_out",
    ]
    assert set(near["scene"]) == {"rays_uniform:hit=50:bytes=24k:sets=fresh"}


def test_t_u_and_v_have_to_be_stored(
    measured: Run, machine: Limits
) -> None:  # noqa: F811
    cells = speed_cells(measured.rays.speed).iloc[:1].assign(bytes_per_item=1.0)
    isa, level = cells["isa"].iloc[0], machine.levels[0].name
    loops = ("one_triangle_rays", "one_triangle_rays_tuv")
    alone, written = (
        with_bounds(cells.assign(loop=loop), machine, no_operations()).iloc[0]
        for loop in loops
    )
    assert alone["memory_ns"] == 1e9 / machine.bandwidth(isa, "f32", level)
    stored = machine.bandwidth(isa, "f32", level, "store")
    assert written["memory_ns"] == pytest.approx(1e9 * 12 / stored, rel=0.02)
    assert written["memory_ns"] > 1e9 * 12 / stored  # its bit as well
    assert written["bound_of"] == STORES


def test_both_tables_are_shown_and_without_rays_none(measured: Run) -> None:
    exhibits = Exhibits()
    add_ray_costs(exhibits, measured, ["f32"])
    assert {"ray_operations", "ray_of_limit"} <= {each.key for each in exhibits}
    nothing = Exhibits()
    add_ray_costs(nothing, dataclasses.replace(measured, rays=no_rays()), ["f32"])
    assert not list(nothing)
