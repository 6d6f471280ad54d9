"""How long a sweep is going to take, by the shards of it that have run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from run_folder import ALONE, Shard

# Until one of the others has run: the time of a shard that shares the cores over
# that of one which measures time, as it came out in whole sweeps.
SHARING_SHARE = 0.25


def time_left(
    seconds: Mapping[str, Sequence[float]],
    todo: Sequence[Shard],
    running: Mapping[Shard, float],
    jobs: int,
) -> str:
    """In words. `seconds`: kind → what its shards took so far; `running`: shard →
    seconds since it started; `jobs`: how many shards that share run at once.
    """
    if not any(seconds.values()):
        return "time left: unknown yet"
    left = 0.0
    for shard in [*todo, *running]:
        one = _typical(seconds, shard) - running.get(shard, 0.0)
        left += max(one, 0.0) / (1 if shard.alone else jobs)
    return (
        f"about {left / 60:.0f} min left" if left >= 90 else f"about {left:.0f} s left"
    )


def _typical(seconds: Mapping[str, Sequence[float]], shard: Shard) -> float:
    """The mean of the shards of its kind; where none has run, of those that run
    alone as it does, or share as it does; else by what the one is of the other.
    """
    like = [
        t for kind in seconds if (kind in ALONE) == shard.alone for t in seconds[kind]
    ]
    known = seconds[shard.kind] or like
    if known:
        return sum(known) / len(known)
    every = [t for times in seconds.values() for t in times]
    share = 1 / SHARING_SHARE if shard.alone else SHARING_SHARE
    return share * sum(every) / len(every)
