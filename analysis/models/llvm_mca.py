"""What llvm-mca makes of a compiled loop: the cycles that it would take on
another CPU, by LLVM's description of that CPU. A model, not a measurement.

llvm-mca and llvm-mc are Debian's llvm-19. Without them nothing is modelled.
"""

from __future__ import annotations

import dataclasses
import json
import shutil
import subprocess
from collections.abc import Mapping, Sequence
from typing import Final

import pandas as pd

# LLVM's name of a CPU → the instruction set whose loop it is given: the widest
# that it has. Their loops are of x86-64 and so are these CPUs.
MODELS: Final = {
    "skylake-avx512": "avx512",
    "icelake-server": "avx512",
    "sapphirerapids": "avx512",
    "znver3": "avx2",
    "znver4": "avx512",
    "znver5": "avx512",
}
# LLVM's name → the design (analysis/read/microarchitecture.py) that it describes.
DESIGNS: Final = {
    "skylake-avx512": "Skylake server",
    "icelake-server": "Ice Lake server",
    "sapphirerapids": "Sapphire Rapids",
    "znver3": "Zen 3",
    "znver4": "Zen 4",
    "znver5": "Zen 5",
}
MODELLED_COLUMNS: Final = ["method", "scalar", "loop", "isa", "model", "cycles"]
_VERSION = "19"


@dataclasses.dataclass(frozen=True)
class Architecture:
    """How LLVM's tools read and write the code of one."""

    triple: str
    everything: str  # the option with which llvm-mc knows every instruction
    comment: str  # what begins one
    iterations: int


X86_64: Final = Architecture("x86_64", "-mcpu=sapphirerapids", "#", 100)
# Its iterations are up to five times as long, and its CPUs more.
ARM64: Final = Architecture("aarch64", "-mattr=+v8.5a,+sve2,+sve2-aes", "//", 25)


class NotModelled(Exception):
    """llvm-mca is missing or did not understand a loop; the message says so."""


def no_models() -> pd.DataFrame:
    """What there is without llvm-mca."""
    return pd.DataFrame(columns=MODELLED_COLUMNS)


def model(instructions: pd.DataFrame, loop: str = "one_triangle") -> pd.DataFrame:
    """Cycles an item of every kernel in `instructions` (load_instructions) whose
    loop repeats, on every model. Raises NotModelled.
    """
    rows = instructions[
        (instructions["loop"] == loop) & (instructions["items_per_iteration"] > 0)
    ]
    texts = assembly(sorted({code for it in rows["iteration"] for code in it}))
    modelled = [
        cycles_on(rows[rows["isa"] == isa], texts, name) for name, isa in MODELS.items()
    ]
    modelled = [own for own in modelled if len(own)]
    return pd.concat(modelled, ignore_index=True) if modelled else no_models()


def cycles_on(
    rows: pd.DataFrame,
    texts: Mapping[str, str],
    name: str,
    architecture: Architecture = X86_64,
) -> pd.DataFrame:
    """Cycles an item of each row's loop on one model. Raises NotModelled."""
    own = rows.reset_index(drop=True)
    if own.empty:
        return no_models()
    loops = {
        str(index): [texts[code] for code in iteration]
        for index, iteration in enumerate(own["iteration"])
    }
    command = ["llvm-mca", *_options(name, architecture)]
    cycles = parse(_run(command, source(loops)))
    per_iteration = own.index.map(lambda index: cycles.get(str(index)))
    return own.assign(model=name, cycles=per_iteration / own["items_per_iteration"])[
        MODELLED_COLUMNS
    ]


def model_of(design: str) -> str | None:
    """The model of the CPUs of a design, if there is one."""
    return next((name for name, own in DESIGNS.items() if own == design), None)


def assembly(
    codes: Sequence[str], architecture: Architecture = X86_64
) -> dict[str, str]:
    """The text of each instruction, given as hex bytes. Raises NotModelled."""
    stream = "\n".join(
        " ".join(f"0x{code[i:i + 2]}" for i in range(0, len(code), 2)) for code in codes
    )
    command = ["llvm-mc", "--disassemble", f"-triple={architecture.triple}"]
    printed = _run([*command, architecture.everything], stream)
    return parse_assembly(codes, printed, architecture.comment)


def parse_assembly(
    codes: Sequence[str], printed: str, comment: str = "#"
) -> dict[str, str]:
    """llvm-mc's lines, one an instruction. Raises NotModelled."""
    lines = [line.partition(comment)[0].strip() for line in printed.splitlines()]
    texts = [line for line in lines if line and not line.startswith(".")]
    if len(texts) != len(codes):
        raise NotModelled(
            f"llvm-mc took {len(codes)} instructions for {len(texts)}: their bytes "
            "do not tell where each ends"
        )
    return dict(zip(codes, texts))


def source(loops: Mapping[str, Sequence[str]]) -> str:
    """Input for llvm-mca: each loop as a region of its name (in this form of
    comment on every architecture; llvm-mca takes no other).
    """
    lines = []
    for name, texts in loops.items():
        lines += [f"# LLVM-MCA-BEGIN {name}", *texts, f"# LLVM-MCA-END {name}"]
    return "\n".join(lines) + "\n"


def parse(printed: str) -> dict[str, float]:
    """Cycles an iteration of each region, from llvm-mca's JSON."""
    try:
        regions = json.loads(printed)["CodeRegions"]
        return {
            region["Name"]: region["SummaryView"]["TotalCycles"]
            / region["SummaryView"]["Iterations"]
            for region in regions
        }
    except (ValueError, KeyError, TypeError) as error:
        raise NotModelled(f"llvm-mca printed something else than results: {error}")


def _options(name: str, architecture: Architecture) -> list[str]:
    return [
        f"-mtriple={architecture.triple}",
        f"-mcpu={name}",
        "--json",
        f"-iterations={architecture.iterations}",
        "-instruction-info=false",
        "-resource-pressure=false",
    ]


def _run(command: Sequence[str], text: str) -> str:
    program = f"{command[0]}-{_VERSION}"
    if shutil.which(program) is None:
        raise NotModelled(f"{program} is not installed (Debian's llvm-{_VERSION})")
    done = subprocess.run(
        [program, *command[1:]], input=text, capture_output=True, text=True
    )
    if done.returncode != 0:
        raise NotModelled(f"{program} failed: {done.stderr.strip()[:300]}")
    return done.stdout
