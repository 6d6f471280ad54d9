"""Other libraries in the chapter on rays: their rows, and what is said of them."""

from __future__ import annotations

import dataclasses
from typing import Any, Final

import pandas as pd

from analysis.rays.rays_tables import libraries_compared
from analysis.read.run import RayRun
from analysis.report.wording import listed, with_interval
from analysis.speed.tables import sort_cells

DIAMONDS: Final = (
    " Thin diamonds are calls into other libraries, which the frontier leaves out."
)
# What is timed of a call that looks triangles up; no number of a run.
CAPTION: Final = (
    " Rows on “library” are calls into other libraries. Embree is asked "
    "about a scene of one triangle; in one_ray about a scene of all triangles, in "
    "which it looks for the ray’s by an index (BVH), while all other rows look at "
    "every triangle; and pair by pair it is judged alone. Its scenes are built "
    "before the timing; handing over the rays is timed. The rays of this scene hit "
    "many triangles that lie one behind the other, which leaves an index little to "
    "skip. CGAL has no index here and is set up within the time."
)


@dataclasses.dataclass(frozen=True)
class RayPeers:
    """What the prose says of the libraries."""

    libraries: str
    fastest: str
    fastest_times: str  # over the branchless test of the same run
    leak_free: tuple[str, ...]
    leaking: tuple[str, ...]
    refused: tuple[tuple[str, str], ...]  # cell, reason


def table_of_libraries(
    rays: RayRun, libraries: RayRun, cells: pd.DataFrame, scalars: list[str]
) -> pd.DataFrame:
    """One row a call and scalar; as methods_compared has it for our methods."""
    tables = [libraries_compared(rays, libraries, cells, one) for one in scalars]
    joined = pd.concat([table for table in tables if len(table)] or tables[:1])
    return sort_cells(joined, ["method", "scalar"]) if len(joined) else joined


def words_of_libraries(
    table: pd.DataFrame, libraries: RayRun, versions: dict[str, str], scalar: str
) -> RayPeers | None:
    """None where nothing of a library was timed. `table`: table_of_libraries."""
    own = table[table["scalar"] == scalar] if len(table) else table
    if not len(own):
        return None
    best = own.loc[own["ns"].idxmin()]
    ratio = (best[f"times_base{end}"] for end in ("", "_low", "_high"))
    known = own.dropna(subset=["holes"])
    return RayPeers(
        libraries=listed(names(libraries, versions)),
        fastest=str(best["method"]),
        fastest_times=with_interval(*ratio),
        leak_free=tuple(known.loc[known["holes"] == 0, "method"]),
        leaking=tuple(known.loc[known["holes"] > 0, "method"]),
        refused=tuple(zip(libraries.refused["name"], libraries.refused["reason"])),
    )


def names(libraries: RayRun, versions: dict[str, str]) -> list[str]:
    """Each library with its version, in the order of its calls."""
    known = {m.key.partition("_")[0]: m.source for m in libraries.methods}
    return [f"{name} {versions.get(key, '')}".strip() for key, name in known.items()]


def sources(libraries: RayRun, versions: dict[str, str]) -> list[dict[str, Any]]:
    """What each call is, with the library's version."""
    rows = []
    for entry in libraries.methods:
        version = versions.get(entry.key.partition("_")[0], "")
        source = f"{entry.source} {version}".strip()
        rows.append({**dataclasses.asdict(entry), "source": source})
    return rows
