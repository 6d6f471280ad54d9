"""Statistics against published tables and hand calculation."""

from __future__ import annotations

import math

import pytest

from analysis.trust.stats import (
    benjamini_hochberg,
    median_interval,
    pareto_frontier,
    ratio_interval,
    ratio_p_value,
    wilson,
)


@pytest.mark.parametrize(
    ("n", "low", "high"),
    # Order statistics of the 95 % interval of a median, as in the tables of the
    # sign test (e.g. Conover, Practical Nonparametric Statistics, table A3).
    [(6, 1, 6), (9, 2, 8), (10, 2, 9), (15, 4, 12), (20, 6, 15), (25, 8, 18)],
)
def test_median_interval_takes_the_tabulated_order_statistics(
    n: int, low: int, high: int
) -> None:
    found = median_interval([float(i) for i in range(n, 0, -1)])
    assert (found.low, found.high) == (low, high)
    assert found.value == (n + 1) / 2


def test_median_interval_of_nine_covers_96_percent() -> None:
    assert median_interval(range(9)).coverage == 1 - 20 / 512


def test_median_interval_of_few_says_how_little_it_covers() -> None:
    found = median_interval([3.0, 1.0, 2.0])
    assert found[:3] == (2.0, 1.0, 3.0)
    assert found.coverage == 0.75
    assert median_interval([7.0]) == (7.0, 7.0, 7.0, 0.0)


@pytest.mark.parametrize("bad", [[], [math.nan], [1.0, math.inf]])
def test_median_of_nothing_or_of_no_number_is_refused(bad: list[float]) -> None:
    with pytest.raises(ValueError, match="finite"):
        median_interval(bad)


def test_ratio_is_the_median_of_all_quotients() -> None:
    # 2/1 4/1 8/1 2/2 4/2 8/2 = 1 2 2 4 4 8, whose median is 3.
    assert ratio_interval([2.0, 4.0, 8.0], [1.0, 2.0]).value == 3.0


@pytest.mark.parametrize(
    ("m", "n", "critical"),
    # Two-sided 5 % critical values of U, from the usual tables (Mann and
    # Whitney 1947; e.g. Siegel, Nonparametric Statistics, table K).
    [(5, 5, 2), (6, 6, 5), (7, 7, 8), (8, 8, 13), (8, 9, 15), (9, 9, 17), (10, 10, 23)],
)
def test_ratio_interval_uses_the_tabulated_critical_value(
    m: int, n: int, critical: int
) -> None:
    # Values whose quotients are all different, so that each end tells its rank.
    top = [1.0 + 0.1 * i for i in range(m)]
    bottom = [math.e ** (0.0003 * j * j) for j in range(n)]
    quotients = sorted(t / b for t in top for b in bottom)
    found = ratio_interval(top, bottom)
    assert found.low == pytest.approx(quotients[critical])
    assert found.high == pytest.approx(quotients[-1 - critical])
    assert found.coverage >= 0.95


def test_ratio_of_equal_samples_contains_one() -> None:
    times = [1.0, 1.1, 1.05, 1.2, 1.02, 1.01, 1.3, 1.04, 1.06]
    found = ratio_interval(times, times)
    assert found.value == 1.0
    assert found.low < 1.0 < found.high


def test_ratio_turned_round_is_the_inverse() -> None:
    one, two = [1.0, 1.2, 1.1, 1.4, 1.3], [2.0, 2.1, 2.5, 2.2, 2.3]
    there, back = ratio_interval(one, two), ratio_interval(two, one)
    assert there.low == pytest.approx(1 / back.high)
    assert there.value == pytest.approx(1 / back.value)


@pytest.mark.parametrize(
    ("count", "of", "low", "high"),
    # Newcombe 1998, Statistics in Medicine 17, table I, method 3.
    [
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 20, 0.0, 0.1611),
        (1, 29, 0.0061, 0.1718),
    ],
)
def test_wilson_gives_newcombes_published_intervals(
    count: int, of: int, low: float, high: float
) -> None:
    found = wilson(count, of)
    assert found.value == count / of
    assert found.low == pytest.approx(low, abs=5e-5)
    assert found.high == pytest.approx(high, abs=5e-5)


