"""Whether a run may be believed.

One tolerance, and several ways of leaving it. Pairs of rows of which the ratio
is known must come out at it (analysis/trust/controls.py); the clock must not move by
more between the start and the end of a shard, nor lie further from that of the
other shards; what the CPU does in a cycle, measured beside the clock, which a
neighbour on the same core's ports lowers, must not either; no more of the time
may have been stolen by the hypervisor or given to other processes of the core,
since a share s of lost time alone makes a repetition longer by s; most slices
must have been timed while nobody else used the core (harness/measure/quiet.h);
and no more of a shard's rows may be noisy by
themselves than can be on a quiet machine.
"""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pandas as pd

from analysis.read.cells import DOUBLED, TWIN
from analysis.read.run import Shard
from analysis.speed.tables import speed_cells
from analysis.trust.controls import control_pairs
from analysis.trust.row_noise import TOLERANCE

__all__ = ["MOST_NOISY_ROWS", "TOLERANCE", "Reason", "Verdict", "judge"]

# A noisy row is marked, so a few do no harm; and some are wide on the quietest
# machine, since each repetition takes other calls, and some methods' time hangs
# on them: one in ten in a full run of which 98 % was undisturbed, one in six of
# a shard of rays. Where one in four is, there is more to it.
MOST_NOISY_ROWS = 0.25

# A repetition takes the fastest of several passes, so with half of the slices
# undisturbed nearly each has an undisturbed pass; with fewer, many have none.
LEAST_QUIET_SHARE = 0.5


@dataclasses.dataclass(frozen=True)
class Reason:
    shard: str
    text: str


@dataclasses.dataclass(frozen=True)
class Verdict:
    """noisy: some shard left the tolerance. judged: there was an A/A pair."""

    noisy: bool
    judged: bool
    reasons: tuple[Reason, ...]
    shards: pd.DataFrame
    pairs: pd.DataFrame
    rows: int  # the timed cells, controls left out
    noisy_rows: int

    @property
    def word(self) -> str:
        return "noisy" if self.noisy else ("quiet" if self.judged else "not judged")


def judge(
    speed: pd.DataFrame,
    shards: tuple[Shard, ...],
    cells: pd.DataFrame | None = None,
) -> Verdict:
    """The noise verdict of a run, with a reason for each shard that fails.
    `cells`: tables.speed_cells of the same rows, if they are there already.
    """
    cells = speed_cells(speed) if cells is None else cells
    every = control_pairs(speed)
    clock = float(np.median([_clock(shard) for shard in shards]))
    work = np.array([_work_a_cycle(shard) for shard in shards])
    usual = float(np.median(work[np.isfinite(work)])) if np.isfinite(work).any() else 1
    reasons: list[Reason] = []
    rows = []
    for shard in shards:
        pairs = every[every["shard"] == shard.name]
        own = cells[cells["shard"] == shard.name]
        noisy = int((own["noise"] != "").sum())
        found = [
            *_pair_reasons(pairs),
            *_clock_reasons(shard, clock),
            *_throughput_reasons(shard, usual),
            *_lost_time_reasons(shard),
            *_quiet_reasons(shard),
        ]
        if noisy > MOST_NOISY_ROWS * len(own):
            found.append(
                f"{noisy} of {len(own)} rows are noisy by themselves "
                f"(more than {100 * MOST_NOISY_ROWS:.0f} %)"
            )
        reasons += [Reason(shard.name, text) for text in found]
        twins = pairs[pairs["control"] == TWIN]["ratio"]
        doubled = pairs[pairs["control"] == DOUBLED]["ratio"]
        width = (own["ns_high"] - own["ns_low"]) / own["ns"]
        rows.append(
            {
                "shard": shard.name,
                "cpu": shard.cpu,
                "clock_before_ghz": shard.clock_before_ghz,
                "clock_after_ghz": shard.clock_after_ghz,
                "quiet_share": shard.quiet_share,
                "clock_drift": shard.clock_after_ghz / shard.clock_before_ghz - 1,
                "steal_percent": shard.steal_percent,
                "cpu_share": _cpu_share(shard),
                "preemptions": shard.preemptions,
                "load_average": shard.load_average,
                "pairs": len(twins),
                "smallest_ratio": twins.min(),
                "largest_ratio": twins.max(),
                "smallest_doubled": doubled.min(),
                "largest_doubled": doubled.max(),
                "interval_width": width.median(),
                "rows": len(own),
                "noisy_rows": noisy,
                "verdict": "noisy" if found else "quiet" if len(twins) else "no pair",
            }
        )
    return Verdict(
        noisy=bool(reasons),
        judged=bool((every["control"] == TWIN).any()),
        reasons=tuple(reasons),
        shards=pd.DataFrame(rows),
        pairs=every,
        rows=len(cells),
        noisy_rows=int((cells["noise"] != "").sum()),
    )


