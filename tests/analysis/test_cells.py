"""Names of cells: what is one, what is none, and that both are said plainly."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from analysis.read.cells import Cell, CellNameError, Scene, parse_cell, parse_scene

WORDS = st.from_regex(r"[a-z][a-z0-9_]{0,12}", fullmatch=True)
VALUES = st.from_regex(r"[A-Za-z0-9_.+-]{1,8}", fullmatch=True)
SCENES = st.builds(
    Scene,
    family=WORDS,
    parameters=st.lists(
        st.tuples(WORDS, VALUES), max_size=4, unique_by=lambda pair: pair[0]
    ).map(tuple),
)
CELLS = st.builds(
    Cell,
    loop=WORDS,
    scene=SCENES,
    method=WORDS,
    scalar=WORDS,
    isa=WORDS,
    control=st.sampled_from(["", "twin", "doubled", "placed_0", "placed_48"]),
) | st.builds(
    Cell,
    loop=WORDS,
    scene=SCENES,
    method=WORDS,
    scalar=WORDS,
    isa=WORDS,
    threads=st.integers(1, 999_999),
)


@given(CELLS)
def test_what_is_written_is_read_back(cell: Cell) -> None:
    assert parse_cell(str(cell)) == cell


@given(st.text())
def test_any_text_is_a_name_or_a_clear_error(text: str) -> None:
    try:
        assert str(parse_cell(text)) == text
    except CellNameError as error:
        assert str(error)


@given(CELLS, st.data())
def test_a_spoilt_name_is_never_read_as_something_else(
    cell: Cell, data: st.DataObject
) -> None:
    name = str(cell)
    at = data.draw(st.integers(0, len(name) - 1))
    spoilt = name[:at] + data.draw(st.characters()) + name[at + 1 :]
    try:
        assert str(parse_cell(spoilt)) == spoilt
    except CellNameError:
        pass


def test_the_names_of_the_design_are_read() -> None:
    cell = parse_cell(
        "one_triangle/uniform:hit=50:n=4096:sets=fresh/edge_function/f32/avx512/twin"
    )
    assert cell.control == "twin"
    assert cell.scene.family == "uniform"
    assert cell.scene.number("n") == 4096
    assert cell.scene.get("sets") == "fresh"
    assert math.isnan(cell.scene.number("sets"))
    assert parse_scene("offset:ratio=-3").number("ratio") == -3


@pytest.mark.parametrize(
    ("name", "says"),
    [
        ("", "not of the form"),
        ("a/b/c/d", "not of the form"),
        ("a/b/c/d/e/f", "not of the form"),
        ("a/b/c/d/e/", "not of the form"),
        ("a/b/c/d/e/twin/twin", "not of the form"),
        ("a/b/c/d/e/placed_", "not of the form"),
        ("a/b/c/d/e/threads:0", "not of the form"),
        ("a/b/c/d/e/threads:2/twin", "not of the form"),
        ("a/b:k/c/d/e", "no '=value'"),
        ("a/b:k=1:k=2/c/d/e", "twice"),
        ("a/b:k=/c/d/e", "value of scene parameter 'k'"),
        ("A/b/c/d/e", "is not a loop"),
        ("a/b/c/d/e\n", "is not a ISA"),
        ("a/b/<i>/d/e", "is not a method"),
    ],
)
def test_a_bad_name_is_refused_with_its_reason(name: str, says: str) -> None:
    with pytest.raises(CellNameError, match=says):
        parse_cell(name)
