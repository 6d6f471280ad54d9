"""Synthetic runs on disk, and reports of them, made once for all tests."""

from __future__ import annotations

from pathlib import Path

import pytest

from analysis.read.load import load_run
from analysis.report.page import write_page
from analysis.report.report import Report, build
from tests.analysis.hard_scenes import Asked
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


@pytest.fixture(scope="session", params=["f32", "f64"])
def asked(
    request: pytest.FixtureRequest, tmp_path_factory: pytest.TempPathFactory
) -> Asked:
    """Hard scenes, and the real kernels' answers to them."""
    scalar = request.param
    return Asked(scalar, tmp_path_factory.mktemp("cases") / f"{scalar}.csv")
