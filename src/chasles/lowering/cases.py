"""Values that depend on a comparison: the first case all of whose comparisons come out as said is taken.

An inverse with branches is such a choice: which comparisons does a machine make to know that a branch applies?
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Literal

from chasles.lowering.refusal import LoweringError
from chasles.lowering.rewriting import Angle
from chasles.problems.variables import angle_multiples
from chasles.statements import Branch, Hypothesis, Inverse
from chasles.vocabulary import Call, Dot, Node, Norm, Scale, Symbol, Trace, column, number, plain, uniform


@dataclass(frozen=True, slots=True)
class Comparison:
    """left < right, or left = right, or (where it does not hold) the opposite."""

    kind: Literal["less", "equal"]
    left: Node
    right: Node
    holds: bool = True


@dataclass(frozen=True, slots=True)
class Case:
    """Where all comparisons come out as said: the values of a choice's symbols, in their order.

    A case without values says what no numbers do: there something is infinite, or not a number.
    """

    where: tuple[Comparison, ...]
    values: tuple[Node, ...]


@dataclass(frozen=True, slots=True)
class Choice:
    """The symbols take the values of the first case that applies, and have no value where none does."""

    symbols: tuple[Symbol, ...]
    cases: tuple[Case, ...]

    @property
    def is_exhaustive(self) -> bool:
        """Whether the last case applies whatever comes."""
        return not self.cases[-1].where


def vanishes(scalar: Node, *, holds: bool = True) -> Comparison:
    """Whether the scalar is zero, or (where that does not hold) is not."""
    return Comparison("equal", scalar, number(0), holds)


def largest_of(symbols: tuple[Symbol, ...], candidates: Sequence[tuple[Node, tuple[Node, ...]]]) -> Choice:
    """The values beside the largest of the scalars; the first of several that are equally large.

    Each candidate is a scalar and the values that go with it.
    """
    cases = []
    for place, (size, values) in enumerate(candidates):
        rivals = candidates[place + 1 :]
        cases.append(Case(tuple(Comparison("less", size, other, holds=False) for other, _ in rivals), values))
    return Choice(symbols, tuple(cases))


def oriented(sign: Symbol, entries: Sequence[Node], finite: Node | None = None) -> Choice:
    """The sign, 1 or -1, that makes the first of the entries positive that is not zero; 1 where all are zero.

    There is none where the scalar that is to be `finite` is not.
    """
    cases = [] if finite is None else [Case((vanishes(finite - finite, holds=False),), ())]
    plus, minus = number(1), number(-1)
    for entry in entries:
        cases.append(Case((Comparison("less", entry, number(0)),), (minus,)))
        cases.append(Case((Comparison("less", number(0), entry),), (plus,)))
    return Choice((sign,), (*cases, Case((), (plus,))))


def choices_of(
    inverse: Inverse, *, largest: bool = False, sign: tuple[Node, ...] = ()
) -> tuple[list[Choice], dict[Node, Node], dict[Symbol, Angle]]:
    """The branches as cases, the rules that go with them, and angles by the cosine and sine that the branches give.

    The first branch whose `where` is not zero is taken, or the one where it is `largest`. The values of the `sign`
    keys change sign together, so that the first of their entries that is not zero is positive.
    Raises `LoweringError` for branches that give values to different symbols, and for an assumption that no comparison
    of numbers can confirm.
    """
    keys = tuple(dict(inverse.branches[0].values))
    for branch in inverse.branches:
        if tuple(dict(branch.values)) != keys:
            raise LoweringError(f"({inverse.number}): the branches must give values to the same symbols, in one order")
    symbols = {key: _symbol(inverse, key) for key in keys}
    found = {key: _beside(symbol, "before its sign") if key in sign else symbol for key, symbol in symbols.items()}
    choices = [_choice(inverse, tuple(found.values()), largest=largest)]
    rules: dict[Node, Node] = {}
    if sign:
        turn = Symbol(f"sign of {plain(inverse.of.left)}", "", uniform((1, 1)))
        # Whatever is infinite or not a number among what is inverted makes each branch's size so.
        finite = _size(inverse.branches[0])
        choices.append(oriented(turn, [entry for key in sign for entry in _entries(found[key])], finite))
        rules = {symbols[key]: Scale(turn, found[key]) for key in sign}
    return choices, rules, _angles(symbols)


def _choice(inverse: Inverse, symbols: tuple[Symbol, ...], *, largest: bool) -> Choice:
    values = [tuple(value for _, value in branch.values) for branch in inverse.branches]
    if largest:
        return largest_of(symbols, list(zip(map(_size, inverse.branches), values, strict=True)))
    tests = [tuple(_comparisons(branch)) for branch in inverse.branches]
    return Choice(symbols, tuple(Case(where, those) for where, those in zip(tests, values, strict=True)))


def _angles(symbols: dict[Node, Symbol]) -> dict[Symbol, Angle]:
    angles = {}
    for key in symbols:
        if isinstance(key, Call) and key.function == "cos":
            ((angle, multiple),) = angle_multiples(key.argument, {}).items()
            angles[angle] = Angle(symbols[key], symbols[Call("sin", key.argument)], 1 / multiple)
    return angles


def _symbol(inverse: Inverse, key: Node) -> Symbol:
    """The symbol that holds a branch's value; one of its own for the cosine or sine of an angle."""
    match key:
        case Symbol():
            return key
        case Call("cos" | "sin", argument) if len(angle_multiples(argument, {})) == 1:
            return _beside(Symbol(plain(key), "", uniform((1, 1))), "as found")
        case _:
            said = "it must be a symbol, or the cosine or sine of a multiple of one"
            raise LoweringError(f"({inverse.number}): a branch gives a value to {plain(key)}; {said}")


def _beside(symbol: Symbol, said: str) -> Symbol:
    """Another symbol of the same size."""
    return Symbol(f"{symbol.name}, {said}", "", symbol.size)


def _entries(symbol: Symbol) -> list[Node]:
    rows = symbol.shape[0]
    if rows == 1:
        return [symbol]
    return [Dot(column(*(int(i == k) for i in range(rows))), symbol) for k in range(rows)]


def _size(branch: Branch) -> Node:
    """What tells how far a branch is from where it does not apply: `where`, or its square if it is a norm."""
    return Dot(branch.where.of, branch.where.of) if isinstance(branch.where, Norm) else branch.where


def _comparisons(branch: Branch) -> Iterator[Comparison]:
    yield vanishes(_size(branch), holds=False)
    for hypothesis in branch.assuming:
        yield _confirmed(branch, hypothesis)


def _confirmed(branch: Branch, hypothesis: Hypothesis) -> Comparison:
    """The comparison by which a hypothesis is confirmed, once the branches before have been left out."""
    match hypothesis.kind, hypothesis.subjects:
        case "nonzero", (scalar,):
            return vanishes(scalar, holds=False)
        case "positive", (scalar,):
            return Comparison("less", number(0), scalar)
        case "half_turn", (rotation,):
            # A rotation without an axial vector is a half-turn, of trace -1, or the identity, of trace 3.
            return Comparison("less", Trace(rotation), number(0))
        case _:
            raise LoweringError(
                f"the branch '{branch.says}' assumes that {hypothesis.text}, which no comparison of numbers confirms: "
                "say where the branch applies by what is not zero there"
            )
