"""What sweep.py promises: shards run once, alone where timed, and resume."""

from __future__ import annotations

import json
import os
import signal
import time

from tests.sweep.fake_sweep import SHARDS, FakeSweep

ALL = sorted(f"{name}.json" for name, _ in SHARDS)


def intervals(fake: FakeSweep) -> dict[str, tuple[float, float]]:
    """When each shard that ended ran."""
    starts = {name: t for event, name, t in fake.log() if event == "start"}
    return {n: (starts[n], t) for event, n, t in fake.log() if event == "end"}


def overlap(a: tuple[float, float], b: tuple[float, float]) -> bool:
    return a[0] < b[1] and b[0] < a[1]


def test_a_sweep_leaves_every_shard_and_what_the_report_needs(fake: FakeSweep) -> None:
    code, output, errors = fake.run()
    assert (code, errors) == (0, "")
    assert fake.results() == ALL
    assert fake.leftovers() == []
    assert json.loads((fake.out / "machine.json").read_text())["revision"]
    assert json.loads((fake.out / "methods.json").read_text()) == {"methods": []}
    assert json.loads((fake.out / "sweep.json").read_text())["profile"] == "tiny"
    assert "6 shards run, 0 were there, 0 failed" in output


def test_a_shard_gets_its_arguments(fake: FakeSweep) -> None:
    fake.run("--shard", "speed-b")
    got = json.loads((fake.out / "speed-b.json").read_text())["arguments"]
    want = ["speed", "--profile", "tiny", "--filter", "^speed-b/"]
    assert got == [*want, "--out", str(fake.out / "speed-b.json")]


def test_speed_comes_first_and_every_kind_in_the_listed_order(fake: FakeSweep) -> None:
    fake.run("--jobs", "1")
    want = ["speed-a", "speed-b", "accuracy-a", "accuracy-b", "accuracy-c", "maps"]
    assert fake.started() == want


def test_nothing_runs_beside_a_speed_shard(fake: FakeSweep) -> None:
    fake.plan["seconds"] = {name: 0.2 for name, _ in SHARDS}
    fake.run("--jobs", "3")
    ran = intervals(fake)
    assert len(ran) == len(SHARDS)
    for speed in ("speed-a", "speed-b"):
        assert not [n for n in ran if n != speed and overlap(ran[n], ran[speed])]


def test_accuracy_shards_share_the_cores(fake: FakeSweep) -> None:
    fake.plan["seconds"] = {name: 0.5 for name, _ in SHARDS}
    fake.run("--jobs", "3")
    ran = intervals(fake)
    assert overlap(ran["accuracy-a"], ran["accuracy-b"])
    assert overlap(ran["accuracy-b"], ran["accuracy-c"])


def test_maps_run_beside_accuracy_shards(fake: FakeSweep) -> None:
    fake.plan["seconds"] = {"accuracy-c": 1.0, "maps": 0.5}
    fake.run("--jobs", "4")
    ran = intervals(fake)
    assert overlap(ran["accuracy-c"], ran["maps"])


def test_two_sweeps_never_run_beside_each_others_timings(fake: FakeSweep) -> None:
    """Each shard runs once in either folder; the log tells the two apart by
    order only, so it is read as a sequence: between a speed shard's start and
    its end nothing else starts."""
    fake.plan["seconds"] = {name: 0.15 for name, _ in SHARDS}
    first = fake.start(out=fake.folder / "results" / "first")
    second = fake.start(out=fake.folder / "results" / "second")
    outputs = first.communicate(timeout=60)[0] + second.communicate(timeout=60)[0]
    assert (first.returncode, second.returncode) == (0, 0)
    assert "waiting: another sweep on this machine" in outputs
    log = fake.log()
    assert len(log) == 4 * len(SHARDS)
    running = 0
    for event, name, _ in log:
        if event == "start":
            assert running == 0 or not name.startswith("speed")
        else:
            assert running == 1 or not name.startswith("speed")
        running += 1 if event == "start" else -1


def test_a_finished_sweep_runs_nothing_again(fake: FakeSweep) -> None:
    fake.run()
    before = fake.started()
    code, output, _ = fake.run()
    assert code == 0
    assert fake.started() == before
    assert "6 of 6 shards are there already" in output


