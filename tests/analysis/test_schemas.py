"""The schemas themselves: sound, and strict where the object is ours."""

from __future__ import annotations

import copy
import json
import tempfile
from pathlib import Path
from typing import Any

import jsonschema
import pytest

from analysis.cpus.stored_run import measured
from analysis.read.load import load_run
from analysis.read.read_json import SCHEMAS, _validator
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import documents, write_run

NAMES = ["machine", "speed", "accuracy", "methods", "maps", "limits"] + [
    "operations",
    "instructions",
    "sweep",
    "times",
    "build",
    "stored",
    "verify",
]
# As `pitbench verify --out` writes it; no file of a run.
VERIFIED: dict[str, Any] = {
    "context": {
        "schema": "pitbench-verify-2",
        "revision": "5f17ce7ab1e0",
        "dirty": False,
        "kernel_hash": "ab" * 32,
        "seed": 1,
    },
    "of": "points",
    "method": "exact",
    "scalar": "f32",
    "isas": ["scalar", "avx2"],
    "loops": ["one_triangle", "pairs"],
    "points": 1000,
    "boundary_points": 90,
    "answers": 4000,
    "wrong": 0,
    "first_wrong": None,
    "seconds": 1.5,
    "truth_points_per_second": 1e7,
}


def fits(name: str, document: Any) -> bool:
    return bool(_validator(name).is_valid(document))


def good(name: str) -> Any:
    if name == "stored":
        with tempfile.TemporaryDirectory() as folder:
            run = load_run(write_run(Path(folder) / "run", TWO_METHODS))
        return json.loads(json.dumps(measured(run, "a label", anonymous=False)))
    if name == "verify":
        return copy.deepcopy(VERIFIED)
    files = documents(TWO_METHODS)
    return copy.deepcopy(next(d for f, d in files.items() if f.startswith(name)))


@pytest.mark.parametrize("name", NAMES)
def test_each_schema_is_a_schema_and_fits_a_good_file(name: str) -> None:
    jsonschema.Draft202012Validator.check_schema(_validator(name).schema)
    assert fits(name, good(name))


def test_there_is_no_schema_that_is_not_tested() -> None:
    files = {path.name for path in SCHEMAS.iterdir()}
    assert files == {f"{name}.schema.json" for name in NAMES}


@pytest.mark.parametrize("name", NAMES)
def test_each_required_field_is_missed(name: str) -> None:
    for key in _validator(name).schema["required"]:
        document = good(name)
        del document[key]
        assert not fits(name, document), key


def test_googles_own_objects_may_have_more() -> None:
    document = good("speed")
    document["context"]["library_version"] = "9"
    document["benchmarks"][0]["label"] = "new"
    assert fits("speed", document)


def test_a_refused_row_needs_a_reason_and_no_numbers() -> None:
    document = good("speed")
    document["benchmarks"] = [{"name": "x", "error_occurred": True}]
    assert not fits("speed", document)
    document["benchmarks"][0]["error_message"] = "differs"
    assert fits("speed", document)


def test_a_row_that_is_not_refused_needs_its_numbers() -> None:
    document = good("speed")
    document["benchmarks"] = [{"name": "x", "error_occurred": False}]
    assert not fits("speed", document)


@pytest.mark.parametrize(
    ("point", "is_point"),
    [
        (["0x1p+0", "-0x1.8p-149"], True),
        (["-inf", "nan"], True),
        (["12", "-7"], False),
        (["0.5", "1"], False),
        (["0x1p+0"], False),
        (["nano", "1"], False),
        ([1, 2], False),
    ],
)
def test_worst_points_are_hex_floats_or_not_finite(point: Any, is_point: bool) -> None:
    document = good("accuracy")
    classes = (cell["classes"].values() for cell in document["cells"])
    share = next(share for each in classes for share in each if share["worst"])
    share["worst"][0]["p"] = point
    assert fits("accuracy", document) == is_point
