"""What the input does, against small frames worked out by hand."""

from __future__ import annotations

import math

import pandas as pd
import pytest

from analysis.claims.inputs import (
    FAILS,
    HOLDS,
    PARTLY,
    UNTESTED,
    break_even_words,
    early_way_out,
    hoisting,
    inverse,
)
from analysis.read.cells import parse_cell
from analysis.read.run import Cache
from analysis.speed.break_even import (
    break_evens,
    claimed,
    paid_between,
    paid_from,
    ratios_by_size,
)
from analysis.speed.input_tables import (
    by_size,
    by_threads,
    early_out,
    home,
    most_telling,
    of_comparisons,
)
from analysis.speed.tables import speed_cells
from tests.analysis.test_tables import name, speed_frame

CACHES = (
    Cache(1, "Data", 32768, 1),
    Cache(1, "Instruction", 65536, 1),
    Cache(2, "Unified", 1 << 20, 1),
)


def sized(n: int, sets: str = "fresh") -> str:
    return f"uniform:hit=50:n={n}:sets={sets}"


def hit(percent: int, sets: str = "fresh") -> str:
    return f"uniform:hit={percent}:bytes=24k:sets={sets}"


def frame(times: dict[str, float]) -> pd.DataFrame:
    """Nine repetitions of each cell, spread by one percent; 8 bytes a point."""
    spread = [0.995 + 0.00125 * k for k in range(9)]
    speed = speed_frame({cell: [ns * s for s in spread] for cell, ns in times.items()})
    cells = [parse_cell(cell) for cell in speed["name"]]
    items = [c.scene.number("n") if c.scene.get("n") else 3072.0 for c in cells]
    return speed.assign(
        items=items,
        working_set_bytes=[24.0 + 8 * n for n in items],
        threads=[c.threads or 1 for c in cells],
    )


# A call of n points takes 10 + n ns cheaply, 100 + n/2 ns after a dear set-up:
# as much for 180 points.
DEAR = {
    name(method, "avx2", sized(n)): (setup + per_point * n) / n
    for n in (1, 16, 64, 128, 256, 4096, 65536)
    for method, setup, per_point in (
        ("cross_product", 10.0, 1.0),
        ("barycentric_inverse", 100.0, 0.5),
        ("cross_product_unhoisted", 11.0, 1.5),
    )
}


def test_a_break_even_is_where_two_straight_lines_cross() -> None:
    # 10 + n against 100 + n/2: 101 and 180 of 110 and 180 to come.
    n = [16, 256]
    others = [26.0, 266.0]
    ratios = [108 / 26, 228 / 266]
    assert paid_from(n, ratios, others, 1) == pytest.approx(180)


def test_a_break_even_at_the_first_n_or_nowhere() -> None:
    assert paid_from([1, 16], [1.0, 0.9], [1.0, 1.0], 1) == 1
    assert math.isnan(paid_from([1, 16], [1.1, 1.01], [1.0, 1.0], 1))


def test_equal_at_the_ends_is_no_break_even() -> None:
    # A tail hides the set-up at first, memory the arithmetic at last.
    n = [1, 16, 256, 4096]
    ratios = [0.99, 2.0, 0.5, 1.01]
    assert paid_from(n, ratios, [1.0, 2.0, 4.0, 8.0], 2) == pytest.approx(16 + 240 / 2)
    assert paid_between(n, ratios, ratios, 2) == (16, 256)


def test_the_interval_reaches_to_the_timed_numbers_around_it() -> None:
    n = [1, 16, 32, 64, 128]
    lows, highs = [2.0, 1.5, 0.98, 0.9, 0.7], [2.2, 1.6, 1.02, 1.01, 0.8]
    assert paid_between(n, lows, highs, 4) == (16, 128)


def test_a_tail_says_nothing_about_whole_vectors() -> None:
    assert paid_between([1, 8, 64, 512], [0.9] * 4, [0.95] * 4, 3) == (1, 64)
    assert paid_between([1, 8, 16, 512], [0.9] * 4, [0.95] * 4, 3) == (1, 1)
    ratios = [2.0, 2.0, 0.9, 0.9]
    assert paid_between([16, 32, 33, 64], ratios, ratios, 3) == (32, 64)


def tailed(setup: float, point: float, n: int) -> float:
    """A call in ns by vectors of 16; what fills none costs as much as eight."""
    whole, tail = divmod(n, 16)
    return setup + 16 * point * (whole + 8 * (tail > 0))


