"""What each kind of step makes of the equations reached, and how it is decided."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

from chasles.deriving.solving import solve_by_moving, solve_by_multiplying, solve_linear_system
from chasles.deriving.state import Equation, State, usable
from chasles.rewriting.isolate import CannotIsolate, alone, before
from chasles.rewriting.matching import occurs, put_for
from chasles.rewriting.product import chained
from chasles.rewriting.products import multiplied_out, without_brackets
from chasles.rewriting.rates import carried_out, rate_of
from chasles.rewriting.tidy import tidied
from chasles.statements.derivation import (
    Ansatz,
    Consider,
    DerivationStep,
    Differentiate,
    Expand,
    Factor,
    FactorOut,
    Multiply,
    Solve,
    Substitute,
    Take,
    TakeVector,
)
from chasles.verdict import Holds, Posed, Verdict
from chasles.vocabulary import Contract, Identity, Inverse, Negative, Node, Rate, Scale, Sum, Symbol, Vect, replace


@dataclass(frozen=True, slots=True)
class StepResult:
    """The equations after a step, the verdict on it, and what is done in words."""

    equations: tuple[Equation, ...]
    verdict: Verdict
    reason: str


def carry_out(step: DerivationStep, state: State) -> StepResult:
    """The step's outcome; raises TypeError for a kind of step that is not known."""
    kinds: dict[type[Any], Callable[[Any, State], StepResult]] = {
        Take: _take,
        Consider: _consider,
        Substitute: _substitute,
        Expand: _expand,
        Factor: _factor,
        FactorOut: _factor_out,
        Ansatz: _ansatz,
        Solve: _solve,
        Differentiate: _differentiate,
        Multiply: _multiply,
        TakeVector: _take_vector,
    }
    if type(step) not in kinds:
        raise TypeError(f"no way to carry out a step of the kind {type(step).__name__}")
    return kinds[type(step)](step, state)


def _take(step: Take, state: State) -> StepResult:
    verdicts = [state.session.decide(statement).standing for statement in step.statements]
    verdict = next((v for v in verdicts if not v.true), verdicts[0])
    said = "; ".join(f"{state.cited(s)} {s.says}" for s in step.statements)
    return StepResult(tuple(map(state.sides, step.statements)), verdict, said)


def _consider(step: Consider, state: State) -> StepResult:
    node = without_brackets(step.expression)
    return StepResult(((node, node),), Holds({"entries": {}}, {}), f"{step.expression}")


def _substitute(step: Substitute, state: State) -> StepResult:
    """Each left side in turn; where it is no symbol, it is held fast as one while the step is decided."""
    if not step.statements:
        return _substitute_solved(step, state)
    equations, verdict = state.equations, None
    for statement in step.statements:
        if not any(occurs(state.sides(statement)[0], side) for side in _worked_on(equations, step.both)):
            raise ValueError(f"the left side of {state.cited(statement)}, {state.sides(statement)[0]}, does not occur")
        equations, decided = _put(state, equations, state.sides(statement), step, usable(statement))
        verdict = decided if verdict is None or verdict.true else verdict
    assert verdict is not None
    return StepResult(equations, verdict, ", ".join(map(state.cited, step.statements)))


def _worked_on(equations: Sequence[Equation], both: bool) -> list[Node]:
    return [side for left, right in equations for side in ((left, right) if both else (right,))]


def _put(
    state: State, equations: tuple[Equation, ...], rule: Equation, step: Substitute, as_rule: bool
) -> tuple[tuple[Equation, ...], Verdict]:
    pattern, value = rule
    after, goals, held = [], [], []
    assert pattern.measure is not None
    stand_in = Symbol(f"[{pattern}]", str(pattern), pattern.measure)
    for left, right in equations:
        changed = (put_for(left, pattern, value) if step.both else left, put_for(right, pattern, value))
        after.append(changed)
        for old, new in zip((left, right), changed, strict=True):
            goals.append(("after and before", old, new))
            held.append((old, put_for(old, pattern, stand_in) if new is not old else old, new))
    if as_rule:
        return tuple(after), state.decide(goals, state.environment(step.using, ((pattern, value),)))
    before_it = [("before", old, kept) for old, kept, _ in held]
    verdict = state.decide(before_it, state.environment(step.using, ((stand_in, pattern),)))
    if verdict.true:
        behind = [("after", kept, new) for _, kept, new in held]
        verdict = state.decide(behind, state.environment(step.using, ((stand_in, value),)))
    return tuple(after), verdict


def _substitute_solved(step: Substitute, state: State) -> StepResult:
    if not state.solved:
        raise ValueError("nothing has been solved for yet")
    equations = state.equations
    if state.ansatz is not None and equations == state.solved:
        equations = ((without_brackets(state.ansatz.unknown), without_brackets(state.ansatz.form)),)
    verdict: Verdict | None = None
    for rule in state.solved:
        if any(occurs(rule[0], side) for side in _worked_on(equations, step.both)):
            equations, decided = _put(state, equations, rule, step, as_rule=True)
            verdict = decided if verdict is None or verdict.true else verdict
    if verdict is None:
        raise ValueError("nothing that was solved for occurs")
    neat = tuple((left, tidied(right)) for left, right in equations)
    if verdict.true and neat != equations:
        verdict = state.decide(_unchanged(equations, neat), state.environment(step.using))
    return StepResult(neat, verdict, "what was found for " + ", ".join(str(left) for left, _ in state.solved))


