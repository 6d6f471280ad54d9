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
