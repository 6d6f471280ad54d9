"""python3 -m analysis: from the files of a run to its report.

Exit codes: 0 done, 1 a regression was found where that was asked, 2 the input
or the call was wrong.
"""

from __future__ import annotations

import argparse
import dataclasses
import sys
from pathlib import Path

from analysis.choice import choose_command
from analysis.choice.choose_scene import SceneError
from analysis.cpus import cpus_command
from analysis.cpus.stored_run import RUNS, is_stored, load_stored, stored_runs
from analysis.read.load import LoadError, load_run
from analysis.read.run import Run
from analysis.report.page import write_page
from analysis.report.paper import paper
from analysis.report.readme import BEGIN, read_readme, write_readme
from analysis.report.report import build
from analysis.report.report_data import beside
from analysis.speed.cost_exhibits import with_models

ROOT = Path(__file__).resolve().parent.parent

EXAMPLES = """examples:
  python3 -m analysis report results/quick
  python3 -m analysis report results/quick --out /tmp/report
  python3 -m analysis readme results/quick
  python3 -m analysis choose --scalar f32 --coordinates 0 1 --altitude 0.01
  python3 -m analysis machines add results/full --anonymous
  python3 -m analysis compare amd-epyc-zen-4-full-1a2b3c4d results/full
"""


def main(arguments: list[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    try:
        if options.command in ("machines", "compare"):
            return cpus_command.run(options)
        if options.command == "choose":
            return choose_command.run(options)
        run_folder: Path = options.run
        if options.command == "report":
            report = build(_loaded(run_folder), stored_runs(options.runs))
            # Where runs are kept there is no place for pages.
            place = ROOT / "results" / run_folder.resolve().name
            within = place if is_stored(run_folder) else run_folder
            out = options.out or within / "report"
            data = beside(report.run, run_folder, out)
            if not options.no_pdf:
                data = dataclasses.replace(data, pdf=paper(report, data))
            written = write_page(report, out, data)
        else:
            read_readme(options.readme)  # a refusal comes before the long work
            report = build(_loaded(run_folder))
            written = write_readme(report, options.readme)
    except (LoadError, SceneError) as error:
        print(f"analysis: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"analysis: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    print(written)
    return 0


def _loaded(folder: Path) -> Run:
    if is_stored(folder):
        return load_stored(folder)
    return with_models(load_run(folder))


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="python3 -m analysis",
        description="Tables, charts and report from the files of a run.",
        epilog=EXAMPLES,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    report = commands.add_parser(
        "report", help="write the page, its tables and its charts"
    )
    report.add_argument("run", type=Path, metavar="RUN_DIR", help="results/<run>/")
    report.add_argument(
        "--out", type=Path, metavar="DIR", help="where to write; default RUN_DIR/report"
    )
    report.add_argument(
        "--runs",
        type=Path,
        metavar="DIR",
        default=RUNS,
        help="where the runs to compare CPUs with are kept; default report/runs/",
    )
    report.add_argument(
        "--no-pdf", action="store_true", help="the page alone, without report.pdf"
    )
    choose_command.add_parser(commands)
    cpus_command.add_parsers(commands)
    readme = commands.add_parser(
        "readme", help="rewrite the measured part of README.md"
    )
    readme.add_argument("run", type=Path, metavar="RUN_DIR", help="results/<run>/")
    readme.add_argument(
        "--readme",
        type=Path,
        metavar="FILE",
        default=ROOT / "README.md",
        help=f"the file with the line {BEGIN}; default: the repository's README.md",
    )
    return parser


if __name__ == "__main__":
    sys.exit(main())
