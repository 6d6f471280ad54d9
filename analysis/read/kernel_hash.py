"""Which kernels a run measured: the hash of their sources.

A revision changes with every commit; the kernels' times and answers change
only with the kernels, and not with what is said of them. harness/build_info.cmake
puts the same hash into what is built, and so into machine.json.
"""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

_SUFFIXES = (".cc", ".h", ".inc")
_COMMENTS = re.compile(rb"[ \t]*//[^\n]*")
_CMAKE_COMMENTS = re.compile(rb"\n[ \t]*#[^\n]*")


def kernel_hash(root: Path) -> str:
    """SHA-256 over the lines "PATH SHA-256" of the kernels' sources below
    `root`, by path, without comments and empty lines; empty if there are none.
    """
    files = {
        path.relative_to(root).as_posix(): path
        for path in (root / "kernels").rglob("*")
        if path.suffix in _SUFFIXES or path.name == "CMakeLists.txt"
    }
    lines = [
        f"{name} {hashlib.sha256(_code(files[name])).hexdigest()}\n"
        for name in sorted(files)
    ]
    return hashlib.sha256("".join(lines).encode()).hexdigest() if lines else ""


def _code(path: Path) -> bytes:
    text = path.read_bytes()
    if path.name == "CMakeLists.txt":
        text = _CMAKE_COMMENTS.sub(b"", b"\n" + text)
    else:
        text = _COMMENTS.sub(b"", text)
    return re.sub(rb"\n+", b"\n", text).strip(b" \t\r\n")
