"""maps.json: bits and weights from base64, each as large as it says."""

from __future__ import annotations

import base64
import binascii
from pathlib import Path
from typing import Any

import numpy as np

from analysis.fields import SameRun, whole
from analysis.maps import Bits, Gradient, Maps, TwoTruths, UlpMap
from analysis.read_json import LoadError, read_json


_LARGEST_SIDE = 4096


def load_maps(path: Path, same_run: SameRun) -> Maps:
    """Raises LoadError, which names the file and the field."""
    document = read_json(path, "maps")
    same_run.check(path, "$.context", document["context"])
    return Maps(
        ulp_maps=tuple(
            _ulp_map(path, f"$.ulp_maps[{index}]", entry)
            for index, entry in enumerate(document["ulp_maps"])
        ),
        gradients=tuple(
            _gradient(path, f"$.gradients[{index}]", entry)
            for index, entry in enumerate(document["gradients"])
        ),
        two_truths=tuple(
            TwoTruths(**entry) for entry in document.get("two_truths", [])
        ),
    )


def _ulp_map(path: Path, field: str, entry: dict[str, Any]) -> UlpMap:
    width, height = int(entry["width"]), int(entry["height"])
    if width != height:
        raise LoadError(f"{path}: {field}.height: is {height}, the width {width}")
    return UlpMap(
        method=entry["method"],
        scalar=entry["scalar"],
        isa=entry["isa"],
        lower=_bits(path, f"{field}.lower", entry["lower"], width, height),
        upper=_bits(path, f"{field}.upper", entry["upper"], width, height),
        counts={
            key: whole(path, f"{field}.counts.{key}", value)
            for key, value in entry["counts"].items()
        },
    )


def _gradient(path: Path, field: str, entry: dict[str, Any]) -> Gradient:
    width, height = int(entry["width"]), int(entry["height"])
    if not (0 < width <= _LARGEST_SIDE and 0 < height <= _LARGEST_SIDE):
        raise LoadError(f"{path}: {field}.width: {width} by {height} is no picture")
    raw = _bytes(path, f"{field}.weights", entry["weights"], 12 * width * height)
    weights = np.frombuffer(raw, dtype="<f4").reshape(height, width, 3)
    corners = []
    for key in ("a", "b", "c"):
        x, y = (_number(path, f"{field}.{key}", text) for text in entry[key])
        corners.append((x, y))
    return Gradient(
        method=entry["method"],
        scalar=entry["scalar"],
        isa=entry["isa"],
        scene=entry["scene"],
        corners=tuple(corners),
        weights=weights.astype(np.float32),
        inside=_bits(path, f"{field}.inside", entry["inside"], width, height),
    )


def _number(path: Path, field: str, text: str) -> float:
    try:
        return float.fromhex(text)
    except (ValueError, OverflowError):
        raise LoadError(f"{path}: {field}: {text} is no double") from None


def _bits(path: Path, field: str, text: str, width: int, height: int) -> Bits:
    """Rows of bits, least significant first, each row in whole bytes."""
    row = -(-width // 8)
    raw = _bytes(path, field, text, row * height)
    packed = np.frombuffer(raw, dtype=np.uint8).reshape(height, row)
    return np.unpackbits(packed, axis=1, bitorder="little")[:, :width].astype(bool)


def _bytes(path: Path, field: str, text: str, length: int) -> bytes:
    try:
        raw = base64.b64decode(text, validate=True)
    except (binascii.Error, ValueError) as error:
        raise LoadError(f"{path}: {field}: is not base64: {error}") from None
    if len(raw) != length:
        raise LoadError(f"{path}: {field}: has {len(raw)} bytes, not {length}")
    return raw
