"""Letters as a notation file declares them: what each is, its shape, its unit, and what it stands for."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from chasles.nearest import nearest
from chasles.reading.atoms import Unread
from chasles.reading.glyphs import Glyph, letter_in, spelled
from chasles.reading.letter_table import BadNotation, LetterTable, named_apart, require
from chasles.reading.lexemes import BadPage
from chasles.reading.page_notation import PageNotation
from chasles.vocabulary import NO_DIMENSION, Dimension, Inverse, Misfit, Node, Symbol, Transpose, uniform
from chasles.vocabulary.dimension import has_units
from chasles.vocabulary.families import Index
from chasles.vocabulary.parts import part

KINDS: dict[str, tuple[int, int]] = {
    "scalar": (1, 1), "angle": (1, 1), "integer": (1, 1), "vector": (3, 1), "unit vector": (3, 1), "point": (3, 1),
    "rotation": (3, 3), "symmetric": (3, 3), "skew": (3, 3), "matrix": (3, 3), "array": (3, 1), "quaternion": (4, 1),
    "unit quaternion": (4, 1), "positive": (1, 1), "positive-definite": (3, 3), "imaginary unit": (1, 1),
}  # fmt: skip
"""What a letter may be, and the shape that it then has unless the file says another."""
TYPEFACE_NAMES = ("mathbf", "boldsymbol", "mathrm", "operatorname")
RUN = re.compile(r"(?<!\S)[A-Za-z](?: [A-Za-z](?!\S))+")
SIGNS = {"*": "star", "+": "plus", "-": "minus"}
"""How signs in a letter's scripts are called in its name."""
OTHERS = ("component", "entry", "index")
OTHERWISE = ("matrix", "scalar", "symmetric")
"""What else a letter may be said to be, `or`: what is found only if it is not that is ambiguous then."""
KNOWN_KEYS: dict[str, type] = {
    "is": str, "unit": str, "constant": bool, "positive": bool, "shape": object, "size": int, "of": str,
    "inverse": str, "stands_for": str, "meaning": str, "or": str,
}  # fmt: skip
"""What may be said of a letter, and of which type it is; the shape is checked where it is read."""
UNITS = {"m": Dimension(1), "kg": Dimension(0, 1), "s": Dimension(0, 0, 1), "rad": NO_DIMENSION, "1": NO_DIMENSION,
         "N": Dimension(1, 1, -2), "J": Dimension(2, 1, -2), "W": Dimension(2, 1, -3), "Hz": Dimension(0, 0, -1),
         "Pa": Dimension(-1, 1, -2)}  # fmt: skip


def declare_letter(notation: PageNotation, table: LetterTable, text: str, said: Any) -> None:
    """Enter what the file says of a letter; raises `BadNotation` for what is unknown or does not go together."""
    where = f"[symbols] '{text}'"
    said = {"is": said} if isinstance(said, str) else said
    if not isinstance(said, Mapping):
        raise BadNotation(f"{where}: expected a table such as {{ is = 'vector' }}")
    for key in said:
        if key not in KNOWN_KEYS:
            raise BadNotation(
                f"{where} has no {key!r}{nearest(key, list(KNOWN_KEYS))}: it takes {', '.join(KNOWN_KEYS)}"
            )
        require(said[key], KNOWN_KEYS[key], f"{where} {key}")
    try:
        letter = letter_in(text)
    except (Unread, BadPage) as problem:
        raise BadNotation(f"{where}: {problem}") from None
    if letter is None:
        raise BadNotation(f"{where} is not one letter with its accents and scripts")
    if table.said.setdefault(letter, (text, said))[1] != said:
        raise BadNotation(f"{where}: '{table.said[letter][0]}' is the same letter, and says something else of it")
    notation.matched[text] = False
    kind = said.get("is", "array" if "stands_for" in said else "")
    if kind == "index":
        notation.indices[letter.base] = Index(letter.base)
    elif kind in ("component", "entry"):
        _component(notation, table, letter, text, said, where)
    elif kind in KINDS:
        _quantity(notation, table, letter, text, said, kind, where)
    else:
        known = [*KINDS, *OTHERS]
        raise BadNotation(f"{where}: is = {kind!r}{nearest(str(kind), known)}; expected one of {', '.join(known)}")


