"""A first notation for a page: each letter that occurs, with what its typeface and its use suggest."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import lru_cache
from typing import Any

from chasles.reading.applying import EVALUATED
from chasles.reading.commands import MARKS
from chasles.reading.declared_letters import declare_letter
from chasles.reading.equations import read_equations, segments
from chasles.reading.glyphs import Glyph, joined, letter_in, letter_of, spelled, text_of
from chasles.reading.grammar import Atom, Terms, formula, terms_in
from chasles.reading.grouping import TYPEFACES, Unread
from chasles.reading.letter_table import LetterTable
from chasles.reading.marks import SIZE, WITHOUT_WORD
from chasles.reading.notation_file import load_notation
from chasles.reading.page_notation import PageNotation
from chasles.reading.printed import PrintedEquation
from chasles.reading.quotients import upright
from chasles.reading.reading import ReadEquation
from chasles.reading.spellings import called
from chasles.reading.tokens import BadPage, Token
from chasles.vocabulary import At, Rate, Symbol
from chasles.vocabulary.measure import Extent

__all__ = ["proposed"]

TRANSPOSES, INVERSES = ("T", r"\top"), ("- 1", "- T", r"- \top")
RATES = (r"\dot", r"\ddot", r"\dddot")
NO_LETTERS = frozenset([*WITHOUT_WORD, r"\partial", ".", "!"])
DIFFERENTIAL = re.compile(r"\\o?int\b|\bd t\b|\\mathrm \{ d \}")
PRIMED = re.compile(r"[])] ('(?: ')*)")
BARE = (r"\pi", "e", "0", "I", r"\mathbf I", r"\mathbf 0", r"\mathbf 1", r"\mathrm d")
"""What is no letter of the page where it has no subscript."""
KINDS = {(True, True): ("matrix", "vector"), (True, False): ("vector", "matrix"),
         (False, True): ("matrix", "scalar", "vector"), (False, False): ("scalar", "vector")}  # fmt: skip
"""What a letter may be, by whether it is bold and whether it is a capital."""
MANY = 3
LONGEST, MOST_TRIED, ROUNDS, MOST_WORK = 150, 5, 2, 2000
"""A letter is tried in so many equations that have it, of so many tokens at most, so many times, with so much work."""


@dataclass
class _Use:
    """How a letter is used on the page: with which signs, in which functions, with which subscripts, where."""

    signs: set[str] = field(default_factory=set)
    letters: dict[Glyph, None] = field(default_factory=dict)
    places: dict[int, None] = field(default_factory=dict)
    kind: str = ""
    other: str = ""
    shape: tuple[Extent, ...] = ()


def proposed(equations: Sequence[PrintedEquation]) -> str:
    """A notation in TOML for the letters of these equations; where two meanings are likely, a question mark says so.

    Of what a letter may be, that is taken with which more of the equations can be read.
    """
    usual = load_notation("")
    uses: dict[Glyph, _Use] = {}
    has_differentials, primes = False, set[str]()
    for place, equation in enumerate(equations):
        try:
            text = " ".join(token.text for token in equation.tokens)
            has_differentials |= bool(DIFFERENTIAL.search(text))
            primes.update(PRIMED.findall(text))
            for line, _ in segments(equation.tokens):
                for side in formula(line).sides:
                    _note(side, "", uses, usual, place)
        except (Unread, BadPage):
            continue
    if has_differentials:
        uses.pop(Glyph("d"), None)
    elif Glyph("d") in uses:
        uses = {stem: use for stem, use in uses.items() if not stem.base.startswith("d ")}
    uses = dict(sorted(uses.items(), key=lambda each: spelled(each[0])))
    are_bold = sum(_looks(stem)[0] for stem in uses) >= MANY
    for stem, use in uses.items():
        use.kind, use.other = _kind(stem, use, are_bold)
    signs = ", ".join(f'"#{each.replace(" ", "")}"' for each in sorted(primes))
    quantity = [f"quantity = [{signs}]  # ? what these marks make of an expression"] if primes else []
    operators = "\n".join(["[operators]", *_operators(uses), *quantity])
    _choose_kinds(uses, load_notation(operators), equations)
    lines = [operators, "", "[symbols]"]
    for stem, use in uses.items():
        question = f"  # ? or {use.other}" if use.other else ""
        for glyph, said in _declared(stem, use):
            of = f", of = {_quoted(said['of'])}" if "of" in said else ""
            of += f", shape = {said['shape']}" if "shape" in said else ""
            known = _is_one_letter(glyph)
            entry = f'{_quoted(spelled(glyph))} = {{ is = "{said["is"]}"{of} }}{"" if of else question}'
            lines.append(entry if known else f"# {spelled(glyph)}: several letters in one; say what it is")
    return "\n".join(lines) + "\n"


def _choose_kinds(uses: dict[Glyph, _Use], operators: PageNotation, equations: Sequence[PrintedEquation]) -> None:
    """Let each letter be that with which most of the shortest equations that have it can be read."""
    for _ in range(ROUNDS):
        for stem, use in sorted(uses.items(), key=lambda each: -len(KINDS[_looks(each[0])])):
            having = [equations[place] for place in use.places if len(equations[place].tokens) < LONGEST]
            tried = sorted(having, key=lambda equation: len(equation.tokens))[:MOST_TRIED]
            read = _read(tried, uses, operators)
            best = sum(map(_is_well_formed, read))
            kinds = [(kind, ()) for kind in _kinds(stem, use)]
            wanted = dict.fromkeys(shape for each in read for shape in _shapes_wanted(each, use))
            for kind, shape in (
                (*kinds, *(("matrix", shape) if shape != (1, 1) else ("scalar", ()) for shape in wanted))
                if best < len(tried)
                else ()
            ):
                before = use.kind, use.shape
                use.kind, use.shape = kind, shape
                count = sum(map(_is_well_formed, _read(tried, uses, operators)))
                if count > best:
                    best, use.other = count, ""
                else:
                    use.kind, use.shape = before


def _is_well_formed(each: ReadEquation) -> bool:
    return bool(each.readings) and not any(part.fault for part in each.readings[0].parts)


def _shapes_wanted(each: ReadEquation, use: _Use) -> Iterator[tuple[Extent, ...]]:
    """What shape the letter has where it is set equal to something else."""
    letters = set(map(spelled, use.letters))
    for part in each.readings[0].parts if each.readings else ():
        for one, other in ((part.left, part.right), (part.right, part.left)) if part.fault else ():
            of = one.below[0] if isinstance(one, Rate | At) else one
            if isinstance(of, Symbol) and of.letter in letters and other.measure:
                yield other.shape


def _read(
    tried: Sequence[PrintedEquation], uses: dict[Glyph, _Use], operators: PageNotation
) -> tuple[ReadEquation, ...]:
    """What is read of the equations when the letters are what is proposed."""
    letters = LetterTable().before(operators.letters)
    notation = replace(operators, letters=letters, matched={}, most_work=MOST_WORK)
    for stem, use in uses.items():
        for glyph, said in _declared(stem, use):
            if _is_one_letter(glyph):
                declare_letter(notation, notation.letters, spelled(glyph), said)
    return read_equations(tried, notation)


def _declared(stem: Glyph, use: _Use) -> Iterator[tuple[Glyph, Mapping[str, Any]]]:
    """What is said of a letter: with its subscripts, by a pattern for many of them, and of a vector's components."""
    components = [glyph for glyph in use.letters if glyph.sub in ("x", "y", "z")]
    are_parts = use.kind == "vector" and stem in use.letters and bool(components)
    glyphs = [glyph for glyph in use.letters if not (are_parts and glyph in components)]
    if len(glyphs) > 3 and all(glyph.sub for glyph in glyphs):
        glyphs = [replace(stem, sub="##")]
    shape = {"shape": list(use.shape)} if use.shape else {}
    yield from ((glyph, {"is": use.kind, **shape}) for glyph in glyphs)
    if are_parts:
        yield replace(stem, sub="x|y|z"), {"is": "component", "of": spelled(stem)}


