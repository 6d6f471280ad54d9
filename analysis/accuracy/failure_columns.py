"""How the columns of the tables of failures are shown."""

from __future__ import annotations

import dataclasses
from typing import Any

from analysis.accuracy.overview import POOLED_CLASSES, WRONG_ANSWERS
from analysis.charts import ramp
from analysis.report import wording
from analysis.report.columns import number, sentence, whole, with_interval, word
from analysis.report.exhibits import Column
from analysis.report.wording import (
    grouped,
    share,
    share_between,
    short_count,
    short_share,
)

Row = dict[str, Any]


def failure_rate(key: str, title: str, hint: str = "") -> Column:
    """A rate that is coloured, "0 of N" where there is no failure, with count
    and interval for those who point at it. A dash: not measured.
    """

    def note(row: Row) -> str:
        nothing = row[f"{key}_of"] and not row[f"{key}_count"]
        return f"of {short_count(row[f'{key}_of'])}" if nothing else ""

    return Column(
        title,
        lambda row: short_share(row[key]),
        note,
        sort=key,
        hint=hint,
        tint=lambda row: _tint(row, key),
        tip=lambda row: _tip(row, key),
    )


def wrong_answers(key: str, title: str) -> Column:
    """The rate of false inside over that of false outside, each in its colour;
    as failure_rate() where there is neither.
    """
    plain = failure_rate(key, title, "false inside over false outside")
    inside, outside = f"{key}_inside", f"{key}_outside"

    def note(row: Row) -> str:
        if row[f"{key}_count"]:
            return short_share(row[outside])
        return plain.note(row) if plain.note else ""

    def tint(row: Row) -> str:
        if not row[f"{key}_count"]:
            return _tint(row, key)
        return f"{_tint(row, inside)} under-{_tint(row, outside) or 'unknown'}".strip()

    def tip(row: Row) -> str:
        if not row[f"{key}_count"]:
            return _tip(row, key)
        return f"false inside: {_tip(row, inside)}; outside: {_tip(row, outside)}"

    def show(row: Row) -> str:
        return short_share(row[inside] if row[f"{key}_count"] else row[key])

    return dataclasses.replace(plain, show=show, note=note, tint=tint, tip=tip)


def _tint(row: Row, key: str) -> str:
    if not row[f"{key}_of"]:
        return ""
    if not row[f"{key}_count"]:
        return "rate-none"
    return f"rate{ramp.level(row[key])}"


def _tip(row: Row, key: str) -> str:
    count, of = row[f"{key}_count"], row[f"{key}_of"]
    if not of:
        return "not measured"
    ends = share_between(row[f"{key}_low"], row[f"{key}_high"])
    by_rule = row.get(f"{key}_by_rule", 0)
    more = f"; {grouped(by_rule)} more by its boundary rule" if by_rule else ""
    return f"{grouped(count)} of {grouped(of)}: {share(row[key])} ({ends}){more}"


def _boundary(row: Row) -> str:
    if row["boundary_of"]:
        return short_share(row["boundary"])
    return str(row["boundary_rule"]).replace("_", "-")


def _boundary_tip(row: Row) -> str:
    said = f"{str(row['boundary_rule']).replace('_', '-')}; accepted: "
    return said + _tip(row, "boundary_accepted")


_BOUNDARY = failure_rate("boundary", "boundary rule broken")

OVERVIEW = (
    Column(
        "method",
        lambda row: str(row["method"]),
        numeric=False,
        tip=lambda row: f"on {row['isa']}",
    ),
    *(wrong_answers(key, title) for key, title, _ in WRONG_ANSWERS),
    failure_rate("degenerate", "flat triangle accepted"),
    Column(
        _BOUNDARY.title,
        _boundary,
        _BOUNDARY.note,
        sort="boundary",
        hint="closed rejects, or open accepts; else the rule",
        tint=_BOUNDARY.tint,
        tip=_boundary_tip,
    ),
    *(failure_rate(key, title) for key, title, _ in POOLED_CLASSES),
)

FLAGS_AXIS = (
    Column(
        "method",
        lambda row: f"{row['method']}{' ⚠' if row['warning'] else ''}",
        numeric=False,
        tint=lambda row: "warned" if row["warning"] else "",
        tip=lambda row: str(row["warning"]),
    ),
    word("base", "beside"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    failure_rate("base_error", "errors near an edge: without"),
    failure_rate("error", "with"),
    failure_rate("base_hole", "holes: without"),
    failure_rate("hole", "with"),
    failure_rate("base_double_hit", "double hits: without"),
    failure_rate("double_hit", "with"),
    with_interval("time", "time: with ÷ without"),
)
_AT_MOST = Column(
    "at most, 95 %",
    lambda row: wording.share(row["error_rate_high"]),
    sort="error_rate_high",
    hint="upper end of the Wilson interval of the points",
)
EXACT_ERRORS = (
    word("method", "method"),
    word("scalar", "scalar"),
    whole("scenes", "scenes"),
    whole("isas", "ISAs"),
    whole("wrong", "wrong answers"),
    whole("of", "of answers"),
    whole("points", "to points"),
    _AT_MOST,
    whole("holes", "holes"),
    whole("double_hits", "double hits"),
    whole("queries", "of queries on meshes"),
)
VERIFIED = (
    word("method", "method"),
    word("scalar", "scalar"),
    whole("wrong", "wrong answers"),
    whole("answers", "of answers"),
    whole("points", "to points"),
    whole("boundary_points", "of them on a boundary"),
    _AT_MOST,
    sentence("isas", "ISAs"),
    sentence("loops", "loops"),
    word("kernels", "kernels"),
    number("truth_per_second", "judged a second", "points, by truth on one CPU"),
)
EXACT_SPEED = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    word("scene", "scene"),
    number("ns", "ns/point"),
    with_interval("of_edge", "throughput ÷ edge_function_fma"),
    with_interval("of_fastest", "throughput ÷ fastest inexact"),
    word("fastest", "the fastest inexact"),
)
EXACT_WORST = (
    word("scalar", "scalar"),
    word("isa", "ISA"),
    word("points", "points"),
    with_interval("ns", "ns/point"),
    with_interval("times_edge", "time ÷ edge_function_fma"),
)
TWO_TRUTHS = (
    word("id", "case"),
    word("scalar", "scalar"),
    word("binary", "of the binary numbers"),
    word("decimal", "of the decimals typed"),
    word("differ", "the two"),
    sentence("source", "from"),
)
