"""Points that satisfy every condition, and at which two sides are certainly different: their values enclosed.

What is refuted so needs no algebra of the functions that occur. An equation that is given is satisfied exactly: it, or
that of the squares of its sides, is linear or quadratic in one of its atoms, which is solved for, or it holds in
rational arithmetic.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from math import prod
from random import Random
from typing import Any

import sympy

from chasles.algebra.work_limit import afford, check
from chasles.checker.expressions.quantities import SIGNS
from chasles.checker.sparse import Rejected
from chasles.from_sympy.atoms import assumed_of
from chasles.from_sympy.enclosures import Enclosures
from chasles.from_sympy.opening import Entries, atoms_of, excerpt
from chasles.problems.variables import Untreatable
from chasles.verdict import Counterexample

FEW, MANY = (4, 16), (30, 300)
"""So many points are looked at, of so many that are drawn."""
TRIES = 20
SMALL = 40
TERM = 30
"""What a term of SymPy's counts as, in products."""


@dataclass(slots=True)
class Sampling:
    """Both sides, what is given to be equal and not to vanish, and the expressions that have to be defined.

    If the sides have more than `rows` rows, those below are imaginary parts. `still` says that no functions of time are
    given, so that every value at an instant is possible: else nothing is refuted.
    """

    left: Entries
    right: Entries
    rows: int
    given: Sequence[tuple[Any, Any]] = ()
    nonzero: Sequence[Any] = ()
    defined: Sequence[Any] = ()
    still: bool = True
    _dummies: dict[Any, Any] = field(default_factory=dict)

    def counterexample(self, few: bool = False) -> Counterexample | None:
        """A point at which an entry of the two sides differs; None if none was found."""
        sides = [[[self._named(entry) for entry in row] for row in side.rows] for side in (self.left, self.right)]
        for enclosures in self._points(*(FEW if few else MANY)) if self.still else ():
            for i, (one, other) in enumerate(zip(*sides, strict=True)):
                for j, (a, b) in enumerate(zip(one, other, strict=True)):
                    try:
                        if not enclosures(a).meets(enclosures(b)):
                            return self._told(enclosures, i % self.rows, j)
                    except Rejected:
                        continue
        return None

    def point(self) -> Mapping[str, Any] | None:
        """A point at which everything that occurs is defined, and all conditions hold: there both sides are equal."""
        fallback = None
        for free_first, equal in ((False, False), (True, False), (False, True)):
            for enclosures in self._points(*MANY, free_first, equal) if fallback is None else ():
                found = self._coordinates(enclosures)
                if all(isinstance(value, Fraction) for value in found.values()):
                    return found
                fallback = fallback or found
        return fallback

    def _points(
        self, enough: int, attempts: int, free_first: bool = False, equal: bool = False
    ) -> Iterator[Enclosures]:
        sides = [entry for side in self._entries for entry in side]
        given = [(self._named(one), self._named(other)) for one, other in self.given]
        nonzero = [self._named(e) for e in self.nonzero]
        expressions = [*(self._named(e) for e in (*sides, *self.defined)), *(side for pair in given for side in pair)]
        pairs = zip(*self._entries, strict=True) if equal else ()
        told = [(self._named(one), self._named(other)) for one, other in pairs]
        last = [dummy for atom, dummy in self._dummies.items() if free_first and assumed_of(atom)]
        solved = _Solved([*told, *given], last)
        for attempt in range(attempts):
            check()
            random = Random(attempt)
            atoms = sorted(self._dummies.items(), key=lambda known: str(known[0]))
            values = {dummy: _drawn(atom, random, attempt) for atom, dummy in atoms}
            if solved.quadratic:
                # Half of the others vanish where they may: roots are rational more often.
                free = [dummy for atom, dummy in atoms if dummy not in solved.quadratic and _agrees(atom, sympy.S.Zero)]
                values |= {dummy: sympy.S.Zero for dummy in free if random.random() < 0.5}
            enclosures = Enclosures({**values, **solved.roots(values), **solved.values})
            try:
                for expression in expressions:
                    enclosures(expression)
                good = solved.satisfied(enclosures) and all(map(enclosures.sign, nonzero))
                good = good and all(_may_be(atom, enclosures, dummy) for atom, dummy in self._dummies.items())
            except Rejected:
                continue
            if good:
                yield enclosures
                enough -= 1
            if not enough:
                return

    @property
    def _entries(self) -> tuple[list[Any], list[Any]]:
        left, right = ([entry for row in side.rows for entry in row] for side in (self.left, self.right))
        return left, right

    def _named(self, expression: Any) -> Any:
        """The expression with every atom a symbol of its own."""
        for part in atoms_of(expression):
            if part not in self._dummies:
                self._dummies[part] = sympy.Dummy(str(part))
        try:
            return expression.xreplace(self._dummies)
        except (TypeError, ValueError):
            raise Untreatable(f"{excerpt(expression)} is not treated: SymPy substitutes nothing in it") from None

    def _coordinates(self, enclosures: Enclosures) -> dict[str, Any]:
        """The exact values of the atoms."""
        found = {str(atom): exactly(self._exact(enclosures, dummy)) for atom, dummy in self._dummies.items()}
        return dict(sorted(found.items()))

    def _exact(self, enclosures: Enclosures, expression: Any) -> Any:
        return expression.xreplace(enclosures.point)

    def _told(self, enclosures: Enclosures, row: int, column: int) -> Counterexample:
        """The counterexample, both sides with their imaginary parts if they may have some."""
        texts = []
        for side in (self.left, self.right):
            rows = range(row, len(side.rows), self.rows)
            parts = [self._exact(enclosures, self._named(side.rows[k][column])) for k in rows]
            texts.append(str(parts[0] + sympy.I * parts[1] if len(parts) > 1 else parts[0]))
        return Counterexample(self._coordinates(enclosures), (row + 1, column + 1), texts[0], texts[1])