@lru_cache(maxsize=4096)
def _is_one_letter(glyph: Glyph) -> bool:
    """Whether it is read as the letter that it is once it is written."""
    try:
        return "#" in glyph.sub or "|" in glyph.sub or letter_in(spelled(glyph)) == glyph
    except (Unread, BadPage):
        return False


def _quoted(text: str) -> str:
    return json.dumps(text) if "'" in text else f"'{text}'"


def _note(terms: Terms | None, within: str, uses: dict[Glyph, _Use], usual: PageNotation, at: int) -> None:
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
            if piece.kind == "LETTER" and name in usual.spellings.names:
                before = name
                continue
            if name == "d" and isinstance(after, Atom) and after.kind == "LETTER" and not _is_derivative(terms, within):
                _note_letter(letter_of(joined((piece, after)) or piece), around, uses, at)
                before = within
                continue
            inside = piece.text if piece.text in (r"\|\|", "||", r"\lfloor\rfloor") else before
            inside = "d" if len(piece.arguments) == 2 and upright(piece.arguments[0])[:1] == ["d"] else inside
            for inner in terms_in(piece):
                _note(inner, inside, uses, usual, at)
            if piece.kind == "LETTER" or piece.text in TYPEFACES or piece.text in MARKS:
                _note_letter(letter_of(piece), around, uses, at)
            before = within


