"""Formulas as methods declare them, in plain text, set as formulas: names in
italics, and what belongs to a name below it. Needs no network and no fonts of
its own, and is the same in a page and on paper.
"""

from __future__ import annotations

import re
from typing import Final

from markupsafe import Markup, escape

# ex, vy, xa: a vector or a coordinate and which part of it. s_b, p_y: told by
# an underscore. pₓ: a letter that is low by itself. E1: a number.
_PART: Final = re.compile(
    r"\b(?:([evw])([xy])|([xy])([abc])|([A-Za-z])_([A-Za-z])|([A-Z])(\d))\b|([a-z])ₓ"
)
# A letter alone, which “a” before a word and the s behind an apostrophe are not.
_NAME: Final = re.compile(r"(?<![\w;])([A-Zb-zαβδε]|a(?! \w))(?!\w)")


def formula(text: str) -> Markup:
    """`text` is plain and is escaped."""
    with_parts = _PART.sub(_low, str(escape(text)))
    pieces = re.split(r"(<[^>]+>[^<]*</[^>]+>)", with_parts)
    return Markup(
        "".join(
            piece if index % 2 else _NAME.sub(r"<i>\1</i>", piece)
            for index, piece in enumerate(pieces)
        )
    )


def _low(found: re.Match[str]) -> str:
    if found[9]:
        return f"<i>{found[9]}</i><sub>x</sub>"
    name, part = (group for group in found.groups() if group)
    return f"<i>{name}</i><sub>{part}</sub>"
