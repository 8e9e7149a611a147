"""What a page or a notebook shows of one equation, repair, statement, number: plain values for the templates.

What may be missing is a tuple, so that a template loops over it and decides nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

from markupsafe import Markup

from chasles.report.html.citing import Link
from chasles.report.words import VERDICTS


@dataclass(frozen=True, slots=True)
class Badge:
    """A verdict: the name of its style, its sign and its word."""

    name: str
    sign: str
    word: str


def badge_of(name: str) -> Badge:
    """The badge of a verdict's name."""
    sign, _, word, _ = VERDICTS[name]
    return Badge(name, sign, word)


@dataclass(frozen=True, slots=True)
class Equation:
    """An equation as MathML and in plain text, with a label where it is one of several; in LaTeX where that is used."""

    math: Markup
    words: str
    label: str = ""
    latex: str = ""


@dataclass(frozen=True, slots=True)
class Fact:
    """One thing that is said in a word and what follows it."""

    term: str
    text: Markup


@dataclass(frozen=True, slots=True)
class Related:
    """Other things on the page to which a word leads."""

    term: str
    links: tuple[Link, ...]


@dataclass(frozen=True, slots=True)
class Repaired:
    """What is right instead: the equation, its verdict, who found it, what was changed."""

    equation: Equation
    verdict: Markup
    found: str
    changes: tuple[Markup, ...]


@dataclass(frozen=True, slots=True)
class StepShown:
    """A step of a derivation: what is done, by what, the verdict, its result, the objections to it."""

    kind: str
    reason: Markup
    badges: tuple[Badge, ...]
    equations: tuple[Equation, ...]
    objections: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class DerivationView:
    """A derivation that was walked; `number` is that to which it belongs."""

    number: str
    name: str
    says: str
    outcome: str
    arrives: bool
    assuming: tuple[str, ...]
    steps: tuple[StepShown, ...]


@dataclass(frozen=True, slots=True)
class KernelRow:
    """A kernel: its name, place on the page, number, signature, how many operations of which kinds it takes.

    `bound` says how large its errors can be, a line for each result.
    """

    name: str
    place: str
    number: Link
    says: str
    signature: str
    needs: tuple[Markup, ...]
    total: int
    operations: str
    bound: tuple[str, ...]
    form: str


@dataclass(frozen=True, slots=True)
class StatementShown:
    """A statement: what it says, the equations as printed, the verdict with what it needs, and all else about it."""

    place: str
    name: str
    role: str
    says: str
    badge: Badge
    equations: tuple[Equation, ...]
    needs: tuple[Markup, ...]
    why: tuple[Fact, ...]
    instead: tuple[Repaired, ...]
    slip: tuple[str, ...]
    related: tuple[Related, ...]
    facts: tuple[Fact, ...]


@dataclass(frozen=True, slots=True)
class NumberShown:
    """A number of the book with its parts and its derivations; `classes` are what filters look for."""

    place: str
    cited: str
    badge: Badge
    classes: str
    parts: tuple[StatementShown, ...]
    roads: tuple[DerivationView, ...]


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
