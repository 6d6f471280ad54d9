"""Twelve scenes as they occur, described as `choose` wants them.

Their sizes are assumptions about a kind of program, not measurements; whoever
has other ones changes the command.
"""

from __future__ import annotations

import dataclasses
from typing import Final

from analysis.choice.choose_scene import Described


@dataclasses.dataclass(frozen=True)
class Typical:
    name: str
    words: str
    scene: Described


TYPICAL: Final = (
    Typical(
        "Picking in a game",
        "the cursor against ten thousand projected triangles, to an eighth of a pixel",
        Described(
            scalar="f32",
            coordinates=(0, 4096),
            altitude=0.5,
            edge=(1, 256),
            points=0.0001,
            hit=0.001,
            tolerance=0.125,
        ),
    ),
    Typical(
        "Tiles of a rasteriser",
        "64 × 64 pixels, vertices on 1/256 pixel, no pixel drawn twice or left out",
        Described(
            scalar="f32",
            coordinates=(0, 64),
            altitude=0,
            points=4096,
            grid=(64, 64),
            need="watertight",
            precision=1 / 256,
        ),
    ),
    Typical(
        "Masks of an image",
        "all pixels of a grid of 80 × 50, whole vertices",
        Described(
            scalar="i32",
            coordinates=(0, 79),
            altitude=0,
            grid=(80, 50),
            points=4000,
            need="exact",
        ),
    ),
    Typical(
        "Maps in degrees",
        "longitude and latitude, triangles from 1 cm to a degree, to a millimetre",
        Described(
            scalar="f64",
            coordinates=(-180, 180),
            altitude=1e-7,
            edge=(1e-6, 1),
            points=200,
            hit=0.3,
            tolerance=1e-8,
        ),
    ),
    Typical(
        "CAD far from the origin",
        "a part of 100 mm at a kilometre, to a tenth of a micrometre",
        Described(
            scalar="f64",
            coordinates=(1e6, 1e6 + 100),
            altitude=0.001,
            edge=(0.1, 100),
            points=4096,
            tolerance=1e-4,
        ),
    ),
    Typical(
        "Glyphs",
        "outlines in whole font units on an em of 2048, every sample right",
        Described(
            scalar="f32",
            coordinates=(0, 2048),
            altitude=0,
            points=4096,
            need="exact",
            precision=1,
        ),
    ),
    Typical(
        "Point location in a mesh",
        "a candidate triangle for each point, every point in exactly one",
        Described(
            scalar="f64",
            coordinates=(0, 1),
            aspect=50,
            edge=(0.001, 0.05),
            points=1,
            need="watertight",
        ),
    ),
    Typical(
        "Binning of particles",
        "100 000 particles against each large triangle of a unit square",
        Described(
            scalar="f32",
            coordinates=(0, 1),
            aspect=10,
            edge=(0.1, 0.5),
            points=100000,
            hit=0.05,
            precision=2.0**-24,
            tolerance=1e-4,
        ),
    ),
    Typical(
        "Hits of rays, projected",
        "a hit point and its triangle at a time, with the weights to shade it",
        Described(
            scalar="f32",
            coordinates=(-1, 1),
            aspect=20,
            edge=(0.01, 0.1),
            points=1,
            need="weights",
            tolerance=1e-4,
        ),
    ),
    Typical(
        "Navigation mesh",
        "an agent against a thousand triangles, never in two or none",
        Described(
            scalar="f32",
            coordinates=(-512, 512),
            altitude=0.05,
            edge=(0.5, 20),
            points=0.001,
            hit=0.001,
            need="watertight",
        ),
    ),
    Typical(
        "Regions in medical images",
        "voxels of a slice of 512 × 512 in whole numbers, every voxel right",
        Described(
            scalar="i16",
            coordinates=(0, 511),
            altitude=0,
            points=50000,
            need="exact",
        ),
    ),
    Typical(
        "Interpolation in finite elements",
        "16 points an element, weights to nine digits",
        Described(
            scalar="f64",
            coordinates=(0, 10),
            aspect=20,
            edge=(0.01, 0.1),
            points=16,
            need="weights",
            tolerance=1e-9,
        ),
    ),
)
