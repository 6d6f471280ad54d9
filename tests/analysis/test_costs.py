"""What a point costs: files, tables, claims, and the cycles of a model."""

from __future__ import annotations

import dataclasses
import json
import shutil
from pathlib import Path

import pandas as pd
import pytest

from analysis.models import llvm_mca, modelled
from analysis.read.load import LoadError, load_run
from analysis.read.load_instructions import load_instructions
from analysis.read.load_operations import load_operations
from analysis.read.run import Run
from analysis.report.page import render
from analysis.report.report import build
from analysis.speed import operations_tables
from analysis.speed.cost_exhibits import with_models
from analysis.speed.tables import speed_cells
from tests.analysis.synthetic import Options, documents, write_run
from tests.analysis.synthetic_costs import ITERATIONS

FOUR = Options(
    methods=(
        "cross_product",
        "cross_product_det",
        "edge_function_fma",
        "barycentric_inverse",
    ),
    small=True,
)
needs_llvm = pytest.mark.skipif(
    shutil.which("llvm-mca-19") is None, reason="llvm-19 is not installed"
)


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return write_run(tmp_path_factory.mktemp("run"), FOUR)


@pytest.fixture(scope="module")
def run(folder: Path) -> Run:
    return load_run(folder)


def test_each_method_is_one_row_with_set_up_point_and_instructions(run: Run) -> None:
    table = operations_tables.cost_table(run.operations, run.instructions, "f32")
    assert sorted(table["method"]) == sorted(FOUR.methods)
    row = table.set_index("method").loc["cross_product_det"]
    assert (row["call_add"], row["item_add"], row["item_divide"]) == (9, 9, 0)
    assert row["isa"] == "avx512"
    assert row["instructions"] == len(ITERATIONS["avx512"]) / 16


def test_a_method_that_was_not_traced_has_no_instructions(run: Run) -> None:
    traced = run.instructions[run.instructions["method"] != "cross_product"]
    table = operations_tables.cost_table(run.operations, traced, "f32")
    assert table.set_index("method")["instructions"].isna().sum() == 1


def test_the_verdict_on_a_claim_follows_from_the_counts(run: Run) -> None:
    said = {c["number"]: c["verdict"] for c in operations_tables.ledger(run.operations)}
    assert said == {
        1: "holds",
        2: "holds with a condition",
        3: "holds with a condition",
    }
    fewer = run.operations.assign(multiply=run.operations["multiply"] - 1)
    said = {c["number"]: c["verdict"] for c in operations_tables.ledger(fewer)}
    assert said == {1: "does not hold", 2: "does not hold", 3: "does not hold"}


def test_a_run_without_the_files_has_no_chapter_on_cost(tmp_path: Path) -> None:
    older = write_run(tmp_path, FOUR)
    for name in ("operations.json", "instructions.json"):
        (older / name).unlink()
    run = with_models(load_run(older))
    assert run.operations.empty and run.modelled.empty
    page = render(build(run), "index.html.j2")
    assert 'id="cost"' not in page and 'id="modelled"' not in page


def test_the_page_says_why_nothing_was_traced(tmp_path: Path) -> None:
    folder = write_run(tmp_path, FOUR)
    file = folder / "instructions.json"
    document = json.loads(file.read_text()) | {"rows": [], "reason": "no trap flag"}
    file.write_text(json.dumps(document))
    page = render(build(with_models(load_run(folder))), "index.html.j2")
    assert "could not be traced: no trap flag" in page
    assert "Not modelled: no trap flag" in page


