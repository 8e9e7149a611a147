"""Typefaces, scripts, brackets and texts in one spelling."""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace

from chasles.reading import commands
from chasles.reading.atoms import ROW_END, Atom, Atoms, lines_of, single
from chasles.reading.lexemes import Token, cut, spelled

BRACKETED = {"[": ("]", "bmatrix"), "(": (")", "pmatrix"), "|": ("|", "vmatrix")}
NAME = re.compile(r"[A-Za-z]+(?:\\?_[A-Za-z0-9]+)*")
UNIT = re.compile(
    r"(?:(?:[kcmnMG]?(?:m|g|s|N|J|W|Pa|Hz|V|A|K|T)|rad|deg|h|min|ft|lbf?|rev)(?:\^?-?\d)?(?:[ /*](?=\w)|$))+", re.ASCII
)
UNBRACKETED = ("array", "matrix", "smallmatrix")
Scripts = tuple[Atoms | None, int, tuple[Atoms, ...]]


def with_scripts(nuclei: Sequence[Atom], scripts: Scripts, place: Token) -> list[Atom]:
    """Scripts go to what stands alone in its group, and of letters to the last; other groups keep their braces."""
    sub, primes, sups = scripts
    if len(nuclei) == 1:
        (one,) = nuclei
        if not ((one.sub is not None and sub is not None) or (one.primes and primes) or (one.sups and sups)):
            sub = one.sub if sub is None else sub
            return [replace(one, sub=sub, primes=one.primes + primes, sups=one.sups + sups)]
    are_letters = all(atom.kind == "LETTER" or atom.text in commands.STYLES for atom in nuclei)
    if len(nuclei) > 1 and are_letters and commands.FUNCTIONS.isdisjoint(atom.text for atom in nuclei):
        return [*nuclei[:-1], *with_scripts(nuclei[-1:], scripts, place)]  # as print shows it
    return [Atom("GROUP", "", place._replace(text="{"), (tuple(nuclei),), (), sub, primes, sups)]


def styled(style: str, atoms: list[Atom], place: Token) -> list[Atom]:
    """The atoms in another typeface: each letter by itself, upright letters beside each other as one name."""
    found: list[Atom] = []
    for atom in atoms if style else []:
        name = _upright_name(found[-1]) if style == r"\mathrm" and found and atom.text.isalnum() else ""
        if name and not atom.arguments:
            text = rf"\operatorname{{{name}{atom.text}}}"
            found[-1] = replace(atom, kind="LETTER", text=text, place=found[-1].place)
        else:
            found.append(_in_style(style, atom))
    if found:  # the command begins where the person wrote it
        found[0] = replace(found[0], place=Token(found[0].place.text, *place[1:]))
    return found if style else atoms


def _upright_name(atom: Atom) -> str:
    """The letters of an upright name without scripts."""
    if atom.is_marked:
        return ""
    if atom.text == r"\mathrm":
        name = re.fullmatch(r"(\w)", " ".join(each.text for each in atom.arguments[0] if not each.is_marked))
    else:
        name = re.fullmatch(r"\\operatorname\{(\w+)\}", atom.text)
    return name[1] if name else ""


def _in_style(style: str, atom: Atom) -> Atom:
    """The atom with each letter in it in a typeface, scripts as they are; of what has one already the whole."""
    if atom.arguments and atom.text not in commands.STYLES:
        held = (tuple(_in_style(style, each) for each in argument) for argument in atom.arguments)
        return replace(atom, arguments=tuple(held))
    is_letter = atom.text in commands.LETTERS or atom.text.isalnum()
    if atom.text == style or not (atom.arguments or is_letter):
        return atom
    place = atom.place._replace(text=style)
    return replace(atom, kind="COMMAND", text=style, place=place, arguments=((atom.bare,),))


