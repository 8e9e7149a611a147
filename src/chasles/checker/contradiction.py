"""Does a certificate prove that nothing satisfies what is assumed? Asked of the checker, which searches for nothing."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from typing import Any

from chasles.checker.quantities import squeezed
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import ONE, Polynomial, Rejected, exponents, parsed, powered, product, variable, well_formed
from chasles.statements import Problem


def check_contradiction(problem: Problem, hypotheses: Collection[str], certificate: Mapping[str, Any]) -> None:
    """Nothing satisfies these hypotheses of the problem: raises `Rejected` if the certificate does not prove it.

    What does not vanish is a combination of what does; or it is positive, and up to such a combination not above zero.
    """
    with well_formed("certificate"):
        known = tuple(hypothesis for hypothesis in problem.hypotheses if hypothesis.text in hypotheses)
        if {hypothesis.text for hypothesis in known} != {*hypotheses}:
            raise Rejected("what is said to contradict itself is not assumed")
        reading = PolynomialProblem(Problem((), problem.rules, (), (), known), certificate["variables"])
        total, is_positive = ONE, True
        for label, power in certificate["nonvanishing"].items():
            place = reading.places[squeezed(label)]
            total *= product([reading.nonzero[place]], next(iter(powered(0, power).terms)))
            is_positive &= power % 2 == 0 or place in reading.greater
        for label, cofactor in certificate["contradiction"].items():
            total -= parsed(cofactor, reading.places) * reading.vanishing[label]
        if total and not (is_positive and _is_nonnegative(reading, -total)):
            raise Rejected("the certificate shows no contradiction")


def _is_nonnegative(reading: PolynomialProblem, polynomial: Polynomial) -> bool:
    """Whether every term is a positive number times squares, norms and what is declared positive."""
    free = {place for place, what in enumerate(reading.variables) if what[0] == "norm"}
    free |= {place for factor in reading.greater.values() for place in factor.places if not factor - variable(place)}
    return all(
        coefficient * polynomial.below > 0
        and all(power % 2 == 0 or place in free for place, power in exponents(monomial))
        for monomial, coefficient in polynomial.terms.items()
    )
