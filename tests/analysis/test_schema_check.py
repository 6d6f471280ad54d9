"""The fast check says of every document what jsonschema says."""

from __future__ import annotations

import copy
import math
import time
from collections.abc import Callable
from typing import Any

import jsonschema
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from analysis.read.read_json import _validator
from analysis.read.schema_check import UnknownKeyword, compiled
from tests.analysis.conftest import TWO_METHODS
from tests.analysis.synthetic import documents
from tests.analysis.test_load_spoilt import JSON, places

NAMES = ["machine", "speed", "accuracy", "methods", "maps"]
CHECKS = {name: compiled(_validator(name).schema) for name in NAMES}


def shortened(document: Any) -> Any:
    """A document with no more than three rows in a list, to be quick."""
    if isinstance(document, dict):
        return {key: shortened(inner) for key, inner in document.items()}
    if isinstance(document, list):
        return [shortened(inner) for inner in document[:3]]
    return document


FILES = documents(TWO_METHODS)
GOOD = {
    name: shortened(next(d for f, d in FILES.items() if f.startswith(name)))
    for name in NAMES
}


@settings(max_examples=400, deadline=None)
@given(data=st.data())
def test_a_spoilt_document_is_judged_as_jsonschema_judges_it(
    data: st.DataObject,
) -> None:
    name = data.draw(st.sampled_from(NAMES))
    document = copy.deepcopy(GOOD[name])
    *parents, last = data.draw(st.sampled_from(places(document)))
    inner = document
    for key in parents:
        inner = inner[key]
    if isinstance(inner, dict) and data.draw(st.booleans()):
        del inner[last]
    else:
        inner[last] = data.draw(JSON)
    assert CHECKS[name](document) == _validator(name).is_valid(document)


@pytest.mark.parametrize(
    ("schema", "value", "fits"),
    [
        ({"const": 1}, True, False),
        ({"enum": [0, "a"]}, False, False),
        ({"type": "integer"}, 2.0, True),
        ({"type": "integer"}, True, False),
        ({"type": ["null", "string"]}, None, True),
        ({"minimum": 3}, "text", True),
        ({"pattern": "b"}, "abc", True),
        ({"oneOf": [{"type": "number"}, {"minimum": 0}]}, 1, False),
        ({"anyOf": [{"type": "number"}, {"minimum": 0}]}, 1, True),
        ({"allOf": [{"type": "number"}, {"minimum": 2}]}, 1, False),
        ({"not": {"const": 1}}, 1, False),
        ({"if": {"type": "string"}, "then": {"minLength": 2}}, "a", False),
        ({"if": {"type": "string"}, "else": {"maximum": 2}}, 3, False),
        ({"exclusiveMinimum": 0, "exclusiveMaximum": 1}, 1, False),
        ({"minimum": 3, "maximum": 4}, math.nan, True),
        ({"exclusiveMinimum": 0, "exclusiveMaximum": 1}, math.nan, True),
        ({"items": {"type": "null"}, "minItems": 1, "maxItems": 2}, [None, None], True),
        ({"items": False}, [1], False),
        ({"uniqueItems": True}, [1, True, [1], [True]], True),
        ({"uniqueItems": True}, [1, "a", 1.0], False),
    ],
)
def test_each_keyword_means_what_the_standard_says(
    schema: Any, value: Any, fits: bool
) -> None:
    assert compiled(schema)(value) == fits
    assert jsonschema.Draft202012Validator(schema).is_valid(value) == fits


def test_a_keyword_that_is_not_known_is_not_passed_over() -> None:
    with pytest.raises(UnknownKeyword):
        compiled({"multipleOf": 2})


def test_the_cells_of_a_run_are_checked_much_faster() -> None:
    """A run has tens of thousands of cells: jsonschema alone is too slow for them.
    Five times as many are checked in less than its time.
    """
    cells = FILES["accuracy-near_edge-f32.json"]["cells"]
    few, many = ((cells * 1000)[:count] for count in (200, 1000))

    def seconds(check: Callable[[Any], bool], rows: list[Any]) -> float:
        before = time.process_time()
        assert check({**GOOD["accuracy"], "cells": rows})
        return time.process_time() - before

    slow = seconds(_validator("accuracy").is_valid, few)
    assert min(seconds(CHECKS["accuracy"], many) for _ in range(3)) < slow
