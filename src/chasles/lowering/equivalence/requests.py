"""Does a program compute what was asked for? Decided in the prover's own fractions, entry by entry, case by case."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import product
from math import prod

from chasles.algebra.localization import Ratio
from chasles.lowering.cases import Choice
from chasles.lowering.equivalence.algebra import Algebra
from chasles.lowering.equivalence.angles_taken import Unreadable, angles_of
from chasles.lowering.equivalence.reading import ProgramReading, Settled, scale_symbols
from chasles.lowering.equivalence.signs import Differences, Fork, Impossible, Signs
from chasles.lowering.program import Program
from chasles.lowering.request import Output, Request
from chasles.problems.divisors import UndeclaredDivisor
from chasles.problems.variables import Untreatable
from chasles.statements.arrays import argument_name, places_of
from chasles.vocabulary import Node, Symbol


def differences(request: Request, program: Program) -> tuple[str, ...]:
    """Where the program is not, or is not seen to be, what the request asks for: one line each, none if it is equal.

    Programs with selections are compared on every way through the cases, given what the cases say.
    """
    said = _shape(request, program)
    if said:
        return (said,)
    found: dict[str, None] = {}
    try:
        algebras = _Algebras(request, program)
        for way in product(*map(_cases, request.choices)):
            found |= dict.fromkeys(_on_way(request, program, way, algebras))
    except (Unreadable, Untreatable, UndeclaredDivisor) as error:
        found[str(error)] = None
    return tuple(found)


def _cases(choice: Choice) -> tuple[int, ...]:
    """The cases that numbers can be in, by their places; the last place is that of none, where that can be."""
    places = range(len(choice.cases) + (not choice.is_exhaustive))
    return tuple(k for k in places if k == len(choice.cases) or choice.cases[k].values)


def _shape(request: Request, program: Program) -> str | None:
    """What of the program's arguments and results is not the request's."""
    wanted = [(argument_name(argument), len(places_of(argument))) for argument in request.arguments]
    have = [(argument.name, prod(argument.shape)) for argument in program.arguments]
    if wanted != have:
        return f"its arguments are {have}, and {wanted} were asked for"
    wanted = [(output.name, len(output.places)) for output in request.outputs]
    have = [(result.name, len(result.entries)) for result in program.results]
    return f"its results are {have}, and {wanted} were asked for" if wanted != have else None


class _Algebras:
    """The algebra for each set of values that the choices take, and what steps come to in it; each made once."""

    def __init__(self, request: Request, program: Program) -> None:
        compared = [side for c in request.choices for case in c.cases for w in case.where for side in (w.left, w.right)]
        self.scales = scale_symbols(program)
        arguments = (argument for known in request.functions for argument in (known.symbol, *known.arguments))
        self._further = (*compared, *angles_of(program, request), *arguments)
        self._request = request
        self._program = program
        self._known: dict[tuple[tuple[Node, Node], ...], tuple[Algebra, Settled]] = {}

    def of(self, rules: dict[Node, Node]) -> tuple[Algebra, Settled]:
        """The algebra in which the rules hold."""
        key = tuple(rules.items())
        if key not in self._known:
            algebra = Algebra(self._request, rules, self._further, tuple(self.scales.values()))
            self._known[key] = algebra, Settled(self._program)
        return self._known[key]


def _on_way(request: Request, program: Program, way: Sequence[int], algebras: _Algebras) -> Iterator[str]:
    """The differences where each choice is in the case that `way` says; past its last case a choice has no value."""
    rules: dict[Node, Node] = {}
    valueless: list[Symbol] = []
    for choice, place in zip(request.choices, way, strict=True):
        if place == len(choice.cases):
            valueless += choice.symbols
        else:
            rules |= dict(zip(choice.symbols, choice.cases[place].values, strict=True))
    algebra, settled = algebras.of(rules)
    waiting = [_signs(algebra, request.choices, way)]
    while waiting:
        signs = waiting.pop()
        if not signs.is_possible:
            continue
        try:
            reading = ProgramReading(program, request, signs, settled, algebras.scales)
            yield from _compared(request, reading, program, signs, valueless)
        except Fork as fork:
            waiting += signs.forked(fork)
        except Impossible:
            continue


def _signs(algebra: Algebra, choices: Sequence[Choice], way: Sequence[int]) -> Signs:
    """The signs that follow from the cases that are taken and from those that are passed over."""
    signs = Signs(Differences(algebra))
    for choice, place in zip(choices, way, strict=True):
        for case in choice.cases[:place]:
            signs = signs.not_in_case(case)
        if place < len(choice.cases):
            signs = signs.in_case(choice.cases[place])
    signs.differences.is_thorough = True
    return signs


def _compared(
    request: Request, reading: ProgramReading, program: Program, signs: Signs, valueless: Sequence[Symbol]
) -> Iterator[str]:
    algebra = signs.differences.algebra
    lost = _Lost(request, algebra, valueless)
    for output, result in zip(request.outputs, program.results, strict=True):
        if output.packed:
            yield from _asymmetric(output, signs)
        for (_, row, column), number in zip(output.places, result.entries, strict=True):
            wanted, found = algebra.entry(output.value, row, column), reading.value(number)
            label = f"{result.name}, entry {row + 1}, {column + 1}"
            if found is None or wanted in lost:
                if found is not None or wanted not in lost:
                    yield f"{label}: it has no value where the formula has one, or the other way round"
            elif not algebra.vanishes(found - wanted, signs.zeros):
                yield f"{label}: it is not what the formula says"


def _asymmetric(output: Output, signs: Signs) -> Iterator[str]:
    """The entries of a packed result that are not those on the other side of the diagonal."""
    algebra = signs.differences.algebra
    for _, row, column in output.places:
        one, other = algebra.entry(output.value, row, column), algebra.entry(output.value, column, row)
        if not algebra.vanishes(one - other, signs.zeros):
            yield f"{output.name} is not symmetric in {row + 1}, {column + 1}: six numbers cannot stand for it"


class _Lost:
    """The fractions that depend on symbols without a value, or on angles that are known by such."""

    def __init__(self, request: Request, algebra: Algebra, valueless: Sequence[Symbol]) -> None:
        variables = algebra.context.variables
        self._ring = algebra.context.field.ring
        self._field = algebra.context.field
        self._places = {k for k, variable in enumerate(variables) if variable.symbol in valueless}
        for symbol, angle in request.angles:
            if any(algebra.entry(side) in self for side in (angle.cosine, angle.sine)):
                self._places |= {k for k, variable in enumerate(variables) if variable.symbol == symbol}

    def __contains__(self, ratio: Ratio) -> bool:
        if not self._places:
            return False
        degrees = [self._ring.degrees(p) for p in (ratio.numerator, self._field.power_product(ratio.denominator))]
        return any(found[k] > 0 for found in degrees for k in self._places)
