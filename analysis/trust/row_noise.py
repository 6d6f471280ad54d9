"""Whether the time of one row may be believed to within TOLERANCE.

It may not where its median is not known that well, since the interval around it
reaches farther. (The slices of all repetitions of a shard's rows are shuffled
into each other, so no repetition is earlier than another and none can drift:
harness/measure/slices.h.)
"""

from __future__ import annotations

from analysis.trust.stats import Values, median_interval

# What a kernel timed twice may differ by, and with it all else that is judged
# here and in analysis/trust/noise.py. It is a choice, of what is small enough not to
# matter: methods that differ by less are not worth choosing between.
TOLERANCE = 0.03

WIDE = "wide"


def row_noise(values: Values) -> str:
    """Of the repetitions: why the row is noisy, empty if it is not."""
    time = median_interval(values)
    wide = max(time.high / time.value - 1, 1 - time.low / time.value) > TOLERANCE
    return WIDE if wide else ""
