#!/usr/bin/python3
"""Stands in for build/pitbench: sleeps instead of measuring, and keeps a log.

FAKE_STATE names a folder with plan.json: {"revision", "dirty", "cpu",
"seconds": {shard: s}, "held": [shard], "fail": [shard], "shards": [[name,
kind]]}. Every shard appends "start|end NAME TIME" lines to log.txt there; one
that is held goes on when a file `released` is there.
"""

import json
import os
import sys
import time
from pathlib import Path

state = Path(os.environ["FAKE_STATE"])
plan = json.loads((state / "plan.json").read_text())


def note(event: str, name: str) -> None:
    with open(state / "log.txt", "a") as log:
        log.write(f"{event} {name} {time.monotonic()}\n")


def write_whole(path: str, content: object) -> None:
    Path(path + ".tmp").write_text(json.dumps(content))
    os.replace(path + ".tmp", path)


def main() -> int:
    command = sys.argv[1]
    if command == "shards":
        for name, kind in plan["shards"]:
            print(f"{name}\t{kind}\t--profile {sys.argv[3]} --filter ^{name}/")
        return 0
    if command == "list":
        print('{"methods": []}')
        return 0
    out = sys.argv[sys.argv.index("--out") + 1]
    if command == "machine":
        facts = {key: plan[key] for key in ("revision", "dirty")}
        write_whole(out, {**facts, "cpu": {"model": plan["cpu"]}})
        return 0
    name = Path(out).stem
    note("start", name)
    Path(out + ".tmp").write_text("half a resu")
    time.sleep(plan["seconds"].get(name, 0.05))
    while name in plan["held"] and not (state / "released").exists():
        time.sleep(0.01)
    if name in plan["fail"]:
        print(f"{name}: the answers are wrong", file=sys.stderr)
        return 1
    write_whole(out, {"arguments": sys.argv[1:]})
    note("end", name)
    return 0


sys.exit(main())
