"""JSON files that are checked against a schema before anything uses them."""

from __future__ import annotations

import functools
import json
import math
from pathlib import Path
from typing import Any

import jsonschema

SCHEMAS = Path(__file__).resolve().parent.parent / "harness" / "schema"


class LoadError(Exception):
    """The input is not what it must be; the message names file and field."""


def read_json(path: Path, schema: str) -> dict[str, Any]:
    """The object in `path`, which fits harness/schema/<schema>.schema.json.

    Raises LoadError for whatever may be wrong with the file: it cannot be
    read, is no JSON, has a number that is not finite, or does not fit.
    """
    try:
        text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        raise LoadError(f"{path}: cannot be read: {error}") from None
    try:
        document = json.loads(text, parse_constant=_refuse, parse_float=_finite)
    except json.JSONDecodeError as error:
        hint = " (cut off?)" if error.pos >= len(text.rstrip()) else ""
        raise LoadError(
            f"{path}:{error.lineno}: is not JSON: {error.msg}{hint}"
        ) from None
    except (ValueError, RecursionError) as error:
        raise LoadError(f"{path}: is not JSON that is usable: {error}") from None
    problem = jsonschema.exceptions.best_match(_validator(schema).iter_errors(document))
    if problem is not None:
        field = problem.json_path + _whose(document, list(problem.absolute_path))
        raise LoadError(f"{path}: {field}: {_shortened(problem.message)}")
    assert isinstance(document, dict)
    return document


@functools.cache
def _validator(schema: str) -> Any:
    text = (SCHEMAS / f"{schema}.schema.json").read_text(encoding="utf-8")
    return jsonschema.Draft202012Validator(json.loads(text))


def _refuse(constant: str) -> float:
    raise ValueError(f"it contains {constant}, which is no number")


def _finite(text: str) -> float:
    value = float(text)
    if not math.isfinite(value):
        raise ValueError(f"it contains {text}, which no double can hold")
    return value


def _whose(document: Any, path: list[str | int]) -> str:
    """The name of the row or cell that the path leads into, if it has one."""
    if len(path) >= 2 and isinstance(path[1], int):
        row = document[path[0]][path[1]]
        if isinstance(row, dict) and isinstance(row.get("name"), str):
            return _shortened(f" ({row['name']})")
    return ""


def _shortened(message: str) -> str:
    return message if len(message) <= 240 else message[:120] + " … " + message[-100:]
