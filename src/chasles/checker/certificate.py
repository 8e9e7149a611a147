"""Is a certificate right? The checker imports nothing of the prover, and it searches for nothing.

It reads the problem from the declaration. A certificate says by what to divide, and supplies cofactors where division
alone does not do, the values of what conditions determine, and a witness: each is tried, and nothing else is believed.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from chasles.checker.division import Division, divided, solved_for
from chasles.checker.quantities import squeezed
from chasles.checker.reading import PolynomialProblem
from chasles.checker.sparse import ONE, ZERO, Polynomial, Rejected, cleared, parsed, powered, variable, well_formed
from chasles.checker.witness import point_of, require
from chasles.statements import Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.conditions import freed
from chasles.statements.goals import AcceptedSides
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.posing import default_sides
from chasles.statements.premises import IN_FULL, with_all_premises
from chasles.statements.spins import with_spins


def check(
    said: Problem | Statement | Theorem | Inverse,
    form: str,
    certificate: Mapping[str, Any],
    accepted: AcceptedSides = default_sides,
) -> None:
    """Every entry of every equation holds wherever the hypotheses do, and somewhere they do: the certificate proves it.

    `accepted` gives the sides with which given statements are used; a problem needs neither form nor sides. Raises
    `Rejected` with the reason if the certificate does not prove the statement, and what `problem_of` raises.
    """
    if isinstance(said, Statement | Theorem) and isinstance(certificate, Mapping) and certificate.get(IN_FULL):
        said = with_all_premises(said, accepted)
    if isinstance(said, Inverse):
        problems = dict(problems_of_inverse(said, accepted))
    else:
        problems = {"": said if isinstance(said, Problem) else problem_of(said, form, accepted)}
    with well_formed("certificate"):
        for says, problem in problems.items():
            _check(problem, certificate["branches"][says] if isinstance(said, Inverse) else certificate)


def _check(problem: Problem, certificate: Mapping[str, Any]) -> None:
    if not problem.goals:
        raise Rejected("there is nothing to prove")
    if "scalars" in certificate:
        from chasles.checker.expressions.scalars import check_scalars  # loads SymPy

        check_scalars(problem, certificate)
        return
    if "words" in certificate:
        from chasles.checker.any_size.proof import check_words  # few chapters have letters for sizes

        check_words(problem, certificate)
        return
    problem = freed(problem) if certificate.get("freed") else problem
    problem = with_spins(problem) if certificate.get("spins") else problem
    if "squares" in certificate:
        from chasles.checker.inequalities.squares import ReadingOfSquares

        reading: PolynomialProblem = ReadingOfSquares(problem, certificate)
        problem = reading.problem
    else:
        reading = PolynomialProblem(problem, certificate["witness"])
    occurring = set().union(*(condition.places for condition in reading.conditions))
    divisions = [_division(reading, label, term) for label, term in certificate.get("division", ())]
    occurring = occurring.union(*(reading.vanishing[label].places for label, _ in certificate.get("division", ())))
    values: dict[int, Polynomial] = {}
    for name, said in certificate.get("solved", {}).items():
        place = reading.places[squeezed(name)]
        values[place] = parsed(said["numerator"], reading.places) * _over(reading, said)
        occurring |= _follows(reading, divisions, variable(place) - values[place], said, f"the value of {name}")
    reading.settle(values)
    for count, goal in enumerate(problem.goals):
        occurring = occurring.union(*(x.places for side in goal.sides for row in reading(side) for x in row))
        for i, j, difference in reading.difference(goal.left, goal.right):
            said = certificate.get("entries", {}).get(f"{count}:{i},{j}", {})
            what = f"entry {i + 1}, {j + 1} of equation {count + 1}"
            occurring |= _follows(reading, [] if said else divisions, difference, said, what)
    require(reading, point_of(reading, certificate["witness"]), occurring)


def _division(reading: PolynomialProblem, label: str, term: str) -> Division:
    """A term, given by its factors, of something that vanishes, and what it therefore equals."""
    if label not in reading.vanishing:
        raise Rejected(f"the certificate divides by {label!r}, which the statement does not assume")
    (factors,) = parsed(f"1*{term}", reading.places).terms
    if factors not in reading.vanishing[label].terms:
        raise Rejected(f"the certificate solves {label!r} for {term}, which does not occur in it")
    return solved_for(factors, reading.vanishing[label])


def _follows(
    reading: PolynomialProblem, divisions: list[Division], claim: Polynomial, said: Mapping[str, Any], what: str
) -> set[int]:
    """The variables in a claim that is, up to division, the combination said; raises `Rejected` for any other."""
    occurring, total = claim.places, ZERO
    for label, cofactor in said.get("cofactors", {}).items():
        if label not in reading.vanishing:
            raise Rejected(f"{what} is said to follow from {label!r}, which the statement does not assume")
        occurring |= reading.vanishing[label].places
        total += parsed(cofactor, reading.places) * reading.vanishing[label]
    if divided(cleared(claim - total * _over(reading, said), reading.nonzero)[0], divisions):
        raise Rejected(f"{what} does not follow")
    return occurring


def _over(reading: PolynomialProblem, said: Mapping[str, Any]) -> Polynomial:
    """One over a product of powers of nonzero factors."""
    total = ONE
    for label, power in said.get("denominator", {}).items():
        place = reading.places.get(squeezed(label), len(reading.nonzero))
        if place >= len(reading.nonzero):
            raise Rejected(f"the certificate divides by {label!r}, which is not declared nonzero")
        total *= powered(place, power)
    return total
