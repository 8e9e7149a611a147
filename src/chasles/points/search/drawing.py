"""One attempt to find a point: orthonormal frames and fixed angles first, then equations, then all other variables."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from random import Random

from chasles.algebra.surds import SurdSum, root_of
from chasles.algebra.work_limit import check
from chasles.points.search.angles import NO_TURNS, QUARTERS, Turning
from chasles.points.search.constraints import ConstraintSystem
from chasles.points.search.solving import eliminable, solve_one, unknowns
from chasles.points.search.values import Partial, Sparse, Values, degree

PLAIN_ATTEMPTS = 12
TRIES = 12
ORDINARY = 0.9


@dataclass(frozen=True, slots=True)
class Frame:
    """The names of the entries of a matrix with orthonormal columns; `proper` if its determinant is one."""

    rows: tuple[tuple[str, ...], ...]
    proper: bool


class Drawing:
    """Draws points of a system; the variables that are `determined` are solved for, once others have values."""

    def __init__(
        self,
        system: ConstraintSystem,
        turning: Turning,
        frames: Sequence[Frame],
        allowed: Callable[[str, SurdSum], bool],
        determined: frozenset[str] = frozenset(),
    ) -> None:
        self.determined = determined
        self.system = system
        self.turning = turning
        self.frames = frames
        self.allowed = allowed

    def attempt(self, random: Random, number: int) -> Values | None:
        """Values of all variables at which everything holds; None if it does not work out this time."""
        self.random = random
        self.plain = number < PLAIN_ATTEMPTS
        self.values = Values()
        for frame in self.frames:
            self._draw_frame(frame)
        turns = NO_TURNS if number == 0 else QUARTERS if self.plain else None
        drawn = self.turning.draw(self.values, self._number, random, turns)
        if not (drawn and self._solve() and self._draw_rest() and self._holds()):
            return None
        return self.values

    def _number(self, place: int) -> Fraction:
        """A small number that the variable may be."""
        reach = 2 if self.plain else 5 if self.random.random() < ORDINARY else 10 ** self.random.randint(1, 3)
        for _ in range(TRIES):
            below = 1 if self.plain else self.random.choice((1, 1, 1, 2, 3))
            value = Fraction(self.random.randint(-reach, reach), below)
            if place in self.system.roots:
                return abs(value)
            if self.allowed(self.system.names[place], SurdSum.rational(value)):
                break
        return value

    def _draw_frame(self, frame: Frame) -> None:
        size = len(frame.rows)
        matrix = [[Fraction(int(i == j)) for j in range(size)] for i in range(size)]
        reflections = 2 if frame.proper else self.random.choice((1, 2))
        for _ in range(reflections):
            matrix = self._reflected(matrix)
        for names, entries in zip(frame.rows, matrix, strict=True):
            for name, entry in zip(names, entries, strict=False):
                if name in self.system.place:
                    self.values[self.system.place[name]] = entry

    def _reflected(self, matrix: list[list[Fraction]]) -> list[list[Fraction]]:
        """The columns reflected in a random plane."""
        size = len(matrix)
        reach = 1 if self.plain else 3
        normal = [0] * size
        while not any(normal):
            normal = [self.random.randint(-reach, reach) for _ in range(size)]
        square = sum(n * n for n in normal)
        along = [sum(n * row[j] for n, row in zip(normal, matrix, strict=True)) for j in range(size)]
        return [
            [entry - Fraction(2 * n, square) * along[j] for j, entry in enumerate(row)]
            for n, row in zip(normal, matrix, strict=True)
        ]

    def _solve(self) -> bool:
        """Satisfy the equations, roots included, until nothing is left that asks for a value."""
        equations = list(self.system.equations)
        free = [a for a in self.system.angles if a.cosine not in self.values]
        equations += [self.system.circles[angle.sine] for angle in free]
        roots = dict(self.system.roots)
        while True:
            check()
            self.values.settle()
            if self._find_roots(roots, equations) is None:
                return False
            partials = [partial for partial in map(self.values.into, equations) if partial]
            if any(not unknowns([partial]) for partial in partials):
                return False
            if partials and (eliminable(partials) or not roots.keys() & set(unknowns(partials))):
                if not self._step(partials):
                    return False
            elif not roots:
                return True
            elif not self._draw_radicand(roots, equations):
                return False

    def _find_roots(self, roots: dict[int, Sparse], equations: list[Sparse]) -> bool | None:
        """Take out the roots whose radicands have values; None if one is not real. A root that is known is an equation.

        So is one that what is under it has come to depend on.
        """
        for place, radicand in list(roots.items()):
            inside = self.values.into(radicand)
            if place in self.values or place in self.values.forms or place in unknowns([inside]):
                equations.append([*radicand, (((place, 2),), Fraction(-1))])
            elif not unknowns([inside]):
                root = self._root_of(inside)
                if root is None:
                    return None
                self.values[place] = root
            else:
                continue
            del roots[place]
            self.values.settle()
            return self._find_roots(roots, equations)
        return True

    def _step(self, partials: list[Partial]) -> bool:
        """Eliminate a variable, or satisfy an equation where none can be."""
        candidates = eliminable(partials)
        candidates = [(k, form) for k, form in candidates if k not in self.system.roots] or candidates
        if candidates:
            lowest = min(degree(form) for _, form in candidates)
            self.values.follow(*self.random.choice([(k, form) for k, form in candidates if degree(form) == lowest]))
            return True
        states = {k for k in unknowns(partials) if self.system.names[k] not in self.determined}
        if all(set(unknowns([partial])) - states for partial in partials) and states:
            place = min(states)
            self.values[place] = self._number(place)
            return True
        partials = [partial for partial in partials if set(unknowns([partial])) <= states] or partials
        fewest = min(len(unknowns([partial])) for partial in partials)
        partials = [partial for partial in partials if len(unknowns([partial])) == fewest]
        solution = solve_one(self.random.choice(partials), self._number, self.random, self.plain)
        for place, value in (solution or {}).items():
            self.values[place] = value
        return solution is not None

    def _draw_radicand(self, roots: dict[int, Sparse], equations: list[Sparse]) -> bool:
        """Values of the variables under a root for which it is real, rational if that is soon found."""
        insides = {place: unknowns([self.values.into(radicand)]) for place, radicand in roots.items()}
        free = [place for place, inside in insides.items() if not roots.keys() & set(inside)]
        if not free:
            place, radicand = roots.popitem()
            equations.append([*radicand, (((place, 2),), Fraction(-1))])
            return True
        radicand, places = roots[free[0]], insides[free[0]]
        good: dict[int, Fraction] | None = None
        for _ in range(TRIES):
            point = {place: self._number(place) for place in places}
            trial = self.values.copy()
            trial.rational |= point
            trial.settle()
            partial = trial.into(radicand)
            root = self._root_of(partial)
            good = point if root is not None else good
            if root is not None and root.as_rational is not None:
                break
        for place, value in (good or {}).items():
            self.values[place] = value
        return good is not None

    def _root_of(self, inside: Partial) -> SurdSum | None:
        if unknowns([inside]):
            return None
        in_use = {one for value in self.values.irrational.values() for _, _, nested in value.terms for one in nested}
        return root_of(inside.get((), SurdSum({})), sorted(in_use, key=str))

    def _draw_rest(self) -> bool:
        for place in range(len(self.system.names)):
            if place not in self.values and place not in self.values.forms:
                self.values[place] = self._number(place)
        self.values.settle()
        return True

    def _holds(self) -> bool:
        """Whether everything holds: the last word, whatever led here."""
        values = self.values
        roots = self.system.roots.items()
        squares = ((place, values[place] * values[place] - values.of(inside)) for place, inside in roots)
        vanishing = (*self.system.equations, *self.system.consequences, *self.system.circles.values())
        return (
            all(values.of(terms).is_zero for terms in vanishing)
            and all(rest.is_zero and _is_root(values[place]) for place, rest in squares)
            and not any(values.of(factor).is_zero for factor in self.system.nonzero)
            and not any(values[place].is_zero for place in self.turning.nonzero())
            and all(
                self.allowed(name, values[place])
                for place, name in enumerate(self.system.names)
                if place not in self.system.roots
            )
        )


def _is_root(value: SurdSum) -> bool:
    """Whether a number is not negative; the transcendental number is not."""
    if len(value.terms) == 1:
        return all(coefficient > 0 for coefficient in value.terms.values())
    return value.is_algebraic and not value.is_negative
