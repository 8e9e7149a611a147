"""What the verdicts rest on: the length of the checker, counted in its source, and what else has to be trusted."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from importlib.resources import files


@dataclass(frozen=True, slots=True)
class Trusted:
    """How many certificates and counterexamples were checked again, how many were rejected, by how long a checker."""

    certificates: int
    counterexamples: int
    rejected: int
    lines: int


def checked_again(certificates: int, counterexamples: int, rejected: int) -> Trusted:
    """What was checked again, and how long the checker is."""
    return Trusted(certificates, counterexamples, rejected, source_lines())


def source_lines() -> int:
    """The lines of the checker's source that are neither blank nor comments."""
    lines = (line.strip() for text in _sources() for line in text.splitlines())
    return sum(1 for line in lines if line and not line.startswith("#"))


def _sources() -> Iterator[str]:
    for source in sorted(files("chasles.checker").iterdir(), key=lambda each: each.name):
        if source.name.endswith(".py"):
            yield source.read_text("utf-8")
