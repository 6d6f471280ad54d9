"""Which runs are fit to be compared by others, and how they are kept.

`add` refuses a run with the list of all that is wrong with it, each with what
to do, before it writes anything.
"""

from __future__ import annotations

import dataclasses
import getpass
import json
import re
import socket
from pathlib import Path
from typing import Any, Final

from analysis.cpus.stored_run import (
    COPIED,
    MEASURED,
    fingerprint,
    is_stored,
    load_stored,
    measured,
    write_packed,
)
from analysis.read.load import load_run
from analysis.read.read_json import LoadError
from analysis.read.run import Run
from analysis.report.whole_file import write_whole
from analysis.speed.cost_exhibits import with_models
from analysis.trust import noise

_NAME: Final = re.compile(r"[a-z0-9][a-z0-9._-]{0,79}\Z")
# A path of two parts or more that nothing stands before: what a file system
# of somebody's looks like, and neither a cell nor a source file of ours.
_PATH: Final = re.compile(
    r"(?:^|[\s=:,;\"'(])(/[\w.+~-]+(?:/[\w.+~-]*)+|[A-Za-z]:\\\S*)"
)


class Unfit(LoadError):
    """The run cannot be kept; the message lists why, and what to do."""


@dataclasses.dataclass(frozen=True)
class Wanted:
    """How a run is to be kept."""

    anonymous: bool = False
    label: str = ""
    name: str = ""
    noisy: bool = False  # whether a noisy run is taken


def add(folder: Path, runs: Path, wanted: Wanted = Wanted()) -> Path:
    """Keeps the run in `folder` in `runs` and returns its new folder. Raises
    Unfit, or LoadError for files that do not fit their schemas.
    """
    if is_stored(folder):
        raise Unfit(f"{folder} is a stored run already; give the results/NAME of one")
    run = load_run(folder)
    troubles = unfit(folder, run, wanted.noisy)
    name = wanted.name or default_name(run)
    if not _NAME.match(name):
        troubles.append(
            f"--name {name}: letters in lower case, digits, '.', '_' and '-' only"
        )
    kept = runs / name
    if kept.exists() and not _same(kept, run):
        troubles.append(f"{kept} holds another run: give a --name of its own")
    copies = {
        COPIED[source]: json.loads((folder / source).read_text(encoding="utf-8"))
        for source in COPIED
        if (folder / source).exists()
    }
    if wanted.anonymous:
        copies["machine.json"] = anonymous(copies["machine.json"])
    document = measured(with_models(run), wanted.label.strip(), wanted.anonymous)
    names = _names_here() if wanted.anonymous else []
    told = {**copies, MEASURED: document}
    for file, content in told.items():
        troubles += [
            f"{file}: {field}: “{text}” tells {what}; take it out of the run's "
            "files, or build in another place"
            for field, text, what in private(content, names)
        ]
    if troubles:
        lines = "".join(f"\n  - {trouble}" for trouble in troubles)
        raise Unfit(f"{folder} was not added:{lines}")
    for file, content in copies.items():
        if file.endswith(".gz"):
            write_packed(kept / file, content)
        else:
            text = json.dumps(content, indent=1, ensure_ascii=False, sort_keys=True)
            write_whole(kept / file, (text + "\n").encode())
    write_packed(kept / MEASURED, document)  # last: with it the run is there
    return kept


def unfit(folder: Path, run: Run, noisy: bool = False) -> list[str]:
    """What is wrong with the run, and what to do about it; empty if nothing."""
    found = []
    if run.profile in ("tiny", "custom"):
        found.append(
            f"profile {run.profile} is a trial: measure with --profile full (or quick)"
        )
    if run.machine.dirty:
        found.append(
            "it was built from sources with changes, so its revision does not give "
            "it again: commit (or undo) them, build and measure anew"
        )
    if run.machine.revision == "unknown":
        found.append("its revision is unknown: build in a clone with git installed")
    found += [
        f"{path.name.removesuffix('.json.failed')} failed: run the sweep again, which "
        "goes on there, and look at what it says"
        for path in sorted(folder.glob("*.json.failed"))
    ]
    missing = [name for name in expected(folder) if not (folder / name).exists()]
    if missing:
        found.append(
            f"it is not complete, {', '.join(missing)} is missing: run "
            "./reproduce report again, which goes on where it stopped"
        )
    judged = noise.judge(run.speed, run.shards)
    if judged.word != "quiet" and not noisy:
        reasons = [f"{r.shard}: {r.text}" for r in judged.reasons]
        shown = "".join(f"\n      {text}" for text in reasons[:5])
        more = f"\n      and {len(reasons) - 5} more" if len(reasons) > 5 else ""
        found.append(
            f"its noise verdict is “{judged.word}”: measure again with nothing else "
            "running (README, Trust), or give --noisy to keep it, marked as noisy"
            + shown
            + more
        )
    return found


def expected(folder: Path) -> list[str]:
    """The files of a complete run; its shards as sweep.json lists them."""
    files = ["sweep.json", "methods.json", "limits.json", "operations.json"]
    sweep = folder / "sweep.json"
    if sweep.exists():
        names = json.loads(sweep.read_text(encoding="utf-8")).get("shards", [])
        files += [f"{name}.json" for name in names if name != "maps"]
    return list(dict.fromkeys(files))


def anonymous(machine: dict[str, Any]) -> dict[str, Any]:
    """machine.json without what a site may have named itself: the vendor of
    the virtual machine and the build of the system's kernel, of which the first
    two numbers stay.
    """
    release = re.match(r"\w+ \d+\.\d+", machine["os"]["kernel"])
    return {
        **machine,
        "cpu": {**machine["cpu"], "hypervisor": None},
        "os": {**machine["os"], "kernel": release.group(0) if release else "not told"},
    }


def private(
    document: Any, names: list[str], field: str = "$"
) -> list[tuple[str, str, str]]:
    """(field, text, what it tells) of each string in which there is a path, or
    one of `names`.
    """
    if isinstance(document, dict):
        found = []
        for key, value in document.items():
            found += private(key, names, f"{field}.{key}")
            # A pattern of cells has slashes that are of no file.
            if key != "filter":
                found += private(value, names, f"{field}.{key}")
        return found
    if isinstance(document, list):
        return [
            entry
            for index, value in enumerate(document)
            for entry in private(value, names, f"{field}[{index}]")
        ]
    if not isinstance(document, str):
        return []
    path = _PATH.search(document)
    found = [(field, path.group(1), "a path of a computer")] if path else []
    words = set(re.split(r"[^\w.-]+", document))
    return found + [
        (field, name, "a host or a user") for name in names if name in words
    ]


def _names_here() -> list[str]:
    """The names of this host and user, but for those that every machine has."""
    names = {socket.gethostname(), socket.getfqdn(), getpass.getuser()}
    return sorted(names - {"root", "localhost", "debian", ""})


def default_name(run: Run) -> str:
    words = re.sub(r"[^a-z0-9]+", "-", run.machine.name.lower()).strip("-")
    parts = [words[:48].strip("-"), run.profile, run.machine.revision[:8]]
    return "-".join(parts + [run.isa_up_to] * bool(run.isa_up_to))


def _same(kept: Path, run: Run) -> bool:
    try:
        return fingerprint(load_stored(kept)) == fingerprint(run)
    except LoadError:
        return False
