"""Medians, ratios, shares and frontiers, each with the interval it deserves.

Timings of one kernel are skewed (interruptions only ever add time) and few
(nine repetitions), so nothing here assumes a normal distribution: intervals
come from order statistics, whose coverage is exact for any continuous
distribution. All functions are pure; none draws random numbers.
"""

from __future__ import annotations

import functools
import math
from collections.abc import Sequence
from statistics import NormalDist
from typing import NamedTuple

import numpy as np
import numpy.typing as npt

CONFIDENCE = 0.95

Values = Sequence[float] | npt.NDArray[np.float64]


class Interval(NamedTuple):
    """An estimate and the interval around it, which has this `coverage`."""

    value: float
    low: float
    high: float
    coverage: float


def median_interval(values: Values) -> Interval:
    """The median and its interval from the k-th smallest to the k-th largest.

    The median of the distribution lies below the k-th smallest of n values
    with probability P(Binomial(n, 1/2) < k), whatever the distribution; the
    largest k that keeps CONFIDENCE is taken. n = 9 gives the 2nd and the 8th
    value and a coverage of 1 − 2·(1 + 9)/2⁹ = 96.1 %. Below n = 6 no k is
    enough; the interval is then from the smallest to the largest value, and
    `coverage` says how little that is.
    """
    ordered = _ordered(values)
    k, coverage = _median_rank(len(ordered))
    return Interval(
        _middle(ordered), float(ordered[k - 1]), float(ordered[-k]), coverage
    )


def ratio_interval(
    top: Values, bottom: Values, confidence: float = CONFIDENCE
) -> Interval:
    """How many times as large `top` is as `bottom`, from repeated timings.

    The estimate is the median of all len(top)·len(bottom) quotients (Hodges
    and Lehmann 1963, on logarithms), the interval runs from the k-th smallest
    to the k-th largest quotient, with k from the exact distribution of the
    Mann-Whitney statistic: P(U < k) ≤ 2.5 %. For 9 and 9 repetitions k = 18
    (the tables' critical value 17, plus one).

    Why not pairs by repetition: the slices of all cells of a shard are shuffled
    into each other, so the i-th of one cell and the i-th of another are not
    neighbours in time, and what the shuffle does give is two independent
    samples from the same stretch of time. That is what this method needs, and
    the reason why both must come from one shard. Why not a bootstrap: at nine
    values the bootstrap interval of a median covers too little.

    Where even the widest interval, from the smallest to the largest quotient,
    has less than `confidence`, it is given, and `coverage` says so.
    """
    tops, bottoms = _ordered(top), _ordered(bottom)
    quotients = np.sort((tops[:, None] / bottoms[None, :]).ravel())
    k, coverage = _ratio_rank(len(tops), len(bottoms), confidence)
    return Interval(
        _middle(quotients), float(quotients[k - 1]), float(quotients[-k]), coverage
    )


def wilson(count: int, of: int, confidence: float = CONFIDENCE) -> Interval:
    """The share count/of and its score interval (Wilson 1927).

    Keeps its coverage near 0 and 1, where error rates live: 0 of n gives
    [0, z²/(n + z²)]. Nothing counted (of = 0) gives NaN in [0, 1].
    """
    if not 0 <= count <= of:
        raise ValueError(f"a share of {count} in {of}")
    if of == 0:
        return Interval(math.nan, 0.0, 1.0, confidence)
    z = _normal_quantile((1 + confidence) / 2)
    share = count / of
    centre = share + z * z / (2 * of)
    spread = z * math.sqrt(share * (1 - share) / of + z * z / (4 * of * of))
    scale = 1 + z * z / of
    low = 0.0 if count == 0 else (centre - spread) / scale
    high = 1.0 if count == of else (centre + spread) / scale
    return Interval(share, low, high, confidence)


