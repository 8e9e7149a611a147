"""LANGUAGES: kernels as text in C, as generalised ufuncs and as array-API Python; a folder here is a language.

`render` makes the text, `write` puts it below a folder, `stale` compares it with what lies there, `discover` finds
the languages.
"""

from __future__ import annotations

from chasles.targets.emit import MANIFEST, render, spelled_out, taken_away
from chasles.targets.kernel import Check, EmissionError, Heading, TargetKernel, signature
from chasles.targets.target import Origin, Page, Target, discover
from chasles.targets.tree import Difference, Written, place, stale, write

__all__ = [
    "MANIFEST",
    "Check",
    "Difference",
    "EmissionError",
    "Heading",
    "Origin",
    "Page",
    "Target",
    "TargetKernel",
    "Written",
    "discover",
    "place",
    "render",
    "signature",
    "spelled_out",
    "stale",
    "taken_away",
    "write",
]
