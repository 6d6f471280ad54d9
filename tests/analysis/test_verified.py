"""What `pitbench verify` found apart from a run, as the report shows it."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

from analysis.accuracy.verified import FOLDER, OTHERS, SAME, verified, verified_words
from analysis.read.kernel_hash import kernel_hash
from analysis.read.read_json import LoadError
from tests.analysis.test_schemas import VERIFIED

HASH = VERIFIED["context"]["kernel_hash"]


def kept(folder: Path, name: str, context: dict[str, Any] = {}, **other: Any) -> None:
    document = VERIFIED | other
    document["context"] = document["context"] | context
    (folder / f"{name}.json").write_text(json.dumps(document))


def test_a_file_is_a_row_with_the_interval_of_its_points(tmp_path: Path) -> None:
    kept(tmp_path, "a", points=10**9, answers=5 * 10**9)
    (row,) = verified(HASH, tmp_path).to_dict("records")
    assert (row["method"], row["scalar"], row["wrong"]) == ("exact", "f32", 0)
    # Wilson: z² / (n + z²) of no error in n.
    assert row["error_rate_high"] == pytest.approx(1.959964**2 / 1e9, rel=1e-5)
    assert row["kernels"] == SAME
    assert (row["isas"], row["loops"]) == ("scalar and avx2", "one_triangle and pairs")


def test_words_tell_other_kernels_and_wrong_answers(tmp_path: Path) -> None:
    kept(tmp_path, "a", wrong=7, first_wrong="one of them")
    kept(tmp_path, "b", scalar="f64", context={"kernel_hash": "cd" * 32})
    table = verified(HASH, tmp_path)
    assert list(table["kernels"]) == [SAME, OTHERS]
    words = verified_words(table)
    assert words is not None
    assert (words["wrong"], words["wrong_words"]) == (7, "7")
    assert words["kernels"] == "kernels that are not all those of this run"
    assert words["points"] == "1000 (f32) and 1000 (f64)"
    assert words["answers"] == "8000 answers"
    other = verified_words(verified("ef" * 32, tmp_path))
    assert other is not None and other["kernels"].startswith("other kernels")


def test_rays_are_left_out_and_nothing_is_said_of_nothing(tmp_path: Path) -> None:
    assert verified_words(verified(HASH, tmp_path)) is None
    kept(tmp_path, "rays", of="rays")
    assert verified(HASH, tmp_path).empty
    assert verified_words(verified(HASH, tmp_path / "missing")) is None


def test_a_build_with_changes_is_refused(tmp_path: Path) -> None:
    kept(tmp_path, "a", context={"dirty": True})
    with pytest.raises(LoadError, match="a.json.*changes"):
        verified(HASH, tmp_path)


def test_what_is_kept_is_a_thousand_million_points_a_scalar_and_no_error() -> None:
    root = FOLDER.parents[1]
    table = verified(kernel_hash(root))
    assert set(zip(table["method"], table["scalar"])) >= {
        ("exact", "f32"),
        ("exact", "f64"),
    }
    assert (table["points"] >= 10**9).all() and (table["wrong"] == 0).all()
