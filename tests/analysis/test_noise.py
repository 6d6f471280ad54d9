"""A noisy run is called noisy, with its reason; a quiet one is not."""

from __future__ import annotations

from pathlib import Path

import pytest

from analysis.load import load_run
from analysis.noise import Verdict, judge
from analysis.run import Shard
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run
from tests.analysis.test_tables import SPEED, name, speed_frame


def shard(
    label: str, before: float = 3.5, after: float = 3.5, steal: float = 0.0
) -> Shard:
    return Shard(label, "", 0, before, after, steal, 0.5)


def verdict(ratio: float = 1.0, **shard_values: float) -> Verdict:
    base = name("cross_product", "avx2")
    speed = speed_frame({base: [4.0] * 9, base + "/twin": [4.0 * ratio] * 9})
    return judge(speed, (shard("speed-a", **shard_values),))


def test_a_quiet_run_is_quiet() -> None:
    found = verdict()
    assert (found.word, found.reasons) == ("quiet", ())


@pytest.mark.parametrize("ratio", [0.96, 1.04])
def test_twins_apart_make_it_noisy(ratio: float) -> None:
    found = verdict(ratio)
    assert found.word == "noisy"
    assert f"A/A ratio {ratio:.3f}" in found.reasons[0].text


@pytest.mark.parametrize("ratio", [0.975, 1.025])
def test_twins_within_three_percent_do_not(ratio: float) -> None:
    assert verdict(ratio).word == "quiet"


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


def test_a_shard_with_another_clock_is_named() -> None:
    found = judge(
        SPEED, tuple(shard(f"speed-{s}") for s in "abc") + (shard("d", 3, 3),)
    )
    assert [reason.shard for reason in found.reasons if "its clock" in reason.text] == [
        "d"
    ]


def test_without_a_pair_noise_is_not_judged() -> None:
    speed = speed_frame({name("cross_product", "avx2"): [4.0] * 9})
    assert judge(speed, (shard("speed-a"),)).word == "not judged"


@pytest.mark.parametrize(
    ("change", "reason"),
    [
        ({"twin_ratio": 1.2}, "A/A ratio"),
        ({"clock_after": 3.0}, "the clock went from"),
        ({"steal_percent": 12.0}, "the hypervisor took"),
    ],
)
def test_a_noisy_run_on_disk_shows_as_noisy(
    tmp_path: Path, change: dict[str, float], reason: str
) -> None:
    import dataclasses

    options = dataclasses.replace(TWO_METHODS, **change)
    run = load_run(write_run(tmp_path / "noisy", options))
    found = judge(run.speed, run.shards)
    assert found.word == "noisy"
    assert any(reason in r.text for r in found.reasons)