def ratio_p_value(top: Values, bottom: Values, within: float = 0.0) -> float:
    """How likely samples at least as far apart are if `top` is at most 1 + within
    times `bottom` and `bottom` at most 1 + within times `top`.

    Two exact Mann-Whitney tests, one for each way of being apart, of `top`
    against `bottom` moved by as much as may be; the smaller probability twice
    (Bonferroni), at most 1. It is the test whose interval ratio_interval gives:
    with within = 0 it is below 1 − coverage where that leaves out 1. Equal
    values count for neither side, which errs towards no difference. Below four
    values on each side it cannot come out below 5 %.
    """
    tops, bottoms = _ordered(top), _ordered(bottom)
    counts = _mann_whitney_counts(len(tops), len(bottoms))
    total = sum(counts)

    def above(high: npt.NDArray[np.float64], low: npt.NDArray[np.float64]) -> float:
        u = int((high[:, None] > (1 + within) * low[None, :]).sum())
        return sum(counts[u:]) / total

    return min(1.0, 2 * above(tops, bottoms), 2 * above(bottoms, tops))


def benjamini_hochberg(p_values: Sequence[float]) -> list[float]:
    """The smallest share of false claims at which each would be among those
    made (Benjamini and Hochberg 1995): claiming all with a value of at most
    `level` keeps the expected share of false claims among them below `level`,
    and, where nothing differs, the chance of any claim at all.

    Why not Holm, which keeps the chance of a single false claim: with nine
    repetitions each no test gives less than 2 / C(18, 9) = 4·10⁻⁵, and Holm
    asks its first of 2500 cells for 2·10⁻⁵, so it would never claim anything.
    """
    n = len(p_values)
    adjusted = [1.0] * n
    least = 1.0
    order = sorted(range(n), key=lambda i: p_values[i], reverse=True)
    for rank, index in zip(range(n, 0, -1), order):
        least = min(least, p_values[index] * n / rank)
        adjusted[index] = least
    return adjusted


def pareto_frontier(gain: Sequence[float], cost: Sequence[float]) -> list[bool]:
    """Which entries no other beats: more gain at no more cost, or as much gain
    at less cost. Equal entries do not beat each other. An entry with NaN is
    not on the frontier and beats nothing.
    """
    pairs = list(zip(gain, cost, strict=True))

    def beaten(g: float, c: float) -> bool:
        return any(
            (other_g > g and other_c <= c) or (other_g >= g and other_c < c)
            for other_g, other_c in pairs
        )

    return [not (math.isnan(g) or math.isnan(c)) and not beaten(g, c) for g, c in pairs]


def _ordered(values: Values) -> npt.NDArray[np.float64]:
    ordered = np.sort(np.asarray(values, dtype=np.float64))
    if len(ordered) == 0 or not np.all(np.isfinite(ordered)):
        raise ValueError("needs at least one value, all of them finite")
    return ordered


def _middle(ordered: npt.NDArray[np.float64]) -> float:
    """The median of values in order."""
    n = len(ordered)
    return float((ordered[(n - 1) // 2] + ordered[n // 2]) / 2)


_normal_quantile = functools.cache(NormalDist().inv_cdf)


@functools.cache
def _median_rank(n: int) -> tuple[int, float]:
    """The k of median_interval(), and the interval's coverage."""
    tail, chosen = 0.0, (1, 1 - 2 / 2**n)
    for k in range(1, n // 2 + 1):
        tail += math.comb(n, k - 1) / 2**n
        if 1 - 2 * tail < CONFIDENCE:
            break
        chosen = (k, 1 - 2 * tail)
    return chosen


@functools.cache
def _ratio_rank(m: int, n: int, confidence: float) -> tuple[int, float]:
    """The k of ratio_interval() for m and n values, and the coverage."""
    counts = _mann_whitney_counts(m, n)
    total = sum(counts)
    k, tail, coverage = 1, 0, 1 - 2 * counts[0] / total
    for candidate in range(1, m * n // 2 + 1):
        tail += counts[candidate - 1]
        if 2 * tail > (1 - confidence) * total:
            break
        k, coverage = candidate, 1 - 2 * tail / total
    return k, max(coverage, 0.0)


@functools.cache
def _mann_whitney_counts(m: int, n: int) -> list[int]:
    """How many of the orderings of m and n values have U = 0, 1, …, m·n.

    Coefficients of the Gaussian binomial Π (1 − q^(n+i)) / (1 − q^i).
    """
    counts = [1] + [0] * (m * n)
    for i in range(1, m + 1):
        for u in range(m * n, n + i - 1, -1):
            counts[u] -= counts[u - n - i]
        for u in range(i, m * n + 1):
            counts[u] += counts[u - i]
    return counts
