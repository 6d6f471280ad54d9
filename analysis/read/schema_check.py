"""A fast yes or no to whether a document fits a JSON schema.

jsonschema walks the schema anew for each value, which takes minutes for the
cells of a run. Here the schema is turned once into plain functions, which say
only whether a value fits; what does not fit, and where, is then for jsonschema
to say, of the one row that was found. Both must agree: the tests hold them
against each other on spoilt documents.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any, Final

Check = Callable[[Any], bool]


class UnknownKeyword(ValueError):
    """The schema says something that is not understood here."""


# These say nothing about what fits.
_NOTES = {"$schema", "$id", "$defs", "$comment", "title", "description", "examples"}


def compiled(schema: dict[str, Any]) -> Check:
    """The check of a whole schema. Raises UnknownKeyword."""
    return _Compiler(schema).check(schema)


class _Compiler:
    def __init__(self, root: dict[str, Any]) -> None:
        self._root = root
        self._named: dict[str, Check] = {}

    def check(self, schema: Any) -> Check:
        if isinstance(schema, bool):
            return lambda value: bool(schema)
        checks: list[Check] = []
        for keyword in schema:
            if keyword in _NOTES or keyword in ("then", "else"):
                continue
            if keyword in _OBJECT_KEYWORDS:
                continue
            make = getattr(self, "_" + keyword.lstrip("$"), None)
            if make is None:
                raise UnknownKeyword(keyword)
            checks.append(make(schema[keyword], schema))
        if any(keyword in schema for keyword in _OBJECT_KEYWORDS):
            checks.append(self._object(schema))
        return _both(checks)

    def _ref(self, name: str, _: Any) -> Check:
        if name not in self._named:
            place: Any = self._root
            if not name.startswith("#/"):
                raise UnknownKeyword(f"$ref {name}")
            for part in name[2:].split("/"):
                place = place[part]
            self._named[name] = self.check(place)
        return self._named[name]

    def _type(self, names: Any, _: Any) -> Check:
        wanted = [names] if isinstance(names, str) else names
        types = frozenset(kind for name in wanted for kind in _TYPES[name])
        if "integer" in wanted and "number" not in wanted:  # 2.0 is one too
            return lambda value: type(value) in types or _is_whole(value)
        return lambda value: type(value) in types

    def _const(self, wanted: Any, _: Any) -> Check:
        return lambda value: _same(value, wanted)

    def _enum(self, values: list[Any], _: Any) -> Check:
        if all(isinstance(value, str) for value in values):
            words = frozenset(values)
            return lambda value: isinstance(value, str) and value in words
        return lambda value: any(_same(value, wanted) for wanted in values)

    def _pattern(self, pattern: str, _: Any) -> Check:
        search = re.compile(pattern).search
        return lambda value: not isinstance(value, str) or search(value) is not None

    def _minLength(self, least: int, _: Any) -> Check:
        return lambda value: not isinstance(value, str) or len(value) >= least

    def _minimum(self, least: float, _: Any) -> Check:
        return lambda value: not _is_number(value) or not value < least

    def _maximum(self, most: float, _: Any) -> Check:
        return lambda value: not _is_number(value) or not value > most

    def _exclusiveMinimum(self, bound: float, _: Any) -> Check:
        return lambda value: not _is_number(value) or not value <= bound

    def _exclusiveMaximum(self, bound: float, _: Any) -> Check:
        return lambda value: not _is_number(value) or not value >= bound

    def _minItems(self, least: int, _: Any) -> Check:
        return lambda value: not isinstance(value, list) or len(value) >= least

    def _maxItems(self, most: int, _: Any) -> Check:
        return lambda value: not isinstance(value, list) or len(value) <= most

    def _items(self, schema: Any, _: Any) -> Check:
        each = self.check(schema)
        if not isinstance(schema, dict) or not schema.keys() <= _OF_NUMBERS:
            return lambda value: not isinstance(value, list) or all(map(each, value))
        # Numbers within bounds: those at both ends stand for all between them,
        # and a sum of floats tells that no NaN is among them.
        plain: set[type] = {int} if schema.get("type") == "integer" else {int, float}

        def numbers(value: Any) -> bool:
            if not isinstance(value, list) or not value:
                return True
            if not plain.issuperset(map(type, value)) or not math.isfinite(sum(value)):
                return all(map(each, value))
            return each(min(value)) and each(max(value))

        return numbers

    def _uniqueItems(self, wanted: bool, _: Any) -> Check:
        def check(value: Any) -> bool:
            return not isinstance(value, list) or not any(
                _same(one, other)
                for at, one in enumerate(value)
                for other in value[:at]
            )

        return check if wanted else lambda value: True

    def _allOf(self, schemas: list[Any], _: Any) -> Check:
        checks = [self.check(schema) for schema in schemas]
        return lambda value: all(check(value) for check in checks)

    def _anyOf(self, schemas: list[Any], _: Any) -> Check:
        checks = [self.check(schema) for schema in schemas]
        return lambda value: any(check(value) for check in checks)

    def _oneOf(self, schemas: list[Any], _: Any) -> Check:
        checks = [self.check(schema) for schema in schemas]
        return lambda value: sum(check(value) for check in checks) == 1

    def _not(self, schema: Any, _: Any) -> Check:
        check = self.check(schema)
        return lambda value: not check(value)

    def _if(self, schema: Any, whole: Any) -> Check:
        condition = self.check(schema)
        then = self.check(whole.get("then", True))
        otherwise = self.check(whole.get("else", True))
        return lambda value: then(value) if condition(value) else otherwise(value)

    def _object(self, schema: Any) -> Check:
        """properties, required and additionalProperties together: one pass."""
        known = {k: self.check(s) for k, s in schema.get("properties", {}).items()}
        required = tuple(schema.get("required", ()))
        other = self.check(schema.get("additionalProperties", True))

        def check(value: Any) -> bool:
            if not isinstance(value, dict):
                return True
            for key in required:
                if key not in value:
                    return False
            for key, inner in value.items():
                if not known.get(key, other)(inner):
                    return False
            return True

        return check


_OBJECT_KEYWORDS = ("properties", "required", "additionalProperties")


def _both(checks: list[Check]) -> Check:
    """Whether a value fits all of them."""
    if not checks:
        return lambda value: True
    if len(checks) == 1:
        return checks[0]
    first, rest = checks[0], _both(checks[1:])
    return lambda value: first(value) and rest(value)


def _is_number(value: Any) -> bool:
    return type(value) is int or type(value) is float


def _is_whole(value: Any) -> bool:
    return type(value) is float and value.is_integer()


def _same(one: Any, other: Any) -> bool:
    """Equality in which true is not 1."""
    if isinstance(one, bool) or isinstance(other, bool):
        return one is other
    if isinstance(one, list) and isinstance(other, list):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(_same(one[k], other[k]) for k in one)
    return bool(one == other)


# What a list of numbers may be asked for one number at a time.
_OF_NUMBERS: Final = _NOTES | {
    *("type", "minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum")
}
# As json.loads() makes them.
_TYPES: Final[dict[str, tuple[type, ...]]] = {
    "null": (type(None),),
    "boolean": (bool,),
    "integer": (int,),
    "number": (int, float),
    "string": (str,),
    "array": (list,),
    "object": (dict,),
}
