"""A first notation for a page: each letter that occurs, with what its typeface and its use suggest."""

from __future__ import annotations

import json
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field, replace

from chasles.reading.commands import MARKS
from chasles.reading.equations import segments
from chasles.reading.glyphs import Glyph, letter_in, letter_of, spelled
from chasles.reading.grammar import Terms, formula, terms_in
from chasles.reading.grouping import TYPEFACES, Unread
from chasles.reading.page_notation import PageNotation, usual_spellings
from chasles.reading.printed import PrintedEquation
from chasles.reading.spellings import called
from chasles.reading.tokens import BadPage, Token

__all__ = ["proposed"]

TRANSPOSES, INVERSES = ("T", r"\top"), ("- 1", "- T", r"- \top")
RATES = (r"\dot", r"\ddot", r"\dddot")
NOT_DECLARED = (
    r"d \partial \int \sum \lim \ldots \dots \cdots \infty \pi e . ! 0 I \mathbf_I \mathbf_0 \mathbf_1 \mathrm_d"
)
BARE_VECTORS = (r"\vec", r"\bar", r"\hat")


@dataclass
class _Use:
    """How a letter is used on the page: with which signs, in which functions, with which subscripts."""

    signs: set[str] = field(default_factory=set)
    letters: dict[Glyph, None] = field(default_factory=dict)


def proposed(equations: Sequence[PrintedEquation]) -> str:
    """A notation in TOML for the letters of these equations; where two meanings are likely, a question mark says so."""
    usual = PageNotation()
    usual_spellings(usual)
    uses: dict[Glyph, _Use] = {}
    for equation in equations:
        try:
            for line, _ in segments(equation.tokens):
                for side in formula(line).sides:
                    _note(side, "", uses, usual)
        except (Unread, BadPage):
            continue
    lines = ["[operators]", *_operators(uses), "", "[symbols]"]
    for stem, use in sorted(uses.items(), key=lambda each: spelled(each[0])):
        lines += _declared(stem, use)
    return "\n".join(lines) + "\n"


def _declared(stem: Glyph, use: _Use) -> Iterator[str]:
    """The lines of a letter: with its subscripts, one pattern for many of them, or the components of a vector."""
    kind, other = _kind(stem, use)
    components = [glyph for glyph in use.letters if glyph.sub in ("x", "y", "z")]
    question = f"  # ? or {other}" if other else ""
    glyphs = [glyph for glyph in use.letters if not (kind == "vector" and stem in use.letters and glyph in components)]
    if len(glyphs) > 3 and all(glyph.sub and not glyph.sups for glyph in glyphs):
        glyphs = [replace(stem, sub="##")]
    for glyph in glyphs:
        if "#" not in glyph.sub and not _is_one_letter(glyph):
            yield f"# {spelled(glyph)}: several letters in one; say what it is"
            continue
        yield f'{_quoted(spelled(glyph))} = {{ is = "{kind}" }}{question}'
    if len(glyphs) < len(use.letters) and components and stem in use.letters:
        marks = replace(stem, sub="x|y|z")
        yield f'{_quoted(spelled(marks))} = {{ is = "component", of = {_quoted(spelled(stem))} }}'


def _is_one_letter(glyph: Glyph) -> bool:
    """Whether it is read as the letter that it is once it is written."""
    try:
        return letter_in(spelled(glyph)) == glyph
    except (Unread, BadPage):
        return False


def _quoted(text: str) -> str:
    return json.dumps(text) if "'" in text else f"'{text}'"


def _note(terms: Terms | None, within: str, uses: dict[Glyph, _Use], usual: PageNotation) -> None:
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
            for inner in terms_in(piece):
                _note(inner, piece.text if piece.text in (r"\|\|", "||") else before, uses, usual)
            if piece.kind == "LETTER" or piece.text in TYPEFACES or piece.text in MARKS:
                _note_letter(letter_of(piece), around, uses)
            before = within


def _note_letter(letter: Glyph, around: set[str], uses: dict[Glyph, _Use]) -> None:
    if (
        letter.base.replace(" ", "_") in NOT_DECLARED.split()
        or " , " in letter.base
        or letter.base.startswith(("[", "(", r"\begin"))
    ):
        return
    scripts = {sup for sup in letter.sups if sup in (*TRANSPOSES, *INVERSES, "2", "3", r"\wedge", r"\vee", "*")}
    accents = tuple(accent for accent in letter.accents if accent not in (*RATES, r"\tilde"))
    own = Glyph(letter.base, accents, letter.sub, letter.primes, tuple(set(letter.sups) - scripts), letter.before)
    stem = Glyph(letter.base, accents, before=letter.before)
    use = uses.setdefault(stem, _Use())
    use.letters[own] = None
    use.signs |= around | {f"^{sup}" for sup in scripts} | {accent for accent in letter.accents if accent == r"\tilde"}


def _kind(stem: Glyph, use: _Use) -> tuple[str, str]:
    """What the letter is most likely, and what else it may be."""
    letter = stem.base.split()[-1]
    large = letter[:1].isupper() or (letter[:1] == "\\" and letter[1:2].isupper())
    square = any(f"^{sup}" in use.signs for sup in INVERSES) or bool(use.signs & {r"\det", "tr", r"\tr"})
    vector = bool(use.signs & {r"\times", r"\cdot", r"\|\|", r"\tilde", r"^\wedge"})
    transposed = any(f"^{sup}" in use.signs for sup in TRANSPOSES)
    if r"\mathbf" in stem.base or set(stem.accents) & {r"\vec", r"\bar", r"\hat"} or r"\vec" in stem.base:
        return (
            ("rotation", "matrix")
            if large and letter in ("R", "Q", "C")
            else ("matrix", "")
            if large
            else ("vector", "")
        )
    if large and (square or transposed):
        return ("rotation", "matrix") if letter in ("R", "Q", "C") else ("matrix", "")
    if vector and not large:
        return "vector", "scalar" if r"\cdot" in use.signs else ""
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
    lines = ["skew = [" + ", ".join(f"'{form}'" for form in (*skew, r"[#]_\times")) + "]"]
    lines += ["transpose = [" + ", ".join(f"'{form}'" for form in transposes) + "]"]
    return [*lines, r"identity = ['\mathbf{1}', '\mathbf{I}', 'I']  # ? what of these is a letter of its own"]