@pytest.mark.parametrize("setup", [40.0, 60.0, 90.0, 300.0, 900.0])
@pytest.mark.parametrize("kept", [2, 3, 4])
def test_fewer_timed_numbers_do_not_contradict_more(setup: float, kept: int) -> None:
    dense = [1, 2, 4, 8, 12, 15, 16, 17, 24, 31, 32, 48, 63, 64, 65, 80, 96, 127]
    dense += [128, 160, 192, 256, 384, 512, 768, 1024, 2048, 4096, 8192, 65536]

    def found(sizes: list[int]) -> pd.Series:
        times = {
            name(method, "avx512", sized(n)): tailed(before, point, n) / n
            for n in sizes
            for method, before, point in (
                ("cross_product", 10.0, 1.0),
                ("barycentric_inverse", setup, 0.75),
            )
        }
        speed = frame(times)
        table = break_evens(speed, speed_cells(speed))
        return table.set_index("method").loc["barycentric_inverse"]

    whole = found(dense)
    assert whole["break_even"] > 1
    for first in range(kept):
        few = found(sorted({1, 65_536, *dense[first::kept]}))
        assert few["break_even_low"] <= whole["break_even"] <= few["break_even_high"]
        assert few["break_even_low"] <= few["break_even"] <= few["break_even_high"]


def test_the_break_even_is_where_the_two_calls_take_as_long() -> None:
    speed = frame(DEAR)
    table = break_evens(speed, speed_cells(speed))
    row = table[table["method"] == "barycentric_inverse"].iloc[0]
    assert row["against"] == "cross_product"  # the cheapest for one point
    assert row["break_even"] == pytest.approx(180)
    assert (row["break_even_low"], row["break_even_high"]) == (128, 256)
    assert row["worst"] == pytest.approx(100.5 / 11, rel=1e-6)
    assert row["worst_n"] == 1
    assert row["best_n"] == 65536
    assert break_even_words(row) == "180 (128 to 256)"


def test_what_is_faster_for_less_than_a_vector_has_no_break_even() -> None:
    times = {name("cross_product", "avx2", sized(n)): 1.0 for n in (1, 16, 256)}
    times |= {
        name("uv_projection", "avx2", sized(n)): ratio
        for n, ratio in ((1, 0.9), (16, 1.5), (256, 1.2))
    }
    speed = frame(times)
    row = break_evens(speed, speed_cells(speed)).iloc[0]
    assert break_even_words(row) == "never"


def test_what_is_never_faster_has_no_break_even() -> None:
    speed = frame(DEAR)
    table = break_evens(speed, speed_cells(speed))
    row = table[table["method"] == "cross_product_unhoisted"].iloc[0]
    assert math.isnan(row["break_even"])
    assert break_even_words(row) == "never"


def test_what_is_faster_for_one_point_already_always_pays() -> None:
    speed = frame(DEAR)
    table = break_evens(speed, speed_cells(speed))
    row = table[table["against"] == "cross_product_unhoisted"].iloc[0]
    assert (row["method"], break_even_words(row)) == ("cross_product", "always")


def test_an_interval_that_never_leaves_1_is_no_proof() -> None:
    times = {
        name("cross_product", "avx2", sized(n)): 1.0 for n in (1, 16, 256, 4096)
    } | {
        name("uv_projection", "avx2", sized(n)): ratio
        for n, ratio in ((1, 2.0), (16, 1.5), (256, 1.002), (4096, 1.002))
    }
    speed = frame(times)
    row = break_evens(speed, speed_cells(speed)).iloc[0]
    assert math.isnan(row["break_even_high"])
    assert row["break_even_low"] == 16
    assert break_even_words(row) == "not shown"


def test_each_ratio_by_size_is_over_what_is_cheapest_to_set_up() -> None:
    speed = frame(DEAR)
    table = ratios_by_size(speed, speed_cells(speed))
    assert set(table["cheapest"]) == {"cross_product"}
    own = table[table["method"] == "cross_product"]
    assert set(own["ratio"]) == {1.0}
    far = table[(table["method"] == "barycentric_inverse") & (table["n"] == 65536)]
    assert far["ratio"].iloc[0] == pytest.approx(0.502, rel=0.01)


def test_the_sweep_over_n_is_fresh_and_of_one_cpu() -> None:
    scene = sized(64)
    speed = frame(
        {
            name("edge_function", "avx2", scene): 1.0,
            name("edge_function", "avx2", sized(64, "fixed")): 1.0,
            name("edge_function", "avx2", hit(50)): 1.0,
            name("edge_function", "avx2", scene) + "/threads:2": 1.0,
        }
    )
    assert list(by_size(speed_cells(speed))["scene"]) == [scene]


def test_methods_are_not_compared_by_the_cells_of_sweeps() -> None:
    speed = frame(
        {
            name("edge_function", "avx2", sized(64)): 1.0,
            name("edge_function", "avx2", hit(50)): 1.0,
            name("edge_function", "avx2", hit(50)) + "/threads:1": 1.0,
        }
    )
    cells = speed_cells(speed)
    assert list(of_comparisons(cells)["name"]) == [
        name("edge_function", "avx2", hit(50))
    ]
    only = cells[cells["name"].str.contains("n=64")]
    assert len(of_comparisons(only)) == 1  # where there is nothing else


