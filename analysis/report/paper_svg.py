"""Charts written so that WeasyPrint 57 draws all of them. In a page without an
address of its own it draws nothing that is used by reference, and of what is
filled with opacity 0 it leaves out the outline.
"""

from __future__ import annotations

import re
from typing import Final

_DEFINED: Final = re.compile(r'<path id="([^"]+)" d="([^"]+)"/>')
_USE: Final = re.compile(r'<use href="#([^"]+)"([^>]*)/>')
_PLACE: Final = re.compile(r' ([xy])="([^"]*)"')
_HOLLOW: Final = re.compile(r'<[^>]* fill-opacity="0"[^>]*>')
_FILL: Final = re.compile(r' fill(?:-opacity)?="[^"]*"')


def for_paper(page: str) -> str:
    """The page with each mark in its place, and hollow ones without a filling.
    Ids are those of the whole page, as small_svg.py gives them.
    """
    shapes = dict(_DEFINED.findall(page))
    page = _USE.sub(lambda use: _mark(shapes[use[1]], use[2]), page)
    return _HOLLOW.sub(
        lambda tag: re.sub(r"^<\w+", r'\g<0> fill="none"', _FILL.sub("", tag[0])),
        page,
    )


def _mark(shape: str, attributes: str) -> str:
    at = dict(_PLACE.findall(attributes))
    rest = _PLACE.sub("", attributes)
    place = f"translate({at.get('x', 0)} {at.get('y', 0)})"
    own = re.search(r' transform="([^"]*)"', rest)
    if own:
        rest = rest.replace(own[0], "")
        place = f"{own[1]} {place}"
    return f'<path d="{shape}" transform="{place}"{rest}/>'
