"""The command line of sweep.py."""

from __future__ import annotations

import argparse
from pathlib import Path


def parse_arguments(arguments: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        description="Run the shards of a profile whose results are missing."
    )
    parser.add_argument("--pitbench", default="build/pitbench", metavar="PROGRAM")
    parser.add_argument("--profile", default="quick", help="tiny, quick or full")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--out", type=Path, metavar="FOLDER", help="results/NAME")
    what.add_argument(
        "--print-run-name",
        action="store_true",
        help="only print a name for a run of this program's revision",
    )
    parser.add_argument(
        "--isa-up-to",
        default="",
        metavar="ISA",
        help="leave out the rows of wider instruction sets, e.g. avx2",
    )
    only = parser.add_mutually_exclusive_group()
    only.add_argument("--shard", metavar="NAME", help="run this shard only")
    only.add_argument(
        "--index", type=int, metavar="K", help="run the K-th shard only, from 0"
    )
    parser.add_argument(
        "--jobs",
        type=int,
        metavar="N",
        help="shards of accuracy and maps at once (by default, one a core)",
    )
    options = parser.parse_args(arguments)
    if options.jobs is not None and options.jobs < 1:
        parser.error("--jobs must be at least 1")
    return options
