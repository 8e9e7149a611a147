"""The equations of a statement as printed, in one line of plain text or in LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from chasles.statements import Chapter, Entry, Inverse, Packed, Stack, Statement, Theorem
from chasles.statements.kernel import Argument
from chasles.statements.statement import Equation
from chasles.vocabulary import Node, latex, plain

Sentence = Statement | Theorem | Inverse


def labelled_equations(sentence: Sentence) -> Iterator[tuple[str, Node, Node]]:
    """The two sides of each equation in the book's order, with its label, or its case where it is one of several."""
    match sentence:
        case Theorem(forms=forms):
            yield from (equation for form in forms for equation in form.equations())
        case Inverse(branches=branches):
            yield from ((branch.says, *sides) for branch in branches for sides in branch.values)
        case Statement():
            yield "", *sentence.printed


def in_words(sentence: Sentence) -> tuple[str, ...]:
    """The equations in plain text, in the book's order: several for a theorem, one line a case for an inverse."""
    return _equations(sentence, plain, lambda _: "=")


def in_latex(sentence: Sentence) -> tuple[str, ...]:
    """The same in LaTeX."""
    return _equations(sentence, latex, lambda sign: sign)


def hypotheses_in_latex(book: Chapter) -> dict[str, str]:
    """The hypotheses of a book in LaTeX, by their text."""
    return {hypothesis.text: hypothesis.latex for entry in book for hypothesis in entry.statement.assuming}


def in_both(sides: Equation, sign: str) -> tuple[str, str]:
    """An equation in plain text and in LaTeX."""
    left, right = sides
    return f"{plain(left)} = {plain(right)}", f"{latex(left)} {sign} {latex(right)}"


def signature_in_words(entry: Entry) -> str | None:
    """The functions that a statement asks for, as they are called: "rotation_from_axis_angle(e, phi)"."""
    calls = (f"{kernel.name}({', '.join(map(argument_in_words, kernel.of))})" for kernel in entry.kernels)
    return ", ".join(calls) or None


def argument_in_words(argument: Argument) -> str:
    """An argument as it is called in the book, or by its own name if it stacks several symbols."""
    match argument:
        case Stack(name):
            return name
        case Packed(matrix):
            return plain(matrix)
        case _:
            return plain(argument)


def _equations(sentence: Sentence, spell: Callable[[Node], str], sign: Callable[[str], str]) -> tuple[str, ...]:
    mark = sign(sentence.sign if isinstance(sentence, Statement) else "=")
    if isinstance(sentence, Inverse):
        cases = [[f"{spell(left)} {mark} {spell(right)}" for left, right in b.values] for b in sentence.branches]
        return tuple(", ".join(case) for case in cases)
    return tuple(f"{spell(left)} {mark} {spell(right)}" for _, left, right in labelled_equations(sentence))
