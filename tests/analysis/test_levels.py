"""How much of a set that is read over and over comes from which level."""

from __future__ import annotations

import pytest

from analysis.read.limits import Limits
from tests.analysis.test_bounds import machine  # noqa: F401

L1, L2, L3 = 49152, 1 << 20, 1 << 25  # bytes


@pytest.mark.parametrize(
    ("size", "shares"),
    [
        (1, {"L1": 1}),
        (L1, {"L1": 1}),
        (L1 * 1.25, {"L1": 1, "L2": 0.25}),
        (L1 * 2, {"L1": 1, "L2": 1}),
        (L1 + L2, {"L1": 1, "L2": 1}),
        ((L1 + L2) * 1.5, {"L1": 1, "L2": 1, "L3": 0.5}),
        (L1 + L2 + L3, {"L1": 1, "L2": 1, "L3": 1}),
        (1e15, {"L1": 1, "L2": 1, "L3": 1, "DRAM": 1}),
    ],
)
def test_what_nearer_levels_cannot_hold_comes_from_farther(
    machine: Limits, size: float, shares: dict[str, float]  # noqa: F811
) -> None:
    assert machine.shares(size) == pytest.approx(shares)


# L1 reads twice as much a cycle as L2, and L2 as L3.
@pytest.mark.parametrize(
    ("size", "level", "of_l1"),
    [
        (L1 * 1.25, "L1", 1),
        (L1 * 1.75, "L2", 1 / 2 / 0.75),
        ((L1 + L2) * 1.25, "L2", 1 / 2),
        ((L1 + L2) * 1.75, "L3", 1 / 4 / 0.75),
    ],
)
def test_a_set_is_bounded_by_the_level_that_delivers_its_share_last(
    machine: Limits, size: float, level: str, of_l1: float  # noqa: F811
) -> None:
    whole = machine.bandwidth("avx512", "f32", "L1")
    found = machine.reading("avx512", "f32", size)
    assert found == (level, pytest.approx(whole * of_l1))
