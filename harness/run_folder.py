"""A run's folder: whose it is, which shards belong there and which are done."""

from __future__ import annotations

import hashlib
import json
import re
import shlex
import subprocess
import tempfile
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from locks import Refusal


KINDS = ("limits", "speed", "accuracy", "maps", "operations", "instructions")
ALONE = ("limits", "speed")  # of the kinds, those that measure time


@dataclass(frozen=True)
class Shard:
    name: str
    kind: str  # one of KINDS, and the command that runs it
    arguments: tuple[str, ...]

    @property
    def alone(self) -> bool:
        """Whether no other shard may run beside it."""
        return self.kind in ALONE


def ask(pitbench: str, *arguments: str) -> str:
    """Output of a pitbench command that has to succeed."""
    try:
        done = subprocess.run(
            [pitbench, *arguments],
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
        )
    except OSError as error:
        raise Refusal(f"cannot run {pitbench}: {error.strerror}; build it") from error
    if done.returncode != 0:
        raise Refusal(
            f"{shlex.join([pitbench, *arguments])} ended with "
            f"{done.returncode}: {done.stderr.strip()}"
        )
    return done.stdout


def list_shards(pitbench: str, profile: str) -> list[Shard]:
    shards = []
    for line in ask(pitbench, "shards", "--profile", profile).splitlines():
        fields = line.split("\t")
        if (
            len(fields) != 3
            or fields[1] not in KINDS
            or not re.fullmatch(r"[\w.=:+-]+", fields[0])
        ):
            raise Refusal(f"pitbench shards printed a line not understood: {line!r}")
        shards.append(Shard(fields[0], fields[1], tuple(fields[2].split())))
    if not shards:
        raise Refusal(f"profile {profile} has no shards")
    return shards


def describe_machine(pitbench: str) -> dict[str, Any]:
    """What the program says of this machine and of its own build."""
    with tempfile.TemporaryDirectory(prefix="pitbench-") as folder:
        file = Path(folder, "machine.json")
        ask(pitbench, "machine", "--out", str(file))
        machine: dict[str, Any] = json.loads(file.read_text())
    return machine


def run_name(machine: dict[str, Any], profile: str, isa_up_to: str = "") -> str:
    revision = str(machine.get("revision", "unknown"))
    name = "worktree" if revision == "unknown" else revision[:8]
    name += "-dirty" if machine.get("dirty") else ""
    return f"{profile}-{name}" + (f"-{isa_up_to}" if isa_up_to else "")


def write_whole(path: Path, text: str) -> None:
    temporary = path.with_name(path.name + ".tmp")
    temporary.write_text(text)
    temporary.replace(path)


def began_with(out: Path) -> tuple[dict[str, Any], dict[str, Any]] | None:
    """machine.json and sweep.json of a folder that was begun, else None."""
    files = [out / "machine.json", out / "sweep.json"]
    if not all(file.exists() for file in files):
        if any(any(out.glob(f"{kind}*.json")) for kind in KINDS):
            raise Refusal(
                f"{out} holds results but not both of machine.json and sweep.json, "
                "so where they come from is unknown: give another folder"
            )
        return None
    try:
        machine, sweep = (json.loads(file.read_text()) for file in files)
        return machine, sweep
    except ValueError as error:
        raise Refusal(f"{files} do not read ({error}): delete {out}") from error


def prepare(
    pitbench: str,
    profile: str,
    out: Path,
    shards: list[Shard],
    isa_up_to: str = "",
) -> None:
    """Writes machine.json, methods.json and sweep.json, or checks that the
    folder was begun by this program, on this CPU, for this profile."""
    machine = describe_machine(pitbench)
    sweep: dict[str, Any] = {
        "schema": "pitbench-sweep-1",
        "profile": profile,
        "program_sha256": hashlib.sha256(Path(pitbench).read_bytes()).hexdigest(),
        "shards": [shard.name for shard in shards],  # what makes it complete
    }
    if isa_up_to:
        sweep["isa_up_to"] = isa_up_to
    begun = began_with(out)
    if begun is None:
        write_whole(out / "machine.json", json.dumps(machine, indent=1) + "\n")
        write_whole(out / "sweep.json", json.dumps(sweep, indent=1) + "\n")
    else:
        old_machine, old_sweep = begun
        for what, old, new in (
            ("revision", old_machine.get("revision"), machine.get("revision")),
            ("dirty", old_machine.get("dirty"), machine.get("dirty")),
            ("CPU", cpu_model(old_machine), cpu_model(machine)),
            ("profile", old_sweep.get("profile"), profile),
            ("--isa-up-to", old_sweep.get("isa_up_to", "none"), isa_up_to or "none"),
            ("program", fingerprint(machine, old_sweep), fingerprint(machine, sweep)),
        ):
            if old != new:
                raise Refusal(
                    f"{out} was begun with {what} {old}, and this is {what} {new}. "
                    "Results of the two do not mix: give another folder, or "
                    f"delete {out}, or go back to {what} {old}"
                )
    if not (out / "methods.json").exists():
        write_whole(out / "methods.json", ask(pitbench, "list", "--json"))


def cpu_model(machine: dict[str, Any]) -> str:
    return str(machine.get("cpu", {}).get("model"))


def fingerprint(machine: dict[str, Any], sweep: dict[str, Any]) -> str:
    """Tells programs apart that a revision does not; a clean one names its own."""
    if machine.get("dirty") or machine.get("revision") == "unknown":
        return str(sweep.get("program_sha256"))[:12]
    return ""


def result(out: Path, shard: Shard) -> Path:
    return out / f"{shard.name}.json"


def is_done(out: Path, shard: Shard) -> bool:
    """An empty file is what a power cut can leave of a rename: not done."""
    file = result(out, shard)
    return file.exists() and file.stat().st_size > 0


def remove_temporaries(out: Path, shard: str = "") -> None:
    """Removes what a killed shard, or any (""), left; needs its lock."""
    for file in out.glob(f"{shard}.json*.tmp*" if shard else "*.tmp*"):
        file.unlink(missing_ok=True)
