"""A sweep over a fake pitbench, in a folder of its own."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

HERE = Path(__file__).resolve().parent
SWEEP = HERE.parents[1] / "harness" / "sweep.py"
SHARDS = [
    ["speed-a", "speed"],
    ["accuracy-a", "accuracy"],
    ["speed-b", "speed"],
    ["accuracy-b", "accuracy"],
    ["accuracy-c", "accuracy"],
    ["maps", "maps"],
]


class FakeSweep:
    def __init__(self, folder: Path) -> None:
        self.folder, self.out = folder, folder / "results" / "run"
        self.children: list[subprocess.Popen[str]] = []
        self.plan: dict[str, Any] = {
            "revision": "0123456789abcdef",
            "dirty": False,
            "cpu": "Fake CPU",
            "seconds": {},
            "held": [],
            "fail": [],
            "shards": SHARDS,
        }

    def start(self, *arguments: str, out: Path | None = None) -> subprocess.Popen[str]:
        (self.folder / "plan.json").write_text(json.dumps(self.plan))
        command = ["/usr/bin/python3", str(SWEEP), "--profile", "tiny"]
        command += ["--pitbench", str(HERE / "fake_pitbench.py")]
        if "--print-run-name" not in arguments:
            command += ["--out", str(out or self.out)]
        child = subprocess.Popen(
            [*command, *arguments],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            start_new_session=True,
            env={
                **os.environ,
                "FAKE_STATE": str(self.folder),
                "PITBENCH_TIMING_LOCK": str(self.folder / "timing.lock"),
            },
        )
        self.children.append(child)
        return child

    def run(self, *arguments: str, out: Path | None = None) -> tuple[int, str, str]:
        """Exit code, stdout and stderr of a sweep run to its end."""
        child = self.start(*arguments, out=out)
        output, errors = child.communicate(timeout=60)
        return child.returncode, output, errors

    def release(self) -> None:
        """Lets shards that the plan holds go on."""
        (self.folder / "released").write_text("")

    def log(self) -> list[tuple[str, str, float]]:
        file = self.folder / "log.txt"
        lines = file.read_text().splitlines() if file.exists() else []
        return [(e, n, float(t)) for e, n, t in (line.split() for line in lines)]

    def started(self) -> list[str]:
        return [name for event, name, _ in self.log() if event == "start"]

    def wait_for(self, event: str, name: str) -> None:
        self.wait_until(lambda: (event, name) in [e[:2] for e in self.log()])

    def wait_until(self, condition: Callable[[], bool]) -> None:
        until = time.monotonic() + 20
        while not condition():
            assert time.monotonic() < until, "waited too long"
            time.sleep(0.01)

    def results(self) -> list[str]:
        files = {*self.out.glob("*-*.json"), *self.out.glob("maps.json")}
        return sorted(file.name for file in files)

    def leftovers(self) -> list[str]:
        return sorted(file.name for file in self.out.glob("*.tmp*"))

    def end_all(self) -> None:
        for child in self.children:
            if child.poll() is None:
                os.killpg(child.pid, signal.SIGKILL)
            child.communicate()
