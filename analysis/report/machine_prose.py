"""The machine and the build, as rows of names and values, and how long measuring took."""

from __future__ import annotations

from typing import Any

from analysis.read.run import Build, Machine, SweepTimes
from analysis.report.wording import counted, duration, listed, size_in_bytes

_TIMED = ("speed", "limits")  # what the names of shards that run alone begin with


def machine_rows(machine: Machine) -> list[tuple[str, str]]:
    yes = {True: "yes", False: "no", None: "not told"}
    virtual = "yes" if machine.virtual else "no"
    if machine.hypervisor:
        virtual += f" ({machine.hypervisor})"
    caches = listed(
        [
            f"L{c.level} {c.type.lower()} {size_in_bytes(c.bytes)}"
            + (f" for {c.shared_by} threads" if c.shared_by > 1 else "")
            for c in machine.caches
        ]
    )
    return [
        ("CPU", machine.name),
        ("It identifies itself as", machine.identity or "not told"),
        ("Microcode", machine.microcode or "not told"),
        ("Cores and threads", f"{machine.cores} and {machine.threads}"),
        ("Simultaneous multithreading", yes[machine.smt]),
        ("Frequency governor", machine.governor or "not told"),
        ("Virtual machine", virtual),
        ("Caches", caches or "not told"),
        ("Memory", size_in_bytes(machine.memory_bytes)),
        ("Instruction sets that run here", listed(machine.isas)),
        ("Kernel", machine.kernel),
        ("System", machine.distribution),
        ("Compiler", machine.compiler),
        ("Libraries", listed([f"{name} {v}" for name, v in machine.libraries])),
        ("Revision", machine.revision + (", with changes" if machine.dirty else "")),
        ("Seed", str(machine.seed)),
    ]


def build_facts(built: Build | None) -> dict[str, Any] | None:
    """How long the program's build took, in phrases; None where nobody told."""
    if built is None or not built.compiled + built.from_cache:
        return None
    return {
        "took": duration(built.seconds),
        "files": counted(built.compiled + built.from_cache, "file"),
        "cached": built.from_cache,
    }


def times_facts(times: SweepTimes | None) -> dict[str, Any] | None:
    """How long the sweep took, in phrases; None where the run does not tell."""
    if times is None:
        return None
    alone = sum(taken for name, taken in times.shards if name.startswith(_TIMED))
    longest = times.shards[0] if times.shards else None
    return {
        "total": duration(times.seconds),
        "starts": times.starts,
        "starts_words": counted(times.starts, "start"),
        "shards": counted(len(times.shards), "shard"),
        "alone": duration(alone),
        "longest": longest and longest[0],
        "longest_took": longest and duration(longest[1]),
    }
