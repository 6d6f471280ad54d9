"""Claims about time: on the run's own repetitions, interleaved."""

from __future__ import annotations

import statistics
from typing import Final

from analysis.claims import inputs
from analysis.claims.evidence import (
    MAIN_LOOP,
    UNTESTED,
    Evidence,
    Finding,
    Test,
    judged,
    not_measured,
    time_ratio,
)
from analysis.report.wording import between, listed, nanoseconds, with_interval
from analysis.speed.break_even import UNHOISTED, break_evens, claimed
from analysis.speed.grid_tables import across_edges, published_scene
from analysis.speed.input_tables import early_out
from analysis.speed.operations_tables import ledger as counted_claims
from analysis.speed.tables import reference_cells, samples
from analysis.trust.stats import Interval, ratio_interval

CROSS: Final = "cross_product"
# The steps that are claimed; sse4 stands for SSE.
STEPS: Final = ("scalar", "sse4", "avx2", "avx512")
# What “little more” may be: the plain test and a quarter of it.
LITTLE: Final = 1.25
ADAPTIVE, PLAIN = "shewchuk_adaptive", "cross_product_det"


def operations(number: int) -> Test:
    """The test of the claim `number` about counted operations."""

    def test(evidence: Evidence) -> Finding:
        for row in counted_claims(evidence.run.operations):
            if row["number"] == number:
                why = f"Counted by running {row['method']} with numbers that count"
                remark = f". {row['remark']}" if row["remark"] else "."
                return Finding(row["verdict"], row["counted"], why + remark)
        return not_measured("counts of that method's operations")

    return test


def hoisting(evidence: Evidence) -> Finding:
    run = evidence.run
    table = claimed(run.speed, evidence.timed, UNHOISTED, CROSS)
    return _of_inputs(inputs.hoisting(table, run.machine.caches))


def inverse(evidence: Evidence) -> Finding:
    table = break_evens(evidence.run.speed, evidence.timed)
    return _of_inputs(inputs.inverse(table))


def early_way_out(evidence: Evidence) -> Finding:
    table = early_out(evidence.run.speed, evidence.timed)
    return _of_inputs(inputs.early_way_out(table))


def each_step_widens(evidence: Evidence) -> Finding:
    """That every wider instruction set is faster than the one before."""
    rows = reference_cells(evidence.cells, "f32", MAIN_LOOP)
    isas = [isa for isa in STEPS if isa in set(rows["isa"])]
    by_cell = samples(evidence.run.speed)
    own: dict[str, Interval] = {}
    words = []
    for narrow, wide in zip(isas, isas[1:]):
        below, above = (
            {cell["method"]: by_cell[cell["shard"], cell["name"]] for cell in cells}
            for cells in (
                rows[rows["isa"] == isa].to_dict("records") for isa in (narrow, wide)
            )
        )
        gains = {
            method: ratio_interval(below[method], above[method])
            for method in sorted(set(below) & set(above))
        }
        step = f"{wide} over {narrow}"
        if CROSS in gains:
            own[step] = gains[CROSS]
        middle = statistics.median(gain.value for gain in gains.values())
        slower = [name for name, gain in gains.items() if gain.high < 1]
        text = f"{step}: the middle method {middle:.2f} times as fast"
        words.append(text + (f", {listed(slower)} slower" if slower else ""))
    if not own:
        return not_measured(f"{CROSS} on two instruction sets")
    why = (
        f"Of all methods, {'; '.join(words)}. Four lanes for one would be 4, and then "
        "each step 2."
    )
    figure = "; ".join(f"{step} {_figure(gain)}" for step, gain in own.items())
    surely = [gain.low > 1 for gain in own.values()]
    return Finding(judged(all(surely), any(surely)), f"{CROSS}: {figure}", why)


def published_program(evidence: Evidence) -> Finding:
    """What the published program prints: the mean time a triangle on its scene."""
    run = evidence.run
    table = published_scene(run.speed, evidence.cells, dict(run.writes))
    if not len(table):
        return not_measured("published scene")
    best = table.loc[table.groupby("track")["ns"].idxmin()]
    words = [
        f"{row['method']} ({row['scalar']}, {row['isa']}) takes "
        f"{nanoseconds(row['ns'])} a triangle ({between(row['ns_low'], row['ns_high'])})"
        for row in best.to_dict("records")
    ]
    lanes = across_edges(run.speed, evidence.cells)
    why = (
        "The text's own times are of other machines, so its scene is measured here: "
        f"{'; '.join(words)}."
    )
    if len(lanes):
        row = lanes.iloc[-1]
        gain = with_interval(row["gain"], row["gain_low"], row["gain_high"])
        why += (
            f" On {row['isa']} lanes across points are {gain} times as fast as its own way, "
            "lanes across the edges of one point."
        )
    return Finding(UNTESTED, "; ".join(nanoseconds(ns) for ns in best["ns"]), why)


def adaptive_costs_little(evidence: Evidence) -> Finding:
    """That the adaptive test costs little more than the plain one."""
    speed, cells = evidence.run.speed, evidence.cells
    one_lane = cells[cells["isa"] == "scalar"]
    found = [
        time_ratio(speed, rows, ADAPTIVE, PLAIN, scalar)
        for scalar in ("f32", "f64")
        for rows in (one_lane, cells)
    ]
    ratios = [ratio for ratio in found if ratio]
    if not ratios:
        return not_measured(ADAPTIVE)
    why = (
        f"{ADAPTIVE} over {PLAIN}, uniform points, which its filter decides. Little is "
        f"taken to be a factor of {LITTLE}."
    )
    little = [ratio.ratio.high <= LITTLE for ratio in ratios]
    text = "; ".join(f"{ratio.figure} in {ratio.place}" for ratio in ratios)
    return Finding(judged(all(little), any(little)), text, why)


def _figure(gain: Interval) -> str:
    return with_interval(gain.value, gain.low, gain.high)


def _of_inputs(claim: inputs.Claim) -> Finding:
    return Finding(claim.verdict, claim.figure, claim.why)
