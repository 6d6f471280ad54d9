"""A sweep restricted to narrower instruction sets, and that it says so."""

from __future__ import annotations

import json
import re

import pytest
from tests.sweep.fake_sweep import FakeSweep

SHARDS = [
    ["speed-a", "speed"],
    ["operations", "operations"],
    ["instructions", "instructions"],
    ["maps", "maps"],
]


def arguments(fake: FakeSweep, shard: str) -> list[str]:
    document = json.loads((fake.out / f"{shard}.json").read_text())
    given: list[str] = document["arguments"]
    return given


def test_only_rows_up_to_the_isa_pass_the_filters(fake: FakeSweep) -> None:
    assert fake.run("--isa-up-to", "avx2")[0] == 0
    given = arguments(fake, "speed-a")
    pattern = re.compile(given[given.index("--filter") + 1])
    for isa, held in {
        "scalar": True,
        "ssse3": True,
        "sse4": True,
        "autovec_v2": True,
        "autovec_v3": True,
        "avx2": True,
        "avx2/twin": True,
        "library": True,
        "avx512": False,
        "autovec_v4": False,
        "avx512/twin": False,
        "neon": False,
    }.items():
        name = f"speed-a/uniform:n=5/cross_product/f32/{isa}"
        assert bool(pattern.search(name)) == held, isa
    # What the shard's own filter leaves out stays out.
    assert not pattern.search("speed-b/uniform:n=5/cross_product/f32/avx2")


def test_without_the_option_the_filters_are_as_listed(fake: FakeSweep) -> None:
    assert fake.run()[0] == 0
    assert "^speed-a/" in arguments(fake, "speed-a")
    assert "isa_up_to" not in json.loads((fake.out / "sweep.json").read_text())


def test_the_folder_says_so_and_takes_no_other_rows(fake: FakeSweep) -> None:
    assert fake.run("--isa-up-to", "sse4")[0] == 0
    assert json.loads((fake.out / "sweep.json").read_text())["isa_up_to"] == "sse4"
    code, _, errors = fake.run()
    assert code == 2
    assert "begun with --isa-up-to sse4, and this is --isa-up-to none" in errors


def test_counts_stay_and_maps_of_wider_kernels_go(fake: FakeSweep) -> None:
    fake.plan["shards"] = SHARDS
    assert fake.run("--isa-up-to", "avx2")[0] == 0
    assert not (fake.out / "maps.json").exists()
    assert (fake.out / "instructions.json").exists()
    assert "^operations/" in arguments(fake, "operations")


def test_instructions_are_traced_of_the_widest_isa_that_is_left(
    fake: FakeSweep,
) -> None:
    fake.plan["shards"] = [["instructions", "instructions"]]
    assert fake.run("--isa-up-to", "avx2")[0] == 0
    given = arguments(fake, "instructions")
    pattern = re.compile(given[given.index("--filter") + 1])
    assert pattern.search("one_triangle/exact/f32/avx2")
    # As the shard asks for, which here is all of its own name.
    assert pattern.search("instructions/exact/f32/neon")
    assert pattern.search("instructions/exact/f32/sse4")
    assert not pattern.search("instructions/exact/f32/avx512")
    assert not pattern.search("one_triangle/exact/f32/avx512")


@pytest.mark.parametrize("isa", ["avx3", "autovec_v3", "AVX2"])
def test_an_unknown_isa_is_refused_with_those_there_are(
    fake: FakeSweep, isa: str
) -> None:
    code, _, errors = fake.run("--isa-up-to", isa)
    assert code == 2
    assert f"--isa-up-to {isa}: no such instruction set" in errors
    assert "avx2, avx512" in errors
    assert not fake.out.exists()


def test_the_name_of_a_run_says_so(fake: FakeSweep) -> None:
    code, output, _ = fake.run("--print-run-name", "--isa-up-to", "avx2")
    assert (code, output) == (0, "tiny-01234567-avx2\n")
