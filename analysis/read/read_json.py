"""JSON files that are checked against a schema before anything uses them."""

from __future__ import annotations

import functools
import gzip
import json
import math
import zlib
from pathlib import Path
from typing import Any

import jsonschema

from analysis.read.schema_check import Check, UnknownKeyword, compiled

SCHEMAS = Path(__file__).resolve().parents[2] / "harness" / "schema"


class LoadError(Exception):
    """The input is not what it must be; the message names file and field."""


def read_json(path: Path, schema: str) -> dict[str, Any]:
    """The object in `path`, which fits harness/schema/<schema>.schema.json.

    Raises LoadError for whatever may be wrong with the file: it cannot be
    read, is no JSON, has a number that is not finite, or does not fit.
    """
    try:
        if path.suffix == ".gz":
            text = gzip.decompress(path.read_bytes()).decode("utf-8")
        else:
            text = path.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError, EOFError, zlib.error) as error:
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
    if not _quick_check(schema)(document):
        _refuse_by_field(path, schema, document)
    assert isinstance(document, dict)
    return document


@functools.cache
def _validator(schema: str) -> Any:
    text = (SCHEMAS / f"{schema}.schema.json").read_text(encoding="utf-8")
    return jsonschema.Draft202012Validator(json.loads(text))


@functools.cache
def _quick_check(schema: str) -> Check:
    """Whether a document fits, without saying where it does not."""
    try:
        return compiled(_validator(schema).schema)
    except UnknownKeyword:  # slow, but no less strict
        return lambda document: bool(_validator(schema).is_valid(document))


def _refuse_by_field(path: Path, schema: str, document: Any) -> None:
    """Raises the LoadError of a document that does not fit. Of a long list of
    rows only the first that does not fit is looked at: jsonschema is slow.
    """
    shortened, place = document, None
    if isinstance(document, dict):
        for key, rows in document.items():
            if not isinstance(rows, list):
                continue
            for index, row in enumerate(rows):
                if not _quick_check(schema)({**document, key: [row]}):
                    shortened, place = {**document, key: [row]}, (key, index)
                    break
    problem = jsonschema.exceptions.best_match(
        _validator(schema).iter_errors(shortened)
    )
    if problem is None:
        return
    where = list(problem.absolute_path)
    field = problem.json_path + _whose(shortened, where)
    if place and where[:1] == [place[0]]:
        field = field.replace(f"$.{place[0]}[0]", f"$.{place[0]}[{place[1]}]", 1)
    raise LoadError(f"{path}: {field}: {_shortened(problem.message)}")


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
