"""The pixels of maps, heat maps and gradients, and how small they are kept."""

from __future__ import annotations

import base64
import io
import re

import numpy as np
import pandas as pd
import pytest
from PIL import Image

from analysis.accuracy.gradients import NO_WEIGHTS, OUTSIDE, picture, steps
from analysis.accuracy.heat_maps import picture as heat_picture
from analysis.accuracy.ulp_maps import (
    ANSWERS,
    CLAIMS,
    answer_classes,
    answers_chart,
    claim_classes,
)
from analysis.charts import ramp, svg_paths
from analysis.charts.small_svg import inline
from analysis.read.maps import Gradient, UlpMap

# Row j, column i; the lower triangle holds i > j.
LOWER = np.array([[1, 0, 1], [1, 0, 1], [0, 0, 1]], dtype=bool)
UPPER = np.array([[1, 0, 0], [1, 0, 1], [1, 1, 0]], dtype=bool)
MAP = UlpMap("cross_product", "f64", "avx2", LOWER, UPPER, {})


def names(classes: np.ndarray, legend: tuple[tuple[str, str], ...]) -> list[list[str]]:
    return [[legend[at][0] for at in row] for row in classes]


def test_each_answer_is_told_by_its_side_of_the_diagonal() -> None:
    assert names(answer_classes(MAP), ANSWERS) == [
        ["boundary, accepted", "inside, but called outside", "inside, right"],
        ["outside, but called inside", "boundary, rejected", "inside, right"],
        ["outside, right", "outside, right", "boundary, accepted"],
    ]


def test_each_point_is_claimed_once_or_it_shows() -> None:
    once, hole = "claimed once", "a hole: claimed by none"
    double = "a double hit: claimed by both"
    assert names(claim_classes(MAP), CLAIMS) == [
        ["boundary, claimed by both", hole, once],
        [double, "boundary, claimed by none", double],
        [once, once, once],
    ]


def test_the_title_counts_what_the_picture_shows() -> None:
    chart = answers_chart([MAP], "f64", "footer")
    assert "0 of 1 method answer every one right" in chart.title
    assert "cross_product errs on 2 of 9" in chart.title


def test_rows_grow_upwards_in_the_picture() -> None:
    chart = answers_chart([MAP], "f64", "footer")
    encoded = re.findall(r'data:image/png;base64,([^"]*)', chart.svg)
    pixels = Image.open(io.BytesIO(base64.b64decode(encoded[0]))).convert("RGB")
    assert pixels.size == (3, 3)
    right = dict(ANSWERS)["outside, right"]
    assert pixels.getpixel((0, 0)) == ramp.rgb(right)  # j = 2, the last row


def test_pictures_in_a_page_are_sharp_and_have_no_ids_in_common() -> None:
    svg = answers_chart([MAP, MAP], "f64", "footer").svg
    assert "image-rendering:pixelated" in svg
    assert ' id="image' not in svg


@pytest.mark.parametrize("colours", [2, 17, 256, 300])
def test_a_smaller_picture_has_the_same_pixels(colours: int) -> None:
    chance = np.random.default_rng(7)
    palette = chance.integers(0, 256, (colours, 3), dtype=np.uint8)
    pixels = palette[chance.integers(0, colours, (40, 50))]
    opaque = np.dstack([pixels, np.full((40, 50), 255, np.uint8)])
    raw = io.BytesIO()
    Image.fromarray(opaque).save(raw, format="png")
    text = base64.b64encode(raw.getvalue()).decode()
    made = inline(f'<svg><image href="data:image/png;base64,{text}"/></svg>', "key")
    found = re.findall(r'base64,([^"]*)"', made)[0]
    again = Image.open(io.BytesIO(base64.b64decode(found))).convert("RGB")
    assert (np.asarray(again) == pixels).all()
    assert len(found) < len(text)


def test_places_are_rounded_but_scales_are_not() -> None:
    made = inline(
        '<svg>\n   <path d="M 1.23456 7 \nL 2 133.999 \nL 2 9"/>'
        '<text transform="translate(1.23456 2) scale(0.015625)">a</text></svg>',
        "key",
    )
    assert 'd="M1.2 7L2 134V9"' in made
    assert "translate(1.23456 2) scale(0.015625)" in made


def test_what_is_painted_keeps_its_order_and_look_out_of_its_groups() -> None:
    mark = '<use xlink:href="#m" x="{}" y="2" style="fill: #ff0000"/>'
    made = inline(
        '<svg xmlns:xlink="http://www.w3.org/1999/xlink"><g id="axes_1"><defs>'
        '<path id="m" d="M 0 0 L 1 1" style="stroke: #000000"/></defs><g>'
        + mark.format(1)
        + mark.format(3)
        + "</g></g><g><path d='M 0 0 L 5 0' style='fill: none; stroke: #00ff00'/>"
        "<path style='fill: none; stroke: #00ff00'/>"  # of nothing
        "<path d='M 0 1 L 5 1' style='fill: none; stroke: #00ff00'/></g></svg>",
        "key",
    )
    body = made[made.index("</defs>") :]
    assert re.findall(r'<(\w+)[^>]* (?:x|d)="([^"]*)"', body) == [
        ("use", "1"),
        ("use", "3"),
        ("path", "M0 0H5M0 1H5"),
    ]
    assert '<g fill="#ff0000" stroke="#000000">' in body
    assert 'fill="none" stroke="#00ff00"' in body


@pytest.mark.parametrize(
    ("path", "written"),
    [
        ("M 1 2 L 1.01 2.01 L 3 4 z", "M1 2L3 4Z"),
        ("M 1 2 L 1.01 2.01", "M1 2h0"),
        ("M -0.5 -0.04 C 1 2 -3 4 5 6", "M-.5 0C1 2-3 4 5 6"),
    ],
)
def test_a_path_is_written_in_short(path: str, written: str) -> None:
    assert svg_paths.short(svg_paths.steps(path), 1) == written


def test_a_heat_map_has_a_colour_a_rate_and_grey_where_nothing_was_asked() -> None:
    table = pd.DataFrame(
        [["a", 1.0, 0.0], ["a", 2.0, 0.5], ["b", 1.0, 1e-4]],
        columns=["method", "at", "error_rate"],
    )
    pixels = heat_picture(table, ["a", "b"], [1.0, 2.0])
    assert tuple(pixels[0, 0]) == (255, 255, 255)
    assert tuple(pixels[0, 1]) == ramp.colour(0.5)
    assert tuple(pixels[1, 0]) == ramp.colour(1e-4)
    assert tuple(pixels[1, 1]) == ramp.rgb(ramp.UNKNOWN)


def gradient(weights: list[list[list[float]]], inside: list[list[bool]]) -> Gradient:
    corners = ((0.0, 0.0), (1.0, 0.0), (0.0, 1.0))
    return Gradient(
        "m",
        "f32",
        "avx2",
        "near_origin",
        corners,
        np.array(weights, dtype=np.float32),
        np.array(inside),
    )


def test_a_gradient_is_the_corners_colours_mixed_by_the_weights() -> None:
    nan = float("nan")
    entry = gradient(
        [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[nan, 0, 0], [9, -9, 1], [1, 0, 0]]],
        [[True, True, True], [True, True, False]],
    )
    pixels = [[tuple(pixel) for pixel in row] for row in picture(entry)]
    assert pixels[0] == [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
    assert pixels[1] == [ramp.rgb(NO_WEIGHTS), (255, 0, 255), ramp.rgb(OUTSIDE)]
    assert steps(entry) == 4
