"""Records of emitted kernels: the expression each is made from, and its proved error bound."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from typing import Any

from chasles.bounds.bound import Bound
from chasles.bounds.model import SINGLE
from chasles.lowering.program import Op
from chasles.report.details import Lines

ROUNDOFF = "u = 2^-53, in single precision 2^-24"


def emitted_kernels(manifest: str) -> dict[str, Mapping[str, Any]]:
    """The manifest's record of each kernel, by name; an empty manifest has none."""
    kernels: dict[str, Mapping[str, Any]] = tomllib.loads(manifest).get("kernels", {})
    return kernels


def recorded(kernels: Mapping[str, Mapping[str, Any]], names: tuple[str, ...]) -> Lines:
    """What each of the kernels is made of, and what is proved of its errors; nothing of those not emitted."""
    for name in names:
        if name in kernels:
            record, of = kernels[name], f"{name}: " if len(names) > 1 else ""
            if record["form"] == "offered":
                yield "made of", f"{of}an offered form, proved equal to the statement"
            yield from (("error bound", f"{of}{line}") for line in proved(record))


def proved(record: Mapping[str, Any]) -> tuple[str, ...]:
    """What is proved of a kernel's errors, a line for each result, and the rounding model under which it is."""
    bound = Bound.from_data(record["bound"])
    if all(guarantee.against == "nothing" for guarantee in bound.guarantees):
        return bound.in_words
    *lines, last = bound.in_words
    return (*lines, f"{last}; {ROUNDOFF}; {SINGLE.in_words([Op(name) for name in record['operations']])}")
