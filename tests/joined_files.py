"""Joins the C++ files of a folder, so that a tool reads their headers once.

usage: joined_files.py OUT < paths of files, one a line, from the root

Writes to OUT a file a folder that includes its files, and compile_commands.json
with how to compile each, from build/compile_commands.json. Prints the files,
those of most lines first. Where files of a folder are compiled differently, the
command that is longest is taken; files that Highway compiles once for each ISA
include themselves, and stay alone.
"""

from __future__ import annotations

import collections
import json
import shlex
import sys
from pathlib import Path

SELF_INCLUDING = "HWY_TARGET_INCLUDE"


def main() -> None:
    out = Path(sys.argv[1]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    commands = {
        Path(entry["file"]): entry
        for entry in json.loads(Path("build/compile_commands.json").read_text())
    }
    groups: dict[Path, list[Path]] = collections.defaultdict(list)
    for line in sys.stdin:
        file = Path(line.strip()).resolve()
        alone = SELF_INCLUDING in file.read_text()
        groups[file if alone else file.parent].append(file)
    joined = []
    for place, files in groups.items():
        name = "_".join(place.relative_to(Path.cwd()).with_suffix("").parts)
        path = out / f"{name}.cc"
        path.write_text(
            "".join(
                f'#include "{file}"  // NOLINT(bugprone-suspicious-include)\n'
                for file in files
            )
        )
        entry = max((commands[file] for file in files), key=lambda e: len(e["command"]))
        words = [
            str(path) if word == entry["file"] else word
            for word in shlex.split(entry["command"])
        ]
        lines = sum(file.read_text().count("\n") for file in files)
        command = {**entry, "command": shlex.join(words), "file": str(path)}
        joined.append((lines, path, command))
    joined.sort(key=lambda group: -group[0])
    (out / "compile_commands.json").write_text(
        json.dumps([command for _, _, command in joined])
    )
    for _, path, _ in joined:
        print(path)


if __name__ == "__main__":
    main()
