"""What a shell offers for the word that is being typed: numbers, sections, kernels and exercises.

Nothing is decided for it, and SymPy is not imported. Where the declarations cannot be read, nothing is offered.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from functools import wraps
from typing import Any

import click
from click.shell_completion import CompletionItem

Offer = Callable[[click.Context, click.Parameter, str], list[CompletionItem]]
Offered = Iterable[tuple[str, str]]
"""Words, each with what it stands for, which some shells show beside it."""


def _offering(find: Callable[[Sequence[str]], Offered]) -> Offer:
    """The completion of a parameter, from what is offered after the words before the one that is typed."""

    @wraps(find)
    def offer(context: click.Context, parameter: click.Parameter, incomplete: str) -> list[CompletionItem]:
        before: Any = context.params.get(parameter.name or "") or ()
        found: dict[str, str] = {}
        try:
            with context.scope(cleanup=False):
                for word, says in find((before,) if isinstance(before, str) else before):
                    found.setdefault(word, says)
        except Exception:
            # A message would stand in the middle of the line that is being typed.
            return []
        typed = incomplete.casefold()
        return [CompletionItem(word, help=says) for word, says in found.items() if word.casefold().startswith(typed)]

    return offer


@_offering
def numbers(before: Sequence[str]) -> Offered:
    """The numbers of the book, word by word: after `Thm` come those of the theorems."""
    from chasles.cli.chosen_chapter import chapter

    book = chapter()
    says: dict[str, str] = {}
    for entry in book:
        says.setdefault(entry.number, entry.statement.says)
    rows = [(number.split(), says[number]) for number in book.numbers]
    for length in range(len(before), 0, -1):
        begun = [word.casefold() for word in before[-length:]]
        rest = [(words, said) for words, said in rows if [word.casefold() for word in words[:length]] == begun]
        further = [(words[length], said) for words, said in rest if len(words) > length]
        if further:
            return further
    return [(words[0], said if len(words) == 1 else "") for words, said in rows]


@_offering
def sections(before: Sequence[str]) -> Offered:
    """The sections of the book."""
    from chasles.cli.chosen_chapter import chapter

    return [(section.number, section.title) for section in chapter().sections]


@_offering
def kernels(before: Sequence[str]) -> Offered:
    """The names of the kernels that are not there yet."""
    from chasles.cli.chosen_chapter import chapter

    named = [(kernel.name, entry.statement.says) for entry in chapter() for kernel in entry.kernels]
    return [(name, says) for name, says in named if name not in before]


@_offering
def exercises(before: Sequence[str]) -> Offered:
    """The numbers of the exercises."""
    from chasles.cli.chosen_chapter import package_chosen
    from chasles.statements.exercises import exercise_numbers

    return [(number, "") for number in exercise_numbers(package_chosen())]