@pytest.mark.parametrize(
    ("name", "spoil", "field"),
    [
        ("operations", lambda d: d["rows"].append(d["rows"][0]), r"\$.rows\[8\]"),
        ("operations", lambda d: d["rows"][1]["per_item"].pop("add"), "per_item"),
        ("operations", lambda d: d["context"].update(seed=1), "context.seed"),
        ("instructions", lambda d: d["rows"].append(d["rows"][0]), r"\$.rows\[16\]"),
        (
            "instructions",
            lambda d: d["rows"][2].update(items_per_iteration=0),
            r"\$.rows\[2\].items_per_iteration",
        ),
        ("instructions", lambda d: d["rows"][0]["iteration"].append("xy"), "iteration"),
    ],
)
def test_a_spoilt_file_is_refused_by_file_and_field(
    tmp_path: Path, name: str, spoil: object, field: str
) -> None:
    folder = write_run(tmp_path, FOUR)
    document = documents(FOUR)[f"{name}.json"]
    assert callable(spoil)
    spoil(document)
    (folder / f"{name}.json").write_text(json.dumps(document))
    with pytest.raises(LoadError, match=rf"{name}\.json: .*{field}"):
        load_run(folder)


def test_files_load_on_their_own(folder: Path) -> None:
    assert len(load_operations(folder / "operations.json")) == 2 * 2 * len(FOUR.methods)
    instructions, reason, *_ = load_instructions(folder / "instructions.json")
    assert reason == "" and set(instructions["iteration"]) == {
        tuple(codes) for codes in ITERATIONS.values()
    }


PRINTED = json.dumps(
    {
        "CodeRegions": [
            {"Name": "0", "SummaryView": {"TotalCycles": 912, "Iterations": 100}},
            {"Name": "1", "SummaryView": {"TotalCycles": 50, "Iterations": 100}},
        ]
    }
)


def test_cycles_are_those_of_an_iteration() -> None:
    assert llvm_mca.parse(PRINTED) == {"0": 9.12, "1": 0.5}
    with pytest.raises(llvm_mca.NotModelled, match="something else"):
        llvm_mca.parse('{"CodeRegions": [{}]}')


def test_each_instruction_keeps_its_text() -> None:
    printed = "\t.text\n\taddq\t$16, %rax\n\tjne\t-26 # back\n"
    texts = llvm_mca.parse_assembly(["4883c010", "75e6"], printed)
    assert texts == {"4883c010": "addq\t$16, %rax", "75e6": "jne\t-26"}
    with pytest.raises(llvm_mca.NotModelled, match="where each ends"):
        llvm_mca.parse_assembly(["4883c010"], printed)


def test_a_run_has_the_model_of_its_own_cpu() -> None:
    assert llvm_mca.model_of("Zen 5") == "znver5"
    assert llvm_mca.model_of("Zen 2") is None
    assert llvm_mca.model_of("") is None
    assert set(llvm_mca.DESIGNS) == set(llvm_mca.MODELS)


@needs_llvm
def test_llvm_mca_models_a_dependent_loop_by_its_latency(run: Run) -> None:
    cycles = llvm_mca.model(run.instructions)
    assert set(cycles["model"]) == set(llvm_mca.MODELS)
    assert set(cycles.loc[cycles["model"] == "znver3", "isa"]) == {"avx2"}
    # zmm0 = zmm1 + zmm2, …: independent but for vfmadd231ps, which adds to the
    # product just made: less than a latency an iteration of 16 items.
    assert (cycles["cycles"] > 1 / 16).all() and (cycles["cycles"] < 2).all()


def with_cycles(run: Run, nearest: str | None) -> Run:
    rows = [
        {"method": method, "scalar": "f32", "loop": "one_triangle"}
        | {"isa": isa, "model": name, "cycles": value}
        for method in FOUR.methods
        for name, isa, value in (
            ("znver4", "avx512", 2.0),
            ("znver5", "avx512", 2.0),
            ("znver3", "avx2", 3.0),
        )
    ]
    frame = pd.DataFrame(rows, columns=llvm_mca.MODELLED_COLUMNS)
    return dataclasses.replace(run, modelled=frame, nearest_model=nearest)


