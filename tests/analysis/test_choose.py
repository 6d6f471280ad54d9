"""What is chosen for a scene is right for it, and the cheapest of what is."""

from __future__ import annotations

import dataclasses
import math
from pathlib import Path

import numpy as np
import pytest

from analysis.choice.choice_chart import CHOICE_COLUMNS, SHAPES, choice_map, choices
from analysis.choice.choice_exhibits import typical_table
from analysis.choice.choose import Choice, choose, decide, ranked
from analysis.choice.choose_command import chooser
from analysis.choice.choose_scene import Described, Scene, SceneError, checked
from analysis.choice.choose_text import document, guarantee, lines, reasons
from analysis.choice.choose_times import set_ups, stored_as, timings
from analysis.choice.error_bounds import ALWAYS_EXACT
from analysis.choice.typical_scenes import TYPICAL
from analysis.read.load import load_run
from analysis.speed.tables import samples, speed_cells
from tests.analysis.choosing import ENTRIES, METHODS, entry, timing
from tests.analysis.synthetic import Options, write_run


def scene(**other: object) -> Scene:
    """Stout f32 triangles in a unit square, but for what is told."""
    values: dict[str, object] = {
        "scalar": "f32",
        "coordinates": (0.0, 1.0),
        "altitude": 0.1,
    }
    if "aspect" in other:
        del values["altitude"]
    return checked(Described(**(values | other)))  # type: ignore[arg-type]


def test_the_cheapest_that_is_right_is_taken() -> None:
    timed = [
        timing("exact", 5.0),
        timing("cross_product", 3.0),
        timing("edge_function", 2.0),
    ]

    def taken(tolerance: float) -> str:
        choice = decide(scene(tolerance=tolerance), timed, ENTRIES)
        assert choice.chosen is not None
        return choice.chosen.name

    # 6u·L²/h = 7.2e-6 and 8√2·u·M·L/h = 9.5e-6, for L = √2.
    assert taken(0.0) == "exact"
    assert taken(8e-6) == "cross_product"
    assert taken(2e-5) == "edge_function"


def test_among_equally_fast_ones_the_stronger_guarantee_is_taken() -> None:
    timed = [timing("edge_function", 3.0), timing("exact", 3.003)]
    choice = decide(scene(tolerance=0.01), timed, ENTRIES)
    assert choice.chosen is not None and choice.chosen.name == "exact"
    slower = [timing("edge_function", 3.0), timing("exact", 3.3)]
    choice = decide(scene(tolerance=0.01), slower, ENTRIES)
    assert choice.chosen is not None and choice.chosen.name == "edge_function"
    assert [o.name for o in choice.runners_up] == ["exact"]
    # Where moving code changes as much, neither is the faster one.
    choice = decide(scene(tolerance=0.01), slower, ENTRIES, alike=1.2)
    assert choice.chosen is not None and choice.chosen.name == "exact"
    assert [choice.as_fast(o) for o in choice.runners_up] == [True]


def test_a_method_is_listed_once_in_its_cheapest_form() -> None:
    pairs = dataclasses.replace(timing("exact", 9.0), loop="pairs")
    choice = decide(scene(), [pairs, timing("exact", 5.0)], ENTRIES)
    assert choice.chosen is not None and choice.chosen.timing.loop == "one_triangle"
    assert choice.runners_up == ()
    assert ranked([]) == []


def test_watertight_takes_exact_answers_by_the_top_left_rule() -> None:
    timed = [timing(m, 1.0 + k / 9) for k, m in enumerate(METHODS)]
    choice = decide(scene(need="watertight"), timed, ENTRIES)
    assert choice.chosen is not None and choice.chosen.name == "exact_top_left"
    whole = scene(need="watertight", coordinates=(0.0, 64.0), precision=1.0)
    choice = decide(whole, timed, ENTRIES)
    assert choice.chosen is not None and choice.chosen.boundary == "top_left"
    assert choice.chosen.bound.exact


def test_triangles_that_may_have_no_area_leave_nothing_inexact() -> None:
    timed = [timing(m, 1.0 + k / 9) for k, m in enumerate(METHODS)]
    choice = decide(scene(altitude=0.0, tolerance=1.0), timed, ENTRIES)
    assert choice.chosen is not None and choice.chosen.name in ALWAYS_EXACT
    assert choice.nothing_inexact_is_safe


def test_no_method_being_right_is_said_with_the_reason() -> None:
    choice = decide(scene(), [timing("edge_function", 1.0)], ENTRIES)
    assert choice.chosen is None and math.isnan(choice.ns)
    text = "\n".join(lines(choice))
    assert text.startswith("No method of this run is right")
    assert "no wrong answer is allowed" in text and "edge_function" in text
    assert document(choice, "run", "command")["chosen"] is None


