"""From the book to what is emitted: a statement that asks for a kernel, its verdict, and a program proved equal.

What must hold of the kernel's arguments is what its proof assumes of them, and what is expected of them besides. What
is assumed of other symbols cannot be seen in the arguments: a declaration says in `expected` what amounts to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator

from chasles.bounds.bound import Bound
from chasles.decisions.decision import HOW, Decision
from chasles.lowering.declaration import Decide, requested
from chasles.lowering.equivalence.requests import differences
from chasles.lowering.lower import program_of
from chasles.lowering.offered import counterexample, in_words
from chasles.lowering.program import Program
from chasles.lowering.reach import Reach
from chasles.lowering.refusal import LoweringError
from chasles.lowering.request import Output, Request, composed
from chasles.statements import Entry, Hypothesis, Packed
from chasles.statements import Kernel as Asked
from chasles.statements.arrays import argument_name
from chasles.statements.fingerprint import fingerprint
from chasles.statements.kernel import nodes_of
from chasles.targets.kernel import Demand, EmissionError, Heading, TargetKernel
from chasles.targets.self_checks import checks_of
from chasles.verdict import HoldsUnder, Verdict
from chasles.vocabulary import Node

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


def demands_of(request: Request, hypotheses: Iterable[Hypothesis]) -> tuple[Demand, ...]:
    """Those of the hypotheses that are about the arguments, each once; what another one implies is left out.

    Of those that say the same in words, as those of a statement and of what is given to it may, the first is taken.
    """
    chosen = [h for h in dict.fromkeys(hypotheses) if not _is_built_in(h, request)]
    implied = {node for h in chosen if h.kind != "nonzero" for node in h.nonvanishing}
    found = (_demand(h, request) for h in chosen if h.kind != "nonzero" or not implied.issuperset(h.nonvanishing))
    said: dict[str, Demand] = {}
    for demand in found:
        if demand is not None:
            said.setdefault(demand.text, demand)
    return tuple(said.values())


def _is_built_in(hypothesis: Hypothesis, request: Request) -> bool:
    """Whether it says that a matrix is symmetric of which only six numbers are given."""
    packed = {argument.matrix for argument in request.arguments if isinstance(argument, Packed)}
    return hypothesis.kind == "symmetric" and packed.issuperset(hypothesis.subjects)


def _demand(hypothesis: Hypothesis, request: Request) -> Demand | None:
    """What the hypothesis demands; None if it is not about the arguments alone."""
    if hypothesis.kind == "nonzero":
        divisor = _divisor(hypothesis.nonvanishing[0], request)
        names = tuple(argument.name for argument in divisor.arguments) if divisor else ()
        return Demand(hypothesis.kind, hypothesis.text, names, divisor) if divisor else None
    if not set(request.of).issuperset(hypothesis.subjects):
        return None
    return Demand(hypothesis.kind, hypothesis.text, tuple(_holders(hypothesis.subjects, request)))


def _holders(subjects: Iterable[Node], request: Request) -> Iterator[str]:
    for subject in subjects:
        for argument in request.arguments:
            if subject in nodes_of(argument):
                yield argument_name(argument)


def _divisor(node: Node, request: Request) -> Program | None:
    """The program of what must not vanish, as a function of the arguments on which it depends; None if of others."""
    rules, angles = dict(request.rules), dict(request.angles)
    reach = Reach(request.name, request.of, rules, request.choices, angles)
    try:
        reach.follow(node)
    except LoweringError:
        return None
    arguments = [argument for argument in request.arguments if any(map(reach.is_used, nodes_of(argument)))]
    if not arguments:
        return None
    value = Output("divisor", "what must not vanish", node)
    return program_of(composed(request.name, arguments, [value], rules=rules, choices=request.choices, angles=angles))
