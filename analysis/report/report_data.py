"""The data beside a report: the run in the form in which runs are kept, small
enough to go with the page, and links to the whole files where they lie above it.
"""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Mapping
from pathlib import Path

from analysis.cpus.run_labels import label_of
from analysis.cpus.stored_run import COPIED, MEASURED, is_stored, measured, packed
from analysis.read.run import Run


@dataclasses.dataclass(frozen=True)
class Beside:
    """What lies beside a page besides its tables and charts. files: path →
    content; raw: paths of the run's own files, seen from the page.
    """

    pdf: bytes | None = None
    files: Mapping[str, bytes] = dataclasses.field(default_factory=dict)
    raw: tuple[str, ...] = ()


def beside(run: Run, source: Path, out: Path) -> Beside:
    """For the page in `out` of the run that was loaded from `source`."""
    within = out.resolve().parent == source.resolve()
    whole = sorted(source.glob("*.json")) if within else []
    raw = tuple(f"../{path.name}" for path in whole)
    return Beside(files=kept(run, source), raw=raw)


def kept(run: Run, source: Path) -> dict[str, bytes]:
    """The run's files as `machines add` keeps them (stored_run.py), below data/.
    Of a run that is kept already they are its own.
    """
    if is_stored(source):
        names = [*COPIED.values(), MEASURED]
        return {
            f"data/{name}": (source / name).read_bytes()
            for name in names
            if (source / name).exists()
        }
    files = {}
    for name, kept_as in COPIED.items():
        if (source / name).exists():
            content = (source / name).read_bytes()
            if kept_as.endswith(".gz"):
                content = packed(json.loads(content))
            files[f"data/{kept_as}"] = content
    files[f"data/{MEASURED}"] = packed(measured(run, label_of(run), False))
    return files
