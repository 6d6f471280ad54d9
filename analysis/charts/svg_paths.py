"""Paths and numbers of an SVG, written as short as an eye allows."""

from __future__ import annotations

import re
from collections.abc import Iterator

_STEP = re.compile(r"([A-Za-z])([^A-Za-z]*)")

Step = tuple[str, tuple[float, ...]]


def number(value: float, decimals: int) -> str:
    """Rounded, without zeros that say nothing: 3, -.5."""
    text = f"{value:.{decimals}f}"
    if "." in text:
        text = text.rstrip("0").rstrip(".")
    if text in ("-0", "0"):
        return "0"
    return text.replace("0.", ".", 1) if text.lstrip("-").startswith("0.") else text


def steps(path: str) -> list[Step]:
    """The steps of a path in absolute coordinates: M, L, Q, C and Z."""
    found = []
    for letter, values in _STEP.findall(path):
        if letter.upper() != "Z" and letter not in "MLQC":
            raise ValueError(f"a path with a step {letter!r}")
        found.append((letter.upper(), tuple(map(float, values.split()))))
    return found


def moved(path: list[Step], x: float, y: float) -> list[Step]:
    return [
        (letter, tuple(v + (y if k % 2 else x) for k, v in enumerate(values)))
        for letter, values in path
    ]


def short(path: list[Step], decimals: int) -> str:
    """The path in text. A line to where the pen is already is left out, unless
    it is all there is; one along an axis names one coordinate.
    """
    return "".join(_written(path, decimals))


def _written(path: list[Step], decimals: int) -> Iterator[str]:
    here = ("", "")
    for at, (letter, values) in enumerate(path):
        texts = [number(value, decimals) for value in values]
        if not texts:
            yield letter
            continue
        there = (texts[-2], texts[-1])
        if letter != "L" or at == 0:
            yield letter + _joined(texts)
        elif there == here:
            alone = at + 1 == len(path) or path[at + 1][0] != "L"
            if path[at - 1][0] == "M" and alone:
                yield "h0"
        elif there[1] == here[1]:
            yield "H" + there[0]
        elif there[0] == here[0]:
            yield "V" + there[1]
        else:
            yield "L" + _joined(texts)
        here = there


def _joined(texts: list[str]) -> str:
    """Parted by a blank, where a minus does not part them."""
    return texts[0] + "".join(t if t[0] == "-" else " " + t for t in texts[1:])
