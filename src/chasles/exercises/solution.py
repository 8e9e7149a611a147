"""A worked solution: what was given, the steps with the equations of the book that they use, answers and checks."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from chasles.decisions.decision import HOW
from chasles.display import Displayed
from chasles.exact.spelling import as_data

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
