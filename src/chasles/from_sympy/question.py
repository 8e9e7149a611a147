"""A question on SymPy expressions: the problem that decides it, and how to say the answer in SymPy's terms."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass, replace
from fractions import Fraction
from typing import Any

import sympy

from chasles.algebra.surds import SurdSum
from chasles.checker.expressions.asked import Asked
from chasles.checker.expressions.at_point import AtPoint
from chasles.checker.expressions.motion import require_given
from chasles.checker.expressions.symbolic import Symbolic
from chasles.checker.sparse import Rejected, well_formed
from chasles.from_sympy.naming import angle_of, number_of, spelled
from chasles.from_sympy.opening import atoms_of
from chasles.from_sympy.sampling import Sampling
from chasles.points.search import Search
from chasles.prover.certifying import proved
from chasles.statements import Goal, Hypothesis, Problem
from chasles.verdict import Counterexample, Fails, Holds, HoldsUnder, IllFormed, Undecided, Verdict
from chasles.vocabulary import PI, Block, Negative, Node, Power, Sum, Symbol, Zero


@dataclass(slots=True)
class Question:
    """A problem in words, with the search for its points and the names that SymPy has for its variables.

    `needs` are reported whatever the proof uses: divisors, the domains of roots, substituted angles. `hidden` texts are
    true by themselves. `sources` give the texts of what the user said for that of what follows
    from it, `origins` what each word stands for; `roots` follow from the other coordinates of a point, and so do the
    atoms `substituted`. If it is `formal`, words stand for values of functions: a point of the problem need not be one
    of the question. If it is `nonnegative`, both sides are scalars that visibly are. By what is `of_rates`
    only rates of what is given are divided.
    """

    problem: Problem
    own: tuple[Hypothesis, ...]
    search: Search
    needs: tuple[str, ...]
    hidden: frozenset[str]
    sources: Mapping[str, tuple[str, ...]]
    origins: Mapping[Symbol, Any]
    roots: frozenset[Symbol]
    substituted: tuple[tuple[Any, Any], ...]
    sampling: Sampling | None = None
    formal: bool = False
    nonnegative: bool = False
    of_rates: frozenset[Hypothesis | None] = frozenset()

    def variants(self) -> Iterator[tuple[int, Problem]]:
        """Problems that say the same, and may be easier to prove, with what the certificate calls them.

        The square of the difference is zero (1); or the squares of sides are equal that are not negative (2).
        """
        for goal in self.problem.goals if self.conditions else ():
            rows, columns = shape = goal.left.shape
            places = [(i + 1, j + 1) for i in range(rows) for j in range(columns)]
            pairs = [(entry_of(goal.left, place), entry_of(goal.right, place)) for place in places]
            squares: list[Node] = [Power(Sum((one, Negative(other))), 2) for one, other in pairs]
            yield 1, replace(self.problem, goals=(Goal("", matrix_of(squares, shape), Zero(rows, columns)),))
        if self.nonnegative:
            (goal,) = self.problem.goals
            yield 2, replace(self.problem, goals=(Goal("", Power(goal.left, 2), Power(goal.right, 2)),))

    @property
    def conditions(self) -> bool:
        """Whether equations are given."""
        return any(h.kind != "root" and h.equations for h in self.problem.hypotheses)

    def answered(self, verdict: Verdict) -> Verdict:
        """The verdict in SymPy's terms."""
        match verdict:
            case Holds() | HoldsUnder():
                needs = tuple(text for text in self._said((*self.needs, *verdict.needs)) if text not in self.hidden)
                unused = tuple(text for text in self._said(verdict.unused) if text not in (*needs, *self.hidden))
                return proved(needs, verdict.certificate, self._point(verdict.witness), unused)
            case Fails(Counterexample() as found):
                return Fails(replace(found, at=self._point(found.at)))
            case IllFormed(reason):
                return Undecided(reason)
            case _:
                return verdict

    def moves(self, asked: Asked, point: Mapping[str, Any]) -> bool:
        """Whether the checker sees a motion through a point that satisfies what is given at all times."""
        with suppress(Rejected), well_formed("point"):
            at = AtPoint(Symbolic({}, {}), self._point(point))
            for e in (atom for expression in asked.expressions for atom in atoms_of(expression)):
                at.symbolic.place(e)
            require_given(asked, at)
            return True
        return False

    def said_of(self, hypothesis: Hypothesis) -> tuple[str, ...]:
        """What the user said of which a hypothesis follows."""
        return tuple(self.sources.get(hypothesis.text, (hypothesis.text,)))

    def _said(self, texts: Iterable[str]) -> tuple[str, ...]:
        """What the user said, for texts of hypotheses."""
        return tuple(dict.fromkeys(said for text in texts for said in self.sources.get(text, (text,))))

    def _point(self, point: Mapping[str, Any]) -> dict[str, Any]:
        """A point by SymPy's names, irrational coordinates as SymPy numbers; roots follow from the others."""
        origins = {word.name: origin for word, origin in self.origins.items()}
        hidden = {word.name for word in (*self.roots, PI)}
        angle = self._angle(point, origins)
        found: dict[str, Any] = {}
        for name, value in sorted(point.items()):
            if name in hidden:
                continue
            text = spelled(name, origins)
            # A symbol may be called as a cosine is written.
            text = text if text not in found else sympy.srepr(origins.get(name, text))
            found[text] = number_of(value, angle) if isinstance(value, SurdSum) else value
        for atom, value in reversed(self.substituted):
            parts = set(atoms_of(value))
            for part in sorted(parts, key=str):
                # What is spoken of in no other way is free.
                if not any(str(part) in name for name in found):
                    found[str(part)] = Fraction(int(bool(part.is_positive)))
            known = {part: found.get(str(part)) for part in parts}
            if all(number is not None for number in known.values()):
                found[str(atom)] = value.xreplace({part: sympy.sympify(x) for part, x in known.items()})
        return found

    def _angle(self, point: Mapping[str, Any], origins: Mapping[str, Any]) -> Any:
        """What the transcendental number is: pi, or the positive angle that has its cosine and sine at the point."""
        theta = self.search.theta
        for name, cosine in point.items():
            word, unit = angle_of(name, origins) if name.startswith("cos(") else ("", sympy.S.One)
            if theta is not None and word == theta.name:
                sine = point["sin" + name.removeprefix("cos")]
                turned = sympy.atan2(*(sympy.Rational(x.numerator, x.denominator) for x in (sine, cosine)))
                return (turned if turned.is_positive else turned + 2 * sympy.pi) / unit
        return sympy.pi


def entry_of(node: Node, place: tuple[int, int]) -> Node:
    """The word in a row and column of a matrix of scalars; a scalar is its own."""
    return node.rows[place[0] - 1][place[1] - 1] if isinstance(node, Block) else node


def matrix_of(nodes: list[Node], shape: tuple[int, int]) -> Node:
    """The matrix with these entries, row by row; a scalar is its own."""
    rows, columns = shape
    if shape == (1, 1):
        return nodes[0]
    return Block(tuple(tuple(nodes[i * columns : (i + 1) * columns]) for i in range(rows)))
