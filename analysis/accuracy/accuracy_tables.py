"""Tables of accuracy, and those that set it beside speed."""

from __future__ import annotations

import math

import pandas as pd

from analysis.charts.palette import is_autovec, isa_rank, loop_rank
from analysis.read.cells import WEIGHTS_SUFFIX
from analysis.speed.tables import CELL_KEYS, parameter, reference_cells, sort_cells
from analysis.trust.stats import pareto_frontier, wilson

COUNTS = ["interior", "exterior", "boundary", "degenerate"]
WRONG = ["false_outside", "false_inside", "boundary_accepted"]


RATE_COLUMNS = (
    ["error_rate", "error_rate_low", "error_rate_high", "wrong", "of"]
    + [*WRONG, *COUNTS, "smallest_ulps", "largest_ulps"]
    + ["accepts", "boundary_rule", "scenes"]
)


def error_rates(accuracy: pd.DataFrame, by: list[str]) -> pd.DataFrame:
    """Wrong answers and their share, the cells of a group pooled.

    Interior, exterior and degenerate points must be answered right; points on
    the boundary are counted apart, because the rule for them is the method's
    own choice. So `of` = interior + exterior + degenerate.
    """
    counts = ["points", *COUNTS, *WRONG]
    distances = ["smallest_ulps", "largest_ulps"]
    numbers = dict.fromkeys(counts, "int64") | dict.fromkeys(distances, "float64")
    groups = accuracy.astype(numbers).groupby(by, sort=True)
    table = groups[counts].sum()
    of = table["interior"] + table["exterior"] + table["degenerate"]
    wrong = table["false_outside"] + table["false_inside"]
    shares = [wilson(int(w), int(n)) for w, n in zip(wrong, of)]
    return (
        table.assign(
            error_rate=[share.value for share in shares],
            error_rate_low=[share.low for share in shares],
            error_rate_high=[share.high for share in shares],
            wrong=wrong,
            of=of,
            smallest_ulps=groups["smallest_ulps"].min(),
            largest_ulps=groups["largest_ulps"].max(),
            accepts=groups["accepts"].first(),
            boundary_rule=groups["boundary_rule"].first(),
            scenes=groups["scene"].nunique(),
        )
        .reset_index()
        .reindex(columns=[*by, *RATE_COLUMNS])
    )


def accuracy_loop(accuracy: pd.DataFrame) -> str | None:
    """The loop whose answers stand for the method: the one with most cells,
    one_triangle first among equals. Loops that also write weights answer by
    the same formula and are left out.
    """
    plain = accuracy[~accuracy["loop"].str.endswith(WEIGHTS_SUFFIX)]
    counts: dict[str, int] = plain["loop"].value_counts().to_dict()
    if not counts:
        return None
    return min(counts, key=lambda loop: (-counts[loop], loop_rank(loop)))


def widest_of_each(accuracy: pd.DataFrame) -> dict[str, str]:
    """Method → the widest ISA that it was judged on; a plain loop left to the
    compiler only where the method has nothing else.
    """
    widest: dict[str, str] = {}
    for method, rows in accuracy.groupby("method"):
        isas = set(rows["isa"])
        vectors = {isa for isa in isas if not is_autovec(isa)}
        widest[method] = max(vectors or isas, key=isa_rank)
    return widest


def accuracy_cells(accuracy: pd.DataFrame) -> pd.DataFrame:
    """One row a cell, with its error rate."""
    return sort_cells(error_rates(accuracy, ["family", *CELL_KEYS]))


def families_pooled(accuracy: pd.DataFrame) -> pd.DataFrame:
    """One row a family of scenes, method and scalar: its scenes pooled, in the
    loop that stands for the method. ISAs that gave the same counts are one, or
    the intervals would be too narrow.
    """
    parts = [
        rows[rows["loop"] == accuracy_loop(rows)]
        for _, rows in accuracy.groupby("family", sort=True)
    ]
    place = ["family", "loop", "scene", "method", "scalar"]
    once = pd.concat(parts).drop_duplicates([*place, *COUNTS, *WRONG])
    keys = ["family", "loop", "method", "scalar"]
    return sort_cells(error_rates(once, keys), ["family", "scalar", "loop", "method"])


def errors_along(
    accuracy: pd.DataFrame, family: str, key: str, scalar: str, isa: str
) -> pd.DataFrame:
    """The error rate of each method against the parameter `key` of a family
    of scenes (column `at`), for one scalar, on the ISA or, where a method has
    no row on it, on its widest. A scene all of whose points lie on the boundary
    has no error rate and is left out.
    """
    chosen = accuracy[(accuracy["family"] == family) & (accuracy["scalar"] == scalar)]
    chosen = chosen[chosen["loop"] == accuracy_loop(chosen)]
    on_isa = set(chosen[chosen["isa"] == isa]["method"])
    own_isa = chosen["method"].map(widest_of_each(chosen))
    own_isa = own_isa.mask(chosen["method"].isin(on_isa), isa)
    chosen = chosen[chosen["isa"] == own_isa]
    chosen = chosen.assign(at=parameter(chosen, key)).dropna(subset=["at"])
    rates = error_rates(chosen, ["method", "at"]).dropna(subset=["error_rate"])
    return sort_cells(rates, ["method", "at"])


