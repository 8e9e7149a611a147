"""How a page uses its letters: with which signs, in which functions, with which subscripts, and what that suggests."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import combinations

from chasles.reading.atoms import TYPEFACES, Atom, Atoms, Terms, said_of
from chasles.reading.commands import MARKS
from chasles.reading.derivatives import derivative, is_undefined
from chasles.reading.glyphs import ARROWS, Glyph, joined, letter_of, pieces_of, spelled, text_of
from chasles.reading.grammar import Chain, terms_in
from chasles.reading.letter_names import INVERSES, TRANSPOSES, NameMarks, is_declared, parted, stem_of
from chasles.reading.letter_shapes import TRACES
from chasles.reading.notation_file import usual_names
from chasles.reading.page_functions import DIFFERENCES, makes_difference, shown_alone
from chasles.reading.printed import PrintedEquation
from chasles.reading.segments import chains_of
from chasles.reading.spellings import called
from chasles.vocabulary.measure import Extent

GRID = re.compile(r"\\begin\{(?:\w*matrix|array)\}|[])] \^ \{ (?:- 1|T) \}")
"""A matrix that is written out, or brackets that are inverted or transposed."""
TURNING = re.compile(r"\\(?:omega|Omega|sin|cos)\b|\bS O\b|\bSO\b")
"""What a page with rotations has: their spins, their angles, or the name of their group."""
MANY = 3
NUMBERS = frozenset({"1/", r"\sqrt", r"\sin", r"\cos", r"\tan"})
SKEW = frozenset({r"^\wedge", r"^\times", r"[]_\times"})
"""Signs that make a cross-product matrix of a vector."""
CROSSED = frozenset({r"\times", r"\|\|", *SKEW})
"""Signs of vectors."""


@dataclass
class LetterUse:
    """How a letter is used on the page: with which signs, in which functions, with which subscripts, where.

    If it `has_order`, the page has it before and behind the same letter, as no author does of numbers.
    """

    signs: set[str] = field(default_factory=set)
    letters: dict[Glyph, dict[int, None]] = field(default_factory=dict)
    places: dict[int, None] = field(default_factory=dict)
    kind: str = ""
    other: str = ""
    shape: tuple[Extent, ...] = ()
    has_order: bool = False

    @property
    def meant(self) -> tuple[str, tuple[Extent, ...]]:
        """Its kind, and its shape where that is not the kind's own."""
        return self.kind, self.shape

    @property
    def is_number(self) -> bool:
        """Whether something is divided by it, or a root or an angle is made of it."""
        return bool(self.signs & NUMBERS)

    @property
    def is_square(self) -> bool:
        """Whether it is inverted, or has a determinant or a trace."""
        return bool(self.signs & {*TRACES, *(f"^{sup}" for sup in INVERSES)})

    @property
    def is_matrix(self) -> bool:
        """Whether it is used as no scalar is: also if it is transposed."""
        return self.is_square or any(f"^{sup}" in self.signs for sup in (*TRANSPOSES, r"\dagger"))


@dataclass(frozen=True, slots=True)
class _Noting:
    """Where letters are noted: in an equation at a place, with the marks that are no part of their names."""

    uses: dict[Glyph, LetterUse]
    at: int
    marks: NameMarks
    alone: frozenset[str]


def letter_uses(
    equations: Sequence[PrintedEquation], texts: Sequence[str], marks: NameMarks, said: Mapping[Glyph, str]
) -> dict[Glyph, LetterUse]:
    """The letters in their order, with how they are used and what they may be.

    `texts` are the equations' tokens as one text each. `marks` are no part of a letter's name. What is `said` of a
    letter in words is most likely.
    """
    uses: dict[Glyph, LetterUse] = {}
    found = [chains_of(equation) for equation in equations]
    alone = shown_alone(chain for chains in found for chain in chains)
    for place, chains in enumerate(found):
        for side in (side for chain in chains for side in chain.sides):
            _note(side, "", _Noting(uses, place, marks, alone))
    products = [[each for chain in chains for each in _products(chain)] for chains in found]
    pairs = [each for page in products for each in page if len(each) == 2]
    for letter in set().union(*map(_in_both_orders, (*products, pairs))):
        own, _ = parted(letter, marks)
        if (use := uses.get(stem_of(own))) and own in use.letters:
            use.has_order = True
    uses = dict(sorted(uses.items(), key=lambda each: spelled(each[0])))
    has_rotations = any(use.signs & {*SKEW, r"\times"} for use in uses.values()) or any(map(TURNING.search, texts))
    are_bold = sum(looks(stem)[0] for stem in uses) >= MANY
    are_thin = any(map(GRID.search, texts))
    are_thin |= any(use.signs & SKEW or (use.is_matrix and looks(stem)[1]) for stem, use in uses.items())
    traced = {stem.base.split()[-1] for stem, use in uses.items() if use.signs & {*TRACES, ":"}}
    for stem, use in uses.items():
        entries = uses.get(Glyph(stem.base, stem.accents, "#"), LetterUse()).letters
        has_parts = not stem.sub and {"x", "y"} <= {glyph.sub for glyph in entries}
        sign, _, bare_letter = stem.base.partition(" ")
        of = replace(stem, base=bare_letter) if sign in DIFFERENCES and bare_letter else stem
        use.kind, use.other = _kind(of, uses.get(of, use), are_bold, are_thin, has_parts)
        if use.kind == "vector" and looks(of)[0] and of.base.split()[-1] in traced and not use.signs & CROSSED:
            use.kind, use.other = "matrix", "vector"
        if _is_imaginary(stem, use, texts):
            use.kind, use.other = "imaginary unit", ""
        if use.kind == "rotation" and ("+" in use.signs or not has_rotations):
            use.kind, use.other = "matrix", ""
        if len(words := {said[own] for own in use.letters if own in said}) == 1:
            use.kind, use.other = words.pop(), ""
        if use.kind == "matrix" and use.signs.isdisjoint(f"^{each}" for each in INVERSES):
            use.shape = _oblong(stem.base, texts)
    return uses