EARLY = {
    name(method, isa, hit(percent, sets)): ns
    for method, isa, percent, sets, ns in (
        ("cross_product", "scalar", 0, "fresh", 4.0),
        ("cross_product_early_out", "scalar", 0, "fresh", 2.0),
        ("cross_product", "scalar", 50, "fresh", 4.0),
        ("cross_product_early_out", "scalar", 50, "fresh", 12.0),
        ("cross_product", "scalar", 50, "fixed", 4.0),
        ("cross_product_early_out", "scalar", 50, "fixed", 3.0),
    )
}


def test_an_early_way_out_is_compared_with_the_method_without() -> None:
    speed = frame(EARLY)
    table = early_out(speed, speed_cells(speed))
    ratios = {(r["sets"], r["hit"]): r["over_plain"] for _, r in table.iterrows()}
    assert ratios == {
        ("fresh", 0): pytest.approx(0.5),
        ("fresh", 50): pytest.approx(3.0),
        ("fixed", 50): pytest.approx(0.75),
    }


def test_a_way_out_that_saves_at_some_hit_rates_holds_with_a_condition() -> None:
    speed = frame(EARLY)
    claim = early_way_out(early_out(speed, speed_cells(speed)))
    assert claim.verdict == PARTLY
    assert "saves time with 0 % of the points inside" in claim.why
    assert "costs some with 50 %" in claim.why


@pytest.mark.parametrize(("ns", "verdict"), [(2.0, HOLDS), (5.0, FAILS), (4.0, FAILS)])
def test_the_verdict_on_the_way_out_follows_its_time(ns: float, verdict: str) -> None:
    speed = frame(
        {
            name("cross_product", "scalar", hit(50)): 4.0,
            name("cross_product_early_out", "scalar", hit(50)): ns,
        }
    )
    assert early_way_out(early_out(speed, speed_cells(speed))).verdict == verdict


def test_claims_without_cells_cannot_be_tested() -> None:
    speed = frame({name("edge_function", "avx2", hit(50)): 1.0})
    cells = speed_cells(speed)
    assert early_way_out(early_out(speed, cells)).verdict == UNTESTED
    assert inverse(break_evens(speed, cells)).verdict == UNTESTED
    pairs = claimed(speed, cells, "cross_product_unhoisted", "cross_product")
    assert hoisting(pairs, CACHES).verdict == UNTESTED


def test_the_inverse_is_dear_and_pays_for_many_points() -> None:
    speed = frame(DEAR)
    claim = inverse(break_evens(speed, speed_cells(speed)))
    assert claim.verdict == HOLDS
    assert "On avx2 (f32) a call of 1 point takes 9.14" in claim.why


@pytest.mark.parametrize(("ns", "verdict"), [(1.5, HOLDS), (1.0, FAILS), (0.9, FAILS)])
def test_hoisting_is_judged_where_the_points_are_near(ns: float, verdict: str) -> None:
    # 4096 points are 32 KiB and 24 bytes: no more in a cache of 32 KiB.
    times = {name("cross_product", "avx2", sized(n)): 1.0 for n in (64, 2048, 4096)}
    times |= {
        name("cross_product_unhoisted", "avx2", sized(n)): far
        for n, far in ((64, 1.2), (2048, ns), (4096, 7.0))
    }
    speed = frame(times)
    pairs = claimed(
        speed, speed_cells(speed), "cross_product_unhoisted", "cross_product"
    )
    claim = hoisting(pairs, CACHES)
    assert claim.verdict == verdict
    assert "2048 a call" in claim.why


def test_speed_up_and_bandwidth_of_threads() -> None:
    cell = name("edge_function", "avx2", "uniform:hit=50:bytes=64M:sets=fresh")
    speed = frame({f"{cell}/threads:1": 0.2, f"{cell}/threads:2": 0.125, cell: 0.5})
    table = by_threads(speed, speed_cells(speed)).set_index("threads")
    assert list(table.index) == [1, 2]
    assert table.loc[2, "speed_up"] == pytest.approx(1.6)
    assert table.loc[2, "speed_up_low"] < 1.6 < table.loc[2, "speed_up_high"]
    assert table.loc[2, "bandwidth"] == pytest.approx(64e9)


def test_where_points_stay_is_the_first_cache_that_holds_them() -> None:
    assert [home(n, CACHES) for n in (32768, 32769, 1 << 21)] == ["L1", "L2", "DRAM"]


def test_of_many_cells_those_that_methods_are_compared_by_come_first() -> None:
    scenes = [sized(64), hit(10), hit(50), sized(256), hit(50, "fixed")]
    cells = speed_cells(frame({name("exact", "avx2", s): 1.0 for s in scenes}))
    assert most_telling(cells, 9).equals(cells)
    assert set(most_telling(cells, 2)["scene"]) == {hit(50), hit(50, "fixed")}
    assert set(most_telling(cells, 3)["scene"]) == {hit(50), hit(50, "fixed"), hit(10)}
    order = list(cells["scene"])
    kept = list(most_telling(cells, 3)["scene"])
    assert kept == sorted(kept, key=order.index)
