"""The limits of the made-up machine, and invented counts of operations.

Its clock runs at 3.5 GHz; each cycle it does two additions, two multiply-adds
and four of both, compares in units that do not add, loads two vectors from L1, one from L2, half of one from L3
and an eighth from memory: round numbers, so that bounds can be made by hand.
"""

from __future__ import annotations

from typing import Any

GHZ = 3.5
BYTES = {"scalar": 4, "ssse3": 16, "sse4": 16, "avx2": 32, "avx512": 64}
WIDTHS = {"f32": 4, "f64": 8, "i32": 4, "i16": 2, "u8": 1}
A_CYCLE = {"add": 2.0, "multiply": 2.0, "multiply_add": 2.0, "mixed": 4.0} | {
    "divide": 0.2,
    "min_max": 2.0,
    "compare": 2.0,
    "add_min_max_compare": 4.0,
    "multiply_multiply_add": 2.0,
}
_FUSED = ("multiply_add", "multiply_multiply_add")
_OF_FLOATS = (*_FUSED, "divide", "mixed", "add_min_max_compare")
LEVELS = [
    ("L1", 49152, 24576, 2.0),
    ("L2", 1 << 20, 1 << 19, 1.0),
    ("L3", 1 << 25, 5 << 20, 0.5),
    ("DRAM", None, 1 << 27, 0.125),
]
# (method → per point: multiply-adds or pairs of multiplication and addition).
_PRODUCTS = {"cross_product": 6, "edge_function": 6, "edge_function_fma": 6}


def limits(context: dict[str, Any], isas: tuple[str, ...]) -> dict[str, Any]:
    here = [isa for isa in BYTES if isa in isas]
    memory = []
    operations = []
    for isa in here:
        groups = [[s] for s in WIDTHS] if isa == "scalar" else [list(WIDTHS)]
        for scalars in groups:
            width = WIDTHS[scalars[0]] if isa == "scalar" else BYTES[isa]
            for level, _, _, loads in LEVELS:
                for streams, share in ((1, 1.0), (2, 0.9)):
                    rate = GHZ * 1e9 * width * loads * share
                    memory.append(_memory(isa, scalars, level, "load", streams, rate))
            rate = GHZ * 1e9 * width
            memory.append(_memory(isa, scalars, "L1", "store", 1, rate))
        for scalar in WIDTHS:
            lanes = 1 if isa == "scalar" else BYTES[isa] // WIDTHS[scalar]
            for kind, count in A_CYCLE.items():
                if kind in _FUSED and isa not in ("avx2", "avx512"):
                    continue
                if scalar[0] != "f":
                    if kind in _OF_FLOATS:
                        continue
                    kind = "integer_multiply" if kind == "multiply" else kind
                value = GHZ * 1e9 * lanes * count
                operations.append(
                    {
                        "isa": isa,
                        "scalar": scalar,
                        "operation": kind,
                        "operations_per_second": value,
                        "median": 0.99 * value,
                        "lowest": 0.9 * value,
                    }
                )
    return {
        "context": {
            **context,
            "schema": "pitbench-limits-1",
            "cpu": 1,
            "clock_before_ghz": GHZ,
            "clock_after_ghz": GHZ,
            "seconds_per_sample": 0.001,
            "repetitions": 9,
        },
        "levels": [
            {"name": name, "capacity_bytes": capacity, "probed_bytes": probed}
            for name, capacity, probed, _ in LEVELS
        ],
        "memory": memory,
        "operations": operations,
    }


def _memory(
    isa: str, scalars: list[str], level: str, access: str, streams: int, rate: float
) -> dict[str, Any]:
    return {
        "isa": isa,
        "scalars": scalars,
        "level": level,
        "access": access,
        "streams": streams,
        "bytes_per_second": rate,
        "median": 0.97 * rate,
        "lowest": 0.8 * rate,
    }


def operations(
    context: dict[str, Any], methods: tuple[str, ...], scalars: tuple[str, ...]
) -> dict[str, Any]:
    rows = []
    for method in methods:
        for scalar in scalars:
            for loop in ("one_triangle", "one_point", "pairs"):
                products = _PRODUCTS.get(method)
                if products is None:
                    continue
                fused = method.endswith("_fma")
                item = _counts(compare=3)
                if fused:
                    item["multiply_add"] = products
                else:
                    item |= {"add": products, "multiply": products}
                rows.append(
                    {
                        "method": method,
                        "scalar": scalar,
                        "loop": loop,
                        "per_call": _counts(add=9, multiply=6),
                        "per_item": item,
                    }
                )
    return {
        "schema": "operations-1",
        "context": {k: v for k, v in context.items() if k != "schema"},
        "rows": rows,
    }


def _counts(**known: float) -> dict[str, float]:
    kinds = ["add", "multiply", "multiply_add", "divide", "min_max", "compare"]
    kinds += ["integer_multiply", "logic", "convert", "load", "store"]
    return {kind: known.get(kind, 0) for kind in kinds}
