"""The ledger of claims: every claim has its test, and every verdict can turn."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from fractions import Fraction

import pandas as pd
import pytest

from analysis.claims import formulas, in_space, lattice, rightness, speeds
from analysis.claims.evidence import (
    FAILS,
    HOLDS,
    PARTLY,
    UNTESTED,
    Evidence,
    Finding,
)
from analysis.claims.ledger import TESTS, counted_verdicts, ledger, words
from analysis.read.load import load_run
from analysis.read.load_operations import no_operations
from analysis.read.run import ACCURACY_COLUMNS, RayRun, Run, no_rays
from analysis.report.report import Report, build
from analysis.speed.tables import speed_cells
from tests.analysis.synthetic import Options, write_run
from tests.analysis.test_input_tables import frame
from tests.analysis.test_tables import accuracy_frame, name

Make = Callable[..., Evidence]


@pytest.fixture(scope="module")
def make(tmp_path_factory: pytest.TempPathFactory) -> Make:
    """Evidence of nothing but what is given: times by cell, answers by cell."""
    small = Options(profile="tiny", methods=("cross_product",), small=True)
    run = load_run(write_run(tmp_path_factory.mktemp("claims") / "run", small))

    def evidence(
        times: dict[str, float] | None = None,
        accuracy: pd.DataFrame | None = None,
        rays: RayRun | None = None,
    ) -> Evidence:
        own = dataclasses.replace(
            run,
            speed=frame(times) if times else run.speed.head(0),
            accuracy=(
                pd.DataFrame(columns=ACCURACY_COLUMNS) if accuracy is None else accuracy
            ),
            operations=no_operations(),
            rays=rays or no_rays(),
        )
        cells = speed_cells(own.speed)
        return Evidence(own, cells, cells)

    return evidence


def judged_as(test: Callable[[Evidence], Finding], evidence: Evidence) -> str:
    found = test(evidence)
    assert found.figure and found.why.endswith(".")
    return found.verdict


def test_every_claim_has_its_words_and_its_test() -> None:
    assert [entry["number"] for entry in words()] == sorted(TESTS)
    for entry in words():
        assert set(entry) == {"number", "source", "claim", "tested"}
        assert all(entry.values())


def test_a_run_without_anything_gets_no_verdict_but_on_formulas(make: Make) -> None:
    table = ledger(make()).set_index("number")["verdict"]
    of_formulas = [5, 8, 10, 12, 13, 15]
    assert set(table.drop(of_formulas)) == {UNTESTED}
    assert UNTESTED not in set(table[of_formulas])


def test_the_page_shows_the_verdicts_of_its_run(report: Report) -> None:
    table = report.claims
    assert len(table) == len(TESTS)
    exhibit = report.exhibits.get("ledger")
    assert exhibit and len(exhibit.rows) == len(table)
    spoken = counted_verdicts(table)
    assert spoken.split()[0] == str((table["verdict"] == HOLDS).sum())


# --- formulas ------------------------------------------------------------------


def test_weights_sum_to_one_and_give_the_point_back() -> None:
    for triangle in lattice.TRIANGLES:
        for p in lattice.points(triangle):
            parts = lattice.weights(triangle, p)
            assert sum(parts) == 1
            mixed = [sum(w * v[k] for w, v in zip(parts, triangle)) for k in range(2)]
            assert mixed == list(p)


def test_the_lattice_has_points_inside_outside_and_on_edges() -> None:
    for triangle in lattice.TRIANGLES:
        every = list(lattice.points(triangle))
        edge = [p for p in every if lattice.on_boundary(triangle, p)]
        inside = [p for p in every if lattice.contains(triangle, p)]
        assert len(edge) >= 3 and len(edge) < len(inside) < len(every)


def test_equations_are_solved_exactly_where_a_pivot_is_zero() -> None:
    q = Fraction
    assert lattice.solve([[q(0), q(2)], [q(3), q(1)]], [q(4), q(5)]) == [1, 2]


def test_the_sum_of_the_example_is_another(make: Make) -> None:
    found = formulas.example_of_percents(make())
    assert found.verdict == FAILS and "(11, 2)" in found.figure


@pytest.mark.parametrize("wrong, verdict", [(10, HOLDS), (400, PARTLY)])
def test_two_formulas_of_one_value_are_one_method_if_they_err_alike(
    make: Make, wrong: int, verdict: str
) -> None:
    cells = {
        name("barycentric_inverse", "avx2", "near_edge:ulps=1"): (1000, wrong, 1000, 0),
        name("cross_product_det", "avx2", "near_edge:ulps=1"): (1000, 10, 1000, 0),
    }
    evidence = make(accuracy=accuracy_frame(cells))
    assert judged_as(formulas.same_weights, evidence) == verdict


@pytest.mark.parametrize("ulps, verdict", [(2.0, PARTLY), (1e5, FAILS)])
def test_a_gradient_needs_weights_good_to_half_a_step(
    make: Make, ulps: float, verdict: str
) -> None:
    cells = accuracy_frame({name("cross_solve", "avx2"): (1000, 0, 1000, 0)})
    evidence = make(accuracy=cells.assign(weights_largest_ulps=ulps))
    assert judged_as(formulas.gradient, evidence) == verdict


# --- time ----------------------------------------------------------------------


@pytest.mark.parametrize(
    "times, verdict",
    [
        ((8.0, 2.0, 1.0, 0.5), HOLDS),
        ((8.0, 2.0, 1.0, 1.1), PARTLY),
        ((8.0, 9.0, 10.0, 11.0), FAILS),
    ],
)
def test_a_step_widens_if_it_is_surely_faster(
    make: Make, times: tuple[float, ...], verdict: str
) -> None:
    cells = {name("cross_product", i): t for i, t in zip(speeds.STEPS, times)}
    assert judged_as(speeds.each_step_widens, make(cells)) == verdict


@pytest.mark.parametrize("ns, verdict", [(1.1, HOLDS), (2.0, FAILS)])
def test_adaptive_is_little_more_up_to_a_quarter(
    make: Make, ns: float, verdict: str
) -> None:
    cells = {
        name("shewchuk_adaptive", "avx2"): ns,
        name("cross_product_det", "avx2"): 1.0,
    }
    assert judged_as(speeds.adaptive_costs_little, make(cells)) == verdict


def ray_cell(method: str, n: int = 1024) -> str:
    size = f"n={n}" if n != 1024 else "bytes=24k"
    return f"one_triangle_rays/rays_uniform:hit=50:{size}:sets=fresh/{method}/f32/avx2"


def rays(**times: float) -> RayRun:
    cells = {ray_cell(method): ns for method, ns in times.items()}
    return dataclasses.replace(no_rays(), speed=frame(cells))


@pytest.mark.parametrize("ns, verdict", [(1.05, HOLDS), (1.2, PARTLY), (2.0, FAILS)])
def test_watertight_is_held_to_both_claims(make: Make, ns: float, verdict: str) -> None:
    run = rays(watertight=ns, baldwin_weber=1.0)
    assert judged_as(in_space.watertight_costs, make(rays=run)) == verdict


@pytest.mark.parametrize(
    "factor, verdict", [(1.0, PARTLY), (0.25, HOLDS), (4.0, FAILS)]
)
def test_transforming_beforehand_has_to_be_faster_and_soon(
    make: Make, factor: float, verdict: str
) -> None:
    # 8 ns a call and half a ns a ray saved: faster by a third, from 16 rays on.
    cells = {
        ray_cell("moller_trumbore"): 0.4,
        ray_cell("baldwin_weber"): 0.3 * factor,
    }
    for n in (1, 4, 16, 64, 256):
        cells[ray_cell("moller_trumbore", n)] = 1.0
        cells[ray_cell("baldwin_weber", n)] = (0.5 + 8 / n) * factor
    run = dataclasses.replace(no_rays(), speed=frame(cells))
    assert judged_as(in_space.transformed_beforehand, make(rays=run)) == verdict


def test_a_break_even_without_a_number_is_said_in_words() -> None:
    nan = float("nan")
    row = {"worst_n": 1, "break_even": 3.0, "break_even_low": 2.0}
    assert in_space._pays(pd.Series({**row, "break_even_high": 4.0})).startswith(
        "pays from 3 (2 to 4)"
    )
    unsure = in_space._pays(pd.Series({**row, "break_even_high": nan}))
    assert unsure == "is not shown to pay at any number of rays"
    never = pd.Series({**row, "break_even_low": nan, "break_even_high": nan})
    assert in_space._pays(never) == "never pays"


# --- answers -------------------------------------------------------------------


@pytest.mark.parametrize("inverse", [(0, HOLDS), (30, PARTLY)])
def test_triangles_without_area_are_ruled_out_if_none_is_accepted(
    make: Make, inverse: tuple[int, str]
) -> None:
    accepted, verdict = inverse
    scene = "degenerate:kind=collinear"
    cells = accuracy_frame(
        {
            name("cross_product", "avx2", scene): (0, 0, 0, accepted),
            name("exact", "avx2", scene): (0, 0, 0, 0),
        }
    ).assign(degenerate=100)
    evidence = make(accuracy=cells)
    assert judged_as(rightness.collinear_vertices, evidence) == verdict
    why = rightness.collinear_vertices(evidence).why
    assert ("exactly without area" in why) == (accepted > 0)


@pytest.mark.parametrize("wrong, verdict", [(0, HOLDS), (10, PARTLY), (400, FAILS)])
def test_a_tolerance_is_robust_if_nothing_is_wrong(
    make: Make, wrong: int, verdict: str
) -> None:
    cells = {
        name("epsilon", "avx2", "near_edge:ulps=1"): (1000, wrong, 1000, 0),
        name("cross_product_det", "avx2", "near_edge:ulps=1"): (1000, 100, 1000, 0),
    }
    evidence = make(accuracy=accuracy_frame(cells))
    assert judged_as(rightness.epsilon_makes_robust, evidence) == verdict


@pytest.mark.parametrize(
    "within, beyond, spread, verdict",
    [(0, 50, 0, HOLDS), (0, 50, 1, PARTLY), (1, 50, 0, FAILS)],
)
def test_double_double_is_held_to_its_range(
    make: Make, within: int, beyond: int, spread: int, verdict: str
) -> None:
    def cell(scene: str) -> str:
        return f"one_triangle/{scene}/double_double/f64/avx2"

    cells = {
        cell("scale:exponent=502"): (100, within, 100, 0),
        cell("scale:exponent=764"): (100, beyond, 100, 0),
        cell("exponent_spread:binades=60"): (100, spread, 100, 0),
    }
    found = rightness.double_double_range(make(accuracy=accuracy_frame(cells)))
    assert found.verdict == verdict
    assert ("exponent_spread" in found.why) == (spread > 0)


@pytest.mark.parametrize("wrong, verdict", [(0, HOLDS), (1, PARTLY)])
def test_promotion_is_exact_if_no_scene_shows_otherwise(
    make: Make, wrong: int, verdict: str
) -> None:
    cells = {
        name("promoted_f64", "avx2", "near_edge:ulps=1"): (100, 0, 100, 0),
        name("promoted_f64", "avx2", "special:kind=largest"): (100, wrong, 100, 0),
    }
    evidence = make(accuracy=accuracy_frame(cells))
    assert judged_as(rightness.promotion_is_exact, evidence) == verdict


@pytest.mark.parametrize("wrong, verdict", [(100, HOLDS), (400, PARTLY)])
def test_normal_equations_may_cost_accuracy(
    make: Make, wrong: int, verdict: str
) -> None:
    cells = accuracy_frame(
        {
            f"one_triangle_rays/rays_near_edge:ulps=1/{method}/f32/avx2": (
                1000,
                count,
                1000,
                0,
            )
            for method, count in (("plane_gram", wrong), ("moller_trumbore", 100))
        }
    )
    run = dataclasses.replace(no_rays(), accuracy=cells)
    assert judged_as(rightness.normal_equations, make(rays=run)) == verdict
