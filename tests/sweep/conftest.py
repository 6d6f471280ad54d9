"""A fresh fake sweep for every test; nothing it started outlives it."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.sweep.fake_sweep import FakeSweep


@pytest.fixture
def fake(tmp_path: Path) -> Iterator[FakeSweep]:
    sweep = FakeSweep(tmp_path)
    yield sweep
    sweep.end_all()