def test_killed_in_a_shard_the_next_start_completes(fake: FakeSweep) -> None:
    fake.plan["seconds"] = {"speed-b": 30}
    child = fake.start()
    fake.wait_for("start", "speed-b")
    fake.wait_until(lambda: bool(fake.leftovers()))
    os.killpg(child.pid, signal.SIGKILL)
    child.wait()
    assert fake.results() == ["speed-a.json"]
    assert fake.leftovers() == ["speed-b.json.tmp"]

    fake.plan["seconds"] = {}
    code, output, _ = fake.run()
    assert code == 0
    assert fake.results() == ALL
    assert fake.leftovers() == []
    assert fake.started().count("speed-a") == 1
    assert "1 of 6 shards are there already" in output


def test_killed_alone_it_takes_its_shard_along(fake: FakeSweep) -> None:
    """An orphan would go on timing beside whatever runs next."""
    fake.plan["seconds"] = {"speed-a": 2}
    child = fake.start()
    fake.wait_for("start", "speed-a")
    child.kill()
    child.wait()
    fake.plan["seconds"] = {}
    code, _, errors = fake.run()
    assert (code, errors) == (0, "")
    assert fake.results() == ALL
    time.sleep(2)  # an orphan would have ended by now
    ended = [name for event, name, _ in fake.log() if event == "end"]
    assert ended.count("speed-a") == 1


def test_interrupted_it_stops_its_shards_and_ends_with_130(fake: FakeSweep) -> None:
    for number in (signal.SIGINT, signal.SIGTERM):
        fake.plan["seconds"] = {"speed-a": 30}
        starts = fake.started().count("speed-a")
        child = fake.start()
        fake.wait_until(lambda: fake.started().count("speed-a") == starts + 1)
        fake.wait_until(lambda: bool(fake.leftovers()))
        child.send_signal(number)
        _, errors = child.communicate(timeout=10)
        assert child.returncode == 130
        assert "Traceback" not in errors and "goes on" in errors
        assert fake.leftovers() == []
    fake.plan["seconds"] = {}
    assert fake.run()[0] == 0
    assert fake.results() == ALL


def test_a_second_start_into_the_same_folder_says_so_and_ends(fake: FakeSweep) -> None:
    fake.plan["held"] = ["speed-a"]
    first = fake.start()
    fake.wait_for("start", "speed-a")
    for arguments in ((), ("--shard", "accuracy-a")):
        code, output, errors = fake.run(*arguments)
        assert (code, output) == (2, "")
        assert "another sweep is running in" in errors
    fake.release()
    assert first.wait(timeout=30) == 0
    assert fake.results() == ALL


def test_a_failing_shard_is_shown_and_the_others_go_on(fake: FakeSweep) -> None:
    fake.plan["fail"] = ["speed-a", "accuracy-b"]
    code, output, _ = fake.run()
    assert code == 1
    assert fake.results() == [
        "accuracy-a.json",
        "accuracy-c.json",
        "maps.json",
        "speed-b.json",
    ]
    assert "FAILED speed-a: exit 1" in output
    assert "speed-a: the answers are wrong" in output
    assert "--filter '^speed-a/' --out" in output
    assert fake.leftovers() == []
    assert "4 shards run, 0 were there, 2 failed" in output

    fake.plan["fail"] = []
    assert fake.run()[0] == 0
    assert fake.results() == ALL


def test_an_empty_result_is_run_again(fake: FakeSweep) -> None:
    """A power cut can leave an empty file of a rename."""
    fake.run()
    (fake.out / "accuracy-a.json").write_text("")
    assert fake.run()[0] == 0
    assert fake.started().count("accuracy-a") == 2
    assert (fake.out / "accuracy-a.json").stat().st_size > 0


def test_terminal_free_output_is_plain_lines(fake: FakeSweep) -> None:
    _, output, _ = fake.run()
    assert "\x1b" not in output and "\n\n" not in output
    assert "1/6 speed-a " in output
    assert "s left" in output


def test_limits_run_first_and_alone(fake: FakeSweep) -> None:
    fake.plan["shards"] = [["limits", "limits"], *SHARDS]
    fake.plan["seconds"] = {name: 0.2 for name, _ in SHARDS} | {"limits": 0.3}
    code, _, errors = fake.run("--jobs", "3")
    assert (code, errors) == (0, "")
    assert fake.started()[0] == "limits"
    ran = intervals(fake)
    assert not [n for n in ran if n != "limits" and overlap(ran[n], ran["limits"])]
    assert (fake.out / "limits.json").exists()
