"""Which method for rays to take, in sentences made of the run's data.

Each function gives one sentence, or nothing where the run has no data for it.
`Priced` holds what all of them speak of.
"""

from __future__ import annotations

import dataclasses
import math
from collections.abc import Hashable, Mapping
from typing import Any, Final

import pandas as pd

from analysis.accuracy.accuracy_tables import error_rates
from analysis.rays.rays_claims import (
    PAIRS,
    WATERTIGHT,
    kept_break_evens,
    time_over,
    watertight_over_precomputed,
)
from analysis.rays.rays_leaks import sphere_rates
from analysis.rays.rays_tables import BASE, MAIN_LOOP
from analysis.read.run import RayRun
from analysis.report.method_families import FMA_SUFFIX, is_exact
from analysis.report.wording import (
    counted,
    grouped,
    listed,
    nanoseconds,
    share,
    share_between,
    with_interval,
)
from analysis.speed.break_even import break_even_words
from analysis.speed.input_tables import EARLY_OUT, culling, early_out
from analysis.speed.tables import (
    reference_cells,
    reference_scene,
    sort_cells,
    widest_isa,
)
from analysis.trust.stats import Interval

PERTURBED: Final = "exact_perturbed"


@dataclasses.dataclass(frozen=True)
class Priced:
    """A run's rays of one scalar on one ISA.

    cells: those that methods are compared by; every: those of sweeps too; timed:
    the two-sided methods' rows of the reference scene, by method; leaks:
    rays_leaks.sphere_rates by method, two-sided methods only.
    """

    rays: RayRun
    cells: pd.DataFrame
    every: pd.DataFrame
    scalar: str
    isa: str
    timed: pd.DataFrame
    leaks: pd.DataFrame

    @property
    def fastest(self) -> str:
        return str(self.timed["ns"].idxmin())

    def over(self, method: str, other: str) -> Interval | None:
        return time_over(self.rays, self.cells, method, other, self.scalar, self.isa)


def priced(
    rays: RayRun, cells: pd.DataFrame, every: pd.DataFrame, scalar: str
) -> Priced | None:
    """None where no two-sided method was timed."""
    main = reference_cells(cells, scalar, MAIN_LOOP)
    isa = widest_isa(main)
    if isa is None:
        return None
    culls = {entry.key for entry in rays.methods if entry.culls_backface}
    timed = main[(main["isa"] == isa) & ~main["method"].isin(culls)]
    if not len(timed):
        return None
    leaks = sphere_rates(rays.accuracy, scalar, isa)
    return Priced(
        rays=rays,
        cells=cells,
        every=every,
        scalar=scalar,
        isa=isa,
        timed=timed.set_index("method"),
        leaks=leaks[~leaks["method"].isin(culls)].set_index("method"),
    )


def guidance(run: Priced) -> tuple[str, ...]:
    sentences = (
        take_fastest(run),
        take_without_leaks(run),
        take_exact(run),
        watertight_costs(run),
        precomputing_pays(run),
        contraction_leaks(run),
        leaving_early(run),
        culling_saves(run),
    )
    return tuple(sentence for sentence in sentences if sentence)


def take_fastest(run: Priced) -> str:
    best = run.fastest
    where = f"{nanoseconds(run.timed.loc[best, 'ns'])} a ray ({run.scalar}, {run.isa})"
    if best not in run.leaks.index:
        return f"The fastest is {best}, at {where}."
    if run.leaks.loc[best, "hole_count"] == 0:
        return f"Take {best}: the fastest, at {where}, and {_none_escaped(run, best)}."
    return (
        f"Where a lost ray does no harm, take {best}: the fastest, at {where}. Of "
        f"the rays aimed from inside at the edges of a closed sphere "
        f"{_escaped(run, best)} escaped it."
    )


