"""The notation of a chapter: its letters are what its statements say they are, section by section."""

from __future__ import annotations

import sys

from chasles.reading.letter_table import LetterTable
from chasles.reading.page_notation import PageNotation, declared_in
from chasles.statements import Chapter, Statement
from chasles.vocabulary import Symbol, symbols_of


def notation_of_chapter(chapter: Chapter) -> PageNotation:
    """The notation in which a chapter is declared; in a section a letter is first what it is in its statements."""
    spoken: dict[str, dict[Symbol, None]] = {}
    for entry in chapter:
        if isinstance(entry.statement, Statement):
            here = (symbol for side in entry.statement.printed for symbol in symbols_of(side))
            spoken.setdefault(entry.section.number, {}).update(dict.fromkeys(here))
    modules = [module for name, module in sys.modules.items() if f"{name}.".startswith(f"{chapter.package}.")]
    declared = {id(value): value for module in modules for value in vars(module).values()}
    known = {value for value in declared.values() if isinstance(value, Symbol)}
    more = {symbol: None for symbols in spoken.values() for symbol in symbols if symbol not in known}
    notation = declared_in(chapter.package, (*declared.values(), *more))
    for number, symbols in spoken.items():
        table = notation.sections.setdefault(number, LetterTable())
        for symbol in symbols:
            table.declare(symbol, symbol.letter)
    return notation
