"""Who is left out of the advice, and who may be called the fastest."""

from __future__ import annotations

import pandas as pd
import pytest

from analysis.read.run import MethodEntry
from analysis.report.verdicts import NOTICED, advise, unfit, verdicts
from analysis.speed.tables import speed_cells
from tests.analysis.test_tables import FRESH, accuracy_frame, name, speed_frame

POINTS = 786_432


def left_out(wrong: int, of: int = POINTS) -> bool:
    cells = {name("edge_function", "avx2"): (of // 2, wrong, of - of // 2, 0)}
    return "edge_function" in unfit(accuracy_frame(cells), (), "f32")


def test_a_wrong_answer_in_a_million_is_not_noticed() -> None:
    assert not left_out(0)
    assert not left_out(1)
    assert not left_out(round(NOTICED * POINTS))


def test_ten_times_what_is_noticed_is_left_out() -> None:
    assert left_out(round(10 * NOTICED * POINTS))


def test_the_low_end_of_the_interval_decides() -> None:
    found = [wrong for wrong in range(60, 140) if left_out(wrong)]
    assert found[0] == pytest.approx(
        NOTICED * POINTS + 2 * (NOTICED * POINTS) ** 0.5, 0.05
    )
    assert found == list(range(found[0], 140))


def test_few_points_convict_nobody_by_chance() -> None:
    """1 of 5000 is twice the rate, but may be one of 10 000 as well."""
    assert not left_out(1, 5000)
    assert left_out(20, 5000)


def test_cells_are_judged_one_by_one_and_of_the_same_scalar() -> None:
    cells = {
        name("edge_function", isa, f"uniform:hit=50:n={n}:sets=fresh"): (
            POINTS,
            w,
            9,
            0,
        )
        for isa, n, w in (("avx2", 1, 0), ("avx512", 2, 900))
    }
    frame = accuracy_frame(cells)
    assert unfit(frame, (), "f32") == {"edge_function"}
    assert unfit(frame, (), "f64") == frozenset()


def test_errors_on_hard_input_leave_nobody_out() -> None:
    hard = {name("edge_function", "avx2", "near_edge:ulps=1"): (100, 50, 100, 50)}
    assert unfit(accuracy_frame(hard), (), "f32") == frozenset()


def test_a_warning_leaves_out() -> None:
    entry = MethodEntry("epsilon", "", "", "closed", "triangle", False, False, "odd")
    assert unfit(accuracy_frame({}), (entry,), "f32") == {"epsilon"}


STEADY = [1 + k / 900 for k in range(9)]
HARD = "near_edge:ulps=1"


def said(
    times: dict[str, float], wrong: dict[str, int], moved: float = 1.0
) -> dict[str, str]:
    """Method → its verdict, where moving the code of the first one makes it take
    `moved` times as long.
    """
    table = judged(times, wrong, moved)
    return dict(zip(table["method"], table["verdict"]))


def judged(
    times: dict[str, float], wrong: dict[str, int], moved: float = 1.0
) -> pd.DataFrame:
    cells = {
        name(method, "avx2", FRESH): [factor * t for t in STEADY]
        for method, factor in times.items()
    }
    if moved != 1:
        first, own = next(iter(cells.items()))
        cells[first + "/placed_16"] = [moved * t for t in own]
    speed = speed_frame(cells)
    accuracy = accuracy_frame(
        {
            name(method, "avx2", HARD): (5000, count, 5000, 0)
            for method, count in wrong.items()
        }
    )
    plain = speed[speed["control"] == ""]
    return verdicts(speed, speed_cells(plain), accuracy, "f32")


def test_the_fastest_is_one_that_the_intervals_tell_from_all_others() -> None:
    found = said({"a": 1.0, "b": 1.1}, {"a": 900, "b": 100})
    assert found["a"] == "the fastest; whatever errs less takes longer"


def test_one_that_is_not_told_from_another_is_as_fast_as_that() -> None:
    found = said({"a": 1.0, "b": 1.002, "c": 1.1}, {"a": 900, "b": 500, "c": 100})
    assert found["a"].startswith("as fast as b, as far as the intervals can tell")
    assert not any("the fastest" in text for text in found.values())


def test_what_beats_a_method_is_named_with_intervals() -> None:
    text = said({"a": 1.0, "b": 2.0}, {"a": 100, "b": 1000})["b"]
    text = text.replace("\u00a0", " ")
    assert text.startswith("a is 2.00 × as fast (1.99") and "less often (" in text
    assert said({"a": 1.0, "b": 1.002}, {"a": 100, "b": 1000})["b"].startswith(
        "a takes as long"
    )


def test_what_moving_code_changes_makes_no_method_the_faster_one() -> None:
    times = {"exact": 1.1, "exact_open": 1.08, "fast": 1.0}
    wrong = {"exact": 0, "exact_open": 0, "fast": 900}
    found = said(times, wrong)
    assert "exact_open is 1.02" in found["exact"].replace("\u00a0", " ")
    moved = said(times, wrong, moved=1.05)
    assert moved["exact"] == moved["exact_open"]
    assert moved["exact"].startswith("does not err near an edge")
    advice = advise(judged(times, wrong), same=1.05)
    assert advice is not None and advice.fastest == "fast"
    assert (advice.most_right, advice.as_right) == ("exact", ("exact_open",))
    strict = advise(judged(times, wrong))
    assert strict is not None
    assert (strict.most_right, strict.as_right) == ("exact_open", ())


def test_a_method_is_sent_to_the_first_of_those_that_are_as_fast() -> None:
    times = {"slow": 2.0, "exact_open": 1.0, "exact": 1.02}
    wrong = {"slow": 10, "exact_open": 0, "exact": 0}
    assert said(times, wrong)["slow"].startswith("exact_open is")
    assert said(times, wrong, moved=1.05)["slow"].startswith("exact is")
