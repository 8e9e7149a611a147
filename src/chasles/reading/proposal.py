"""A first notation for a page: each letter that occurs, with what its typeface and its use suggest."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from functools import lru_cache
from typing import Any

from chasles.reading.declared_letters import declare_letter
from chasles.reading.equations import read_equations
from chasles.reading.glyphs import Glyph, letter_in, spelled
from chasles.reading.grouping import Unread
from chasles.reading.letter_table import LetterTable
from chasles.reading.letter_uses import INVERSES, OPERATORS, RATES, TRANSPOSES, LetterUse, letter_uses, looks
from chasles.reading.notation_file import load_notation
from chasles.reading.page_notation import PageNotation
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import ReadEquation
from chasles.reading.tokens import BadPage
from chasles.vocabulary import At, Rate, Symbol
from chasles.vocabulary.measure import Extent

__all__ = ["proposed"]

PRIMED = re.compile(r"[])] ('(?: ')*)")
KINDS = {(True, True): ("matrix", "vector"), (True, False): ("vector", "matrix"),
         (False, True): ("matrix", "scalar", "vector"), (False, False): ("scalar", "vector")}  # fmt: skip
"""What a letter may be, by whether it is bold and whether it is a capital."""
LONGEST, MOST_TRIED, ROUNDS, MOST_WORK = 150, 5, 2, 2000
"""A letter is tried in so many equations that have it, of so many tokens at most, so many times, with so much work."""


def proposed(equations: Sequence[PrintedEquation]) -> str:
    """A notation in TOML for the letters of these equations; where two meanings are likely, a question mark says so.

    Of what a letter may be, that is taken with which more of the equations can be read.
    """
    texts = [_text_of(equation) for equation in equations]
    with_tilde = sorted((k for k, text in enumerate(texts) if r"tilde " in text), key=lambda k: len(texts[k]))
    uses = letter_uses(equations, texts, OPERATORS)
    if with_tilde:
        tried = [equations[k] for k in with_tilde[:MOST_TRIED]]
        other = letter_uses(equations, texts, RATES)
        read, of_letters = (
            sum(map(_is_well_formed, _read(tried, each, load_notation("\n".join(["[operators]", *_operators(each)])))))
            for each in (uses, other)
        )
        uses = other if of_letters > read else uses
    primes = {prime for text in texts for prime in PRIMED.findall(text)}
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


def _text_of(equation: PrintedEquation) -> str:
    try:
        return " ".join(token.text for token in equation.tokens)
    except BadPage:
        return ""


def _choose_kinds(uses: dict[Glyph, LetterUse], operators: PageNotation, equations: Sequence[PrintedEquation]) -> None:
    """Let each letter be that with which most of the shortest equations that have it can be read."""
    for _ in range(ROUNDS):
        for stem, use in sorted(uses.items(), key=lambda each: -len(KINDS[looks(each[0])])):
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


def _shapes_wanted(each: ReadEquation, use: LetterUse) -> Iterator[tuple[Extent, ...]]:
    """What shape the letter has where it is set equal to something else."""
    letters = set(map(spelled, use.letters))
    for part in each.readings[0].parts if each.readings else ():
        for one, other in ((part.left, part.right), (part.right, part.left)) if part.fault else ():
            of = one.below[0] if isinstance(one, Rate | At) else one
            if isinstance(of, Symbol) and of.letter in letters and other.measure:
                yield other.shape


def _read(
    tried: Sequence[PrintedEquation], uses: dict[Glyph, LetterUse], operators: PageNotation
) -> tuple[ReadEquation, ...]:
    """What is read of the equations when the letters are what is proposed."""
    letters = LetterTable().before(operators.letters)
    notation = replace(operators, letters=letters, matched={}, most_work=MOST_WORK)
    for stem, use in uses.items():
        for glyph, said in _declared(stem, use):
            if _is_one_letter(glyph):
                declare_letter(notation, notation.letters, spelled(glyph), said)
    return read_equations(tried, notation)


def _declared(stem: Glyph, use: LetterUse) -> Iterator[tuple[Glyph, Mapping[str, Any]]]:
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


def _kinds(stem: Glyph, use: LetterUse) -> dict[str, None]:
    """What the letter may be: also a quaternion or a matrix where it is used as those are."""
    quaternion = ["quaternion"] if r"\otimes" in use.signs else []
    matrix = ["matrix"] if any(f"^{sup}" in use.signs for sup in (*TRANSPOSES, *INVERSES)) else []
    return dict.fromkeys((*KINDS[looks(stem)], *quaternion, *matrix))


def _operators(uses: dict[Glyph, LetterUse]) -> list[str]:
    """The spellings that occur of transposes and cross-product matrices."""
    signs = set().union(*(use.signs for use in uses.values()))
    skew = [form for sign, form in ((r"\tilde", r"\tilde{#}"), (r"^\wedge", r"#^\wedge")) if sign in signs]
    transposes = [f"#^{sup}" for sup in TRANSPOSES if f"^{sup}" in signs] or ["#^T"]
    skew += [r"\lfloor # \rfloor"] if r"\lfloor\rfloor" in signs else []
    lines = ["skew = [" + ", ".join(f"'{form}'" for form in (*skew, r"[#]_\times")) + "]"] if skew else []
    lines += ["transpose = [" + ", ".join(f"'{form}'" for form in transposes) + "]"]
    return [*lines, r"identity = ['\mathbf{1}', '\mathbf{I}', 'I']  # ? what of these is a letter of its own"]
