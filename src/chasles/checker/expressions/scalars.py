"""A problem without a polynomial form, as a question on SymPy expressions, entry by entry.

Prover and checker read such a problem here, and from here on as they read what SymPy users ask.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from fractions import Fraction
from functools import reduce
from typing import Any

import sympy as sp
from sympy.core.function import AppliedUndef

from chasles import vocabulary as w
from chasles.checker.expressions.counterexample import check_refutation
from chasles.checker.expressions.proof import check_proof
from chasles.checker.expressions.widened import plain_expression, put
from chasles.checker.expressions.words import EntriesOfWords
from chasles.checker.sparse import Rejected
from chasles.statements import Hypothesis, Problem
from chasles.statements.conditions import ASSUMED, UNFINISHED
from chasles.verdict import Counterexample, HoldsUnder
from chasles.vocabulary.functions import FunctionOf


@dataclass(frozen=True, slots=True)
class ScalarQuestion:
    """Both sides of all goals, one entry below the other, what is given, and what does not vanish.

    `places` are the goal, row and column of each entry; `sources` who says what is given, by its text in SymPy; `used`
    the hypotheses by which arguments of functions are said otherwise. If it is `partial`, hypotheses say more than
    that: a proof counts, a counterexample does not. `values` are those that quantities between bounds have.
    """

    left: Any
    right: Any
    given: tuple[Any, ...]
    nonzero: tuple[Any, ...]
    places: tuple[tuple[str, tuple[int, int]], ...]
    sources: Mapping[str, tuple[str, ...]]
    used: tuple[str, ...]
    partial: bool
    values: Mapping[Any, Any]

    @property
    def asked(self) -> tuple[Any, ...]:
        """The question as `chasles.prove` takes it."""
        return self.left, self.right, self.given, self.nonzero


def scalar_question(problem: Problem, proving: bool = True) -> ScalarQuestion:
    """The question that a problem asks, entry by entry; raises `Rejected` for a word that has no entries.

    A divisor that was cancelled is named among what is used. Of a quantity between bounds it is asked of all values
    between them; for proving, the bounds are left out where no function or root has other values without them, and
    nothing else is said of it: a proof does without them, and a witness need not be looked for.
    """
    entries = EntriesOfWords(problem)
    sides = [[entries(side) for side in goal.sides] for goal in problem.goals]
    left, right = (sp.Matrix([entry for pair in sides for entry in pair[k]]) for k in (0, 1))
    given: dict[Any, tuple[str, ...]] = {}
    both = sp.Tuple(*left, *right)
    values = entries.values_between(both, numbers=not proving)
    settled = {*entries.by_sign, *(text for _, texts in values.values() for text in texts)}
    nonzero: list[Any] = []
    sources: dict[str, tuple[str, ...]] = {}
    stated = [("", goal.left, goal.right) for goal in problem.conditions]
    assumed = [hypothesis for hypothesis in problem.hypotheses if hypothesis.text not in settled]
    # That a condition holds is given: it is no condition of a verdict, nor is it that a vector has a direction.
    texts_of = {h: "" if h.kind in {*ASSUMED, "direction"} else h.text for h in assumed if h.kind != "definite"}
    stated += [(text, *p) for h, text in texts_of.items() if not _turns(h) for p in h.equations]
    stated += [(h.text, abs(s), s) for h in assumed if h.kind == "positive" for s in h.subjects if s in entries.rules]
    stated += [("", abs(symbol), symbol) for symbol in problem.nonnegative if symbol in entries.rules]
    for text, one, other in stated:
        for equation in entries.equations(one, other):
            # That a matrix is symmetric says of each pair of entries twice that they are equal.
            if sp.Eq(equation.rhs, equation.lhs, evaluate=False) not in given:
                given[equation] = (text,)
    for text, matrix in ((h.text, h.subjects[0]) for h in assumed if h.kind == "definite"):
        product, diagonal = entries.factored(matrix)
        given |= {sp.Eq(*pair, evaluate=False): (text,) for pair in zip(entries(matrix), product, strict=True)}
        sources |= {f"{entry} is positive": (text,) for entry in diagonal}
    for hypothesis in (h for h in assumed if h.kind != "positive" or h.subjects[0] in entries.rules):
        nodes = hypothesis.nonvanishing[: 1 if hypothesis.kind == "inequality" else None]
        kept = [entries(node)[0] for node in nodes]
        if _turns(hypothesis):  # its difference, read as a word by the hypothesis itself, would say nothing
            value = entries(hypothesis.subjects[0])[0]
            kept = [value for _ in nodes if value.atoms(sp.Function) <= value.atoms(sp.cos, sp.sin)]
            sign = (sp.sign(value), sp.Integer(1)) if nodes and not kept else (sp.Abs(value), value)
            given[sp.Eq(*sign, evaluate=False)] = (hypothesis.text,)
        nonzero += kept
        sources |= {f"{value} != 0": (hypothesis.text,) for value in kept}
    lost = entries.lost_divisors(both)
    nonzero += [divisor for divisor in lost if divisor not in nonzero]
    if not proving:
        for domain in entries.lost_domains(both):
            given[sp.Eq(sp.Abs(domain), domain, evaluate=False)] = (f"{spelled(domain)} >= 0",)
    if proving:
        values = {q: e for q, e in values.items() if _matters(q, both) or any(e.has(q) for e in (*given, *nonzero))}

    def said(e: Any) -> Any:
        return reduce(lambda e, known: put(e, known[0], known[1][0]), values.items(), e)

    given = {sp.Eq(*map(said, equation.args), evaluate=False): texts for equation, texts in given.items()}
    sources |= {f"{said(e)} != 0": sources.get(f"{e} != 0", (f"{spelled(e)} != 0",)) for e in nonzero}
    if not proving:
        given |= {sp.Eq(quantity, value, evaluate=False): texts for quantity, (value, texts) in values.items()}
    shapes = [(goal.label, *goal.left.shape) for goal in problem.goals]
    places = tuple((label, (i + 1, j + 1)) for label, m, n in shapes for i in range(m) for j in range(n))
    partial = any(h.kind == UNFINISHED for h in problem.hypotheses)
    sources |= {f"{equation.lhs} = {equation.rhs}": texts for equation, texts in given.items()}
    divided = (text for e in lost for text in sources.get(f"{e} != 0", (f"{spelled(e)} != 0",)))
    used = (*entries.reasons, *dict.fromkeys(text for _, texts in values.values() for text in texts), *divided)
    left, right = left.applyfunc(said), right.applyfunc(said)
    known = {quantity: value for quantity, (value, _) in values.items()}
    return ScalarQuestion(left, right, tuple(given), tuple(map(said, nonzero)), places, sources, used, partial, known)


def spelled(e: Any) -> str:
    """A SymPy expression, or a text with one, as it is spelled in a chapter."""
    return str(e).replace("**", "^").replace("*", " ")


def _matters(quantity: Any, sides: Any) -> bool:
    """Whether sides speak of a quantity in more than products and sums of cosines and sines."""
    calls = sides.atoms(sp.Function, sp.Pow)
    turns = {call: sp.Dummy() for call in calls if isinstance(call, sp.cos | sp.sin)}
    plain = (*turns, *sides.atoms(AppliedUndef), *(e for e in calls if e.is_Pow and e.exp.is_Integer))
    return any(e.has(quantity) for e in (sides.xreplace(turns), *calls.difference(plain)))


def _turns(hypothesis: Hypothesis) -> bool:
    """Whether it is an inequality with functions: said by a sign, not by a square."""
    words = w.walk(hypothesis.subjects[0]) if hypothesis.kind == "inequality" else ()
    return any(isinstance(part, w.Call | FunctionOf) for part in words)


def check_scalars(problem: Problem, certificate: Mapping[str, Any]) -> None:
    """The certificate proves the question that the problem asks; raises `Rejected` with the reason if not."""
    question = scalar_question(problem, proving=not certificate.get("whole"))
    needs = tuple(certificate["needs"])
    point = {name: plain_expression(text, {}) for name, text in certificate["point"].items()}
    witness = {name: Fraction(int(e.p), int(e.q)) if e.is_Rational else e for name, e in point.items()}
    check_proof(HoldsUnder(needs, certificate["scalars"], witness), *question.asked)


def check_scalar_counterexample(problem: Problem, shown: Counterexample) -> None:
    """The point refutes the question that the problem asks; raises `Rejected` with the reason if not."""
    question = scalar_question(problem, proving=False)
    if question.partial:
        raise Rejected("a hypothesis says more than equations, and nothing shows that the point satisfies it")
    if (shown.goal, shown.entry) not in question.places:
        raise Rejected(f"no equation of the statement is called {shown.goal!r}, or it has no such entry")
    check_refutation(replace(shown, entry=(question.places.index((shown.goal, shown.entry)) + 1, 1)), *question.asked)
