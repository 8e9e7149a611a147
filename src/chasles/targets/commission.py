"""From the book to what is emitted: a statement that asks for a kernel, its verdict, and a program proved equal."""

from __future__ import annotations

from collections.abc import Callable

from chasles.bounds.bound import Bound
from chasles.decisions.decision import HOW, Decision
from chasles.lowering.declaration import Decide, requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.offered import counterexample, in_words
from chasles.lowering.program import Program
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Request
from chasles.statements import Entry
from chasles.statements import Kernel as Asked
from chasles.statements.fingerprint import fingerprint
from chasles.targets.demands import demands_of
from chasles.targets.kernel import EmissionError, Heading, TargetKernel
from chasles.targets.self_checks import checks_of
from chasles.verdict import HoldsUnder, Verdict

Prove = Callable[[Program, Request], Bound]
"""What is proved of a program's errors."""


def kernel_of(entry: Entry, decide: Decide, asked: Asked | None = None, prove: Prove | None = None) -> TargetKernel:
    """The kernel `asked` of a statement, or the first that it asks for; `decide` gives verdicts, `prove` error bounds.

    Raises EmissionError where the statement is not accepted, where no program can be made of it, and where the program
    is not proved to equal the accepted form.
    """
    asked = asked or next(iter(entry.kernels), None)
    try:
        request = requested(entry, decide, asked)
        program = program_of(request)
    except LoweringError as error:
        raise EmissionError(str(error)) from error
    wrong = differences(request, program)
    if wrong:
        raise EmissionError(f"{program.name}: {_unequal(entry, request, wrong)}")
    assert asked is not None
    heading = _heading(entry, decide(entry.statement), request, asked)
    needed = [hypothesis for hypothesis in request.hypotheses if hypothesis.text in heading.hypotheses]
    demands = demands_of(request, (*needed, *asked.expected))
    return TargetKernel(
        program, heading, checks_of(request, program), demands, prove(program, request) if prove else None
    )


def _unequal(entry: Entry, request: Request, wrong: tuple[str, ...]) -> str:
    """How a program, or the form of which it is made, differs from the accepted form."""
    found = counterexample(request) if request.form else None
    if found is not None:
        return f"the offered form is not equal to ({entry.number}), as one sees {in_words(found)}"
    what = "offered form" if request.form else "program"
    return f"the {what} is not proved to equal ({entry.number}): {'; '.join(wrong)}"


def _heading(entry: Entry, decision: Decision, request: Request, asked: Asked) -> Heading:
    """What the generated function says of itself."""
    verdict, said = decision.verdict, _word(decision.verdict)
    if not verdict.true and decision.correction is not None:
        verdict = decision.correction.verdict
        said = f"{said} as printed, {_word(verdict)} {HOW[decision.correction.form]}"
    needs = verdict.needs if isinstance(verdict, HoldsUnder) else _assumed(verdict, request)
    section = f"section_{entry.section.number.replace('.', '_')}"
    derivation, form = fingerprint(entry.statement), "offered" if request.form else "stated"
    expected = tuple(hypothesis.text for hypothesis in asked.expected if hypothesis.text not in needs)
    return Heading(entry.number, entry.statement.says, said, needs, derivation, section, form, expected)


def _word(verdict: Verdict) -> str:
    return "holds under" if verdict.name == "holds-under" else verdict.name


def _assumed(verdict: Verdict, request: Request) -> tuple[str, ...]:
    """A definition is not decided, so its kernel assumes all that it does; what holds without more assumes nothing."""
    if verdict.name != "defined":
        return ()
    return tuple(dict.fromkeys(hypothesis.text for hypothesis in request.hypotheses))