def _is_imaginary(stem: Glyph, use: LetterUse, texts: Sequence[str]) -> bool:
    """Whether it is an i or a j that stands where only the imaginary unit makes sense: e^{i x}, i^2 = -1, j omega.

    As in a + i b, too, where the page numbers nothing with it.
    """
    letter = stem.base.split()[-1]
    if replace(stem, base=letter) != Glyph(letter) or letter not in ("i", "j", r"\imath", r"\jmath"):
        return False
    said = re.escape(letter)
    signs = [rf"{said} (?:\}} )?\^ \{{ 2 \}}.* = - 1(?: |$)", r"\\sqrt \{ - 1 \}", rf"(?:^| ){said} (?:2 \\pi|\\omega)"]
    if not any(re.search(rf"[_^] \{{ (?:[^{{}}]* )?{said} [^{{}}]*\}}", text) for text in texts):
        signs.append(rf"[+-] {said} [A-Za-z\\]")
    return bool(use.signs & {"e", r"\exp"}) or any(re.search(sign, text) for sign in signs for text in texts)


def _in_both_orders(products: Iterable[Sequence[Glyph]]) -> set[Glyph]:
    """The letters that stand in one product before, in another behind the same letter."""
    pairs = {pair for letters in products for pair in combinations(letters, 2) if pair[0] != pair[1]}
    return {letter for one, other in pairs if (other, one) in pairs for letter in (one, other)}


def _products(chain: Chain) -> list[list[Glyph]]:
    """The letters of each term of the sides."""
    return [_factors(row) for side in chain.sides if side is not None for row in side.rows]


def _factors(row: Atoms) -> list[Glyph]:
    """The letters of a product in the order of print, those in brackets among them; behind another sign none."""
    found: list[Glyph] = []
    for piece in row:
        if piece.kind == "INFIX" and piece.text != r"\cdot":
            break
        if piece.text == "()":
            found += [each for terms in piece.inside for inner in terms.rows for each in _factors(inner)]
        elif piece.kind == "LETTER" or piece.text in TYPEFACES or piece.text in MARKS:
            found.append(replace(letter_of(piece), place=None))
    return found


def _oblong(letter: str, texts: Sequence[str]) -> tuple[Extent, ...]:
    """The shape of a matrix that is inverted only in a product with its own transpose, as X is in (X^T X)^{-1}."""
    words = letter.split()
    found, turned = re.escape(" { ".join(words) + " }" * (len(words) - 1)), r" \^ \{ (?:T|\\top) \}"
    ends = (
        rf"\( {found}{turned} (?:[^()]* )?{found} \) \^ \{{ -",
        rf"\( {found} (?:[^()]* )?{found}{turned} \) \^ \{{ -",
    )
    shapes = [shape for shape, end in zip(((4, 3), (3, 4)), ends, strict=True) if any(re.search(end, t) for t in texts)]
    return shapes[0] if len(shapes) == 1 else ()