def take_without_leaks(run: Priced) -> str:
    judged = run.leaks[run.leaks.index.isin(run.timed.index)]
    if not len(judged):
        return ""
    whole = judged.index[judged["hole_count"] == 0]
    if not len(whole):
        return (
            "For a closed surface none of them will do: rays escaped every method "
            "of this run."
        )
    if run.fastest in whole:
        return ""
    best = str(run.timed.loc[whole, "ns"].idxmin())
    ratio = run.over(best, run.fastest)
    price = f", at {_times(ratio)} × the time of {run.fastest}" if ratio else ""
    twice = judged.loc[best]
    claims = (
        f"none was claimed twice beyond what the rule for edges brings about"
        if twice["double_hit_count"] == 0
        else f"{share(twice['double_hit'])} were claimed twice beyond what the rule "
        "for edges brings about"
    )
    return (
        f"For a closed surface take {best}: of {counted(len(whole), 'method')} that "
        f"let no ray out the cheapest{price}. {_capital(_none_escaped(run, best))}; "
        f"{claims}."
    )


def take_exact(run: Priced) -> str:
    judged = run.rays.accuracy
    judged = judged[(judged["scalar"] == run.scalar) & (judged["isa"] == run.isa)]
    methods = [method for method in run.timed.index if is_exact(method)]
    if not methods or not set(methods) & set(judged["method"]):
        return ""
    rates = error_rates(judged[judged["method"].isin(methods)], ["method"])
    wrong, of = int(rates["wrong"].sum()), int(rates["of"].sum())
    best = str(run.timed.loc[methods, "ns"].idxmin())
    prices = [
        f"{_times(ratio)} × the time of {other}"
        for other in (run.fastest, WATERTIGHT)
        if other != best and (ratio := run.over(best, other))
    ]
    answers = counted(of, "answer")
    said = (
        f"none of {answers} on all scenes of this run was wrong"
        if wrong == 0
        else f"{grouped(wrong)} of {answers} on the scenes of this run were wrong, "
        "which the method does not allow"
    )
    text = f"Where every answer has to be right, take {best}"
    text += f", at {listed(prices)}: {said}." if prices else f": {said}."
    if PERTURBED in run.leaks.index and PERTURBED in run.timed.index:
        own = run.leaks.loc[PERTURBED]
        if own["hole_count"] == own["double_hit_count"] == 0:
            text += (
                f" {PERTURBED} gave each of {counted(int(own['hole_of']), 'ray')} "
                "through a closed sphere to exactly one triangle, edges included."
            )
    return text


def watertight_costs(run: Priced) -> str:
    found = watertight_over_precomputed(run.rays, run.cells, run.scalar, run.isa)
    if found is None:
        return ""
    other, ratio = found
    if ratio.high < 1:
        verdict = "so it costs nothing here"
    elif ratio.low > 1:
        verdict = _watertight(run)
    else:
        verdict = "which the interval does not tell from the same"
    return (
        f"{WATERTIGHT} takes {_times(ratio)} × the time of {other}, the fastest method that "
        f"prepares triangles: {verdict}."
    )


def precomputing_pays(run: Priced) -> str:
    evens = kept_break_evens(run.rays, run.every)
    evens = evens[evens["scalar"] == run.scalar]
    pays: dict[str, list[str]] = {}
    never: dict[str, list[str]] = {}
    for row in sort_cells(evens, ["method", "isa"]).to_dict("records"):
        if math.isnan(row["break_even_high"]):
            never.setdefault(row["method"], []).append(row["isa"])
            continue
        words = break_even_words(pd.Series(row))
        many = f"from {words}" if words != "always" else "for any number of"
        pays.setdefault(row["method"], []).append(
            f"{many} rays a triangle on {row['isa']} "
            f"({_ratio(row, 'best')} × the time at best)"
        )
    parts = []
    for method, other in PAIRS:
        if method not in (*pays, *never):
            continue
        part = f"{method} in place of {other} "
        if method in pays:
            part += f"pays {listed(pays[method])}"
            if method in never:
                part += f", and on {listed(never[method])} nowhere beyond doubt"
        else:
            part += f"pays nowhere beyond doubt ({listed(never[method])})"
        parts.append(part)
    if not parts:
        return ""
    return f"With the preparation of the triangle included, {'; '.join(parts)}."


