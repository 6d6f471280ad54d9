"""One scale of colours for rates of failure: a colour a decade, light to dark.

After ColorBrewer's yellow-orange-brown: lightness falls steadily, so that the
order can be seen with any colour blindness and on paper. None at all is white
and stands outside of the scale.
"""

from __future__ import annotations

import math
from typing import Final

Colour = tuple[int, int, int]

# Rates up to 10 ppm, 100 ppm, 0.1 %, 1 %, 10 %, 100 %.
COLOURS: Final = ("#FFF0B3", "#FED976", "#FDAE4B", "#F07F1F", "#C5500C", "#7F2704")
ZERO: Final = "#FFFFFF"
UNKNOWN: Final = "#E4E4E4"
_SMALLEST_DECADE: Final = -6
_LIGHT_TEXT_FROM: Final = 4  # the level from which dark letters are hard to read


def level(rate: float) -> int:
    """The decade of a positive rate, as an index into COLOURS."""
    decade = math.ceil(math.log10(rate)) - 1 - _SMALLEST_DECADE
    return min(max(decade, 0), len(COLOURS) - 1)


def colour(rate: float) -> Colour:
    """The colour of a rate, between those of its decade and the next; white
    for none, grey for NaN.
    """
    if math.isnan(rate):
        return rgb(UNKNOWN)
    if rate <= 0:
        return rgb(ZERO)
    at = (math.log10(rate) - _SMALLEST_DECADE) * (len(COLOURS) - 1) / len(COLOURS)
    at = min(max(at, 0.0), len(COLOURS) - 1.0)
    low = min(int(at), len(COLOURS) - 2)
    pairs = zip(rgb(COLOURS[low]), rgb(COLOURS[low + 1]))
    red, green, blue = (round(a + (at - low) * (b - a)) for a, b in pairs)
    return (red, green, blue)


def rgb(text: str) -> Colour:
    """#FF8000 → (255, 128, 0)."""
    red, green, blue = bytes.fromhex(text[1:])
    return (red, green, blue)


def css() -> str:
    """Two classes of the page's style for each level: of a cell, and, with
    `under-`, of its second line alone.
    """
    return "\n".join(
        f"{cell}{index}{part} {{ background: {text}; "
        f"color: {'#FFFFFF' if index >= _LIGHT_TEXT_FROM else '#1D1D1F'}; }}"
        for cell, part in (("td.rate", ""), ("table td.under-rate", " small"))
        for index, text in enumerate(COLOURS)
    )
