"""A run beside a busy process on its own core must be called noisy.

usage: busy_core.py PITBENCH FOLDER

Measures a few cells into FOLDER while another process takes what it can of the
CPU that pitbench pins itself to, and asks analysis for the verdict. Nothing
here is about how long anything takes: two processes that never wait share a
core, so pitbench cannot have had it for all of the time, however fast it is.
Exit code 1, and what was seen, if the verdict does not say so.
"""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from analysis.read.load import load_run  # noqa: E402
from analysis.trust.noise import judge  # noqa: E402

_BUSY = "print('running', flush=True)\nwhile True: pass"


@contextmanager
def busy(cpu: int) -> Iterator[None]:
    """While inside, a process that never waits runs on this CPU."""
    with subprocess.Popen(
        ["taskset", "-c", str(cpu), sys.executable, "-c", _BUSY],
        stdout=subprocess.PIPE,
    ) as process:
        assert process.stdout is not None
        process.stdout.readline()
        try:
            yield
        finally:
            process.kill()


def measure(pitbench: str, folder: Path) -> None:
    """A small run: as much as analysis needs to load it."""

    def call(command: str, *arguments: str, out: str) -> None:
        subprocess.run(
            [pitbench, command, *arguments, "--out", str(folder / out)],
            check=True,
            stderr=subprocess.DEVNULL,
        )

    tiny = ("--profile", "tiny", "--filter")
    call("machine", out="machine.json")
    call(
        "accuracy", *tiny, "near_edge:ulps=1/cross_product/f32/", out="accuracy-a.json"
    )
    # pitbench takes the last CPU that it may use.
    with busy(max(os.sched_getaffinity(0))):
        call("speed", *tiny, "^one_triangle/uniform.*/f32/", out="speed-a.json")


def main(pitbench: str, folder: Path) -> int:
    folder.mkdir(parents=True)
    measure(pitbench, folder)
    run = load_run(folder)
    verdict = judge(run.speed, run.shards)
    shard = run.shards[0]
    print(f"{verdict.word}: {shard.cpu_seconds:.2f} of {shard.wall_seconds:.2f} s")
    for reason in verdict.reasons:
        print(f"{reason.shard}: {reason.text}")
    said = any("ran on the same core" in reason.text for reason in verdict.reasons)
    return 0 if verdict.noisy and said else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], Path(sys.argv[2])))
