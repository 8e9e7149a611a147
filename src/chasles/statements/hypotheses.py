"""The named hypotheses: the only side conditions that a statement may assume.

Each says what it means as equations between words and as expressions that do not vanish; nothing else is known of it.
A free equation is not among them, so that no conclusion can be assumed.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction

from chasles import vocabulary as w
from chasles.vocabulary import Node, latex
from chasles.vocabulary.arguments import Declared, declaring
from chasles.vocabulary.fitting import measured
from chasles.vocabulary.measure import added


@dataclass(frozen=True, slots=True)
class Hypothesis(Declared):
    """A named side condition on `subjects`: its `equations` hold and its `nonvanishing` expressions are not zero.

    A `free` one is said of any expressions, not of symbols, and always counts; declarations do not make them.
    Raises `Misfit` if the two sides of one of its equations differ in shape or dimension.
    """

    kind: str
    subjects: tuple[Node, ...]
    equations: tuple[tuple[Node, Node], ...] = ()
    nonvanishing: tuple[Node, ...] = ()
    latex: str = ""
    text: str = ""
    free: bool = False

    def __post_init__(self) -> None:
        for left, right in self.equations:
            added(measured(left), measured(right), (left, right), f"assume {self.kind}: cannot equate")

    @property
    def sides(self) -> list[Node]:
        """The sides of its equations."""
        return [side for equation in self.equations for side in equation]

    def rewritten(self, change: Callable[[Node], Node]) -> Hypothesis:
        """The same said of changed expressions."""
        equations = tuple((change(left), change(right)) for left, right in self.equations)
        subjects, nonvanishing = (tuple(map(change, each)) for each in (self.subjects, self.nonvanishing))
        return with_fields(self, subjects=subjects, equations=equations, nonvanishing=nonvanishing)


def said_of(
    kind: str,
    subjects: tuple[Node, ...],
    letters: str | tuple[Node, Node],
    words: str,
    *equations: tuple[Node, Node],
    nonvanishing: tuple[Node, ...] = (),
) -> Hypothesis:
    """The hypothesis, said in LaTeX and in plain text with the subjects at {0}, {1} and {2}.

    Letters that are two sides are printed as an equation, in the notation of the chapter.
    """
    printed = letters.format(*map(latex, subjects)) if isinstance(letters, str) else latex(*letters)
    said = printed, words.format(*map(w.plain, subjects))
    return Hypothesis(kind, subjects, equations, nonvanishing, *said)


def _symbols(kind: str, *subjects: Node) -> None:
    for subject in subjects:
        if not isinstance(subject, w.Symbol) or subject.stands_for is not None:
            instead = (
                f"write inequality({subject} > 0), of chasles.statements.inequalities"
                if kind == "positive"
                else "define a symbol as what it is, and say it of that"
            )
            raise TypeError(f"{kind} is said of a symbol, and {subject} is an expression: {instead}")


def _scalar(subject: Node, kind: str) -> None:
    if not subject.is_scalar:
        raise TypeError(f"{kind} is said of a scalar, and {subject} is {subject.shape[0]} x {subject.shape[1]}")


@declaring
def unit(vector: Node) -> Hypothesis:
    """The vector has length one."""
    _symbols("unit", vector)
    one = w.Number(Fraction(1))
    return said_of("unit", (vector,), (w.Norm(vector), one), "|{0}| = 1", (w.Dot(vector, vector), one))


@declaring
def unit_column(*parts: Node) -> Hypothesis:
    """The quantities, one below the other, make a column of length one, as Euler-Rodrigues parameters do."""
    _symbols("unit_column", *parts)
    places = ", ".join(f"{{{place}}}" for place in range(len(parts)))
    total = w.Sum(tuple(part * part if part.is_scalar else w.Dot(part, part) for part in parts))
    return said_of("unit column", parts, rf"\|[{places}]\| = 1", f"|[{places}]| = 1", (total, w.Number(Fraction(1))))


@declaring
def nonzero(expression: Node, letter: str = "") -> Hypothesis:
    """The scalar is not zero; `letter` says so in LaTeX in the reader's terms (phi != 0, not 1 - cos(phi) != 0)."""
    _scalar(expression, "nonzero")
    said = letter or rf"{latex(expression)} \neq 0"
    text = _plain_of(letter) if letter else f"{w.plain(expression)} != 0"
    return Hypothesis("nonzero", (expression,), (), (expression,), said, text)


