"""How long a sweep says that it is going to take."""

from __future__ import annotations

import pytest
from run_folder import Shard
from time_left import time_left, usual


def shard(name: str) -> Shard:
    return Shard(name, name.partition("-")[0], ())


TRIANGLE, POINT, PAIRS = map(
    shard, ("speed-one_triangle-f32", "speed-one_point-f32", "speed-pairs-f64")
)
EDGE, VERTEX = map(shard, ("accuracy-near_edge-f32", "accuracy-near_vertex-f64"))
LIMITS = shard("limits")


@pytest.mark.parametrize(
    ("seconds", "todo", "said"),
    [
        ({}, [TRIANGLE], "time left: unknown yet"),
        # They take as long in a sweep of seconds as in one of hours.
        ({LIMITS: 5.0}, [TRIANGLE], "time left: unknown yet"),
        ({POINT: 30.0}, [PAIRS], "about 30 s left"),
        ({POINT: 30.0}, [PAIRS] * 10, "about 5 min left"),
        (
            {TRIANGLE: 100.0},
            [POINT],
            f"about {100 * usual(POINT) / usual(TRIANGLE):.0f} s left",
        ),
        # Two at once; until one has run, as those that measure time did.
        (
            {POINT: 20.0},
            [EDGE] * 4,
            f"about {20 * usual(EDGE) / usual(POINT) * 4 / 2:.0f} s left",
        ),
        # Once one has run, its own time counts and not that of the others.
        ({POINT: 900.0, EDGE: 10.0}, [EDGE] * 8, "about 40 s left"),
        ({EDGE: 10.0, VERTEX: 700.0, POINT: 30.0}, [PAIRS], "about 30 s left"),
    ],
)
def test_it_follows_from_what_has_run(
    seconds: dict[Shard, float], todo: list[Shard], said: str
) -> None:
    assert time_left(seconds, todo, {}, 2) == said


def test_what_a_running_shard_has_done_is_not_left() -> None:
    first, second = shard("accuracy-scale-f32"), shard("accuracy-offset-f64")
    seconds = {EDGE: 10.0}
    assert time_left(seconds, [], {first: 4.0, second: 2.0}, 2) == "about 7 s left"
    # One that takes longer than the others says nothing about those.
    assert time_left(seconds, [first], {second: 50.0}, 1) == "about 10 s left"
