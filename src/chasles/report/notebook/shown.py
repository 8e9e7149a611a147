"""What is displayed of a thing: plain values for the template; what may be missing is empty."""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from chasles.report.html.shown import Badge, Equation, Fact, Repaired, StepShown


@dataclass(frozen=True, slots=True)
class Card:
    """A heading with badges, words, equations, facts, what is right instead, steps, rows of a table, code to open."""

    title: str = ""
    badges: tuple[Badge, ...] = ()
    needs: tuple[Markup, ...] = ()
    says: str = ""
    quiet: str = ""
    equations: tuple[Equation, ...] = ()
    facts: tuple[Fact, ...] = ()
    instead: tuple[Repaired, ...] = ()
    slip: tuple[str, ...] = ()
    steps: tuple[StepShown, ...] = ()
    head: tuple[str, ...] = ()
    rows: tuple[tuple[Markup | str, ...], ...] = ()
    code: tuple[tuple[str, str], ...] = ()
