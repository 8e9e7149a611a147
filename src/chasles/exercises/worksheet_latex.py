"""A worked solution as LaTeX: for notebooks, and to be pasted into a sheet."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.exact.spelling import latex_of, plain_in_latex, words_in_latex
from chasles.exercises.solution import Solution, SolutionStep, cited


def as_latex(solution: Solution) -> str:
    """The steps, numbered, and the answers."""
    return "\n".join(_parts(solution)) + "\n"


def _parts(solution: Solution) -> Iterator[str]:
    yield rf"\textbf{{Exercise {solution.exercise}: {plain_in_latex(solution.title)}}}"
    for text in solution.assumptions:
        yield rf"\par Assumed: {plain_in_latex(text)}"
    for number, step in enumerate(solution.steps, 1):
        yield rf"\par {number}. {_said(step)}"
        yield from (rf"\[ {line.latex} \]" for line in step.lines)
    yield rf"\par\textbf{{Answer: {plain_in_latex(solution.outcome)}}}"
    yield from (rf"\[ {words_in_latex(name)} = {latex_of(value)} \]" for name, value in solution.answers.items())
    for check in solution.checks:
        yield rf"\par {_said(check)}"
        yield from (rf"\[ {line.latex} \]" for line in check.lines)


def _said(step: SolutionStep) -> str:
    cites = cited(step.cites)
    return plain_in_latex(step.says) + (f" ({plain_in_latex(cites)})" if cites else "")
