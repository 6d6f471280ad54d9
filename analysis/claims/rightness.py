"""Claims about right and wrong answers: on the run's judged cells."""

from __future__ import annotations

from typing import Final

from analysis.accuracy.accuracy_tables import error_rates
from analysis.claims.evidence import (
    Evidence,
    Finding,
    at_widest,
    error_share,
    judged,
    not_measured,
    share_figure,
)
from analysis.report.wording import counted, grouped, listed, power_of_two, share
from analysis.speed.tables import parameter

EPSILON, CROSS = "epsilon", "cross_product_det"
DOUBLE_DOUBLE: Final = "double_double"
SOUND: Final = 511  # the range that is claimed, as a power of two
PROMOTED: Final = "promoted_f64"


def collinear_vertices(evidence: Evidence) -> Finding:
    """What methods answer where a text rules a case out."""
    rows = at_widest(evidence.run.accuracy, "f32")
    flat = rows[rows["family"] == "degenerate"]
    if not len(flat):
        return not_measured("triangles without area")
    wrong = flat.groupby("method")["false_inside"].sum().astype(int)
    asked = flat.groupby("method")["degenerate"].sum().astype(int)
    accepting = wrong[wrong > 0]
    why = (
        "Ruling the case out leaves it to the caller. Of "
        f"{counted(len(wrong), 'method')} asked about {grouped(int(asked.max()))} points "
        f"of triangles without area, {len(wrong) - len(accepting)} call none of them "
        f"inside and {len(accepting)} call some"
    )
    if len(accepting):
        worst = str((accepting / asked[accepting.index]).idxmax())
        rate = accepting[worst] / asked[worst]
        why += (
            f", {worst} most often ({share(rate)}). The triangles are exactly without "
            "area as the methods are given them, so what accepts is their own rounding or "
            "tolerance"
        )
    return Finding(
        judged(not len(accepting), len(accepting) < len(wrong)),
        f"{len(accepting)} of {len(wrong)} accept some",
        why + ".",
    )


def epsilon_makes_robust(evidence: Evidence) -> Finding:
    rows = at_widest(evidence.run.accuracy, "f32")
    hard = rows[~rows["family"].isin(["uniform", "special", "degenerate", "corpus"])]
    own, plain = (error_share(hard, method) for method in (EPSILON, CROSS))
    if own is None or plain is None:
        return not_measured(EPSILON)
    pooled = error_rates(hard[hard["method"] == EPSILON], ["family"])
    worst = pooled.loc[pooled["error_rate"].idxmax()]
    why = (
        f"On the hard scenes together it errs {share_figure(own)} of the time, {CROSS}, "
        f"the same test without a tolerance, {share_figure(plain)}. Worst in "
        f"{worst['family']} ({share(worst['error_rate'])}): a tolerance fits one size of "
        "triangle."
    )
    better = own.high < plain.low
    return Finding(judged(own.value == 0, better), share_figure(own) + " wrong", why)


def double_double_range(evidence: Evidence) -> Finding:
    """That the double-double test is right between 2^-511 and 2^511."""
    rows = at_widest(evidence.run.accuracy, "f64")
    own = rows[(rows["method"] == DOUBLE_DOUBLE) & (rows["family"] == "scale")]
    if not len(own):
        return not_measured(f"{DOUBLE_DOUBLE} at several scales")
    own = own.assign(exponent=parameter(own, "exponent").astype(float))
    rates = error_rates(own, ["exponent"])
    inside = rates[rates["exponent"].abs() <= SOUND]
    wrong_inside = inside[inside["wrong"] > 0]
    beyond = rates[(rates["exponent"].abs() > SOUND) & (rates["wrong"] > 0)]
    others = rows[
        (rows["method"] == DOUBLE_DOUBLE)
        & ~rows["family"].isin(["scale", "special", "degenerate", "corpus"])
    ]
    elsewhere = error_rates(others, ["family"])
    spoilt = elsewhere[elsewhere["wrong"] > 0]
    low, high = power_of_two(-SOUND), power_of_two(SOUND)
    why = (
        f"Scenes of size {listed([power_of_two(e) for e in inside['exponent']])}, within "
        f"{low} to {high}: {grouped(int(inside['wrong'].sum()))} of "
        f"{grouped(int(inside['of'].sum()))} answers wrong. "
    )
    if len(beyond):
        why += (
            f"Beyond, at {listed([power_of_two(e) for e in beyond['exponent']])}, "
            f"{share(beyond['wrong'].sum() / beyond['of'].sum())} are. "
        )
    if len(spoilt):
        words = [
            f"{row['family']} ({share(row['error_rate'])})"
            for row in spoilt.to_dict("records")
        ]
        why += (
            f"It also errs in {listed(words)}, where coordinates of very different size "
            "meet and the differences themselves round."
        )
    fine = not len(wrong_inside)
    return Finding(
        judged(fine and not len(spoilt), fine),
        f"{grouped(int(inside['wrong'].sum()))} wrong within, "
        f"{grouped(int(beyond['wrong'].sum()))} beyond",
        why.strip(),
    )


def promotion_is_exact(evidence: Evidence) -> Finding:
    rows = at_widest(evidence.run.accuracy, "f32")
    own = rows[rows["method"] == PROMOTED]
    if not len(own):
        return not_measured(PROMOTED)
    rates = error_rates(own, ["scene"])
    wrong = rates[rates["wrong"] > 0]
    total, of = int(rates["wrong"].sum()), int(rates["of"].sum())
    why = f"{PROMOTED}, over {counted(len(rates), 'scene')} of f32"
    if len(wrong):
        words = [
            f"{row['scene']} ({share(row['error_rate'])})"
            for row in wrong.to_dict("records")
        ]
        why += (
            f": wrong in {listed(words)}; right wherever no difference of two coordinates "
            "and no sum of their products needs more bits than a double has"
        )
    else:
        why += ": not one wrong answer"
    return Finding(
        judged(not len(wrong), len(wrong) < len(rates)),
        f"{grouped(total)} of {grouped(of)} wrong",
        why + ".",
    )


def normal_equations(evidence: Evidence) -> Finding:
    """That the normal equations solve the system, and at which cost."""
    accuracy = evidence.run.rays.accuracy
    rows = at_widest(accuracy, "f32", "one_triangle_rays")
    near = rows[rows["family"].isin(["rays_near_edge", "rays_needle"])]
    if not len(near):
        return not_measured("rays near an edge")
    own, other = (error_share(near, m) for m in ("plane_gram", "moller_trumbore"))
    if own is None or other is None:
        return not_measured("plane_gram")
    surely_more = own.low > other.high
    why = (
        "They do solve it: its answers are those of the other methods but for rounding. "
        f"Near edges and in needles plane_gram, which squares the edges, errs "
        f"{share_figure(own)} of the time, moller_trumbore {share_figure(other)}"
    )
    why += ": the price of the squares." if surely_more else ": no more than that one."
    return Finding(judged(not surely_more, True), share_figure(own) + " wrong", why)
