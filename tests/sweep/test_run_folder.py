"""A folder belongs to one revision, CPU and profile; single shards for Slurm."""

from __future__ import annotations

import os
import stat
from typing import Any

import pytest
from tests.sweep.fake_sweep import SHARDS, FakeSweep


@pytest.mark.parametrize(
    "key, value, word",
    [
        ("revision", "fedcba9876543210", "revision"),
        ("dirty", True, "dirty"),
        ("cpu", "Other CPU", "CPU"),
    ],
)
def test_a_folder_of_another_program_or_machine_is_refused(
    fake: FakeSweep, key: str, value: Any, word: str
) -> None:
    fake.run("--shard", "speed-a")
    fake.plan[key] = value
    code, output, errors = fake.run()
    assert (code, output) == (2, "")
    assert f"was begun with {word}" in errors and "give another folder" in errors
    assert fake.results() == ["speed-a.json"]


def test_a_folder_of_another_profile_is_refused(fake: FakeSweep) -> None:
    fake.run("--shard", "speed-a")
    code, _, errors = fake.run("--profile", "quick")
    assert code == 2
    assert "begun with profile tiny, and this is profile quick" in errors


def test_a_dirty_program_that_changed_is_refused(fake: FakeSweep) -> None:
    """Its revision does not say what it was built from; its digest does."""
    fake.plan["dirty"] = True
    assert fake.run("--shard", "speed-a")[0] == 0
    file = fake.out / "sweep.json"
    text = file.read_text()
    digest = text.split('"program_sha256": "')[1][:64]
    file.write_text(text.replace(digest, "0" * 64))
    code, _, errors = fake.run()
    assert code == 2
    assert "begun with program 000000000000" in errors


def test_results_of_unknown_origin_are_refused(fake: FakeSweep) -> None:
    fake.run()
    (fake.out / "machine.json").unlink()
    code, _, errors = fake.run()
    assert code == 2
    assert "where they come from is unknown" in errors


def test_a_broken_machine_file_is_refused_without_a_traceback(fake: FakeSweep) -> None:
    fake.run()
    (fake.out / "machine.json").write_text("{")
    code, _, errors = fake.run()
    assert code == 2
    assert "machine.json" in errors and "Traceback" not in errors


def test_a_missing_program_is_named(fake: FakeSweep) -> None:
    code, _, errors = fake.run("--pitbench", "/nonexistent/pitbench")
    assert code == 2
    assert "cannot run /nonexistent/pitbench" in errors and "build it" in errors


def test_an_unwritable_folder_is_named(fake: FakeSweep) -> None:
    (fake.folder / "file").write_text("")
    code, _, errors = fake.run(out=fake.folder / "file" / "run")
    assert code == 2
    assert str(fake.folder / "file") in errors and "Traceback" not in errors


def test_index_counts_as_shards_are_listed(fake: FakeSweep) -> None:
    for index, (name, _) in enumerate(SHARDS):
        assert fake.run("--index", str(index))[0] == 0
        assert fake.started()[-1] == name
    assert fake.results() == sorted(f"{name}.json" for name, _ in SHARDS)
    for wrong in ("-1", "6"):
        code, _, errors = fake.run("--index", wrong)
        assert (code, "there are 6 shards" in errors) == (2, True)


def test_an_unknown_shard_is_refused(fake: FakeSweep) -> None:
    code, _, errors = fake.run("--shard", "speed-x")
    assert (code, "no shard 'speed-x'" in errors) == (2, True)


def test_single_shards_share_a_folder_but_not_a_shard(fake: FakeSweep) -> None:
    fake.plan["held"] = ["accuracy-a"]
    first = fake.start("--shard", "accuracy-a")
    fake.wait_for("start", "accuracy-a")
    assert fake.run("--shard", "accuracy-b")[0] == 0
    code, _, errors = fake.run("--shard", "accuracy-a")
    assert (code, "being run in" in errors) == (2, True)
    code, _, errors = fake.run()
    assert (code, "another sweep is running" in errors) == (2, True)
    fake.release()
    assert first.wait(timeout=20) == 0
    assert fake.results() == ["accuracy-a.json", "accuracy-b.json"]


def test_run_name_says_profile_and_revision(fake: FakeSweep) -> None:
    assert fake.run("--print-run-name")[1] == "tiny-01234567\n"
    fake.plan["dirty"] = True
    assert fake.run("--print-run-name")[1] == "tiny-01234567-dirty\n"
    fake.plan["revision"] = "unknown"
    fake.plan["dirty"] = False
    assert fake.run("--print-run-name")[1] == "tiny-worktree\n"


def test_the_timing_lock_is_no_link_and_readable_by_all(fake: FakeSweep) -> None:
    lock = fake.folder / "timing.lock"
    umask = os.umask(0o077)
    try:
        assert fake.run("--shard", "speed-a")[0] == 0
    finally:
        os.umask(umask)
    assert stat.S_IMODE(lock.stat().st_mode) == 0o644
    assert lock.read_bytes() == b""

    lock.unlink()
    lock.symlink_to(fake.folder / "elsewhere")
    code, _, errors = fake.run("--shard", "speed-b")
    assert (code, "PITBENCH_TIMING_LOCK" in errors) == (2, True)
    assert not (fake.folder / "elsewhere").exists()
