"""The machine and the build, as rows of names and values."""

from __future__ import annotations

from analysis.read.run import Machine
from analysis.report.wording import listed, size_in_bytes


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