def _kind(stem: Glyph, use: LetterUse, are_bold: bool, are_thin: bool, has_parts: bool) -> tuple[str, str]:
    """What the letter is most likely, and what else it may be; where vectors are bold, others are none at first.

    Capitals in italics are matrices at first where `are_thin` says that the page has matrices so.
    """
    letter = stem.base.split()[-1]
    bold, large = looks(stem)
    crossed = bool(use.signs & CROSSED)
    vector = crossed or (not large and r"\tilde" in use.signs)
    is_apart = not crossed and (use.is_matrix or letter == "I" or r"\cdot" not in use.signs)
    if large and (bold or use.is_matrix) and (use.is_square or is_apart or letter in ("R", "Q", "C")):
        return ("rotation", "matrix") if letter in ("R", "Q", "C") else ("matrix", "")
    if bold or use.signs & SKEW or (vector and not are_bold) or (has_parts and not large):
        return "vector", "" if bold or r"\cdot" not in use.signs else "scalar"
    if use.is_matrix:
        return "vector", "matrix"
    if r"\{\}" in use.signs:
        return "vector", "scalar"
    if r"\otimes" in use.signs and not large:
        return "quaternion", "scalar"
    if use.signs & {r"\sin", r"\cos", r"\tan"}:
        return "angle", ""
    if large and "[]" in use.signs:
        return "matrix", ""
    if large:
        return ("matrix", "scalar") if bold or are_thin else ("scalar", "matrix")
    return "scalar", "vector"


def looks(stem: Glyph) -> tuple[bool, bool]:
    """Whether the letter is bold, or has an accent of vectors, and whether it is a capital."""
    letter = stem.base.split()[-1]
    accented = bool({*stem.accents} & {r"\bar", r"\hat", *ARROWS})
    is_double = stem.accents.count(r"\underline") > 1
    is_column = not is_double and (bool({*stem.accents} & ARROWS) or r"\vec" in stem.base)
    is_large = is_double or (letter.strip("\\")[:1].isupper() and not is_column)
    return r"\mathbf" in stem.base or is_column or accented, is_large


def _note(terms: Terms | None, within: str, noting: _Noting) -> None:
    """Note each letter of the terms, with what stands around it."""
    if terms is None:
        return
    for row in terms.rows:
        before = within
        for place, piece in enumerate(row):
            if piece.kind == "INFIX":
                before = piece.text
                continue
            after = row[place + 1] if place + 1 < len(row) else None
            around = {before, after.text if after and after.kind == "INFIX" else ""} - {""}
            around |= {"{}"} if after and after.kind == "GROUP" else set()
            around |= {"marked"} if after is None or after.kind in ("INFIX", "BRACKET") else set()
            around |= {"1/"} if before == "/" else set()
            around |= {"+"} if len(terms.rows) > len(row) == 1 else set()
            name = called(piece)
            if piece.kind == "LETTER" and name in usual_names():
                before = name
                continue
            if letter_of(piece).base == "d" and (within == "d" or (after and _is_derivative(terms, within))):
                continue
            if within == "d" and is_undefined(piece.text):
                continue
            if (
                after is not None
                and makes_difference(piece, after, noting.alone)
                and (after.kind == "LETTER" or after.text in TYPEFACES or after.text in MARKS)
                and not _is_derivative(terms, within)
            ):
                _note_letter(letter_of(joined((piece, after)) or piece), around, noting)
                before = within
                continue
            inside, held = _sign_around(piece, before), [*terms_in(piece)]
            divisor = held[-1] if piece.text.endswith("frac") and inside != "d" and held else None
            for inner in held:
                _note(inner, "1/" if inner is divisor else inside, noting)
            if piece.kind == "LETTER" or piece.text in TYPEFACES or piece.text in MARKS:
                _note_letter(letter_of(piece), around, noting)
            before = within


def _sign_around(piece: Atom, before: str) -> str:
    """What is noted of the letters that a piece holds: its own sign, or that before it."""
    if (found := derivative(piece)) and (found.sign in ("d", r"\partial") or is_undefined(found.sign)):
        return "d"
    if piece.text in ("[]", r"\{\}") and len(pieces_of(piece)) == 1:
        return piece.text
    if piece.kind == "BRACKET" and r"\times" in map(said_of, (piece.sub or (), *piece.sups)):
        is_letters = all(len(row) == 1 for terms in piece.inside for row in terms.rows)
        return r"[]_\times" if is_letters else ""  # of a product one factor alone is a vector
    return piece.text if piece.text in (r"\|\|", "||", r"\lfloor\rfloor", r"\sqrt", "e") else before


def _is_derivative(terms: Terms, within: str) -> bool:
    """Whether a d is that of a derivative or an integral."""
    return within == "d" or "int" in text_of(terms)


def _note_letter(letter: Glyph, around: set[str], noting: _Noting) -> None:
    if is_declared(letter, noting.marks.bare):
        own, marks = parted(letter, noting.marks)
        use = noting.uses.setdefault(stem_of(own), LetterUse())
        use.letters.setdefault(own, {})[noting.at] = use.places[noting.at] = None
        use.signs |= {"marked"} if letter.sub or letter.accents or letter.primes or letter.sups else set()
        use.signs |= {r"^\dagger"} if r"\dagger" in own.sups else set()
        use.signs |= around | {each if each in noting.marks.operators else f"^{each}" for each in marks}
