"""A worked solution in the terminal: what is asked, numbered steps with formulas, the answer, what was checked."""

from __future__ import annotations

import re
from collections.abc import Iterator

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.exact.spelling import decimal_text, text_of
from chasles.exercises.solution import Solution, SolutionStep, cited

WIDE, SHORT = 100, 24
"""Signs on a line, and in what stands before a value on the same line."""


def worked_page(solution: Solution, signs: bool) -> Iterator[RenderableType]:
    """The whole sheet; `signs` says whether more than ASCII can be shown."""
    yield Text.assemble((f"Exercise {solution.exercise}", "bold"), "  ", (solution.title, "bold"))
    for text in solution.asked:
        yield Padding(Text(f"- {text}"), (0, 0, 0, 2))
    for text in solution.assumptions:
        yield Padding(Text.assemble(("assumed: ", "dim"), text), (0, 0, 0, 2))
    yield Text("")
    for number, step in enumerate(solution.steps, 1):
        yield _step(str(number), step, signs)
    yield Text("")
    yield Text.assemble(("Answer", "bold"), ": ", (solution.outcome, "bold cyan"))
    yield Padding(_answers(solution, signs), (0, 0, 0, 2))
    if solution.checks:
        yield Text("")
        yield Text("Substituted back", "bold")
        for check in solution.checks:
            yield _step("✓" if signs else "+", check, signs)


def hints_page(solution: Solution, count: int) -> Iterator[RenderableType]:
    """The first steps without values."""
    yield Text(f"Exercise {solution.exercise}, {min(count, len(solution.steps))} of {len(solution.steps)} steps")
    for number, step in enumerate(solution.steps[:count], 1):
        yield _step(str(number), SolutionStep(step.says, step.cites), signs=True)


def _step(mark: str, step: SolutionStep, signs: bool) -> RenderableType:
    grid = Table.grid(padding=(0, 1, 0, 0))
    grid.add_column(justify="right", style="dim", width=3)
    grid.add_column(overflow="fold")
    said = Text(step.says)
    if step.cites:
        said.append(f"  {cited(step.cites)}", "dim cyan")
    grid.add_row(mark, said)
    for line in step.lines:
        grid.add_row("", Padding(_with_decimals(line.text, line.decimals, signs), (0, 0, 0, 4)))
    return grid


def _with_decimals(text: str, decimals: str, signs: bool) -> Text:
    """The text with its decimals: beside it, or below where both are long."""
    shown = Text(in_lines(text))
    if decimals:
        between = "  " if len(text) + len(decimals) < WIDE else "\n"
        shown.append(between + in_lines(f"{'≈' if signs else '~'} {decimals}"), "dim")
    return shown


def in_lines(text: str) -> str:
    """A long chain of equal expressions with each on its own line, and so each row of a matrix that is long."""
    name, *values = _parted(text, " = ", 0) if len(text) > WIDE else [text]
    if values and len(name) <= SHORT:
        name, *values = f"{name} = {values[0]}", *values[1:]
    lines = [name, *(f"= {value}" for value in values)]
    return "\n".join(_rows(line) if len(line) > WIDE else line for line in lines)


def _rows(line: str) -> str:
    """The line with each row of the matrix at its end, or each entry of the column or list, below the other."""
    found = re.fullmatch(r"(|.*= |[≈~] )(\[.*\]|\(.*\))", line)
    mark = "; " if len(_parted(line, "; ", 1)) > 1 else ", "
    return line if found is None else (f"{mark[0]}\n" + " " * (found.end(1) + 1)).join(_parted(line, mark, 1))


def _parted(text: str, mark: str, depth: int) -> list[str]:
    """The parts between marks that stand in so many brackets."""
    parts, start, within = [], 0, 0
    for at, sign in enumerate(text):
        within += (sign in "([") - (sign in ")]")
        if within == depth and text.startswith(mark, at):
            parts.append(text[start:at])
            start = at + len(mark)
    return [*parts, text[start:]]


def _answers(solution: Solution, signs: bool) -> RenderableType:
    grid = Table.grid(padding=(0, 2, 0, 0))
    grid.add_column(style="cyan", no_wrap=True)
    grid.add_column(overflow="fold")
    for name, value in solution.answers.items():
        grid.add_row(name, _with_decimals(text_of(value), decimal_text(value), signs))
        if says := solution.means.get(name):
            grid.add_row("", Text(says, "dim"))
    return grid
