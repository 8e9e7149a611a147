"""Statements and derivations found by what names them: the number as the book cites it, the name, the part."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from chasles.nearest import nearest
from chasles.statements.chapter import Chapter, Entry
from chasles.statements.derivation import Derivation

LONGEST = 4
"""How many words a number may have: "text 3.2.3 g" has three."""


class UnknownNumber(LookupError):
    """A number or name that there is not, with those near it."""


def statements_cited(book: Chapter, words: Iterable[str]) -> tuple[Entry, ...]:
    """The statements that the words name, in the book's order.

    `Thm 3.2.2` is one number, in one word or two, `(3.4)` is 3.4 and `3.4/2` is a part of it. Raises Unknown.
    """
    names = [entry.name for entry in book.entries]
    parts = {f"{entry.number}/{entry.statement.part}": entry.name for entry in book.entries}
    known = {known.casefold(): known for known in (*names, *book.numbers)} | {name: name for name in names} | parts
    found = _named(words, known, "the book has no equation", [*book.numbers, *names])
    chosen = set(found)
    return tuple(entry for entry in book.entries if chosen & {entry.number, entry.name})


def derivations_cited(known: Mapping[str, Derivation], words: Iterable[str]) -> dict[str, Derivation]:
    """The derivations by name that end at these numbers, or come past them where none ends there. Raises Unknown."""
    numbers = dict.fromkeys(number for derivation in known.values() for number in _numbers(derivation))
    meant = {word.casefold(): word.casefold() for word in (*numbers, *known)}
    found: set[str] = set()
    for cited in _named(words, meant, "no derivation leads to", [*numbers, *known]):
        ending = [name for name, derivation in known.items() if cited in (name.casefold(), *_ends(derivation))]
        found.update(ending or [name for name, derivation in known.items() if cited in _numbers(derivation)])
    return {name: derivation for name, derivation in known.items() if name in found}


def _named(words: Iterable[str], known: Mapping[str, str], missing: str, all_words: list[str]) -> Iterator[str]:
    """What a row of words names, each phrase as long as it can be."""
    pieces = [piece for word in words for piece in word.split() or [word]]
    while pieces:
        for length in range(min(LONGEST, len(pieces)), 0, -1):
            phrase = " ".join(pieces[:length]).removeprefix("(").removesuffix(")")
            found = known.get(phrase) or known.get(phrase.casefold())
            if found is not None:
                yield found
                pieces = pieces[length:]
                break
        else:
            word = pieces[0].strip("()")
            raise UnknownNumber(f"{missing} {word!r}{nearest(word, all_words)}")


def _ends(derivation: Derivation) -> tuple[str, ...]:
    return (derivation.number.casefold(), *(() if derivation.to is None else (derivation.to.number.casefold(),)))


def _numbers(derivation: Derivation) -> tuple[str, ...]:
    """Every number that the derivation is compared with."""
    return (*_ends(derivation), *(statement.number.casefold() for statement in derivation.stops))
