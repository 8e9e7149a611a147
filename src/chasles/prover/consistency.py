"""Whether hypotheses can hold together: a point that satisfies them, or a proof that there is none.

What is assumed contradicts itself if something that does not vanish is a combination of what does (Nullstellensatz),
or if something positive is, up to such a combination, minus a sum of squares (Positivstellensatz): Bochnak, Coste and
Roy, Real algebraic geometry, Chapter 4. Only combinations that a Groebner basis shows, and sums of squares of single
terms, are found.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction
from itertools import chain, islice
from typing import Any

from chasles.algebra.groebner import Basis, Combination, completed
from chasles.algebra.rings import Polynomial, written
from chasles.algebra.work_limit import OutOfTime, remaining, within
from chasles.points import sampling as points
from chasles.points.evaluation import Point
from chasles.problems.context import Context, Vanishing, build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.relevance import free_symbols
from chasles.problems.variables import Untreatable
from chasles.statements import Goal, Hypothesis, Problem
from chasles.verdict import Contradictory
from chasles.vocabulary import Negative, Sum, Symbol

SAMPLES = 40
"""So many sample points are looked at for one at which all that is assumed holds."""
WORK = 2e6
"""The work that a proof of a contradiction may take, in products of terms."""
Proof = tuple[Combination, tuple[int, ...], Polynomial]
"""Cofactors, powers of nonzero factors, and the product of these less the combination: it is never positive."""


def holds_somewhere(context: Context) -> bool:
    """Whether a point is found at which those hypotheses hold that bear on nothing that occurs in what is decided."""
    rest = _idle(context)
    subjects = [subject for hypothesis in rest for subject in hypothesis.subjects]
    each_of_its_own = len({*subjects}) == len(subjects) and all(isinstance(s, Symbol) for s in subjects)
    return (each_of_its_own and not context.problem.rules) or point_of_the_rest(context) is not None


def point_of_the_rest(context: Context) -> Point | None:
    """A point at which the hypotheses hold that bear on nothing that occurs; None if none is found."""
    rest = _idle(context)
    try:
        alone = build(_alone(context.problem, rest))
    except (UndeclaredDivisor, Untreatable):
        return None
    drawn = chain(points.plain(alone, {}, SAMPLES), islice(points.sample(alone, {}), SAMPLES))
    return next(drawn, None) if rest else {}


def _idle(context: Context) -> tuple[Hypothesis, ...]:
    """The hypotheses on symbols none of which occurs in what is decided."""
    occurring = {variable.symbol for variable in context.variables}
    rules = dict(context.problem.rules)
    rest = (h for h in context.problem.hypotheses if h not in context.active)
    return tuple(h for h in rest if not any(occurring & free_symbols(s, rules) for s in h.subjects))


def _alone(problem: Problem, hypotheses: tuple[Hypothesis, ...]) -> Problem:
    """The problem of the hypotheses alone; those on what a rule replaces are said of what replaces it.

    Of a definite matrix it is then used that it is symmetric and that its determinant is positive.
    """
    ruled = {left for left, _ in problem.rules}
    said = []
    for each in hypotheses:
        differences = tuple(Sum((left, Negative(right))) for left, right in each.equations)
        of_rules = bool(each.equations) and not ruled.isdisjoint(each.subjects)
        if of_rules and each.kind == "definite":
            said.append(replace(each, kind="positive", subjects=each.nonvanishing))
        else:
            said.append(replace(each, kind="given", subjects=differences) if of_rules else each)
    goals = tuple(Goal(h.text, subject, subject) for h in said for subject in h.subjects)
    return Problem(goals, problem.rules, (), (), tuple(said))


def contradiction(problem: Problem, cases: tuple[Goal, ...] = ()) -> Contradictory | None:
    """The verdict that nothing satisfies all that is assumed, and the cases, if that is found; with as little as does.

    A condition, or a case, has its label as its name; the verdict then has no certificate.
    """
    equations = tuple(
        Hypothesis("given", (Sum((g.left, Negative(g.right))),), ((g.left, g.right),), (), "", g.label)
        for g in (*problem.conditions, *cases)
    )
    core: tuple[Hypothesis, ...] = (*problem.hypotheses, *equations)
    found = _contradicting(problem, core)
    if found is None:
        return None
    certificate = found[1]
    core = found[0]
    for hypothesis in core:
        fewer = tuple(h for h in core if h != hypothesis)
        found = _contradicting(problem, fewer) if hypothesis in core and fewer else None
        if found is not None:
            core, certificate = found
    certified = certificate if not {*core} & {*equations} else None
    return Contradictory(tuple(h.text for h in core), certified)


def _contradicting(
    problem: Problem, hypotheses: tuple[Hypothesis, ...]
) -> tuple[tuple[Hypothesis, ...], dict[str, Any]] | None:
    """Those of the hypotheses that contradict each other, and why; None if that is not found."""
    try:
        with within(WORK):
            context = build(_alone(problem, hypotheses))
            proof = _proof(context)
    except Vanishing as vanishing:
        hypothesis = vanishing.hypothesis
        nothing = {"contradiction": {}, "nonvanishing": {f"1. {hypothesis.text}": 1}, "variables": []}
        return (hypothesis,), nothing
    except (UndeclaredDivisor, Untreatable):
        return None
    except OutOfTime:
        if remaining() <= 0:
            raise
        return None
    if proof is None:
        return None
    cofactors, powers, rest = proof
    used = {context.generators[k].hypothesis for k in cofactors}
    used |= {h for (h, _), power in zip(context.nonzero, powers, strict=False) if power}
    degrees = context.field.ring.degrees(rest) if rest != 0 else ()
    used |= {h for k, h in _greater(context).items() if k < len(degrees) and degrees[k]}
    names = {h.text for h in used if h is not None}
    core = tuple(h for h in hypotheses if h.text in names)
    if not core:
        return None
    ring = context.field.ring
    divisors = [h.text for h in core for _ in h.nonvanishing]
    nonzero = (
        (h.text, power) for (h, _), power in zip(context.nonzero, powers, strict=False) if h is not None and power
    )
    return core, {
        "contradiction": {context.generators[k].label: written(ring, c) for k, c in sorted(cofactors.items())},
        "nonvanishing": {f"{divisors.index(text) + 1}. {text}": power for text, power in nonzero},
        "variables": list(ring.names),
    }


def _proof(context: Context) -> Proof | None:
    """A combination of what vanishes that cannot vanish, if one is found."""
    ring = context.field.ring
    positive = [h is not None and _is_positive(context, h) for h, _ in context.nonzero]
    basis = completed(context.basis)
    for powers in _powers(positive):
        product = context.field.power_product(powers)
        cofactors, rest = basis.reduce(product)
        is_positive = all(power % 2 == 0 or positive[k] for k, power in enumerate(powers))
        if rest == 0 or (is_positive and _one_sign(context, ring.terms(rest)) == -1):
            return cofactors, powers, rest
    return _square_sum(context, basis)


def _powers(positive: list[bool]) -> Iterator[tuple[int, ...]]:
    """None of the nonzero factors, each of them, all of them, and their squares."""
    size = len(positive)
    yield (0,) * size
    for power in (1, 2):
        yield from (tuple(power * (k == j) for j in range(size)) for k in range(size))
        if size > 1:
            yield (power,) * size


def _square_sum(context: Context, basis: Basis) -> Proof | None:
    """A product of squares of what does not vanish, or one, and a sum of squares, among what vanishes."""
    ring = context.field.ring
    places = {
        k: j for k, v in enumerate(ring.generators) for j, (_, factor) in enumerate(context.nonzero) if factor == v
    }
    for rest, parts in basis.remainders():
        terms = ring.terms(rest)
        for exponents, coefficient in terms if _one_sign(context, terms) else ():
            scale = ring.constant(1 / coefficient)
            if {k for k, power in enumerate(exponents) if power} <= {*places}:
                powers = [0] * len(context.nonzero)
                for k, j in places.items():
                    powers[j] = exponents[k]
                total = {k: cofactor * scale for k, cofactor in parts.items() if cofactor != 0}
                return total, tuple(powers), context.field.power_product(tuple(powers)) - rest * scale
    return None


def _one_sign(context: Context, terms: list[tuple[tuple[int, ...], Fraction]]) -> int:
    """The sign of all terms, numbers times squares, norms and what is declared positive; 0 if they have no such."""
    signs = {1 if coefficient > 0 else -1 for _, coefficient in terms}
    free = {k for k, v in enumerate(context.variables) if v.kind == "norm"} | _greater(context).keys()
    squares = (power % 2 == 0 or k in free for exponents, _ in terms for k, power in enumerate(exponents))
    return signs.pop() if len(signs) == 1 and all(squares) else 0


def _greater(context: Context) -> dict[int, Hypothesis]:
    """The variables that are declared positive."""
    variables = context.field.ring.generators
    positive = [(h, factor) for h, factor in context.nonzero if h is not None and _is_positive(context, h)]
    return {k: h for k, variable in enumerate(variables) for h, factor in positive if factor == variable}


def _is_positive(context: Context, hypothesis: Hypothesis) -> bool:
    """Whether what a hypothesis declares positive is a factor itself, not only the numerator of a fraction."""
    return hypothesis.kind in ("positive", "definite") and not any(
        any(entry.denominator) for row in context.unfold(hypothesis.subjects[0]) for entry in row
    )