def test_wilson_of_all_mirrors_that_of_none() -> None:
    assert wilson(20, 20).low == pytest.approx(1 - wilson(0, 20).high)
    assert wilson(20, 20).high == 1.0


def test_wilson_of_nothing_knows_nothing() -> None:
    found = wilson(0, 0)
    assert math.isnan(found.value)
    assert (found.low, found.high) == (0.0, 1.0)


@pytest.mark.parametrize(("count", "of"), [(-1, 5), (6, 5)])
def test_wilson_refuses_what_is_no_share(count: int, of: int) -> None:
    with pytest.raises(ValueError, match="a share of"):
        wilson(count, of)


def test_frontier_keeps_what_nothing_beats() -> None:
    speed = [1.0, 2.0, 3.0, 2.0, 4.0]
    error = [0.0, 0.1, 0.2, 0.3, 0.2]
    #        best  kept  slower than the last at equal error; worse twice; fastest
    assert pareto_frontier(speed, error) == [True, True, False, False, True]


def test_frontier_keeps_equals_together() -> None:
    assert pareto_frontier([1.0, 1.0], [0.5, 0.5]) == [True, True]


def test_unknown_error_is_never_on_the_frontier_and_beats_nothing() -> None:
    assert pareto_frontier([9.0, 1.0], [math.nan, 0.5]) == [False, True]


def shifted(u: int) -> list[float]:
    """Nine values of which exactly `u` of 81 pairs with 0.5, 1.5, … 8.5 win."""
    full, rest = divmod(u, 9)
    tail = [-1.0 - i for i in range(9 - full - (rest > 0))]
    return [10.0 + i for i in range(full)] + [float(rest)] * (rest > 0) + tail


def test_p_values_follow_the_tables_of_mann_and_whitney() -> None:
    """For nine and nine U = 17 is the critical value of 5 % on two sides."""
    others = [0.5 + i for i in range(9)]
    above = [v + 100 for v in others]  # ratios need positive values
    assert ratio_p_value([v + 100 for v in shifted(81 - 17)], above) <= 0.05
    assert ratio_p_value([v + 100 for v in shifted(81 - 18)], above) > 0.05


def test_p_value_of_samples_wholly_apart_is_two_in_all_orders() -> None:
    low, high = [1.0 + i / 100 for i in range(9)], [2.0 + i / 100 for i in range(9)]
    assert ratio_p_value(high, low) == pytest.approx(2 / math.comb(18, 9))
    assert ratio_p_value(low, high) == ratio_p_value(high, low)


def test_p_value_of_equal_samples_is_one() -> None:
    assert ratio_p_value([3.0] * 9, [3.0] * 9) == 1.0


def test_p_value_counts_only_what_lies_beyond_the_band() -> None:
    low, high = [1.0 + i / 1000 for i in range(9)], [1.04 + i / 1000 for i in range(9)]
    assert ratio_p_value(high, low, 0.02) == pytest.approx(2 / math.comb(18, 9))
    assert ratio_p_value(high, low, 0.06) == 1.0
    assert ratio_p_value(low, high, 0.06) == 1.0


def test_false_discovery_rate_follows_its_authors_example() -> None:
    """Benjamini and Hochberg (1995), section 3.2: four of fifteen at 5 %."""
    values = [0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344]
    values += [0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.0000]
    adjusted = benjamini_hochberg(values)
    assert [a <= 0.05 for a in adjusted] == [True] * 4 + [False] * 11
    assert adjusted[0] == pytest.approx(0.0015)
    assert benjamini_hochberg(values[::-1]) == adjusted[::-1]
    assert benjamini_hochberg([]) == []