def _is_derivative(terms: Terms | None, within: str) -> bool:
    """Whether a d is that of a derivative or an integral."""
    return within == "d" or terms is None or "int" in text_of(terms)


def _note_letter(letter: Glyph, around: set[str], uses: dict[Glyph, _Use], at: int) -> None:
    is_bare = letter.base in BARE and (letter.base != "e" or bool(letter.sups))
    is_bare = is_bare and (not letter.sub or bool(SIZE.fullmatch(letter.sub))) and not {*letter.accents} - {*RATES}
    if is_bare or letter.base in NO_LETTERS or " , " in letter.base or letter.base.startswith(("[", "(", r"\begin")):
        return
    words = (*TRANSPOSES, *INVERSES, r"\wedge", r"\vee")
    scripts = {sup for sup in letter.sups if sup in words or sup.isdigit() or sup.startswith(EVALUATED)}
    accents = tuple(accent for accent in letter.accents if accent not in (*RATES, r"\tilde"))
    own = Glyph(letter.base, accents, letter.sub, letter.primes, tuple(set(letter.sups) - scripts), letter.before)
    stem = replace(own, sub="")
    use = uses.setdefault(stem, _Use())
    use.letters[own] = use.places[at] = None
    use.signs |= around | {f"^{sup}" for sup in scripts} | {accent for accent in letter.accents if accent == r"\tilde"}


def _looks(stem: Glyph) -> tuple[bool, bool]:
    """Whether the letter is bold, or has an accent of vectors, and whether it is a capital."""
    letter = stem.base.split()[-1]
    accented = bool({*stem.accents} & {r"\vec", r"\bar", r"\hat"})
    return r"\mathbf" in stem.base or r"\vec" in stem.base or accented, letter.strip("\\")[:1].isupper()


def _kinds(stem: Glyph, use: _Use) -> dict[str, None]:
    """What the letter may be: also a quaternion or a matrix where it is used as those are."""
    quaternion = ["quaternion"] if r"\otimes" in use.signs else []
    matrix = ["matrix"] if any(f"^{sup}" in use.signs for sup in (*TRANSPOSES, *INVERSES)) else []
    return dict.fromkeys((*KINDS[_looks(stem)], *quaternion, *matrix))


def _kind(stem: Glyph, use: _Use, are_bold: bool) -> tuple[str, str]:
    """What the letter is most likely, and what else it may be; where vectors are bold, others are none at first."""
    letter = stem.base.split()[-1]
    bold, large = _looks(stem)
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


def _operators(uses: dict[Glyph, _Use]) -> list[str]:
    """The spellings that occur of transposes and cross-product matrices."""
    signs = set().union(*(use.signs for use in uses.values()))
    skew = [form for sign, form in ((r"\tilde", r"\tilde{#}"), (r"^\wedge", r"#^\wedge")) if sign in signs]
    transposes = [f"#^{sup}" for sup in TRANSPOSES if f"^{sup}" in signs] or ["#^T"]
    skew += [r"\lfloor # \rfloor"] if r"\lfloor\rfloor" in signs else []
    lines = ["skew = [" + ", ".join(f"'{form}'" for form in (*skew, r"[#]_\times")) + "]"] if skew else []
    lines += ["transpose = [" + ", ".join(f"'{form}'" for form in transposes) + "]"]
    return [*lines, r"identity = ['\mathbf{1}', '\mathbf{I}', 'I']  # ? what of these is a letter of its own"]
