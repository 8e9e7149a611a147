"""What a person says of single equations of a page: their roles, what they define, and what they follow from."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from operator import itemgetter
from typing import Any

from chasles.pages.attempts import named
from chasles.pages.quantities import Quantity, quantity, symbols_in
from chasles.reading.atoms import Unread
from chasles.reading.equations import expressions, read_equations
from chasles.reading.letter_table import BadNotation
from chasles.reading.lexemes import BadPage
from chasles.reading.page_notation import PageNotation
from chasles.reading.printed import PrintedEquation
from chasles.reading.reading import Part
from chasles.statements import Claim
from chasles.vocabulary import At, Symbol, plain

DEFINING = (r"\equiv", ":=", r"\triangleq", r"\coloneqq", r"\doteq", "≡")
"""The signs by which something is defined."""
EQUAL = ("=", *DEFINING)
Given = tuple[str, Claim]
"""A premise, and how it is told."""


@dataclass(frozen=True, slots=True)
class EquationNote:
    """The `role` of an equation, what it is a definition `of`, and its premises; where none are given, the page's."""

    role: str = ""
    of: Quantity | None = None
    given: tuple[Given, ...] | None = None


NOTHING = EquationNote()
"""Nothing is said of an equation."""


def notes_of(notation: PageNotation, relations: Mapping[str, Sequence[Claim]]) -> dict[tuple[str, int], EquationNote]:
    """What is said of each relation of the page, by the name of its equation and its part, or for all of its equation.

    `relations` are those of the page, by the names of its equations. Raises `BadNotation` for what is given and neither
    stands on the page nor can be read.
    """
    found = {}
    for name, claims in relations.items():
        whole = notation.notes.get(name, {})
        is_of_all = whole.get("role") == "definition" or all(map(is_defining, claims))
        for claim in claims:
            own = notation.notes.get(f"{name}/{claim.part}", {})
            if "reading" in own:
                raise BadNotation(f"[equations] '{name}/{claim.part}': give one reading for the whole of '{name}'")
            is_of_others = is_defining(claim) and not is_of_all
            said = own if "role" in own or is_of_others else {**whole, **own}
            if said:
                found[name, claim.part] = _note_of(name, said, notation, relations, [claim] if own else claims)
    return found


def _note_of(
    name: str,
    said: Mapping[str, Any],
    notation: PageNotation,
    relations: Mapping[str, Sequence[Claim]],
    among: Sequence[Claim],
) -> EquationNote:
    given = said.get("given")
    if "of" in said and said.get("role") != "definition":
        raise BadNotation(f"[equations] '{name}' of: 'of' belongs to a definition: say role = 'definition'")
    return EquationNote(
        said.get("role", ""),
        _defined(name, said["of"], notation, among) if "of" in said else None,
        None
        if given is None
        else tuple(each for text in given for each in _given(name, text, notation, relations, among)),
    )


def _given(
    name: str, text: str, notation: PageNotation, relations: Mapping[str, Sequence[Claim]], among: Sequence[Claim]
) -> Iterator[Given]:
    number, _, part = text.partition("/")
    if text in relations:
        yield from ((named(claim), claim) for claim in relations[text])
    elif number in relations and any(str(claim.part) == part for claim in relations[number]):
        yield from ((named(claim), claim) for claim in relations[number] if str(claim.part) == part)
    else:
        where = f"[equations] '{name}' given '{text}'"
        spoken = symbols_in(side for claim in among for side in claim.printed)
        for said in parts_of(text, notation, where, spoken):
            told = f"{plain(said.left)} = {plain(said.right)}"
            yield told, Claim(told, said.left, said.right, sic=True)


def parts_of(text: str, notation: PageNotation, where: str, spoken: Collection[Symbol] = ()) -> tuple[Part, ...]:
    """The equations that a notation says in LaTeX; raises `BadNotation` for what is none that can be read.

    Of several readings that is meant in which the most symbols are `spoken` of.
    """
    (found,) = read_equations((PrintedEquation(text),), notation)
    strange = [(len(symbols_in(reading.sides).difference(spoken)), reading.parts) for reading in found.readings]
    parts = min(strange, key=itemgetter(0), default=(0, ()))[1]
    relations = [f"{part.sign} is no sign of an equation" for part in parts if part.sign not in EQUAL]
    why = [found.why] if not parts else [*relations, *(part.fault for part in parts if part.fault)]
    if why:
        raise BadNotation(f"{where}: expected an equation, and {why[0]}")
    return parts


def _defined(name: str, letter: str, notation: PageNotation, relations: Sequence[Claim]) -> Quantity:
    """The quantity that a letter is, which stands alone on a side of a relation."""
    try:
        found = [key for node in expressions(letter, notation) if (key := quantity(node)) is not None]
    except (Unread, BadPage) as problem:
        raise BadNotation(f"[equations] '{name}' of '{letter}': {problem}") from None
    if not found:
        raise BadNotation(f"[equations] '{name}' of '{letter}': expected a letter alone")
    alone = [key for claim in relations for side in claim.printed if (key := quantity(side)) in found]
    if not alone:
        raise BadNotation(f"[equations] '{name}' of '{letter}': it is alone on neither side")
    return alone[0]


def is_defining(claim: Claim) -> bool:
    """Whether it is printed as definitions are: by its sign, or of a symbol with its argument."""
    return claim.sign in DEFINING or isinstance(claim.left, At)
