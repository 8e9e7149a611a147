"""A page read and decided: each displayed equation with what was made of its relations."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import cache, cached_property
from itertools import islice
from pathlib import Path
from types import ModuleType
from typing import Any

from chasles.decisions.session import Session
from chasles.display import Displayed
from chasles.pages.chains import without_misfits_in_chains
from chasles.pages.chapter_notation import notation_of_chapter
from chasles.pages.deduction import WORK, Deduction
from chasles.pages.facts import facts_of, kind_in_meaning
from chasles.pages.finding import PageFinding
from chasles.pages.known_answers import KnownAnswers
from chasles.pages.notes import EQUAL, NOTHING, EquationNote, is_defining, notes_of, parts_of
from chasles.pages.other_kinds import imaginary_unit
from chasles.pages.page_chapter import chapter_of
from chasles.pages.page_equation import PageEquation
from chasles.pages.premises import Premises
from chasles.pages.quantities import quantity, symbols_in
from chasles.reading.equations import read_equations
from chasles.reading.notation_file import load_notation
from chasles.reading.page_notation import PageNotation
from chasles.reading.pages import Kind, displayed
from chasles.reading.printed import PrintedEquation
from chasles.reading.prose import Lead, lead_of
from chasles.reading.reading import Part, ReadEquation, Reading
from chasles.statements import Chapter, Claim
from chasles.vocabulary import Node, Number, Rate, Symbol, latex, walk

MOST_READINGS = 4
"""So many readings of one equation are decided."""
AHEAD, MOST_AHEAD = 2, 6
"""So many equations that follow may say what new symbols are, and so many if all others are definitions."""
PROVED = ("holds", "holds-under")
UNDECIDED = frozenset({"defined", "open"})
"""Where nothing else is said, it makes no difference how the equation is read."""
Notes = Mapping[tuple[str, int], EquationNote]
"""What a person says of a relation, by the name of its equation and its part."""
OF_TIME = re.compile(r"(?:\bd|\{ ?d ?\}|\\partial|\\dd) ?t\b|\( ?t ?\)")
DISPLAYS = ("$$", "\\[", "\\begin{", "```", ".. math::")


@dataclass(frozen=True, repr=False)
class ReadPage(Displayed):
    """The equations of a page in its order, relation by relation; `file` is where it was read."""

    equations: tuple[PageEquation, ...]
    file: str = ""

    def __repr__(self) -> str:
        return f"<page: {self.summary}>"

    @property
    def counts(self) -> dict[str, int]:
        """How many equations and relations there are, and how many of these have each verdict."""
        found = Counter(each.verdict for each in self.equations)
        readable = [each for each in self.equations if each.verdict != "unread"]
        return {
            "displayed": len({id(each.read) for each in self.equations}),
            "equalities": len(self.equations),
            "read": len(readable),
            "decided": sum(each.is_decided for each in readable),
            **dict(sorted(found.items())),
        }

    @property
    def summary(self) -> str:
        """The counts in one line."""
        counts = self.counts
        equalities = f"{counts['equalities']} equalit{'y' if counts['equalities'] == 1 else 'ies'}"
        words = {"holds-under": "hold under", "holds": "hold", "fails": "fail"}
        whole = ("displayed", "equalities", "read", "decided")
        undecided = ("open", "ambiguous", "unread", "undecided", "contradictory")
        inner = [f"{n} {words.get(v, v)}" for v, n in counts.items() if v not in (*whole, *undecided)]
        outer = [f"{n} {verdict}" for verdict, n in counts.items() if verdict in undecided]
        return ", ".join(
            [
                f"{counts['displayed']} displayed equation{'s' * (counts['displayed'] != 1)}",
                f"{equalities}: {counts['read']} read",
                f"{counts['decided']} decided" + (f" ({', '.join(inner)})" if inner else ""),
                *outer,
            ]
        )

    @cached_property
    def chapter(self) -> Chapter:
        """What was read as a chapter: its statements with the premises that they need."""
        return chapter_of(self.file or "page", self.equations)[0]


def read(
    text: str, notation: str | Path | ModuleType | Chapter | Mapping[str, Any], kind: Kind | None = None
) -> ReadPage:
    """The equations of a page, or one equation alone, decided.

    Args:
        text: a page in LaTeX, Markdown or reStructuredText, or one equation in LaTeX.
        notation: what its letters are: a TOML file, its text or tables, a Python module, or a chapter.
        kind: "tex", "md", "rst" or "equation"; without it, as the text looks.

    Raises:
        BadNotation: for a notation that cannot be used.
        BadPage: for a page that cannot be read.
    """
    looks: Kind = "rst" if ".. math::" in text else "md" if any(sign in text for sign in DISPLAYS) else "equation"
    if kind is None and "\\begin{document}" in text:
        kind = "tex"
    known = notation_of_chapter(notation) if isinstance(notation, Chapter) else load_notation(notation)
    return read_page(displayed(text, kind or looks) or (() if kind else displayed(text, "equation")), known)


def read_page(
    printed: tuple[PrintedEquation, ...], notation: PageNotation, file: str = "", known: KnownAnswers | None = None
) -> ReadPage:
    """The page of these equations, decided in their order; raises `BadNotation` for what it cannot assume.

    What is found out is added to the answers that are `known`.
    """
    known = known or KnownAnswers()
    beside = [each for equation in printed for each in equation.beside]
    both = tuple(map(without_misfits_in_chains, read_equations([*printed, *beside], notation)))
    equations, beside_them = both[: len(printed)], iter(both[len(printed) :])
    sides = [side for equation in equations for reading in equation.readings for side in reading.sides]
    session, is_complex = Session(WORK, memory=known.memory), imaginary_unit(sides) is not None
    printed_rates = (quantity(part) for side in sides for part in walk(side))
    moving = frozenset(key[0] for key in printed_rates if key and key[1])
    usual = (dict.fromkeys(each.readings[0].sides) for each in equations if each.readings)
    used = Counter(symbol for each in usual for side in each for symbol in symbols_in((side,)))
    recurring = frozenset(symbol for symbol, count in used.items() if count > 1)
    facts = cache(lambda symbol: facts_of(symbol, kind_in_meaning(symbol)))
    premises = Premises(facts, moving=moving, recurring=recurring)
    deduction = Deduction(premises, session, notation.proposed, is_complex, known.may_follow)
    for said in notation.assuming:
        for part in parts_of(said, notation, f"[page] assuming '{said}'"):
            deduction.assume(part.left, part.right)
    for time in _times(printed, sides):
        deduction.assume(Rate(time), Number(Fraction(1)))
    names = [each.printed.number or each.printed.label or f"line {each.printed.line}" for each in equations]
    places: Counter[str] = Counter()
    relations = []
    for equation, name in zip(equations, names, strict=True):
        relations.append(_relations(equation.readings[0], name, places[name] + 1) if equation.readings else ())
        places[name] += len(relations[-1]) or 1
    named: dict[str, list[Claim]] = {}
    for name, claims in zip(names, relations, strict=True):
        named.setdefault(name, []).extend(claims)
    defined = {claim.left for claims in relations for claim in claims}
    notes = notes_of(notation, named)
    found: list[PageEquation] = []
    leads = _leads(printed, names)
    for place, (equation, name) in enumerate(zip(equations, names, strict=True)):
        ahead = tuple(_saying(relations[place + 1 : place + 1 + MOST_AHEAD], leads[place + 1 :]))
        first = relations[place][0].part if relations[place] else 1
        for nth, named_by in enumerate(islice(beside_them, len(equation.printed.beside)), 1):
            naming = (each for each in named_by.readings if quantity(each.parts[0].left) is not None)
            for reading in islice(naming, 1):
                claims = _relations(reading, named_by.printed.label or f"{name} under a brace", nth)
                deduction.say_beside(each for each in claims if is_defining(each) or each.left not in defined)
        found += _decided(equation, name, first, notes, deduction, ahead, leads[place])
    return ReadPage(tuple(replace(each, finding=deduction.settled(each.finding)) for each in found), file)


def _times(printed: Sequence[PrintedEquation], sides: Iterable[Node]) -> Iterator[Symbol]:
    """The letter t, a number where the page differentiates by it, or has functions of it: its own rate is one."""
    if any(OF_TIME.search(each.latex) for each in printed):
        found = {symbol for symbol in symbols_in(sides) if symbol.letter == "t" and not symbol.constant}
        yield from (symbol for symbol in found if symbol.is_scalar)


def _leads(printed: Sequence[PrintedEquation], names: Sequence[str]) -> list[Lead]:
    """What leads to each equation: it cites the one before it, too."""
    labels = {each.label: name for each, name in zip(printed, names, strict=True)}
    leads: list[Lead] = []
    for each, before in zip(printed, ("", *names), strict=False):
        lead = lead_of(each.before)
        cited = dict.fromkeys((before, *(labels.get(name, name) for name in lead.cited)))
        said = leads[-1] if lead.again and leads else lead
        leads.append(replace(lead, cited=tuple(cited), is_posed=said.is_posed, is_case=said.is_case))
    return leads


def _saying(following: Sequence[tuple[Claim, ...]], leads: Sequence[Lead]) -> Iterator[Claim]:
    """The relations that may say what is new in the equation before them: none that are said to follow."""
    for place, (claims, lead) in enumerate(zip(following, leads, strict=False)):
        if place >= AHEAD and not all(map(is_defining, claims)):
            return
        yield from (claim for claim in claims if claim.sign in EQUAL and (is_defining(claim) or not lead.follows))


def _relations(reading: Reading, number: str, first: int) -> tuple[Claim, ...]:
    return tuple(
        Claim(number, part.left, part.right, part=place, sign=part.sign, sic=True)
        for place, part in enumerate(reading.parts, first)
    )


def _decided(
    equation: ReadEquation,
    number: str,
    first: int,
    notes: Notes,
    deduction: Deduction,
    ahead: tuple[Claim, ...],
    lead: Lead,
) -> Iterator[PageEquation]:
    """The relations of an equation in its usual reading, and what differs in its other readings.

    Of several readings those count in which least is new; none beside a usual one that is proved.
    """
    if not equation.readings:
        yield PageEquation(equation, number, first)
        return
    news = [deduction.strange(reading) for reading in equation.readings]
    taken, *others = [each for each, new in zip(equation.readings, news, strict=True) if new == min(news)]
    forks = [(other, deduction.fork()) for other in others[: MOST_READINGS - 1]]
    where, known = equation.printed, deduction.premises
    posed, opened = len(known.posed), dict(known.opened)
    findings = list(_said(taken, number, first, notes, deduction, ahead, where, lead))
    usual = [_verdict(finding) for _, finding in findings]
    told = []
    for other, fork in () if _is_meant(usual) else forks:
        verdicts = [_verdict(finding) for _, finding in _said(other, number, first, notes, fork, ahead, where, lead)]
        if verdicts != usual and not UNDECIDED.issuperset((*verdicts, *usual)):
            told.append((", ".join(verdicts), _in_latex(other)))
    if told:  # what is open in one reading alone is no premise of what follows
        deduction.premises.posed[posed:], deduction.premises.opened = [], opened
        deduction.premises.told.pop(number, None)
    for place, (part, finding) in enumerate(findings, first):
        yield PageEquation(equation, number, place, part, finding, tuple(told))


def _is_meant(verdicts: list[str]) -> bool:
    """Whether a reading says something that holds, and nothing that does not."""
    return any(each in PROVED for each in verdicts) and all(each in (*PROVED, "defined") for each in verdicts)


def _said(
    reading: Reading,
    number: str,
    first: int,
    notes: Notes,
    deduction: Deduction,
    ahead: tuple[Claim, ...],
    printed: PrintedEquation,
    lead: Lead,
) -> Iterator[tuple[Part, PageFinding]]:
    claims = _relations(reading, number, first)
    with deduction.where(number, reading.given, printed.display, printed.section):
        for place, (part, claim) in enumerate(zip(reading.parts, claims, strict=True), 1):
            following = (*(each for each in claims[place:] if each.sign in EQUAL), *ahead)
            note = notes.get((number, claim.part), NOTHING)
            yield part, deduction.say(number, claim.part, part.left, part.sign, part.right, note, following, lead)


def _verdict(finding: PageFinding) -> str:
    return "open" if finding.open else finding.verdict.name


def _in_latex(reading: Reading) -> str:
    return r" \quad ".join(f"{latex(part.left)} {part.sign} {latex(part.right)}" for part in reading.parts)
