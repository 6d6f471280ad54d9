"""Runs kept for comparison: what is taken, what is refused, what is left."""

from __future__ import annotations

import dataclasses
import gzip
import json
import math
import subprocess
from pathlib import Path
from typing import Any

import pandas as pd
import pytest

from analysis.__main__ import main
from analysis.cpus import run_labels
from analysis.cpus.compare import compare
from analysis.cpus.machines import Unfit, Wanted, add, anonymous, private
from analysis.cpus.stored_run import (
    MEASURED,
    fingerprint,
    load_stored,
    open_run,
    packed,
)
from analysis.read.kernel_hash import kernel_hash
from analysis.read.load import load_run
from analysis.read.read_json import LoadError
from analysis.read.run import CLASSES
from analysis.speed.bounds import with_bounds
from analysis.speed.limit_tables import at_the_widest, with_instructions
from analysis.speed.operations_tables import cost_table
from analysis.speed.tables import speed_cells
from analysis.trust import noise
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run

SMALL = dataclasses.replace(TWO_METHODS, profile="quick", kernel_hash="ab" * 32)


@pytest.fixture
def run(tmp_path: Path) -> Path:
    return write_run(tmp_path / "run", SMALL)


def edit(path: Path, change: Any) -> None:
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))


def test_what_is_kept_says_the_same(run: Path, tmp_path: Path) -> None:
    whole, kept = load_run(run), load_stored(add(run, tmp_path / "runs"))
    assert fingerprint(whole) == fingerprint(kept)
    found = compare(whole, kept)
    assert (found.cells["ratio"] - 1).abs().max() < 1e-4
    assert found.same_input == len(whole.accuracy) and found.accuracy.empty
    columns = ["name", "points", "interior", "boundary_rule", "accepts"]
    for kind in CLASSES:
        columns += [kind, f"{kind}_of", f"{kind}_low", f"{kind}_high"]
    first, second = (
        each.accuracy[columns].sort_values("name", ignore_index=True)
        for each in (whole, kept)
    )
    pd.testing.assert_frame_equal(first, second, check_dtype=False, rtol=1e-9)
    assert (whole.machine, whole.methods) == (kept.machine, kept.methods)
    assert (run_labels.label_of(kept), kept.profile) == (whole.machine.model, "quick")
    assert kept.limits is not None and kept.limits.moved == whole.limits.moved != {}
    assert len(kept.operations) == len(whole.operations)


def test_the_same_run_gives_the_same_bytes(run: Path, tmp_path: Path) -> None:
    first, second = (add(run, tmp_path / name) for name in ("one", "two"))
    names = sorted(path.name for path in first.iterdir())
    assert names == sorted(path.name for path in second.iterdir())
    for name in names:
        assert (first / name).read_bytes() == (second / name).read_bytes()
    # The time that gzip would write into its header.
    assert (first / MEASURED).read_bytes()[4:8] == bytes(4)
    before = (first / MEASURED).stat().st_size
    add(run, tmp_path / "one")  # the very same run once more is no other
    assert (first / MEASURED).stat().st_size == before


def test_another_run_does_not_take_its_place(run: Path, tmp_path: Path) -> None:
    add(run, tmp_path / "runs")
    other = write_run(tmp_path / "other", dataclasses.replace(SMALL, chance=3))
    with pytest.raises(Unfit, match="holds another run: give a --name"):
        add(other, tmp_path / "runs")
    assert add(other, tmp_path / "runs", Wanted(name="mine")).name == "mine"


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"profile": "tiny"}, "profile tiny is a trial"),
        ({"dirty": True}, "sources with changes.*commit"),
        ({"revision": "unknown"}, "its revision is unknown"),
        ({"twin_ratio": 1.2}, "noise verdict is “noisy”.*--noisy"),
    ],
)
def test_a_run_that_is_not_fit_is_refused_with_what_to_do(
    tmp_path: Path, changes: dict[str, Any], told: str
) -> None:
    folder = write_run(tmp_path / "run", dataclasses.replace(SMALL, **changes))
    with pytest.raises(Unfit, match=told):
        add(folder, tmp_path / "runs")
    assert not (tmp_path / "runs").exists()


def test_a_noisy_run_is_kept_if_that_is_wanted(tmp_path: Path) -> None:
    noisy = dataclasses.replace(SMALL, twin_ratio=1.2)
    folder = write_run(tmp_path / "run", noisy)
    kept = load_stored(add(folder, tmp_path / "runs", Wanted(noisy=True)))
    table = run_labels.table([kept])
    assert list(table["noise"]) == ["noisy"]


@pytest.mark.parametrize("name", ["limits.json", "methods.json", "operations.json"])
def test_a_run_that_is_not_complete_is_refused(
    run: Path, tmp_path: Path, name: str
) -> None:
    (run / name).unlink()
    with pytest.raises(Unfit, match=f"{name} is missing.*goes on"):
        add(run, tmp_path / "runs")


