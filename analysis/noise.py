"""Whether a run may be believed.

One tolerance, three ways of leaving it. A kernel registered twice must come
out equal within TOLERANCE (A/A); the clock must not move by more between the
start and the end of a shard, nor lie further from that of the other shards;
and no more of the time may have been stolen by the hypervisor, since a share
s of stolen time alone makes a repetition longer by s.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pandas as pd

from analysis.run import Shard
from analysis.stats import median_interval, ratio_interval
from analysis.tables import samples

TOLERANCE = 0.03


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
    twins: pd.DataFrame

    @property
    def word(self) -> str:
        return "noisy" if self.noisy else ("quiet" if self.judged else "not judged")


def twin_ratios(speed: pd.DataFrame) -> pd.DataFrame:
    """One row an A/A pair: the twin's time over that of the first."""
    by_cell = samples(speed)
    rows = []
    for (shard, name), own in by_cell.items():
        base = by_cell.get((shard, name.removesuffix("/twin")))
        if name.endswith("/twin") and base is not None:
            ratio = ratio_interval(own, base)
            rows.append(
                {
                    "shard": shard,
                    "name": name.removesuffix("/twin"),
                    "ratio": ratio.value,
                    "ratio_low": ratio.low,
                    "ratio_high": ratio.high,
                    "within": abs(ratio.value - 1) <= TOLERANCE,
                }
            )
    columns = ["shard", "name", "ratio", "ratio_low", "ratio_high", "within"]
    return pd.DataFrame(rows, columns=columns)


def judge(speed: pd.DataFrame, shards: tuple[Shard, ...]) -> Verdict:
    """The noise verdict of a run, with a reason for each shard that fails."""
    twins = twin_ratios(speed)
    clock = float(np.median([_clock(shard) for shard in shards]))
    spreads = _interval_widths(speed)
    reasons: list[Reason] = []
    rows = []
    for shard in shards:
        pairs = twins[twins["shard"] == shard.name]
        found = [*_pair_reasons(pairs), *_clock_reasons(shard, clock)]
        if shard.steal_percent > 100 * TOLERANCE:
            found.append(
                f"the hypervisor took {shard.steal_percent:.1f} % of the time "
                f"(more than {100 * TOLERANCE:.0f} %)"
            )
        reasons += [Reason(shard.name, text) for text in found]
        rows.append(
            {
                "shard": shard.name,
                "cpu": shard.cpu,
                "clock_before_ghz": shard.clock_before_ghz,
                "clock_after_ghz": shard.clock_after_ghz,
                "clock_drift": shard.clock_after_ghz / shard.clock_before_ghz - 1,
                "steal_percent": shard.steal_percent,
                "load_average": shard.load_average,
                "pairs": len(pairs),
                "smallest_ratio": pairs["ratio"].min(),
                "largest_ratio": pairs["ratio"].max(),
                "interval_width": spreads.get(shard.name, np.nan),
                "verdict": "noisy" if found else "quiet" if len(pairs) else "no pair",
            }
        )
    return Verdict(
        bool(reasons), len(twins) > 0, tuple(reasons), pd.DataFrame(rows), twins
    )


def _pair_reasons(pairs: pd.DataFrame) -> list[str]:
    return [
        f"the same kernel timed twice differs: A/A ratio {pair.ratio:.3f} "
        f"(outside {1 - TOLERANCE:.2f} to {1 + TOLERANCE:.2f}) for {pair.name_}"
        for pair in pairs.rename(columns={"name": "name_"}).itertuples()
        if not pair.within
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


def _clock(shard: Shard) -> float:
    return (shard.clock_before_ghz + shard.clock_after_ghz) / 2


def _interval_widths(speed: pd.DataFrame) -> dict[str, float]:
    """Shard → the median over its cells of (high − low) / median."""
    widths: dict[str, list[float]] = {}
    for (shard, _), own in samples(speed).items():
        interval = median_interval(own)
        width = (interval.high - interval.low) / interval.value
        widths.setdefault(shard, []).append(width)
    return {shard: float(np.median(values)) for shard, values in widths.items()}
