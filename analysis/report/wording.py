"""Numbers as people read them. Pure functions from numbers to text."""

from __future__ import annotations

import math
from collections.abc import Sequence

NONE = "–"

# Between a number and its unit, so that no line ends there.
JOIN = "\u00a0"


def significant(value: float, digits: int = 3) -> str:
    """`value` rounded to so many digits; with a power of ten only where the
    digits alone could not be read.
    """
    if not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    if not 1e-4 <= abs(value) < 1e7:
        mantissa, exponent = f"{value:.{digits - 1}e}".split("e")
        return f"{mantissa}·{power(10, int(exponent))}"
    places = digits - 1 - math.floor(math.log10(abs(value)))
    rounded = round(value, places)
    if rounded and math.floor(math.log10(abs(rounded))) > digits - 1 - places:
        places -= 1  # 9.999 became 10.00, which has a digit too many
    text = f"{rounded:.{max(places, 0)}f}"
    return grouped(int(rounded)) if places <= 0 else text


def grouped(value: int) -> str:
    """1234567 → 1 234 567, with spaces that do not break; 4096 stays whole."""
    if abs(value) < 10_000:
        return str(value)
    return f"{value:,}".replace(",", "\u202f")


def nanoseconds(value: float) -> str:
    return f"{significant(value)}{JOIN}ns"


def duration(seconds: float) -> str:
    """In seconds up to ten minutes, in minutes above."""
    if seconds <= 600:
        return f"{significant(seconds)}{JOIN}s"
    return f"{significant(seconds / 60)}{JOIN}min"


def rate_of_items(per_second: float) -> str:
    """12.3e9 → 12.3 G/s."""
    for unit, size in (("G", 1e9), ("M", 1e6), ("k", 1e3)):
        if per_second >= size:
            return f"{significant(per_second / size)}{JOIN}{unit}/s"
    return f"{significant(per_second)}{JOIN}/s"


def share(value: float) -> str:
    """A share as % where that reads well, else in a million."""
    if not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    if value >= 0.001:
        return f"{significant(100 * value)}{JOIN}%"
    return significant(1e6 * value) + " in a million"


def share_between(low: float, high: float) -> str:
    """A range of shares in one unit."""
    if high >= 0.001:
        return f"{significant(100 * low)} to {significant(100 * high)}{JOIN}%"
    return f"{significant(1e6 * low)} to {significant(1e6 * high)} in a million"


def short_share(value: float) -> str:
    """A share in a narrow column: 12 %, 0.34 %, 56 ppm."""
    if not math.isfinite(value):
        return NONE
    if value == 0:
        return "0"
    if value >= 0.001:
        return f"{significant(100 * value, 2 if value < 0.995 else 3)}{JOIN}%"
    return f"{significant(1e6 * value, 2)}{JOIN}ppm"


def short_count(count: int) -> str:
    """950 · 12 k · 3.4 M."""
    for unit, size in (("G", 10**9), ("M", 10**6), ("k", 10**3)):
        if count >= size:
            digits = 3 if count >= 100 * size else 2
            return f"{significant(count / size, digits)}{JOIN}{unit}"
    return str(count)


def times(value: float) -> str:
    return f"{significant(value)}{JOIN}×"


def between(low: float, high: float) -> str:
    """An interval, with as many places in both ends as the finer one needs."""
    if not (math.isfinite(low) and math.isfinite(high)):
        return NONE
    if low <= 0:
        return f"{significant(low)} to {significant(high)}"
    places = max(2 - math.floor(math.log10(low)), 0)
    if places == 0:
        return f"{grouped(round(low))} to {grouped(round(high))}"
    return f"{low:.{places}f} to {high:.{places}f}"


def with_interval(value: float, low: float, high: float) -> str:
    """2.477 in [2.468, 2.499] → 2.48 (2.47 to 2.50); a ratio of a thing to
    itself, which has no interval, as it is.
    """
    if not math.isfinite(value):
        return NONE
    if low == high:
        return significant(value, 1)
    places = max(2 - math.floor(math.log10(low)), 0) if low > 0 else 2
    ends = between(low, high)
    return f"{significant(value) if places == 0 else f'{value:.{places}f}'} ({ends})"


def spoken(count: float) -> str:
    """20.7e9 → 20.7 billion."""
    for word, size in (("billion", 1e9), ("million", 1e6)):
        if count >= size:
            return f"{significant(count / size)} {word}"
    return grouped(round(count))


def size_in_bytes(value: float) -> str:
    for unit, size in (("GiB", 2**30), ("MiB", 2**20), ("KiB", 2**10)):
        if value >= size:
            return f"{significant(value / size)}{JOIN}{unit}"
    return f"{significant(value)}{JOIN}B"


def plain(value: float) -> str:
    """A parameter of a scene as it was written: 4, 0.5."""
    return f"{value:g}"


def power_of_two(exponent: float) -> str:
    """-12 → 2⁻¹²."""
    return power(2, exponent)


def power(base: int, exponent: float) -> str:
    """With the digits that stand above the line."""
    raised = f"{exponent:g}".translate(str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"))
    return f"{base}{raised}"


def listed(words: Sequence[str]) -> str:
    """a · a and b · a, b and c."""
    if len(words) <= 1:
        return "".join(words)
    return ", ".join(words[:-1]) + " and " + words[-1]


def counted(count: int, one: str, many: str | None = None) -> str:
    """1 shard · 2 shards."""
    return f"{grouped(count)} {one if count == 1 else (many or one + 's')}"
