"""From the book to what is emitted: a statement that asks for a kernel, its verdict, and a program proved equal."""

from __future__ import annotations

from chasles.lowering.declaration import Decide, requested
from chasles.lowering.equality import differences
from chasles.lowering.lower import program_of
from chasles.lowering.offered import counterexample, in_words
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.proof.judge import Decision
from chasles.proof.verdict import HoldsUnder, Verdict
from chasles.statements import Entry
from chasles.statements.fingerprint import fingerprint
from chasles.targets.kernel import EmissionError, Heading, Kernel
from chasles.targets.self_checks import checks_of

__all__ = ["kernel_of"]


def kernel_of(entry: Entry, decide: Decide) -> Kernel:
    """The kernel that a statement asks for; `decide` gives verdicts, as `Judge.decide` does.

    Raises EmissionError where the statement does not stand, where no program can be made of it, and where the program
    is not proved to equal what stands.
    """
    try:
        request = requested(entry, decide)
        program = program_of(request)
    except LoweringError as error:
        raise EmissionError(str(error)) from error
    wrong = differences(request, program)
    if wrong:
        raise EmissionError(f"{program.name}: {_unequal(entry, request, wrong)}")
    heading = _heading(entry, decide(entry.statement), request)
    return Kernel(program, heading, checks_of(request, program))


def _unequal(entry: Entry, request: Request, wrong: tuple[str, ...]) -> str:
    """In what a program, or the form of which it is made, is not what stands."""
    found = counterexample(request) if request.form else None
    if found is not None:
        return f"the offered form is not equal to ({entry.number}), as one sees {in_words(found)}"
    what = "offered form" if request.form else "program"
    return f"the {what} is not proved to equal ({entry.number}): {'; '.join(wrong)}"


def _heading(entry: Entry, decision: Decision, request: Request) -> Heading:
    """What the generated function says of itself."""
    standing, said = decision.verdict, _word(decision.verdict)
    if not standing.true and decision.correction is not None:
        standing = decision.correction.verdict
        how = {"reading": "as read", "repair": "as repaired", "corrected": "as corrected"}[decision.correction.form]
        said = f"{said} as printed, {_word(standing)} {how}"
    needs = standing.needs if isinstance(standing, HoldsUnder) else _assumed(standing, request)
    section = f"section_{entry.section.number.replace('.', '_')}"
    derivation, form = fingerprint(entry.statement), "offered" if request.form else "stated"
    return Heading(entry.number, entry.statement.says, said, needs, derivation, section, form)


def _word(verdict: Verdict) -> str:
    return "holds under" if verdict.name == "holds-under" else verdict.name


def _assumed(verdict: Verdict, request: Request) -> tuple[str, ...]:
    """A definition is not decided, so its kernel assumes all that it does; what holds without more assumes nothing."""
    if verdict.name != "defined":
        return ()
    return tuple(dict.fromkeys(hypothesis.text for hypothesis in request.hypotheses))
