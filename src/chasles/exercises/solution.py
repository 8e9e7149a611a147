"""A worked solution: what was given, the steps with the equations of the book that they use, answers and checks."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from chasles.decisions.decision import HOW
from chasles.display import Displayed
from chasles.exact.linear import Solutions
from chasles.exact.spelling import as_data, decimal_text, latex_of, text_of, words_in_latex
from chasles.vocabulary import Identity, Node, Number, Zero, latex, plain

if TYPE_CHECKING:
    from chasles.exercises.picture import Picture


@dataclass(frozen=True, slots=True)
class Formula:
    """A formula: as text, in LaTeX, and, where that tells more, its value in decimals."""

    text: str
    in_latex: str | Callable[[], str]
    """Made where it is asked for: a terminal shows none, and of long numbers it takes a while."""
    decimals: str = ""

    @property
    def latex(self) -> str:
        """The formula in LaTeX."""
        return self.in_latex if isinstance(self.in_latex, str) else self.in_latex()


@dataclass(frozen=True, slots=True)
class Citation:
    """An equation of the book that a step uses: its number, and what is decided of it in the form that is used."""

    number: str
    part: int
    verdict: str
    needs: tuple[str, ...] = ()
    form: str = "printed"
    chapter: str = ""
    """Its package, where that is another than the exercise's."""

    @property
    def shown(self) -> str:
        """The number as it is cited."""
        number = self.number if self.number.startswith(("text", "Thm", "Cor", "Ex")) else f"({self.number})"
        return f"{number} of {self.chapter}" if self.chapter else number


def cited(citations: Sequence[Citation]) -> str:
    """The numbers that are cited, in one line; where a corrected form is used, that is said."""
    groups: dict[tuple[str, str], list[int]] = {}
    for citation in citations:
        groups.setdefault((citation.shown, citation.form), []).append(citation.part)
    return "; ".join(f"{shown}{_parts(parts)}{_form(form)}" for (shown, form), parts in groups.items())


def _parts(parts: list[int]) -> str:
    if parts == [1]:
        return ""
    return f" part{'s' if len(parts) > 1 else ''} {', '.join(map(str, parts))}"


def _form(form: str) -> str:
    return "" if form == "printed" else f", {HOW[form]}"


@dataclass(frozen=True, slots=True)
class SolutionStep:
    """What is done and why, the equations of the book that are used, the formulas that come of it.

    A check is one, too: the answer substituted into what was asked, where the two sides are equal, exactly.
    """

    says: str
    cites: tuple[Citation, ...] = ()
    lines: tuple[Formula, ...] = ()


@dataclass(frozen=True)
class Solution(Displayed):
    """The solution of an exercise for one set of data.

    `answers` are exact: SymPy numbers and matrices, words, truth values, nested lists and dictionaries of them. `means`
    says what they are, with their units.
    """

    exercise: str
    title: str
    asked: tuple[str, ...]
    status: str
    given: Mapping[str, Any]
    answers: Mapping[str, Any]
    assumptions: tuple[str, ...]
    steps: tuple[SolutionStep, ...]
    checks: tuple[SolutionStep, ...]
    picture: Picture | None = field(default=None, repr=False)
    means: Mapping[str, str] = field(default_factory=dict, repr=False)

    def as_data(self) -> dict[str, Any]:
        """What `chasles solve --json` prints; its keys and their order are fixed."""
        return {
            "exercise": self.exercise,
            "status": self.status,
            "answers": as_data(self.answers),
            "assumptions": list(self.assumptions),
            "steps": len(self.steps),
        }

    @property
    def outcome(self) -> str:
        """What was found, in words: which case it is; where there is but one, that it is solved, or proved."""
        if self.status == "ok":
            return "proved" if set(self.answers) == {"proofs"} else "solved"
        return self.status.replace("-", " ")

    @property
    def hints(self) -> list[str]:
        """What each step does and the equations it uses, without values."""
        return [f"{step.says} {cited(step.cites)}".rstrip() for step in self.steps]

    def figure(self) -> Any:
        """The picture as a matplotlib figure.

        Raises LookupError where the exercise has none, ImportError, with what to install, without matplotlib.
        """
        if self.picture is None:
            raise LookupError(f"exercise {self.exercise} has no picture for these data")
        from chasles.exercises.drawing import drawn

        return drawn(self.picture)


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
