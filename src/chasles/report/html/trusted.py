"""What the verdicts rest on: certificates that were checked again, and the length of the checker."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.report.closure import lines


@dataclass(frozen=True, slots=True)
class Trusted:
    """How many certificates and counterexamples were checked again, how many were rejected, by how long a checker."""

    certificates: int
    counterexamples: int
    rejected: int
    lines: int


def checked_again(certificates: int, counterexamples: int, rejected: int) -> Trusted:
    """What was checked again, and how long the checker is."""
    return Trusted(certificates, counterexamples, rejected, lines("declared"))