def _pair_reasons(pairs: pd.DataFrame) -> list[str]:
    return [
        f"{trouble}, for {name}"
        for name, trouble in zip(pairs["name"], pairs["trouble"])
        if trouble
    ]


def _clock_reasons(shard: Shard, clock: float) -> list[str]:
    found = []
    drift = shard.clock_after_ghz / shard.clock_before_ghz - 1
    if abs(drift) > TOLERANCE:
        found.append(
            f"the clock went from {shard.clock_before_ghz:.2f} to "
            f"{shard.clock_after_ghz:.2f} GHz ({100 * drift:+.1f} %)"
        )
    apart = _clock(shard) / clock - 1
    if abs(apart) > TOLERANCE:
        found.append(
            f"its clock, {_clock(shard):.2f} GHz, is {100 * apart:+.1f} % off the "
            f"{clock:.2f} GHz of the run"
        )
    return found


def _throughput_reasons(shard: Shard, usual: float) -> list[str]:
    """`usual`: the median of the run's shards. Nothing where a file does not
    tell: a comparison with NaN does not hold.
    """
    found = []
    change = _work_after(shard) / _work_before(shard) - 1
    if abs(change) > TOLERANCE:
        found.append(
            f"from its start to its end the CPU came to do {100 * change:+.1f} % in a "
            "cycle, as beside a neighbour that uses the same core"
        )
    apart = _work_a_cycle(shard) / usual - 1
    if abs(apart) > TOLERANCE:
        found.append(
            f"the CPU did {100 * apart:+.1f} % in a cycle, against the other shards"
        )
    return found


def _work_before(shard: Shard) -> float:
    return shard.throughput_before_gops / shard.clock_before_ghz


def _work_after(shard: Shard) -> float:
    return shard.throughput_after_gops / shard.clock_after_ghz


def _work_a_cycle(shard: Shard) -> float:
    return (_work_before(shard) + _work_after(shard)) / 2


def _lost_time_reasons(shard: Shard) -> list[str]:
    found = []
    if shard.steal_percent > 100 * TOLERANCE:
        found.append(
            f"the hypervisor took {shard.steal_percent:.1f} % of the time "
            f"(more than {100 * TOLERANCE:.0f} %)"
        )
    if _cpu_share(shard) < 1 - TOLERANCE:
        found.append(
            f"it had its CPU for {100 * _cpu_share(shard):.1f} % of the time only, "
            f"and was interrupted {shard.preemptions:.0f} times: other processes "
            "ran on the same core"
        )
    return found


def _quiet_reasons(shard: Shard) -> list[str]:
    if not shard.quiet_share < LEAST_QUIET_SHARE:  # nor where a file does not tell
        return []
    return [
        f"only {100 * shard.quiet_share:.0f} % of its slices were timed while nobody "
        f"else used the core (less than {100 * LEAST_QUIET_SHARE:.0f} %)"
    ]


def _cpu_share(shard: Shard) -> float:
    """NaN if the shard's file does not tell."""
    known = math.isfinite(shard.wall_seconds)
    return shard.cpu_seconds / shard.wall_seconds if known else math.nan


def _clock(shard: Shard) -> float:
    return (shard.clock_before_ghz + shard.clock_after_ghz) / 2
