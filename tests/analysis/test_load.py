"""Files that fit are loaded; whatever does not is refused by file and field."""

from __future__ import annotations

import base64
import dataclasses
import json
import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from analysis.read.load import LoadError, load_run
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import REVISION, write_run

SPEED = "speed-one_triangle-f32.json"
ACCURACY = "accuracy-near_edge-f32.json"
MAPS = "maps.json"


def edit(path: Path, change: Callable[[Any], None]) -> None:
    document = json.loads(path.read_text())
    change(document)
    path.write_text(json.dumps(document))


def test_a_run_is_loaded_whole(small_run: Path) -> None:
    run = load_run(small_run)
    assert run.machine.revision == REVISION
    assert run.profile == "tiny"
    # 2 methods × 2 ISAs × fresh and fixed, a twin, a doubled one and 4 places; 9
    # repetitions each.
    assert len(run.speed) == (2 * 2 * 2 + 2 + 4) * 9
    assert set(run.speed["control"]) == {"", "twin", "doubled"} | {
        f"placed_{shift}" for shift in (0, 16, 32, 48)
    }
    assert len(run.accuracy) == 2 * 2 * 9
    assert [shard.name for shard in run.shards] == ["speed-one_triangle-f32"]
    assert {entry.key for entry in run.methods} == set(TWO_METHODS.methods)


def test_nanoseconds_are_of_one_item(small_run: Path) -> None:
    def two_items(document: Any) -> None:
        row = document["benchmarks"][0]
        row["items_per_second"] = 4e9

    edit(small_run / SPEED, two_items)
    assert load_run(small_run).speed["ns"].iloc[0] == 0.25


def test_a_shard_of_an_older_run_does_not_tell_how_much_of_its_cpu_it_had(
    small_run: Path,
) -> None:
    def forget(document: Any) -> None:
        for key in ("wall_seconds", "cpu_seconds", "preemptions"):
            del document["context"]["pitbench"][key]

    assert load_run(small_run).shards[0].preemptions == 12
    edit(small_run / SPEED, forget)
    assert math.isnan(load_run(small_run).shards[0].wall_seconds)


def test_a_run_without_methods_json_is_loaded(small_run: Path) -> None:
    (small_run / "methods.json").unlink()
    assert load_run(small_run).methods == ()


def test_each_class_of_failure_has_its_columns(small_run: Path) -> None:
    cell = json.loads((small_run / ACCURACY).read_text())["cells"][0]
    row = load_run(small_run).accuracy.set_index("name").loc[cell["name"]]
    share = cell["classes"]["rotated_vertices"]
    found = [row[f"rotated_vertices{end}"] for end in ("", "_of", "_low", "_high")]
    assert found == [share[key] for key in ("count", "of", "low", "high")]
    assert row["rotated_vertices_smallest"] == share["distance_ulps"]["smallest"]
    assert row[["hole", "hole_of"]].isna().all()


def test_the_worst_inputs_of_every_class_are_kept(small_run: Path) -> None:
    cells = json.loads((small_run / ACCURACY).read_text())["cells"]
    worst = load_run(small_run).worst
    expected = sum(len(s["worst"]) for c in cells for s in c["classes"].values())
    assert len(worst) == expected > 0
    assert set(worst["kind"]) > {"false_inside", "false_outside"}
    assert worst["b"].iloc[0] == "0x1p+0 0x0p+0"


def test_a_worst_input_without_a_distance_has_none(small_run: Path) -> None:
    def unknown(document: Any) -> None:
        for cell in document["cells"]:
            for share in cell["classes"].values():
                for answer in share["worst"]:
                    answer["distance_ulps"] = None

    edit(small_run / ACCURACY, unknown)
    assert load_run(small_run).worst["distance_ulps"].isna().all()


def test_bits_of_maps_are_read_row_by_row_and_lowest_first(small_run: Path) -> None:
    raw = bytearray(32 * 256)
    raw[32 * 5 + 2] = 0b1000_0010

    def one_row(document: Any) -> None:
        document["ulp_maps"][0]["lower"] = base64.b64encode(raw).decode()

    edit(small_run / MAPS, one_row)
    lower = load_run(small_run).maps.ulp_maps[0].lower
    assert [tuple(at) for at in zip(*lower.nonzero())] == [(5, 17), (5, 23)]


