"""Which instruction sets a sweep holds, where it is to hold fewer than run here.

A run restricted to those of an older CPU shows what the same machine would do
without the newer ones; it says so in its sweep.json and in every filter.
"""

from __future__ import annotations

import dataclasses

from locks import Refusal
from run_folder import Shard

# Each with what code for it may use, narrowest first. A plain loop compiled
# for x86-64-v2, v3 or v4 needs SSE4, AVX2 or AVX-512.
_X86 = ("scalar", "ssse3", "sse4", "avx2", "avx512")
_ARM = ("scalar", "neon", "sve", "sve2")
_PLAIN_LOOPS = {"sse4": "autovec_v2", "avx2": "autovec_v3", "avx512": "autovec_v4"}
# Rows that are of no instruction set: calls into other libraries.
_LIBRARY = "library"


def up_to(isa: str) -> tuple[str, ...]:
    """The ISAs of the rows that a sweep up to `isa` holds. Raises Refusal."""
    for chain in (_X86, _ARM):
        if isa in chain:
            held = chain[: chain.index(isa) + 1]
            loops = [_PLAIN_LOOPS[each] for each in held if each in _PLAIN_LOOPS]
            return (*held, *loops)
    known = ", ".join(dict.fromkeys((*_X86, *_ARM)))
    raise Refusal(f"--isa-up-to {isa}: no such instruction set; there are {known}")


def restricted(shards: list[Shard], isa: str) -> list[Shard]:
    """The shards with only the rows of ISAs up to `isa`.

    Operations are counted in numbers of no ISA and stay. The maps are drawn by
    the widest kernels that run here, whatever a filter leaves, and are left
    out. Instructions are traced of those ISAs that the shard asks for and are
    not too wide, and of `isa`, the widest now.
    """
    held = up_to(isa)
    only = "(?=.*/(" + "|".join((*held, _LIBRARY)) + ")(/|$))"
    found = []
    for shard in shards:
        arguments = list(shard.arguments)
        if shard.kind == "maps":
            continue
        at = arguments.index("--filter") + 1
        if shard.kind == "instructions":
            of_isa = f"^one_triangle/.*/{isa}$"
            arguments[at] = f"^{_not_wider(isa)}.*({arguments[at]}|{of_isa})"
        elif shard.kind != "operations":
            arguments[at] = f"^{only}.*({arguments[at]})"
        found.append(dataclasses.replace(shard, arguments=tuple(arguments)))
    return found


def _not_wider(isa: str) -> str:
    """A pattern of all names but those of wider ISAs of the same CPUs. Loops
    of another architecture were never timed, and stay.
    """
    chain = _X86 if isa in _X86 else _ARM
    wider = [each for each in chain if each not in up_to(isa)]
    wider += [loop for each, loop in _PLAIN_LOOPS.items() if each in wider]
    return "(?!.*/(" + "|".join(wider) + ")$)" if wider else ""