def speed_against_error(
    cells: pd.DataFrame,
    accuracy: pd.DataFrame,
    scalar: str,
    loop: str = "one_triangle",
    family: str = "near_edge",
) -> pd.DataFrame:
    """One row a method × ISA: its speed on the loop's reference scene beside
    its error rate on all scenes of the hard family together, and whether it
    is on the frontier (no other row is faster without erring more).

    A timed row whose answers were not judged has NaN and is never on it.
    """
    timed = reference_cells(cells, scalar, loop)
    hard = accuracy[
        (accuracy["family"] == family)
        & (accuracy["scalar"] == scalar)
        & (accuracy["loop"] == accuracy_loop(accuracy[accuracy["family"] == family]))
    ]
    rates = error_rates(hard, ["method", "isa"])
    joined = timed.merge(rates, on=["method", "isa"], how="left")
    frontier = pareto_frontier(
        list(joined["items_per_second"]), list(joined["error_rate"])
    )
    return sort_cells(joined.assign(on_frontier=frontier), ["method", "isa"])


def isa_agreement(accuracy: pd.DataFrame) -> pd.DataFrame:
    """One row a loop × scene × method × scalar that more than one ISA answered:
    whether they all gave the same counts.
    """
    keys = ["loop", "scene", "method", "scalar"]
    groups = accuracy.groupby(keys, sort=True)
    different = groups[[*WRONG, *COUNTS]].nunique().max(axis=1)
    return (
        pd.DataFrame({"agree": different == 1})[groups.size() > 1]
        .reset_index()
        .reindex(columns=[*keys, "agree"])
    )


def weights_accuracy(accuracy: pd.DataFrame) -> pd.DataFrame:
    """The error of the weights, for each method, scalar and family of scenes:
    the largest over all cells, and the mean over all their points; `forward`
    is that of the point which the weights give.
    """
    judged = accuracy.dropna(subset=["weights_points"])
    judged = judged[judged["weights_points"].astype(float) > 0]
    rows = []
    for key, group in judged.groupby(["family", "method", "scalar"], sort=True):
        points = group["weights_points"].astype(float)
        row: dict[str, object] = dict(zip(["family", "method", "scalar"], key))
        for kind in ("ulps", "forward_ulps"):
            mean = group[f"weights_mean_{kind}"].astype(float) * points
            largest = group[f"weights_largest_{kind}"].astype(float)
            row[f"largest_{kind}"] = float(largest.max())
            row[f"mean_{kind}"] = mean.sum() / points.sum()
        row["not_finite"] = int(group["weights_not_finite"].astype(float).sum())
        row["points"] = int(points.sum())
        rows.append(row)
    columns = ["family", "method", "scalar", "largest_ulps", "mean_ulps"]
    columns += ["largest_forward_ulps", "mean_forward_ulps", "not_finite", "points"]
    return sort_cells(
        pd.DataFrame(rows, columns=columns), ["family", "scalar", "method"]
    )


def worst_answers(worst: pd.DataFrame) -> pd.DataFrame:
    """Each wrong answer once, with the ISAs that gave it: first the farthest
    from the boundary of each method and scalar (place 1), then the next.
    """
    keys = ["method", "scalar", "kind", "distance_ulps", "a", "b", "c", "p"]
    keys += ["loop", "scene"]
    once = (
        worst.groupby(keys, sort=True)["isa"]
        .agg(lambda isas: ", ".join(sorted(isas, key=isa_rank)))
        .reset_index()
    )
    order = ["distance_ulps", "scene", "kind", "p", "a", "b", "c", "loop"]
    once = once.sort_values(order, ascending=[False, *[True] * (len(order) - 1)])
    place = once.groupby(["method", "scalar"]).cumcount() + 1
    return sort_cells(once.assign(place=place), ["place", "method", "scalar"])


def hardest(
    accuracy: pd.DataFrame, family: str, key: str, scalar: str, isa: str
) -> dict[str, float]:
    """Method → its largest error rate along the parameter of a family."""
    along = errors_along(accuracy, family, key, scalar, isa)
    worst = along.groupby("method")["error_rate"].max().to_dict() if len(along) else {}
    return {k: float(v) for k, v in worst.items() if not math.isnan(v)}
