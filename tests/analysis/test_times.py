"""How long build and sweep took, as their run tells and the page says."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from analysis.cpus import machines
from analysis.cpus.stored_run import load_stored
from analysis.read.load import LoadError, load_run
from analysis.read.run import Build, SweepTimes
from analysis.report.machine_prose import build_facts, times_facts
from analysis.report.page import render
from analysis.report.report import build
from analysis.report.wording import duration
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import write_run

TIMES = SweepTimes(100.0, 2, (("speed-a", 60.0), ("maps", 20.0), ("limits", 10.0)))


@pytest.mark.parametrize(
    ("seconds", "text"),
    [(2.0, "2.00\u00a0s"), (231.4, "231\u00a0s"), (3000.0, "50.0\u00a0min")],
)
def test_a_duration_is_in_seconds_up_to_ten_minutes(seconds: float, text: str) -> None:
    assert duration(seconds) == text


def test_the_times_in_phrases() -> None:
    told = times_facts(TIMES)
    assert told is not None
    assert told["total"] == duration(100.0)
    assert told["alone"] == duration(70.0)  # without the maps
    assert (told["longest"], told["longest_took"]) == ("speed-a", duration(60.0))
    assert told["starts_words"] == "2 starts"
    assert times_facts(None) is None


def test_the_build_in_phrases() -> None:
    cold = build_facts(Build(seconds=125, compiled=410, from_cache=0))
    assert cold == {"took": duration(125), "files": "410 files", "cached": 0}
    warm = build_facts(Build(seconds=25, compiled=10, from_cache=400))
    assert warm == {"took": duration(25), "files": "410 files", "cached": 400}
    assert build_facts(Build(seconds=1, compiled=0, from_cache=0)) is None
    assert build_facts(None) is None


def test_the_page_says_how_long_building_took(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", TWO_METHODS)
    built = f"took {duration(125)}"
    page = render(build(load_run(folder)), "index.html.j2")
    assert f"410 files with nothing in a compiler's cache, {built}" in page
    document = json.loads((folder / "build.json").read_text())
    (folder / "build.json").write_text(json.dumps(document | {"from_cache": 90}))
    page = render(build(load_run(folder)), "index.html.j2")
    assert f"500 files of which 90 came out of a compiler's cache, {built}" in page
    (folder / "build.json").unlink()
    assert "compiler's cache" not in render(build(load_run(folder)), "index.html.j2")


def test_the_page_says_how_long_measuring_took(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", TWO_METHODS)
    run = load_run(folder)
    assert run.times is not None and run.times.starts == 2
    page = render(build(run), "index.html.j2")
    assert f"Measuring took {duration(run.times.seconds)} in all, in 2 starts" in page
    (folder / "times.json").unlink()
    older = load_run(folder)
    assert older.times is None
    assert "Measuring took" not in render(build(older), "index.html.j2")


def test_a_stored_run_keeps_them(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run")
    kept = machines.add(folder, tmp_path / "runs", machines.Wanted(noisy=True))
    assert load_stored(kept).times == load_run(folder).times is not None
    assert load_stored(kept).built == load_run(folder).built is not None


def test_a_file_that_does_not_fit_is_refused(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", TWO_METHODS)
    path = folder / "times.json"
    document = json.loads(path.read_text())
    path.write_text(json.dumps(document | {"seconds": -1}))
    with pytest.raises(LoadError, match=r"times\.json: \$\.seconds"):
        load_run(folder)