def contraction_leaks(run: Priced) -> str:
    leaks = run.leaks
    pairs = [m for m in leaks.index if m + FMA_SUFFIX in leaks.index]
    if not pairs:
        return ""
    plain = leaks.loc[pairs, "hole_count"]
    fused = leaks.loc[[m + FMA_SUFFIX for m in pairs], "hole_count"].set_axis(pairs)
    torn = [m for m in pairs if plain[m] == 0 and fused[m] > 0]
    mended = [m for m in pairs if plain[m] > 0 and fused[m] == 0]
    more = int((fused > plain).sum())
    less = int((fused < plain).sum())
    text = (
        f"With multiply-add {grouped(more)} of {counted(len(pairs), 'method')} let "
        f"more rays out and {grouped(less)} fewer"
    )
    if torn:
        text += f"; {listed(torn)} let none out without it and some with it"
    if mended:
        text += f"; {listed(mended)} let some out without it and none with it"
    return f"{text}."


def leaving_early(run: Priced) -> str:
    table = early_out(run.rays.speed, run.every)
    table = table[
        (table["scalar"] == run.scalar)
        & (table["method"] == BASE + EARLY_OUT)
        & (table["sets"] == "fresh")
    ]
    if not len(table):
        return ""
    saves = table[table["over_plain_high"] < 1]
    costs = table[table["over_plain_low"] > 1]
    best = table.loc[table["over_plain"].idxmin()]
    worst = table.loc[table["over_plain"].idxmax()]
    cases = counted(len(table), "case")
    return (
        f"A way out after each test saves time in {len(saves)} of {cases} on fresh "
        f"input and costs some in {len(costs)}: {_place(best)} at best, "
        f"{_place(worst)} at worst."
    )


def culling_saves(run: Priced) -> str:
    rows = culling(run.rays.speed, run.cells)
    rows = rows[
        (rows["scalar"] == run.scalar)
        & (rows["isa"] == run.isa)
        & (rows["loop"] == MAIN_LOOP)
        & ~rows["method"].str.endswith(FMA_SUFFIX)
        & (rows["scene"] == reference_scene(run.cells, MAIN_LOOP))
    ]
    words = [
        f"{row['method']} {_ratio(row, 'over_two_sided')} × the time of the method "
        "for both sides"
        for row in rows.to_dict("records")
    ]
    if not words:
        return ""
    return (
        "Hitting only what is seen from the front is another question; answering it "
        f"takes {listed(words)}."
    )


def _watertight(run: Priced) -> str:
    if WATERTIGHT not in run.leaks.index:
        return "what it costs"
    if run.leaks.loc[WATERTIGHT, "hole_count"] == 0:
        return "the price of not losing rays"
    return "and yet rays escaped it"


def _none_escaped(run: Priced, method: str) -> str:
    row = run.leaks.loc[method]
    return (
        f"none of {counted(int(row['hole_of']), 'ray')} aimed from inside at the "
        f"edges of a closed sphere escaped it, so at most {share(row['hole_high'])} "
        "do (95 %)"
    )


def _escaped(run: Priced, method: str) -> str:
    row = run.leaks.loc[method]
    return f"{share(row['hole'])} ({share_between(row['hole_low'], row['hole_high'])})"


def _times(ratio: Interval) -> str:
    return with_interval(ratio.value, ratio.low, ratio.high)


def _ratio(row: Mapping[Hashable, Any] | pd.Series, key: str) -> str:
    return with_interval(row[key], row[f"{key}_low"], row[f"{key}_high"])


def _place(row: pd.Series) -> str:
    ratio = _ratio(row, "over_plain")
    return f"{ratio} × the time without it ({row['isa']}, {row['hit']:g} % hit)"


def _capital(text: str) -> str:
    return text[:1].upper() + text[1:]
