"""Limits that were measured before the methods and again after them."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any

import pytest

from analysis.read.load import load_run
from analysis.read.load_limits import load_limits
from analysis.read.read_json import LoadError
from analysis.report.wording import significant
from analysis.speed.limit_columns import bandwidth_columns
from analysis.speed.limit_prose import _clock_moved
from analysis.speed.limit_tables import bandwidths, rates
from tests.analysis.test_bounds import CONTEXT, ISAS, loaded, same_run
from tests.analysis.synthetic_limits import limits as limits_document

Document = dict[str, Any]


def both(folder: Path, first: Document, again: Document) -> Any:
    for name, document in (("limits", first), ("limits_after", again)):
        (folder / f"{name}.json").write_text(json.dumps(document))
    return load_limits(folder, same_run(folder))


def scaled(document: Document, part: str, which: Any, factor: float) -> Document:
    """With the rates of the rows of `part` that `which` chooses times `factor`."""
    found = copy.deepcopy(document)
    for row in found[part]:
        if which(row):
            for name in row:
                if isinstance(row[name], float):
                    row[name] *= factor
    return found


def test_of_both_the_better_counts(tmp_path: Path) -> None:
    first = limits_document(CONTEXT, ISAS)
    again = scaled(first, "memory", lambda row: row["level"] == "DRAM", 1.25)
    again = scaled(again, "memory", lambda row: row["level"] == "L1", 0.5)
    again = scaled(again, "operations", lambda row: row["operation"] == "add", 0.75)
    (tmp_path / "one").mkdir()
    one = loaded(tmp_path / "one", first)
    two = both(tmp_path, first, again)
    for isa in ISAS:
        nearest, farthest = (
            two.bandwidth(isa, "f32", level) / one.bandwidth(isa, "f32", level)
            for level in ("L1", "DRAM")
        )
        assert nearest == 1
        assert farthest == pytest.approx(1.25)
        assert two.rate(isa, "f32", "add") == one.rate(isa, "f32", "add")
    assert two.moved == {
        "memory": (0.5, 1.25),
        "operations": (0.75, 1.0),
    }
    assert one.moved == {}


def test_a_limit_keeps_the_repetitions_that_it_came_of(tmp_path: Path) -> None:
    first = limits_document(CONTEXT, ISAS)
    two = both(tmp_path, first, scaled(first, "memory", lambda row: True, 2.0))
    assert len(two.memory) == len(first["memory"])
    assert (two.memory["median"] / two.memory["bytes_per_second"]).tolist() == (
        pytest.approx([0.97] * len(two.memory))
    )


def test_other_levels_are_refused(tmp_path: Path) -> None:
    first = limits_document(CONTEXT, ISAS)
    again = copy.deepcopy(first)
    again["levels"][0]["capacity_bytes"] += 1024
    with pytest.raises(LoadError, match=r"limits_after\.json: \$\.levels: other"):
        both(tmp_path, first, again)


def test_a_spoilt_second_file_is_refused_by_its_name(tmp_path: Path) -> None:
    first = limits_document(CONTEXT, ISAS)
    again = copy.deepcopy(first)
    again["operations"].append(again["operations"][0])
    with pytest.raises(LoadError, match=r"limits_after\.json: \$\.operations\["):
        both(tmp_path, first, again)


def test_a_run_reads_both(small_run: Path, tmp_path: Path) -> None:
    run = load_run(small_run)
    assert run.limits is not None
    assert run.limits.moved == {"memory": (1.0, 1.0), "operations": (1.0, 1.0)}


def clocked(document: Document, before: float, after: float) -> Document:
    found = copy.deepcopy(document)
    found["context"] |= {"clock_before_ghz": before, "clock_after_ghz": after}
    return found


def test_a_rate_is_divided_by_the_highest_clock_of_its_own_file(
    tmp_path: Path,
) -> None:
    first = clocked(limits_document(CONTEXT, ISAS), 4.5, 4.2)
    again = scaled(first, "memory", lambda row: row["level"] == "L1", 1.25)
    again = scaled(again, "operations", lambda row: row["operation"] == "add", 1.25)
    two = both(tmp_path, first, clocked(again, 4.1, 4.3))
    assert two.clocks_ghz == (4.5, 4.2, 4.1, 4.3)
    walks, counts = bandwidths(two), rates(two)
    for table, key, clock in (
        (walks, "load_L1", 4.3),
        (walks, "load_L2", 4.5),
        (counts, "add", 4.3),
        (counts, "multiply", 4.5),
    ):
        ratios = table[key] / table[f"{key}_per_cycle"] / 1e9
        assert ratios.dropna().tolist() == pytest.approx([clock] * ratios.count())
    shown = next(c for c in bandwidth_columns(two) if c.title.startswith("load L1"))
    row = walks.to_dict("records")[0]
    assert shown.note is not None
    assert shown.note(row) == f"{significant(row['load_L1_per_cycle'])} B a cycle"


def test_the_chapter_says_when_the_clock_moved() -> None:
    assert _clock_moved((3.5, 3.5, 3.45, 3.5)) == ""
    words = _clock_moved((4.5, 4.2, 4.5, 4.5))
    assert words == "4.50, 4.20, 4.50 and 4.50 GHz (7.1 % apart)"
