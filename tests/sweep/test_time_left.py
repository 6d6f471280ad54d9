"""How long a sweep says that it is going to take."""

from __future__ import annotations

import pytest
from run_folder import KINDS, Shard
from time_left import SHARING_SHARE, time_left


def shards(kind: str, count: int) -> list[Shard]:
    return [Shard(f"{kind}-{i}", kind, ()) for i in range(count)]


def known(**seconds: list[float]) -> dict[str, list[float]]:
    return {kind: seconds.get(kind, []) for kind in KINDS}


@pytest.mark.parametrize(
    ("seconds", "todo", "said"),
    [
        (known(), shards("speed", 3), "time left: unknown yet"),
        (known(speed=[10.0, 20.0]), shards("speed", 4), "about 60 s left"),
        (known(speed=[10.0, 20.0]), shards("speed", 20), "about 5 min left"),
        # Two at once, each a share of one that measures time.
        (
            known(speed=[10.0]),
            shards("accuracy", 20),
            f"about {20 * 10 * SHARING_SHARE / 2:.0f} s left",
        ),
        # Once one has run, its own time counts and nothing is supposed.
        (known(speed=[100.0], accuracy=[2.0]), shards("maps", 8), "about 8 s left"),
        (
            known(accuracy=[2.0]),
            shards("speed", 4),
            f"about {8 / SHARING_SHARE:.0f} s left",
        ),
        (known(limits=[20.0]), shards("speed", 2), "about 40 s left"),
    ],
)
def test_it_follows_from_what_has_run(
    seconds: dict[str, list[float]], todo: list[Shard], said: str
) -> None:
    assert time_left(seconds, todo, {}, 2) == said


def test_what_a_running_shard_has_done_is_not_left() -> None:
    first, second = shards("accuracy", 2)
    seconds = known(accuracy=[10.0])
    assert time_left(seconds, [], {first: 4.0, second: 2.0}, 2) == "about 7 s left"
    # One that takes longer than the others says nothing about those.
    assert time_left(seconds, [first], {second: 50.0}, 1) == "about 10 s left"
