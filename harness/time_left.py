"""How long a sweep is going to take, by the shards of it that have run."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from run_folder import Shard

# What shards take beside each other: the name's beginning and the seconds, as
# they came out in whole sweeps (profile full; of those that share the cores half
# as much again, as quick spares them less). The first that matches counts.
USUAL = (
    ("limits", 6.0),
    ("speed-one_triangle-", 250.0),
    ("speed-(one_point|pairs)-", 150.0),
    ("speed-", 15.0),
    ("accuracy-mesh-", 120.0),
    ("accuracy-(near_edge|needle|offset|scale|exponent_spread)-", 60.0),
    ("accuracy-(cancellation|whole_numbers)-", 60.0),
    ("accuracy-special-", 35.0),
    ("accuracy-rays_(near_edge|near_vertex|special)-", 24.0),
    ("accuracy-(rays_)?(uniform|grid|corpus|icosphere|tiled)", 2.5),
    ("accuracy-", 10.0),
    ("instructions", 180.0),
    ("", 3.0),
)


def usual(shard: Shard) -> float:
    """Seconds, of which only the ratios of two shards mean anything."""
    return next(seconds for name, seconds in USUAL if re.match(name, shard.name))


def time_left(
    seconds: Mapping[Shard, float],
    todo: Sequence[Shard],
    running: Mapping[Shard, float],
    jobs: int,
) -> str:
    """In words. `seconds`: what those that have run took; `running`: seconds since
    they started; `jobs`: how many of the shards that share the cores run at once.
    """
    # The limits take as long in every profile, and so tell nothing of the others.
    telling = {s: t for s, t in seconds.items() if s.kind != "limits"}
    if not telling:
        return "time left: unknown yet"
    left = 0.0
    for shard in [*todo, *running]:
        like = [s for s in telling if s.alone == shard.alone] or list(telling)
        pace = sum(telling[s] for s in like) / sum(usual(s) for s in like)
        one = pace * usual(shard) - running.get(shard, 0.0)
        left += max(one, 0.0) / (1 if shard.alone else jobs)
    return (
        f"about {left / 60:.0f} min left" if left >= 90 else f"about {left:.0f} s left"
    )
