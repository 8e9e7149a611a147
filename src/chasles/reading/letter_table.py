"""The table in which a notation says what letters mean."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import chain
from typing import Any

from chasles.reading.glyphs import Glyph, letter_in, spelled
from chasles.vocabulary import PI, Node, Symbol
from chasles.vocabulary.letters import entry_names

MAY_LOSE_BOLD = re.compile(r"\\[A-Za-z]+$")
Meaning = Callable[[Glyph], Node]
TYPES: dict[type, str] = {str: "text in quotes", bool: "true or false", int: "a whole number", dict: "a table"}
"""How a type is told to who writes a notation."""


class BadNotation(ValueError):
    """A notation that cannot be used: its text says in one line what is wrong and what is expected."""


def require(said: Any, kind: type, where: str) -> None:
    """Raises `BadNotation` for what is not of a type."""
    if not isinstance(said, kind) or (kind is int and isinstance(said, bool)):
        raise BadNotation(f"{where}: expected {TYPES[kind]}, found {said!r:.60}")


class LetterTable:
    """What letters mean: exact ones, and patterns of subscripts, superscripts and arguments.

    `said` is what a file says of each of them, and how; of the patterns, those that leave least open come first.
    `names` are the letters that are several side by side.
    """

    def __init__(self) -> None:
        self.exact: dict[Glyph, list[Meaning]] = {}
        self.loose: dict[Glyph, list[Meaning]] = {}
        self.patterns: list[tuple[int, str, Glyph, tuple[re.Pattern[str], ...], Meaning]] = []
        self.names: set[str] = set()
        self.behind: LetterTable | None = None
        self.said: dict[Glyph, tuple[str, Any]] = {}

    def before(self, other: LetterTable) -> LetterTable:
        """The letters of this table, and those of another that this one does not have."""
        self.behind, self.names = other, self.names | other.names
        return self

    def declare(self, node: Node, text: str) -> None:
        """Let the letter that the text writes stand for the node."""
        letter = letter_in(text)
        if letter is not None:
            self.add(letter, lambda _: node)

    def add(self, letter: Glyph, meaning: Meaning, said: str = "") -> None:
        """Say what a letter means, beside what it may mean already; `said` is how a file writes it."""
        if len(letter.loose.base.split()) > 1 and letter.base[0] not in "[(":
            self.names.add(letter.loose.base)
        marks = _marks(letter)
        if any("#" in part or "|" in part for part in marks):
            freedom = sum(100 if "# #" in part else part.count("#") for part in marks)
            self.patterns.append((freedom, said, _bare(letter), tuple(map(_pattern, marks)), meaning))
            self.patterns.sort(key=lambda each: each[0])
            return
        letter = replace(letter, sups=_joined(" ".join(letter.sups).split()))
        self.exact.setdefault(letter, []).append(meaning)
        self.loose.setdefault(letter.loose, []).append(meaning)

    def meanings(self, letter: Glyph, is_function: bool = False) -> Iterator[tuple[Node, Glyph]]:
        """What the letter may be, most of its marks taken into the symbol first, and the marks left over.

        With `is_function` a letter whose arguments the notation does not know has a value of its own for each of them.
        """
        found = list(self._found(letter, self.exact))
        if not found and MAY_LOSE_BOLD.search(letter.base):
            found = list(self._found(letter.loose, self.loose))
        if not found and letter.arguments and is_function:
            of_bare = self.meanings(replace(letter, arguments=""))
            found = [(_value(node, letter), rest) for node, rest in of_bare if isinstance(node, Symbol) and node != PI]
        if self.behind and (not found or found[0][1].marks):
            found = min(found, [*self.behind.meanings(letter, is_function)], key=_least_marks)
        yield from found

    def _found(self, letter: Glyph, table: dict[Glyph, list[Meaning]]) -> Iterator[tuple[Node, Glyph]]:
        for taken, rest in _divided(letter):
            for meaning in table.get(taken, ()):
                yield meaning(taken), rest
            if taken in table or table is not self.exact:
                continue
            yield from ((meaning(taken), rest) for meaning in self._matching(taken))

    def _matching(self, letter: Glyph) -> list[Meaning]:
        """What the pattern says that leaves least open; raises `BadNotation` where two leave as much."""
        bare, marks = _bare(letter), _marks(letter)
        found = [
            (freedom, said, meaning)
            for freedom, said, base, patterns, meaning in self.patterns
            if base == bare and all(each.fullmatch(mark) for each, mark in zip(patterns, marks, strict=True))
        ]
        if len(found) > 1 and found[0][0] == found[1][0] and found[0][1] != found[1][1]:
            both = " and ".join(f"'{said}'" for _, said, _ in found[:2])
            raise BadNotation(f"[symbols] {both} both match {spelled(letter)}: say what that letter is by itself")
        return [meaning for _, _, meaning in found[:1]]


def _least_marks(found: list[tuple[Node, Glyph]]) -> float:
    """How many marks are left over of what a letter may be."""
    return found[0][1].marks if found else float("inf")


def _bare(letter: Glyph) -> Glyph:
    return Glyph(letter.base, letter.accents, primes=letter.primes)


def _value(node: Symbol, letter: Glyph) -> Symbol:
    """The value of a function that the notation declares without its arguments."""
    words = re.sub(r"\\math\w+ |\\boldsymbol ", "", letter.arguments)
    said = f"{node.letter}({letter.arguments.replace(' ,', ',')})"
    return replace(node, name=f"{node.name}({words})", letter=said, stands_for=None)


def _divided(letter: Glyph) -> Iterator[tuple[Glyph, Glyph]]:
    """The ways in which marks belong to a symbol, or to what is done to it: most of them to the symbol first."""
    sups = " ".join(letter.sups).split()
    place = letter.place
    for count in range(len(letter.accents), -1, -1):
        for sub in dict.fromkeys((letter.sub, "")):
            for primes in dict.fromkeys((letter.primes, 0)):
                for cut in range(len(sups), -1, -1):
                    own, other = _joined(sups[:cut]), _joined(sups[cut:])
                    marks = letter.accents[:count], sub, primes, own, letter.before, letter.arguments
                    taken = Glyph(letter.base, *marks, place=place)
                    left = "" if sub else letter.sub
                    yield (
                        taken,
                        Glyph(letter.base, letter.accents[count:], left, letter.primes - primes, other, place=place),
                    )


def _marks(letter: Glyph) -> tuple[str, ...]:
    arguments = re.sub("#( #)?", "# #", letter.arguments)
    return letter.sub, " ".join(letter.sups), *letter.before, arguments


def _joined(words: list[str]) -> tuple[str, ...]:
    return (" ".join(words),) if words else ()


def _pattern(text: str) -> re.Pattern[str]:
    """A pattern of marks: '##' stands for one or more, '#' for one, a|b for either, or for itself as in P_{k|k-1}."""
    words = []
    for word in re.sub(r"\s*\|\s*", "|", text.replace("# #", "##")).split():
        if word in ("##", "#"):
            words.append(r"\S+(?: \S+)*" if word == "##" else r"\S+")
        else:
            words.append("(?:" + "|".join(map(re.escape, word.split("|"))) + ")")
    return re.compile(f"{' '.join(words)}|{re.escape(text)}")


def named_apart(symbol: Symbol, named: dict[str, Symbol], as_printed: bool = True) -> Symbol:
    """The symbol with a name that no other of those `named` has, nor an entry of one; it is among them then.

    That is its own, or what it is printed as, or its own with a number.
    """
    if symbol.stands_for is not None:
        return symbol
    names = (symbol.name, *[symbol.letter] * as_printed, *(f"{symbol.name}'{k}" for k in range(2, len(named) + 3)))
    others = (replace(symbol, name=name) for name in names)
    apart = next(other for other in others if all(named.get(name, other) == other for name in _names(other)))
    named.update(dict.fromkeys(_names(apart), apart))
    return apart


def _names(symbol: Symbol) -> set[str]:
    """The names of the symbol and of its entries."""
    rows, columns = symbol.shape
    has_entries = isinstance(rows, int) and isinstance(columns, int)
    return {symbol.name, *chain.from_iterable(entry_names(symbol.name, rows, columns) if has_entries else ())}
