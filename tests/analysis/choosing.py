"""All methods as a program would list them, and times for them, to choose among."""

from __future__ import annotations

from analysis.choice.choose_times import Timing
from analysis.choice.error_bounds import ALWAYS_EXACT, EXPANSIONS, SNAPPED
from analysis.choice.error_families import FAMILIES
from analysis.read.run import MethodEntry

TOP_LEFT = {name for name in (*FAMILIES, *ALWAYS_EXACT) if "top_left" in name}
METHODS = (*FAMILIES, *ALWAYS_EXACT, *EXPANSIONS, *SNAPPED)


def entry(key: str, **other: object) -> MethodEntry:
    boundary = "top_left" if key in TOP_LEFT else "closed"
    values = {"boundary": boundary, "accepts": "triangle", "fma": False} | other
    weights = key.startswith(("barycentric", "cross_solve", "uv_"))
    return MethodEntry(key, "", "", weights=weights, **values)  # type: ignore[arg-type]


ENTRIES = tuple(entry(key) for key in METHODS)


def timing(method: str, ns: float, scalar: str = "f32") -> Timing:
    """Five repetitions within a hundredth."""
    values = tuple(ns * (1 + 0.002 * k) for k in range(-2, 3))
    return Timing(method, scalar, "one_triangle", "avx2", "uniform", values)