def test_a_run_without_maps_has_none(small_run: Path) -> None:
    (small_run / MAPS).unlink()
    assert load_run(small_run).maps.ulp_maps == ()


def test_a_warning_is_read(small_run: Path) -> None:
    def warn(document: Any) -> None:
        document["methods"][0]["warning"] = "breaks on NaN"
        del document["methods"][1]["warning"]

    edit(small_run / "methods.json", warn)
    said = [entry.warning for entry in load_run(small_run).methods]
    assert said == ["breaks on NaN", ""]


def test_an_aggregate_row_is_no_repetition(small_run: Path) -> None:
    before = len(load_run(small_run).speed)
    edit(
        small_run / SPEED,
        lambda d: d["benchmarks"].append(
            {"name": d["benchmarks"][0]["name"] + "_mean", "run_type": "aggregate"}
        ),
    )
    assert len(load_run(small_run).speed) == before


def test_a_refused_cell_is_listed_once_and_not_timed(small_run: Path) -> None:
    name = "one_triangle/uniform:hit=50:n=1:sets=fresh/cross_product/f32/avx2"
    row = {"name": name, "error_occurred": True, "error_message": "3 of 9 differ"}
    edit(small_run / SPEED, lambda d: d["benchmarks"].extend([row, row]))
    run = load_run(small_run)
    assert list(run.refused["reason"]) == ["3 of 9 differ"]
    assert name not in set(run.speed["name"])


def set_row(key: str, value: Any) -> Callable[[Any], None]:
    return lambda d: d["benchmarks"][0].update({key: value})


def set_cell(key: str, value: Any) -> Callable[[Any], None]:
    return lambda d: d["cells"][0].update({key: value})


def set_context(key: str, value: Any) -> Callable[[Any], None]:
    return lambda d: d["context"]["pitbench"].update({key: value})


BAD = [
    (SPEED, set_row("items_per_second", "fast"), "benchmarks[0].items_per_second"),
    (SPEED, set_row("items_per_second", 0), "benchmarks[0].items_per_second"),
    (SPEED, set_row("items_per_second", 1e-320), "benchmarks[0].items_per_second"),
    (SPEED, set_row("items_per_second", 10**400), "benchmarks[0].items_per_second"),
    (SPEED, set_row("time_unit", "ms"), "benchmarks[0].time_unit"),
    (SPEED, set_row("run_name", "nonsense"), "benchmarks[0].name"),
    (SPEED, lambda d: d["benchmarks"][0].pop("items"), "'items' is a required"),
    (SPEED, lambda d: d["context"].pop("pitbench"), "$.context"),
    (SPEED, lambda d: d["context"].update(host_name="mine"), "$.context"),
    (SPEED, set_context("profile", "slow"), "pitbench.profile"),
    (SPEED, set_context("surprise", 1), "surprise"),
    (SPEED, set_context("clock_after_ghz", 0), "pitbench.clock_after_ghz"),
    (SPEED, lambda d: d["benchmarks"].append(d["benchmarks"][0]), "is there twice"),
    (ACCURACY, set_cell("method", "edge_function_fma"), "cells[0].method"),
    (ACCURACY, set_cell("interior", 4901), "cells[0].classes.false_outside.of"),
    (ACCURACY, set_cell("boundary_rule", "shut"), "cells[0].boundary_rule"),
    (ACCURACY, set_cell("surprise", 1), "surprise"),
    (ACCURACY, lambda d: d["cells"].append(d["cells"][0]), "already in"),
    (
        ACCURACY,
        lambda d: d["cells"][0]["classes"]["false_inside"].update(count=5021),
        "cells[0].classes.false_inside.count",
    ),
    (
        ACCURACY,
        lambda d: d["cells"][30]["classes"]["negated"].pop("low"),
        "cells[30].classes.negated (one_triangle/",
    ),
    (
        ACCURACY,
        lambda d: d["cells"][0]["classes"].update(vanished={}),
        "'vanished' was unexpected",
    ),
    (
        ACCURACY,
        lambda d: d["context"].update(schema="pitbench-accuracy-1"),
        "$.context.schema",
    ),
    (MAPS, lambda d: d["ulp_maps"][1].pop("upper"), "$.ulp_maps[1]"),
    (
        MAPS,
        lambda d: d["ulp_maps"][1].update(lower="AAAA"),
        "$.ulp_maps[1].lower: has 3 bytes, not 8192",
    ),
    (
        MAPS,
        lambda d: d["ulp_maps"][0].update(upper="AAA"),
        "$.ulp_maps[0].upper: is not base64",
    ),
    (MAPS, lambda d: d["ulp_maps"][0].update(height=8), "$.ulp_maps[0].height"),
    ("machine.json", lambda d: d.pop("seed"), "'seed' is a required"),
    ("machine.json", lambda d: d["cpu"].update(cores=0), "$.cpu.cores"),
    ("machine.json", lambda d: d.update(surprise=1), "surprise"),
    ("methods.json", lambda d: d["methods"][0].pop("formula"), "methods[0]"),
]


