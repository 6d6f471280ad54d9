"""The pairs of rows of which one knows what to expect: the same kernel timed
twice (A/A), whose ratio is 1, and the same work done twice over, whose ratio
is 2. Two failures have names here: claiming a difference between identical
work, and missing a real one.
"""

from __future__ import annotations

import pandas as pd

from analysis.read.cells import DOUBLED, TWIN
from analysis.speed.tables import samples
from analysis.trust.row_noise import TOLERANCE
from analysis.trust.stats import CONFIDENCE, Interval, ratio_interval

EXPECTED = {TWIN: 1.0, DOUBLED: 2.0}
# Where its arrays lie makes two timings of a kernel differ by some tenths of a
# percent for good. Less than this is no difference to be claimed or missed.
NEGLIGIBLE = 0.005
# A call that reads so much is the only one of its scene, so of two the second
# finds in the last cache some of what the first left. Such pairs, which are in
# runs of older revisions (harness/measure/speed.cc), have no known ratio.
LONG_CALL_BYTES = 1 << 24
TITLES = {TWIN: "A/A", DOUBLED: "2×"}
COLUMNS = ["shard", "name", "control", "expected", "ratio", "ratio_low"]
COLUMNS += ["ratio_high", "coverage", "trouble"]


def control_pairs(speed: pd.DataFrame) -> pd.DataFrame:
    """One row a pair: the control's time over that of the plain row, and what
    is the trouble with it (empty: none).

    An A/A pair must come out within TOLERANCE of 1, and its interval hold 1, or
    miss it by no more than NEGLIGIBLE. Intervals of CONFIDENCE each would
    exclude it once in twenty pairs, so in nearly every run; these are so wide
    that with CONFIDENCE all of a run's intervals hold it at once (Bonferroni):
    of m pairs each has a coverage of 1 − (1 − CONFIDENCE)/m. A doubled pair must
    come out within TOLERANCE of 2, and its interval, which is like those of all
    other ratios, exclude 1.
    """
    long = speed["working_set_bytes"] >= LONG_CALL_BYTES
    speed = speed[~(long & (speed["control"] == DOUBLED))]
    by_cell = samples(speed[speed["name"].isin(_with_bases(speed))])
    found = []
    for (shard, name), own in by_cell.items():
        plain, _, control = name.rpartition("/")
        base = by_cell.get((shard, plain))
        if control in EXPECTED and base is not None:
            found.append((shard, plain, control, own, base))
    twins = sum(control == TWIN for _, _, control, _, _ in found)
    confidence = {TWIN: 1 - (1 - CONFIDENCE) / max(twins, 1), DOUBLED: CONFIDENCE}
    rows = []
    for shard, plain, control, own, base in found:
        ratio = ratio_interval(own, base, confidence[control])
        row = {
            "shard": shard,
            "name": plain,
            "control": control,
            "expected": EXPECTED[control],
            "ratio": ratio.value,
            "ratio_low": ratio.low,
            "ratio_high": ratio.high,
            "coverage": ratio.coverage,
            "trouble": _trouble(control, ratio),
        }
        rows.append(row)
    return pd.DataFrame(rows, columns=COLUMNS)


def _with_bases(speed: pd.DataFrame) -> set[str]:
    """The names of the controls and of the rows they belong to."""
    controls = set(speed[speed["control"].isin(EXPECTED)]["name"])
    return controls | {name.rpartition("/")[0] for name in controls}


def _trouble(control: str, ratio: Interval) -> str:
    expected = EXPECTED[control]
    seen = f"ratio {ratio.value:.3f}, {ratio.low:.3f} to {ratio.high:.3f}"
    least, most = expected * (1 - TOLERANCE), expected * (1 + TOLERANCE)
    holds_one = ratio.low <= 1 <= ratio.high
    reaches_one = ratio.low <= 1 + NEGLIGIBLE and ratio.high >= 1 - NEGLIGIBLE
    within = least <= ratio.value <= most
    outside = f"(outside {least:.2f} to {most:.2f})"
    if control == TWIN and not reaches_one:
        return f"a difference is seen between identical work: A/A {seen}"
    if control == TWIN and not within:
        return f"the same kernel timed twice differs: A/A {seen} {outside}"
    if control == DOUBLED and holds_one:
        return f"a real difference is missed: of twice the work the {seen}"
    if control == DOUBLED and not within:
        return f"twice the work does not take twice the time: {seen} {outside}"
    return ""
