"""How long a sweep took, as its run tells and the page says."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from analysis.cpus import machines
from analysis.cpus.stored_run import load_stored
from analysis.read.load import LoadError, load_run
from analysis.read.run import SweepTimes
from analysis.report.machine_prose import times_facts
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


def test_a_file_that_does_not_fit_is_refused(tmp_path: Path) -> None:
    folder = write_run(tmp_path / "run", TWO_METHODS)
    path = folder / "times.json"
    document = json.loads(path.read_text())
    path.write_text(json.dumps(document | {"seconds": -1}))
    with pytest.raises(LoadError, match=r"times\.json: \$\.seconds"):
        load_run(folder)
