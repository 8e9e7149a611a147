"""The equations nearest to one that fits together and fails: candidates for the prover, the fewest changes first.

One change is another coefficient, a missing term or a slip of form; then comes another object that the claims about it
allow, then several changes at once. A candidate passes the modular test; it is not proved.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from dataclasses import replace as with_fields
from typing import TYPE_CHECKING

from chasles import vocabulary as w
from chasles.repairs.factors import Factors, declared_inverses
from chasles.repairs.free_objects import freedom_of, other_objects
from chasles.repairs.inside_definitions import block_edits
from chasles.repairs.local_edits import SingleEdit
from chasles.repairs.modular_testing import REFUSED, ModularTest, modular_test
from chasles.repairs.one_term import Change, new_coefficients, other_terms
from chasles.repairs.residues import Unsampled
from chasles.repairs.several_terms import combined_changes
from chasles.repairs.single_edits import exchanged_letters, in_letters
from chasles.repairs.true_edits import true_edits
from chasles.repairs.without_form import changes_without_form
from chasles.rewriting.term_basis import TermBasis, fit, term_basis
from chasles.statements import Claim, Statement
from chasles.statements.goals import AcceptedSides
from chasles.statements.statement import bare
from chasles.vocabulary import Node

if TYPE_CHECKING:
    from chasles.repairs.real_test import RealTest


@dataclass
class Nearest:
    """What can be changed in a statement: the symbols at hand are those of its sides and of the `given_sides`.

    Where it is `undecided`, and its sides agree at points, there is nothing to change.
    """

    statement: Statement
    accepted: AcceptedSides
    given_sides: tuple[Node, ...] = ()
    context: tuple[Claim, ...] = ()
    undecided: bool = False
    _known_tests: dict[tuple[Node, Node, int], tuple[ModularTest | None, TermBasis]] = field(default_factory=dict)

    def changes(self, left: Node, right: Node) -> Iterator[Change]:
        """The first candidates that there are for sides that fit."""
        yield from next(iter(self.stages(left, right)), ())

    def stages(self, left: Node, right: Node) -> Iterator[list[Change]]:
        """Candidates for sides that fit, later ones further from them; one without words if they agree as they are."""
        if self.agree(left, right):
            yield [Change(left, right, ())]
            yield list(self._without_form(left, right))
            return
        kinds = (
            self._one_change,
            self._other_objects,
            self._several_changes,
            self._inner_changes,
            self._without_form,
        )
        yield from filter(None, (list(changes(left, right)) for changes in kinds))

    def is_tested(self, left: Node, right: Node) -> bool:
        """Whether there are points at which changes can be tried."""
        return any(True for _ in self._tests(left, right))

    def agree(self, left: Node, right: Node) -> bool:
        """Whether two sides agree at generic points."""
        try:
            test = modular_test(self.statement, left, right, self.accepted)
            return test is not None and not any(test.residual(test.varied))
        except REFUSED:
            return False

    def single_changes(self, left: Node, right: Node) -> Iterator[Change]:
        """One change to the right side; in a second turn, with letters that it does not have."""
        for turn, (test, basis) in enumerate(self._tests(left, right)):
            changes = [*self._edits(test, turn), *other_terms(test, basis)]
            turned = [*self._edits(test.turned, turn)]
            if isinstance(right, w.Zero):
                turned += other_terms(test.turned, basis)
            changes += [with_fields(change, left=change.right, right=change.left) for change in turned]
            found = [change for change in changes if self._holds(test, change)]
            yield from found
            if found:
                return

    def _edits(self, test: ModularTest, turn: int) -> Iterator[Change]:
        """One edit of what stands on the right in a test, new terms left aside."""
        left, right = test.left, test.right
        if not turn:
            yield from new_coefficients(test)
        letters = () if test.exchanged and isinstance(right, w.Symbol) else self.letters
        for new, words, effort in in_letters(right, letters) if turn else exchanged_letters(right):
            if fit(left, new):
                yield Change(left, new, (words,), effort)
        without = frozenset((bare(left),)) if test.exchanged else self.own
        yield from true_edits(test, Factors(test, (right, left), self.given_sides if turn else (), without))

    def _one_change(self, left: Node, right: Node) -> Iterator[Change]:
        """Another letter for one that nothing introduces, or any other change."""
        for meant, words, effort in self.introduced(left, right):
            if self.agree(left, meant):
                yield Change(left, meant, (words,), effort)
        yield from self.single_changes(left, right)

    def _holds(self, test: ModularTest, change: Change) -> bool:
        if bare(change.left) == bare(change.right):
            return False
        try:
            return test.holds(change.left, change.right)
        except Unsampled:
            return self.agree(change.left, change.right)
        except REFUSED:
            return False

    def _other_objects(self, left: Node, right: Node) -> Iterator[Change]:
        basis = term_basis([right], self.own)
        for freedom in freedom_of(left, self.context, self.accepted):
            try:
                yield from other_objects(self.statement, (left, right), freedom, basis, self.accepted)
            except REFUSED:
                continue

    def _several_changes(self, left: Node, right: Node) -> Iterator[Change]:
        for test, basis in self._tests(left, right):
            found = [change for change in combined_changes(test, basis) if self._holds(test, change)]
            yield from found
            if found:
                return

    def _inner_changes(self, left: Node, right: Node) -> Iterator[Change]:
        for test, basis in list(self._tests(left, right))[1:]:
            yield from (change for change in block_edits(test, basis) if self._holds(test, change))

    def _without_form(self, left: Node, right: Node) -> Iterator[Change]:
        test = self.in_floats(left, right)
        if test is not None and not (self.undecided and test.agree(left, right)):
            yield from changes_without_form(test, left, right, self.letters, self.given_sides)

    def in_floats(self, left: Node, right: Node) -> RealTest | None:
        """The equation at points in floating point, if others are no test: lengths of sums are rational at few."""
        lengths = (part for side in (left, right) for part in w.walk(side) if isinstance(part, w.Norm))
        tested = self.agree(left, right) or self.is_tested(left, right)
        if tested and all(isinstance(bare(each.of), w.Symbol) for each in lengths):
            return None
        from chasles.repairs.real_test import real_test  # few equations have no form, and NumPy takes long to load

        return real_test(self.statement, left, right, self.accepted)

    def _tests(self, left: Node, right: Node) -> Iterator[tuple[ModularTest, TermBasis]]:
        """The equation at points, first with the symbols of its right side alone, then with all that are at hand."""
        inverses = [each for each in declared_inverses(self.statement.assuming) if isinstance(each.of, w.Symbol)]
        for turn, nodes in enumerate(([right], [right, left, *self.given_sides, *inverses])):
            key = left, right, turn
            if key not in self._known_tests:
                order = max(map(_order, nodes)) if turn else 0
                self._known_tests[key] = self._tried(left, right, term_basis(nodes, self.own, order))
            test, basis = self._known_tests[key]
            if test is not None:
                yield test, basis

    def _tried(self, left: Node, right: Node, basis: TermBasis) -> tuple[ModularTest | None, TermBasis]:
        try:
            test = modular_test(self.statement, left, right, self.accepted, basis.nodes)
            failing = test is not None and any(test.residual(test.probe)) and any(test.residual(test.varied))
        except REFUSED:
            return None, basis
        return test if failing else None, basis

    @property
    def letters(self) -> list[w.Symbol]:
        """What a letter can have been meant for: the symbols at hand, but not the left side's own."""
        left = _symbol(self.statement.left)
        nodes = (*self.given_sides, *self.statement.printed)
        return [symbol for symbol in _symbols(nodes) if symbol != left]

    @property
    def own(self) -> frozenset[Node]:
        """The left side and its rate: with these, nothing is repaired."""
        left = bare(self.statement.left)
        return frozenset((left, w.Rate(left)))

    def introduced(self, left: Node, right: Node) -> Iterator[SingleEdit]:
        """The right side with letters that something introduces for the one that nothing does, if there is just one."""
        known = _symbols((left, *self.given_sides))
        subjects = [node for h in self.statement.assuming for node in h.subjects]
        meanings = [s.stands_for for s in known if s.stands_for is not None]
        known += [s for s in _symbols((*meanings, *subjects)) if s not in known]
        strays = [s for s in w.symbols_of(right) if s not in known and s.stands_for is None and not s.constant]
        if len(strays) == 1:
            letters = [s for s in known if s in self.letters and s.shape == strays[0].shape]
            yield from in_letters(right, letters, of=strays)


def given_sides(statement: Statement, accepted: AcceptedSides) -> tuple[Node, ...]:
    """Both sides of all that a statement is given, or restates; raises TypeError if some of that is not proved."""
    return tuple(side for each in statement.relied_on for side in accepted(each))


def _symbol(left: Node) -> w.Symbol | None:
    """The symbol that a left side is, or is the rate of."""
    node = bare(left)
    while isinstance(node, w.Rate):
        node = node.of
    return node if isinstance(node, w.Symbol) else None


def _order(node: Node) -> int:
    """How many times a rate is taken."""
    if isinstance(node, w.Rate):
        return 1 + _order(node.of)
    return max(map(_order, w.children(node)), default=0)


def _symbols(nodes: Iterable[Node]) -> list[w.Symbol]:
    return list(dict.fromkeys(symbol for node in nodes for symbol in w.symbols_of(node)))