class _Solved:
    """The atoms that given equations determine, linear ones where the coefficient does not vanish; some atoms last."""

    def __init__(self, given: Sequence[tuple[Any, Any]], last: Sequence[Any]) -> None:
        self.values: dict[Any, Any] = {}
        self.slopes: list[Any] = []
        self.left: list[Any] = []
        self.rooted: list[Any] = []
        self.quadratic: dict[Any, tuple[Any, Any, Any]] = {}
        for one, other in given:
            if rooted := not (_has_roots(one**2) or _has_roots(other**2)) and _has_roots(one - other):
                self.rooted.append(one - other)
            difference = self._put_in(one**2 - other**2 if rooted else one - other)
            if not (self._solve(difference, last) or self._solve(_numerator(difference), last)):
                self.left.append(difference)
        self.left = [e for e in map(_numerator, map(self._put_in, self.left)) if e != 0]
        for difference in self.left:
            for atom in sorted(_of_degree(difference, 2) - self.quadratic.keys(), key=str):
                slope = sympy.diff(difference, atom)
                twice = sympy.diff(slope, atom)
                if twice != 0 and not twice.has(atom):
                    b, c = (e.xreplace({atom: sympy.S.Zero}) for e in (slope, difference))
                    self.quadratic[atom] = twice / 2, b, c
                    break

    def _solve(self, difference: Any, last: Sequence[Any]) -> bool:
        """Whether something that vanishes is linear in an atom, which has the value then that it says."""
        for atom in sorted(_of_degree(difference, 1), key=lambda atom: (atom in last, str(atom))):
            slope = sympy.diff(difference, atom)
            if slope != 0 and not slope.has(atom):
                value = -difference.xreplace({atom: sympy.S.Zero}) / slope
                self.values = {known: e.xreplace({atom: value}) for known, e in self.values.items()}
                self.values[atom] = value
                self.slopes.append(slope)
                return True
        return False

    def _put_in(self, difference: Any) -> Any:
        """What vanishes by what is solved for, without what the values of that divide by."""
        difference = sympy.expand(difference)
        known = difference.xreplace(self.values)
        return known if known == difference else _numerator(known)

    def roots(self, values: dict[Any, Any]) -> dict[Any, Any]:
        """Atoms whose squares equations say, where there are real ones; with the sign that they had, if one has."""
        found = dict[Any, Any]()
        for atom, coefficients in self.quadratic.items():
            a, b, c = (e.xreplace(found).xreplace(values) for e in coefficients)
            square = b**2 - 4 * a * c
            if a != 0 and square.is_Rational and square >= 0:
                roots = [(-b + sign * sympy.sqrt(square)) / (2 * a) for sign in (1, -1)]
                found[atom] = next((root for root in roots if (root >= 0) == (values[atom] >= 0)), roots[0])
        return found

    def satisfied(self, enclosures: Enclosures) -> bool:
        """Whether all of them hold, exactly."""
        known = all(map(enclosures.sign, self.slopes))
        return known and all(sympy.expand(e.xreplace(enclosures.point)) == 0 for e in (*self.left, *self.rooted))