@declaring
def positive(quantity: Node) -> Hypothesis:
    """The scalar is greater than zero, as a mass is; a proof uses only that it is not zero."""
    _symbols("positive", quantity)
    _scalar(quantity, "positive")
    return said_of("positive", (quantity,), "{0} > 0", "{0} > 0", nonvanishing=(quantity,))


@declaring
def symmetric(matrix: Node) -> Hypothesis:
    """The matrix equals its transpose."""
    _symbols("symmetric", matrix)
    equation = (matrix, w.Transpose(matrix))
    return said_of("symmetric", (matrix,), equation, "{0} is symmetric", equation)


@declaring
def definite(matrix: Node) -> Hypothesis:
    """The matrix is symmetric and positive-definite: x . M x > 0 for every x but zero.

    The equations of a proof use its symmetry, and that its determinant is not zero; a sum of squares, x . M x itself.
    """
    _symbols("definite", matrix)
    letters, words = r"{0} \text{{ positive-definite}}", "{0} is positive-definite"
    equation = (matrix, w.Transpose(matrix))
    return said_of("definite", (matrix,), letters, words, equation, nonvanishing=(w.Determinant(matrix),))


@declaring
def rotation(matrix: Node) -> Hypothesis:
    """The matrix is proper orthogonal; the 21 quadrics that say so are already a Groebner basis."""
    _symbols("rotation", matrix)
    return said_of("rotation", (matrix,), r"{0} \in SO(3)", "{0} is a rotation", *_proper_orthogonal(matrix))


@declaring
def half_turn(matrix: Node) -> Hypothesis:
    """The matrix is a rotation through the angle pi: it is symmetric, its trace is -1, and Q + 1 has rank one."""
    _symbols("half_turn", matrix)
    equations = (
        (matrix, w.Transpose(matrix)),
        (w.Trace(matrix), w.Number(Fraction(-1))),
        (w.Cofactor(matrix + w.Identity(3)), w.Zero(3, 3)),
    )
    return said_of("half_turn", (matrix,), r"{0} \text{{ is a half-turn}}", "{0} is a half-turn", *equations)


@declaring
def orthonormal(first: Node, second: Node, third: Node) -> Hypothesis:
    """The three vectors are orthonormal and right-handed: as columns they make a rotation."""
    triad = (first, second, third)
    _symbols("orthonormal", *triad)
    letters = r"\{{ {0}, {1}, {2} \}} \text{{ orthonormal, right-handed}}"
    words = "{0}, {1}, {2} are orthonormal and right-handed"
    return said_of("orthonormal", triad, letters, words, *_proper_orthogonal(w.Block((triad,))))


@declaring
def perpendicular(one: Node, other: Node) -> Hypothesis:
    """The two vectors are at right angles."""
    _symbols("perpendicular", one, other)
    equation = (w.Dot(one, other), w.Number(Fraction(0)))
    return said_of("perpendicular", (one, other), r"{0} \perp {1}", "{0} is perpendicular to {1}", equation)


def _proper_orthogonal(matrix: Node) -> tuple[tuple[Node, Node], ...]:
    identity = w.Identity(3)
    return (
        (w.Transpose(matrix) @ matrix, identity),
        (matrix @ w.Transpose(matrix), identity),
        (matrix, w.Cofactor(matrix)),
    )


def _plain_of(letter: str) -> str:
    """A short LaTeX condition in plain text."""
    text = letter.replace(r"\neq", "!=").replace(r"\pi", "pi").replace(r"\|", "|")
    return re.sub(r"\\(?:mathbf|boldsymbol)\{([^}]*)\}", r"\1", text).replace("\\", "")
