"""chasles: the shipped generalised ufuncs."""

from __future__ import annotations

import tomllib
from collections.abc import Sequence
from pathlib import Path

from benchmarks.formulas import Kernel
from benchmarks.peers import Made

from chasles import kernels as shipped

TITLE = "chasles"
MANIFEST = Path(__file__).resolve().parents[2] / "generated" / "MANIFEST.toml"


def make(kernels: Sequence[Kernel]) -> dict[str, Made]:
    """The kernels by name; operations as the manifest counts them, sine and cosine apart."""
    listed = tomllib.loads(MANIFEST.read_text("utf-8"))["kernels"]
    counts = {name: entry["operations"] for name, entry in listed.items()}
    return {
        kernel.name: Made(
            getattr(shipped, kernel.name),
            sum(number for word, number in counts[kernel.name].items() if word not in ("sine", "cosine")),
        )
        for kernel in kernels
    }
