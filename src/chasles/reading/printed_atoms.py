"""What carries scripts in an equation: typefaces, braces, brackets and texts in one spelling."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from typing import NamedTuple

from chasles.reading import commands
from chasles.reading.lexemes import Token, cut, spelled

BRACKETED = {"[": ("]", "bmatrix"), "(": (")", "pmatrix"), "|": ("|", "vmatrix")}
UNIT = re.compile(
    r"(?:(?:[kcmnMG]?(?:m|g|s|N|J|W|Pa|Hz|V|A|K|T)|rad|deg|h|min|ft|lbf?|rev)(?:\^?-?\d)?(?:[ /*](?=\w)|$))+", re.ASCII
)
UNBRACKETED = (r"\begin{array}", r"\begin{matrix}", r"\begin{smallmatrix}")


class PrintedAtom(NamedTuple):
    """What carries scripts, and its scripts."""

    nucleus: list[Token]
    sub: list[Token] = []  # noqa: RUF012 (never changed)
    primes: list[Token] = []  # noqa: RUF012
    sup: list[Token] = []  # noqa: RUF012


def flat(atoms: Iterable[PrintedAtom]) -> list[Token]:
    """The tokens of atoms in a row, scripts behind what carries them."""
    return [token for atom in atoms for tokens_of in atom for token in tokens_of]


def braced(atoms: Iterable[PrintedAtom], place: Token) -> list[Token]:
    """The same within braces."""
    return [place._replace(text="{"), *flat(atoms), place._replace(text="}")]


def with_scripts(nuclei: list[PrintedAtom], scripts: PrintedAtom, place: Token) -> list[PrintedAtom]:
    """Scripts go to what stands alone in its group; a group of several things keeps its braces."""
    if len(nuclei) == 1 and not any(old and new for old, new in zip(nuclei[0][1:], scripts[1:], strict=True)):
        return [PrintedAtom(*(old + new for old, new in zip(nuclei[0], scripts, strict=True)))]
    return [scripts._replace(nucleus=braced(nuclei, place))]


def styled(style: str, atoms: list[PrintedAtom], place: Token) -> list[PrintedAtom]:
    """The atoms in another typeface: each letter by itself, upright letters beside each other as one name."""
    found: list[PrintedAtom] = []
    for atom in atoms if style else []:
        letter = atom.nucleus[0].text if len(atom.nucleus) == 1 else ""
        name = None
        if style == r"\mathrm" and letter.isalnum() and found and not any(found[-1][1:]):
            name = re.fullmatch(r"\\operatorname\{(\w+)\}|\\mathrm\{(\w)\}", spelled(found[-1].nucleus))
        if name:
            text = rf"\operatorname{{{name[1] or name[2]}{letter}}}"
            found[-1] = atom._replace(nucleus=[found[-1].nucleus[0]._replace(text=text)])
        else:
            found.append(atom._replace(nucleus=_in_style(style, atom.nucleus)))
    if found and found[0].nucleus:  # the command begins where the person wrote it
        first = found[0].nucleus
        first[0] = Token(first[0].text, *place[1:])
    return found if style else atoms


def _in_style(style: str, nucleus: list[Token]) -> list[Token]:
    found: list[Token] = []
    at = 0
    while at < len(nucleus):
        token = nucleus[at]
        if token.text in commands.STYLES:  # set already: the whole of it is set once more
            start, at, depth = at, at + 2, 1
            while depth and at < len(nucleus):
                depth, at = depth + (nucleus[at].text == "{") - (nucleus[at].text == "}"), at + 1
            inside, wrapped = nucleus[start:at], token.text != style
        else:
            inside, at = [token], at + 1
            wrapped = token.text in commands.LETTERS or token.text.isalnum()
        signs = [token._replace(text=text) for text in (style, "{", "}")]
        found += [*signs[:2], *inside, signs[2]] if wrapped else inside
    return found


def without_empty_cells(inside: list[Token]) -> list[Token]:
    """A matrix without columns that are there for their space alone."""
    rows = [cut(row, ("&",)) for row in cut(inside, (r"\\",)) if row]
    width = max(map(len, rows), default=0)
    kept = [at for at in range(width) if any(any(row[at : at + 1]) for row in rows)]
    if not kept or not all(len(row) > max(kept) and all(row[at] for at in kept) for row in rows):
        kept = [*range(width)]  # an empty cell beside full ones may be a zero
    found: list[Token] = []
    for row in rows:
        place = next(token for cell in [*row, inside] for token in cell)
        found += [place._replace(text=r"\\")] if found else []
        for at in kept[: max(len(row), 1)]:
            found += [place._replace(text="&")] if at != kept[0] else []
            found += row[at] if at < len(row) else []
    return found


def bracket(atoms: list[PrintedAtom]) -> None:
    """An array between brackets is a matrix with these brackets."""
    if len(atoms) < 3 or any(atoms[-3][1:]) or any(atoms[-2][1:]) or len(atoms[-3].nucleus) != 1:
        return
    opening, inside, closing = atoms[-3].nucleus[0], atoms[-2].nucleus, atoms[-1].nucleus
    if opening.text == r"\{" and not closing and inside and inside[0].text in UNBRACKETED:
        begin, end = (inside[at]._replace(text=rf"\{side}{{cases}}") for at, side in ((0, "begin"), (-1, "end")))
        atoms[-3:] = [PrintedAtom([begin, *inside[1:-1], end])]
        return
    close, name = BRACKETED.get(opening.text, ("", ""))
    if close and [token.text for token in closing] == [close] and inside and inside[0].text in UNBRACKETED:
        ends = opening._replace(text=rf"\begin{{{name}}}"), closing[0]._replace(text=rf"\end{{{name}}}")
        atoms[-3:] = [atoms[-1]._replace(nucleus=[ends[0], *inside[1:-1], ends[1]])]


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