def without_empty_cells(inside: list[Atom]) -> list[Atom]:
    """A matrix without columns that are there for their space alone, and without commas at the end of cells."""
    rows = [[_unpunctuated(cell) for cell in cut(row, ("&",))] for row in cut(inside, (ROW_END,)) if row]
    width = max(map(len, rows), default=0)
    kept = [at for at in range(width) if any(any(row[at : at + 1]) for row in rows)]
    if not kept or not all(len(row) > max(kept) and all(row[at] for at in kept) for row in rows):
        kept = [*range(width)]  # an empty cell beside full ones may be a zero
    found: list[Atom] = []
    for row in rows:
        place = next(atom for cell in [*row, inside] for atom in cell).place
        found += [single(place._replace(text=ROW_END))] if found else []
        for at in kept[: max(len(row), 1)]:
            found += [single(place._replace(text="&"))] if at != kept[0] else []
            found += row[at] if at < len(row) else []
    return found


def _unpunctuated(cell: list[Atom]) -> list[Atom]:
    return cell[:-1] if cell and cell[-1].text in (",", ";") else cell


def array_in_brackets(atoms: list[Atom]) -> None:
    r"""An array between brackets is a matrix with these brackets; scripts of \right. are put on what it closes."""
    closing = atoms[-1] if atoms and atoms[-1].kind in ("CLOSE", "BAR", "END") else None
    if closing is None:
        return
    if _row_with_blanks(atoms):
        return
    array = atoms[-2] if len(atoms) > 2 else closing
    if array.kind == "GRID" and array.text in UNBRACKETED and not (array.is_marked or atoms[-3].is_marked):
        close, name = BRACKETED.get(atoms[-3].text, ("", ""))
        if (name and closing.text == close) or (atoms[-3].text == r"\{" and closing.kind == "END"):
            name = name or "cases"
            place = atoms[-3].place._replace(text=rf"\begin{{{name}}}")
            atoms[-3:] = [replace(closing, kind="GRID", text=name, place=place, arguments=array.arguments)]
            return
    if atoms.pop().kind != "END":
        atoms.append(closing)
    elif closing.is_marked:
        atoms[-1:] = with_scripts(atoms[-1:], (closing.sub, closing.primes, closing.sups), closing.place)


def _row_with_blanks(atoms: list[Atom]) -> bool:
    """Make a row of what stands in square brackets with wide blanks between, where none of these may set off a sign."""
    depth, start = 0, len(atoms)
    while start and (depth or start == len(atoms)):
        start -= 1
        depth += (atoms[start].text == "]") - (atoms[start].text == "[")
    if atoms[-1].text != "]" or depth or atoms[start].is_marked:
        return False
    cells = lines_of(atoms[start + 1 : -1], (r"\quad",))
    ends = [atom.kind for cell in cells for atom in (cell[:1] + cell[-1:])]
    if len(cells) < 2 or not all(cells) or {"SIGN", "INFIX", "RELATION", "COMMA", "LAYOUT"} & {*ends}:
        return False
    place = atoms[start].place
    between = single(place._replace(text="&"))
    inside = tuple(piece for k, cell in enumerate(cells) for piece in (*((between,) if k else ()), *cell))
    made = replace(atoms[-1], kind="GRID", text="bmatrix", place=place._replace(text=r"\begin{bmatrix}"))
    atoms[start:] = [replace(made, arguments=(inside,))]
    return True


def text_atoms(command: Token, inside: list[Token], atoms_of: Callable[[list[Token]], list[Atom]]) -> list[Atom]:
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
        return styled(style, [single(command._replace(text=words))], command)
    if UNIT.fullmatch(words) and not words.isalpha():
        return [single(command._replace(text=rf"\operatorname{{{words}}}"))]
    words = words[:-1] if words[:-1].isalpha() and words[-1] == "." else words  # an abbreviation
    is_apart = inside[0].text == " " == inside[-1].text  # a word of another language, perhaps
    is_connective = is_apart or "\\" + words.lower() in commands.CONNECTIVES
    is_name = bool(NAME.fullmatch(words)) and not is_connective
    return [single(command._replace(text=rf"\{'operatorname' if is_name else 'text'}{{{words}}}"))]
