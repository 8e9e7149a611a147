"""Findings on a page in words: a line each, as compilers write it, and a record each for programs."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Any

from chasles.pages.page import ReadPage
from chasles.pages.page_equation import PageEquation
from chasles.statements import Definition
from chasles.verdict import Counterexample, Fails, HoldsUnder, IllFormed, Undecided
from chasles.vocabulary import latex, plain

FINE = ("holds", "holds-under", "defined", "posed", "assumed")
ASKED = "if it is a law or a condition, say so"


def line_of(each: PageEquation, file: str) -> str:
    """FILE:LINE: (NUMBER) verdict: reason."""
    number = each.printed.number or each.printed.label
    part = f" part {each.place}" if each.place > 1 else ""
    name = f"({number}){part}" if number else part.strip()
    words = " ".join(filter(None, (name, " ".join(told(each).split()))))
    return f"{each.printed.file or file}:{each.line}: {words}"


def annotation_of(each: PageEquation, file: str) -> str:
    """The same as a workflow command of GitHub, which marks the line in the changes that are looked at."""
    name, line, message = line_of(each, file).split(":", 2)
    level = "error" if each.verdict in ("fails", "ill-formed") else "warning"
    column = each.printed.column if each.read.column is None else each.read.column
    at = name.translate({ord("%"): "%25", ord(":"): "%3A", ord(","): "%2C"})
    return f"::{level} file={at},line={line},col={column}::{message.strip().replace('%', '%25')}"


def is_fine(each: PageEquation) -> bool:
    """Whether there is nothing to look at."""
    return each.verdict in FINE


def told(each: PageEquation) -> str:
    """The verdict and its reason."""
    finding = each.finding
    if finding is None:
        column = f", column {each.read.column}" if each.read.column else ""
        return f"unread: {each.read.why}{column}"
    if finding.doubt:
        return f"ambiguous: {finding.verdict.name} if {finding.doubt}, as is proposed, and is open otherwise"
    if each.verdict == "ambiguous":
        others = "; ".join(f"{verdict} if read {reading}" for verdict, reading in each.others)
        own = "open" if finding.open else finding.verdict.name
        return f"ambiguous: {own} as it is usually read; {others}"
    match finding.verdict:
        case _ if finding.open:
            return _open(each)
        case IllFormed(reason):
            return f"ill-formed: {reason}{_instead(each)}"
        case Fails(counterexample):
            under = f"; under {', '.join(dict.fromkeys(finding.against))}" if finding.against else ""
            return f"fails: {_point(counterexample)}{under}{_instead(each)}"
        case HoldsUnder(needs):
            return f"holds under {', '.join(needs)}{_given(each)}"
        case _ if isinstance(finding.statement, Definition):
            anew = f" anew, not as in {', '.join(dict.fromkeys(finding.against))}" if finding.against else ""
            return f"defines {plain(finding.statement.left)}{anew}"
        case verdict:
            return verdict.name + (f": {verdict.reason}" if isinstance(verdict, Undecided) else _given(each))


def _given(each: PageEquation) -> str:
    return f", given {', '.join(each.finding.given)}" if each.finding and each.finding.given else ""


def _open(each: PageEquation) -> str:
    assert each.finding is not None
    if each.finding.said_elsewhere:
        where = ", ".join(each.finding.against)
        told = f"differs from {where} in one mark: one of them is a slip" if where else "a slip"
        return f"open: {told}, unless it is another case than elsewhere on the page{_instead(each)}"
    if each.finding.instead and not each.finding.verdict.true:
        return f"open: likely a slip, but no point is known at which it fails{_instead(each)}"
    match each.finding.verdict:
        case Fails(counterexample):
            return f"open: does not follow from what the page says before ({_point(counterexample)}); {ASKED}"
        case Undecided(reason):
            return f"open: not decided: {reason}"
        case IllFormed(reason) if each.part and each.part.fault:
            return f"open: ill-formed if the letters are what is proposed: {reason}"
        case _:
            return f"open: does not follow from what the page says before; {ASKED}"


def _instead(each: PageEquation) -> str:
    found = each.finding.instead if each.finding else None
    return (
        f"; instead: {latex(found.left)} {each.part.sign if each.part else '='} {latex(found.right)}" if found else ""
    )


def _point(found: Counterexample) -> str:
    """Where the sides differ, and in which entry."""
    by_value: dict[Fraction, list[str]] = {}
    for name, value in found.at.items():
        by_value.setdefault(value, []).append(name)
    at = ", ".join(f"{' = '.join(names)} = {value}" for value, names in by_value.items())
    row, column = found.entry
    place = f" (row {row}, column {column})" if column > 1 else f" (row {row})" if row > 1 else ""
    where = f"at {at} " if at else ""
    return f"{where}the left side is {found.left}, the right side {found.right}{place}"


def records_of(page: ReadPage) -> dict[str, Any]:
    """Everything of a page, as plain data."""
    return {"file": page.file, "equations": [record_of(each) for each in page.equations], "counts": page.counts}


def record_of(each: PageEquation) -> dict[str, Any]:
    """One relation as plain data: keys and their order are fixed."""
    finding, printed = each.finding, each.printed
    statement = finding.statement if finding else None
    counterexample = getattr(finding.verdict, "counterexample", None) if finding else None
    instead = finding.instead if finding else None
    return {
        "number": printed.number,
        "label": printed.label,
        "line": each.line,
        "column": printed.column,
        "latex": printed.latex,
        "part": each.place,
        "status": each.read.status,
        "why": each.read.why or ("" if is_fine(each) else told(each)),
        "role": finding.role if finding else None,
        "declaration": f"{plain(statement.left)} {statement.sign} {plain(statement.right)}" if statement else None,
        "verdict": each.verdict,
        "needs": list(finding.verdict.needs) if finding else [],
        "given": list(finding.given) or [given.number for given in statement.given] if finding and statement else [],
        "counterexample": _counterexample(counterexample),
        "instead": {"latex": f"{latex(instead.left)} = {latex(instead.right)}", "changes": list(instead.changes)}
        if instead
        else None,
        "read_back": each.read.status != "unread",
    }


def _counterexample(found: Counterexample | None) -> Mapping[str, Any] | None:
    if found is None:
        return None
    at = {name: str(value) for name, value in found.at.items()}
    return {"at": at, "entry": list(found.entry), "lhs": found.left, "rhs": found.right}
