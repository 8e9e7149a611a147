"""How a page uses its letters: with which signs, in which functions, with which subscripts, and what that suggests."""

from __future__ import annotations

import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace

from chasles.reading.applying import EVALUATED
from chasles.reading.commands import MARKS
from chasles.reading.equations import segments
from chasles.reading.glyphs import Glyph, joined, letter_of, spelled, text_of
from chasles.reading.grammar import Atom, Terms, formula, terms_in
from chasles.reading.grouping import TYPEFACES, Unread
from chasles.reading.marks import SIZE, WITHOUT_WORD
from chasles.reading.notation_file import load_notation
from chasles.reading.page_notation import PageNotation
from chasles.reading.printed import PrintedEquation
from chasles.reading.quotients import upright
from chasles.reading.spellings import called
from chasles.reading.tokens import BadPage, Token
from chasles.vocabulary.measure import Extent

__all__ = ["INVERSES", "OPERATORS", "RATES", "TRANSPOSES", "LetterUse", "letter_uses", "looks"]

TRANSPOSES, INVERSES = ("T", r"\top"), ("- 1", "- T", r"- \top")
RATES = (r"\dot", r"\ddot", r"\dddot")
OPERATORS = (*RATES, r"\tilde")
"""Accents that are put on a letter; any other is part of its name."""
NO_LETTERS = frozenset([*WITHOUT_WORD, r"\partial"])
DIFFERENTIAL = re.compile(r"\\o?int\b|\bd t\b|\\mathrm \{ d \}")
BARE = (r"\pi", "e", "0", "I", r"\mathbf I", r"\mathbf 0", r"\mathbf 1", r"\mathrm d")
"""What is no letter of the page where it has no subscript."""
MANY = 3


@dataclass
class LetterUse:
    """How a letter is used on the page: with which signs, in which functions, with which subscripts, where."""

    signs: set[str] = field(default_factory=set)
    letters: dict[Glyph, None] = field(default_factory=dict)
    places: dict[int, None] = field(default_factory=dict)
    kind: str = ""
    other: str = ""
    shape: tuple[Extent, ...] = ()


@dataclass(frozen=True, slots=True)
class _Noting:
    """Where letters are noted: in an equation at a place, with accents that are operators."""

    uses: dict[Glyph, LetterUse]
    usual: PageNotation
    at: int
    operators: tuple[str, ...]


def letter_uses(
    equations: Sequence[PrintedEquation], texts: Sequence[str], operators: tuple[str, ...]
) -> dict[Glyph, LetterUse]:
    """The letters in their order, with how they are used and what they may be.

    `texts` are the equations' tokens as one text each. Accents that are no `operators` are part of a letter's name.
    """
    usual = load_notation("")
    uses: dict[Glyph, LetterUse] = {}
    for place, equation in enumerate(equations):
        with suppress(Unread, BadPage):
            for line, _ in segments(equation.tokens):
                for side in formula(line).sides:
                    _note(side, "", _Noting(uses, usual, place, operators))
    if any(map(DIFFERENTIAL.search, texts)):
        uses.pop(Glyph("d"), None)
    elif Glyph("d") in uses:
        uses = {stem: use for stem, use in uses.items() if not stem.base.startswith("d ")}
    uses = dict(sorted(uses.items(), key=lambda each: spelled(each[0])))
    are_bold = sum(looks(stem)[0] for stem in uses) >= MANY
    for stem, use in uses.items():
        use.kind, use.other = _kind(stem, use, are_bold)
    return uses


def _kind(stem: Glyph, use: LetterUse, are_bold: bool) -> tuple[str, str]:
    """What the letter is most likely, and what else it may be; where vectors are bold, others are none at first."""
    letter = stem.base.split()[-1]
    bold, large = looks(stem)
    square = any(f"^{sup}" in use.signs for sup in INVERSES) or bool(use.signs & {r"\det", "tr", r"\tr"})
    vector = bool(use.signs & {r"\times", r"\cdot", r"\|\|", r"\lfloor\rfloor", r"\tilde", r"^\wedge"})
    transposed = any(f"^{sup}" in use.signs for sup in TRANSPOSES)
    if large and (bold or square or transposed):
        return ("rotation", "matrix") if letter in ("R", "Q", "C") else ("matrix", "")
    has_parts = stem in use.letters and {"x", "y"} <= {glyph.sub for glyph in use.letters}
    if bold or (vector and not large and (has_parts or not are_bold)):
        return "vector", "" if bold or r"\cdot" not in use.signs else "scalar"
    if transposed:
        return "vector", "matrix"
    if use.signs & {r"\sin", r"\cos", r"\tan"}:
        return "angle", ""
    return ("matrix", "scalar") if large else ("scalar", "vector")


def looks(stem: Glyph) -> tuple[bool, bool]:
    """Whether the letter is bold, or has an accent of vectors, and whether it is a capital."""
    letter = stem.base.split()[-1]
    accented = bool({*stem.accents} & {r"\vec", r"\bar", r"\hat"})
    return r"\mathbf" in stem.base or r"\vec" in stem.base or accented, letter.strip("\\")[:1].isupper()


def _note(terms: Terms | None, within: str, noting: _Noting) -> None:
    """Note each letter of the terms, with what stands around it."""
    for row in terms.rows if terms else ():
        before = within
        for place, piece in enumerate(row.pieces):
            if isinstance(piece, Token):
                before = piece.text
                continue
            after = row.pieces[place + 1] if place + 1 < len(row.pieces) else None
            around = {before, after.text if isinstance(after, Token) else ""} - {""}
            name = called(piece)
            if piece.kind == "LETTER" and name in noting.usual.spellings.names:
                before = name
                continue
            if name == "d" and isinstance(after, Atom) and after.kind == "LETTER" and not _is_derivative(terms, within):
                _note_letter(letter_of(joined((piece, after)) or piece), around, noting)
                before = within
                continue
            inside = piece.text if piece.text in (r"\|\|", "||", r"\lfloor\rfloor") else before
            inside = "d" if len(piece.arguments) == 2 and upright(piece.arguments[0])[:1] == ["d"] else inside
            for inner in terms_in(piece):
                _note(inner, inside, noting)
            if piece.kind == "LETTER" or piece.text in TYPEFACES or piece.text in MARKS:
                _note_letter(letter_of(piece), around, noting)
            before = within


def _is_derivative(terms: Terms | None, within: str) -> bool:
    """Whether a d is that of a derivative or an integral."""
    return within == "d" or terms is None or "int" in text_of(terms)


def _note_letter(letter: Glyph, around: set[str], noting: _Noting) -> None:
    is_bare = letter.base in BARE and (letter.base != "e" or bool(letter.sups))
    is_bare = is_bare and (not letter.sub or bool(SIZE.fullmatch(letter.sub))) and not {*letter.accents} - {*RATES}
    if is_bare or letter.base in NO_LETTERS or " , " in letter.base or letter.base.startswith(("[", "(", r"\begin")):
        return
    words = (*TRANSPOSES, *INVERSES, r"\wedge", r"\vee")
    scripts = {sup for sup in letter.sups if sup in words or sup.isdigit() or sup.startswith(EVALUATED)}
    accents = tuple(accent for accent in letter.accents if accent not in noting.operators)
    own = Glyph(letter.base, accents, letter.sub, letter.primes, tuple(set(letter.sups) - scripts), letter.before)
    stem = replace(own, sub="")
    use = noting.uses.setdefault(stem, LetterUse())
    use.letters[own] = use.places[noting.at] = None
    use.signs |= around | {f"^{sup}" for sup in scripts} | ({*letter.accents} & {*noting.operators[len(RATES) :]})
