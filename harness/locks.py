"""The locks of a sweep: one on the results folder, one on the machine."""

from __future__ import annotations

import contextlib
import fcntl
import os
import stat
import time
from collections.abc import Callable, Iterator
from pathlib import Path

TIMING_LOCK = "/tmp/pitbench-timing.lock"


class Refusal(Exception):
    """The call was wrong; the message says what to do. Exit code 2."""


def try_lock(descriptor: int, operation: int, patience: float = 0.0) -> bool:
    """Takes a flock, trying for `patience` seconds."""
    until = time.monotonic() + patience
    while True:
        try:
            fcntl.flock(descriptor, operation | fcntl.LOCK_NB)
            return True
        except BlockingIOError:
            if time.monotonic() >= until:
                return False
            time.sleep(0.05)


@contextlib.contextmanager
def folder_lock(path: Path, operation: int, busy: str) -> Iterator[int]:
    """Holds a lock inside the results folder, or refuses with `busy`.

    A second of patience: the shard of a sweep that was just killed needs a
    moment to die, and holds the lock until then.
    """
    descriptor = os.open(path, os.O_RDWR | os.O_CREAT | os.O_CLOEXEC, 0o644)
    try:
        if not try_lock(descriptor, operation, patience=1.0):
            raise Refusal(busy)
        yield descriptor
    finally:
        os.close(descriptor)


def open_timing_lock(path: str) -> int:
    """Opens the machine-wide lock file, which may belong to another user.

    Nothing is ever written to it and no link is followed, so a file planted
    there can at worst make us wait or refuse. Reading is enough for flock.
    """
    flags = os.O_RDONLY | os.O_NOFOLLOW | os.O_CLOEXEC | os.O_NONBLOCK
    try:
        for _ in range(10):
            try:
                descriptor = os.open(path, flags)
                break
            except FileNotFoundError:
                with contextlib.suppress(FileExistsError):
                    created = os.open(path, flags | os.O_CREAT | os.O_EXCL, 0o644)
                    os.fchmod(created, 0o644)  # whatever the umask is
                    os.close(created)
        else:
            raise OSError("it comes and goes")
    except OSError as error:
        raise Refusal(
            f"cannot open {path} ({error.strerror or error}), the lock that keeps "
            "timings apart; remove it, or name another in PITBENCH_TIMING_LOCK"
        ) from error
    if not stat.S_ISREG(os.fstat(descriptor).st_mode):
        os.close(descriptor)
        raise Refusal(f"{path} is not a plain file; remove it")
    return descriptor


@contextlib.contextmanager
def timing_lock(alone: bool, say: Callable[[str], None]) -> Iterator[int]:
    """Holds the machine-wide lock: alone (to measure time), or shared."""
    path = os.environ.get("PITBENCH_TIMING_LOCK", TIMING_LOCK)
    operation = fcntl.LOCK_EX if alone else fcntl.LOCK_SH
    descriptor = open_timing_lock(path)
    try:
        if not try_lock(descriptor, operation):
            say(f"waiting: another sweep on this machine is measuring ({path})")
            fcntl.flock(descriptor, operation)
        yield descriptor
    finally:
        os.close(descriptor)
