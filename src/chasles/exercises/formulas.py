"""Formulas of a solution, each as text and in LaTeX: expressions of the book with their values."""

from __future__ import annotations

from typing import Any

from chasles.exact.linear import Solutions
from chasles.exact.spelling import decimal_text, latex_of, text_of, words_in_latex
from chasles.exercises.solution import Formula
from chasles.vocabulary import Identity, Node, Number, Zero, latex, plain


def scalar_or_matrix(value: Any) -> Any:
    """The entry of a 1 x 1 matrix, or the matrix."""
    return value[0, 0] if value.shape == (1, 1) else value


def equation(name: Node | str, value: Any) -> Formula:
    """A name, or an expression, and its value."""
    text, in_latex = (plain(name), latex(name)) if isinstance(name, Node) else (name, words_in_latex(name))
    return chain([text], [in_latex], value)


def chain(texts: list[str], formulas: list[str], value: Any) -> Formula:
    """Expressions that are equal, the last of them a value; what is written alike is written once."""
    written = dict(zip([*texts, text_of(value)], [*formulas, ""], strict=True))

    def in_latex() -> str:
        return " = ".join((written | {text_of(value): latex_of(value)}).values())

    return Formula(" = ".join(written), in_latex, decimal_text(value))


def compared(left: Node, right: Node, values: tuple[Any, Any], same: bool) -> tuple[Formula, ...]:
    """Both sides with their values, and whether these are equal."""
    if isinstance(right, Number | Zero | Identity):
        asked = "as it must be" if same else f"and must be {text_of(values[1])}"
        line = equation(left, values[0])
        return (Formula(f"{line.text}, {asked}", f"{line.latex} {words_in_latex(', ' + asked)}", line.decimals),)
    verdict = note("the two are equal" if same else "the two differ")
    return equation(left, values[0]), equation(right, values[1]), verdict


def stated(label: str, left: Node, right: Node) -> Formula:
    """An equation without numbers."""
    text, in_latex = f"{plain(left)} = {plain(right)}", f"{latex(left)} = {latex(right)}"
    return (
        Formula(f"{label}: {text}", f"{words_in_latex(label + ': ')} {in_latex}") if label else Formula(text, in_latex)
    )


class Proofs(list[dict[str, Any]]):
    """What is proved, one sentence a line: its number, what it says, what is decided of it and what that needs."""

    def as_data(self) -> list[dict[str, Any]]:
        """What JSON holds of it."""
        return list(self)

    def as_text(self) -> str:
        """A line for each."""
        return "\n".join(self._lines())

    def as_latex(self) -> str:
        """The same in LaTeX."""
        return r"\begin{array}{l}" + r" \\ ".join(map(words_in_latex, self._lines())) + r"\end{array}"

    def _lines(self) -> list[str]:
        return [f"{one['number']}: {one['says']} {_verdict(one['verdict'], one['needs'])}" for one in self]


def _verdict(verdict: str, needs: list[str]) -> str:
    return f"It {verdict.partition('-')[0]}" + (f", given that {' and '.join(needs)}." if needs else ".")


def note(text: str) -> Formula:
    """A line of words."""
    return Formula(text, words_in_latex(text))


def confirmed(left: Node, right: Node, value: Any) -> Formula:
    """An equation and the value of both sides."""
    if isinstance(right, Number | Zero | Identity):
        return Formula(f"{plain(left)} = {text_of(value)}", f"{latex(left)} = {latex_of(value)}")
    return chain([plain(left), plain(right)], [latex(left), latex(right)], value)


def solved(unknown: Node, found: Solutions) -> Formula:
    """All solutions of linear equations."""
    if not found.exist:
        return note("no solution")
    if found.unique:
        return equation(unknown, scalar_or_matrix(found.one))
    ways = " + ".join(f"s_{k} {text_of(way)}" for k, way in enumerate(found.directions, 1))
    signs = " + ".join(f"s_{k} {latex_of(way)}" for k, way in enumerate(found.directions, 1))
    return Formula(
        f"{plain(unknown)} = {text_of(found.one)} + {ways}", f"{latex(unknown)} = {latex_of(found.one)} + {signs}"
    )
