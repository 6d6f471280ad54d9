"""Made-up cells of accuracy: every family of scenes and class of failure."""

from __future__ import annotations

import random
from typing import Any

from analysis.trust.stats import wilson
from tests.analysis.synthetic_methods import METHODS

# Family → (scene, share of the method's error rate near an edge).
SCENES: dict[str, list[tuple[str, float]]] = {
    "uniform": [("uniform:hit=50:bytes=24k:sets=fresh", 0.0)],
    "near_edge": [(f"near_edge:ulps={2**k}", 0.8**k / (1 + k)) for k in range(9)],
    "near_vertex": [(f"near_vertex:ulps={k}", 0.6) for k in (0, 1, 16, 256)],
    "needle": [(f"needle:aspect={e}", min(e / 20, 1.0)) for e in range(2, 17, 2)],
    "offset": [(f"offset:ratio={e}", min(e / 12, 1.0)) for e in range(0, 13, 2)],
    "scale": [(f"scale:exponent={e}", abs(e) / 200) for e in (-140, -64, 0, 64, 120)],
    "exponent_spread": [
        (f"exponent_spread:binades={b}", b / 80) for b in (0, 10, 28, 60)
    ],
    "cancellation": [(f"cancellation:binades={b}", b / 80) for b in (20, 28, 36)],
    "whole_numbers": [(f"whole_numbers:bits={b}", b / 80) for b in (12, 22, 24)],
    "degenerate": [
        (f"degenerate:kind={kind}", 0.5) for kind in ("collinear", "doubled", "single")
    ],
    "special": [
        (f"special:kind={kind}", 0.1)
        for kind in ("nan", "infinite", "minus_zero", "subnormal", "largest")
    ],
    "mesh_pair": [(f"mesh_pair:ulps={k}", 0.5) for k in (0, 4)],
    "mesh_fan": [(f"mesh_fan:ulps={k}", 0.5) for k in (0, 4)],
    "mesh_triangulation": [("mesh_triangulation:ulps=1", 0.3)],
    "corpus": [("corpus", 0.5)],
}
NOT_FINITE = ("special:kind=nan", "special:kind=infinite")
WORST = {
    "corpus": {
        "a": ["0x0p+0", "0x0p+0"],
        "b": ["0x1p+2", "0x0p+0"],
        "c": ["0x0p+0", "0x1p+2"],
        "p": ["0x1p+1", "0x1p+0"],
    },
    "near_edge": {
        "a": ["0x0p+0", "0x0p+0"],
        "b": ["0x1p+0", "0x0p+0"],
        "c": ["0x1p+0", "0x1p-13"],
        "p": ["0x1.8p-1", "0x1p-15"],
    },
    "": {
        "a": ["0x1.eb851ep-3", "-0x1.47ae14p-1"],
        "b": ["0x1.70a3d8p+0", "0x1.3d70a4p-2"],
        "c": ["-0x1.0a3d7p-1", "0x1.d1eb86p+0"],
        "p": ["0x1.99999ap-4", "0x1.333334p-2"],
    },
}


def cells(
    family: str,
    scalar: str,
    kernels: list[tuple[str, str]],
    factors: dict[str, float],
    seed: int,
) -> list[dict[str, Any]]:
    """The cells of a family for each (method, ISA)."""
    chance = random.Random(f"{seed} accuracy {family} {scalar}")
    found = []
    for scene, hardness in SCENES[family]:
        wrong: dict[str, int] = {}
        for key, isa in kernels:
            if key not in wrong:
                rate = min(METHODS[key].error * hardness * factors.get(key, 1.0), 0.9)
                if METHODS[key].accepts != "triangle":
                    rate = 0.66
                inside = round(rate * 5000 * (0.9 + 0.2 * chance.random()))
                wrong[key] = min(inside, 4800)
            found.append(cell(scene, key, scalar, isa, wrong[key]))
    return found


def cell(scene: str, key: str, scalar: str, isa: str, wrong: int) -> dict[str, Any]:
    """A cell of 10 000 points; 80 of them on the boundary, 20 degenerate."""
    family = scene.partition(":")[0]
    interior, exterior, degenerate = 4900, 5000, 20
    if family == "degenerate":
        interior, exterior, degenerate = 0, 0, 9920
        wrong = min(wrong, 4000)
    boundary = 80
    if scene == "near_vertex:ulps=0":
        interior, exterior, degenerate, boundary, wrong = 0, 0, 0, 9000, 0
    if scene in NOT_FINITE:
        interior = exterior = degenerate = wrong = 0
    outside = wrong // 3 if interior else 0
    accepted = {"closed": boundary, "open": 0}.get(METHODS[key].boundary, boundary // 2)
    careless = 500 if METHODS[key].warning else 0
    classes = {
        "false_inside": share(family, wrong - outside, exterior + degenerate),
        "false_outside": share(family, outside, interior, "outside"),
        "boundary_accepted": share(family, accepted, boundary) | {"worst": []},
        "not_finite_accepted": share(family, careless, 1000),
        "reversed_winding": share(family, wrong // 5, 9900),
        "rotated_vertices": share(family, wrong // 4, 9900),
        "swapped_vertices": share(family, wrong // 6, 9900),
        "negated": share(family, 0, 9900),
        "scaled_by_power_of_two": share(family, wrong // 50, 8000),
    }
    if family.startswith("mesh"):
        classes["hole"] = share(family, wrong // 7, 5000, "outside")
        doubled = 0 if METHODS[key].boundary == "top_left" and not wrong else wrong // 9
        classes["double_hit"] = share(family, doubled, 5000)
    return {
        "name": f"one_triangle/{scene}/{key}/{scalar}/{isa}",
        "loop": "one_triangle",
        "scene": scene,
        "method": key,
        "scalar": scalar,
        "isa": isa,
        "boundary_rule": METHODS[key].boundary,
        "accepts": METHODS[key].accepts,
        "points": 10000 if boundary == 80 else boundary,
        "interior": interior,
        "exterior": exterior,
        "boundary": boundary,
        "degenerate": degenerate,
        "not_finite": 9920 if scene in NOT_FINITE else 0,
        "classes": classes,
        "weights": (
            {
                "largest_ulps": 812.5,
                "mean_ulps": 0.7,
                "not_finite": 0,
                "points": 9980,
                "largest_forward_ulps": 96.25,
                "mean_forward_ulps": 1.5,
            }
            if METHODS[key].weights
            else None
        ),
    }


def share(family: str, count: int, of: int, said: str = "inside") -> dict[str, Any]:
    interval = wilson(count, of)
    points = WORST.get(family, WORST[""])
    return {
        "count": count,
        "of": of,
        "low": interval.low,
        "high": interval.high,
        "distance_ulps": {"smallest": 0.5, "largest": 9.5} if count else None,
        "worst": (
            [{"distance_ulps": 9.5, "said": said, **points}] if count and of else []
        ),
    }
