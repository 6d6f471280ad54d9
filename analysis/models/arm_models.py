"""Arm CPUs by llvm-mca: the loops of the kernels for arm64, which ran under an
emulator and were never timed. So there is no measured row to hold them against.
"""

from __future__ import annotations

import os
from concurrent.futures import ThreadPoolExecutor
from typing import Final

import pandas as pd

from analysis.models import llvm_mca
from analysis.models.llvm_mca import MODELLED_COLUMNS

# LLVM's name of a CPU → the instruction sets whose loops it is given, and how
# many bits its vectors have in each. (Arm's technical reference manuals: SVE
# has 256 bits on the V1, 128 on the N2 and the V2.)
ARM_MODELS: Final = {
    "neoverse-n1": {"neon": 128},
    "neoverse-n2": {"neon": 128, "sve2": 128},
    "neoverse-v1": {"neon": 128, "sve": 256},
    "neoverse-v2": {"neon": 128, "sve2": 128},
    "apple-m1": {"neon": 128},
    "apple-m4": {"neon": 128},
}
# What LLVM may put in the place of tables of a CPU's own: an older CPU's.
_OLDER: Final = {"apple-m1": "apple-a7", "apple-m4": "apple-a7"}
ARM_COLUMNS: Final = [*MODELLED_COLUMNS, "vector_bits", "tables"]


def no_arm_models() -> pd.DataFrame:
    return pd.DataFrame(columns=ARM_COLUMNS)


def model_arm(emulated: pd.DataFrame) -> pd.DataFrame:
    """Cycles an item of every emulated kernel whose loop repeats, on each model
    that has its instruction set with vectors as long; `tables` is the older CPU
    that gives the same for every loop, empty if none does. Raises NotModelled.
    """
    rows = emulated[emulated["items_per_iteration"] > 0]
    if rows.empty:
        return no_arm_models()
    codes = sorted({code for loop in rows["iteration"] for code in loop})
    texts = llvm_mca.assembly(codes, llvm_mca.ARM64)
    loops = {
        (isa, bits): rows[(rows["isa"] == isa) & (rows["vector_bits"] == bits)]
        for isas in ARM_MODELS.values()
        for isa, bits in isas.items()
    }
    wanted = [
        (name, form)
        for name, isas in ARM_MODELS.items()
        for form in isas.items()
        if len(loops[form])
    ]
    wanted += {(_OLDER[name], form): None for name, form in wanted if name in _OLDER}

    def cycles_of(model: tuple[str, tuple[str, int]]) -> pd.DataFrame:
        return llvm_mca.cycles_on(loops[model[1]], texts, model[0], llvm_mca.ARM64)

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        cycles = dict(zip(wanted, pool.map(cycles_of, wanted)))
    parts = []
    for (name, form), own in cycles.items():
        if name in ARM_MODELS:
            older = cycles.get((_OLDER.get(name, ""), form))
            tables = "" if older is None else tables_of(own, older)
            parts.append(own.assign(vector_bits=form[1], tables=tables))
    return pd.concat(parts, ignore_index=True) if parts else no_arm_models()


def tables_of(cycles: pd.DataFrame, older: pd.DataFrame) -> str:
    """The older CPU's name if it gives every loop the same cycles, else empty."""
    same = cycles["cycles"].tolist() == older["cycles"].tolist()
    return str(older["model"].iloc[0]) if same and len(older) else ""