def test_the_error_is_modelled_over_measured_cycles(run: Run) -> None:
    cells = speed_cells(run.speed)
    error = modelled.model_error(with_cycles(run, "znver5"), cells, "f32")
    assert set(error["method"]) == set(FOUR.methods)
    clock = {s.name: (s.clock_before_ghz + s.clock_after_ghz) / 2 for s in run.shards}
    row = error.set_index("method").loc["cross_product"]
    timed = cells[
        (cells["method"] == "cross_product")
        & (cells["isa"] == "avx512")
        & (cells["shard"] == "speed-one_triangle-f32")
        & (cells["family"] == "uniform")
    ]
    measured = timed["ns"] * clock["speed-one_triangle-f32"]
    assert any(abs(row["off"] - 2.0 / m) < 1e-9 for m in measured)


def test_without_a_model_of_the_host_there_is_no_error_and_the_chart_says_so(
    run: Run,
) -> None:
    cells = speed_cells(run.speed)
    other = with_cycles(run, None)
    assert modelled.model_error(other, cells, "f32").empty
    page = render(build(other), "index.html.j2")
    assert "How far it is off on the CPU of this run is not known" in page
    assert "Modelled, not measured" in page


def test_a_host_whose_loops_were_not_timed_is_said_to_be_that(run: Run) -> None:
    narrow = with_cycles(run, "znver5")
    speed = narrow.speed[narrow.speed["isa"] != "avx512"]
    page = render(build(dataclasses.replace(narrow, speed=speed)), "index.html.j2")
    assert "its model znver5 was given loops of avx512, and this run timed none" in page
    assert "another machine" not in page


def test_modelled_rows_never_stand_among_measured_ones(run: Run) -> None:
    plain, more = build(run), build(with_cycles(run, "znver5"))
    for exhibit in plain.exhibits:
        other = more.exhibits.get(exhibit.key)
        assert other is not None and other.csv.equals(exhibit.csv), exhibit.key
    assert {e.key for e in more.exhibits} - {e.key for e in plain.exhibits} == {
        "modelled-f32",
        "model_error",
    }


def test_models_that_give_the_same_share_a_mark(run: Run) -> None:
    table = modelled.model_table(with_cycles(run, None).modelled, "f32")
    models = [name for name in llvm_mca.MODELS if name in table.columns]
    assert modelled.alike(table, models) == [["znver3"], ["znver4", "znver5"]]


def test_models_whose_instruction_set_did_not_run_are_named_with_the_reason(
    run: Run,
) -> None:
    def without_avx512(**machine: object) -> Run:
        cycles = pd.DataFrame(
            [["cross_product", "f32", "one_triangle", "avx2", "znver3", 2.0]],
            columns=llvm_mca.MODELLED_COLUMNS,
        )
        here = dataclasses.replace(run.machine, isas=("scalar", "sse4", "avx2"))
        return dataclasses.replace(
            run, **({"modelled": cycles, "machine": here} | machine)
        )

    assert modelled.left_out(run) == ""  # nobody asked
    words = modelled.left_out(without_avx512())
    assert words == (
        "Not modelled are skylake-avx512, icelake-server, sapphirerapids, znver4 and "
        "znver5, whose loops are of avx512, which the CPU of this run does not have, "
        "so that none could be traced."
    )
    held = without_avx512(machine=run.machine, isa_up_to="avx2")
    assert "which this run left out: it was held to avx2" in modelled.left_out(held)
    page = render(build(without_avx512()), "index.html.j2")
    assert words in page
    every = pd.concat(
        [without_avx512().modelled.assign(model=model) for model in llvm_mca.MODELS]
    )
    assert modelled.left_out(without_avx512(modelled=every)) == ""
    one = every[every["model"] != "znver3"]
    words = modelled.left_out(without_avx512(modelled=one))
    assert words.startswith("Not modelled is znver3, whose loops are of avx2, which ")
    none = without_avx512(modelled=every.iloc[:0], nearest_model="znver3")
    page = render(build(none), "index.html.j2")
    assert "<p>Not modelled are skylake-avx512" in page
