"""The error bounds hold for the real kernels, and are not so wide that anything
would hold; and so does what is chosen by them.

The kernels are those of build/: over hundreds of scenes, of both number types,
each with thousands of points near edges, beyond sharp corners and far away, no
answer is wrong farther from an edge than the method's bound.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from analysis.choice.choose import decide
from analysis.choice.choose_scene import Scene
from analysis.choice.error_bounds import bound, bound_of_all
from analysis.choice.extent import Extent
from tests.analysis.choosing import ENTRIES, METHODS, timing
from tests.analysis.hard_scenes import Asked, HardScene, Rows, needs_program

# Errors that were found beyond this share of the bound: a bound that much smaller
# would be wrong. The methods that work from P err most on triangles that the
# scenes seldom have.
TIGHT = {
    "cross_product": 0.05,
    "cross_product_det": 0.05,
    "cross_product_det_fma": 0.03,
    "epsilon": 0.3,
    "edge_function": 0.1,
    "edge_function_fma": 0.08,
    "edge_function_top_left": 0.08,
    "edge_slope": 0.08,
    "edge_slope_fma": 0.08,
    "barycentric_determinant": 0.01,
    "barycentric_determinant_closed": 0.01,
    "barycentric_determinant_closed_fma": 0.01,
    "barycentric_inverse": 0.1,
    "barycentric_inverse_fma": 0.08,
    "uv_projection": 0.01,
    "cross_product_centered": 0.01,
    "cross_product_kahan": 0.01,
    "cross_solve": 0.004,
    "snapped_i16": 0.2,
}


def _limits(asked: Asked, method: str) -> Rows:
    """The bound at each case: the smaller one of the two that hold, that of the
    scene's sizes and that of its slimness.
    """
    every = [
        min(
            bound(method, scene.extent).distance,
            bound_of_all(method, scene.by_aspect).distance,
        )
        for scene in asked.scenes
    ]
    return np.array(every)[asked.which]


def _of(scalar: str) -> Iterator[str]:
    for method in METHODS:
        if scalar == "f32" or not method.startswith("promoted"):
            yield method


@needs_program
def test_no_kernel_is_wrong_farther_from_an_edge_than_its_bound(asked: Asked) -> None:
    beyond = {}
    for method in _of(asked.scalar):
        bad = asked.wrong(method) & (asked.distance > _limits(asked, method))
        if bad.any():
            case = int(np.flatnonzero(bad)[0])
            scene = asked.scenes[int(asked.which[case])]
            beyond[method] = (int(bad.sum()), case, scene.extent)
    assert beyond == {}


@needs_program
def test_bounds_are_not_so_wide_that_anything_would_hold(asked: Asked) -> None:
    loose = {}
    for method, least in TIGHT.items():
        limits = _limits(asked, method)
        judged = asked.wrong(method) & np.isfinite(limits) & (limits > 0)
        reached = float((asked.distance[judged] / limits[judged]).max(initial=0))
        if reached < least:
            loose[method] = reached
    assert loose == {}


@needs_program
def test_a_hundredth_of_a_bound_does_not_hold(asked: Asked) -> None:
    """That the first test would notice."""
    for method in ("cross_product", "edge_function", "edge_slope", "uv_projection"):
        small = _limits(asked, method) / 100
        assert (asked.wrong(method) & (asked.distance > small)).any(), method


@needs_program
def test_scenes_ask_what_is_hard(asked: Asked) -> None:
    words, counts = np.unique(asked.truth, return_counts=True)
    share = dict(zip(words, counts / len(asked.truth)))
    assert share["inside"] > 0.1 and share["outside"] > 0.1
    assert "degenerate" not in share
    assert asked.wrong("cross_product").sum() > 1000


def of(found: HardScene, tolerance: float, need: str) -> Scene:
    e: Extent = found.extent
    return Scene(
        scalar=e.scalar,
        low=e.low,
        high=e.high,
        altitude=e.altitude,
        edges=(e.longest, e.longest),
        points=4096,
        hit=0.5,
        need=need,
        precision=e.quantum,
        tolerance=tolerance,
    )


@needs_program
def test_what_is_chosen_is_right_or_wrong_within_what_was_stated(asked: Asked) -> None:
    """For each scene times are drawn, so that every method has its turn, and
    a tolerance; then the kernel that is chosen answers all the scene's points.
    """
    random = np.random.default_rng(1)
    taken: dict[str, int] = {}
    for index, found in enumerate(asked.scenes):
        need = ["class", "exact", "watertight"][
            int(random.choice(3, p=[0.8, 0.1, 0.1]))
        ]
        reach = found.extent.longest * 2.0 ** random.uniform(-30, 2)
        tolerance = reach if need == "class" else 0.0
        timed = [timing(m, float(random.uniform(1, 9)), asked.scalar) for m in METHODS]
        if asked.scalar == "f64":
            timed = [t for t in timed if not t.method.startswith("promoted")]
        choice = decide(of(found, tolerance, need), timed, ENTRIES)
        chosen = choice.chosen
        assert chosen is not None  # an exact method is always among them
        mine = asked.which == index
        wrong = asked.wrong(chosen.name)[mine]
        beyond = asked.distance[mine][wrong]
        assert beyond.max(initial=0) <= chosen.bound.distance <= tolerance, chosen
        if need != "class":
            assert not wrong.any() and chosen.bound.exact
        taken[chosen.name] = taken.get(chosen.name, 0) + 1
    assert len(taken) > len(METHODS) / 2  # the test saw most of them
