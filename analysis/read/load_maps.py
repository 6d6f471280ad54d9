"""maps.json: bits and weights from base64, each as large as it says."""

from __future__ import annotations

import base64
import binascii
from pathlib import Path
from typing import Any

import numpy as np

from analysis.read.fields import SameRun, whole
from analysis.read.maps import Bits, Gradient, Maps, RayCase, RayMap, TwoTruths, UlpMap
from analysis.read.read_json import LoadError, read_json


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
        ray_maps=_ray_maps(path, document),
        ray_cases=tuple(
            RayCase(
                **{key: entry[key] for key in ("id", "source", "scalar", "truth")},
                answers=tuple((a["method"], a["hit"]) for a in entry["answers"]),
            )
            for entry in document.get("ray_cases", [])
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
        counts=_counts(path, field, entry),
    )


def _ray_maps(path: Path, document: dict[str, Any]) -> tuple[RayMap, ...]:
    windows: dict[str, tuple[int, int, Bits]] = {}
    for index, entry in enumerate(document.get("ray_windows", [])):
        field = f"$.ray_windows[{index}]"
        width, height = int(entry["width"]), int(entry["height"])
        if not (0 < width <= _LARGEST_SIDE and 0 < height <= _LARGEST_SIDE):
            raise LoadError(f"{path}: {field}.width: {width} by {height} is no picture")
        on_edge = _bits(path, f"{field}.on_edge", entry["on_edge"], width, height)
        windows[entry["scalar"]] = (width, height, on_edge)
    maps = []
    for index, entry in enumerate(document.get("ray_maps", [])):
        field = f"$.ray_maps[{index}]"
        if entry["scalar"] not in windows:
            raise LoadError(
                f"{path}: {field}.scalar: $.ray_windows has none of {entry['scalar']}"
            )
        width, height, on_edge = windows[entry["scalar"]]
        claimed = _bits(path, f"{field}.claimed", entry["claimed"], width, height)
        name = f"{field}.claimed_twice"
        twice = _bits(path, name, entry["claimed_twice"], width, height)
        if (twice & ~claimed).any():
            raise LoadError(f"{path}: {name}: has rays that {field}.claimed has not")
        maps.append(
            RayMap(
                method=entry["method"],
                scalar=entry["scalar"],
                isa=entry["isa"],
                claimed=claimed,
                twice=twice,
                on_edge=on_edge,
                counts=_counts(path, field, entry),
            )
        )
    return tuple(maps)


def _counts(path: Path, field: str, entry: dict[str, Any]) -> dict[str, int]:
    return {
        key: whole(path, f"{field}.counts.{key}", value)
        for key, value in entry["counts"].items()
    }


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
