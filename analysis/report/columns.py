"""How the columns of the report's tables are shown."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from analysis.report import wording
from analysis.report.exhibits import Column
from analysis.report.wording import between, grouped, share, share_between, significant
from analysis.trust.row_noise import TOLERANCE

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


def near_interval(key: str, title: str, hint: str = "") -> Column:
    """The interval of a ratio near 1 or 2, where the third place matters."""

    def show(row: Row) -> str:
        return f"{row[f'{key}_low']:.3f} to {row[f'{key}_high']:.3f}"

    return Column(title, show, sort=f"{key}_low", hint=hint)


def noise_mark(title: str = "noise") -> Column:
    """Why the row is noisy; nothing where it is not."""
    within = f"±{100 * TOLERANCE:.0f} %"
    hint = f"wide: the interval leaves {within}"
    return Column(title, lambda row: str(row["noise"]), numeric=False, hint=hint)


def with_interval(key: str, title: str, hint: str = "") -> Column:
    """A ratio and its interval in one column."""

    def show(row: Row) -> str:
        return wording.with_interval(row[key], row[f"{key}_low"], row[f"{key}_high"])

    return Column(title, show, sort=key, hint=hint)


def above_interval(
    key: str,
    title: str,
    hint: str = "95 % interval below",
    marks_noise: bool = False,
) -> Column:
    """A number, and its interval as a note below it."""

    def note(row: Row) -> str:
        low, high = row[f"{key}_low"], row[f"{key}_high"]
        mark = ", noisy" if marks_noise and row["noise"] else ""
        return "" if low == high else between(low, high) + mark

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


def _share_if_known(key: str, title: str, hint: str) -> Column:
    """A share that older files do not tell."""

    def show(row: Row) -> str:
        return f"{100 * row[key]:.1f} %" if row[key] == row[key] else wording.NONE

    return Column(title, show, sort=key, hint=hint)


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
    noise_mark(),
    items("items/s"),
    with_interval("times_scalar", "× scalar", "over the scalar row of the same shard"),
    Column(
        "working set",
        lambda row: wording.size_in_bytes(row["working_set_bytes"]),
        sort="working_set_bytes",
    ),
)
ACCURACY = (
    word("family", "family"),
    word("loop", "loop"),
    word("method", "method"),
    word("scalar", "scalar"),
    whole("scenes", "scenes"),
    rate_with_interval("error_rate", "error rate"),
    whole("wrong", "wrong"),
    whole("of", "of"),
    whole("false_outside", "false outside"),
    whole("false_inside", "false inside"),
    part("boundary accepted", "boundary", "boundary_accepted"),
    number("smallest_ulps", "nearest error", "ulps from the boundary"),
    number("largest_ulps", "farthest error", "ulps from the boundary"),
)
VERDICTS = (
    word("method", "method"),
    above_interval("ns", "ns/point", marks_noise=True),
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
    noise_mark(),
    number("bytes_per_item", "bytes/item"),
    word("scene", "scene"),
)
GRID = (
    word("track", "given as"),
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    number("ns", "ns/triangle"),
    interval("ns", "interval"),
    number("pixel_ns", "ns/pixel"),
    noise_mark(),
    with_interval("times_points", "× i32 points", "same ISA, same shard"),
    sentence("writes", "writes"),
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
    ratio("smallest_doubled", "smallest 2× ratio"),
    ratio("largest_doubled", "largest 2× ratio"),
    Column(
        "noisy rows",
        lambda row: f"{row['noisy_rows']} of {row['rows']}",
        sort="noisy_rows",
    ),
    number("clock_before_ghz", "clock in the first half, GHz"),
    number("clock_after_ghz", "in the second, GHz"),
    percent("clock_drift", "drift"),
    _share_if_known(
        "quiet_share",
        "quiet",
        "of its slices: nobody else used the core before and after",
    ),
    Column("stolen", lambda row: f"{row['steal_percent']:.2f} %", sort="steal_percent"),
    _share_if_known("cpu_share", "had its CPU", "of the time"),
    number("preemptions", "interruptions", "how often the CPU was taken from it"),
    Column("load", lambda row: f"{row['load_average']:.2f}", sort="load_average"),
    Column(
        "width of an interval",
        lambda row: f"{100 * row['interval_width']:.2f} %",
        sort="interval_width",
        hint="median over the shard's cells, of the median",
    ),
)


def break_even(item: str) -> tuple[Column, ...]:
    return (
        word("scalar", "scalar"),
        word("isa", "ISA"),
        word("method", "method"),
        word("against", "against"),
        Column(
            "pays from n",
            lambda row: str(row["words"]),
            sort="break_even",
            hint=f"{item}s a call; in brackets the timed numbers that it lies between, "
            "as far as the ratios' intervals tell; never: at no timed number",
        ),
        with_interval("worst", "ratio at its worst before"),
        whole("worst_n", "at n"),
        with_interval("best", "at its best"),
        whole("best_n", "at n"),
        with_interval("most", f"for the most {item}s"),
    )


def early_out(item: str, inside: str) -> tuple[Column, ...]:
    return (
        word("scalar", "scalar"),
        word("isa", "ISA"),
        word("sets", "input"),
        Column(f"{inside}, %", lambda row: f"{row['hit']:g}", sort="hit"),
        number("ns", f"ns/{item}"),
        with_interval("over_plain", "× without", "over the same without a way out"),
    )


BREAK_EVEN = break_even("point")
EARLY_OUT = early_out("point", "inside")
THREADS = (
    word("method", "method"),
    word("scalar", "scalar"),
    word("isa", "ISA"),
    Column(
        "a call reads",
        lambda row: wording.size_in_bytes(row["working_set_bytes"]),
        sort="working_set_bytes",
    ),
    word("home", "from"),
    whole("threads", "CPUs"),
    number("ns", "ns/point"),
    with_interval("speed_up", "× one CPU"),
    Column(
        "GB/s",
        lambda row: significant(row["bandwidth"] / 1e9),
        lambda row: between(row["bandwidth_low"] / 1e9, row["bandwidth_high"] / 1e9),
        "bandwidth",
        hint="bytes of points read a second; 95 % interval below",
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
