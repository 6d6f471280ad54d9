"""The pictures of what a method says of neighbouring floating-point numbers.

Each pixel is one representable point. Two triangles share the diagonal: the
lower one holds the pixels below it exactly, the upper one those above it.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any, Final

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.patches import Patch

from analysis import palette
from analysis.chart_frame import Chart, finish, style
from analysis.maps import UlpMap
from analysis.method_families import in_order
from analysis.ramp import rgb
from analysis.wording import counted, grouped, listed

Picture = npt.NDArray[np.uint8]

# What a pixel is, and its colour: right answers pale, wrong ones strong, the
# two kinds of wrong apart in lightness as well as in hue.
ANSWERS: Final = (
    ("outside, right", "#F6F6F4"),
    ("inside, right", "#C9DDEA"),
    ("boundary, rejected", "#9A9A9A"),
    ("boundary, accepted", "#33658A"),
    ("outside, but called inside", "#F0A202"),
    ("inside, but called outside", "#B3001B"),
)
CLAIMS: Final = (
    ("claimed once", "#EEF1F3"),
    ("boundary, claimed by none", "#9A9A9A"),
    ("boundary, claimed by both", "#33658A"),
    ("a hole: claimed by none", "#B3001B"),
    ("a double hit: claimed by both", "#F0A202"),
)
_COLUMNS: Final = 5
_WIDTH: Final = 11.0  # inches


def answer_classes(entry: UlpMap) -> npt.NDArray[np.intp]:
    """What the lower triangle's answer is at each pixel, as an index into
    ANSWERS, row 0 first.
    """
    j, i = np.indices(entry.lower.shape)
    said = entry.lower
    classes = np.where(said, 1, 5)
    classes = np.where(i < j, np.where(said, 4, 0), classes)
    return np.where(i == j, np.where(said, 3, 2), classes)


def claim_classes(entry: UlpMap) -> npt.NDArray[np.intp]:
    """How many of the two triangles claim each pixel, as an index into CLAIMS."""
    j, i = np.indices(entry.lower.shape)
    claims = entry.lower.astype(int) + entry.upper
    off = np.select([claims == 0, claims == 2], [3, 4], 0)
    on = np.select([claims == 0, claims == 2], [1, 2], 0)
    return np.where(i == j, on, off)


def answers_chart(maps: Sequence[UlpMap], scalar: str, footer: str) -> Chart:
    """What each method says of the lower triangle. `maps`: of one scalar."""
    ordered = _ordered(maps)
    wrong = {m.method: int((answer_classes(m) >= 4).sum()) for m in ordered}
    right = [method for method, count in wrong.items() if count == 0]
    most = max(wrong, key=lambda method: wrong[method])
    title = (
        f"One edge through neighbouring {scalar} points: "
        f"{len(right)} of {counted(len(wrong), 'method')} answer every one right; "
        f"{most} errs on {grouped(wrong[most])} of {grouped(ordered[0].lower.size)}"
    )
    alt = f"{title}. Wrong pixels: " + _words(wrong)
    return _small_multiples(
        ordered,
        answer_classes,
        ANSWERS,
        lambda m: f"{grouped(wrong[m.method])} wrong" if wrong[m.method] else "0 wrong",
        (f"ulps-{scalar}", title, alt, footer),
    )


def claims_chart(maps: Sequence[UlpMap], scalar: str, footer: str) -> Chart:
    """How many of two neighbours claim each point. `maps`: of one scalar."""
    ordered = _ordered(maps)
    classes = {m.method: claim_classes(m) for m in ordered}
    holes = {method: int((found == 3).sum()) for method, found in classes.items()}
    doubles = {method: int((found == 4).sum()) for method, found in classes.items()}
    whole = [m for m in holes if holes[m] == doubles[m] == 0]
    title = (
        f"Two triangles with a common edge, {scalar}: beside the edge "
        f"{len(whole)} of {counted(len(holes), 'method')} give every point to "
        "exactly one"
    )
    alt = f"{title}. Holes: {_words(holes)} Double hits: {_words(doubles)}"
    return _small_multiples(
        ordered,
        claim_classes,
        CLAIMS,
        lambda m: f"{grouped(holes[m.method])} holes, "
        f"{grouped(doubles[m.method])} double",
        (f"claims-{scalar}", title, alt, footer),
    )


def _ordered(maps: Sequence[UlpMap]) -> list[UlpMap]:
    by_method = {entry.method: entry for entry in maps}
    return [by_method[method] for method in in_order(by_method)]


def _words(counts: dict[str, int]) -> str:
    some = sorted((m for m in counts if counts[m]), key=lambda m: -counts[m])
    none = [m for m in counts if not counts[m]]
    words = "; ".join(f"{m} {grouped(counts[m])}" for m in some)
    if none:
        words += f"{'; ' if words else ''}none: {listed(none)}"
    return words + "."


def _small_multiples(
    maps: list[UlpMap],
    classify: Callable[[UlpMap], npt.NDArray[np.intp]],
    classes: Sequence[tuple[str, str]],
    note: Callable[[UlpMap], str],
    words: tuple[str, str, str, str],
) -> Chart:
    colours = np.array([rgb(colour) for _, colour in classes], dtype=np.uint8)
    lines = math.ceil(len(maps) / _COLUMNS)
    side, gap, top, bottom = 2.0, 0.2, 1.2, 0.35
    step = side + 0.42
    height = top + lines * step + bottom
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        for index, entry in enumerate(maps):
            line, column = divmod(index, _COLUMNS)
            axes = figure.add_axes(
                (
                    (0.1 + column * (side + gap)) / _WIDTH,
                    1 - (top + line * step + side) / height,
                    side / _WIDTH,
                    side / height,
                )
            )
            _pixels(axes, colours[classify(entry)])
            look = palette.method_style(entry.method)
            axes.text(
                0,
                1.1,
                entry.method,
                transform=axes.transAxes,
                fontsize=7.5 if len(entry.method) < 31 else 6.6,
                weight="bold",
                color=look.colour,
            )
            axes.text(
                0,
                1.02,
                note(entry),
                transform=axes.transAxes,
                fontsize=7,
                color="#666666",
            )
        figure.legend(
            handles=[
                Patch(facecolor=colour, edgecolor="#8A8A8A", linewidth=0.5, label=name)
                for name, colour in classes
            ],
            loc="upper left",
            bbox_to_anchor=(0.005, 1 - 0.56 / height),
            ncol=len(classes),
            fontsize=7.8,
            handlelength=1.1,
            handletextpad=0.4,
            columnspacing=1.1,
        )
        return finish(figure, *words)


def _pixels(axes: Any, picture: Picture) -> None:
    """Row 0 below, as y grows upwards."""
    axes.imshow(picture[::-1], interpolation="none", aspect="auto")
    axes.set_xticks([])
    axes.set_yticks([])
    axes.grid(visible=False)
    for spine in axes.spines.values():
        spine.set_visible(True)
        spine.set_linewidth(0.5)
