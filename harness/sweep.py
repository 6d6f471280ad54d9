#!/usr/bin/python3
"""Runs the shards of a profile into one folder; stopped, it goes on later.

One process a shard. The limits of the machine and the speed shards come first
and run alone; the others, of accuracy, of maps and of counts, then share the
cores. What keeps a result true:

* A shard's file is written whole by pitbench and renamed, so a shard whose
  file is there is done, and one that was killed left no file.
* One sweep at a time writes into a folder (a lock on `.lock`), and a timing
  shard never runs beside any shard of another sweep on the machine (a lock
  in /tmp: exclusive for those, shared for the others). Children hold the locks
  with their parent and die with it, so no orphan runs on unseen.
* A folder belongs to one profile, one revision, one CPU model and one limit on
  the instruction sets.

Exit codes: 0 done, 1 a shard failed, 2 wrong call, 130 interrupted.
"""

from __future__ import annotations

import argparse
import contextlib
import fcntl
import os
import resource
import select
import shlex
import signal
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass
from pathlib import Path
from types import FrameType
from typing import IO

from isas import restricted
from locks import Refusal, folder_lock, timing_lock
from options import parse_arguments
from rich.console import Console
from rich.progress import BarColumn, Progress, TextColumn, TimeElapsedColumn
from run_folder import (
    Shard,
    describe_machine,
    is_done,
    list_shards,
    prepare,
    remove_temporaries,
    result,
    run_name,
)
from sweep_times import SweepTimes
from time_left import time_left

STDERR_LINES = 12


class Interrupted(Exception):
    """SIGINT, SIGTERM or SIGHUP arrived. Exit code 130."""


@dataclass
class Child:
    shard: Shard
    command: list[str]
    process: subprocess.Popen[bytes]
    descriptor: int  # pidfd: readable when the process has ended
    output: IO[bytes]
    started: float


class Sweep:
    """Runs shards, says how it goes, and remembers which failed."""

    def __init__(self, pitbench: str, out: Path, shards: list[Shard]) -> None:
        self.pitbench, self.out = pitbench, out
        self.todo = [shard for shard in shards if not is_done(out, shard)]
        self.total, self.before = len(shards), len(shards) - len(self.todo)
        self.failed: list[str] = []
        self.seconds: dict[Shard, float] = {}
        self.children: list[Child] = []
        self.times = SweepTimes(out)
        self.console = Console(soft_wrap=True, highlight=False)
        # No refresh thread: nothing may wake up beside a timing shard but the
        # one tick a second of run().
        self.bar = Progress(
            TextColumn("{task.completed:.0f}/{task.total:.0f}"),
            BarColumn(),
            TimeElapsedColumn(),
            TextColumn("{task.description}", markup=False),
            console=self.console,
            auto_refresh=False,
            disable=not self.console.is_terminal,
        )
        self.task = self.bar.add_task("", total=self.total, completed=self.before)

    def say(self, text: str) -> None:
        self.console.print(text, markup=False)

    def time_left(self, jobs: int) -> str:
        running = {c.shard: time.monotonic() - c.started for c in self.children}
        return time_left(self.seconds, self.todo, running, jobs)

    def start(self, shard: Shard, locks: list[int]) -> None:
        command = [self.pitbench, shard.kind, *shard.arguments]
        command += ["--out", str(result(self.out, shard))]
        output = tempfile.TemporaryFile(prefix="pitbench-")
        process = subprocess.Popen(
            ["setpriv", "--pdeathsig", "KILL", "--", *command],
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=output,
            pass_fds=locks,
        )
        descriptor = os.pidfd_open(process.pid)
        self.children.append(
            Child(shard, command, process, descriptor, output, time.monotonic())
        )

    def finish(self, child: Child, jobs: int) -> None:
        code, seconds = child.process.wait(), time.monotonic() - child.started
        os.close(child.descriptor)
        self.children.remove(child)
        shard, file = child.shard, result(self.out, child.shard)
        set_aside = file.with_name(file.name + ".failed")
        if code == 0 and is_done(self.out, shard):
            self.seconds[shard] = seconds
            self.times.add(shard.name, seconds)
            self.bar.advance(self.task)
            set_aside.unlink(missing_ok=True)
            count = self.before + len(self.seconds)
            if not self.console.is_terminal:
                self.say(
                    f"{count}/{self.total} {shard.name} {seconds:.1f} s, "
                    f"{self.time_left(jobs)}"
                )
        else:
            # Kept for whoever looks into it, but not under the shard's name.
            if file.exists():
                file.replace(set_aside)
            remove_temporaries(self.out, shard.name)
            why = f"exit {code}" if code >= 0 else f"killed by signal {-code}"
            self.failed.append(shard.name)
            self.say(f"FAILED {shard.name}: {why if code else 'wrote no file'}")
            self.say(f"  {shlex.join(child.command)}")
            child.output.seek(0)
            lines = child.output.read().decode(errors="replace").splitlines()
            for line in lines[-STDERR_LINES:]:
                self.say(f"  | {line}")
        child.output.close()

    def run(self, alone: bool, jobs: int, locks: list[int]) -> None:
        """Runs the shards that run alone (they measure time), or the others, at most
        `jobs` at once."""
        mine = [shard for shard in self.todo if shard.alone == alone]
        if not mine:
            return
        with timing_lock(alone, self.say) as machine_wide:
            while mine or self.children:
                while mine and len(self.children) < jobs:
                    self.todo.remove(mine[0])
                    self.start(mine.pop(0), [*locks, machine_wide])
                names = ", ".join(child.shard.name for child in self.children[:2])
                self.bar.update(
                    self.task, description=f"{self.time_left(jobs)}  {names}"
                )
                self.bar.refresh()
                fds = [child.descriptor for child in self.children]
                ended, _, _ = select.select(fds, [], [], 1.0)
                for child in [c for c in self.children if c.descriptor in ended]:
                    self.finish(child, jobs)

    def stop(self) -> None:
        """Ends the children: asked first, killed after five seconds."""
        for child in self.children:
            child.process.terminate()
        until = time.monotonic() + 5.0
        for child in self.children:
            try:
                child.process.wait(max(0.0, until - time.monotonic()))
            except subprocess.TimeoutExpired:
                child.process.kill()
                child.process.wait()
            remove_temporaries(self.out, child.shard.name)


