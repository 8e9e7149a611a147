"""What theorems say, with their quantifiers: each of their forms is a claim that follows from its equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import Unsaid
from chasles.coq.forms import SAID, SaidForm
from chasles.coq.proof import steps_of, theorem
from chasles.coq.sentences import NOW, asserted, for_all, introduced
from chasles.coq.statement import CoqStatement
from chasles.statements import Problem, Theorem
from chasles.statements.varied import demands, varied_symbol, visible


def theorem_and_proof(
    name: str, sentence: Theorem, said: CoqStatement, certificate: Mapping[str, Any]
) -> tuple[str, str]:
    """The definition of what a theorem says, and the theorem that it is so. Raises `Unsaid` for some forms."""
    parts = list(_parts(sentence, said, certificate))
    lemmas, steps = list[str](), list[str]()
    for count, part in enumerate(parts):
        lemmas += asserted(f"equations'{count}", part.said, steps_of(part.said, part.certificate))
        shown = part.steps(f"equations'{count}")
        steps += [f"assert (form'{count} : {part.claim}).", "{", *(f"  {step}" for step in shown), "}"]
    intro = f"intros {introduced(said)}{NOW * said.timed}."
    proof = "".join(f"conj form'{count} (" for count in range(len(parts) - 1))
    closed = f"exact ({proof}form'{len(parts) - 1}{')' * (len(parts) - 1)})."
    text = f"Definition {name} : Prop :=\n{for_all(said, [part.claim for part in parts])}.\n"
    return text, theorem(name, [*(["unfold during."] * said.timed), *lemmas, intro, *steps, closed])


def cover_and_proof(name: str, said: CoqStatement, certificate: Mapping[str, Any]) -> tuple[str, str]:
    """The definition of what says that no case is left out, and the theorem: else one were a sum of zeros."""
    [goal] = said.problem.goals
    terms = goal.left.terms if isinstance(goal.left, w.Sum) else (goal.left,)
    cases = [said.spelling.number(term.term) for term in terms if isinstance(term, w.Scale)]
    some = " \\/ ".join(f"{case} <> 0" for case in cases)
    text = f"Definition {name} : Prop :=\n{for_all(said, [some])}.\n"
    bound = introduced(said)
    steps = [
        *asserted("equation'", said, steps_of(said, certificate)),
        f"intros {bound}. specialize (equation' {bound}).",
    ]
    for count, case in enumerate(cases):
        left = "left; " * (count < len(cases) - 1)
        steps.append(f"destruct (Req_dec ({case}) 0) as [zero'{count}|taken']; [|{left}exact taken'].")
        steps += ["right."] * bool(left)
    zeros = ", ".join(f"zero'{count}" for count in range(len(cases)))
    steps.append(f"exfalso. rewrite {zeros} in equation'. lra.")
    return text, theorem(name, steps)


def _parts(sentence: Theorem, said: CoqStatement, certificate: Mapping[str, Any]) -> Iterator[SaidForm]:
    problem, start = said.problem, 0
    rules = dict(problem.rules)
    for form in sentence.forms:
        shown = visible(form, rules, ())
        if tuple(demands(shown, problem.hypotheses)):
            raise Unsaid("what is assumed of a symbol that a theorem varies")
        count = len(shown.equations())
        varied = varied_symbol(form)
        goals = problem.goals[start : start + count]
        some = replace(problem, goals=goals, rules=_without(problem, varied[0] if varied else None))
        entries = {
            f"{int(key.partition(':')[0]) - start}:{key.partition(':')[2]}": entry
            for key, entry in certificate.get("entries", {}).items()
            if start <= int(key.partition(":")[0]) < start + count
        }
        if type(shown) not in SAID:
            raise Unsaid(f"a theorem of the form {type(shown).__name__}")
        yield SAID[type(shown)](shown, said, CoqStatement(some, said.names), {**certificate, "entries": entries})
        start += count


def _without(problem: Problem, varied: w.Symbol | None) -> tuple[tuple[w.Node, w.Node], ...]:
    """The rules that do not depend on a symbol."""
    depending: set[w.Node] = {varied} if varied is not None else set()
    while more := {w.undotted(left)[0] for left, right in problem.rules if depending & {*w.walk(right)}} - depending:
        depending |= more
    return tuple(rule for rule in problem.rules if w.undotted(rule[0])[0] not in depending)
