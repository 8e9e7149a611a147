"""Side conditions that contradict each other: a combination of them vanishes that cannot.

That what does not vanish has an inverse is an equation too (J. L. Rabinowitsch, Math. Ann. 102, 1930). What cannot
vanish is a number, what the signs of symbols and squares make positive, and what would leave to a symbol no value that
it may have.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import chain

import sympy

from chasles.algebra.groebner import Basis, Combination, completed
from chasles.algebra.rings import Polynomial, written
from chasles.algebra.work_limit import OutOfTime, remaining, within
from chasles.checker.expressions.quantities import is_atom
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.opening import Signed
from chasles.from_sympy.positivity import definite_by
from chasles.from_sympy.question import Question
from chasles.problems.context import Context, build
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.statements import Hypothesis, Problem
from chasles.verdict import Contradictory
from chasles.vocabulary import Node, Number, Scale, Symbol, scalar

EFFORT = 1e6
"""The work that a set of conditions may take, in products of terms."""
LARGEST_DEGREE = 6
Assumptions = Mapping[str, bool]


@dataclass(frozen=True, slots=True)
class _Found:
    """A combination that cannot vanish, the hypotheses that it is made of, and what is assumed of symbols in it."""

    polynomial: str
    cofactors: Mapping[str, str]
    used: frozenset[Hypothesis]
    assumed: tuple[str, ...]


def contradiction(question: Question, effort: float = EFFORT) -> Contradictory | None:
    """A smallest set of side conditions that nothing satisfies; None if none is found.

    Without effort only what is seen without completing the equations to a Groebner basis is found.
    """
    stated = (h for h in question.problem.hypotheses if h not in question.of_rates)
    conditions = [h for h in stated if h.equations or h.nonvanishing]
    found = _impossible(question, conditions, effort)
    if found is None:
        return None
    kept = [h for h in conditions if h in found.used]
    for texts in list(dict.fromkeys(question.said_of(h) for h in kept)):
        fewer = [h for h in kept if question.said_of(h) != texts]
        again = _impossible(question, fewer) if len(fewer) < len(kept) else None
        if again is not None:
            found, kept = again, [h for h in fewer if h in again.used]
    own = [h for h in kept if h.text not in question.hidden]
    said = dict.fromkeys(text for h in own for text in question.said_of(h))
    certificate = {"vanishes": found.polynomial, "cofactors": dict(found.cofactors)}
    return Contradictory((*said, *found.assumed), certificate) if said else None


def _impossible(question: Question, conditions: Sequence[Hypothesis], effort: float = EFFORT) -> _Found | None:
    try:
        with within(min(EFFORT, remaining() / 4)):
            return _searched(question, conditions, effort) if conditions else None
    except (OutOfTime, Untreatable, UndeclaredDivisor):
        return None


def _searched(question: Question, conditions: Sequence[Hypothesis], effort: float) -> _Found | None:
    divisors = [(h, node) for h in conditions for node in h.nonvanishing]
    inverses = {h: scalar(f"inverse_{k + 1}", f"d_{k + 1}", "", constant=True) for k, (h, _) in enumerate(divisors)}
    turned = [_inverted(h, node, inverses[h]) for h, node in divisors]
    problem = question.problem
    context = build(Problem((), problem.rules, (), problem.unknowns, (*conditions, *turned)))
    basis = completed(context.basis, effort) if effort else context.basis
    assumed = _assumed(question, context)
    for polynomial, origin in chain(zip(basis.generators, basis.origins, strict=True), basis.remainders()):
        names = _forbidden(context, polynomial, assumed)
        if names is not None:
            return _told(
                context, basis, polynomial, origin, names, dict(zip(turned, (h for h, _ in divisors), strict=True))
            )
    return None


def _inverted(hypothesis: Hypothesis, node: Node, inverse: Symbol) -> Hypothesis:
    sides = Scale(inverse, node), Number(Fraction(1))
    return Hypothesis("equation", sides, (sides,), (), "", f"1/({hypothesis.text})", free=True)


def _told(
    context: Context,
    basis: Basis,
    polynomial: Polynomial,
    origin: Combination,
    names: Iterable[str],
    originals: Mapping[Hypothesis, Hypothesis],
) -> _Found:
    own = [context.generators[k] for k in origin]
    used = frozenset(originals.get(g.hypothesis, g.hypothesis) for g in own if g.hypothesis is not None)
    cofactors = {context.generators[k].label: written(basis.ring, c) for k, c in origin.items()}
    return _Found(written(basis.ring, polynomial), cofactors, used, tuple(names))


def _assumed(question: Question, context: Context) -> dict[int, tuple[str, Assumptions]]:
    """By its place what is known of a variable, and how it is called; numbers and roots have no name."""
    found: dict[int, tuple[str, Assumptions]] = {}
    roots = {h.subjects[0] for h in question.problem.hypotheses if h.kind == "root"}
    for place, variable in enumerate(context.variables):
        symbol = variable.symbol if variable.kind == "entry" else None
        atom = None if symbol is None else question.origins.get(symbol)
        if variable.symbol in roots and atom is not None:
            found[place] = "", {"nonnegative": True}
        elif atom is not None and not isinstance(atom, Signed):  # positive only where the question is meant
            found[place] = (str(atom) if is_atom(atom) else ""), assumed_of(atom)
    return found


def _signs(assumed: Mapping[int, tuple[str, Assumptions]]) -> dict[int, tuple[int, bool]]:
    signed = {k: known for k, (_, known) in assumed.items() if known.get("nonnegative") or known.get("nonpositive")}
    return {k: (1 if known.get("nonnegative") else -1, bool(known.get("nonzero"))) for k, known in signed.items()}


def known_signs(question: Question, context: Context) -> dict[int, tuple[int, bool]]:
    """By the places of variables whose sign is known, that, and whether they cannot vanish."""
    return _signs(_assumed(question, context))


def _forbidden(
    context: Context, polynomial: Polynomial, assumed: Mapping[int, tuple[str, Assumptions]]
) -> list[str] | None:
    """What is assumed of the symbols by which the polynomial cannot vanish; None if it can."""
    ring = context.field.ring
    by_sign = definite_by(ring, polynomial, _signs(assumed))
    if by_sign is not None:
        return [_said(*assumed[place]) for place in by_sign if assumed[place][0]]
    places = [k for k, degree in enumerate(ring.degrees(polynomial)) if degree]
    if len(places) != 1 or ring.degrees(polynomial)[places[0]] > LARGEST_DEGREE:
        return None
    (place,) = places
    name, known = assumed.get(place, ("", {}))
    coefficients = {exponents[place]: c for exponents, c in ring.terms(polynomial)}
    z = sympy.Dummy()
    terms = [sympy.Rational(c.numerator, c.denominator) * z**e for e, c in coefficients.items()]
    roots = sympy.real_roots(sympy.Add(*terms), z)
    if any(all(getattr(root, f"is_{key}") in (None, is_so) for key, is_so in known.items()) for root in roots):
        return None
    return [_said(name, known)] if roots and name else []


def _said(name: str, known: Assumptions) -> str:
    """What is assumed of a symbol, in a few words: what follows from something else that is assumed is left out."""
    rest = dict(known)
    for key in ("zero", "prime", "composite", "even", "odd", "integer", "positive", "negative", "rational"):
        if rest.get(key):
            return f"{name} is {key}"
    word = next(key for key, is_so in rest.items() if is_so) if any(rest.values()) else f"not {next(iter(rest))}"
    return f"{name} is {word}"