def sweep(options: argparse.Namespace, out: Path) -> int:
    started = time.monotonic()
    shards = list_shards(options.pitbench, options.profile)
    if options.isa_up_to:
        shards = restricted(shards, options.isa_up_to)
    every = shards
    one = options.shard is not None or options.index is not None
    if options.index is not None:
        if not 0 <= options.index < len(shards):
            raise Refusal(f"--index {options.index}: there are {len(shards)} shards")
        shards = [shards[options.index]]
    elif options.shard is not None:
        shards = [shard for shard in shards if shard.name == options.shard]
        if not shards:
            raise Refusal(f"no shard {options.shard!r} in profile {options.profile}")

    out.mkdir(parents=True, exist_ok=True)
    with contextlib.ExitStack() as stack:
        # Single shards (of a Slurm array) share the folder with each other,
        # not with a whole sweep.
        busy = f"another sweep is running in {out}; wait for it, or give another folder"
        operation = fcntl.LOCK_SH if one else fcntl.LOCK_EX
        locks = [stack.enter_context(folder_lock(out / ".lock", operation, busy))]
        if one:
            name = shards[0].name
            busy = f"shard {name} is being run in {out} already"
            file = out / f".lock-{name}"
            locks.append(stack.enter_context(folder_lock(file, fcntl.LOCK_EX, busy)))
            with open(out / ".lock-prepare", "w") as preparing:
                fcntl.flock(preparing, fcntl.LOCK_EX)
                prepare(
                    options.pitbench, options.profile, out, every, options.isa_up_to
                )
            remove_temporaries(out, name)
        else:
            remove_temporaries(out)
            prepare(options.pitbench, options.profile, out, every, options.isa_up_to)

        jobs = options.jobs or len(os.sched_getaffinity(0))
        work = Sweep(options.pitbench, out, shards)
        if work.before:
            work.say(f"{work.before} of {work.total} shards are there already")
        try:
            if work.console.is_terminal:
                stack.enter_context(work.bar)
            work.run(True, 1, locks)
            work.run(False, jobs, locks)
            if work.seconds or work.failed:
                work.times.add()
        except BaseException:
            for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
                signal.signal(number, signal.SIG_IGN)
            work.stop()
            raise

    peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    ran = len(work.seconds)
    work.say(
        f"{ran} shards run, {work.before} were there, {len(work.failed)} failed; "
        f"{time.monotonic() - started:.1f} s, largest process {peak:.0f} MiB"
    )
    for name in work.failed:
        work.say(f"failed: {name}")
    return 1 if work.failed else 0


def main(arguments: list[str]) -> int:
    def interrupt(number: int, frame: FrameType | None) -> None:
        raise Interrupted()

    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, interrupt)
    options = parse_arguments(arguments)
    options.pitbench = os.path.abspath(options.pitbench)
    try:
        if options.print_run_name:
            machine = describe_machine(options.pitbench)
            print(run_name(machine, options.profile, options.isa_up_to))
            return 0
        return sweep(options, options.out)
    except Refusal as refusal:
        print(f"sweep: {refusal}", file=sys.stderr)
        return 2
    except OSError as error:
        print(f"sweep: {error}", file=sys.stderr)
        return 2
    except Interrupted:
        print("sweep: interrupted; the same command goes on", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
