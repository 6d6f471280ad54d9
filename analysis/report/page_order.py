"""What depends on the order in which things stand in a page: the numbers of its
figures and tables, and its contents. Both are known only when the page is whole,
so templates write stand-ins, which are replaced here.
"""

from __future__ import annotations

import dataclasses
import re
from typing import Final

from markupsafe import Markup

# Control characters, which no text of a run holds: read_json refuses them.
_STAND_IN: Final = re.compile("\x02(Figure|Table) ([^\x03]+)\x03")
_CAPTION: Final = re.compile("<b>\x02(Figure|Table) ([^\x03]+)\x03\\.</b>")
CONTENTS: Final = Markup("\x02contents\x03")
_EMPTY: Final = re.compile(r'<p class="part">[^<]*</p>\s*(?=<p class="part">)')
_HEADING: Final = re.compile(
    r'<p class="part">(?P<part>.*?)</p>'
    r'|<section id="(?P<id>[^"]+)">\s*<h2>(?P<title>.*?)</h2>',
    re.DOTALL,
)


@dataclasses.dataclass(frozen=True)
class Part:
    """Chapters (id, title) that belong together. Texts are markup."""

    title: str
    chapters: tuple[tuple[str, str], ...]


def stand_in(kind: str, key: str) -> str:
    """The name of an exhibit, until its number is known."""
    return f"\x02{kind} {key}\x03"


def numbered(page: str) -> str:
    """The page with its figures and tables numbered as their captions stand,
    each kind from 1. An exhibit without a caption here is called by its key.
    """
    names: dict[tuple[str, str], str] = {}
    counts = {"Figure": 0, "Table": 0}
    for kind, key in _CAPTION.findall(page):
        counts[kind] += 1
        names[kind, key] = f"{kind} {counts[kind]}"
    return _STAND_IN.sub(
        lambda found: names.get((found[1], found[2]), found[2]),
        page,
    )


def parts(page: str) -> list[Part]:
    """The chapters of the page by the parts in which they stand; a part without
    a chapter is left out.
    """
    found: list[tuple[str, list[tuple[str, str]]]] = []
    for heading in _HEADING.finditer(page):
        if heading["part"] is not None:
            found.append((heading["part"], []))
        elif found:
            found[-1][1].append((heading["id"], heading["title"]))
    return [Part(title, tuple(chapters)) for title, chapters in found if chapters]


def with_contents(page: str) -> str:
    """The page with its contents where their stand-in is, as a list of parts;
    the names of parts without a chapter go.
    """
    page = _EMPTY.sub("", page)
    items = "".join(
        f"<li><span>{part.title}</span><ul>"
        + "".join(
            f'<li><a href="#{key}">{title}</a></li>' for key, title in part.chapters
        )
        + "</ul></li>\n"
        for part in parts(page)
    )
    return page.replace(CONTENTS, f"<ol>\n{items}</ol>")