def _numerator(e: Any) -> Any:
    """What is left of a sum without what it divides by; raises `OutOfTime` if it may have more terms than can be."""
    if e.is_polynomial():
        return e
    _afford_numerator(e)
    whole = sympy.cancel if e.is_rational_function(*e.free_symbols) else sympy.together
    return sympy.expand(sympy.fraction(whole(e))[0])


def _has_roots(e: Any) -> bool:
    """Whether square roots of what is no number are in it."""
    return any(power.exp.is_Rational and power.exp.q == 2 and power.base.free_symbols for power in e.atoms(sympy.Pow))


def _of_degree(difference: Any, degree: int) -> set[Any]:
    """The atoms in which a sum may be a polynomial of the degree."""
    polynomial = difference.as_poly()
    if polynomial is None:
        return set(difference.free_symbols)
    degrees = zip(polynomial.gens, polynomial.degree_list(), strict=True)
    return {known for known, reached in degrees if known.is_Symbol and reached == degree}


def _afford_numerator(e: Any) -> None:
    """Raise `OutOfTime` if a sum's numerator may have more terms than there is work left for."""
    terms = sympy.Add.make_args(e)
    below = {base for term in terms for base in sympy.Mul.make_args(sympy.fraction(sympy.together(term))[1])}
    afford(len(terms) * prod(len(sympy.Add.make_args(base)) for base in below) * TERM)


def _drawn(atom: Any, random: Random, attempt: int) -> Any:
    """A rational number that the atom may be, small ones first."""
    value = sympy.Integer(attempt % 2)
    if attempt in (FEW[1], FEW[1] + 1) and _agrees(atom, value):
        return value
    for _ in range(TRIES):
        reach = 3 if attempt < FEW[1] else 12
        value = sympy.Rational(random.randint(-4 * reach, 4 * reach), random.choice((1, 2, 3, 4, 4, 8)))
        if attempt > FEW[1] and attempt % 3 == 2 and not atom.is_integer:
            value /= SMALL  # what adds up to one, say
        if _agrees(atom, value):
            break
    return value


def _may_be(atom: Any, enclosures: Enclosures, dummy: Any) -> bool:
    """Whether the atom may have its value; of one that is not rational only the sign is known."""
    value = enclosures.point.get(dummy, dummy)
    known = value.is_Rational or not assumed_of(atom).keys() - SIGNS.keys()
    return known and _agrees(atom, value if value.is_Rational else sympy.Integer(enclosures.sign(dummy)))


def _agrees(atom: Any, value: Any) -> bool:
    """Whether the atom may have the value, by what SymPy knows of it."""
    return all(getattr(value, f"is_{key}") is known for key, known in assumed_of(atom).items())


def exactly(value: Any) -> Any:
    """A number, as a fraction if it is rational."""
    return Fraction(int(value.p), int(value.q)) if isinstance(value, sympy.Rational) else value