def _expand(step: Expand, state: State) -> StepResult:
    after = tuple((_worked_out(left) if step.both else left, _worked_out(right)) for left, right in state.equations)
    return StepResult(after, state.decide(_unchanged(state.equations, after), state.environment()), "multiplied out")


def _worked_out(node: Node) -> Node:
    return multiplied_out(carried_out(without_brackets(node)))


def _unchanged(equations: Sequence[Equation], after: Sequence[Equation]) -> list[tuple[str, Node, Node]]:
    pairs = zip(chain(*equations), chain(*after), strict=True)
    return [("after and before", old, new) for old, new in pairs]


def _factor(step: Factor, state: State) -> StepResult:
    problem = state.environment(step.using)
    terms = tuple(map(without_brackets, step.terms))
    after = tuple((left, state.combination(right, terms, problem)) for left, right in state.equations)
    zero = all(str(right) == "0" for _, right in after)
    alone = "nothing is left" if zero else "a function of angles"
    said = f"in {', '.join(map(str, step.terms))}" if step.terms else alone
    by = ", ".join(map(state.cited, step.using))
    return StepResult(
        after, state.decide(_unchanged(state.equations, after), problem), f"{said}, by {by}" if by else said
    )


def _factor_out(step: FactorOut, state: State) -> StepResult:
    after, goals = [], []
    for left, right in state.equations:
        matrix = before(without_brackets(step.factor), right)
        whole = Contract((matrix, step.factor))
        goals.append(("the product is what it was", whole, right))
        after.append((left, whole) if step.named is None else (step.named, matrix))
    said = f"{step.factor} taken out" + (f"; what multiplies it is {step.named}" if step.named is not None else "")
    return StepResult(tuple(after), state.decide(goals, state.environment()), said)


def _ansatz(step: Ansatz, state: State) -> StepResult:
    unknown, form = without_brackets(step.unknown), without_brackets(step.form)
    if isinstance(unknown, Inverse):
        equations: tuple[Equation, ...] = ((Contract((unknown.of, form)), Identity(form.shape[0])),)
    elif step.such_that is not None:
        left, right = (without_brackets(side) for side in step.such_that)
        equations = ((replace(left, {unknown: form}), replace(right, {unknown: form})),)
    else:
        raise ValueError(f"say what {step.unknown} is asked to satisfy")
    return StepResult(equations, Posed({}), f"{step.unknown} is sought as {step.form}")


def _solve(step: Solve, state: State) -> StepResult:
    said = ", ".join(map(str, step.unknowns))
    if step.by is not None:
        equation, verdict = solve_by_multiplying(state, step.unknowns[0], step.by, step.using)
        return StepResult((equation,), verdict, f"for {said}, multiplied by {state.cited(step.by)}")
    if step.terms or len(step.unknowns) > 1 or state.ansatz is not None or not _moves(step.unknowns[0], state):
        equations, verdict = solve_linear_system(state, step.unknowns, step.terms, step.using)
        return StepResult(equations, verdict, f"for {said}: a linear system, with one solution")
    equation, verdict = solve_by_moving(state, step.unknowns[0], step.using)
    return StepResult((equation,), verdict, f"for {said}")


def _moves(unknown: Node, state: State) -> bool:
    try:
        alone(unknown, *state.equations[0])
    except CannotIsolate:
        return not unknown.is_scalar
    return True


def _differentiate(step: Differentiate, state: State) -> StepResult:
    after = tuple((_rate(left), _rate(right)) for left, right in state.equations)
    goals = [("the rate", Rate(old), new) for old, new in zip(chain(*state.equations), chain(*after), strict=True)]
    return StepResult(after, state.decide(goals, state.environment()), "both sides, with respect to time")


def _rate(node: Node) -> Node:
    return multiplied_out(rate_of(carried_out(node)))


def _multiply(step: Multiply, state: State) -> StepResult:
    factor = without_brackets(step.factor)

    def times(side: Node) -> Node:
        if factor.is_scalar:
            return Scale(factor, side)
        return chained((side, factor) if step.right else (factor, side))

    after = tuple((times(left), times(right)) for left, right in state.equations)
    pairs = zip(map(_difference, state.equations), map(_difference, after), strict=True)
    goals = [("the difference, multiplied", new, times(old)) for old, new in pairs]
    side = "right" if step.right else "left"
    return StepResult(after, state.decide(goals, state.environment()), f"by {step.factor}, from the {side}")


def _take_vector(step: TakeVector, state: State) -> StepResult:
    after = tuple((Vect(left), Vect(right)) for left, right in state.equations)
    pairs = zip(map(_difference, state.equations), map(_difference, after), strict=True)
    goals = [("the difference's vector", new, Vect(old)) for old, new in pairs]
    return StepResult(after, state.decide(goals, state.environment()), "both sides")


def _difference(equation: Equation) -> Node:
    return Sum((equation[0], Negative(equation[1])))
