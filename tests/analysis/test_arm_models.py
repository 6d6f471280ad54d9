"""Arm CPUs by llvm-mca: from emulated loops to the chart and the words."""

from __future__ import annotations

import dataclasses
import json
import shutil
from pathlib import Path

import pandas as pd
import pytest

from analysis.models import arm_exhibits, arm_models, llvm_mca
from analysis.read.load import load_run
from analysis.read.run import Run
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed.cost_exhibits import with_models
from tests.analysis.synthetic import Options, documents, write_run

OPTIONS = Options(methods=("cross_product", "edge_function"), small=True)
# fmla v0.4s, v1.4s, v2.4s (4 cycles on a Neoverse V1, each after the last),
# then subs x0, x0, #1 and b.ne.
NEON = ["20cc224e", "000400f1", "c1ffff54"]
# fmla z0.s, p0/m, z1.s, z2.s instead.
SVE = ["2000a265", "000400f1", "c1ffff54"]
needs_llvm = pytest.mark.skipif(
    shutil.which("llvm-mca-19") is None, reason="llvm-19 is not installed"
)


def with_emulated(tmp_path: Path) -> Run:
    """A run whose instructions.json has loops for arm64 as well."""
    folder = write_run(tmp_path, OPTIONS)
    document = documents(OPTIONS)["instructions.json"]
    for method in OPTIONS.methods:
        for isa, bits, loop in (("neon", 128, NEON), ("sve", 256, SVE)):
            document["rows"].append(
                {
                    "method": method,
                    "scalar": "f32",
                    "loop": "one_triangle",
                    "isa": isa,
                    "vector_bits": bits,
                    "per_call": 90,
                    "per_item": len(loop) * 32 / bits,
                    "items_per_iteration": bits // 32,
                    "iteration": loop,
                }
            )
    document["not_emulated"] = ""
    (folder / "instructions.json").write_text(json.dumps(document))
    return load_run(folder)


def test_emulated_loops_stand_apart_from_those_of_the_machine(tmp_path: Path) -> None:
    run = with_emulated(tmp_path)
    assert set(run.emulated["isa"]) == {"neon", "sve"}
    assert not set(run.instructions["isa"]) & {"neon", "sve"}


@needs_llvm
def test_a_figure_a_point_is_an_iteration_by_its_points(tmp_path: Path) -> None:
    cycles = arm_models.model_arm(with_emulated(tmp_path).emulated)
    rows = cycles[cycles["method"] == "cross_product"].set_index(["model", "isa"])
    # A chain of additions into one register: so many cycles whatever its width.
    neon, sve = (rows.loc[("neoverse-v1", isa), "cycles"] for isa in ("neon", "sve"))
    assert neon * 4 == pytest.approx(sve * 8, rel=0.05)
    assert ("neoverse-n1", "sve") not in rows.index
    assert ("neoverse-n2", "sve2") not in rows.index  # not emulated here


@needs_llvm
def test_a_cpu_with_the_tables_of_an_older_one_is_called_so(tmp_path: Path) -> None:
    run = with_models(with_emulated(tmp_path))
    table = arm_exhibits.models_table(run, "f32").set_index("model")
    assert table.loc["apple-m4", "tables"] == "apple-a7"
    assert table.loc["neoverse-n1", "tables"] == "its own"


def test_tables_are_shared_only_if_every_loop_takes_the_same() -> None:
    new = pd.DataFrame({"model": "apple-m4", "cycles": [1.0, 2.0]})
    old = pd.DataFrame({"model": "apple-a7", "cycles": [1.0, 2.0]})
    assert arm_models.tables_of(new, old) == "apple-a7"
    assert arm_models.tables_of(new, old.assign(cycles=[1.0, 2.5])) == ""


@needs_llvm
def test_the_page_says_that_no_arm_row_was_measured(tmp_path: Path) -> None:
    run = with_models(with_emulated(tmp_path))
    report = build(run)
    page = render(report, "index.html.j2")
    assert "There is no measured row to compare with" in page
    assert "<code>apple-m4</code>" in page
    assert "modelled-arm-f32" in page
    assert set(run.speed["isa"]).isdisjoint({"neon", "sve", "sve2"})


@needs_llvm
def test_without_emulated_loops_the_page_says_why(tmp_path: Path) -> None:
    run = with_models(load_run(write_run(tmp_path, OPTIONS)))
    reason = dataclasses.replace(run, not_emulated="no compiler for arm64")
    page = render(build(reason), "index.html.j2")
    assert "CPUs of Arm are missing: no compiler for arm64" in page
    assert "modelled-arm" not in page


def test_assembly_for_arm_keeps_its_numbers() -> None:
    printed = "\t.text\n\tadd\tx0, x0, #16  // =0x10\n"
    texts = llvm_mca.parse_assembly(["00400091"], printed, llvm_mca.ARM64.comment)
    assert texts == {"00400091": "add\tx0, x0, #16"}
