"""Is a certificate right? The checker shares no code with the prover, and it searches for nothing.

It reads the problem from the declaration. A certificate supplies cofactors, the values of what conditions determine,
and a witness: each is tried, and nothing else is believed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from fractions import Fraction
from math import lcm, prod
from typing import Any

from chasles.proof.recheck.quantities import squeezed
from chasles.proof.recheck.reading import Reading
from chasles.proof.recheck.sparse import ZERO, Polynomial, Rejected, exponents, variable
from chasles.statements import Inverse, Problem, Statement, Theorem, problem_of
from chasles.statements.inversion import problems_of_inverse
from chasles.statements.problem import default_form
from chasles.statements.spins import with_spins
from chasles.vocabulary import PI

__all__ = ["QUARTERS", "Point", "Rejected", "check", "point_of", "require", "value_at"]

QUARTERS = tuple((Fraction(cosine), Fraction(sine)) for cosine, sine in ((1, 0), (0, 1), (-1, 0), (0, -1)))
"""Cosine and sine of none, one, two and three quarter turns."""
Point = dict[int, tuple[Any, int]]
"""For each variable a number, rational or a sum of square roots, and the power, 0 or 1, of the one transcendental
number by which it is multiplied."""


def check(
    said: Problem | Statement | Theorem | Inverse,
    form: str,
    certificate: Mapping[str, Any],
    standing: Callable[[Statement], str] = default_form,
    number: Callable[[str], Any] = Fraction,
) -> None:
    """Every entry of every equation holds wherever the hypotheses do, and somewhere they do: the certificate proves it.

    `standing` says in which form each given statement is used; a problem needs neither form nor standing. A coordinate
    of the witness is read by `number`. Raises `Rejected` with the reason if the certificate does not prove the
    statement, and what `problem_of` raises.
    """
    if isinstance(said, Inverse):
        problems = dict(problems_of_inverse(said, standing))
    else:
        problems = {"": said if isinstance(said, Problem) else problem_of(said, form, standing)}
    try:
        for says, problem in problems.items():
            _check(problem, certificate["branches"][says] if isinstance(said, Inverse) else certificate, number)
    except Rejected:
        raise
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError) as error:
        raise Rejected(f"the certificate is malformed: {type(error).__name__}: {error}") from error


def _check(problem: Problem, certificate: Mapping[str, Any], number: Callable[[str], Any]) -> None:
    if not problem.goals:
        raise Rejected("there is nothing to prove")
    problem = with_spins(problem) if certificate.get("spins") else problem
    reading = Reading(problem, certificate["witness"])
    occurring = set().union(*(condition.places for condition in reading.conditions))
    values: dict[int, Polynomial] = {}
    for name, said in certificate["solved"].items():
        place = reading.places[squeezed(name)]
        values[place] = _parsed(reading, said["numerator"]) * _over(reading, said["denominator"])
        occurring |= _follows(reading, variable(place) - values[place], said, f"the value of {name}")
    reading.settle(values)
    for count, goal in enumerate(problem.goals):
        occurring = occurring.union(
            *(x.places for side in (goal.left, goal.right) for row in reading(side) for x in row)
        )
        for i, j, difference in reading.difference(goal.left, goal.right):
            what = f"entry {i + 1}, {j + 1} of equation {count + 1}"
            if f"{count}:{i},{j}" not in certificate["entries"]:
                raise Rejected(f"the certificate says nothing of {what}")
            occurring |= _follows(reading, difference, certificate["entries"][f"{count}:{i},{j}"], what)
    require(reading, point_of(reading, certificate["witness"], number), occurring)


def _follows(reading: Reading, claim: Polynomial, said: Mapping[str, Any], what: str) -> set[int]:
    """The variables in a claim that is a sum of cofactors times what vanishes, over a product of atoms."""
    occurring, total = claim.places, ZERO
    for label, cofactor in said["cofactors"].items():
        if label not in reading.vanishing:
            raise Rejected(f"{what} is said to follow from {label!r}, which the statement does not assume")
        occurring |= reading.vanishing[label].places
        total += _parsed(reading, cofactor) * reading.vanishing[label]
    if reading.cleared(claim - total * _over(reading, said["denominator"]))[0]:
        raise Rejected(f"{what} does not follow with the cofactors given")
    return occurring


def _over(reading: Reading, denominator: Mapping[str, int]) -> Polynomial:
    """One over a product of powers of atoms."""
    powers = 0
    for label, power in denominator.items():
        place = reading.places.get(squeezed(label), len(reading.atoms))
        if place >= len(reading.atoms):
            raise Rejected(f"the certificate divides by {label!r}, which is not declared nonzero")
        powers += _power(power) << 8 * place
    return Polynomial({powers: 1})


def _parsed(reading: Reading, text: str) -> Polynomial:
    """A polynomial in the statement's variables, from text such as -1/2*e_1^2*cos(phi) + 3."""
    found: list[tuple[int, Fraction | int]] = []
    for term in text.split(" + "):
        coefficient, *factors = term.split("*")
        monomial = 0
        for factor in factors:
            name, _, power = (factor, "", "1") if factor in reading.places else factor.rpartition("^")
            if name not in reading.places:
                raise Rejected(f"the certificate has a factor {factor!r}, which is no power of a variable")
            monomial += _power(power) << 8 * reading.places[name]
        found.append((monomial, Fraction(coefficient) if "/" in coefficient else int(coefficient)))
    below = lcm(*(value.denominator for _, value in found))
    total: dict[int, int] = {}
    for monomial, value in found:
        total[monomial] = total.get(monomial, 0) + value.numerator * (below // value.denominator)
    return Polynomial({monomial: c for monomial, c in total.items() if c}, below)


def _power(text: str | int) -> int:
    if not 1 <= int(text) <= 127:
        raise Rejected(f"the certificate has {text!r} where an exponent from 1 to 127 is due")
    return int(text)


def point_of(reading: Reading, values: Mapping[str, Any], number: Callable[[str], Any] = Fraction) -> Point:
    """The point with these values; raises `Rejected` where they contradict what the variables mean.

    An angle that occurs beside its own cosine and sine is transcendental, because these are rational (Lindemann). With
    pi, or another such angle, in play it is given in units of pi: its cosine and sine must be those of quarter turns.
    """
    pi = {reading.places["pi"]} if "pi" in reading.places and "pi" in values else set()
    numbers: dict[int, Any] = dict.fromkeys(pi, Fraction(1))
    for name, value in values.items():
        place = reading.places.get(squeezed(name))
        if place is not None and numbers.setdefault(place, here := number(str(value))) != here:
            raise Rejected(f"{name} is given two values")
    angles = [(place, *what[1:]) for place, what in enumerate(reading.variables) if what[0] == "cos"]
    bare = pi | {reading.places[symbol.name] for _, symbol, _ in angles} & numbers.keys()
    for place, symbol, unit in angles:
        here = reading.places[symbol.name]
        if here in bare and (len(bare) > 1 or symbol == PI or not numbers[here]):
            quarters = 2 * unit * numbers[here]
            cosine, sine = QUARTERS[int(quarters) % 4]
            fits = numbers.get(place, cosine) == cosine and numbers.get(place + 1, sine) == sine
            if quarters.denominator != 1 or not fits:
                raise Rejected(f"cosine and sine of {symbol} are not those of the angle given")
    roots = {reading.places.get(str(h.subjects[0])) for h in reading.problem.hypotheses if h.kind == "root"}
    for place, value in numbers.items():
        if (place in roots or reading.variables[place][0] == "norm") and value < 0:
            raise Rejected("a norm, or a root, is given a negative value")
    return {place: (value, int(place in bare)) for place, value in numbers.items()}


def value_at(polynomial: Polynomial, point: Point) -> dict[int, Any]:
    """The value, by power of the transcendental number; empty if it is zero."""
    total: dict[int, Any] = {}
    for monomial, coefficient in polynomial.terms.items():
        powers = exponents(monomial)
        power = sum(point[place][1] * exponent for place, exponent in powers)
        value = prod((point[place][0] ** exponent for place, exponent in powers), start=Fraction(coefficient))
        total[power] = total.get(power, Fraction(0)) + value
    return {power: value / polynomial.below for power, value in total.items() if value}


def _standing_for(reading: Reading, occurring: set[int]) -> set[int]:
    """The variables that occur, and those by which they are what they are: a norm's vector, a cosine's sine."""
    inverses = {place for place in occurring if place < len(reading.atoms)}
    needed = occurring.union(*(reading.atoms[place].places for place in inverses)) - inverses
    for place in tuple(needed):
        match reading.variables[place]:
            case ("cos", *_):
                needed.add(place + 1)
            case ("sin", *_):
                needed.add(place - 1)
            case ("norm", of):
                needed |= reading.vanishing[f"norm |{of}|"].places
    return needed


def require(reading: Reading, point: Point, occurring: set[int]) -> None:
    """All that occurs has a value at the point; what vanishes does, no atom does, and what is positive is."""
    if lacking := _standing_for(reading, occurring) - point.keys():
        names = {place: name for name, place in reading.places.items()}
        raise Rejected(f"no value is given for {', '.join(names[place] for place in sorted(lacking))}")
    for label, polynomial in reading.vanishing.items():
        if polynomial.places <= point.keys() and value_at(polynomial, point):
            raise Rejected(f"the point does not satisfy {label}")
    for label, atom in zip(reading.places, reading.atoms, strict=False):
        if atom.places <= point.keys() and not value_at(atom, point):
            raise Rejected(f"the point does not satisfy {label}")
    for label, positive in reading.positive:
        if positive.places <= point.keys() and min(value_at(positive, point).values(), default=Fraction(0)) <= 0:
            raise Rejected(f"the point does not satisfy {label}")
