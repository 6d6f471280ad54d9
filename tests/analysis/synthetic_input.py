"""Made-up cells of what the input does: the number of points, the share of them
inside, and CPUs that share them. Invented so that a dear set-up pays, and an
early way out does not.
"""

from __future__ import annotations

ISAS = {"scalar": 1.0, "avx2": 11.0, "avx512": 26.0}
SETUPS = {
    "cross_product": (6.0, 1.9),
    "cross_product_unhoisted": (5.0, 2.6),
    "barycentric_inverse": (60.0, 1.7),
    "uv_projection": (9.0, 2.6),
}
SIZES = (1, 16, 256, 4096, 65536, 1 << 20, 1 << 24)
RATES = (0, 10, 50, 100)


def cells(scalar: str) -> list[tuple[str, float | None, float]]:
    """As synthetic.timed_cells: (name, ns per item, items a call)."""
    found: list[tuple[str, float | None, float]] = []
    for isa, rate in ISAS.items():
        for n in SIZES:
            for method, (setup, point) in SETUPS.items():
                # As long as memory takes at the least, where no cache holds it.
                ns = max(setup / n + point / rate, 0.2 if n > 1 << 22 else 0.0)
                scene = f"uniform:hit=50:n={n}:sets=fresh"
                name = f"one_triangle/{scene}/{method}/{scalar}/{isa}"
                found.append((name, ns, float(n)))
        for hit in RATES:
            for sets in ("fresh", "fixed"):
                guesses = 4.0 * hit * (100 - hit) / 2500 if sets == "fresh" else 0.0
                for suffix, ns in (("", 1.9), ("_early_out", 1.2 + guesses)):
                    scene = f"uniform:hit={hit}:bytes=16k:sets={sets}"
                    method = f"cross_product{suffix}"
                    name = f"one_triangle/{scene}/{method}/{scalar}/{isa}"
                    found.append((name, ns / rate, 2048.0))
        for threads in (1, 2):
            scene = "uniform:hit=50:bytes=64M:sets=fresh"
            name = f"one_triangle/{scene}/cross_product/{scalar}/{isa}"
            ns = max(1.9 / rate / threads, 0.15)
            found.append((f"{name}/threads:{threads}", ns, float(1 << 23)))
    return found
