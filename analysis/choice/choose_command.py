"""The command choose of python3 -m analysis."""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any, Final

from analysis.choice.choose import Choice, choose
from analysis.choice.choose_scene import NEEDS, SCALARS, Described, SceneError, checked
from analysis.choice.choose_text import document, lines
from analysis.cpus.stored_run import RUNS, is_stored, open_run, stored_names
from analysis.peers.peers_tables import part
from analysis.read.read_json import LoadError
from analysis.read.run import Run
from analysis.speed.tables import samples, speed_cells
from analysis.trust.placement import usual_spread

RESULTS: Final = RUNS.parent.parent / "results"

EXAMPLES = """examples:
  python3 -m analysis choose --scalar f32 --coordinates 0 1920 --altitude 2 \\
      --points-per-triangle 4096 --hit-rate 0.5 --need class --tolerance 0.01
  python3 -m analysis choose results/quick --scalar u8 --coordinates 0 79 \\
      --altitude 0 --grid 80 50 --need exact

Right means proved, not measured: a method qualifies if its error bound on such
coordinates is within --tolerance, the distance from an edge within which either
answer will do. By default that is 0, and only exact methods qualify, or those
that are exact on such coordinates.
"""


def add_parser(commands: Any) -> None:
    parser = commands.add_parser(
        "choose",
        help="which method to take for a scene",
        description="The cheapest method that is right for a scene, with its "
        "guarantee and what it was measured to take.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument(
        "run",
        nargs="?",
        metavar="RUN",
        help="a folder, or a name in results/ or report/runs/; default: the newest in "
        "results/, else in report/runs/",
    )
    parser.add_argument("--scalar", required=True, help=f"one of {', '.join(SCALARS)}")
    parser.add_argument(
        "--coordinates",
        required=True,
        nargs=2,
        type=float,
        metavar=("LOW", "HIGH"),
        help="all coordinates, of triangles and of points, lie between",
    )
    parser.add_argument(
        "--altitude", type=float, metavar="H", help="no triangle has a smaller one"
    )
    parser.add_argument(
        "--aspect",
        type=float,
        metavar="A",
        help="or: no triangle has a larger ratio of longest edge to smallest altitude",
    )
    parser.add_argument(
        "--edge",
        type=float,
        nargs="+",
        metavar="L",
        help="longest edge of the triangles, or that of the smallest and of the "
        "largest one; default: HIGH - LOW, and the diagonal",
    )
    parser.add_argument(
        "--points-per-triangle",
        dest="points",
        type=float,
        default=4096.0,
        metavar="N",
        help="below 1: a point is asked about by many triangles; default 4096",
    )
    parser.add_argument(
        "--hit-rate",
        dest="hit",
        type=float,
        default=0.5,
        metavar="P",
        help="share of the points that are inside; default 0.5",
    )
    parser.add_argument(
        "--grid",
        nargs="+",
        default=["free"],
        metavar="W H",
        help="the points are the pixels of a grid; or: free (default)",
    )
    parser.add_argument(
        "--need", default="class", help=f"one of {', '.join(NEEDS)}; default class"
    )
    parser.add_argument(
        "--precision",
        type=float,
        default=0.0,
        metavar="STEP",
        help="all coordinates are whole multiples of it, 1 for whole numbers",
    )
    parser.add_argument(
        "--tolerance",
        type=float,
        default=0.0,
        metavar="D",
        help="distance from an edge within which either answer will do; default 0",
    )
    parser.add_argument("--isa", help="take this one; default: the fastest of the run")
    parser.add_argument("--json", action="store_true", help="the answer as JSON")
    parser.add_argument(
        "--runs", type=Path, metavar="DIR", default=RUNS, help="not report/runs/"
    )
    parser.add_argument(
        "--results", type=Path, metavar="DIR", default=RESULTS, help="not results/"
    )


def run(options: argparse.Namespace) -> int:
    """The exit code. Raises LoadError and SceneError."""
    given = described(options)
    scene = checked(given)
    found = found_run(options.run, options.results, options.runs)
    choose_there = chooser(found, options.isa)
    choice = choose_there(given)
    assert choice.scene == scene
    if options.json:
        answer = document(choice, found.name, given.command)
        print(json.dumps(answer, indent=2, ensure_ascii=False))
    else:
        print("\n".join(lines(choice)))
        print(f"  run        {found.name} on {found.machine.name}")
    return 0


def described(options: argparse.Namespace) -> Described:
    return Described(
        scalar=options.scalar,
        coordinates=(options.coordinates[0], options.coordinates[1]),
        altitude=options.altitude,
        aspect=options.aspect,
        edge=None if options.edge is None else tuple(options.edge),
        points=options.points,
        hit=options.hit,
        grid=_grid(options.grid),
        need=options.need,
        precision=options.precision,
        tolerance=options.tolerance,
    )


def _grid(words: list[str]) -> tuple[int, int] | None:
    if words == ["free"]:
        return None
    if len(words) != 2 or not all(word.isdecimal() for word in words):
        raise SceneError(
            f"--grid {' '.join(words)}: give columns and rows, as in --grid 80 50, or "
            "free"
        )
    return (int(words[0]), int(words[1]))


def chooser(whole: Run, isa: str | None = None) -> Callable[[Described], Choice]:
    """What chooses from a run, whose tables are made once. Raises LoadError if
    the run has no row of the ISA.
    """
    ours = part(whole).ours
    if isa is not None and isa not in set(ours.speed["isa"]):
        known = ", ".join(sorted(set(ours.speed["isa"])))
        raise LoadError(f"--isa {isa}: run {whole.name} has rows of {known} only")
    by_cell, cells = samples(ours.speed), speed_cells(ours.speed)
    alike = usual_spread(ours.speed)

    def choose_there(given: Described) -> Choice:
        scene = checked(given)
        return choose(scene, by_cell, cells, ours.accuracy, ours.methods, isa, alike)

    return choose_there


def found_run(text: str | None, results: Path, runs: Path) -> Run:
    """The run that is named, or the newest one. Raises LoadError."""
    if text is not None:
        there = results / text
        return open_run(str(there) if there.is_dir() else text, runs)
    folders = [path.parent for path in results.glob("*/machine.json")]
    folders.sort(key=lambda folder: (folder / "machine.json").stat().st_mtime)
    last: LoadError | None = None
    for folder in reversed(folders):
        try:
            return open_run(str(folder), runs)
        except LoadError as error:  # e.g. a sweep that has not ended
            last = last or error
    kept = [runs / name for name in stored_names(runs) if is_stored(runs / name)]
    if kept:
        kept.sort(key=lambda folder: folder.stat().st_mtime)
        return open_run(str(kept[-1]), runs)
    if last is not None:
        raise last
    raise LoadError(
        f"no run in {results} or {runs}: make one with ./reproduce report, or name one"
    )
