"""A problem said in simpler words: without defined words, inverses and partial derivatives, and by simple lengths.

Divisors need nothing that are positive wherever they are real; of others it is said that they are not zero.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace as with_fields

from chasles import vocabulary as w
from chasles.statements.conditions import ASSUMED, as_rules
from chasles.statements.hypotheses import Hypothesis
from chasles.statements.inverses import Inverses, reached
from chasles.statements.lengths import Lengths
from chasles.statements.problem import Problem
from chasles.statements.varied import opened_parts
from chasles.vocabulary import Integral, Node, Rate, Scale, Symbol, walk
from chasles.vocabulary.shorthand import opened
from chasles.vocabulary.sizes import sizes_of


def needed_of_divisors(
    sides: Iterable[Node], hypotheses: tuple[Hypothesis, ...], rules: Mapping[Node, Node]
) -> Iterator[Hypothesis]:
    """That divisors are not zero which nothing declares so: an equation is about where its sides have values.

    What is seen not to be zero is "evident", no condition of a verdict; a `free` need may follow from declared ones.
    """
    whole = {node: h for h in hypotheses for node in h.nonvanishing}
    declared = {factor: h for node, h in whole.items() for factor in factors_of(node)} | whole
    for divisor in dict.fromkeys(
        factor for side in sides for each in _divisors(side, rules) for factor in factors_of(each)
    ):
        said = [declared[each] for each in (divisor, *_lengths(divisor)) if each in declared]
        if not said:
            from chasles.statements.bounds import seen_not_to_vanish  # few claims divide by what nothing declares

            said = [seen_not_to_vanish(divisor, rules)]
        if divisor not in whole:
            yield with_fields(said[0], subjects=(divisor,), nonvanishing=(divisor,))


def _divisors(side: Node, rules: Mapping[Node, Node]) -> Iterator[Node]:
    """What an expression divides by, and the lengths whose rates it takes, but for those of squares of lengths."""
    parts = opened_parts(side)
    rated = {each: None for part in parts if isinstance(part, w.Rate) for each in opened_parts(part.of)}
    while more := [each for part in rated if part in rules for each in opened_parts(rules[part]) if each not in rated]:
        rated |= dict.fromkeys(more)
    squared = {part.base for part in rated if isinstance(part, w.Power) and part.exponent in (2, 4)}
    yield from (part.denominator for part in parts if isinstance(part, w.Quotient))
    yield from (part for part in rated if isinstance(part, w.Norm) and part not in squared)


def factors_of(divisor: Node) -> Iterator[Node]:
    """The factors on which it depends whether a divisor vanishes, or a matrix has an inverse; a number is none."""
    match divisor:
        case w.Group(of) | w.Negative(of) | w.Power(of) | w.Quotient(of) | w.Transpose(of) | w.Inverse(of):
            yield from factors_of(of)
        case w.Contract(factors) if all(factor.shape == divisor.shape for factor in factors):
            yield from (each for part in factors for each in factors_of(part))
        case w.Scale(factor, term) | w.Dot(factor, term) if factor.is_scalar:
            yield from (each for part in (factor, term) for each in factors_of(part))
        case _ if not isinstance(divisor, w.Number):
            yield divisor


def _lengths(node: Node) -> tuple[Node, ...]:
    """The length of a vector, its square, and how else it is written: where one is not zero, none is."""
    match node:
        case w.Norm((of) as other) | w.Dot(of, other) | w.Contract((w.Transpose(of), other)) if of == other:
            return w.Norm(of), w.Dot(of, of), w.Contract((w.Transpose(of), of)), w.Power(w.Norm(of), 2)
    return ()


def in_simpler_words(problem: Problem) -> Problem:
    """The same problem without defined words and inverses, under the hypotheses that there are such inverses."""
    problem = _differentiated(problem).said_otherwise(opened, lambda said: said.rewritten(opened))
    inverses = Inverses(problem.hypotheses, dict(problem.rules), any_size=bool(sizes_of(problem.sides_and_rules)))
    found = problem.said_otherwise(inverses, inverses.hypothesis, reached(problem.sides, dict(problem.rules)))
    presupposed = tuple(dict.fromkeys((*problem.presupposed, *inverses.used)))
    return with_fields(found, hypotheses=(*inverses.needed, *found.hypotheses), presupposed=presupposed)


def with_what_is_seen(problem: Problem) -> Problem:
    """The same problem, with what is seen about divisors, and about all that sums are taken over."""
    if problem.has_functions:
        return problem
    told = (side for h in problem.hypotheses if h.kind in (*ASSUMED, "posed") for side in h.sides)
    sides = (*problem.sides, *(side for _, side in problem.rules), *told)
    found = (*needed_of_divisors(sides, problem.hypotheses, dict(problem.rules)), *_summed(sides, problem.hypotheses))
    return with_fields(problem, hypotheses=(*problem.hypotheses, *found)) if found else problem


def with_rates_said(problem: Problem) -> Problem:
    """The same problem, if it is about matrices of any size, with letters for the rates of symbols."""
    sides = problem.sides_and_rules
    if not any(isinstance(part, Rate) for side in sides for part in walk(side)) or not sizes_of(sides):
        return problem
    from chasles.statements.sized_rates import SizedRates  # few chapters have such

    problem = _differentiated(_without_conditions(problem, "a rate of a matrix of any size"))
    carried_out = SizedRates({left: opened(right) for left, right in problem.rules})
    found = problem.said_otherwise(lambda side: carried_out(opened(side)), lambda said: said)
    return with_fields(
        found,
        rules=tuple((carried_out(left) if isinstance(left, Rate) else left, right) for left, right in found.rules),
        hypotheses=tuple(carried_out.bound(found.hypotheses)),
    )


def _differentiated(problem: Problem) -> Problem:
    """The same problem with partial derivatives carried out; TypeError where conditions do not say what symbols are."""
    if not problem.has_functions or not _takes_derivatives(problem):
        return problem
    from chasles.statements.field_equations import carried_out  # of no use to most claims

    return carried_out(_without_conditions(problem, "a derivative"))


def _takes_derivatives(problem: Problem) -> bool:
    from chasles.vocabulary.partial import differentiates  # of no use to most claims

    return any(map(differentiates, (*problem.sides_and_rules, *problem.assumed_sides)))


def _without_conditions(problem: Problem, taken: str) -> Problem:
    """The same problem with a definition for each condition, which may be differentiated.

    Raises TypeError where conditions are none, or where a partial derivative depends on which symbol one defines.
    """
    if not problem.conditions:
        return problem
    bound = {part for side in problem.assumed_sides for part in opened_parts(side)}
    bound |= {subject for hypothesis in problem.hypotheses for subject in hypothesis.subjects}
    found = as_rules(problem.conditions, problem.unknowns, problem.rules, bound)
    open_choice = len(problem.unknowns) > len(problem.conditions) and _takes_derivatives(problem)
    if found is None or open_choice:
        raise TypeError(
            f"{taken} is taken: what a statement with one is given has to be definitions, "
            "or conditions that are posed on one symbol each, which stands alone in it"
        )
    return with_fields(problem, rules=found, conditions=(), unknowns=())


def with_simple_lengths(problem: Problem) -> Problem:
    """The same problem with every length said of as simple a vector as is known."""
    lengths = Lengths(problem.hypotheses, dict(problem.rules))
    found = problem.said_otherwise(lengths, lengths.hypothesis)
    return with_fields(found, presupposed=tuple(dict.fromkeys((*problem.presupposed, *lengths.used))))


def _summed(sides: Iterable[Node], hypotheses: tuple[Hypothesis, ...]) -> Iterator[Hypothesis]:
    """The sums of both sides of each equation that is assumed of what differs, also weighted by what differs."""
    integrals = [part for side in sides for part in opened_parts(side) if isinstance(part, Integral)]
    if not integrals:
        return
    first = integrals[0]
    weights = [
        part for part in dict.fromkeys(part for each in integrals for part in opened_parts(each.of))
        if isinstance(part, Symbol) and part.is_scalar and part in first.running
    ]  # fmt: skip
    for hypothesis in hypotheses:
        about = {part for side in hypothesis.sides for part in opened_parts(side)}
        if not about & first.running:
            continue
        pairs = [*hypothesis.equations]
        pairs += [(Scale(weight, one), Scale(weight, other)) for weight in weights for one, other in pairs]
        sums = tuple(tuple(with_fields(first, of=side) for side in pair) for pair in pairs)
        equations = tuple((one, other) for one, other in sums)
        text = f"{hypothesis.text} for each"
        kind = "condition" if hypothesis.kind == "condition" else "of all members"
        yield Hypothesis(kind, sum(sums, ()), equations, (), hypothesis.latex, text, free=True)