def test_shards_that_never_ran_and_that_failed_are_told(
    run: Path, tmp_path: Path
) -> None:
    edit(run / "sweep.json", lambda sweep: sweep["shards"].append("speed-pairs-f64"))
    (run / "speed-grid.json.failed").write_text("{}")
    with pytest.raises(Unfit) as refused:
        add(run, tmp_path / "runs")
    assert "speed-pairs-f64.json is missing" in str(refused.value)
    assert "speed-grid failed: run the sweep again" in str(refused.value)


def test_a_file_that_does_not_fit_its_schema_is_refused(
    run: Path, tmp_path: Path
) -> None:
    edit(run / "machine.json", lambda machine: machine["cpu"].pop("cores"))
    with pytest.raises(LoadError, match="machine.json: .*cores"):
        add(run, tmp_path / "runs")


def test_anonymous_takes_away_what_a_site_named(run: Path, tmp_path: Path) -> None:
    def name_it(machine: dict[str, Any]) -> None:
        machine["os"]["kernel"] = "Linux 6.1.0-18-acme-cluster"
        machine["cpu"]["hypervisor"] = "Acme Cloud"

    edit(run / "machine.json", name_it)
    kept = add(run, tmp_path / "runs", Wanted(anonymous=True))
    text = (kept / "machine.json").read_text()
    text += gzip.decompress((kept / MEASURED).read_bytes()).decode()
    assert "acme" not in text.lower()
    assert load_stored(kept).machine.kernel == "Linux 6.1"


def test_kernel_without_numbers_is_not_told() -> None:
    document = {"cpu": {"hypervisor": "x"}, "os": {"kernel": "secret"}}
    assert anonymous(document)["os"]["kernel"] == "not told"


@pytest.mark.parametrize(
    ("text", "told"),
    [
        ("-O3 -ffile-prefix-map=/srv/ada/pitbench=.", "/srv/ada/"),
        ("/srv/build/kernels", "/srv/build/"),
        ("built on babbage", "babbage"),
        ("C:\\Users\\ada", "C:\\Users\\ada"),
        ("one_triangle/uniform:n=5/exact/f32/avx2", ""),
        ("kernels/methods/exact.cc", ""),
        ("x / y", ""),
        ("babbages", ""),
    ],
)
def test_paths_and_names_are_found_and_cells_are_none(text: str, told: str) -> None:
    found = private({"a": [{"b": text}]}, ["babbage"])
    assert [entry[1].startswith(told) for entry in found] == [True] * bool(told)
    assert all(entry[0] == "$.a[0].b" for entry in found)


def test_a_run_with_a_path_in_its_files_is_refused(run: Path, tmp_path: Path) -> None:
    def leak(machine: dict[str, Any]) -> None:
        first = next(iter(machine["compiler"]["flags"].values()))
        first["simd"] = "-O3 -fdebug-prefix-map=/srv/ada/src=."

    edit(run / "machine.json", leak)
    with pytest.raises(Unfit, match="machine.json: .*“/srv/ada/src” tells a path"):
        add(run, tmp_path / "runs")


def test_a_restricted_run_says_so_in_name_and_label(tmp_path: Path) -> None:
    limited = dataclasses.replace(SMALL, isa_up_to="avx2")
    kept = add(write_run(tmp_path / "run", limited), tmp_path / "runs")
    assert kept.name.endswith("-avx2")
    assert run_labels.label_of(load_stored(kept)).endswith(", ISAs up to avx2")


def test_a_spoilt_stored_run_is_refused_by_field(run: Path, tmp_path: Path) -> None:
    kept = add(run, tmp_path / "runs")
    good = json.loads(gzip.decompress((kept / MEASURED).read_bytes()))

    def refuses(message: str, **changes: Any) -> None:
        text = json.dumps({**good, **changes}).encode()
        (kept / MEASURED).write_bytes(gzip.compress(text))
        with pytest.raises(LoadError, match=message):
            load_stored(kept)

    twice = [good["speed"][0], good["speed"][0]]
    refuses(r"\$\.speed\[1\]\.cell: .* is there twice", speed=twice)
    refuses(r"\$\.speed\[0\]\.ns", speed=[{**good["speed"][0], "ns": [-1]}])
    refuses("shard: 9, but there are", speed=[{**good["speed"][0], "shard": 9}])
    refuses("counts: 11 of them for 1 classes", classes=["hole"])
    context = {**good["context"], "revision": "1" * 40}
    refuses("two runs are mixed", context=context)
    (kept / MEASURED).write_bytes(b"\x1f\x8bnonsense")
    with pytest.raises(LoadError, match="cannot be read"):
        load_stored(kept)


