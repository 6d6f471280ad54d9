"""How long a sweep took: times.json in its folder, over all starts.

Written whole after every shard, so a start that is killed loses no more than the
time since its last one. What it holds is only for reading: no run is refused for it,
and one that does not read is begun anew.
"""

from __future__ import annotations

import fcntl
import json
import time
from pathlib import Path
from typing import Any

from run_folder import write_whole

SCHEMA = "pitbench-times-1"


class SweepTimes:
    """The times of one start, added to those of the starts before it. Single shards
    of an array may run at once, each with one of these; a lock keeps them apart.
    """

    def __init__(self, out: Path) -> None:
        self._out = out
        self._added_until = time.monotonic()
        self._first = True

    def add(self, shard: str = "", seconds: float = 0.0) -> None:
        """Adds the time since the last call, and that of a shard that is done."""
        now = time.monotonic()
        with open(self._out / ".lock-times", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            document = self._read()
            document["starts"] += self._first
            document["seconds"] = round(
                document["seconds"] + now - self._added_until, 3
            )
            if shard:
                document["shards"][shard] = round(seconds, 3)
            text = json.dumps(document, indent=1, sort_keys=True) + "\n"
            write_whole(self._out / "times.json", text)
        self._first, self._added_until = False, now

    def _read(self) -> dict[str, Any]:
        nothing: dict[str, Any] = {
            "schema": SCHEMA,
            "starts": 0,
            "seconds": 0.0,
            "shards": {},
        }
        try:
            text = (self._out / "times.json").read_text()
            document: dict[str, Any] = json.loads(text)
            known = document["schema"] == SCHEMA and set(document) == set(nothing)
            return document if known else nothing
        except (OSError, ValueError, KeyError, TypeError):
            return nothing
