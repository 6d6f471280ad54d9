"""CPUs are told apart by the numbers that they identify themselves with."""

from __future__ import annotations

import dataclasses
from pathlib import Path

import pytest

from analysis.read.load import load_run
from analysis.read.microarchitecture import design, identity_words
from analysis.report.machine_prose import machine_rows
from analysis.speed.cost_exhibits import with_models
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run


@pytest.mark.parametrize(
    ("vendor", "family", "model", "stepping", "told"),
    [
        ("AuthenticAMD", 23, 0x31, 0, "Zen 2"),
        ("AuthenticAMD", 25, 0x01, 1, "Zen 3"),
        ("AuthenticAMD", 25, 0x11, 1, "Zen 4"),
        ("AuthenticAMD", 26, 0x02, 1, "Zen 5"),
        ("AuthenticAMD", 99, 0x02, 1, ""),
        ("GenuineIntel", 6, 0x55, 4, "Skylake server"),
        ("GenuineIntel", 6, 0x55, 7, "Cascade Lake"),
        ("GenuineIntel", 6, 0x55, 11, "Cooper Lake"),
        ("GenuineIntel", 6, 0x6A, 6, "Ice Lake server"),
        ("GenuineIntel", 6, 0x8F, 8, "Sapphire Rapids"),
        ("GenuineIntel", 6, 0xFF, 0, ""),
        ("0x41", 8, 0xD0C, 1, "Neoverse N1"),
    ],
)
def test_known_cpus_have_their_design(
    vendor: str, family: int, model: int, stepping: int, told: str
) -> None:
    identity = {"vendor": vendor, "family": family, "model": model}
    assert design({**identity, "stepping": stepping}) == told


def test_what_is_not_told_has_none() -> None:
    assert design(None) == identity_words(None) == ""


def test_a_run_names_its_cpu_and_takes_the_model_of_it(tmp_path: Path) -> None:
    zen = {"vendor": "AuthenticAMD", "family": 25, "model": 17, "stepping": 1}
    options = dataclasses.replace(TWO_METHODS, model="AMD EPYC", identity=zen)
    run = load_run(write_run(tmp_path / "a", options))
    assert run.machine.name == "AMD EPYC, Zen 4"
    words = "AuthenticAMD family 25, model 17, stepping 1"
    assert ("It identifies itself as", words) in machine_rows(run.machine)
    modelled = with_models(run)
    assert modelled.not_modelled or modelled.nearest_model == "znver4"
    older = dataclasses.replace(options, identity=None)
    machine = load_run(write_run(tmp_path / "b", older)).machine
    assert (machine.name, machine.design) == ("AMD EPYC", "")
    assert machine.same_cpu(run.machine)


def test_a_name_that_tells_the_design_is_left_as_it_is(tmp_path: Path) -> None:
    identity = {"vendor": "0x41", "family": 8, "model": 0xD0C, "stepping": 1}
    named = dataclasses.replace(TWO_METHODS, model="Neoverse N1", identity=identity)
    assert load_run(write_run(tmp_path / "a", named)).machine.name == "Neoverse N1"