def test_weights_may_come_from_another_method_than_the_answer() -> None:
    weighing = [timing("barycentric_determinant", 2.0)]
    alone = scene(need="weights", tolerance=1e-3)
    choice = decide(alone, weighing, ENTRIES, [timing("exact", 1.0)])
    assert choice.chosen is not None and choice.weigher is None
    assert choice.chosen.name == "barycentric_determinant"
    strict = scene(need="weights")
    choice = decide(strict, weighing, ENTRIES, [timing("exact", 1.0)])
    assert choice.chosen is not None and choice.chosen.name == "exact"
    assert choice.weigher is not None
    assert choice.weigher.name == "barycentric_determinant"
    assert choice.ns == pytest.approx(3.0)
    assert "weights of points inside within" in guarantee(choice)


def test_slimness_apart_from_size_gives_the_better_bound() -> None:
    mixed = scene(aspect=4, edge=(0.01, 1.0), tolerance=1e-3)
    choice = decide(mixed, [timing("cross_product", 1.0)], ENTRIES)
    assert choice.chosen is not None
    # 6u·L·(L/h), not 6u·L²/h of the largest edge and the smallest altitude.
    assert choice.chosen.bound.distance == pytest.approx(24 * 2.0**-24, rel=0.05)


def test_there_are_three_reasons_and_they_follow_the_choice() -> None:
    timed = [timing("exact", 5.0), timing("edge_function", 2.0)]
    strict = reasons(decide(scene(), timed, ENTRIES))
    loose = reasons(decide(scene(tolerance=0.01), timed, ENTRIES))
    assert len(strict) == len(loose) == 3
    assert "exact for every finite input" in strict[0]
    assert "Nothing that rounds is safe here" in strict[2]
    assert "within the tolerance of 0.0100" in loose[0]
    assert "Nothing that takes less time" in loose[2]


@pytest.fixture(scope="module")
def run_of_two(tmp_path_factory: pytest.TempPathFactory) -> Path:
    options = Options(
        profile="tiny",
        methods=("cross_product", "exact", "exact_top_left"),
        isas=("scalar", "avx2"),
        scalars=("f32",),
    )
    return write_run(tmp_path_factory.mktemp("runs") / "three", options)


def test_times_are_those_of_the_loop_that_the_scene_asks_for(run_of_two: Path) -> None:
    run = load_run(run_of_two)
    cells = speed_cells(run.speed)

    def loops(points: float) -> set[str]:
        found = timings(scene(points=points), samples(run.speed), cells, run.methods)
        return {t.loop for t in found}

    assert loops(4096) == {"one_triangle"}
    assert loops(0.001) == {"one_point"}
    assert "pairs" in loops(1)


def test_an_isa_that_is_given_is_kept_to(run_of_two: Path) -> None:
    run = load_run(run_of_two)
    cells = speed_cells(run.speed)
    for isa in ("scalar", "avx2"):
        found = timings(scene(), samples(run.speed), cells, run.methods, isa)
        assert {t.isa for t in found} == {isa}


def test_a_warning_is_never_advised() -> None:
    run_methods = (entry("exact"), entry("cross_product", warning="wrong"))
    cells = speed_cells_of("exact", "cross_product")
    found = timings(scene(), *cells, run_methods)
    assert [t.method for t in found] == ["exact"]


def speed_cells_of(*methods: str):  # type: ignore[no-untyped-def]
    import pandas as pd

    at = "uniform:hit=50:bytes=24k:sets=fresh"
    rows = [
        {
            **{"shard": "s", "name": f"one_triangle/{at}/{m}/f32/avx2"},
            **{"family": "uniform", "loop": "one_triangle", "scene": at},
            **{"method": m, "scalar": "f32", "isa": "avx2", "ns": 1.0, "noise": ""},
            "working_set_bytes": 24576,
        }
        for m in methods
    ]
    values = {("s", str(r["name"])): np.array([1.0, 1.01, 0.99]) for r in rows}
    return values, pd.DataFrame(rows)


def test_the_time_of_a_set_up_is_what_few_points_take_longer() -> None:
    import pandas as pd

    many = "uniform:hit=50:bytes=24k:sets=fresh"
    few = [(f"uniform:hit=50:n={n}:sets=fresh", 0.5 + 80 / n) for n in (16, 64, 256)]
    rows = [
        {
            **{"loop": "one_triangle", "family": "uniform", "scene": at, "ns": ns},
            **{"method": "exact", "scalar": "f32", "isa": "avx2"},
            "working_set_bytes": 24576,
        }
        for at, ns in [(many, 0.5), *few]
    ]
    found = set_ups(pd.DataFrame(rows))
    assert found == {("exact", "avx2"): pytest.approx(80)}


