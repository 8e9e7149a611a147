"""Texts in an equation: names, units, formulas, and words between equations."""

from __future__ import annotations

import re
from collections.abc import Callable

from chasles.reading import commands
from chasles.reading.lexemes import Token, spelled
from chasles.reading.printed_atoms import PrintedAtom, styled

UNIT = re.compile(
    r"(?:(?:[kcmnMG]?(?:m|g|s|N|J|W|Pa|Hz|V|A|K|T)|rad|deg|h|min|ft|lbf?|rev)(?:\^?-?\d)?(?:[ /*](?=\w)|$))+", re.ASCII
)


def text_atoms(
    command: Token, inside: list[Token], atoms_of: Callable[[list[Token]], list[PrintedAtom]]
) -> list[PrintedAtom]:
    """A text in an equation: a formula in it, a name such as tr, punctuation, or words between equations."""
    words = " ".join(spelled(each for each in inside if each.text not in commands.TEXT).split())
    words = words if "$" in words else re.sub(r"[{}]", "", words).strip()
    if formula := re.fullmatch(r"(\\boldmath)?\s*\$[^$]*\$\s*(?:\\unboldmath)?", words):
        start, end = (at for at, token in enumerate(inside) if token.text == "$")
        return styled(r"\boldsymbol" if formula[1] else "", atoms_of(inside[start + 1 : end]), command)
    if not words:
        return []
    if len(words) == 1:
        style = commands.TEXT_STYLES.get(command.text, r"\mathrm") if words.isalpha() else ""
        return styled(style, [PrintedAtom([command._replace(text=words)])], command)
    if UNIT.fullmatch(words) and not words.isalpha():
        return [PrintedAtom([command._replace(text=rf"\operatorname{{{words}}}")])]
    words = words[:-1] if words[:-1].isalpha() and words[-1] == "." else words  # an abbreviation
    is_name = words.isalpha() and words.isascii() and "\\" + words.lower() not in commands.CONNECTIVES
    return [PrintedAtom([command._replace(text=rf"\{'operatorname' if is_name else 'text'}{{{words}}}")])]
