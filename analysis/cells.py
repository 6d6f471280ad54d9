"""The names of cells: `loop/scene/method/scalar/isa`, or with `/twin` behind.

A scene is a family and its parameters: `uniform:hit=50:n=4096:sets=fresh`.
"""

from __future__ import annotations

import dataclasses
import math
import re

# What stands between the separators. Narrow on purpose: a name is also part
# of file names, of HTML and of regular expressions on the command line.
_WORD = re.compile(r"[a-z][a-z0-9_]*\Z")
_VALUE = re.compile(r"[A-Za-z0-9_.+-]+\Z")

TWIN = "twin"
WEIGHTS_SUFFIX = "_weights"


class CellNameError(ValueError):
    """The text is not the name of a cell; the message says why."""


@dataclasses.dataclass(frozen=True)
class Scene:
    """A family of inputs and the parameters that it was made with."""

    family: str
    parameters: tuple[tuple[str, str], ...]

    def __str__(self) -> str:
        return ":".join([self.family, *(f"{k}={v}" for k, v in self.parameters)])

    def get(self, key: str) -> str | None:
        """The parameter as it is written, None if the scene has none such."""
        return dict(self.parameters).get(key)

    def number(self, key: str) -> float:
        """The parameter as a number, NaN if there is none or it is no number."""
        text = self.get(key)
        try:
            return float(text) if text is not None else math.nan
        except ValueError:
            return math.nan


@dataclasses.dataclass(frozen=True)
class Cell:
    """One kernel on one scene."""

    loop: str
    scene: Scene
    method: str
    scalar: str
    isa: str
    twin: bool = False

    def __str__(self) -> str:
        parts = [self.loop, str(self.scene), self.method, self.scalar, self.isa]
        return "/".join(parts + [TWIN] * self.twin)


def parse_scene(text: str) -> Scene:
    """The scene that `text` names. Raises CellNameError, and nothing else."""
    family, *pairs = text.split(":")
    _require(_WORD, family, "scene family")
    parameters: dict[str, str] = {}
    for pair in pairs:
        key, equals, value = pair.partition("=")
        _require(_WORD, key, "scene parameter")
        if not equals:
            raise CellNameError(f"scene parameter '{key}' has no '=value'")
        _require(_VALUE, value, f"value of scene parameter '{key}'")
        if key in parameters:
            raise CellNameError(f"scene parameter '{key}' is there twice")
        parameters[key] = value
    return Scene(family, tuple(parameters.items()))


def parse_cell(text: str) -> Cell:
    """The cell that `text` names. Raises CellNameError, and nothing else."""
    parts = text.split("/")
    twin = len(parts) == 6
    if len(parts) not in (5, 6) or (twin and parts[5] != TWIN):
        raise CellNameError(
            f"'{text}' is not of the form loop/scene/method/scalar/isa[/{TWIN}]"
        )
    loop, scene, method, scalar, isa = parts[:5]
    for word, what in (
        (loop, "loop"),
        (method, "method"),
        (scalar, "scalar"),
        (isa, "ISA"),
    ):
        _require(_WORD, word, what)
    return Cell(loop, parse_scene(scene), method, scalar, isa, twin)


def _require(pattern: re.Pattern[str], text: str, what: str) -> None:
    if not pattern.match(text):
        raise CellNameError(f"'{text}' is not a {what}")
