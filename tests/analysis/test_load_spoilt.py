"""Spoilt files are loaded or refused by name, and never crash the program."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from analysis.read.load import LoadError, load_run
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import documents, write_run

SPEED = "speed-one_triangle-f32.json"

JSON = st.recursive(
    st.none()
    | st.booleans()
    | st.integers()
    | st.floats()
    | st.text(max_size=8)
    | st.sampled_from([10**400, 2**63, -1, "NaN", "", 1e308, 5e-324]),
    lambda inner: st.lists(inner, max_size=3)
    | st.dictionaries(st.text(max_size=5), inner, max_size=3),
    max_leaves=6,
)


def places(document: Any, path: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """The path of everything inside a JSON document."""
    inside: list[tuple[Any, ...]] = [path] if path else []
    keys: Any = []
    if isinstance(document, dict):
        keys = document
    elif isinstance(document, list):
        keys = range(min(len(document), 3))
    for key in keys:
        inside += places(document[key], (*path, key))
    return inside


FILES = documents(TWO_METHODS)
# Pictures of one method are enough to be spoilt.
FILES["maps.json"]["ulp_maps"] = FILES["maps.json"]["ulp_maps"][:1]
PLACES = {name: places(document) for name, document in FILES.items()}


@settings(
    max_examples=max(150, settings().max_examples),
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(data=st.data())
def test_a_mutated_file_is_loaded_or_refused_but_never_a_crash(
    data: st.DataObject, tmp_path: Path
) -> None:
    folder = write_run(tmp_path / "mutated", TWO_METHODS)
    name = data.draw(st.sampled_from(sorted(FILES)))
    document = json.loads((folder / name).read_text())
    *parents, last = data.draw(st.sampled_from(PLACES[name]))
    inner = document
    for key in parents:
        inner = inner[key]
    if isinstance(inner, dict) and data.draw(st.booleans()):
        del inner[last]
    else:
        inner[last] = data.draw(JSON)
    (folder / name).write_text(json.dumps(document))
    try:
        load_run(folder)
    except LoadError as error:
        assert name in str(error) or "mixed" in str(error)


@settings(
    max_examples=max(60, settings().max_examples),
    deadline=None,
    suppress_health_check=[HealthCheck.function_scoped_fixture],
)
@given(content=st.binary(max_size=60), cut=st.integers(0, 5000))
def test_spoilt_bytes_are_loaded_or_refused_but_never_a_crash(
    content: bytes, cut: int, tmp_path: Path
) -> None:
    folder = write_run(tmp_path / "spoilt", TWO_METHODS)
    whole = (folder / SPEED).read_bytes()
    (folder / SPEED).write_bytes(whole[:cut] + content + whole[cut + len(content) :])
    try:
        load_run(folder)
    except LoadError as error:
        assert SPEED in str(error)


@pytest.mark.parametrize(
    ("name", "place"),
    [
        ("operations.json", ("per_item", "add")),
        ("operations.json", ("per_call", "integer_min_max")),
        ("instructions.json", ("per_item",)),
    ],
)
def test_an_integer_beyond_any_double_is_refused_by_its_field(
    name: str, place: tuple[str, ...], tmp_path: Path
) -> None:
    folder = write_run(tmp_path / "mutated", TWO_METHODS)
    document = json.loads((folder / name).read_text())
    *parents, last = place
    inner = document["rows"][0]
    for key in parents:
        inner = inner[key]
    inner[last] = 10**400
    (folder / name).write_text(json.dumps(document))
    with pytest.raises(LoadError) as error:
        load_run(folder)
    assert name in str(error.value)
    assert ".".join(("$.rows[0]", *place)) in str(error.value)
