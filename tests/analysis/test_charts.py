"""What charts compute before they draw."""

from __future__ import annotations

from pathlib import Path
from xml.etree import ElementTree

import pytest
from hypothesis import given
from hypothesis import strategies as st

from analysis.charts import palette
from analysis.charts.chart_frame import RateAxis, spread


def test_labels_that_keep_apart_are_not_moved() -> None:
    assert spread([0.1, 0.5, 0.9], 0.1, 0.0, 1.0) == pytest.approx([0.1, 0.5, 0.9])


def test_labels_that_touch_are_moved_apart_as_little_as_possible() -> None:
    assert spread([0.5, 0.5], 0.1, 0.0, 1.0) == pytest.approx([0.45, 0.55])


def test_labels_stay_inside() -> None:
    assert spread([0.0, 0.0, 1.0, 1.0], 0.1, 0.0, 1.0) == pytest.approx(
        [0.0, 0.1, 0.9, 1.0]
    )


@given(st.lists(st.floats(0, 1), min_size=1, max_size=12))
def test_labels_never_overlap_and_keep_their_order(positions: list[float]) -> None:
    moved = spread(positions, 0.08, 0.0, 1.0)
    pairs = sorted(zip(positions, moved))
    for (_, low), (_, high) in zip(pairs, pairs[1:]):
        assert abs(high - low) >= 0.08 - 1e-9
    assert min(moved) >= -1e-9 and max(moved) <= 1 + 1e-9


def test_a_rate_of_zero_has_a_lane_below_all_others() -> None:
    axis = RateAxis([0.0, 0.001, 0.2], [0.0005, 0.002, 0.3])
    assert axis.has_zeros
    assert axis.bottom < axis.at(0.0) < axis.floor <= 0.0005
    assert axis.at(0.2) == 0.2
    below, above = axis.whiskers(0.0, 0.0, 0.0005)
    assert (below, axis.at(0.0) + above) == (0.0, pytest.approx(0.0005))


def test_without_zeros_there_is_no_lane() -> None:
    axis = RateAxis([0.001, 0.2], [0.002, 0.3])
    assert not axis.has_zeros
    assert axis.bottom == axis.floor


# Written down once more, so that a change of the palette is no accident.
PINNED = {
    "cross_product": "#0072B2",
    "cross_product_det": "#3D9BD4",
    "edge_function": "#D55E00",
    "barycentric_inverse": "#B5588C",
    "barycentric_determinant": "#009E73",
    "uv_projection": "#C98A00",
    "cross_solve": "#222222",
}


def test_methods_keep_their_colours_for_ever() -> None:
    assert {key: palette.METHODS[key].colour for key in PINNED} == PINNED


def test_no_two_methods_look_the_same() -> None:
    looks = list(palette.METHODS.values())
    assert len(set(looks)) == len(looks)
    assert len(set(palette.ISAS.values())) == len(palette.ISAS)


def test_a_method_without_a_colour_is_drawn_all_the_same() -> None:
    assert palette.method_style("brand_new") == palette.UNKNOWN_METHOD


def test_every_chart_is_svg_with_machine_and_revision_and_png(page: Path) -> None:
    charts = sorted((page.parent / "charts").glob("*.svg"))
    assert len(charts) >= 9
    for chart in charts:
        root = ElementTree.fromstring(chart.read_text())
        assert root.tag.endswith("svg")
        assert chart.with_suffix(".png").read_bytes().startswith(b"\x89PNG")
        words = "\n".join(root.itertext())
        assert "Synthetic CPU" in words and "5f17ce7ab1e0" in words
        assert "sans-serif" in root.get("font-family", "")