def test_whole_numbers_may_be_stored_in_whatever_holds_them() -> None:
    small = scene(scalar="i32", coordinates=(0.0, 79.0), altitude=0.0)
    assert stored_as(small) == ["i32", "i16", "u8", "f32", "f64"]
    large = scene(scalar="i32", coordinates=(0.0, 2.0**25), altitude=0.0)
    assert stored_as(large) == ["i32", "f64"]


def test_the_chart_follows_the_bounds(run_of_two: Path) -> None:
    run = load_run(run_of_two)
    table = choices(samples(run.speed), speed_cells(run.speed), run.methods)
    assert list(table.columns) == CHOICE_COLUMNS
    assert set(table["points"]) == set(SHAPES)
    # What is not exact is within the tolerance, and exact where it is tightest.
    loose = table[~table["exact"].astype(bool)]
    assert (loose["right_beyond"] <= loose["tolerance"]).all()
    tightest = table[table["tolerance"] == table["tolerance"].min()]
    assert tightest["exact"].all()
    chart = choice_map(table, "footer")
    for method in set(table["method"]):
        assert method in chart.alt and method in chart.svg


def test_the_table_of_typical_scenes_has_their_commands(run_of_two: Path) -> None:
    table = typical_table(chooser(load_run(run_of_two)), "three")
    assert len(table) == len(TYPICAL) == 12
    for command, typical in zip(table["command"], TYPICAL):
        assert command.replace(" choose three ", " choose ") == typical.scene.command


@pytest.mark.parametrize("typical", TYPICAL, ids=lambda typical: typical.name)
def test_a_typical_scene_is_what_its_command_describes(typical) -> None:  # type: ignore[no-untyped-def]
    from analysis.__main__ import _parser
    from analysis.choice.choose_command import described

    words = typical.scene.command.split()
    assert words[:4] == ["python3", "-m", "analysis", "choose"]
    options = _parser().parse_args(words[3:])
    assert checked(described(options)) == checked(typical.scene)
    assert described(options) == typical.scene


def test_choosing_is_pure(run_of_two: Path) -> None:
    run = load_run(run_of_two)
    cells = speed_cells(run.speed)

    def made() -> Choice:
        return choose(
            scene(tolerance=1e-3), samples(run.speed), cells, run.accuracy, run.methods
        )

    assert made() == made()


BAD = [
    ({"coordinates": (1.0, 0.0)}, "--coordinates 1 0"),
    ({"coordinates": (0.0, math.inf)}, "--coordinates 0 inf"),
    ({"coordinates": (0.0, 1e39)}, "no numbers this large"),
    ({"scalar": "f16"}, "--scalar f16"),
    ({"scalar": "u8", "coordinates": (0.0, 300.0)}, "u8 holds numbers from 0 to 255"),
    ({"scalar": "i16", "coordinates": (0.0, 0.5)}, "whole numbers only"),
    ({"altitude": 5.0}, "--altitude 5: must be from 0 to"),
    ({"altitude": -1.0}, "--altitude -1"),
    ({"altitude": math.nan}, "--altitude nan"),
    ({"altitude": None}, "--altitude or --aspect is missing"),
    ({"altitude": 0.1, "aspect": 2.0}, "say the same"),
    ({"altitude": None, "aspect": 1.0}, "--aspect 1"),
    ({"edge": (2.0, 1.0)}, "--edge 2 1"),
    ({"edge": (0.1, 0.2, 0.3)}, "--edge 0.1 0.2 0.3"),
    ({"edge": (0.5, 9.0)}, "the diagonal"),
    ({"points": 0.0}, "--points-per-triangle 0"),
    ({"hit": 1.5}, "--hit-rate 1.5"),
    ({"need": "beauty"}, "--need beauty"),
    ({"precision": -1.0}, "--precision -1"),
    ({"precision": 2.0}, "--precision 2: larger"),
    ({"tolerance": -1.0}, "--tolerance -1"),
    ({"tolerance": 0.1, "need": "exact"}, "leave one of them out"),
    ({"grid": (0, 4)}, "--grid 0 4"),
    ({"grid": (8, 4), "need": "weights"}, "--grid: its kernels write no weights"),
]


@pytest.mark.parametrize(("other", "message"), BAD)
def test_a_scene_that_makes_no_sense_is_refused_by_option(
    other: dict[str, object], message: str
) -> None:
    with pytest.raises(SceneError, match=message.replace("(", r"\(")):
        values = {"scalar": "f32", "coordinates": (0.0, 1.0), "altitude": 0.1} | other
        checked(Described(**values))  # type: ignore[arg-type]
