"""python3 -m analysis choose: what it prints and ends with."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path

import pandas as pd
import pytest

from analysis.__main__ import main

SCENE = ["--scalar", "f32", "--coordinates", "0", "1", "--altitude", "0.1"]


def choose(*words: str) -> int:
    return main(["choose", *words])


def test_it_answers_with_a_guarantee_a_time_and_three_reasons(
    small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert choose(str(small_run), *SCENE, "--tolerance", "0.01") == 0
    text = capsys.readouterr().out
    assert text.startswith("Take ")
    for part in ("guarantee  right for every point farther", "speed ", "ns a point"):
        assert part in text
    assert f"run        {small_run.name}" in text
    reasons = text[text.index("because") :].splitlines()
    assert len(reasons) == 4  # and the run


def test_it_says_so_where_nothing_of_the_run_is_right(
    small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert choose(str(small_run), *SCENE) == 0
    assert "No method of this run is right" in capsys.readouterr().out


def test_the_answer_as_json_has_the_command_that_makes_it(
    small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert choose(str(small_run), *SCENE, "--tolerance", "0.01", "--json") == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["schema"] == "pitbench-choice-1"
    assert answer["chosen"]["right_beyond"] <= 0.01
    assert len(answer["reasons"]) == 3
    words = answer["command"].split()[4:]
    assert choose(str(small_run), *words, "--json") == 0
    assert json.loads(capsys.readouterr().out) == answer


def test_without_a_run_the_newest_whole_one_is_taken(
    small_run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    results = tmp_path / "results"
    for age, name in enumerate(("newer", "older")):
        shutil.copytree(small_run, results / name)
        os.utime(results / name / "machine.json", (1e9 - age, 1e9 - age))
    unfinished = results / "unfinished"
    unfinished.mkdir()
    shutil.copy(small_run / "machine.json", unfinished)
    places = ["--results", str(results), "--runs", str(tmp_path / "none")]
    assert choose(*SCENE, "--tolerance", "0.01", *places) == 0
    assert "run        newer on" in capsys.readouterr().out
    assert choose("older", *SCENE, "--tolerance", "0.01", *places) == 0
    assert "run        older on" in capsys.readouterr().out


def test_without_any_run_it_says_how_to_make_one(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    nowhere = str(tmp_path / "none")
    assert choose(*SCENE, "--results", nowhere, "--runs", nowhere) == 2
    message = capsys.readouterr().err
    assert "no run in" in message and "./reproduce report" in message


@pytest.mark.parametrize(
    ("words", "message"),
    [
        (["--altitude", "9"], "--altitude 9: must be from 0 to"),
        (["--grid", "80"], "--grid 80: give columns and rows"),
        (["--grid", "-1", "x"], None),
        (["--isa", "mmx"], "--isa mmx: run small has rows of avx2, scalar only"),
        (["--need", "speed"], "--need speed: give one of class"),
        (["--coordinates", "3", "2"], "--coordinates 3 2: give two finite numbers"),
        (["--points-per-triangle", "many"], None),
    ],
)
def test_a_wrong_call_ends_with_2_and_names_the_option(
    words: list[str],
    message: str | None,
    small_run: Path,
    capsys: pytest.CaptureFixture[str],
) -> None:
    try:
        code = choose(str(small_run), *SCENE, *words)
    except SystemExit as end:
        code = int(end.code or 0)
    assert code == 2
    error = capsys.readouterr().err
    assert "Traceback" not in error
    assert (message or words[0]) in error


def test_a_run_that_is_not_there_is_named(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert choose("nowhere", *SCENE, "--runs", str(tmp_path)) == 2
    assert "nowhere: neither a folder of a run nor a name" in capsys.readouterr().err


@pytest.mark.parametrize("left_out", ["--scalar", "--coordinates"])
def test_a_scene_without_its_numbers_ends_with_2(
    left_out: str, small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = list(SCENE)
    at = words.index(left_out)
    del words[at : at + (2 if left_out == "--scalar" else 3)]
    with pytest.raises(SystemExit) as end:
        choose(str(small_run), *words)
    assert end.value.code == 2
    assert left_out in capsys.readouterr().err


def test_the_chapter_says_for_how_many_scenes_the_run_has_an_answer(
    small_run: Path, tmp_path: Path
) -> None:
    """Neither of the two methods of the run is exact, so most are left open."""
    alone = ["report", "--runs", str(tmp_path / "none"), str(small_run)]
    assert main([*alone, "--out", str(tmp_path)]) == 0
    page = (tmp_path / "index.html").read_text(encoding="utf-8")
    table = pd.read_csv(tmp_path / "tables" / "typical_scenes.csv")
    answered = int(table["ns"].notna().sum())
    assert 0 < answered < len(table)
    assert f"For {answered} of {len(table)} scenes that occur" in page
    needs = page[page.index("Which method to take") :]
    assert "If every answer has to be right: no method of this run is right" in needs
    assert (tmp_path / "tables" / "choice_map.csv").is_file()
