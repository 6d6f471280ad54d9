"""The pictures of what a method says of neighbouring floating-point numbers.

Each pixel is one representable point. Two triangles share the diagonal: the
lower one holds the pixels below it exactly, the upper one those above it.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Callable, Sequence
from typing import Any, Final, TypeVar

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.patches import Patch

from analysis.charts import palette
from analysis.charts.chart_frame import Chart, finish, style
from analysis.charts.ramp import rgb
from analysis.read.maps import ClaimMap, UlpMap
from analysis.report.method_families import FMA_SUFFIX, in_order
from analysis.report.wording import counted, grouped, listed

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
_ONCE, _BY_RULE_NONE, _BY_RULE_MANY = "#EEF1F3", "#9A9A9A", "#33658A"
_HOLE, _DOUBLE = "#B3001B", "#F0A202"
_COLUMNS: Final = 5
_WIDTH: Final = 11.0  # inches


@dataclasses.dataclass(frozen=True)
class ClaimWords:
    """What a picture of claims is about."""

    key: str
    start: str  # of the title
    beside: str  # where rounding decides
    once: str  # what is right
    hole: str
    classes: tuple[tuple[str, str], ...]  # as claim_classes counts them
    # The methods with multiply-add in a line of their own, below those without.
    fma_below: bool = False


def _legend(edge: str, hole: str, many: str) -> tuple[tuple[str, str], ...]:
    return (
        ("claimed once", _ONCE),
        (f"{edge}, claimed by none", _BY_RULE_NONE),
        (f"{edge}, claimed by {many}", _BY_RULE_MANY),
        (f"{hole}: claimed by none", _HOLE),
        (f"a double hit: claimed by {many}", _DOUBLE),
    )


NEIGHBOURS: Final = ClaimWords(
    "claims",
    "Two triangles with a common edge",
    "beside the edge",
    "give every point to exactly one",
    "hole",
    _legend("boundary", "a hole", "both"),
)
LEAKS: Final = ClaimWords(
    "ray-leaks",
    "Rays past a vertex of a closed sphere",
    "beside its edges",
    "give every ray to exactly one triangle",
    "leak",
    _legend("on an edge", "a leak", "several"),
    fma_below=True,
)
CLAIMS: Final = NEIGHBOURS.classes


def answer_classes(entry: UlpMap) -> npt.NDArray[np.intp]:
    """What the lower triangle's answer is at each pixel, as an index into
    ANSWERS, row 0 first.
    """
    j, i = np.indices(entry.lower.shape)
    said = entry.lower
    classes = np.where(said, 1, 5)
    classes = np.where(i < j, np.where(said, 4, 0), classes)
    return np.where(i == j, np.where(said, 3, 2), classes)


def claim_classes(entry: ClaimMap) -> npt.NDArray[np.intp]:
    """How many of the triangles claim each pixel, as an index into CLAIMS."""
    claims = entry.claims
    off = np.select([claims == 0, claims >= 2], [3, 4], 0)
    on = np.select([claims == 0, claims >= 2], [1, 2], 0)
    return np.where(entry.on_edge, on, off)


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


def claims_chart(
    maps: Sequence[ClaimMap],
    scalar: str,
    footer: str,
    words: ClaimWords = NEIGHBOURS,
) -> Chart:
    """How many of the triangles that meet claim each pixel. `maps`: of one
    scalar.
    """
    ordered = _ordered(maps)
    classes = {m.method: claim_classes(m) for m in ordered}
    holes = {method: int((found == 3).sum()) for method, found in classes.items()}
    doubles = {method: int((found == 4).sum()) for method, found in classes.items()}
    whole = [m for m in holes if holes[m] == doubles[m] == 0]
    title = (
        f"{words.start}, {scalar}: {words.beside} "
        f"{len(whole)} of {counted(len(holes), 'method')} {words.once}"
    )
    kind = words.hole
    alt = f"{title}. {kind.capitalize()}s: {_words(holes)} Double hits: "
    columns = _COLUMNS
    if words.fma_below:
        ordered, columns = fma_below(ordered)
    return _small_multiples(
        ordered,
        claim_classes,
        words.classes,
        lambda m: f"{counted(holes[m.method], kind)}, "
        f"{grouped(doubles[m.method])} double",
        (f"{words.key}-{scalar}", title, alt + _words(doubles), footer),
        columns,
    )


AnyMap = TypeVar("AnyMap", bound=ClaimMap)


def _ordered(maps: Sequence[AnyMap]) -> list[AnyMap]:
    by_method = {entry.method: entry for entry in maps}
    return [by_method[method] for method in in_order(by_method)]


def fma_below(ordered: list[AnyMap]) -> tuple[list[AnyMap], int]:
    """First those without multiply-add, those that have a form with it foremost,
    then these forms in the same order; and how many stand in a line.
    """
    by_method = {entry.method: entry for entry in ordered}
    fused = [m for m in by_method if m.endswith(FMA_SUFFIX)]
    bases = [m.removesuffix(FMA_SUFFIX) for m in fused]
    plain = [m for m in by_method if m not in fused]
    plain.sort(key=lambda method: method not in bases)  # stable
    return [by_method[m] for m in [*plain, *fused]], max(len(plain), 1)


def _words(counts: dict[str, int]) -> str:
    some = sorted((m for m in counts if counts[m]), key=lambda m: -counts[m])
    none = [m for m in counts if not counts[m]]
    words = "; ".join(f"{m} {grouped(counts[m])}" for m in some)
    if none:
        words += f"{'; ' if words else ''}none: {listed(none)}"
    return words + "."


def _small_multiples(
    maps: list[AnyMap],
    classify: Callable[[AnyMap], npt.NDArray[np.intp]],
    classes: Sequence[tuple[str, str]],
    note: Callable[[AnyMap], str],
    words: tuple[str, str, str, str],
    columns: int = _COLUMNS,
) -> Chart:
    colours = np.array([rgb(colour) for _, colour in classes], dtype=np.uint8)
    lines = math.ceil(len(maps) / columns)
    gap, top, bottom = 0.2, 1.2, 0.35
    side = _WIDTH / columns - gap
    step = side + 0.42
    height = top + lines * step + bottom
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        for index, entry in enumerate(maps):
            line, column = divmod(index, columns)
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
                fontsize=7.5 if len(entry.method) < 15.5 * side else 6.6,
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
