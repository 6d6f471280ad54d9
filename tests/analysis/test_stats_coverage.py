"""The intervals do what they promise, on samples whose truth is known.

Timings as they come: a floor, an exponential tail of small delays, and now and
then an interruption that triples one. Seeds are fixed, so that a test holds or
fails for ever; the bounds allow four standard errors of a simulation.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt
import pytest

from analysis.trust.row_noise import row_noise
from analysis.trust.stats import median_interval, ratio_interval, wilson

TRIALS = 4000
REPETITIONS = 9
_TAIL, _INTERRUPTED = 0.01, 0.01


def timings(seed: int, factor: float = 1.0) -> npt.NDArray[np.float64]:
    """TRIALS × REPETITIONS times of work that takes 100 at the least."""
    chance = np.random.default_rng(seed)
    shape = (TRIALS, REPETITIONS)
    tail = chance.exponential(_TAIL, shape)
    stopped = chance.random(shape) < _INTERRUPTED
    return np.asarray(100 * factor * (1 + tail) * np.where(stopped, 3, 1))


def true_median() -> float:
    """Where (1 − interrupted)·(1 − exp(−x/tail)) is one half."""
    quantile = 0.5 / (1 - _INTERRUPTED)
    return 100 * (1 - _TAIL * math.log(1 - quantile))


def least(share: float) -> float:
    return share - 4 * math.sqrt(share * (1 - share) / TRIALS)


def test_the_interval_of_a_median_holds_the_true_one_as_often_as_it_says() -> None:
    found = [median_interval(row) for row in timings(1)]
    hits = sum(i.low <= true_median() <= i.high for i in found) / TRIALS
    promised = found[0].coverage
    assert (
        least(promised)
        <= hits
        <= promised + 4 * math.sqrt(promised * (1 - promised) / TRIALS)
    )


@pytest.mark.parametrize("factor", [1.0, 1.05, 2.0, 30.0])
def test_the_interval_of_a_ratio_holds_the_true_one_as_often_as_it_says(
    factor: float,
) -> None:
    tops, bottoms = timings(2, factor), timings(3)
    found = [ratio_interval(t, b) for t, b in zip(tops, bottoms)]
    hits = sum(i.low <= factor <= i.high for i in found) / TRIALS
    assert hits >= least(found[0].coverage)
    assert hits < 0.97  # and is not simply wide


def test_a_difference_between_identical_work_is_claimed_once_in_twenty() -> None:
    pairs = zip(timings(4), timings(5))
    found = [ratio_interval(a, b) for a, b in pairs]
    claimed = sum(i.low > 1 or i.high < 1 for i in found) / TRIALS
    assert 0.03 < claimed <= 1 - least(0.95)


def test_a_joint_interval_claims_it_in_no_more_than_one_of_twenty_runs() -> None:
    pairs_a_run = 20
    joint = 1 - 0.05 / pairs_a_run
    found = [ratio_interval(a, b, joint) for a, b in zip(timings(6), timings(7))]
    wrong = np.array([i.low > 1 or i.high < 1 for i in found])
    runs = wrong.reshape(-1, pairs_a_run).any(axis=1)
    assert runs.mean() <= 0.05 + 4 * math.sqrt(0.05 * 0.95 / len(runs))


def test_a_real_difference_is_not_missed() -> None:
    """Of 3 % nearly never, of twice the work never nearly."""
    three = [ratio_interval(t, b) for t, b in zip(timings(8, 1.03), timings(9))]
    assert sum(i.low > 1 for i in three) / TRIALS > 0.95
    twice = [ratio_interval(t, b) for t, b in zip(timings(10, 2.0), timings(11))]
    assert sum(i.low > 1 for i in twice) / TRIALS > 0.995


def test_a_steady_machine_has_hardly_a_noisy_row() -> None:
    """The tail alone is a third of the tolerance, and interruptions are rare."""
    noisy = sum(row_noise(row) != "" for row in timings(12)) / TRIALS
    assert noisy < 0.05


def test_rows_on_a_shared_core_are_noisy() -> None:
    """Half of the repetitions take up to twice as long."""
    chance = np.random.default_rng(13)
    shape = (TRIALS, REPETITIONS)
    shared = timings(14) * np.where(
        chance.random(shape) < 0.5, 1, 1 + chance.random(shape)
    )
    noisy = sum(row_noise(row) != "" for row in shared) / TRIALS
    assert noisy > 0.95


@pytest.mark.parametrize("rate", [1e-4, 0.01, 0.3])
def test_wilson_holds_the_true_share_about_as_often_as_it_says(rate: float) -> None:
    """Its coverage swings around 95 % with the rate; never far below."""
    counts = np.random.default_rng(15).binomial(20_000, rate, TRIALS)
    found = [wilson(int(count), 20_000) for count in counts]
    hits = sum(i.low <= rate <= i.high for i in found) / TRIALS
    assert 0.93 < hits < 0.985
