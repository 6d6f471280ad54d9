"""Numbers as people read them."""

from __future__ import annotations

import math

import pytest
from hypothesis import given
from hypothesis import strategies as st

from analysis.accuracy.hardness import hardness_of
from analysis.report import wording


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.06204, "0.0620"),
        (1.0, "1.00"),
        (9.999, "10.0"),
        (123.4, "123"),
        (4130.7, "4130"),
        (41307.0, "41\u202f300"),
        (0, "0"),
        (math.nan, "–"),
        (-2.5, "-2.50"),
        (1.41e14, "1.41·10¹⁴"),
        (5.771e-6, "5.77·10⁻⁶"),
    ],
)
def test_three_significant_digits(value: float, text: str) -> None:
    assert wording.significant(value) == text


@given(st.floats(1e-4, 9.99e6))
def test_rounding_never_changes_a_number_by_more_than_half_a_percent(
    value: float,
) -> None:
    text = wording.significant(value).replace("\u202f", "")
    assert float(text) == pytest.approx(value, rel=0.0051)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (0.333, "33.3\u00a0%"),
        (0.001, "0.100\u00a0%"),
        (2.5e-6, "2.50 in a million"),
    ],
)
def test_shares(value: float, text: str) -> None:
    assert wording.share(value) == text


@pytest.mark.parametrize(
    ("numbers", "text"),
    [
        ((2.477, 2.468, 2.499), "2.48 (2.47 to 2.50)"),
        ((0.999, 0.994, 1.006), "0.999 (0.994 to 1.006)"),
        ((1.0, 1.0, 1.0), "1"),
        ((104.2, 103.1, 105.0), "104 (103 to 105)"),
        ((math.nan, math.nan, math.nan), "–"),
    ],
)
def test_value_and_interval_have_the_same_places(
    numbers: tuple[float, float, float], text: str
) -> None:
    assert wording.with_interval(*numbers) == text


def test_lists_and_counts() -> None:
    assert wording.listed([]) == ""
    assert wording.listed(["a", "b", "c"]) == "a, b and c"
    assert wording.counted(1, "cell") == "1 cell"
    assert wording.counted(30500000, "answer") == "30\u202f500\u202f000 answers"
    assert wording.power_of_two(-12) == "2⁻¹²"
    assert wording.spoken(20.66e9) == "20.7 billion"


def test_one_of_something_is_no_plural() -> None:
    assert hardness_of("near_edge").words(1) == "1 ulp"
    assert hardness_of("near_edge").words(4) == "4 ulps"
    assert hardness_of("offset").words(0) == "2⁰ sizes"
