"""python3 -m analysis: what it prints, writes and ends with."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from analysis.__main__ import main
from analysis.report.readme import BEGIN, END, replaced

ALONE = ("report", "--runs", "no_runs")  # not beside those that the repository keeps


def test_report_writes_beside_the_run_and_prints_the_page_last(
    small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main([*ALONE, str(small_run)]) == 0
    page = small_run / "report" / "index.html"
    assert capsys.readouterr().out.splitlines()[-1] == str(page)
    assert page.is_file()
    assert (page.parent / "tables" / "cells.csv").is_file()
    assert (page.parent / "report.pdf").read_bytes().startswith(b"%PDF-")
    text = page.read_text()
    assert 'href="report.pdf"' in text and 'href="../machine.json"' in text
    assert [p for p in page.parent.rglob(".*") if p.is_file()] == []


def test_report_writes_where_it_is_told(small_run: Path, tmp_path: Path) -> None:
    assert main([*ALONE, str(small_run), "--out", str(tmp_path / "there")]) == 0
    page = tmp_path / "there" / "index.html"
    assert 'href="../machine.json"' not in page.read_text()
    assert not (small_run / "report").exists()


def test_a_bad_file_ends_with_2_a_clear_message_and_no_report(
    small_run: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = small_run / "machine.json"
    document = json.loads(path.read_text())
    document["cpu"]["cores"] = "two"
    path.write_text(json.dumps(document))
    assert main(["report", str(small_run)]) == 2
    message = capsys.readouterr().err
    assert f"{path}: $.cpu.cores" in message
    assert "Traceback" not in message
    assert not (small_run / "report").exists()


def test_a_place_that_cannot_be_written_ends_with_2(
    small_run: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "file").write_text("")
    out = tmp_path / "file" / "report"
    assert main([*ALONE, str(small_run), "--out", str(out)]) == 2
    assert "Not a directory" in capsys.readouterr().err


@pytest.mark.parametrize("arguments", [[], ["dance"], ["report"], ["report", "a", "b"]])
def test_a_wrong_call_ends_with_2(arguments: list[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(arguments)
    assert end.value.code == 2


def test_help_shows_examples(capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main(["--help"])
    assert end.value.code == 0
    assert "python3 -m analysis report results/quick" in capsys.readouterr().out


def test_readme_is_rewritten_between_its_markers_only(
    small_run: Path, tmp_path: Path
) -> None:
    readme = tmp_path / "README.md"
    readme.write_text(f"# Title\n\n{BEGIN}\nold\n{END}\n\nThe end.\n")
    assert main(["readme", str(small_run), "--readme", str(readme)]) == 0
    text = readme.read_text()
    assert text.startswith(f"# Title\n\n{BEGIN}\n![Speed against error")
    assert text.endswith(f"{END}\n\nThe end.\n")
    assert "old" not in text
    assert "| edge_function |" in text
    assert (tmp_path / "report" / "readme" / "hero.png").is_file()
    assert main(["readme", str(small_run), "--readme", str(readme)]) == 0
    assert readme.read_text() == text


@pytest.mark.parametrize(
    "text", ["", BEGIN, f"{END} {BEGIN}", f"{BEGIN}{END}{BEGIN}{END}"]
)
def test_a_readme_without_its_markers_is_left_alone(
    small_run: Path, tmp_path: Path, text: str, capsys: pytest.CaptureFixture[str]
) -> None:
    readme = tmp_path / "README.md"
    readme.write_text(text)
    assert main(["readme", str(small_run), "--readme", str(readme)]) == 2
    assert "README.md: needs one line" in capsys.readouterr().err
    assert readme.read_text() == text
    assert not (tmp_path / "report").exists()


def test_backslashes_in_what_was_measured_stay() -> None:
    assert replaced(f"{BEGIN}{END}", r"a\1b") == f"{BEGIN}\na\\1b\n{END}"
