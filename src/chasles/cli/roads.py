"""The roads of the book, as `derive` uses them: loaded, and chosen by the numbers that they come to."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from chasles.cli.failures import BAD_INPUT, Failure, nearest
from chasles.statements import Chapter, DeclarationError
from chasles.statements.derivation import Derivation
from chasles.statements.roads import roads
from chasles.vocabulary.arguments import WrongArgument

__all__ = ["all_roads", "chosen_roads"]

LONGEST = 4
"""How many words a number may have: "text 3.2.3 g" has three."""


def all_roads(book: Chapter) -> dict[str, Derivation]:
    """The roads by name, in the book's order. Raises Failure for declarations that contradict each other."""
    try:
        return roads(book.package)
    except DeclarationError as error:
        raise Failure(f"the declarations contradict each other: {error}", BAD_INPUT) from error
    except WrongArgument as error:
        raise Failure(str(error), BAD_INPUT) from error


def chosen_roads(book: Chapter, words: Sequence[str]) -> dict[str, Derivation]:
    """The roads that end at these numbers, or come past them where none ends there; all without a number.

    Raises Failure naming a number to which no road leads, and those near it, and where the book has no roads.
    """
    known = all_roads(book)
    if not known:
        raise Failure(f"{book.package} declares no roads: those of its package `roads` would be walked", BAD_INPUT)
    if not words:
        return known
    found: dict[str, Derivation] = {}
    for cited in _cited(words, known):
        found |= _leading_to(cited, known)
    return {name: road for name, road in known.items() if name in found}


def _leading_to(cited: str, known: dict[str, Derivation]) -> dict[str, Derivation]:
    ending = {name: road for name, road in known.items() if cited in (name.casefold(), *_ends(road))}
    return ending or {name: road for name, road in known.items() if cited in _numbers(road)}


def _ends(road: Derivation) -> tuple[str, ...]:
    return (road.number.casefold(), *(() if road.to is None else (road.to.number.casefold(),)))


def _numbers(road: Derivation) -> tuple[str, ...]:
    """Every number that the road comes to."""
    return (*_ends(road), *(statement.number.casefold() for statement in road.stops))


def _cited(words: Sequence[str], known: dict[str, Derivation]) -> Iterator[str]:
    """The numbers and names in a row of words: `Thm 3.2.2` is one number, quoted or not."""
    numbers = dict.fromkeys(number for road in known.values() for number in _numbers(road))
    pieces = [piece for word in words for piece in word.split() or [word]]
    names = {name.casefold() for name in known}
    while pieces:
        for length in range(min(LONGEST, len(pieces)), 0, -1):
            phrase = " ".join(pieces[:length]).removeprefix("(").removesuffix(")").casefold()
            if phrase in numbers or phrase in names:
                yield phrase
                pieces = pieces[length:]
                break
        else:
            near = nearest(pieces[0].strip("()"), [*numbers, *known])
            raise Failure(f"no road leads to {pieces[0]!r}{near}; `chasles derive` names all roads", BAD_INPUT)
