"""A noisy run is called noisy, with its reason; a quiet one is not."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import pandas as pd
import pytest

from analysis.read.load import load_run
from analysis.read.run import Shard
from analysis.trust.controls import control_pairs
from analysis.trust.noise import Verdict, judge
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run
from tests.analysis.test_tables import SPEED, name, speed_frame

BASE = name("cross_product", "avx2")
# As repetitions are: no two alike, and the interval narrower than ±3 %.
TIMES = [4.0, 4.05, 3.98, 4.02, 4.06, 3.99, 4.01, 4.03, 4.04]


def shard(
    label: str,
    before: float = 3.5,
    after: float = 3.5,
    steal: float = 0.0,
    cpu: float = 5.0,
) -> Shard:
    return Shard(label, "", 0, before, after, steal, 0.5, 5.0, cpu, 7)


def slower(ratio: float, by: float = 0.0) -> list[float]:
    return [time * ratio for time in TIMES]


def verdict(twin: float = 1.0, doubled: float = 2.0, **shard_values: float) -> Verdict:
    speed = speed_frame(
        {
            BASE: TIMES,
            BASE + "/twin": slower(twin),
            BASE + "/doubled": slower(doubled),
        }
    )
    return judge(speed, (shard("speed-a", **shard_values),))


def test_a_quiet_run_is_quiet() -> None:
    found = verdict()
    assert (found.word, found.reasons) == ("quiet", ())
    assert (found.rows, found.noisy_rows) == (1, 0)


@pytest.mark.parametrize("ratio", [0.96, 1.04])
def test_claiming_a_difference_between_identical_work_makes_it_noisy(
    ratio: float,
) -> None:
    found = verdict(twin=ratio)
    assert found.word == "noisy"
    assert "a difference is seen between identical work" in found.reasons[0].text
    assert f"A/A ratio {ratio:.3f}" in found.reasons[0].text
    assert BASE in found.reasons[0].text


def test_a_small_difference_is_one_too_if_the_interval_excludes_1() -> None:
    assert "difference is seen" in verdict(twin=1.025).reasons[0].text


def test_a_wide_interval_that_holds_1_does_not_excuse_a_ratio_far_from_it() -> None:
    speed = speed_frame(
        {BASE: [4.0, 4.0, 4.0, 6.0] * 3, BASE + "/twin": [4.0, 4.6, 4.6, 6.0] * 3}
    )
    found = judge(speed, (shard("speed-a"),))
    assert any("timed twice differs: A/A ratio 1.1" in r.text for r in found.reasons)


def test_twins_as_near_as_their_spread_do_not_make_it_noisy() -> None:
    assert verdict(twin=1.004).word == "quiet"


@pytest.mark.parametrize(("ratio", "word"), [(1.004, "quiet"), (1.006, "noisy")])
def test_what_a_sharp_interval_misses_1_by_has_to_be_worth_a_word(
    ratio: float, word: str
) -> None:
    sharp = [4.0 + k / 1e5 for k in range(9)]
    twin = [ratio * time for time in sharp]
    found = judge(speed_frame({BASE: sharp, BASE + "/twin": twin}), (shard("speed-a"),))
    assert found.word == word
    assert (
        not found.pairs["ratio_low"].iloc[0] <= 1 <= found.pairs["ratio_high"].iloc[0]
    )


def test_of_a_long_call_twice_the_work_has_no_known_ratio() -> None:
    speed = speed_frame(
        {BASE: TIMES, BASE + "/twin": TIMES, BASE + "/doubled": slower(1.8)}
    )
    assert len(control_pairs(speed)) == 2
    assert list(
        control_pairs(speed.assign(working_set_bytes=2.0**24))["control"]
    ) == ["twin"]


def test_missing_a_real_difference_makes_it_noisy() -> None:
    found = verdict(doubled=1.0)
    assert found.word == "noisy"
    assert "a real difference is missed" in found.reasons[0].text


@pytest.mark.parametrize("ratio", [1.9, 2.1])
def test_twice_the_work_takes_twice_the_time(ratio: float) -> None:
    assert verdict(doubled=2.02).word == "quiet"
    assert "does not take twice the time" in verdict(doubled=ratio).reasons[0].text


def test_the_intervals_of_all_pairs_hold_at_once() -> None:
    """At 95 % each, one of twenty pairs would miss; so each covers more."""
    many = {
        name(f"m{i}", "avx2") + end: TIMES for i in range(20) for end in ("", "/twin")
    }
    pairs = control_pairs(speed_frame(many))
    assert len(pairs) == 20
    assert (pairs["coverage"] >= 1 - 0.05 / 20).all()
    alone = control_pairs(speed_frame({BASE: TIMES, BASE + "/twin": TIMES}))
    assert 0.95 <= alone["coverage"].iloc[0] < 0.97


def test_a_control_without_its_plain_row_is_no_pair() -> None:
    assert len(control_pairs(speed_frame({BASE + "/twin": TIMES}))) == 0


@pytest.mark.parametrize("after", [3.3, 3.7])
def test_a_clock_that_drifts_makes_it_noisy(after: float) -> None:
    found = verdict(after=after)
    assert found.word == "noisy"
    assert f"from 3.50 to {after:.2f} GHz" in found.reasons[0].text


def test_stolen_time_makes_it_noisy() -> None:
    assert verdict(steal=2.9).word == "quiet"
    found = verdict(steal=3.1)
    assert found.word == "noisy"
    assert "took 3.1 %" in found.reasons[0].text


def test_time_that_others_had_on_its_core_makes_it_noisy() -> None:
    assert verdict(cpu=4.9).word == "quiet"
    found = verdict(cpu=2.5)
    assert found.word == "noisy"
    assert "had its CPU for 50.0 % of the time" in found.reasons[0].text


def test_few_quiet_slices_make_it_noisy() -> None:
    speed = speed_frame({BASE: TIMES, BASE + "/twin": TIMES})

    def judged(share: float) -> Verdict:
        return judge(speed, (dataclasses.replace(shard("a"), quiet_share=share),))

    assert judged(0.6).word == "quiet"
    found = judged(0.4)
    assert found.word == "noisy"
    assert "only 40 % of its slices" in found.reasons[0].text


def test_a_shard_that_does_not_tell_how_much_it_had_is_not_blamed() -> None:
    silent = dataclasses.replace(shard("speed-a"), wall_seconds=math.nan)
    speed = speed_frame({BASE: TIMES, BASE + "/twin": TIMES})
    assert judge(speed, (silent,)).word == "quiet"


def with_throughput(label: str, before: float, after: float) -> Shard:
    return dataclasses.replace(
        shard(label), throughput_before_gops=before, throughput_after_gops=after
    )


def test_a_neighbour_that_slows_the_core_but_not_its_clock_makes_it_noisy() -> None:
    speed = speed_frame({BASE: TIMES, BASE + "/twin": TIMES})
    steady = [with_throughput(f"speed-{s}", 14.0, 14.1) for s in "abc"]
    assert judge(speed, tuple(steady)).word == "quiet"
    falls = judge(speed, (*steady, with_throughput("d", 14.0, 9.0)))
    assert any(r.shard == "d" and "-35.7 % in a cycle" in r.text for r in falls.reasons)
    low = judge(speed, (*steady, with_throughput("d", 9.0, 9.0)))
    assert [r.shard for r in low.reasons] == ["d"]
    assert "against the other shards" in low.reasons[0].text


def test_a_shard_with_another_clock_is_named() -> None:
    found = judge(
        SPEED, tuple(shard(f"speed-{s}") for s in "abc") + (shard("d", 3, 3),)
    )
    assert [reason.shard for reason in found.reasons if "its clock" in reason.text] == [
        "d"
    ]


def test_without_a_pair_noise_is_not_judged() -> None:
    speed = speed_frame({BASE: TIMES})
    assert judge(speed, (shard("speed-a"),)).word == "not judged"


def many_rows(noisy: int) -> pd.DataFrame:
    spread = [3.0, 3.5, *TIMES[2:7], 4.5, 5.0]
    rows = {
        name(f"m{i}", "avx2"): spread if i < noisy else slower(1 + i / 10)
        for i in range(40)
    }
    return speed_frame({**rows, name("m39", "avx2") + "/twin": slower(4.9)})


def test_more_noisy_rows_than_a_quiet_machine_has_make_it_noisy() -> None:
    ten = judge(many_rows(10), (shard("speed-a"),))
    assert (ten.word, ten.noisy_rows) == ("quiet", 10)
    more = judge(many_rows(11), (shard("speed-a"),))
    assert more.word == "noisy"
    assert "11 of 40 rows are noisy by themselves" in more.reasons[0].text


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"twin_ratio": 1.2}, "A/A ratio"),
        ({"doubled_ratio": 1.7}, "twice the work"),
        ({"clock_after": 3.0}, "the clock went from"),
        ({"steal_percent": 12.0}, "the hypervisor took"),
        ({"cpu_share": 0.6}, "other processes ran on the same core"),
    ],
)
def test_a_noisy_run_on_disk_shows_as_noisy(
    tmp_path: Path, change: dict[str, float], reason: str
) -> None:
    options = dataclasses.replace(TWO_METHODS, **change)  # type: ignore[arg-type]
    run = load_run(write_run(tmp_path / "noisy", options))
    found = judge(run.speed, run.shards)
    assert found.word == "noisy"
    assert any(reason in r.text for r in found.reasons)
