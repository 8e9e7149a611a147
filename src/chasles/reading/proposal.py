"""A first notation for a page: each letter that occurs, with what its typeface and its use suggest."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from collections.abc import Set as AbstractSet
from dataclasses import replace
from functools import lru_cache
from typing import Any

from chasles.reading.atoms import TYPEFACES, Unread
from chasles.reading.commands import LETTERS, MARKS
from chasles.reading.glyphs import Glyph, in_latex, letter_in, spelled
from chasles.reading.letter_names import BARE, IDENTITIES, OPERATORS, RATES, TRANSPOSES, NameMarks, inertias
from chasles.reading.letter_uses import SKEW, LetterUse, looks
from chasles.reading.lexemes import BadPage
from chasles.reading.printed import PrintedEquation, Remark
from chasles.reading.prose import POSITIVE, Told, base_of, said_of_letters
from chasles.reading.radicands import letters_under_roots
from chasles.reading.shape_search import shaped_letters

KNOWN = LETTERS | MARKS | TYPEFACES
ENTRY = re.compile(r"[1-9] ?,? ?[1-9]")
"""The numbers of an entry, which is known by its matrix."""
PRIMED = re.compile(r"[])] ('(?: ')*)")
PROPOSED = """\
proposed = true  # what does not fit together is left open; delete this line once it says what the letters are"""


def proposed(equations: Sequence[PrintedEquation], remarks: Iterable[Remark] = ()) -> str:
    """A notation in TOML for the letters of these equations; where two meanings are likely, a question mark says so.

    Of what a letter may be, that is taken with which more of the equations can be read; what the `remarks` in the prose
    say of it comes first.
    """
    named = dict.fromkeys(each for equation in equations for each in equation.beside if each.label)
    equations = [*equations, *named]
    texts = [equation.text for equation in equations]
    told = said_of_letters(remarks, "\n".join(texts))
    said = {letter: base_of(each) for letter, each in told.items()}
    inertia = set().union(*map(inertias, texts))
    bare = frozenset(BARE) - inertia
    marks = NameMarks.on_page(texts, OPERATORS, bare)
    uses, faults = shaped_letters(equations, texts, marks, said)
    told = {**dict.fromkeys(letters_under_roots(texts), POSITIVE), **told}
    if any(r"tilde " in text for text in texts):
        without = NameMarks.on_page(texts, RATES, bare)
        other, fewer = shaped_letters(equations, texts, without, said)
        is_other = any(use.signs & SKEW for use in other.values())  # the page has another sign of a cross product
        if sum(fewer.values()) - is_other < sum(faults.values()):
            uses, faults, marks = other, fewer, without
    primes = {prime for text in texts for prime in PRIMED.findall(text)}
    signs = ", ".join(f'"#{each.replace(" ", "")}"' for each in sorted(primes))
    quantity = [f"quantity = [{signs}]  # ? what these marks make of an expression"] if primes else []
    operators = [*_operators(uses, inertia), *quantity]
    marked = {word for stem, use in uses.items() if "marked" in use.signs for word in stem.base.split()}
    letters = KNOWN | marked - {word for stem, use in uses.items() if "{}" in use.signs for word in stem.base.split()}
    of_operators = any(
        (use.has_order and use.kind == "scalar" and looks(stem)[1]) or r"^\dagger" in use.signs
        for stem, use in uses.items()
    )
    lines = ["[operators]", *operators, "", "[symbols]", *_lines_of(uses, told, letters, of_operators)]
    for section in dict.fromkeys(equations[place].section for place in faults):
        places = [place for place, equation in enumerate(equations) if equation.section == section]
        if section and len(places) < len(equations):
            here = [equations[place] for place in places], [texts[place] for place in places]
            other, fewer = shaped_letters(*here, marks, said)
            anew = {stem: use for stem, use in other.items() if stem not in uses or use.meant != uses[stem].meant}
            if anew and sum(fewer.values()) < sum(faults.get(place, 0) for place in places):
                lines += ["", f"[section.{_quoted(section)}.symbols]", *_lines_of(anew, told, letters, True)]
    return "\n".join([*lines, "", "[page]", PROPOSED]) + "\n"


def _lines_of(
    uses: Mapping[Glyph, LetterUse], told: Told, letters: AbstractSet[str], of_operators: bool
) -> Iterator[str]:
    """What is said of the letters, a line each; of one that is made of others than known `letters`, that alone."""
    seen: set[Glyph] = set()
    for stem, use in uses.items():
        question = f"  # ? or {use.other}" if use.other not in ("", use.kind) else ""
        doubt = _otherwise(stem, use, of_operators)
        for glyph, said in _declared(stem, use, uses, told):
            if glyph in seen:  # the components of one vector may be of several families
                continue
            seen.add(glyph)
            of = f", of = {_quoted(said['of'])}" if "of" in said else ""
            of += f", shape = {said['shape']}" if "shape" in said else ""
            of += "".join(f", {name} = true" for name in ("constant", "positive") if said.get(name))
            of += f', or = "{doubt}"' if doubt and said["is"] == use.kind and glyph not in told else ""
            if unknown := [word for word in stem.base.split() if word[0] == "\\" and word not in letters]:
                yield f"# {unknown[-1]}: no command of LaTeX; --macros FILE defines it, or say here what it is"
                continue
            known = _is_one_letter(glyph)
            is_sure = glyph in told or (of and doubt != "symmetric")
            entry = f'{_quoted(spelled(glyph))} = {{ is = "{said["is"]}"{of} }}{"" if is_sure else question}'
            yield entry if known else f"# {spelled(glyph)}: several letters in one; say what it is"


