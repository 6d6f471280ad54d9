"""The letters of the charts, for a page to bring with it.

Charts hold their words as words and not as outlines: they can be searched and
read aloud, and take a tenth of the room. Matplotlib has placed them by the
widths of its own font, so a page has that font, with the letters that it uses.
"""

from __future__ import annotations

import base64
import functools
import html
import io
import re
from collections.abc import Iterable
from typing import Final

from fontTools.subset import Options, Subsetter
from fontTools.ttLib import TTFont
from matplotlib.font_manager import FontProperties, findfont

_MATPLOTLIBS: Final = "DejaVu Sans"
# A name of its own: what the page says about its other text stays as it is.
FAMILY: Final = "Charts"

_TEXT = re.compile(r"<t(?:ext|span)\b[^>]*>([^<]*)")


def font_faces(svgs: Iterable[str]) -> str:
    """CSS that brings the letters of these charts; the same bytes for the same
    letters. Nothing where there are no charts.
    """
    letters = frozenset("".join(_words(svg) for svg in svgs))
    if not letters:
        return ""
    return "\n".join(
        f'@font-face {{ font-family: "{FAMILY}"; font-weight: {weight}; '
        f"src: url(data:font/woff;base64,{_woff(weight, letters)}) "
        'format("woff"); }'
        for weight in (400, 700)
    )


def _words(svg: str) -> str:
    return html.unescape("".join(_TEXT.findall(svg)))


@functools.lru_cache(maxsize=8)
def _woff(weight: int, letters: frozenset[str]) -> str:
    path = findfont(
        FontProperties(family=_MATPLOTLIBS, weight=weight), fallback_to_default=False
    )
    font = TTFont(path, recalcTimestamp=False)
    options = Options(
        hinting=False,
        layout_features=["kern"],  # as matplotlib does; ligatures it has not
        notdef_outline=True,
        drop_tables=["FFTM"],
    )
    cut = Subsetter(options)
    cut.populate(text="".join(sorted(letters)))
    cut.subset(font)
    font.flavor = "woff"
    packed = io.BytesIO()
    font.save(packed)
    return base64.b64encode(packed.getvalue()).decode()