def test_the_commands_add_list_and_find_by_name(
    run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    runs = ["--runs", str(tmp_path / "runs")]
    assert main(["machines", "list", *runs]) == 0
    assert "no run in" in capsys.readouterr().out
    given = ["machines", "add", str(run), "--name", "mine", "--label", "My CPU"]
    assert main([*given, "--anonymous", *runs]) == 0
    assert main(["machines", "list", *runs]) == 0
    printed = capsys.readouterr().out
    assert "My CPU" in printed and "stale" in printed
    assert main(["compare", "mine", str(run), *runs]) == 0
    assert open_run("mine", tmp_path / "runs").label == "My CPU"
    assert main(["machines", "add", str(tmp_path / "runs" / "mine"), *runs]) == 2
    assert "is a stored run already" in capsys.readouterr().err


def test_the_hash_of_the_kernels_follows_their_text_and_names(tmp_path: Path) -> None:
    assert kernel_hash(tmp_path) == ""
    folder = tmp_path / "kernels" / "methods"
    folder.mkdir(parents=True)
    (folder / "a.cc").write_text("int a;")
    first = kernel_hash(tmp_path)
    (folder / "README.md").write_text("no code")
    assert kernel_hash(tmp_path) == first
    (folder / "a.cc").rename(folder / "b.cc")
    second = kernel_hash(tmp_path)
    (folder / "b.cc").write_text("int b;")
    third = kernel_hash(tmp_path)
    assert len({first, second, third}) == 3
    (folder / "b.cc").write_text("// What b is for.\n\n  // More.\nint b;  // b\n")
    assert kernel_hash(tmp_path) == third
    build = folder.parent / "CMakeLists.txt"
    build.write_text("add(b)\n")
    fourth = kernel_hash(tmp_path)
    build.write_text("# Builds b.\nadd(b)\n  # More.\n")
    assert kernel_hash(tmp_path) == fourth != third


def test_the_build_and_the_analysis_give_the_same_hash(tmp_path: Path) -> None:
    """harness/build_info.cmake says what the program will say of itself."""
    root = run_labels.ROOT
    commands, out = tmp_path / "commands.json", tmp_path / "info.inc"
    commands.write_text('[{"file": "x", "command": "y"}]')
    defined = {"SOURCE": root, "COMMANDS": commands, "OUT": out}
    options = [f"-D{key}={value}" for key, value in defined.items()]
    script = str(root / "harness" / "build_info.cmake")
    subprocess.run(["cmake", *options, "-P", script], check=True)
    assert f'kKernelHash[] = "{kernel_hash(root)}"' in out.read_text()


def test_a_kept_run_is_noisy_for_the_same_reasons(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", SMALL)
    for path in folder.glob("speed-*.json"):
        edit(path, lambda it: it["context"]["pitbench"].update(quiet_share=0.25))
    whole = load_run(folder)
    kept = load_stored(add(folder, tmp_path / "runs", Wanted(noisy=True)))
    assert kept.shards == whole.shards
    first, second = (noise.judge(run.speed, run.shards) for run in (whole, kept))
    assert first.word == "noisy"
    assert "only 25 % of its slices" in first.reasons[0].text
    assert second.reasons == first.reasons


def test_a_kept_run_tells_how_many_instructions_it_executed(
    run: Path, tmp_path: Path
) -> None:
    whole, kept = load_run(run), load_stored(add(run, tmp_path / "runs"))
    keys = ["method", "scalar", "loop", "isa"]
    columns = [*keys, "per_call", "per_item", "items_per_iteration"]
    first, second = (
        each.instructions[columns].sort_values(keys, ignore_index=True)
        for each in (whole, kept)
    )
    assert len(second) > 0 and kept.not_traced == ""
    pd.testing.assert_frame_equal(first, second, check_dtype=False)
    tables = [
        cost_table(each.operations, each.instructions, "f32") for each in (whole, kept)
    ]
    assert tables[1]["instructions"].notna().all()
    pd.testing.assert_frame_equal(*tables)
    near = [
        with_instructions(
            at_the_widest(
                with_bounds(speed_cells(each.speed), each.limits, each.operations)
            ),
            each.instructions,
            each.shards,
        )
        for each in (whole, kept)
    ]
    assert near[0]["instructions"].notna().any()
    assert near[1]["instructions"].tolist() == pytest.approx(
        near[0]["instructions"].tolist(), nan_ok=True
    )


def test_a_run_kept_earlier_tells_less_and_loads(run: Path, tmp_path: Path) -> None:
    folder = add(run, tmp_path / "runs")
    document = json.loads(gzip.decompress((folder / MEASURED).read_bytes()))
    del document["instructions"], document["not_traced"]
    for shard in document["shards"]:
        shard.pop("quiet_share", None)
    (folder / MEASURED).write_bytes(packed(document))
    kept = load_stored(folder)
    assert kept.instructions.empty and "no count" in kept.not_traced
    assert all(math.isnan(shard.quiet_share) for shard in kept.shards)
