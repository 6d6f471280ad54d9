"""Numbers and contents follow the order in which things stand in a page."""

from __future__ import annotations

from analysis.report.page_order import (
    CONTENTS,
    numbered,
    parts,
    stand_in,
    with_contents,
)


def test_each_kind_is_numbered_in_the_order_of_its_captions() -> None:
    a, b, t = stand_in("Figure", "a"), stand_in("Figure", "b"), stand_in("Table", "t")
    page = f"see {a} and {t}: <b>{b}.</b> <b>{t}.</b> <b>{a}.</b> {b}"
    assert numbered(page) == (
        "see Figure 2 and Table 1: <b>Figure 1.</b> <b>Table 1.</b> "
        "<b>Figure 2.</b> Figure 1"
    )


def test_what_has_no_caption_is_called_by_its_key() -> None:
    assert numbered(stand_in("Table", "cells")) == "cells"


def test_the_contents_are_the_headings_by_part() -> None:
    page = (
        f'{CONTENTS}<p class="part">Speed</p>\n<section id="isa">\n<h2>Sets</h2>'
        '<p class="part">Empty</p>\n<p class="part">Rest</p>'
        '<section id="all"><h2>All <em>cells</em></h2>'
    )
    assert [(part.title, part.chapters) for part in parts(page)] == [
        ("Speed", (("isa", "Sets"),)),
        ("Rest", (("all", "All <em>cells</em>"),)),
    ]
    made = with_contents(page)
    assert '<a href="#isa">Sets</a>' in made and "Empty" not in made
