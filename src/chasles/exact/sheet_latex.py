"""A worked solution as LaTeX: for notebooks, and to be pasted into a sheet."""

from __future__ import annotations

from collections.abc import Iterator

from chasles.exact.solution import Check, Solution, Step
from chasles.exact.spelling import latex_of

__all__ = ["as_latex"]


def as_latex(solution: Solution) -> str:
    """The steps, numbered, and the answers."""
    return "\n".join(_parts(solution)) + "\n"


def _parts(solution: Solution) -> Iterator[str]:
    yield rf"\textbf{{Exercise {solution.exercise}: {_text(solution.title)}}}"
    for text in solution.assumptions:
        yield rf"\par Assumed: {_text(text)}"
    for number, step in enumerate(solution.steps, 1):
        yield rf"\par {number}. {_said(step)}"
        yield from (rf"\[ {line.latex} \]" for line in step.lines)
    yield rf"\par\textbf{{Answer: {_text(solution.status)}}}"
    yield from (rf"\[ \text{{{_text(name)}}} = {latex_of(value)} \]" for name, value in solution.answers.items())
    for check in solution.checks:
        yield rf"\par {_said(check)}"
        yield from (rf"\[ {line.latex} \]" for line in check.lines)


def _said(step: Step | Check) -> str:
    cites = "; ".join(citation.words for citation in step.cites)
    return _text(step.says) + (f" ({_text(cites)})" if cites else "")


def _text(words: str) -> str:
    for sign in ("\\", "{", "}"):
        words = words.replace(sign, "")
    for sign in "&%$#_":
        words = words.replace(sign, f"\\{sign}")
    return words.replace("^", r"\^{}").replace("~", r"\~{}")
