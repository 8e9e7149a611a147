"""The equations of a statement as printed, in one line of plain text or in LaTeX."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from chasles.statements import Chapter, Entry, Inverse, Packed, Stack, Statement, Theorem
from chasles.statements.inequalities import ONE, PRINTED, ZERO, difference_of
from chasles.statements.kernel import Argument
from chasles.statements.statement import Equation
from chasles.vocabulary import Negative, Node, Sum, latex, plain

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
    return _equations(sentence, plain, False)


def in_latex(sentence: Sentence) -> tuple[str, ...]:
    """The same in LaTeX."""
    return _equations(sentence, latex, True)


def hypotheses_in_latex(book: Chapter) -> dict[str, str]:
    """The hypotheses of a book in LaTeX, by their text."""
    return {hypothesis.text: hypothesis.latex for entry in book for hypothesis in entry.statement.assuming}


def in_both(sides: Equation, sign: str) -> tuple[str, str]:
    """An equation in plain text and in LaTeX."""
    left, sign, right, mark = compared(*sides, sign)
    return f"{plain(left)} {mark} {plain(right)}", f"{latex(left)} {sign} {latex(right)}"


def compared(left: Node, right: Node, sign: str = "=") -> tuple[Node, str, Node, str]:
    """The sides with the sign between them, in LaTeX and in plain text: that of a comparison where they say one."""
    difference = difference_of(left, right)
    if difference is None:
        return left, sign, right, "="
    mark = ">" if right == ONE else ">="
    if isinstance(difference, Negative):
        mark = mark.replace(">", "<")
        return difference.term, PRINTED[mark], ZERO, mark
    if isinstance(difference, Sum) and len(difference.terms) == 2 and isinstance(difference.terms[1], Negative):
        return difference.terms[0], PRINTED[mark], difference.terms[1].term, mark
    return difference, PRINTED[mark], ZERO, mark


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


def _equations(sentence: Sentence, spell: Callable[[Node], str], in_latex: bool) -> tuple[str, ...]:
    sign = sentence.sign if isinstance(sentence, Statement) else "="

    def said(left: Node, right: Node) -> str:
        one, printed, other, mark = compared(left, right, sign)
        return f"{spell(one)} {printed if in_latex else mark} {spell(other)}"

    if isinstance(sentence, Inverse):
        return tuple(", ".join(said(*sides) for sides in branch.values) for branch in sentence.branches)
    return tuple(said(left, right) for _, left, right in labelled_equations(sentence))
