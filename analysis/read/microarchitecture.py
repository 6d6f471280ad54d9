"""Which design a CPU is of, by the numbers with which it identifies itself.

Names do not tell: virtual machines give CPUs of different designs the same one.
Numbers of x86-64 are from Linux (arch/x86/kernel/cpu/amd.c, intel-family.h), of
arm64 from util-linux (sys-utils/lscpu-arm.c).
"""

from __future__ import annotations

from typing import Any, Final

_Models = tuple[range | int, ...]

# (vendor, family) → designs and the model numbers of each.
_DESIGNS: Final[dict[tuple[str, int], dict[str, _Models]]] = {
    ("AuthenticAMD", 23): {
        "Zen": (range(0x30), range(0x50, 0x60)),
        "Zen 2": (
            range(0x30, 0x50),
            range(0x60, 0x80),
            range(0x90, 0x92),
            range(0xA0, 0xB0),
        ),
    },
    ("AuthenticAMD", 25): {
        "Zen 3": (range(0x10), range(0x20, 0x60)),
        "Zen 4": (range(0x10, 0x20), range(0x60, 0xB0)),
    },
    ("AuthenticAMD", 26): {
        "Zen 5": (range(0x30), range(0x40, 0x50), range(0x60, 0x80)),
    },
    ("GenuineIntel", 6): {
        "Haswell": (0x3C, 0x3F, 0x45, 0x46),
        "Broadwell": (0x3D, 0x47, 0x4F, 0x56),
        "Skylake": (0x4E, 0x5E),
        "Skylake server": (0x55,),
        "Kaby Lake": (0x8E, 0x9E),
        "Comet Lake": (0xA5, 0xA6),
        "Ice Lake": (0x7D, 0x7E),
        "Ice Lake server": (0x6A, 0x6C),
        "Tiger Lake": (0x8C, 0x8D),
        "Rocket Lake": (0xA7,),
        "Alder Lake": (0x97, 0x9A),
        "Raptor Lake": (0xB7, 0xBA, 0xBF),
        "Meteor Lake": (0xAA, 0xAC),
        "Lunar Lake": (0xBD,),
        "Arrow Lake": (0xC5, 0xC6),
        "Sapphire Rapids": (0x8F,),
        "Emerald Rapids": (0xCF,),
        "Granite Rapids": (0xAD, 0xAE),
    },
    ("0x41", 8): {
        "Cortex-A72": (0xD08,),
        "Cortex-A76": (0xD0B,),
        "Neoverse N1": (0xD0C,),
        "Neoverse V1": (0xD40,),
        "Neoverse N2": (0xD49,),
        "Neoverse V2": (0xD4F,),
        "Neoverse V3": (0xD84,),
        "Neoverse N3": (0xD8E,),
    },
}
# Later steppings of a design that have a name of their own: the first of each.
_STEPPINGS: Final = {"Skylake server": {5: "Cascade Lake", 10: "Cooper Lake"}}


def design(identity: dict[str, Any] | None) -> str:
    """The design of a CPU by `cpu.identity` of its machine.json; empty where it
    is not told or not known.
    """
    if identity is None:
        return ""
    designs = _DESIGNS.get((identity["vendor"], identity["family"]), {})
    for name, models in designs.items():
        if any(_holds(own, identity["model"]) for own in models):
            for first, later in _STEPPINGS.get(name, {}).items():
                name = later if identity["stepping"] >= first else name
            return name
    return ""


def _holds(models: range | int, model: int) -> bool:
    return model == models if isinstance(models, int) else model in models


def identity_words(identity: dict[str, Any] | None) -> str:
    """`AuthenticAMD family 25, model 1, stepping 1`; empty where not told."""
    if identity is None:
        return ""
    return (
        f"{identity['vendor']} family {identity['family']}, model "
        f"{identity['model']}, stepping {identity['stepping']}"
    )
