"""What theorems say, with their quantifiers: each of their forms is a claim that follows from its equations."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from chasles import vocabulary as w
from chasles.coq.expressions import ATOM, Spelling, Unsaid
from chasles.coq.proof import steps_of, theorem
from chasles.coq.sentences import NOW, asserted, for_all, introduced
from chasles.coq.statement import CoqStatement
from chasles.statements import Problem, Theorem
from chasles.statements.forms import Always, Exists, Form, Iff, Minimum
from chasles.statements.varied import demands, varied_symbol, visible
from chasles.vocabulary.letters import zero_of


def theorem_and_proof(
    name: str, sentence: Theorem, said: CoqStatement, certificate: Mapping[str, Any]
) -> tuple[str, str]:
    """The definition of what a theorem says, and the theorem that it is so. Raises `Unsaid` for some forms."""
    parts = list(_parts(sentence, said, certificate))
    lemmas, steps = list[str](), list[str]()
    for count, part in enumerate(parts):
        lemmas += asserted(f"equations'{count}", part.said, steps_of(part.said, part.certificate))
        steps += [f"assert (form'{count} : {part.claim}).", "{", *(f"  {step}" for step in part.steps(count)), "}"]
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


@dataclass(frozen=True, slots=True)
class _Part:
    """A form of a theorem, with what proves its equations from no more than they need."""

    form: Form
    whole: CoqStatement
    said: CoqStatement
    certificate: Mapping[str, Any]

    @property
    def claim(self) -> str:
        """What the form says."""
        goals, spelling = self.said.problem.goals, self.said.spelling
        match self.form:
            case Always():
                return spelling.equation(goals[0].left, goals[0].right)
            case Iff():
                return f"({_vanishing(spelling, goals[1].left)} <-> {_vanishing(spelling, goals[0].left)})"
            case Minimum(over=over, at=at):
                of, value = self._excess()
                name, freed = self._freed(over)
                least = f"least (fun {name} => {freed.number(of)}) {spelling.number(value, ATOM)} {_side(spelling, at)}"
                return f"{least}"
            case Exists(symbol=symbol, left=left, right=right):
                name, freed = self._freed(symbol)
                kind = "R" if symbol.is_scalar else f"M {symbol.shape[0]} {symbol.shape[1]}"
                return f"(exists {name} : {kind}, {freed.equation(left, right)})"
        raise Unsaid(f"a theorem of the form {type(self.form).__name__}")

    def _freed(self, symbol: w.Symbol) -> tuple[str, Spelling]:
        """The name of a symbol, and how expressions are spelled in which it is bound."""
        names = self.said.names
        return names.symbol(symbol), Spelling(
            names, lambda node, name: name if node == symbol else self.said.applied(node, name)
        )

    def _excess(self) -> tuple[w.Node, w.Node]:
        """What is least, and its least value."""
        match self.said.problem.goals[0].left:
            case w.Sum((of, w.Negative(value))):
                return of, value
        raise Unsaid("a minimum that is no difference")

    def steps(self, count: int) -> Iterator[str]:
        """The steps by which it follows from the equations."""
        match self.form:
            case Always():
                yield f"exact {self._applied(count)}."
            case Iff():
                yield f"destruct {self._applied(count)} as [forth' back']."
                yield "split; intro zero'; [rewrite forth', zero' | rewrite back', zero']; multiple_of_zero."
            case Minimum(over=over, at=at):
                goals = self.said.problem.goals
                squares = [f"square'{k}" for k in range(1, len(goals))]
                there = _side(self.whole.spelling, at)
                yield "split; [|intro value']."
                yield f"- destruct {self._applied(count, over, there)} as (excess' & {' & '.join(squares)})."
                yield f"  cbv beta in *. rewrite {', '.join(squares)}, ?dot_zero in excess'. lra."
                anywhere = self._applied(count, over, "value'")
                yield f"- destruct {anywhere} as [excess' _]."
                yield "  cbv beta in *. apply Rge_le, Rminus_ge, Rle_ge. rewrite excess'. sum_of_squares."
            case Exists(witness=witness):
                yield f"exists {_side(self.whole.spelling, witness)}. exact {self._applied(count)}."

    def _applied(self, count: int, over: w.Symbol | None = None, value: str = "") -> str:
        """The equations, for the symbols of the theorem; with another value of one of them."""
        arguments = {name: name for name, _ in self.said.binders}
        if over is not None and over in self.said.names.symbols:
            arguments[self.said.names.symbol(over)] = f"(fun _ => {value})" if self.said.moves(over) else value
        now = NOW * self.said.timed
        return f"(equations'{count} {' '.join([*arguments.values(), *(p.name for p in self.said.premises)])}{now})"


def _parts(sentence: Theorem, said: CoqStatement, certificate: Mapping[str, Any]) -> Iterator[_Part]:
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
        yield _Part(shown, said, CoqStatement(some, said.names), {**certificate, "entries": entries})
        start += count


def _without(problem: Problem, varied: w.Symbol | None) -> tuple[tuple[w.Node, w.Node], ...]:
    """The rules that do not depend on a symbol."""
    depending: set[w.Node] = {varied} if varied is not None else set()
    while more := {w.undotted(left)[0] for left, right in problem.rules if depending & {*w.walk(right)}} - depending:
        depending |= more
    return tuple(rule for rule in problem.rules if w.undotted(rule[0])[0] not in depending)


def _vanishing(spelling: Spelling, node: w.Node) -> str:
    return spelling.equation(node, zero_of(node.shape))


def _side(spelling: Spelling, node: w.Node) -> str:
    return spelling.number(node, ATOM) if node.shape == (1, 1) else f"({spelling.matrix(node)})%M"
