"""Chains in which a side does not fit: a = b = c where b has another shape is told once, and a = c is decided."""

from __future__ import annotations

from dataclasses import replace

from chasles.reading.reading import Part, ReadEquation
from chasles.statements import Claim


def without_misfits_in_chains(equation: ReadEquation) -> ReadEquation:
    """The equation with chains in which what fits to neither neighbour is told once: those are compared themselves."""
    return replace(equation, readings=tuple(replace(r, parts=_compared(r.parts)) for r in equation.readings))


def _compared(parts: tuple[Part, ...]) -> tuple[Part, ...]:
    found: list[Part] = []
    for part in parts:
        if found and part.fault and found[-1].fault and part.left == found[-1].right:
            beside = replace(part, left=found[-1].left, fault="")
            fault = Claim("", beside.left, beside.right, sic=True).fault
            found.append(part if fault else beside)
        else:
            found.append(part)
    return tuple(found)
