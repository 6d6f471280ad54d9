"""Maps of rays are read as they were written, and refused where they do not fit."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from analysis.read.load import LoadError, load_run
from tests.analysis.synthetic_maps import packed

CLAIMED = np.zeros((2, 10), dtype=bool)
CLAIMED[0, 9] = CLAIMED[1, 0] = True
TWICE = np.zeros((2, 10), dtype=bool)
TWICE[1, 0] = True
COUNTS = {
    "false_inside": 1,
    "false_outside": 2,
    "boundary_accepted": 3,
    "holes": 18,
    "double_hits": 1,
}


def add_rays(folder: Path, change: Callable[[dict[str, Any]], Any] = len) -> None:
    path = folder / "maps.json"
    document = json.loads(path.read_text())
    corner = ["0x1p+0", "-0x1.8p-1", "0x0p+0"]
    document["ray_windows"] = [
        {
            "scalar": "f32",
            "width": 10,
            "height": 2,
            "origin": corner,
            "direction": corner,
            "axes": ["y", "z"],
            "step": "0x1p-24",
            "triangles": [[corner, corner, corner]],
            "on_edge": packed(TWICE),
        }
    ]
    document["ray_maps"] = [
        {
            "method": "exact",
            "scalar": "f32",
            "isa": "avx2",
            "claimed": packed(CLAIMED),
            "claimed_twice": packed(TWICE),
            "counts": dict(COUNTS),
        }
    ]
    document["ray_cases"] = [
        {
            "id": "a_case",
            "source": "https://example.org",
            "scalar": "f32",
            "truth": "boundary",
            "answers": [{"method": "exact", "hit": True}],
        }
    ]
    change(document)
    path.write_text(json.dumps(document))


def test_rays_are_read_row_by_row(small_run: Path) -> None:
    add_rays(small_run)
    maps = load_run(small_run).maps
    entry = maps.ray_maps[0]
    assert (entry.claims == CLAIMED.astype(int) + TWICE).all()
    assert (entry.on_edge == TWICE).all()
    assert entry.counts == COUNTS
    assert maps.ray_cases[0].answers == (("exact", True),)


def test_a_run_from_before_rays_has_none(small_run: Path) -> None:
    assert load_run(small_run).maps.ray_maps == ()


@pytest.mark.parametrize(
    ("spoil", "said"),
    [
        (
            lambda d: d["ray_maps"][0].update(scalar="f64"),
            r"\$\.ray_maps\[0\]\.scalar: \$\.ray_windows has none of f64",
        ),
        (
            lambda d: d["ray_maps"][0].update(claimed=packed(TWICE & False)),
            r"\$\.ray_maps\[0\]\.claimed_twice: has rays that",
        ),
        (
            lambda d: d["ray_maps"][0].update(claimed="AAAA"),
            r"\$\.ray_maps\[0\]\.claimed: has 3 bytes, not 4",
        ),
        (
            lambda d: d["ray_windows"][0].update(width=0),
            r"\$\.ray_windows\[0\]\.width: 0 by 2 is no picture",
        ),
        (lambda d: d["ray_cases"][0].update(truth="inside"), r"\$\.ray_cases\[0\]"),
    ],
)
def test_rays_that_do_not_fit_are_refused(
    small_run: Path, spoil: Callable[[dict[str, Any]], Any], said: str
) -> None:
    add_rays(small_run, spoil)
    with pytest.raises(LoadError, match=said):
        load_run(small_run)