def _quantity(notation: PageNotation, table: LetterTable, letter: Glyph, text: str, said: Mapping[str, Any],
              kind: str, where: str) -> None:  # fmt: skip
    rows, columns = _shape(said, kind, where)
    notation.sizes.update((rows, columns))
    notation.quaternions |= kind.endswith("quaternion")
    dimension = _dimension(said.get("unit", ""), where)
    in_units = has_units(notation.home)
    measure = uniform((rows, columns), dimension if in_units else NO_DIMENSION)
    if said.get("or", OTHERWISE[0]) not in OTHERWISE:
        raise BadNotation(f"{where}: or = {said['or']!r}; expected one of {', '.join(OTHERWISE)}")
    other = f"or {said['or']}" if "or" in said else ""
    meaning = " ".join(filter(None, ("positive" if said.get("positive") else kind, said.get("meaning", ""), other)))
    inverse = said.get("inverse")
    if inverse is not None and "{swapped}" not in inverse.replace("swapped", "{swapped}"):
        raise BadNotation(f"{where}: inverse = {inverse!r} does not say 'swapped', as in 'R_{{swapped}}'")
    made: dict[Glyph, Node] = {}
    waiting: set[Glyph] = set()

    def symbol(found: Glyph) -> Node:
        notation.matched[text] = True
        if found in made:
            return made[found]
        if found in waiting:
            raise BadNotation(f"{where}: what it stands for leads back to it")
        waiting.add(found)
        latex = text if found == letter else spelled(found)
        stands_for: Node | None = None
        swapped = replace(found, sub=" ".join(reversed(found.sub.split()))) if inverse is not None else found
        if swapped != found and swapped in made:
            stands_for = (Transpose if kind == "rotation" else Inverse)(made[swapped])
        elif "stands_for" in said:
            stands_for = _meant(notation, said["stands_for"], where)
        size = measure if stands_for is None or stands_for.measure is None else stands_for.measure
        constant = bool(said.get("constant", False))
        waiting.discard(found)
        own = Symbol(named(found), latex, size, meaning, constant, stands_for, notation.home, in_units)
        made[found] = named_apart(own, notation.names)
        return made[found]

    table.add(letter, symbol, text)
    if "stands_for" in said:
        notation.checks.append(lambda: symbol(letter))


def _shape(said: Mapping[str, Any], kind: str, where: str) -> tuple[int, int]:
    rows, columns = KINDS[kind]
    if "size" in said:
        rows, columns = said["size"], said["size"] if rows == columns and rows > 1 else columns
    shape = said.get("shape", (rows, columns))
    if not (isinstance(shape, list | tuple) and len(shape) == 2 and all(isinstance(k, int) and k > 0 for k in shape)):
        raise BadNotation(f"{where}: shape = {shape!r}; expected [rows, columns]")
    return shape[0], shape[1]


def _dimension(unit: str, where: str) -> Dimension:
    """The dimension of a unit such as "kg m^2/s"."""
    total = NO_DIMENSION
    for place, units in enumerate(unit.split("/")):
        for word in units.replace("*", " ").replace(".", " ").split():
            name, _, power = word.partition("^")
            if name not in UNITS or not re.fullmatch(r"-?\d*", power):
                raise BadNotation(
                    f"{where}: unit = {unit!r}; expected one made of {', '.join(UNITS)}, as in 'kg m^2/s'"
                )
            of = UNITS[name] ** int(power or 1)
            total = total / of if place else total * of
    return total


def _component(notation: PageNotation, table: LetterTable, letter: Glyph, text: str, said: Mapping[str, Any],
               where: str) -> None:  # fmt: skip
    """Letters for the entries of a column, as many as there are alternatives; of a pattern, by their numbers."""
    marks = [mark.strip() for mark in letter.sub.split("|")]
    whole = letter_in(said.get("of", ""))
    if whole is None or not next(table.meanings(whole), None):
        raise BadNotation(f"{where}: of = {said.get('of')!r} is no letter declared before it")

    def meaning(row: int, mark: str) -> Callable[[Glyph], Node]:
        def make(_: Glyph) -> Node:
            notation.matched[text] = True
            node, _rest = next(table.meanings(whole))
            return replace(part(node, row), mark=mark)

        return make

    def numbered(found: Glyph) -> Node:
        notation.matched[text] = True
        node, _rest = next(table.meanings(whole))
        words = found.sub.replace(" ", "")
        numbers = words.split(",") if "," in words else list(words)
        if not all(number.isdigit() for number in numbers) or len(numbers) > 2:
            raise Unread(f"{spelled(found)} names no entry of {node}")
        try:
            return part(node, int(numbers[0]) if len(numbers) == 1 else (int(numbers[0]), int(numbers[1])))
        except Misfit as misfit:
            raise Unread(str(misfit)) from None

    if "#" in letter.sub:
        table.add(letter, numbered, text)
        return
    for row, mark in enumerate(marks, 1):
        table.add(replace(letter, sub=mark), meaning(row, mark), text)


def _meant(notation: PageNotation, latex: str, where: str) -> Node:
    """The expression that an abbreviation stands for."""
    from chasles.reading.equations import expressions

    try:
        found = expressions(latex, notation)
    except (Unread, BadPage, Misfit) as problem:
        raise BadNotation(f"{where}: stands_for = {latex!r}: {problem}") from None
    return found[0]


def named(letter: Glyph) -> str:
    """A name for a symbol, in letters and digits; what stands above it is told from what stands below.

    Letters side by side in a script are one word.
    """
    below, above = (
        "_".join(
            SIGNS.get(word, word)
            for each in said
            for word in re.findall(r"[^\W_]+|[*+-]", RUN.sub(lambda run: run[0].replace(" ", ""), each))
            if word not in TYPEFACE_NAMES
        )
        for said in ((*letter.before, letter.base, *letter.accents, letter.sub), letter.sups)
    )
    name = (below or letter.base) + (f"^{above}" if above else "") + "'" * letter.primes
    arguments = [word.strip("\\") for word in letter.arguments.split() if word.strip("\\") not in TYPEFACE_NAMES]
    return name + (f"({' '.join(arguments)})" if arguments else "")