def _otherwise(stem: Glyph, use: LetterUse, of_operators: bool) -> str:
    """What else than proposed a letter may be, where that is as likely: then what holds of one alone is in doubt.

    Letters that the page multiplies in both orders may be matrices or operators, and where one of them is a capital,
    so may all capitals be; a cross may stand between numbers. What it never transposes may be symmetric.
    """
    bold, large = looks(stem)
    if use.kind == "matrix" and not use.shape and use.signs.isdisjoint(f"^{each}" for each in (*TRANSPOSES, "- T")):
        return "symmetric"
    are_entries = all(ENTRY.fullmatch(glyph.sub) for glyph in use.letters)
    is_number = use.is_number or are_entries or ("e" in use.signs and not large)
    if use.kind == "scalar" and not is_number and (use.has_order or (large and of_operators)):
        return "matrix"
    is_vector = bold or use.signs & {r"\cdot", r"\|\|", *SKEW, *(f"^{each}" for each in TRANSPOSES)}
    return "scalar" if use.kind == "vector" and r"\times" in use.signs and not is_vector else ""


def _declared(
    stem: Glyph, use: LetterUse, uses: Mapping[Glyph, LetterUse], told: Told
) -> Iterator[tuple[Glyph, dict[str, Any]]]:
    """What is said of a letter: with its subscripts, by a pattern for many of them, and of a vector's components.

    The entries of a matrix, with their numbers, need no word.
    """
    whole = Glyph(stem.base, stem.accents)
    glyphs = list(use.letters)
    is_of_matrix = stem.sub and whole in uses and uses[whole].kind in ("matrix", "rotation") and use.kind == "scalar"
    entries = [glyph for glyph in glyphs if is_of_matrix and ENTRY.fullmatch(glyph.sub)]
    glyphs = [glyph for glyph in glyphs if glyph not in entries]
    if stem.sub and whole in uses and uses[whole].kind == "vector" and not uses[whole].shape and use.kind == "scalar":
        if any(glyph.sub in ("x", "y", "z") for glyph in glyphs):
            yield replace(whole, sub="x|y|z"), {"is": "component", "of": spelled(whole)}
        glyphs = [glyph for glyph in glyphs if glyph.sub not in ("x", "y", "z")]
    is_whole = stem.sub in ("", "#") and all(glyph == replace(stem, sub=glyph.sub) for glyph in glyphs)
    shape = {"shape": list(use.shape)} if use.shape else {}
    fitting = {} if shape else {each: told[each] for each in glyphs if each in told and base_of(told[each]) == use.kind}
    if len(glyphs) > 3 and not entries and is_whole:
        glyphs = [*fitting, replace(stem, sub="##")]
    yield from ((glyph, {"is": use.kind, **shape, **fitting.get(glyph, {})}) for glyph in glyphs)


@lru_cache(maxsize=4096)
def _is_one_letter(glyph: Glyph) -> bool:
    """Whether it is read as the letter that it is once it is written."""
    try:
        return "#" in glyph.sub or "|" in glyph.sub or letter_in(spelled(glyph)) == glyph
    except (Unread, BadPage):
        return False


def _quoted(text: str) -> str:
    return json.dumps(text) if "'" in text else f"'{text}'"


def _operators(uses: dict[Glyph, LetterUse], inertia: set[str]) -> list[str]:
    """The spellings that occur of transposes, cross-product matrices and identities."""
    signs = set().union(*(use.signs for use in uses.values()))
    of_bold = set().union(*(use.signs for stem, use in uses.items() if looks(stem)[0]))
    skew = [
        form
        for sign, form in ((r"\tilde", r"\tilde{#}"), (r"^\wedge", r"#^\wedge"), (r"^\times", r"#^\times"))
        if sign in signs
    ]
    transposes = [f"#^{sup}" for sup in TRANSPOSES if f"^{sup}" in signs] or ["#^T"]
    skew += [r"\lfloor # \rfloor"] if r"\lfloor\rfloor" in of_bold else []
    lines = ["skew = [" + ", ".join(f"'{form}'" for form in (*skew, r"[#]_\times")) + "]"] if skew else []
    lines += ["transpose = [" + ", ".join(f"'{form}'" for form in transposes) + "]"]
    ones = ", ".join(f"'{in_latex(each)}'" for each in IDENTITIES if each not in inertia)
    return [*lines, f"identity = [{ones}]  # ? what of these is a letter of its own"]
