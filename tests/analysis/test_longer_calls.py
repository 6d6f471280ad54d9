"""Calls that take longer than one of more points, against a frame made by hand."""

from __future__ import annotations

import pandas as pd

from analysis.speed.longer_calls import longer_calls, longer_words
from analysis.speed.tables import speed_cells
from tests.analysis.test_input_tables import frame, sized
from tests.analysis.test_tables import name

# ns a call by its points. The dip of `exact` is at 128; one lane never dips.
CALLS = {
    ("exact", "avx2"): {1: 31.0, 16: 28.0, 24: 45.0, 64: 39.0, 128: 23.5, 256: 60.0},
    ("cross_product", "avx2"): {1: 17.0, 16: 5.5, 64: 8.0, 128: 12.0, 256: 20.0},
    # Apart by less than the repetitions are.
    ("edge_function", "avx2"): {1: 6.0, 16: 6.5, 64: 8.01, 128: 8.0, 256: 20.0},
    ("exact", "scalar"): {1: 50.0, 16: 40.0, 64: 90.0, 128: 200.0, 256: 400.0},
}


def found(calls: dict[tuple[str, str], dict[int, float]]) -> pd.DataFrame:
    speed = frame(
        {
            name(method, isa, sized(n)): ns / n
            for (method, isa), own in calls.items()
            for n, ns in own.items()
        }
    )
    return longer_calls(speed, speed_cells(speed))


def said(calls: dict[tuple[str, str], dict[int, float]]) -> str:
    return longer_words(found(calls)).replace("\u00a0", " ")


def test_every_method_at_the_widest_instruction_set_is_looked_at() -> None:
    table = found(CALLS)
    rows = {(r["method"], r["n"]): r["more_n"] for r in table.to_dict("records")}
    assert rows == {
        ("exact", 64): 128,
        ("exact", 24): 128,
        ("exact", 16): 128,
        ("exact", 1): 128,
        ("cross_product", 1): 16,
    }
    assert set(table["isa"]) == {"avx2"}
    assert list(table["n"]) == sorted(table["n"], reverse=True)
    top = table.iloc[0]
    assert 1 < top["longer_low"] < 39 / 23.5 < top["longer_high"]
    assert abs(top["longer"] / (39 / 23.5) - 1) < 1e-6


def test_the_words_name_what_fills_a_vector() -> None:
    words = said(CALLS)
    assert "5 timed numbers of points surely take longer than a larger one" in words
    assert "Of these 2 fill vectors of 16: exact (f32, avx2)" in words
    assert "64 points take 39.0 ns and 128 take 23.5 ns, a ratio of 1.66 (" in words
    tails = {key: own for key, own in CALLS.items() if key[0] == "cross_product"}
    assert said(tails).endswith("None of them fills vectors of 16.")
    assert "1 timed number of points surely takes longer" in said(tails)


def test_where_more_points_always_take_longer_nothing_is_said() -> None:
    steady = {key: own for key, own in CALLS.items() if key[0] == "edge_function"}
    assert len(found(steady)) == 0 and said(steady) == ""
