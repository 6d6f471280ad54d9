"""python3 -m analysis: from the files of a run to its report.

Exit codes: 0 done, 2 the input or the call was wrong.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from analysis.load import LoadError, load_run
from analysis.page import write_page
from analysis.readme import BEGIN, write_readme
from analysis.report import build

ROOT = Path(__file__).resolve().parent.parent

EXAMPLES = """examples:
  python3 -m analysis report results/quick
  python3 -m analysis report results/quick --out /tmp/report
  python3 -m analysis readme results/quick
"""


def main(arguments: list[str] | None = None) -> int:
    options = _parser().parse_args(arguments)
    run_folder: Path = options.run
    try:
        report = build(load_run(run_folder))
        if options.command == "report":
            written = write_page(report, options.out or run_folder / "report")
        else:
            written = write_readme(report, options.readme)
    except LoadError as error:
        print(f"analysis: {error}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"analysis: {error.filename}: {error.strerror}", file=sys.stderr)
        return 2
    print(written)
    return 0


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
