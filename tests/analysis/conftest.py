"""Synthetic runs on disk, and reports of them, made once for all tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from analysis.load import load_run
from analysis.page import write_page
from analysis.report import Report, build
from tests.analysis.synthetic import Options, write_run

TWO_METHODS = Options(
    profile="tiny",
    methods=("cross_product", "edge_function"),
    isas=("scalar", "avx2"),
    scalars=("f32",),
    small=True,
)


@pytest.fixture(scope="session")
def run_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A synthetic run with everything in it."""
    return write_run(tmp_path_factory.mktemp("results") / "quick")


@pytest.fixture(scope="session")
def report(run_folder: Path) -> Report:
    return build(load_run(run_folder))


@pytest.fixture(scope="session")
def page(report: Report, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The page of the synthetic run, its tables and charts beside it."""
    return write_page(report, tmp_path_factory.mktemp("report"))


@pytest.fixture
def small_run(tmp_path: Path) -> Path:
    """Two methods, two ISAs, one loop: fast to read, free to spoil."""
    return write_run(tmp_path / "small", TWO_METHODS)
