"""What another place does to a kernel, against frames made by hand."""

from __future__ import annotations

import pandas as pd
import pytest

from analysis.trust.placement import (
    placement_chart,
    placement_words,
    placements,
    spreads,
)
from tests.analysis.test_tables import name, speed_frame

BASE = name("edge_function", "avx2")
OTHER = name("cross_product", "avx2")
# Repetitions that differ by a thousandth.
STEADY = [1 + k / 9000 for k in range(9)]


def times(factor: float) -> list[float]:
    return [factor * time for time in STEADY]


SPEED = speed_frame(
    {
        BASE: times(2.0),
        BASE + "/placed_0": times(2.2),
        BASE + "/placed_16": times(1.6),
        BASE + "/placed_32": times(2.0),
        OTHER: times(3.0),
        OTHER + "/placed_0": times(3.0),
        OTHER + "/placed_16": times(3.0),
        BASE + "/twin": times(9.0),
        name("uv_projection", "avx2"): times(9.0),
    }
)


def test_each_place_is_a_row_over_the_aligned_one() -> None:
    table = placements(SPEED)
    own = table[table["method"] == "edge_function"]
    assert list(own["place"]) == ["aligned", "0", "16", "32"]
    assert list(own["over_aligned"]) == pytest.approx([1.0, 1.1, 0.8, 1.0], rel=2e-3)
    assert set(table["method"]) == {"edge_function", "cross_product"}
    assert (own["over_aligned_low"] <= own["over_aligned"]).all()


def test_the_spread_is_between_the_slowest_and_the_fastest_place() -> None:
    found = spreads(SPEED, placements(SPEED)).set_index("method")
    row = found.loc["edge_function"]
    assert (row["slowest"], row["fastest"], row["places"]) == ("0", "16", 4)
    assert row["spread"] == pytest.approx(2.2 / 1.6, rel=2e-3)
    assert row["aligned"] == pytest.approx(2.0 / 1.6, rel=2e-3)
    assert 1 < row["spread_low"] < row["spread"] < row["spread_high"]


def test_a_spread_of_nothing_holds_1() -> None:
    row = spreads(SPEED, placements(SPEED)).set_index("method").loc["cross_product"]
    assert row["spread_low"] <= 1 <= row["spread_high"]


def test_the_words_are_of_the_largest_spread() -> None:
    words = placement_words(spreads(SPEED, placements(SPEED)))
    assert words is not None
    assert (words["method"], words["kernels"], words["apart"]) == (
        "edge_function",
        2,
        1,
    )
    assert words["ratio"].startswith("1.37") or words["ratio"].startswith("1.38")
    assert words["slowest"] == "0 bytes on" and words["fastest"] == "16 bytes on"


def test_what_may_be_chance_is_not_the_largest_spread() -> None:
    wide = [1 + k for k in range(9)]
    unsure = speed_frame(
        {
            OTHER: [3.0 * time for time in wide],
            OTHER + "/placed_16": [5.0 * time for time in wide],
        }
    )
    both = pd.concat([SPEED[SPEED["method"] == "edge_function"], unsure])
    table = placements(both)
    found = spreads(both, table)
    assert found.loc[found["spread"].idxmax(), "method"] == "cross_product"
    words = placement_words(found)
    assert words is not None
    assert (words["method"], words["apart"]) == ("edge_function", 1)
    assert "edge_function, avx2), more than is sure" in (
        placement_chart(table, found, "footer").title
    )
    alone = spreads(unsure, placements(unsure))
    words = placement_words(alone)
    assert words is not None and words["apart"] == 0
    chart = placement_chart(placements(unsure), alone, "footer")
    assert "no place is surely slower than another" in chart.title


def test_the_chart_says_the_largest_spread_with_its_interval() -> None:
    table = placements(SPEED)
    chart = placement_chart(table, spreads(SPEED, table), "footer")
    assert "edge_function, avx2" in chart.title and " to 1.3" in chart.title
    assert "16 bytes on: 0.800" in chart.alt


def test_a_run_without_placements_has_none() -> None:
    plain = SPEED[SPEED["control"] == ""]
    table = placements(plain)
    assert len(table) == 0 and len(spreads(plain, table)) == 0
    assert placement_words(spreads(plain, table)) is None


def test_the_plain_row_has_to_be_of_the_same_shard() -> None:
    other = speed_frame({OTHER + "/placed_48": times(9.0)}, "speed-b")
    table = placements(pd.concat([SPEED, other]))
    assert "48" not in set(table["place"])
