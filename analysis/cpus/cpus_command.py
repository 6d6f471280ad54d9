"""The commands machines and compare of python3 -m analysis."""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

from analysis.cpus import machines, run_labels
from analysis.cpus.compare import LEVEL, compare
from analysis.cpus.compare_text import lines
from analysis.cpus.stored_run import RUNS, open_run, stored_runs
from analysis.report.exhibits import csv_text
from analysis.report.whole_file import write_whole


def add_parsers(commands: Any) -> None:
    kept = commands.add_parser("machines", help="keep runs to compare CPUs with")
    actions = kept.add_subparsers(dest="action", required=True, metavar="ACTION")
    add = actions.add_parser(
        "add", help="check a run, make it small and keep it in report/runs/"
    )
    add.add_argument("run", type=Path, nargs="+", metavar="RUN_DIR")
    add.add_argument(
        "--anonymous",
        action="store_true",
        help="without the virtual machine's vendor and the system kernel's build; "
        "refuse what holds a path or the name of this host or user",
    )
    add.add_argument("--label", default="", metavar="TEXT", help="by default the CPU")
    add.add_argument(
        "--name", default="", help="of the folder; by default CPU, profile, revision"
    )
    add.add_argument(
        "--noisy", action="store_true", help="keep a noisy run too, marked as such"
    )
    listed = actions.add_parser("list", help="a table of the runs that are kept")
    differ = commands.add_parser(
        "compare",
        help="whether two runs differ by more than noise",
        description="Whether run B differs from run A by more than noise. Each is a "
        "folder, or a name in report/runs/. Exit codes: 0, or 1 with "
        "--fail-on-regression if B is slower somewhere or errs more, 2 wrong input.",
    )
    differ.add_argument("a", metavar="A")
    differ.add_argument("b", metavar="B")
    differ.add_argument(
        "--level",
        type=_share,
        default=LEVEL,
        help="the share of false claims allowed among all (default: %(default)s)",
    )
    differ.add_argument(
        "--fail-on-regression",
        action="store_true",
        help="end with 1 if a cell takes longer in B, or errs more on the same input",
    )
    differ.add_argument(
        "--across-revisions",
        action="store_true",
        help="compare runs of other kernel code as well",
    )
    differ.add_argument(
        "--csv", type=Path, metavar="FILE", help="write a row for every cell"
    )
    for parser in (add, listed, differ):
        parser.add_argument(
            "--runs", type=Path, metavar="DIR", default=RUNS, help="not report/runs/"
        )


def run(options: argparse.Namespace) -> int:
    """The exit code. Raises LoadError and OSError."""
    if options.command == "compare":
        return _compare(options)
    if options.action == "list":
        return _list(options.runs)
    if len(options.run) > 1 and (options.label or options.name):
        raise machines.Unfit("--label and --name are of one run: add runs one by one")
    wanted = machines.Wanted(
        options.anonymous, options.label, options.name, options.noisy
    )
    for folder in options.run:
        kept = machines.add(folder, options.runs, wanted)
        size = sum(file.stat().st_size for file in kept.iterdir()) / 1024
        print(f"{kept}: {size:.0f} KiB")
    return 0


def _list(runs: Path) -> int:
    found = stored_runs(runs)
    if not found:
        print(f"no run in {runs}; python3 -m analysis machines add results/NAME")
        return 0
    table = run_labels.table(found)
    table["clock_ghz"] = table["clock_ghz"].map("{:.2f}".format)
    print(table.to_string(index=False))
    return 0


def _compare(options: argparse.Namespace) -> int:
    a, b = (open_run(text, options.runs) for text in (options.a, options.b))
    found = compare(a, b, options.level, options.across_revisions)
    print("\n".join(lines(found)))
    if options.csv:
        write_whole(options.csv, csv_text(found.cells).encode())
    return 1 if options.fail_on_regression and found.worse else 0


def _share(text: str) -> float:
    value = float(text)
    if not 0 < value < 1:
        raise argparse.ArgumentTypeError(f"{text} is no share between 0 and 1")
    return value
