"""The derivations of the book, as `derive` uses them: loaded, and chosen by number."""

from __future__ import annotations

from collections.abc import Sequence

from chasles.cli.failures import BAD_INPUT, Failure
from chasles.statements import Chapter, DeclarationError
from chasles.statements.citing import UnknownNumber, derivations_cited
from chasles.statements.derivation import Derivation
from chasles.statements.derivations import declared_derivations
from chasles.vocabulary.arguments import WrongArgument


def all_derivations(book: Chapter) -> dict[str, Derivation]:
    """The derivations by name, in the book's order. Raises Failure for declarations that contradict each other."""
    try:
        return declared_derivations(book.package)
    except DeclarationError as error:
        raise Failure(f"the declarations contradict each other: {error}", BAD_INPUT) from error
    except WrongArgument as error:
        raise Failure(str(error), BAD_INPUT) from error


def chosen_derivations(book: Chapter, words: Sequence[str]) -> dict[str, Derivation]:
    """The derivations that end at these numbers, or compare with them where none ends there; all without a number.

    Raises Failure naming a number that no derivation leads to, and those near it, and where the book has none.
    """
    known = all_derivations(book)
    if not known:
        raise Failure(f"{book.package} declares no derivations: those in its package `roads` would be taken", BAD_INPUT)
    if not words:
        return known
    try:
        return derivations_cited(known, words)
    except UnknownNumber as error:
        raise Failure(f"{error}; `chasles derive` lists all derivations", BAD_INPUT) from error
