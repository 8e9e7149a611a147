"""A worked solution in the terminal: what is asked, numbered steps with formulas, the answer, what was checked."""

from __future__ import annotations

from collections.abc import Iterator

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.exact.spelling import decimal_text, text_of
from chasles.exercises.solution import Formula, Solution, SolutionStep, SubstitutionCheck, cited

WIDE = 100


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


def _step(mark: str, step: SolutionStep | SubstitutionCheck, signs: bool) -> RenderableType:
    grid = Table.grid(padding=(0, 1, 0, 0))
    grid.add_column(justify="right", style="dim", width=3)
    grid.add_column(overflow="fold")
    said = Text(step.says)
    if step.cites:
        said.append(f"  {cited(step.cites)}", "dim cyan")
    grid.add_row(mark, said)
    for line in step.lines:
        grid.add_row("", _formula(line, signs))
    return grid


def _formula(line: Formula, signs: bool) -> Text:
    return _with_decimals(f"    {line.text}", line.decimals, signs, "    ")


def _with_decimals(text: str, decimals: str, signs: bool, indent: str = "") -> Text:
    """The text with its decimals: beside it, or below where both are long."""
    shown = Text(text)
    if decimals:
        between = "  " if len(text) + len(decimals) < WIDE else f"\n{indent}"
        shown.append(f"{between}{'≈' if signs else '~'} {decimals}", "dim")
    return shown


def _answers(solution: Solution, signs: bool) -> RenderableType:
    grid = Table.grid(padding=(0, 2, 0, 0))
    grid.add_column(style="cyan", no_wrap=True)
    grid.add_column(overflow="fold")
    for name, value in solution.answers.items():
        grid.add_row(name, _with_decimals(text_of(value), decimal_text(value), signs))
        if says := solution.means.get(name):
            grid.add_row("", Text(says, "dim"))
    return grid
