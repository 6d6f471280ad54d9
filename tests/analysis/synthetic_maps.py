"""A made-up maps.json. The bits of two formulas are computed as written, so
that the pictures look like real ones; the other methods borrow them.
"""

from __future__ import annotations

import base64
from typing import Any

import numpy as np
import numpy.typing as npt

from tests.analysis.synthetic_methods import METHODS

Floats = npt.NDArray[np.floating[Any]]
Bits = npt.NDArray[np.bool_]
SIDE = 256
LOWER = ((-12.0, -12.0), (24.0, 24.0), (24.0, -12.0))
UPPER = ((-12.0, -12.0), (24.0, 24.0), (-12.0, 24.0))


def document(
    context: dict[str, Any], methods: tuple[str, ...], scalars: tuple[str, ...]
) -> dict[str, Any]:
    return {
        "context": {**context, "schema": "pitbench-maps-1", "filter": ""},
        "ulp_maps": [
            ulp_map(method, scalar)
            for scalar in scalars
            for method in methods
            if not (METHODS[method].only_f32 and scalar != "f32")
        ],
        "gradients": [
            gradient(method, scene)
            for method in methods
            if METHODS[method].weights
            for scene in ("near_origin", "far_away")
        ],
        "two_truths": [
            {
                "id": "jts_163",
                "source": "https://example.org/issues/163",
                "scalar": "f64",
                "binary": "inside",
                "decimal": "boundary",
            }
        ],
    }


def ulp_map(method: str, scalar: str) -> dict[str, Any]:
    kind: Any = np.float32 if scalar == "f32" else np.float64
    unit = 2.0**-24 if scalar == "f32" else 2.0**-53
    steps = (0.5 + np.arange(SIDE) * unit).astype(kind)
    x, y = np.meshgrid(steps, steps)
    lower, upper = answers(method, LOWER, x, y), answers(method, UPPER, x, y)
    i, j = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
    claims = lower.astype(int) + upper
    wrong_in = (lower & (i < j)).sum() + (upper & (i > j)).sum()
    wrong_out = (~lower & (i > j)).sum() + (~upper & (i < j)).sum()
    return {
        "method": method,
        "scalar": scalar,
        "isa": "avx512",
        "width": SIDE,
        "height": SIDE,
        "lower": packed(lower),
        "upper": packed(upper),
        "counts": {
            "false_inside": int(wrong_in),
            "false_outside": int(wrong_out),
            "boundary_accepted": int(((lower + upper) & (i == j)).sum()),
            "holes": int((claims == 0).sum()),
            "double_hits": int(((claims == 2) & (i != j)).sum()),
        },
    }


def answers(method: str, triangle: Any, x: Floats, y: Floats) -> Bits:
    if method.startswith(("exact", "shewchuk", "promoted")):
        i, j = np.meshgrid(np.arange(SIDE), np.arange(SIDE))
        inside = i > j if triangle is LOWER else i < j
        boundary = i == j
        return np.asarray(inside | (boundary & (method == "exact")))
    kind = x.dtype.type
    corners = [(kind(px), kind(py)) for px, py in triangle]
    signs = []
    for k in range(3):
        (ax, ay), (bx, by) = corners[k], corners[(k + 1) % 3]
        if method.startswith("edge"):
            signs.append((ay - by) * x + (bx - ax) * y + (ax * by - bx * ay))
        elif method.startswith(("barycentric", "uv")):
            signs.append((bx - x) * (ay - by) + (by - y) * (bx - ax))
        else:
            signs.append((bx - ax) * (y - ay) - (by - ay) * (x - ax))
    sides = np.stack(signs)
    return np.asarray(np.all(sides >= 0, axis=0) | np.all(sides <= 0, axis=0))


def gradient(method: str, scene: str) -> dict[str, Any]:
    side, size = 96, 1.0
    away = 0.0 if scene == "near_origin" else 2.0**21
    kind = np.float32
    corners = [(away, away), (away + size, away), (away, away + size)]
    steps = (away + np.arange(side) * (size / side)).astype(kind)
    x, y = np.meshgrid(steps, steps)
    (ax, ay), (bx, by), (cx, cy) = [(kind(px), kind(py)) for px, py in corners]
    if method.startswith("barycentric_inverse"):
        area = ax * (by - cy) + bx * (cy - ay) + cx * (ay - by)
        with np.errstate(all="ignore"):
            wa = (x * (by - cy) + y * (cx - bx) + (bx * cy - cx * by)) / area
            wb = (x * (cy - ay) + y * (ax - cx) + (cx * ay - ax * cy)) / area
    else:
        area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        wb = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area
        wc = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area
        wa = 1 - wb - wc
    weights = np.stack([wa, wb, 1 - wa - wb], axis=2).astype("<f4")
    return {
        "method": method,
        "scalar": "f32",
        "isa": "avx512",
        "scene": scene,
        "width": side,
        "height": side,
        **{
            key: [float(v).hex() for v in corner] for key, corner in zip("abc", corners)
        },
        "x0": away.hex(),
        "y0": away.hex(),
        "step": (size / side).hex(),
        "weights": base64.b64encode(weights.tobytes()).decode(),
        "inside": packed(np.all(weights >= 0, axis=2)),
    }


def packed(bits: Bits) -> str:
    rows = np.packbits(bits, axis=1, bitorder="little")
    return base64.b64encode(rows.tobytes()).decode()
