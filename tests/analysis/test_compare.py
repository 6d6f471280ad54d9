"""Two runs compared: what is found, what is not, and how it ends."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

from analysis.__main__ import main
from analysis.cpus import compare as module
from analysis.cpus.compare import NO_DIFFERENCE, SLOWER, Comparison, compare
from analysis.cpus.compare_text import lines
from analysis.read.load import load_run
from analysis.read.read_json import LoadError
from analysis.read.run import Run
from analysis.trust.row_noise import TOLERANCE
from analysis.trust.stats import benjamini_hochberg, ratio_p_value
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import Options, write_run

HASH, OTHER_HASH = "ab" * 32, "cd" * 32
SMALL = dataclasses.replace(TWO_METHODS, profile="quick", kernel_hash=HASH)
SLOW = (("edge_function", 1.05),)


def run_of(folder: Path, **changes: object) -> Run:
    options = dataclasses.replace(SMALL, **changes)  # type: ignore[arg-type]
    return load_run(write_run(folder, options))


@pytest.fixture(scope="session")
def base(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_run(tmp_path_factory.mktemp("compare") / "a", SMALL)


def against(base: Path, folder: Path, **changes: object) -> Comparison:
    return compare(load_run(base), run_of(folder, **changes), across_revisions=True)


def test_nothing_is_claimed_more_often_than_stated_where_nothing_differs() -> None:
    """Timings with a floor, a tail and interruptions, of 20 cells, 1000 times."""
    runs, cells, level = 1000, 20, 0.05
    chance = np.random.default_rng(20)
    shape = (2, runs, cells, 9)
    tail = chance.exponential(0.01, shape)
    a, b = 100 * (1 + tail) * np.where(chance.random(shape) < 0.01, 3, 1)
    claimed = sum(
        min(benjamini_hochberg([ratio_p_value(y, x) for x, y in zip(*pair)])) <= level
        for pair in zip(a, b)
    )
    most = level + 4 * math.sqrt(level * (1 - level) / runs)
    # Some are: a test that never claims anything would pass the first half.
    assert 0 < claimed / runs <= most


@pytest.mark.parametrize("chance", range(1, 6))
def test_two_runs_of_one_program_show_no_regression(
    base: Path, tmp_path: Path, chance: int
) -> None:
    found = against(base, tmp_path / "b", chance=chance)
    assert set(found.cells["verdict"]) == {NO_DIFFERENCE}
    assert not found.worse


def test_one_method_that_is_five_percent_slower_is_found_and_only_that(
    tmp_path: Path,
) -> None:
    options = Options(kernel_hash=HASH)
    slower = dataclasses.replace(options, chance=7, speed_factor=SLOW)
    a = load_run(write_run(tmp_path / "a", options))
    b = load_run(write_run(tmp_path / "b", slower))
    found = compare(a, b)
    assert set(found.regressions["method"]) == {"edge_function"}
    assert found.improvements.empty
    changed = (found.cells["method"] == "edge_function") & (
        # The grid and the inputs are made up with times of their own.
        found.cells["scene"].str.startswith("uniform:hit=50:bytes=24k")
    )
    # Not all: what lies beyond TOLERANCE is but three times their noise.
    assert (found.cells[changed]["verdict"] == SLOWER).mean() > 0.8
    slow = found.regressions["ratio"]
    assert slow.between(1.03, 1.08).all() and slow.is_monotonic_decreasing
    back = compare(b, a)
    assert set(back.improvements["method"]) == {"edge_function"}
    assert back.regressions.empty and not back.worse


def test_an_a_a_pair_that_strayed_widens_what_may_be_chance(
    base: Path, tmp_path: Path
) -> None:
    changes = {"chance": 7, "speed_factor": (("edge_function", 1.08),)}
    assert len(against(base, tmp_path / "b", **changes).regressions)
    strayed = against(base, tmp_path / "c", **changes, twin_ratio=1.1)
    assert strayed.regressions.empty
    assert strayed.cells["within"].min() > 0.08


@pytest.mark.parametrize(
    "changes", [{"clock_after": 3.9}, {"cpu_share": 0.8}, {"steal_percent": 15.0}]
)
def test_a_clock_that_moved_and_time_that_was_lost_widen_it_too(
    base: Path, tmp_path: Path, changes: dict[str, float]
) -> None:
    found = against(base, tmp_path / "b", chance=7, speed_factor=SLOW, **changes)
    assert found.regressions.empty


def test_clocks_widen_it_on_cpus_of_one_design_only(base: Path, tmp_path: Path) -> None:
    """Virtual machines give CPUs of different designs the same name."""
    zen = {"vendor": "AuthenticAMD", "family": 25, "model": 1, "stepping": 1}
    a = run_of(tmp_path / "a", identity=zen)
    alike = run_of(tmp_path / "b", identity=zen, chance=7)
    other = run_of(tmp_path / "c", identity={**zen, "model": 17}, chance=7)
    assert alike.machine.model == other.machine.model
    assert alike.machine.name != other.machine.name
    widest = []
    for run in (load_run(base), alike, other):
        faster = tuple(
            dataclasses.replace(
                shard,
                clock_before_ghz=1.2 * shard.clock_before_ghz,
                clock_after_ghz=1.2 * shard.clock_after_ghz,
            )
            for shard in run.shards
        )
        found = compare(a, dataclasses.replace(run, shards=faster))
        widest.append(found.cells["within"].max())
    # Of the first, an older run, the design is not told.
    assert min(widest[:2]) >= 0.19 and widest[2] < 0.1


def test_the_band_is_never_below_what_matters(base: Path, tmp_path: Path) -> None:
    found = against(base, tmp_path / "b", chance=7)
    assert found.cells["within"].min() >= TOLERANCE


def test_moved_code_counts_only_between_builds_that_differ(
    base: Path, tmp_path: Path
) -> None:
    """In the made-up runs moving the code changes a time by up to 12 %."""
    changes = {"chance": 7, "speed_factor": SLOW}
    assert len(against(base, tmp_path / "b", **changes).regressions)
    other = against(base, tmp_path / "c", **changes, kernel_hash=OTHER_HASH)
    assert not other.same_build
    assert other.regressions.empty
    assert other.cells["within"].min() > 0.08


def test_more_errors_on_the_same_input_are_found_exactly(
    base: Path, tmp_path: Path
) -> None:
    more = (("edge_function", 1.5),)
    found = against(base, tmp_path / "b", error_factor=more)
    assert set(found.more_errors["method"]) == {"edge_function"}
    assert found.more_errors["exact"].all() and found.worse
    assert found.same_input == found.judged > 0
    assert against(base, tmp_path / "c").accuracy.empty


def test_other_input_is_no_verdict(base: Path, tmp_path: Path) -> None:
    more = (("edge_function", 1.5),)
    a, b = load_run(base), run_of(tmp_path / "b", error_factor=more)
    machine = dataclasses.replace(b.machine, seed=b.machine.seed + 1)
    found = compare(a, dataclasses.replace(b, machine=machine))
    assert found.same_input == 0 and len(found.accuracy)
    assert set(found.accuracy["verdict"]) == {module.OTHER_INPUT}
    assert not found.worse


def test_runs_of_other_kernels_are_refused_unless_asked_for(
    base: Path, tmp_path: Path
) -> None:
    other = run_of(tmp_path / "b", kernel_hash=OTHER_HASH)
    with pytest.raises(LoadError, match="measured other kernels.*--across-revisions"):
        compare(load_run(base), other)
    assert len(compare(load_run(base), other, across_revisions=True).cells)


@pytest.mark.parametrize(
    ("changes", "fits"),
    [({}, True), ({"revision": "1" * 40}, False), ({"dirty": True}, False)],
)
def test_without_a_hash_a_clean_revision_tells_the_kernels(
    tmp_path: Path, changes: dict[str, object], fits: bool
) -> None:
    a = run_of(tmp_path / "a", kernel_hash="")
    b = run_of(tmp_path / "b", kernel_hash="", **changes)
    if fits:
        compare(a, b)
    else:
        with pytest.raises(LoadError, match="may have measured other kernels"):
            compare(a, b)


def test_the_text_lists_the_worst_first_and_is_the_same_twice(
    base: Path, tmp_path: Path
) -> None:
    factors = (("edge_function", 1.2), ("cross_product", 1.5))
    found = against(base, tmp_path / "b", chance=3, speed_factor=factors)
    text = "\n".join(lines(found))
    again = against(base, tmp_path / "b", chance=3, speed_factor=factors)
    assert text == "\n".join(lines(again))
    assert text.index("/cross_product/f32") < text.index("/edge_function/f32")
    assert "By instruction set" in text and "By method" in text


def called(base: Path, b: Path, *more: str) -> int:
    return main(["compare", str(base), str(b), *more])


def test_exit_codes(
    base: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    slow = write_run(
        tmp_path / "slow",
        dataclasses.replace(SMALL, chance=7, speed_factor=(("edge_function", 1.3),)),
    )
    assert called(base, slow) == 0
    assert called(base, slow, "--fail-on-regression") == 1
    assert called(slow, base, "--fail-on-regression") == 0
    other = write_run(
        tmp_path / "other", dataclasses.replace(SMALL, kernel_hash=OTHER_HASH)
    )
    assert called(base, other) == 2
    assert "--across-revisions" in capsys.readouterr().err
    assert called(base, other, "--across-revisions", "--fail-on-regression") == 0
    assert called(base, tmp_path / "nowhere") == 2
    assert "neither a folder of a run nor a name" in capsys.readouterr().err
    with pytest.raises(SystemExit) as end:
        called(base, slow, "--level", "2")
    assert end.value.code == 2


def test_runs_without_a_common_cell_are_refused(base: Path, tmp_path: Path) -> None:
    other = run_of(tmp_path / "b", methods=("uv_projection",))
    with pytest.raises(LoadError, match="no cell in common"):
        compare(load_run(base), other)
