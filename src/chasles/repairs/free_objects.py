"""Objects that claims determine only up to some freedom: another such object for which the printed equation is right.

A claim y = X rate(z) leaves X free up to c w^T for any w with w^T rate(z) = 0, and a constraint on z gives such a w. A
left inverse is such an X. What is printed of one of them need not be true of another.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from dataclasses import replace as with_fields
from fractions import Fraction
from itertools import combinations

from chasles.algebra.modular import MODULUS, combination
from chasles.deciding import decided
from chasles.repairs.modular_testing import REFUSED, ModularTest, modular_test
from chasles.repairs.one_term import Change, distinct_terms, instead, rescaled
from chasles.rewriting.coefficients import AngleFunction, added, spelled, times
from chasles.rewriting.places import Place, put, separate_sums
from chasles.rewriting.term_basis import TermBasis, fit
from chasles.statements import Claim, Statement, problem_of
from chasles.statements.goals import AcceptedSides
from chasles.statements.posing import default_sides
from chasles.vocabulary import Block, Contract, Dot, Misfit, Node, Rate, Symbol, Transpose, Zero, plain, replace

MOST_RESCALED = 2
"""Terms of the printed side whose numbers may be wrong as well."""
_Multiple = tuple[AngleFunction, Node, Node]
"""A function, a dyad of a vector and the row, and their product."""


@dataclass(frozen=True, slots=True)
class Freedom:
    """The claim says the same of `symbol` and of symbol + c row^T, for every c."""

    symbol: Symbol
    row: Block
    claim: Claim

    @property
    def words(self) -> str:
        """What is free, and why."""
        return f"({self.claim.number}) says the same of {plain(self.symbol)} + c {plain(self.row)}^T for every vector c"


def freedom_of(left: Node, context: Iterable[Claim], accepted: AcceptedSides) -> Iterator[Freedom]:
    """What claims `context` leave free of the symbol that the left side is, or is the rate of."""
    symbol = left.of if isinstance(left, Rate) else left
    for claim in context:
        if not isinstance(symbol, Symbol) or claim.restates is not None or claim.solves is not None:
            continue
        one, other = default_sides(claim)
        match other:
            case Contract((first, Rate(Symbol() as array))) if first == symbol:
                try:
                    test = modular_test(claim, one, other, accepted)
                except REFUSED:
                    continue
                blocks = dict(test.problem.rules).get(array) if test is not None else None
                if test is not None and isinstance(blocks, Block):
                    yield from (Freedom(symbol, row, claim) for row in _rows(test, blocks))


def _rows(test: ModularTest, array: Block) -> Iterator[Block]:
    """The array with some of its blocks, or all, whose squares add up to a constant."""
    blocks = [line[0] for line in array.rows]
    rates = [test.varied.flat(Dot(block, Rate(block))) for block in blocks]
    for size in range(len(blocks), 0, -1):
        for chosen in combinations(range(len(blocks)), size):
            if not any(sum(entries) % MODULUS for entries in zip(*(rates[k] for k in chosen), strict=True)):
                kept = [block if k in chosen else Zero(*block.shape) for k, block in enumerate(blocks)]
                yield Block(tuple((block,) for block in kept))
                return


def other_objects(
    statement: Statement, sides: tuple[Node, Node], freedom: Freedom, basis: TermBasis, accepted: AcceptedSides
) -> Iterator[Change]:
    """The printed right side, with a few other numbers at most, for another object that the claim allows."""
    left, right = sides
    test = modular_test(statement, left, right, accepted, [freedom.row, Rate(freedom.row)])
    if test is None:
        return
    multiples = list(_multiples(test, freedom, basis))
    columns = [test.varied.flat(replace(left, {freedom.symbol: multiple})) for _, _, multiple in multiples]
    terms = [term for _, terms in separate_sums(right) for term in terms]
    contributions = [test.contribution(test.varied, term) for term in terms]
    for size in range(MOST_RESCALED + 1):
        found = False
        for chosen in combinations(range(len(terms)), size):
            values = combination([*columns, *(contributions[k] for k in chosen)], test.residual(test.varied))
            if values is None:
                continue
            numbers = {terms[k]: value + 1 for k, value in zip(chosen, values[len(columns) :], strict=True)}
            other = _other(freedom, multiples, values)
            if other is not None and _allowed(freedom, other, statement, accepted):
                found = True
                yield _changed(test, freedom, other, numbers)
        if found:
            return


def _multiples(test: ModularTest, freedom: Freedom, basis: TermBasis) -> Iterator[_Multiple]:
    row = _in_letters(test, freedom.row)
    for vector in distinct_terms(test, (node for node in basis.vectors if not isinstance(node, Rate)), ()):
        dyad = Contract((vector, Transpose(row)))
        if fit(freedom.symbol, dyad):
            yield from ((function, dyad, times(function.node, dyad)) for function in test.fractions)


def _in_letters(test: ModularTest, row: Block) -> Block:
    """The row in the letters that stand for its blocks."""
    letters = [left for left, _ in test.problem.rules if isinstance(left, Symbol)]
    named = []
    for (block,) in row.rows:
        same = (k for k in letters if k.shape == block.shape and test.varied.flat(k) == test.varied.flat(block))
        named.append((next(same, block),))
    return Block(tuple(named))


def _other(freedom: Freedom, multiples: list[_Multiple], values: list[Fraction]) -> Node | None:
    """The object for which the printed equation is right; None if it is the one that is printed."""
    terms: list[Node] = []
    for dyad in dict.fromkeys(dyad for _, dyad, _ in multiples):
        coefficient = spelled((-v, f) for (f, own, _), v in zip(multiples, values, strict=False) if own == dyad)
        if coefficient is not None:
            terms.append(times(coefficient, dyad))
    return added([freedom.symbol, *terms]) if terms else None


def _allowed(freedom: Freedom, other: Node, statement: Statement, accepted: AcceptedSides) -> bool:
    """Whether the claim holds for the other object too."""
    left, right = default_sides(freedom.claim)
    given = tuple(dict.fromkeys((*freedom.claim.given, *statement.given)))
    claim = with_fields(freedom.claim.saying(left, replace(right, {freedom.symbol: other})), given=given)
    try:
        return decided(problem_of(claim, "printed", accepted)).true
    except (Misfit, TypeError):
        return False


def _changed(test: ModularTest, freedom: Freedom, other: Node, numbers: dict[Place, Fraction]) -> Change:
    left, right = replace(test.left, {freedom.symbol: other}), test.right
    words = [instead(left, test.left)]
    for place, number in reversed(numbers.items()):
        new, said = rescaled(place.node, number)
        right = put(right, place.path, new)
        words.insert(1, said)
    return Change(left, right, tuple(words), 5, freedom.words)
