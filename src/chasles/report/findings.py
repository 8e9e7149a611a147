"""Of an equation that is wrong as printed: what is right, who found it, and whose slip it probably is."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import SequenceMatcher

from chasles.decisions.session import Decision
from chasles.report.details import number_in_words
from chasles.report.equations import in_both
from chasles.report.words import said
from chasles.statements import Chapter, Entry, Statement
from chasles.verdict import Verdict
from chasles.vocabulary import Node

DecisionsByName = Mapping[str, Decision]
"""By the name of the statement."""
Decided = tuple[Entry, Decision]
Pairs = Sequence[Decided]


SLIPS = {"print": "wrong in the book", "scan": "lost by the scan", "both": "lost by the scan and wrong in the book"}
"""Whose slip it more likely is, in words."""
TOKEN = re.compile(r"\\[A-Za-z]+|\\.|[A-Za-z0-9]|\S")
MARKS = {"&": "a separator between two blocks", r"\tilde": "a tilde", "^": "a superscript"}
"""What is small or blank on a page, and is lost when its picture is made into text."""
LAYOUT = frozenset(("{", "}", "(", ")", r"\left", r"\right", r"\mathbf", r"\boldsymbol"))
"""What a difference in a mark brings with it."""


@dataclass(frozen=True, slots=True)
class Replacement:
    """What is true in place of a wrong equation: its sides, the verdict, how it was `found`, what was changed.

    `found` is "repair" or "declared"; `by` are the claims that show a definition to be the one that was meant.
    """

    left: Node
    right: Node
    sign: str
    verdict: Verdict
    found: str
    changes: tuple[str, ...] = ()
    modulo: str | None = None
    by: tuple[str, ...] = ()

    @property
    def in_words(self) -> str:
        """Behind "which": it holds, under what, or it is the definition with which others hold."""
        if self.by:
            return f"is the definition with which {', '.join(map(number_in_words, self.by))} hold"
        words = said(self.verdict)
        return words if words.startswith("holds") else f"is {words}"

    @property
    def who_found(self) -> str:
        """A sentence that says whether the search found it."""
        return "The search for a repair found it." if self.found == "repair" else "It was declared, not found."


@dataclass(frozen=True, slots=True)
class NumberCounts:
    """How many numbered equations a book has, of its own and of earlier chapters, and how many `others` without one."""

    own: int
    earlier: int
    others: int


def numbers_of(book: Chapter) -> NumberCounts:
    """The numbers of the book, each counted once; its own begin as those of its sections do."""
    chapters = {section.number.split(".")[0] for section in book.sections}
    equations = [number for number in book.numbers if number[:1].isdecimal()]
    own = sum(number.split(".")[0] in chapters for number in equations)
    return NumberCounts(own, len(equations) - own, len(book.numbers) - len(equations))


def ordered(book: Chapter, decisions: DecisionsByName) -> Pairs:
    """The statements of the book with the decisions on them, section by section in the order of their numbers."""
    place = {number: k for k, number in enumerate(book.numbers)}
    section = {known: k for k, known in enumerate(book.sections)}
    entries = sorted(book, key=lambda entry: (section[entry.section], place[entry.number], entry.statement.part))
    return [(entry, decisions[entry.name]) for entry in entries]


def replacements(entry: Entry, decision: Decision) -> tuple[Replacement, ...]:
    """What replaces an equation that is wrong as printed, the other repairs too; there may be none."""
    statement, correction = entry.statement, decision.correction
    if decision.verdict.true or not isinstance(statement, Statement):
        return ()
    if correction is None or not correction.verdict.true:
        return ()
    sides = correction.sides
    if correction.found == "declared":
        return (Replacement(*sides, statement.sign, correction.verdict, "declared"),)
    found = sorted(correction.repairs, key=lambda r: (r.left, r.right) != sides)
    return tuple(
        Replacement(r.left, r.right, statement.sign, r.verdict, "repair", r.changes, r.modulo, r.by) for r in found
    )


def replaced_by(decided: Pairs) -> Counter[str]:
    """How many equations that are wrong as printed a "repair" replaces, how many what is "declared", or "nothing"."""
    wrong = (replacements(*each) for each in decided if each[1].verdict.wrong)
    return Counter(found[0].found if found else "nothing" for found in wrong)


def slips(decided: Pairs) -> dict[str, Pairs]:
    """The equations that are wrong as printed, by whose slip it probably is; only what there is."""
    wrong = [(entry, decision) for entry, decision in decided if decision.verdict.wrong]
    by_slip = {slip: [each for each in wrong if _slip(*each) == slip] for slip in SLIPS}
    return {slip: pairs for slip, pairs in by_slip.items() if pairs}


def slips_in_words(decided: Pairs) -> str:
    """How many are wrong in the book, how many were lost by the scan, how many both; empty if all are right."""
    return ", ".join(f"{len(pairs)} {SLIPS[slip]}" for slip, pairs in slips(decided).items())


def _slip(entry: Entry, decision: Decision) -> str:
    """A `reading` restores what the scan has lost; what is not true with that is wrong in print too."""
    statement, correction = entry.statement, decision.correction
    if not isinstance(statement, Statement) or statement.reading is None:
        return "print"
    return "scan" if correction and correction.form == "reading" and correction.verdict.true else "both"


def likely_slip(entry: Entry, decision: Decision) -> str:
    """A sentence that says whose slip it probably is, and which marks the scan has lost."""
    statement, slip = entry.statement, _slip(entry, decision)
    if slip == "print":
        return "Probably a misprint."
    assert isinstance(statement, Statement)
    lost = lost_marks(*(in_both(statement.form(form), statement.sign)[1] for form in ("printed", "reading")))
    has = [f"has lost {_listed(lost.marks)}"] if lost.marks else []
    has += [f"has {_listed(lost.letters)}"] if lost.letters else []
    if slip == "scan":
        return "Probably a slip of the scan" + (f", which {' and '.join(has)}." if has else ".")
    return f"Probably a slip of the scan, which {' and '.join(has) or 'has lost a mark'}, and a misprint."


def _listed(words: Sequence[str]) -> str:
    """As one says it: a, b and c."""
    *others, last = words
    return f"{', '.join(others)} and {last}" if others else last


@dataclass(frozen=True, slots=True)
class Lost:
    """The `marks` that an equation has lost in the scan, and the `letters` that it has for others, in words."""

    marks: tuple[str, ...] = ()
    letters: tuple[str, ...] = ()


def lost_marks(printed: str, read: str) -> Lost:
    """The marks and letters in which a reading differs from the printed one; none if it differs in more than these."""
    before, behind = TOKEN.findall(printed), TOKEN.findall(read)
    marks: dict[str, None] = {}
    letters: dict[str, None] = {}
    for kind, i, j, k, m in SequenceMatcher(None, before, behind, autojunk=False).get_opcodes():
        old, new = before[i:j], behind[k:m]
        small = [MARKS[token] for token in new if token in MARKS]
        if kind == "equal" or (not small and LAYOUT.issuperset((*old, *new))):
            continue
        if small:
            marks |= dict.fromkeys(small)
        elif len(old) == len(new) == 1 and _are_letters(*old, *new):
            letters[f"{_named(old[0])} for {_named(new[0])}"] = None
        else:
            return Lost()
    return Lost(tuple(marks), tuple(letters))


def _are_letters(*tokens: str) -> bool:
    return all(token.lstrip("\\").isalpha() for token in tokens)


def _named(letter: str) -> str:
    return letter.removeprefix("\\")
