"""Formulas as methods declare them, in plain text, set as formulas: MathML on
the page, which browsers draw and screen readers speak, and italics with low
parts on paper, whose writer draws no MathML. Neither needs a font of its own.

Between formulas stand words ("for each edge"), which stay words; so a line of
both can be broken between them.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import Final

from markupsafe import Markup, escape

# In the order in which they are tried. ex, vy, xa: a vector or a coordinate and
# which part of it. s_b, p_y: told by an underscore. pₓ: a letter that is low by
# itself. E1: a number. The "a" of "a line" and the s behind an apostrophe are
# words.
_TOKEN: Final = re.compile(
    r"""(?P<space>\s+)
    |(?P<part>\b(?:([evw])([xy])|([xy])([abc])|([A-Za-z])_([A-Za-z])|([A-Z])(\d))\b
              |([a-z])(ₓ))
    |(?P<power>⁻¹)
    |(?P<word>a(?=\ [a-z]{2})|[A-Za-z0-9]*[A-Za-z][A-Za-z0-9]*(?:[_'’-]\w+)+
              |\d*[A-Za-z]{2,}\d*|\d+[A-Z]\b|[a-z]\d{2}\b)
    |(?P<name>[A-Za-zαβδε])
    |(?P<number>\d+(?:\.\d+)?)
    |(?P<sign>.)""",
    re.VERBOSE,
)
_RELATIONS: Final = frozenset("+−·×≥≤<>=|/")
_OPENING: Final = frozenset("([⌈⌊")
_CLOSING: Final = frozenset(")]⌉⌋")


@dataclass(frozen=True)
class _Token:
    kind: str  # a group's name above
    text: str
    low: str = ""  # of a part: what is set below
    depth: int = 0  # the brackets around it


def on_paper(text: str) -> Markup:
    """`text`, which is plain, as HTML with names in italics."""
    return Markup("").join(map(_html, _tokens(text)))


def on_page(text: str) -> Markup:
    """`text`, which is plain, as HTML with its formulas as MathML."""
    pieces = []
    for is_math, group in groupby(_marked(list(_tokens(text))), lambda pair: pair[0]):
        tokens = [token for _, token in group]
        if not is_math:
            pieces.append(escape("".join(token.text for token in tokens)))
            continue
        for run in _breakable(tokens):
            pieces.append(_math(run))
    return Markup("").join(pieces)


def _tokens(text: str) -> Iterator[_Token]:
    depth = 0
    for found in _TOKEN.finditer(text):
        kind = str(found.lastgroup)
        depth -= found[0] in _CLOSING
        if kind == "part":
            name, low = [group for group in found.groups()[2:] if group][:2]
            yield _Token(kind, name, "x" if low == "ₓ" else low, depth)
        else:
            yield _Token(kind, found[0], depth=depth)
        depth += found[0] in _OPENING


def _html(token: _Token) -> Markup:
    if token.kind == "part":
        return Markup("<i>{}</i><sub>{}</sub>").format(token.text, token.low)
    if token.kind == "name":
        return Markup("<i>{}</i>").format(token.text)
    return escape(token.text)


def _marked(tokens: list[_Token]) -> Iterator[tuple[bool, _Token]]:
    """Each token, and whether it belongs to a formula."""
    marks = [_is_math(tokens, at) for at in range(len(tokens))]
    for at, token in enumerate(tokens):
        if token.kind == "space":  # by what it stands between
            marks[at] = 0 < at < len(tokens) - 1 and marks[at - 1] and marks[at + 1]
        yield marks[at], token


def _is_math(tokens: list[_Token], at: int) -> bool:
    token = tokens[at]
    before = [other for other in tokens[:at] if other.kind != "space"][-1:]
    after = [other for other in tokens[at + 1 :] if other.kind != "space"][:1]
    beside_word = any(other.kind == "word" for other in before + after)
    if token.kind != "word":
        # A comma or colon behind a word belongs to the sentence.
        return not (token.text in ",;:." and not token.depth and before and beside_word)
    if token.depth > 0 or (at + 1 < len(tokens) and tokens[at + 1].text == "("):
        return True
    return not beside_word and any(other.text in _RELATIONS for other in before + after)


def _breakable(tokens: list[_Token]) -> Iterator[list[_Token]]:
    """The formula's pieces: a line may be broken behind a comma and before a sign
    that stands between spaces, but not in brackets.
    """
    run: list[_Token] = []
    for at, token in enumerate(tokens):
        begun = any(other.kind != "space" for other in run)
        if begun and not token.depth and _stands_free(tokens, at):
            yield run
            run = []
        run.append(token)
        if token.text in ",;" and not token.depth:
            yield run
            run = []
    if run:
        yield run


def _stands_free(tokens: list[_Token], at: int) -> bool:
    """Whether the token is a sign between spaces."""
    around = tokens[max(at - 1, 0) : at] + tokens[at + 1 : at + 2]
    return tokens[at].text in _RELATIONS and [t.kind for t in around] == ["space"] * 2


def _math(run: list[_Token]) -> Markup:
    """The run as one <math>, and the spaces at its ends outside."""
    before = " " if run[0].kind == "space" else ""
    after = " " if run[-1].kind == "space" else ""
    inner = run[bool(before) : len(run) - bool(after)]
    sign = Markup("")
    if inner[0].text in _RELATIONS and inner[1:] and inner[1].kind == "space":
        # Of a line that was broken before it: no sign of the number behind it.
        # The space outside is its distance on the left.
        sign = Markup('<mo form="infix" lspace="0">{}</mo>').format(inner[0].text)
        inner = inner[2:]
    return Markup("{}<math>{}{}</math>{}").format(before, sign, _row(inner), after)


def _row(run: list[_Token]) -> Markup:
    elements: list[Markup] = []
    at = 0
    while at < len(run):
        token = run[at]
        if token.kind == "space":
            # Signs have their own distance; words have not.
            kinds = {run[at - 1].kind, run[at + 1].kind}
            if "word" in kinds and "sign" not in kinds:
                elements.append(Markup("<mtext>\N{NO-BREAK SPACE}</mtext>"))
        elif token.kind == "power":
            power = Markup("<msup>{}<mn>\N{MINUS SIGN}1</mn></msup>")
            elements.append(power.format(elements.pop()))
        elif rows := _rows_of_matrix(run[at:]):
            elements.append(_matrix(rows))
            at += sum(map(len, rows)) + len(rows)
        else:
            elements.append(_element(token))
        at += 1
    return Markup("").join(elements)


def _rows_of_matrix(run: list[_Token]) -> list[list[_Token]]:
    """What [A B C; 1 1 1] has in its rows, none if `run` begins otherwise."""
    texts = [token.text for token in run]
    if texts[0] != "[" or ";" not in texts[: texts.index("]")]:
        return []
    rows: list[list[_Token]] = [[]]
    for token in run[1 : texts.index("]")]:
        if token.text == ";":
            rows.append([])
        else:
            rows[-1].append(token)
    return rows


def _matrix(rows: list[list[_Token]]) -> Markup:
    cells = (
        Markup("").join(
            Markup("<mtd>{}</mtd>").format(_element(token))
            for token in row
            if token.kind != "space"
        )
        for row in rows
    )
    table = Markup("").join(Markup("<mtr>{}</mtr>").format(row) for row in cells)
    return Markup("<mrow><mo>[</mo><mtable>{}</mtable><mo>]</mo></mrow>").format(table)


def _element(token: _Token) -> Markup:
    if token.kind == "part":
        low = _element(_Token("number" if token.low.isdigit() else "name", token.low))
        return Markup("<msub><mi>{}</mi>{}</msub>").format(token.text, low)
    if token.text == "|":
        return Markup('<mo stretchy="false" lspace="0" rspace="0">|</mo>')
    if token.text in _OPENING or token.text in _CLOSING:
        return Markup('<mo stretchy="false">{}</mo>').format(token.text)
    tag = {"name": "mi", "word": "mtext", "number": "mn"}.get(token.kind, "mo")
    return Markup("<{}>{}</{}>").format(tag, token.text, tag)
