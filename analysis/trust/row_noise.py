"""Whether the time of one row may be believed to within TOLERANCE.

Two ways in which it may not: its median is not known that well, since the
interval around it reaches farther; or it is the median of a time that was not
one, since the repetitions of the second half all take longer (or all shorter)
than those of the first, by more than that. Repetitions of all cells of a shard
are shuffled into each other, so those of one cell span the shard, and a row
that drifts while others do not is as much to be doubted as one that spreads.
"""

from __future__ import annotations

from analysis.trust.stats import CONFIDENCE, Values, median_interval, ratio_interval

# What a kernel timed twice may differ by, and with it all else that is judged
# here and in analysis/trust/noise.py. It is a choice, of what is small enough not to
# matter: methods that differ by less are not worth choosing between.
TOLERANCE = 0.03

WIDE = "wide"
DRIFTS = "drifts"


def row_noise(values: Values) -> str:
    """Of the repetitions as they ran: why the row is noisy, empty if it is not.

    Drift is told from chance by the interval of the ratio between the halves
    (the middle one of an odd number belongs to neither), and so not at all
    where there are too few repetitions for an interval of CONFIDENCE, which
    takes four in each half.
    """
    found = []
    time = median_interval(values)
    if max(time.high / time.value - 1, 1 - time.low / time.value) > TOLERANCE:
        found.append(WIDE)
    half = len(values) // 2
    if half:
        moved = ratio_interval(values[-half:], values[:half])
        apart = moved.low > 1 or moved.high < 1
        known = moved.coverage >= CONFIDENCE
        if known and apart and abs(moved.value - 1) > TOLERANCE:
            found.append(DRIFTS)
    return " and ".join(found)
