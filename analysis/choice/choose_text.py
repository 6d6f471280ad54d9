"""A choice in words, and as data."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import Any

from analysis.choice.choose import CLOSED, Choice, Option, slower
from analysis.choice.choose_times import MANY
from analysis.choice.error_bounds import Bound, bound
from analysis.choice.error_families import EPSILON
from analysis.choice.extent import DIGITS
from analysis.report.wording import (
    between,
    counted,
    listed,
    nanoseconds,
    power_of_two,
    share,
    share_between,
    significant,
    times,
)


def lines(choice: Choice) -> list[str]:
    """The answer as it is printed."""
    return [line.replace("\u00a0", " ").replace("\u202f", " ") for line in _all(choice)]


def _all(choice: Choice) -> Iterator[str]:
    yield _headline(choice)
    if choice.chosen is None:
        yield from _indented(reasons(choice))
        return
    yield f"  guarantee  {guarantee(choice)}"
    yield f"  speed      {speed(choice)}"
    yield f"  measured   {errors(choice)}"
    if choice.runners_up:
        yield "  next       " + "\n             ".join(runners_up(choice))
    yield from _indented(reasons(choice))


def _headline(choice: Choice) -> str:
    if choice.chosen is None:
        return "No method of this run is right for this scene."
    take = f"Take {kernel(choice.chosen)}"
    if choice.weigher is not None:
        take += f" to decide, and {kernel(choice.weigher)} for the weights"
    return take + "."


def _indented(sentences: tuple[str, ...]) -> Iterator[str]:
    head = "  because    "
    for sentence in sentences:
        yield head + sentence
        head = " " * len(head)


def kernel(option: Option) -> str:
    """cross_product (f32, one_triangle, avx2)"""
    timing = option.timing
    return f"{option.name} ({timing.scalar}, {timing.loop}, {timing.isa})"


def distance(bound: Bound) -> str:
    """The bound as a column has it."""
    if bound.exact:
        return "exact"
    return significant(bound.distance) if bound.known else "none"


def guarantee(choice: Choice) -> str:
    """What holds for every triangle and point that the scene allows."""
    chosen = choice.chosen
    assert chosen is not None
    if chosen.bound.exact:
        text = f"exact {chosen.bound.why}; the boundary is {_rule(chosen)}"
    else:
        text = (
            f"right for every point farther than {significant(chosen.bound.distance)} "
            f"from an edge ({chosen.bound.why}, {symbols(choice)})"
        )
    weighs = choice.weigher or chosen
    if choice.scene.need == "weights" and math.isfinite(weighs.weights):
        text += (
            f"; weights of points inside within {significant(weighs.weights)} of the "
            "exact ones"
        )
    return text


def symbols(choice: Choice) -> str:
    """What the letters of a formula stand for here."""
    chosen, scene = choice.chosen, choice.scene
    assert chosen is not None
    name = chosen.name
    extent = max(reversed(scene.extents()), key=lambda e: bound(name, e).distance)
    values = {
        "u": power_of_two(-DIGITS[extent.scalar]),
        "L": significant(extent.longest),
        "h": significant(extent.altitude),
        "M": significant(extent.largest),
        "ε": significant(EPSILON[extent.scalar]),
    }
    formula = chosen.bound.why
    return ", ".join(f"{k} = {v}" for k, v in values.items() if k in formula)


def _rule(option: Option) -> str:
    words = {
        CLOSED: "included",
        "open": "left out",
        "top_left": "shared out by the top-left rule",
        "half_open": "included but for edge BC and its corners",
    }
    return words.get(option.boundary, option.boundary.replace("_", "-"))


def speed(choice: Choice) -> str:
    chosen = choice.chosen
    assert chosen is not None
    text = _time(chosen)
    if choice.weigher is not None:
        text += f", and {_time(choice.weigher)} with weights: {nanoseconds(choice.ns)}"
    return text


def _time(option: Option) -> str:
    timing = option.timing
    low, high = timing.interval
    text = f"{nanoseconds(timing.ns)} a point"
    if low < high:
        text += f" ({between(low, high)})"
    if timing.estimated:
        text += f", estimated from {timing.scene} and the time of a set-up"
    else:
        text += f", timed on {timing.scene}"
    return text + (", noisy" if timing.noise else "")


def errors(choice: Choice) -> str:
    """What the run found the method to be wrong on."""
    if not choice.measured:
        return "its answers were not judged in this run"
    return "on the hard input of the run, wrong " + "; ".join(
        f"on {share(it.rate) if it.rate else 'none'} {_where(it.where)}"
        f" ({share_between(it.low, it.high)})"
        for it in choice.measured
    )


def _where(where: str) -> str:
    return where if where.startswith(("near", "on")) else f"at {where}"


def runners_up(choice: Choice) -> list[str]:
    assert choice.chosen is not None
    return [
        f"{kernel(option)}: {nanoseconds(option.ns)}, {_times_as_long(option, choice)}, "
        + (
            "exact"
            if option.bound.exact
            else f"right beyond {significant(option.bound.distance)}"
        )
        for option in choice.runners_up
    ]


def _times_as_long(option: Option, choice: Choice) -> str:
    assert choice.chosen is not None
    ratio = slower(option, choice.chosen)
    if choice.as_fast(option):
        return "as fast as far as can be told"
    return f"{times(ratio.value)} as long"


def reasons(choice: Choice) -> tuple[str, ...]:
    """Three sentences: why it is right, why it is the cheapest, and what a
    cheaper or an inexact one would do.
    """
    if choice.chosen is None:
        return _no_reasons(choice)
    return (_why_right(choice), _why_cheapest(choice), _why_not_less(choice))


def _no_reasons(choice: Choice) -> tuple[str, ...]:
    scene = choice.scene
    if not choice.candidates:
        how = "a point against many triangles" if scene.points < 1 else "these points"
        return (
            f"No kernel for {how} in {scene.scalar} was timed in this run"
            f"{' that writes weights' if scene.need == 'weights' else ''}.",
            "Give another --scalar, --need or --isa, or a run that has one.",
        )
    return (
        f"None of {counted(choice.candidates, 'method')} that could answer is right "
        f"here: {_asked(choice)}.",
        _nearest(choice),
        "Take an exact method in a scalar that holds the coordinates, or allow a "
        "--tolerance.",
    )


def _asked(choice: Choice) -> str:
    scene = choice.scene
    if scene.need == "watertight":
        return (
            "every point of a mesh has to be in exactly one of its triangles, which "
            "takes exact answers by the top-left rule"
        )
    if scene.tolerance > 0:
        return (
            "answers may be wrong only within "
            f"{significant(scene.tolerance)} of an edge"
        )
    return "no wrong answer is allowed, however near to an edge"


def _why_right(choice: Choice) -> str:
    chosen = choice.chosen
    assert chosen is not None
    if not chosen.bound.exact:
        return (
            f"Right: {chosen.bound.why} is {significant(chosen.bound.distance)} for "
            f"these triangles, within the tolerance of "
            f"{significant(choice.scene.tolerance)}."
        )
    text = f"Right: {_asked(choice)}, and it is exact {chosen.bound.why}."
    if choice.weigher is not None:
        text += " No method that gives weights is right here by itself."
    return text


def _why_cheapest(choice: Choice) -> str:
    chosen = choice.chosen
    assert chosen is not None
    text = f"Cheapest of {counted(choice.right, 'method')} that are right here"
    if choice.right == 1:
        text = "The only method that is right here"
    alike = [o.name for o in choice.runners_up if choice.as_fast(o)]
    if alike:
        text += f", with {listed(alike)} as fast as far as can be told"
    points = choice.scene.points
    if choice.scene.grid is None and 1 <= points < MANY:
        text += f", at {counted(round(points), 'point')} a triangle"
    return text + "."


def _why_not_less(choice: Choice) -> str:
    inexact = choice.best_inexact
    if choice.nothing_inexact_is_safe and choice.scene.tolerance == 0:
        none = "Nothing that rounds is safe here"
        return f"{none}: {_nearest(choice)}" if inexact else f"{none}."
    if choice.nearly is None:
        return "Nothing that takes less time was measured."
    bound = choice.nearly.bound
    reach = (
        f"it may be wrong up to {significant(bound.distance)} from an edge"
        if bound.known
        else bound.why
    )
    return (
        f"Less time takes {choice.nearly.name} ({nanoseconds(choice.nearly.ns)}), "
        f"but {reach}."
    )


def _nearest(choice: Choice) -> str:
    inexact = choice.best_inexact
    if inexact is None:
        return "No method that rounds could answer."
    if not inexact.bound.known:
        return f"no bound holds ({inexact.name}: {inexact.bound.why})."
    return (
        f"the least that is proved is of {inexact.name}, right beyond "
        f"{significant(inexact.bound.distance)} from an edge."
    )


def document(choice: Choice, run: str, command: str) -> dict[str, Any]:
    """The answer as JSON."""
    scene = choice.scene
    return {
        "schema": "pitbench-choice-1",
        "run": run,
        "command": command,
        "scene": {
            "scalar": scene.scalar,
            "coordinates": [scene.low, scene.high],
            "altitude": scene.altitude,
            "edges": list(scene.edges),
            "points_per_triangle": scene.points,
            "hit_rate": scene.hit,
            "grid": list(scene.grid) if scene.grid else None,
            "need": scene.need,
            "precision": scene.precision,
            "tolerance": scene.tolerance,
        },
        "chosen": _option_document(choice.chosen),
        "weights_from": _option_document(choice.weigher),
        "ns": None if math.isnan(choice.ns) else choice.ns,
        "runners_up": [_option_document(option) for option in choice.runners_up],
        "nothing_inexact_is_safe": choice.nothing_inexact_is_safe,
        "measured_errors": [
            {"where": it.where, "rate": it.rate, "low": it.low, "high": it.high}
            for it in choice.measured
        ],
        "reasons": list(reasons(choice)),
    }


def _option_document(option: Option | None) -> dict[str, Any] | None:
    if option is None:
        return None
    timing = option.timing
    low, high = timing.interval
    finite = math.isfinite(option.bound.distance)
    return {
        "method": option.name,
        "scalar": timing.scalar,
        "loop": timing.loop,
        "isa": timing.isa,
        "boundary": option.boundary,
        "ns": timing.ns,
        "ns_low": low,
        "ns_high": high,
        "timed_on": timing.scene,
        "estimated": timing.estimated,
        "noisy": timing.noise,
        "exact": option.bound.exact,
        "right_beyond": option.bound.distance if finite else None,
        "why": option.bound.why,
        "weights_within": option.weights if math.isfinite(option.weights) else None,
    }
