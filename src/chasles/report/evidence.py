"""Measured errors: a row for each kernel, with its largest errors and where it loses digits.

Each piece of evidence is on one kernel, in one precision, at one kind of point.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from math import isfinite

from rich.console import RenderableType
from rich.table import Table
from rich.text import Text

from chasles.numerics.verify import Evidence
from chasles.report.details import indented
from chasles.report.screen import Screen

GENERIC = "generic"
RARE = 0.1
"""The share of points at large at which a right kernel may lose digits: some happen to be near a singular set."""
SIGNS = {"fine": ("✓", "ok", "green"), "lossy": ("≈", "~", "yellow"), "wrong": ("✗", "no", "bold red")}


def is_wrong(evidence: Evidence) -> bool:
    """Whether the kernel computes something else: digits are lost at large, and not only near a singular set."""
    return strategy_of(evidence) == GENERIC and evidence.failed > RARE * evidence.samples


def strategy_of(evidence: Evidence) -> str:
    """The kind of points of the evidence; empty where there was none with a value."""
    return evidence.worst[0].strategy if evidence.worst else ""


def evidence_table(screen: Screen, found: Sequence[Evidence]) -> Iterator[RenderableType]:
    """The largest error of each kernel for each precision and kind of point, in units of the roundoff."""
    columns = list(dict.fromkeys((evidence.dtype, strategy_of(evidence)) for evidence in found))
    columns.sort(key=lambda column: column[0], reverse=True)
    table = Table(box=None, pad_edge=False, header_style="dim", padding=(0, 2, 0, 0))
    table.add_column("kernel", overflow="fold")
    table.add_column("", no_wrap=True)
    for dtype, strategy in columns:
        table.add_column(f"{dtype}\n{strategy}", justify="right", no_wrap=True)
    for name in dict.fromkeys(evidence.kernel for evidence in found):
        mine = [evidence for evidence in found if evidence.kernel == name]
        by_column = {(evidence.dtype, strategy_of(evidence)): evidence for evidence in mine}
        table.add_row(Text(name), _sign(screen, mine), *(_error(by_column.get(column)) for column in columns))
    yield table


def losses(found: Sequence[Evidence]) -> Iterator[RenderableType]:
    """For each kernel that loses digits: at how many points, and its largest error with the inputs that gave it."""
    for evidence in found:
        if evidence.passed:
            continue
        worst = evidence.failures[0]
        where = f"  {evidence.dtype}, {worst.strategy} points: {evidence.failed} of {evidence.samples} lose digits"
        yield Text.assemble("\n", (evidence.kernel, "bold"), where)
        size = f"{worst.error:.3g} units of roundoff in {worst.output}, where {worst.allowed:.3g} are allowed"
        lines = [("error", size)]
        lines += [(f"at {name}", str(value)) for name, value in worst.at.items()]
        yield indented(iter(lines))


def worst_of(found: Sequence[Evidence]) -> str:
    """The largest error of each precision over what roundings and inputs explain, and whose it is, in one line.

    The bare error says nothing of the kernel: where terms cancel, the inputs' last digits leave no more of the result.
    """
    parts = []
    for dtype in dict.fromkeys(evidence.dtype for evidence in found):
        worst = max((evidence for evidence in found if evidence.dtype == dtype), key=lambda evidence: evidence.share)
        size = f"{worst.share:.2g}" if isfinite(worst.share) else "inf"
        parts.append(f"{size} in {dtype} ({worst.kernel})")
    return f"largest errors as a share of what roundings and the inputs' last digits explain: {', '.join(parts)}"


def _error(evidence: Evidence | None) -> Text:
    if evidence is None or not evidence.worst:
        return Text("-", "dim")
    error = evidence.error
    shown = f"{error:.1f}" if error < 100 else f"{error:.0e}" if isfinite(error) else "inf"
    return Text(shown, "" if evidence.passed else "yellow")


def _sign(screen: Screen, mine: Sequence[Evidence]) -> Text:
    grade = "wrong" if any(map(is_wrong, mine)) else "fine" if all(evidence.passed for evidence in mine) else "lossy"
    sign, word, colour = SIGNS[grade]
    return Text(sign if screen.signs else word, colour)
