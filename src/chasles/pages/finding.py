"""What was made of one relation of a page."""

from __future__ import annotations

from dataclasses import dataclass

from chasles.repairs.repair import Repair
from chasles.statements import Statement
from chasles.verdict import Verdict


@dataclass(frozen=True, slots=True)
class PageFinding:
    """What was made of one relation: its role, its verdict, and the statement, with the premises that it needs.

    `against` are the premises of a refutation; `instead` is what is true in place of what fails, or likely is a slip;
    `given` are premises that a person says, and needs no more. The verdict of an `open` one says why it was not proved;
    where there is a `doubt`, it is found only if letters are what is proposed, and that says of which kind. It is open
    `unless` other claims of the page rest on the open equations named, under which it fails; what is true instead is
    `said_elsewhere` where an open equation or another section says it: then that may as well be another case; it is
    `against` the equation of another section that says the same but for one mark.
    """

    role: str
    verdict: Verdict
    statement: Statement | None = None
    open: bool = False
    instead: Repair | None = None
    against: tuple[str, ...] = ()
    given: tuple[str, ...] = ()
    doubt: str = ""
    unless: tuple[frozenset[str], PageFinding] | None = None
    said_elsewhere: bool = False
