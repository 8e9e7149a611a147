"""A derivation on a page: each step with what is done, the equation that results, and its verdict; also as data."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from rich.console import RenderableType
from rich.padding import Padding
from rich.table import Table
from rich.text import Text

from chasles.deriving import CheckedDerivation, CheckedStep
from chasles.report.details import number_in_words
from chasles.report.screen import Screen
from chasles.report.words import labelled, number_of, point_in_words, said
from chasles.verdict import Fails
from chasles.vocabulary import Node, plain
from chasles.vocabulary import latex as in_latex


def derivation_page(
    screen: Screen, name: str, road: CheckedDerivation, latex: bool = False
) -> Iterator[RenderableType]:
    """A derivation with all its steps."""
    derivation = road.derivation
    what = derivation.says if derivation.to is None else derivation.to.says
    yield Text.assemble((number_in_words(derivation.number), "bold"), "  ", what)
    yield Text(f"  {name}: {derivation.says}", "dim")
    if derivation.assuming:
        yield Text(f"  assuming {', '.join(h.text for h in derivation.assuming)}", "dim")
    for number, step in enumerate(road.steps, start=1):
        yield from _step(screen, number, step, latex)
    yield Text.assemble("  ", *outcome_of(road))


def derivation_line(screen: Screen, name: str, road: CheckedDerivation) -> Iterator[RenderableType]:
    """A derivation in one line: its number, how many steps it has, what came of it."""
    words = f"{road.derivation.number}  {name}: {number_of(len(road.steps), 'step')}; "
    yield Text.assemble(words, *outcome_of(road))


def derivation_record(name: str, road: CheckedDerivation) -> dict[str, Any]:
    """The derivation as `chasles derive --json` prints it; its keys and their order are fixed."""
    derivation = road.derivation
    return {
        "name": name,
        "number": derivation.number,
        "to": None if derivation.to is None else {"number": derivation.to.number, "part": derivation.to.part},
        "says": derivation.says,
        "assuming": [hypothesis.text for hypothesis in derivation.assuming],
        "arrives": road.arrives,
        "steps": [_record(step) for step in road.steps],
    }


def _step(screen: Screen, number: int, step: CheckedStep, latex: bool) -> Iterator[RenderableType]:
    grid = Table.grid(padding=(0, 1, 0, 0))
    grid.add_column(justify="right", style="dim", width=3)
    grid.add_column(overflow="fold")
    verdict = labelled(step.verdict, screen.signs)
    needs = ", ".join(step.verdict.needs)
    shown = Text.assemble((step.kind, "bold"), f" {step.reason}  ")
    if step.comparison is None:
        shown.append_text(verdict).append(f" {needs}" if needs else "")
    grid.add_row(str(number), shown)
    for what, left, right in equations_of(step):
        label = f"{what}:".ljust(9) if what else ""
        grid.add_row("", Text(f"    {label}{plain(left)} = {plain(right)}"))
        if latex:
            grid.add_row("", Text(f"    {label}{in_latex(left)} = {in_latex(right)}", "dim"))
    for line in objections_of(step):
        grid.add_row("", Text(f"    {line}"))
    yield Padding(grid, (0, 0, 0, 1))


def equations_of(step: CheckedStep) -> Iterator[tuple[str, Node, Node]]:
    """What comes of the step; of a comparison, by a label, what was found and what is printed, where not the same."""
    comparison = step.comparison
    if comparison is None:
        yield from (("", left, right) for left, right in step.equations)
    elif comparison.form != "printed" or comparison.chosen:
        yield "found", *comparison.found
        yield "printed", *comparison.statement.printed


def objections_of(step: CheckedStep) -> Iterator[str]:
    """Why the step does not hold, or where the printed equation differs from what was found."""
    if step.comparison is not None:
        printed = step.comparison.printed
        if isinstance(printed, Fails):
            yield f"for example at {point_in_words(printed.counterexample.at) or 'every point'}"
    elif not step.verdict.true and step.verdict.reason not in step.reason:
        yield f"because {step.verdict.reason}"


def outcome_of(road: CheckedDerivation) -> Iterator[tuple[str, str]]:
    """Whether the derivation is complete, and which results differ from the printed equations: words with colours."""
    if not road.arrives:
        yield f"stops at step {len(road.steps)}", "bold red"
        return
    different = road.differences
    yield "complete", "green"
    if not different and road.comparisons:
        yield "; all results are as printed", ""
    for comparison in different:
        yield f"; {number_in_words(comparison.statement.number, comparison.statement.part)}: {comparison.words}", "red"


def _record(step: CheckedStep) -> dict[str, Any]:
    return {
        "kind": step.kind,
        "reason": step.reason,
        "equations": [
            {"text": f"{plain(left)} = {plain(right)}", "latex": f"{in_latex(left)} = {in_latex(right)}"}
            for left, right in step.equations
        ],
        "verdict": step.verdict.name,
        "needs": list(step.verdict.needs),
        "because": None if step.verdict.true else said(step.verdict) + f" {step.verdict.reason}".rstrip(),
        "compared": _compared(step),
    }


def _compared(step: CheckedStep) -> dict[str, Any] | None:
    comparison = step.comparison
    if comparison is None:
        return None
    return {
        "number": comparison.statement.number,
        "part": comparison.statement.part,
        "text": " = ".join(map(plain, comparison.statement.printed)),
        "printed": comparison.printed.name,
        "equal_to": comparison.form,
        "chosen": {plain(symbol): plain(value) for symbol, value in comparison.chosen},
    }
