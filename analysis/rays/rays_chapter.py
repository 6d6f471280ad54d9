"""What the prose of the chapter on rays says beside its tables."""

from __future__ import annotations

import dataclasses

from analysis.rays.rays_failures import contraction_words
from analysis.rays.rays_guidance import guidance, priced
from analysis.rays.rays_leaks import contraction
from analysis.rays.rays_tables import without_tuv
from analysis.read.run import Run
from analysis.speed.input_tables import of_comparisons
from analysis.speed.tables import speed_cells


@dataclasses.dataclass(frozen=True)
class RayFacts:
    """The chapter in phrases; all empty where the run has nothing for it."""

    guidance: tuple[str, ...] = ()
    leaks: tuple[str, ...] = ()  # scalars with a picture
    contraction: str = ""


def ray_facts(run: Run, scalar: str) -> RayFacts:
    rays = run.rays
    if not len(rays.speed) or not len(rays.accuracy):
        return RayFacts()
    every = without_tuv(speed_cells(rays.speed))
    prices = priced(rays, of_comparisons(every), every, scalar)
    torn = contraction(run.maps.ray_cases)
    mapped = {m.scalar for m in run.maps.ray_maps}
    return RayFacts(
        guidance=() if prices is None else guidance(prices),
        leaks=tuple(s for s in ("f32", "f64") if s in mapped),
        contraction=contraction_words(torn),
    )
