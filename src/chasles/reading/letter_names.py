"""Which marks are part of a letter's name on a page, and which letters are none of its own."""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import NamedTuple

from chasles.reading.applying import EVALUATED
from chasles.reading.glyphs import Glyph
from chasles.reading.marks import SIZE, WITHOUT_WORD

TRANSPOSES, INVERSES = ("T", r"\top"), ("- 1", "- T", r"- \top")
PSEUDOINVERSES = ("+", r"\sharp")
RATES = (r"\dot", r"\ddot", r"\dddot")
OPERATORS = (*RATES, r"\tilde")
"""Accents that are put on a letter; any other is part of its name."""
ITERATE = re.compile(r"\( [a-z](?: [+-] 1)? \)")
"""What numbers the members of a sequence above them."""
NO_LETTERS = frozenset([*WITHOUT_WORD, r"\partial"])
IDENTITIES = (r"\mathbf 1", r"\mathbf I", "I")
BARE = (r"\pi", "e", "0", r"\mathbf 0", r"\mathrm d", *IDENTITIES)
"""What is no letter of the page where it has no subscript."""
INERTIA = re.compile(
    r"(?:(\\mathbf) \{ I \}|(?<!\{ )\bI)"
    r" (?:\\(?:[a-z]*dot|vec|mathbf|boldsymbol|omega|alpha) |[A-Za-z('] |\^ \{ - 1|_ \{? ?(?:1 |[1-3]{2} \})"
    r"|= (?:\\i*int|\\[dt]?frac|m) )"
    r"|\} \{ (?:[^{}()+-]* )?I(?: [^{}()+-]*)? \}"
    r"|(\\mathbf) \{ 1 \} \^ \{ (?:T|\\top|\\mathsf \{ T \}|\\mathrm \{ T \}) \}"
)
"""An I before a letter or brackets, with a prime, in a denominator, inverted, or said to be a quotient or integral, is
no identity; nor is one of one row, nor a 1 that is transposed."""
WORDS = (*TRANSPOSES, *INVERSES, r"\wedge", r"\vee", r"\times")
_LABELLED = re.compile(
    r"(\\?[A-Za-z]+)(?: \})?(?: _ \{ [^{}]* \})? \^ \{ [01] \}"
    r"|(?<== )(?:\\\w+ \{ )*(\\?[A-Za-z]+)(?: \})*(?: _ \{ [^{}]* \})? \^ \{ [a-z] [+] 1 \} (?:=|-|:=)"
)


class NameMarks(NamedTuple):
    """Which marks are no part of a letter's name: accents that are `operators`, and numbers above letters.

    Above those that are `labelled` a number is part of the name, as in x^1, where others have x^{k + 1} at its place.
    What is `bare` is no letter of the page where it has no subscript.
    """

    operators: tuple[str, ...]
    bare: frozenset[str]
    labelled: frozenset[str] = frozenset()

    @classmethod
    def on_page(cls, texts: Iterable[str], operators: tuple[str, ...], bare: frozenset[str]) -> NameMarks:
        """Those of a page whose equations are these, as one text each."""
        return cls(
            operators, bare, frozenset("".join(found) for text in texts for found in _LABELLED.findall(f"= {text}"))
        )


def inertias(text: str) -> set[str]:
    """The letters for an identity that are something else in this equation, given as one text."""
    return {r"\mathbf 1" if ones else f"{face} I".strip() for face, ones in INERTIA.findall(f"{text} ")}


def parted(letter: Glyph, marks: NameMarks) -> tuple[Glyph, tuple[str, ...]]:
    """The letter with all that is part of its name, and the accents and superscripts that are not."""
    plain = {re.sub(r"\\math\w+ ", "", sup): sup for sup in letter.sups}
    is_power = letter.base.split()[-1] not in marks.labelled
    numbers = {sup for sup in plain if sup.isdigit() and sup != "0" and is_power}
    scripts = tuple(sup for sup in plain if sup in WORDS or sup in numbers or sup.startswith(EVALUATED))
    accents = tuple(accent for accent in letter.accents if accent not in marks.operators)
    own = tuple(sup for said, sup in plain.items() if said not in scripts)
    sub, scripts = ("", (*scripts, letter.sub)) if letter.sub == r"\times" else (letter.sub, scripts)
    made = tuple(accent for accent in letter.accents if accent in marks.operators and accent not in RATES)
    return Glyph(letter.base, accents, sub, letter.primes, own, letter.before), (*made, *scripts)


def stem_of(own: Glyph) -> Glyph:
    """What the letters have in common that are most likely of one kind: V, those as V_x, those as V_{xx}, and V^+."""
    count = sum(word.isalpha() for word in own.sub.split())
    sub = "" if not own.sub else "#" if count < 2 else f"# {count}"
    return Glyph(own.base, own.accents, sub, sups=tuple(sup for sup in own.sups if sup in PSEUDOINVERSES))


def is_declared(letter: Glyph, bare: frozenset[str]) -> bool:
    """Whether it is a letter of the page, and not one that has a meaning everywhere."""
    is_exponential = letter.base == "e" and bool(letter.sups) and not ITERATE.fullmatch(letter.sups[0])
    is_bare = letter.base in bare and (letter.base != "e" or is_exponential)
    has_size = letter.base != r"\pi" and bool(SIZE.fullmatch(letter.sub))
    is_bare = is_bare and (not letter.sub or has_size) and not {*letter.accents} - {*RATES}
    is_name = letter.base.startswith(("[", "(", r"\begin")) or " , " in letter.base or letter.loose.base in NO_LETTERS
    return not (is_bare or is_name)
