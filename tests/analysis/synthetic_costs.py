"""The made-up counts of a synthetic run: operations.json, instructions.json."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from analysis.read.load_operations import KINDS

# vaddps, vmulps and vfmadd231ps, then add, cmp and jne.
_LOOP_ENDS = ["4883c010", "4839c8", "75e6"]
ITERATIONS = {
    "avx512": ["62f1744858c2", "62f1744859c2", "62f27548b8c2", *_LOOP_ENDS],
    "avx2": ["c5f458c2", "c5f459c2", "c4e275b8c2", *_LOOP_ENDS],
}
COUNTED = {
    "cross_product": {"add": 7, "multiply": 6, "multiply_add": 1, "compare": 3},
    "cross_product_det": {"add": 9, "multiply": 6, "compare": 3},
    "barycentric_inverse": {"add": 6, "multiply": 6, "compare": 3},
}
OTHERS = {"multiply_add": 6, "compare": 3}


def documents(
    context: dict[str, Any],
    methods: Sequence[str],
    scalars: Sequence[str],
    isas: Sequence[str],
) -> dict[str, Any]:
    """File name → document."""
    own = {key: value for key, value in context.items() if key != "schema"}
    cells = [(method, scalar) for method in methods for scalar in scalars]
    return {
        "operations.json": {
            "schema": "operations-1",
            "context": own,
            "rows": [
                {
                    "method": method,
                    "scalar": scalar,
                    "loop": "one_triangle",
                    "per_call": counts({"add": 9, "multiply": 8, "load": 6}),
                    "per_item": counts(COUNTED.get(method, OTHERS)),
                }
                for method, scalar in cells
            ],
        },
        "instructions.json": {
            "schema": "instructions-1",
            "context": own,
            "reason": "",
            "rows": [
                {
                    "method": method,
                    "scalar": scalar,
                    "loop": "one_triangle",
                    "isa": isa,
                    "per_call": 90,
                    "per_item": len(ITERATIONS[isa]) / 16,
                    "items_per_iteration": 16,
                    "iteration": list(ITERATIONS[isa]),
                }
                for method, scalar in cells
                for isa in isas
                if isa in ITERATIONS
            ],
        },
    }


def counts(some: dict[str, float]) -> dict[str, float]:
    """All kinds, those not given as 0."""
    return {kind: some.get(kind, 0) for kind in KINDS}
