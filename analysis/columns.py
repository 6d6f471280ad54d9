"""How the columns of the report's tables are shown."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from analysis import wording
from analysis.exhibits import Column
from analysis.wording import between, grouped, share, share_between, significant

Row = dict[str, Any]


def word(key: str, title: str) -> Column:
    return Column(title, lambda row: str(row[key]), numeric=False)


def sentence(key: str, title: str) -> Column:
    return Column(title, lambda row: str(row[key]), numeric=False, wraps=True)


def number(key: str, title: str, hint: str = "") -> Column:
    return Column(title, lambda row: significant(row[key]), sort=key, hint=hint)


def ratio(key: str, title: str) -> Column:
    """A ratio near 1, where the third place matters."""

    def show(row: Row) -> str:
        return f"{row[key]:.3f}" if row[key] == row[key] else wording.NONE

    return Column(title, show, sort=key)


def whole(key: str, title: str) -> Column:
    return Column(title, lambda row: grouped(int(row[key])), sort=key)


def interval(key: str, title: str, hint: str = "95 % interval") -> Column:
    """The interval of the column `key`, sorted by its lower end."""
    return Column(
        title,
        lambda row: between(row[f"{key}_low"], row[f"{key}_high"]),
        sort=f"{key}_low",
        hint=hint,
    )


def with_interval(key: str, title: str, hint: str = "") -> Column:
    """A ratio and its interval in one column."""

    def show(row: Row) -> str:
        return wording.with_interval(row[key], row[f"{key}_low"], row[f"{key}_high"])

    return Column(title, show, sort=key, hint=hint)


def above_interval(key: str, title: str, hint: str = "95 % interval below") -> Column:
    """A number, and its interval as a note below it."""

    def note(row: Row) -> str:
        low, high = row[f"{key}_low"], row[f"{key}_high"]
        return "" if low == high else between(low, high)

    return Column(title, lambda row: significant(row[key]), note, key, hint=hint)


def rate_above_interval(key: str, title: str) -> Column:
    """A share, and its Wilson interval as a note below it."""

    def note(row: Row) -> str:
        if row[key] != row[key]:
            return ""
        return share_between(row[f"{key}_low"], row[f"{key}_high"])

    hint = "Wilson interval, 95 %, below"
    return Column(title, lambda row: share(row[key]), note, key, hint=hint)


def rate(key: str, title: str, hint: str = "") -> Column:
    return Column(title, lambda row: share(row[key]), sort=key, hint=hint)


def rate_with_interval(key: str, title: str) -> Column:
    def show(row: Row) -> str:
        if row[key] != row[key]:
            return wording.NONE
        return f"{share(row[key])} ({share_between(row[f'{key}_low'], row[f'{key}_high'])})"

    return Column(title, show, sort=key, hint="Wilson interval, 95 %")


def percent(key: str, title: str, hint: str = "") -> Column:
    return Column(title, lambda row: f"{100 * row[key]:+.2f} %", sort=key, hint=hint)


def part(title: str, of: str, key: str) -> Column:
    """`key` as a share of `of`."""

    def show(row: Row) -> str:
        return share(row[key] / row[of]) if row[of] else wording.NONE

    return Column(title, show, sort=key)


def items(title: str) -> Column:
    show: Callable[[Row], str] = lambda row: wording.rate_of_items(
        row["items_per_second"]
    )
    return Column(title, show, sort="items_per_second")


PLACE = (
    word("loop", "loop"),
    word("scene", "scene"),
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
)
CELLS = (
    *PLACE,
    number("ns", "ns/item"),
    interval("ns", "interval"),
    items("items/s"),
    with_interval("times_scalar", "× scalar", "over the scalar row of the same shard"),
    Column(
        "working set",
        lambda row: wording.size_in_bytes(row["working_set_bytes"]),
        sort="working_set_bytes",
    ),
)
ACCURACY = (
    *PLACE[:-1],
    rate_with_interval("error_rate", "error rate"),
    whole("wrong", "wrong"),
    whole("of", "of"),
    whole("false_outside", "false outside"),
    whole("false_inside", "false inside"),
    part("boundary accepted", "boundary", "boundary_accepted"),
    number("smallest_ulps", "nearest error", "ulps from the boundary"),
    number("largest_ulps", "farthest error", "ulps from the boundary"),
    word("isa", "ISAs"),
)
VERDICTS = (
    word("method", "method"),
    above_interval("ns", "ns/point"),
    above_interval("time_over_best", "× the fastest"),
    rate_above_interval("error_rate", "errors near an edge"),
    rate("worst_needle", "needles, worst"),
    rate("worst_offset", "far away, worst"),
    sentence("verdict", "verdict"),
)
FIXED = (
    *PLACE,
    with_interval("fresh_over_fixed", "fresh ÷ fixed"),
    number("ns", "ns/item, fixed"),
)
LOOPS = (
    word("method", "method"),
    word("loop", "loop"),
    word("isa", "ISA"),
    number("ns", "ns/item"),
    interval("ns", "interval"),
    number("bytes_per_item", "bytes/item"),
    word("scene", "scene"),
)
GRID = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    word("scene", "scene"),
    number("ns", "ns/triangle"),
    interval("ns", "interval"),
    items("triangles/s"),
    with_interval("times_scalar", "× scalar"),
)
WEIGHTS = (
    word("family", "scenes"),
    word("scalar", "scalar"),
    word("method", "method"),
    number("largest_ulps", "largest error, ulps"),
    number("mean_ulps", "mean error, ulps"),
    number(
        "largest_forward_ulps",
        "largest forward error, ulps",
        "of the point that the weights give, in ulps of its larger coordinate",
    ),
    number("mean_forward_ulps", "mean forward error, ulps"),
    whole("not_finite", "not finite"),
    whole("points", "points"),
)
WEIGHTS_COST = (
    *PLACE,
    number("ns", "ns/item"),
    with_interval("weights_over_bits", "× without weights"),
)
REFUSED = (*PLACE, sentence("reason", "why it was not timed"))
SHARDS = (
    word("shard", "shard"),
    word("verdict", "verdict"),
    whole("pairs", "A/A pairs"),
    ratio("smallest_ratio", "smallest A/A ratio"),
    ratio("largest_ratio", "largest A/A ratio"),
    number("clock_before_ghz", "clock before, GHz"),
    number("clock_after_ghz", "after, GHz"),
    percent("clock_drift", "drift"),
    Column("stolen", lambda row: f"{row['steal_percent']:.2f} %", sort="steal_percent"),
    Column("load", lambda row: f"{row['load_average']:.2f}", sort="load_average"),
    Column(
        "width of an interval",
        lambda row: f"{100 * row['interval_width']:.2f} %",
        sort="interval_width",
        hint="median over the shard's cells, of the median",
    ),
)
WORST = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("kind", "answer"),
    number("distance_ulps", "ulps from the boundary"),
    word("scene", "scene"),
    word("a", "a"),
    word("b", "b"),
    word("c", "c"),
    word("p", "p"),
    word("isa", "ISAs"),
)
FLAGS = (
    sentence("source", "source"),
    word("isas", "for"),
    sentence("flags", "flags"),
)
