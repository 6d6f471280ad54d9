"""What methods declare in plain text is set as formulas."""

from __future__ import annotations

import tomllib
from html.parser import HTMLParser
from pathlib import Path

import pytest

from analysis.report.formula import on_page, on_paper

METHODS = Path(__file__).resolve().parents[2] / "report" / "methods.toml"
DECLARED = [
    method["formula"]
    for method in tomllib.loads(METHODS.read_text(encoding="utf-8")).values()
    if "formula" in method
] + [
    "[A B C; 1 1 1]⁻¹ · (x, y, 1) ≥ 0",
    "t by the plane; (α, β) = G⁻¹·(a·x, b·x); α, β ≥ 0, α + β ≤ 1",
    "u = S·(D×E2)/δ, v = D·(S×E1)/δ; u ≥ 0, v ≥ 0, u + v ≤ 1",
]


class _Reader(HTMLParser):
    """The text, and the deepest and the last nesting of elements."""

    def __init__(self, markup: object) -> None:
        super().__init__()
        self.text, self.open = "", list[str]()
        self.feed(str(markup))
        self.close()

    def handle_starttag(self, tag: str, attrs: object) -> None:
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        self.text += data


def signs(text: str) -> str:
    """What is left when distances, low letters and rows are all on one line."""
    for sign, plain in {"ₓ": "x", "⁻¹": "−1", ";": "", "_": ""}.items():
        text = text.replace(sign, plain)
    return "".join(text.split())


@pytest.mark.parametrize("text", DECLARED)
def test_a_formula_says_on_page_and_paper_what_was_declared(text: str) -> None:
    for made in (on_page(text), on_paper(text)):
        read = _Reader(made)
        assert not read.open
        assert signs(read.text) == signs(text)


def test_names_are_set_as_names_on_paper() -> None:
    assert on_paper("ex·(y − vy) ≥ 0 by a line") == (
        "<i>e</i><sub>x</sub>·(<i>y</i> − <i>v</i><sub>y</sub>) ≥ 0 by a line"
    )
    assert on_paper("a·x, p_y, pₓ, E1/δ") == (
        "<i>a</i>·<i>x</i>, <i>p</i><sub>y</sub>, <i>p</i><sub>x</sub>, "
        "<i>E</i><sub>1</sub>/<i>δ</i>"
    )


def test_a_formula_on_the_page_is_mathml_and_its_words_are_words() -> None:
    assert on_page("u as cross_product, E1 ≥ −ε for each edge") == (
        "<math><mi>u</mi></math> as cross_product, "
        "<math><msub><mi>E</mi><mn>1</mn></msub></math> <math>"
        '<mo form="infix" lspace="0">≥</mo><mo>−</mo><mi>ε</mi></math> for each edge'
    )
    assert on_page("U + V < area, by a line") == (
        '<math><mi>U</mi></math> <math><mo form="infix" lspace="0">+</mo><mi>V</mi></math> '
        '<math><mo form="infix" lspace="0">&lt;</mo><mtext>area</mtext></math>, by a line'
    )


@pytest.mark.parametrize(
    "text, pieces",
    [
        ("u, v", 2),
        ("u, ≥ v", 2),
        ("u ≥ 0, v", 3),
        ("(u, v − 1)·w", 1),
        ("−u·v + w/2", 2),
        ("⌈u − v⌉", 1),
    ],
)
def test_a_line_can_be_broken_at_commas_and_signs_but_not_in_brackets(
    text: str, pieces: int
) -> None:
    assert on_page(text).count("<math>") == pieces


def test_a_matrix_has_rows() -> None:
    made = on_page("[A B; 1 1]⁻¹")
    assert made.count("<mtr>") == 2 and made.count("<mtd>") == 4
    assert made.endswith("<mn>−1</mn></msup></math>")


@pytest.mark.parametrize("made", [on_page, on_paper])
def test_what_is_markup_in_a_text_is_escaped(made: object) -> None:
    assert callable(made)
    assert "<b>" not in made("Kahan's <b> > 0") and "&lt;" in made("Kahan's <b> > 0")
