"""A row is noisy for a reason that one can see in its repetitions."""

from __future__ import annotations

from analysis.trust.row_noise import TOLERANCE, row_noise

STEADY = [4.0, 4.05, 3.98, 4.02, 4.06, 3.99, 4.01, 4.03, 4.04]


def test_a_steady_row_is_not_noisy() -> None:
    assert row_noise(STEADY) == ""


def test_the_interval_may_not_reach_beyond_the_tolerance() -> None:
    # The interval of nine is from the second to the second last.
    inside, outside = 1 + 0.9 * TOLERANCE, 1 + 1.1 * TOLERANCE
    assert row_noise([1.0] * 7 + [inside] * 2) == ""
    assert row_noise([1.0] * 7 + [outside] * 2) == "wide"
    assert row_noise([1.0, 1.0, 0.96, 1.0, 1.0, 0.96, 1.0, 1.0, 1.0]) == "wide"


def test_one_interruption_is_no_noise() -> None:
    """Nine repetitions and a median are there to bear it."""
    assert row_noise([*STEADY[:8], 9.0]) == ""


def test_a_single_repetition_tells_nothing() -> None:
    assert row_noise([1.0]) == ""