@pytest.mark.parametrize(("name", "change", "says"), BAD)
def test_a_file_that_does_not_fit_is_refused_by_file_and_field(
    small_run: Path, name: str, change: Callable[[Any], None], says: str
) -> None:
    edit(small_run / name, change)
    with pytest.raises(LoadError) as error:
        load_run(small_run)
    assert str(small_run / name) in str(error.value)
    assert says in str(error.value)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"inside": ""}, "$.gradients[0].inside: has 0 bytes"),
        ({"width": 0, "weights": ""}, "$.gradients[0].width: 0 by 96 is no picture"),
        ({"weights": "AAAA"}, "$.gradients[0].weights: has 3 bytes"),
        ({"a": ["0x1p+9999", "0x1p+0"]}, "$.gradients[0].a: 0x1p+9999 is no double"),
    ],
)
def test_a_gradient_that_does_not_fit_is_refused(
    tmp_path: Path, change: dict[str, Any], says: str
) -> None:
    weighted = dataclasses.replace(TWO_METHODS, methods=("barycentric_inverse",))
    folder = write_run(tmp_path / "run", weighted)
    edit(folder / MAPS, lambda d: d["gradients"][0].update(change))
    with pytest.raises(LoadError) as error:
        load_run(folder)
    assert f"{folder / MAPS}: {says}" in str(error.value)


@pytest.mark.parametrize("key", ["revision", "profile", "dirty", "seed"])
@pytest.mark.parametrize("name", [SPEED, ACCURACY, MAPS])
def test_two_runs_in_one_folder_are_refused(
    small_run: Path, name: str, key: str
) -> None:
    other = {"revision": "abc", "profile": "full", "dirty": True, "seed": 9}
    document = json.loads((small_run / name).read_text())
    context = document["context"].get("pitbench", document["context"])
    context[key] = other[key]
    (small_run / name).write_text(json.dumps(document))
    with pytest.raises(LoadError, match="two runs are mixed"):
        load_run(small_run)


def test_one_cell_in_two_shards_is_refused(small_run: Path) -> None:
    text = (small_run / SPEED).read_text()
    (small_run / "speed-again.json").write_text(text)
    with pytest.raises(LoadError, match="is already in speed-again.json"):
        load_run(small_run)


def test_a_missing_folder_is_refused(tmp_path: Path) -> None:
    with pytest.raises(LoadError, match="no such folder"):
        load_run(tmp_path / "nowhere")


@pytest.mark.parametrize("kind", ["speed", "accuracy"])
def test_speed_without_accuracy_is_refused_and_the_reverse(
    small_run: Path, kind: str
) -> None:
    for path in small_run.glob(f"{kind}-*.json"):
        path.unlink()
    with pytest.raises(LoadError, match=f"no {kind}"):
        load_run(small_run)


@pytest.mark.parametrize("name", [SPEED, ACCURACY, "machine.json", "methods.json"])
def test_a_file_that_was_cut_off_is_refused(small_run: Path, name: str) -> None:
    text = (small_run / name).read_text()
    (small_run / name).write_text(text[: len(text) // 2])
    with pytest.raises(LoadError, match="is not JSON") as error:
        load_run(small_run)
    assert name in str(error.value)


@pytest.mark.parametrize(
    "content",
    [b"", b"\xff\xfe\x00", b"[" * 100_000, b'{"a": NaN}', b'{"a": 1e999}', b"7"],
    ids=["empty", "not_text", "deep", "nan", "too_large", "no_object"],
)
def test_what_is_no_json_of_ours_is_refused(small_run: Path, content: bytes) -> None:
    (small_run / SPEED).write_bytes(content)
    with pytest.raises(LoadError, match=SPEED):
        load_run(small_run)
