"""Rays and triangles in space: the methods side by side."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Final

import pandas as pd

from analysis.accuracy.accuracy_tables import error_rates
from analysis.charts.palette import LIBRARY
from analysis.rays.rays_leaks import sphere_rates
from analysis.read.cells import TUV_SUFFIX
from analysis.read.load_rays import RAY_LOOPS
from analysis.read.run import RayRun
from analysis.speed.tables import (
    reference_cells,
    sort_cells,
    speed_cells,
    times_other,
    widest_isa,
)

MAIN_LOOP: Final = "one_triangle_rays"
BASE: Final = "moller_trumbore"  # branchless, two-sided, without contraction
KEPT: Final = "baldwin_weber"
PER_MILLION: Final = 1e6


def against_base(speed: pd.DataFrame, cells: pd.DataFrame) -> pd.DataFrame:
    """`cells` with their time over that of BASE on the same scene and
    instruction set (`times_base`); rows without one are left out.
    """
    return times_other(
        speed,
        cells,
        "times_base",
        lambda cell: str(cell["name"]).replace(f"/{cell['method']}/", f"/{BASE}/"),
    )


def methods_compared(rays: RayRun, cells: pd.DataFrame, scalar: str) -> pd.DataFrame:
    """One row a method at the widest instruction set: its time a ray in each
    loop, over that of BASE, and how it errs: near edges (`error_rate`), on the
    closed surface (`holes`, `double_hits` beyond its rule, in a million rays), and in t, u and v
    where it hits (`t_worst`, `u_worst`, `v_worst`, in ulps, over all scenes).
    """
    main = reference_cells(cells, scalar, MAIN_LOOP)
    isa = widest_isa(main)
    main = against_base(rays.speed, main[main["isa"] == isa].reset_index(drop=True))
    return _described(rays, main, cells, scalar, isa)


def libraries_compared(
    rays: RayRun, libraries: RayRun, cells: pd.DataFrame, scalar: str
) -> pd.DataFrame:
    """The same of calls into other libraries: over the time of BASE on the
    widest instruction set of the kernels. `cells`: speed_cells of the kernels.
    """
    ours = reference_cells(cells, scalar, MAIN_LOOP)
    isa = widest_isa(ours)
    calls = without_tuv(speed_cells(libraries.speed))
    main = times_other(
        pd.concat([rays.speed, libraries.speed], ignore_index=True),
        reference_cells(calls, scalar, MAIN_LOOP),
        "times_base",
        lambda cell: str(cell["name"]).replace(
            f"/{cell['method']}/{scalar}/{LIBRARY}", f"/{BASE}/{scalar}/{isa}"
        ),
    )
    # What the boundary rule brings about is told by our exact methods.
    ruled = rays.accuracy[rays.accuracy["isa"] == isa].assign(isa=LIBRARY)
    judged = pd.concat([libraries.accuracy, ruled], ignore_index=True)
    others = dataclasses.replace(libraries, accuracy=judged)
    return _described(others, main, calls, scalar, LIBRARY)


def _described(
    rays: RayRun, main: pd.DataFrame, cells: pd.DataFrame, scalar: str, isa: str | None
) -> pd.DataFrame:
    judged = rays.accuracy
    judged = judged[(judged["scalar"] == scalar) & (judged["isa"] == isa)]
    near = error_rates(
        judged[(judged["family"] == "rays_near_edge") & (judged["loop"] == MAIN_LOOP)],
        ["method"],
    ).set_index("method")
    leaks = sphere_rates(rays.accuracy, scalar, str(isa)).set_index("method")
    tuv = rays.tuv[(rays.tuv["scalar"] == scalar) & (rays.tuv["isa"] == isa)]
    others: dict[str, pd.DataFrame] = {}
    for loop in RAY_LOOPS:
        if loop != MAIN_LOOP:
            frame = reference_cells(cells, scalar, loop)
            others[loop] = frame[frame["isa"] == isa].set_index("method")
    rows: list[dict[str, Any]] = []
    for row in main.to_dict("records"):
        method = row["method"]
        found: dict[str, Any] = dict(row)
        for loop, frame in others.items():
            found[f"{loop}_ns"] = (
                float(frame.loc[method, "ns"]) if method in frame.index else math.nan
            )
        for key in ("error_rate", "error_rate_low", "error_rate_high"):
            found[key] = near.loc[method, key] if method in near.index else math.nan
        for key, kind in (("holes", "hole"), ("double_hits", "double_hit")):
            rate = leaks.loc[method, kind] if method in leaks.index else math.nan
            found[key] = PER_MILLION * float(rate)
        errors = tuv[tuv["method"] == method]
        for name in "tuv":
            found[f"{name}_worst"] = (
                float(errors[f"{name}_largest_ulps"].max()) if len(errors) else math.nan
            )
        rows.append(found)
    extra = [f"{loop}_ns" for loop in others] + ["error_rate", "error_rate_low"]
    extra += [
        "error_rate_high",
        "holes",
        "double_hits",
        "t_worst",
        "u_worst",
        "v_worst",
    ]
    return sort_cells(
        pd.DataFrame(rows, columns=[*main.columns, *extra]), ["method", "isa"]
    )


def without_tuv(cells: pd.DataFrame) -> pd.DataFrame:
    return cells[~cells["loop"].str.endswith(TUV_SUFFIX)].reset_index(drop=True)
