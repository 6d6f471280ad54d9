"""The names of cells: `loop/scene/method/scalar/isa`, and behind that `/twin`,
`/doubled` or `/placed_<bytes>` where a cell is timed again as a control, or
`/threads:2` where so many CPUs did a part of each call.

A scene is a family and its parameters: `uniform:hit=50:n=4096:sets=fresh`.
"""

from __future__ import annotations

import dataclasses
import functools
import math
import re

# What stands between the separators. Narrow on purpose: a name is also part
# of file names, of HTML and of regular expressions on the command line.
_WORD = re.compile(r"[a-z][a-z0-9_]*\Z")
_VALUE = re.compile(r"[A-Za-z0-9_.+-]+\Z")

# The controls: what tells how far the times can be trusted.
TWIN = "twin"  # the same once more
DOUBLED = "doubled"  # two calls timed as one
_CONTROL = re.compile(r"(twin|doubled|placed_[0-9]{1,3})\Z")
_THREADS = re.compile(r"threads:([1-9][0-9]{0,5})\Z")
WEIGHTS_SUFFIX = "_weights"
TUV_SUFFIX = "_tuv"  # of rays
# The loop that finds x and y of each point side by side, and the one whose scenes
# and arithmetic it shares.
SIDE_BY_SIDE = "one_triangle_aos"
WHOLE_ARRAYS = "one_triangle"


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
    """One kernel on one scene, or a control of it."""

    loop: str
    scene: Scene
    method: str
    scalar: str
    isa: str
    control: str = ""
    threads: int | None = None  # None where the name does not tell, which is 1

    def __str__(self) -> str:
        parts = [self.loop, str(self.scene), self.method, self.scalar, self.isa]
        if self.threads is not None:
            parts.append(f"threads:{self.threads}")
        return "/".join(parts + [self.control] * bool(self.control))


@functools.cache
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
    last = "/".join(parts[5:])
    threads = _THREADS.match(last)
    control = "" if threads else last
    if len(parts) < 5 or (len(parts) > 5 and not (threads or _CONTROL.match(last))):
        raise CellNameError(
            f"'{text}' is not of the form loop/scene/method/scalar/isa[/{TWIN}] "
            "or …/threads:2"
        )
    loop, scene, method, scalar, isa = parts[:5]
    for word, what in (
        (loop, "loop"),
        (method, "method"),
        (scalar, "scalar"),
        (isa, "ISA"),
    ):
        _require(_WORD, word, what)
    count = int(threads.group(1)) if threads else None
    return Cell(loop, parse_scene(scene), method, scalar, isa, control, count)


def _require(pattern: re.Pattern[str], text: str, what: str) -> None:
    if not pattern.match(text):
        raise CellNameError(f"'{text}' is not a {what}")
