"""Which kernels a run measured: the hash of their sources.

A revision changes with every commit; the kernels' times and answers change
only with the kernels. harness/build_info.cmake puts the same hash into what is
built, and so into machine.json.
"""

from __future__ import annotations

import hashlib
from pathlib import Path

_SUFFIXES = (".cc", ".h", ".inc")


def kernel_hash(root: Path) -> str:
    """SHA-256 over the lines "PATH SHA-256" of the kernels' sources below
    `root`, by path; empty if there are none.
    """
    files = {
        path.relative_to(root).as_posix(): path
        for path in (root / "kernels").rglob("*")
        if path.suffix in _SUFFIXES or path.name == "CMakeLists.txt"
    }
    lines = [
        f"{name} {hashlib.sha256(files[name].read_bytes()).hexdigest()}\n"
        for name in sorted(files)
    ]
    return hashlib.sha256("".join(lines).encode()).hexdigest() if lines else ""
