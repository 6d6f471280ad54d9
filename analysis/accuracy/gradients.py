"""Triangles whose corners are red, green and blue, mixed by computed weights."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import matplotlib.pyplot as plt
import numpy as np
import numpy.typing as npt
from matplotlib.patches import Patch

from analysis.charts import palette
from analysis.charts.chart_frame import Chart, finish, style
from analysis.charts.ramp import rgb
from analysis.read.maps import Gradient
from analysis.report.method_families import in_order
from analysis.report.wording import counted, grouped, power_of_two

OUTSIDE: Final = "#F1F1EF"
NO_WEIGHTS: Final = "#1D1D1F"  # called inside, but a weight is NaN or infinite
SCENES: Final = ("near_origin", "far_away")
_COLUMNS: Final = 7
_WIDTH: Final = 11.0  # inches


def picture(entry: Gradient) -> npt.NDArray[np.uint8]:
    """The colours, row 0 first. Five bits a channel: finer steps cannot be
    seen, and make the picture larger.
    """
    usable = np.isfinite(entry.weights).all(axis=2)
    mixed = np.clip(np.where(usable[..., None], entry.weights, 0.0), 0.0, 1.0)
    colours = (np.round(mixed * 31) * (255 / 31)).astype(np.uint8)
    colours[entry.inside & ~usable] = rgb(NO_WEIGHTS)
    colours[~entry.inside] = rgb(OUTSIDE)
    return np.asarray(colours)


def steps(entry: Gradient) -> int:
    """How many colours the triangle is made of before rounding to five bits:
    the fewer, the coarser its weights are.
    """
    usable = entry.inside & np.isfinite(entry.weights).all(axis=2)
    return len(np.unique(entry.weights[usable], axis=0))


def gradients_chart(gradients: Sequence[Gradient], scalar: str, footer: str) -> Chart:
    """A column a method, a row near the origin and one far away. `gradients`:
    of one scalar, at least one.
    """
    by_place = {(entry.method, entry.scene): entry for entry in gradients}
    methods = in_order(entry.method for entry in gradients)
    bands = [methods[i : i + _COLUMNS] for i in range(0, len(methods), _COLUMNS)]
    side, gap, top, bottom = 1.3, 0.14, 1.2, 0.35
    band_height = 2 * (side + gap) + 0.34
    height = top + band_height * len(bands) + bottom
    with style():
        figure = plt.figure(figsize=(_WIDTH, height))
        for band, members in enumerate(bands):
            for column, method in enumerate(members):
                for row, scene in enumerate(SCENES):
                    entry = by_place.get((method, scene))
                    if entry is None:
                        continue
                    down = top + band * band_height + row * (side + gap) + side
                    axes = figure.add_axes(
                        (
                            (0.85 + column * (side + gap)) / _WIDTH,
                            1 - down / height,
                            side / _WIDTH,
                            side / height,
                        )
                    )
                    axes.imshow(
                        picture(entry)[::-1], interpolation="none", aspect="auto"
                    )
                    axes.axis("off")
                    if row == 0:
                        axes.set_title(
                            method.replace("_determinant", "\n_determinant").replace(
                                "_inverse", "\n_inverse"
                            ),
                            fontsize=6.8,
                            weight="bold",
                            loc="left",
                            pad=2,
                            color=palette.method_style(method).colour,
                        )
                    if column == 0:
                        axes.text(
                            -0.07,
                            0.5,
                            _place(entry),
                            transform=axes.transAxes,
                            ha="right",
                            va="center",
                            fontsize=7.5,
                        )
        figure.legend(
            handles=[
                Patch(facecolor=OUTSIDE, edgecolor="#8A8A8A", label="called outside"),
                Patch(facecolor=NO_WEIGHTS, label="called inside without weights"),
            ],
            loc="upper left",
            bbox_to_anchor=(0.005, 1 - 0.5 / height),
            ncol=2,
            fontsize=7.8,
            handlelength=1.1,
        )
        title = _title(by_place, methods, scalar)
        alt = f"{title}. Different weights within the triangle: " + "; ".join(
            f"{entry.method}, {entry.scene.replace('_', ' ')}: {grouped(steps(entry))}"
            for entry in gradients
        )
        return finish(figure, f"gradients-{scalar}", title, f"{alt}.", footer)


def _place(entry: Gradient) -> str:
    """Where the triangle lies, in powers of two of its size."""
    corners = np.array(entry.corners)
    size = float(np.ptp(corners, axis=0).max())
    away = float(np.abs(corners).max())
    if entry.scene == "near_origin" or size == 0:
        return "near the\norigin"
    return f"{power_of_two(round(np.log2(away / size)))} sizes\naway"


def _title(
    by_place: dict[tuple[str, str], Gradient], methods: list[str], scalar: str
) -> str:
    coarse = 0
    for method in methods:
        pair = [by_place.get((method, scene)) for scene in SCENES]
        near, far = (steps(entry) if entry else 0 for entry in pair)
        coarse += 2 * far < near
    return (
        f"Colours mixed by the weights, {scalar}: far from the origin "
        f"{coarse} of {counted(len(methods), 'method')} "
        f"{'has' if coarse == 1 else 'have'} less than half the steps left"
    )
