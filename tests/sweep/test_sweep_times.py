"""times.json: how long the starts of a sweep took together."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from sweep_times import SweepTimes
from tests.sweep.fake_sweep import SHARDS, FakeSweep


def times(folder: Path) -> dict[str, Any]:
    document: dict[str, Any] = json.loads((folder / "times.json").read_text())
    return document


def test_a_sweep_notes_how_long_each_shard_took_and_all_of_it(fake: FakeSweep) -> None:
    fake.plan["seconds"] = {"speed-a": 0.3}
    assert fake.run("--jobs", "1")[0] == 0
    told = times(fake.out)
    assert set(told["shards"]) == {name for name, _ in SHARDS}
    assert told["shards"]["speed-a"] >= 0.3
    assert told["seconds"] >= sum(told["shards"].values())
    assert told["starts"] == 1
    assert fake.leftovers() == []


def test_a_start_that_goes_on_adds_its_time(fake: FakeSweep) -> None:
    fake.plan["fail"] = ["accuracy-b"]
    assert fake.run()[0] == 1
    first = times(fake.out)
    assert "accuracy-b" not in first["shards"]
    fake.plan["fail"] = []
    fake.plan["seconds"] = {"accuracy-b": 0.3}
    assert fake.run()[0] == 0
    second = times(fake.out)
    assert second["starts"] == 2
    assert second["seconds"] >= first["seconds"] + 0.3
    assert first["shards"].items() <= second["shards"].items()


def test_a_start_that_runs_nothing_changes_nothing(fake: FakeSweep) -> None:
    fake.run()
    before = times(fake.out)
    assert fake.run()[0] == 0
    assert times(fake.out) == before


def test_a_killed_start_keeps_the_time_until_its_last_shard(fake: FakeSweep) -> None:
    fake.plan["held"] = ["speed-b"]
    child = fake.start("--jobs", "1")
    fake.wait_for("start", "speed-b")
    child.kill()
    child.wait()
    told = times(fake.out)
    assert set(told["shards"]) == {"speed-a"}
    assert told["seconds"] >= told["shards"]["speed-a"]


def test_tasks_of_an_array_add_up(fake: FakeSweep) -> None:
    children = [fake.start("--index", str(k)) for k in range(len(SHARDS))]
    for child in children:
        child.communicate(timeout=60)
    told = times(fake.out)
    assert told["starts"] == len(SHARDS)
    assert set(told["shards"]) == {name for name, _ in SHARDS}


@pytest.mark.parametrize("spoilt", ["", "[]", "{}", '{"schema": "other"}', "{"])
def test_a_file_that_does_not_read_is_begun_anew(tmp_path: Path, spoilt: str) -> None:
    (tmp_path / "times.json").write_text(spoilt)
    SweepTimes(tmp_path).add("speed-a", 1.5)
    assert times(tmp_path)["shards"] == {"speed-a": 1.5}
