"""The letters that a page brings for its charts."""

from __future__ import annotations

import base64
import io
import re

from fontTools.ttLib import TTFont

from analysis.charts.chart_font import font_faces

CHART = "<svg><text x='1'>a &amp; é</text><text><tspan>10 µs →</tspan></text></svg>"


def fonts(css: str) -> list[TTFont]:
    found = re.findall(r"base64,([^)]*)", css)
    return [TTFont(io.BytesIO(base64.b64decode(text))) for text in found]


def test_the_letters_of_the_charts_are_there_and_no_others() -> None:
    regular, bold = fonts(font_faces([CHART]))
    wanted = {ord(letter) for letter in "a & é10 µs →"}
    assert set(regular.getBestCmap()) == set(bold.getBestCmap()) == wanted
    assert (regular["OS/2"].usWeightClass, bold["OS/2"].usWeightClass) == (400, 700)


def test_letters_are_as_wide_as_where_matplotlib_placed_them() -> None:
    from matplotlib.font_manager import findfont

    whole = TTFont(findfont("DejaVu Sans"))
    regular, _ = fonts(font_faces([CHART]))
    for letter in "aé1→":
        own, theirs = (
            font["hmtx"][font.getBestCmap()[ord(letter)]][0]
            for font in (regular, whole)
        )
        assert own == theirs
    assert regular["head"].unitsPerEm == whole["head"].unitsPerEm


def test_the_same_letters_give_the_same_bytes_at_any_time() -> None:
    font_faces([CHART])
    regular, _ = fonts(font_faces([CHART]))
    from matplotlib.font_manager import findfont

    assert regular["head"].modified == TTFont(findfont("DejaVu Sans"))["head"].modified


def test_a_page_without_charts_brings_no_font() -> None:
    assert font_faces([]) == ""
