"""From SymPy expressions to a straight-line program, derivatives among its results where they are wanted.

Functions that no step computes are written in those that do where SymPy knows how: binomials by gamma, steps by
conditions.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace as with_fields
from typing import Any

import sympy

from chasles.algebra.work_limit import within
from chasles.compiling.angle_symbols import AngleSymbols
from chasles.compiling.angles import parts_of
from chasles.compiling.derived import DerivedResults
from chasles.compiling.elementary import functions_by_class
from chasles.compiling.inputs import Input
from chasles.compiling.removable import without_removable
from chasles.compiling.results import ResultEntries
from chasles.compiling.scalars import Scalars
from chasles.compiling.sharing import common as common_in
from chasles.compiling.sharing import nested, repeated
from chasles.compiling.variables import Substitution, outermost
from chasles.lowering.builder import Builder
from chasles.lowering.cost import price
from chasles.lowering.equivalence.programs import equivalent
from chasles.lowering.equivalence.sums import same_but_for_order
from chasles.lowering.passes.angles import respelled
from chasles.lowering.passes.guard import guarded
from chasles.lowering.passes.prune import pruned
from chasles.lowering.passes.scale import all_scaled
from chasles.lowering.program import Op, Program, Result
from chasles.lowering.rounding import points_of, steady

MOST_STEPS = 1000
"""A program of more steps is not looked at in other spellings: that would take longer than it saves."""
CHEAPEST = 2
"""So many of the spellings have functions of an angle in lowest terms, too."""
WORK_PER_STEP = 2_000
"""Products of terms, for each step, in which another spelling is proved to be the same, or else is not taken."""
_KNOWN = {*functions_by_class(Builder()), sympy.log, sympy.Piecewise}
_LOSING = (sympy.hyper, sympy.meijerg, sympy.lerchphi)
"""What SymPy writes these in cancels where it has a limit."""
_DEPTH = 4
"""So often is looked at what comes out."""


def program_of(
    name: str, inputs: Sequence[Input], outputs: Sequence[ResultEntries], derived: DerivedResults | None = None
) -> Program:
    """The cheapest program that is proved to be the same as the expressions and loses no digits another one keeps.

    NaN where a divisor is zero. Raises `LoweringError` for what no program computes.
    """

    def spelled(outputs: Sequence[ResultEntries], *, common: bool) -> Program:
        return _program(name, inputs, outputs, derived, common=common)

    symbols = AngleSymbols()
    outputs = [
        with_fields(o, entries=tuple(without_removable(e, symbols) for e in in_known_functions(o.entries)))
        for o in outputs
    ]
    stated = spelled(outputs, common=False)
    derived = derived.patterned(stated) if derived else None
    with within(WORK_PER_STEP * len(stated.steps)):
        chosen = _chosen(stated, list(dict.fromkeys(_candidates(stated, outputs, spelled))))
    scaled = all_scaled(chosen)
    with within(WORK_PER_STEP * len(scaled.steps)):
        return guarded(scaled if scaled != chosen and equivalent(chosen, scaled) else chosen)


def _chosen(stated: Program, candidates: Sequence[Program]) -> Program:
    """The cheapest of the steadiest that are proved to be the same; after them the next steadiest are looked at."""
    points = points_of(stated)
    while True:
        ranked = sorted(steady(candidates, points, stated), key=price)
        for program in ranked:
            if program == stated or same_but_for_order(stated, program) or equivalent(stated, program):
                return program
        candidates = [program for program in candidates if program not in ranked]


def _candidates(
    stated: Program, outputs: Sequence[ResultEntries], spelled: Callable[..., Program]
) -> Iterator[Program]:
    """The expressions as written, nested, with common subexpressions; functions of an angle in lowest terms, too."""
    yield stated
    if len(stated.steps) > MOST_STEPS:
        yield spelled(outputs, common=True)
        return
    done: dict[sympy.Basic, sympy.Basic] = {}
    inner = [with_fields(output, entries=tuple(nested(entry, done) for entry in output.entries)) for output in outputs]
    programs = [stated, spelled(outputs, common=True), spelled(inner, common=False), spelled(inner, common=True)]
    yield from programs
    for program in sorted(dict.fromkeys(programs), key=price)[:CHEAPEST]:
        if program.operations[Op.SINE] + program.operations[Op.COSINE]:
            for halved in (False, True):
                with suppress(ZeroDivisionError):
                    yield pruned(respelled(program, halved=halved))


def _program(
    name: str,
    inputs: Sequence[Input],
    outputs: Sequence[ResultEntries],
    derived: DerivedResults | None,
    *,
    common: bool,
) -> Program:
    build = Builder()
    places = {
        symbol: build.input(place, entry)
        for place, item in enumerate(inputs)
        for entry, symbol in enumerate(item.symbols)
    }
    entries = [entry for output in outputs for entry in output.entries]
    spelled = common_in(entries) if common else {}
    scalars = Scalars(build, places, spelled, repeated(entries, spelled) if common else ())
    numbers = iter([scalars.of(entry) for entry in entries])
    results = [
        Result(output.name, output.shape, f"output {place}", tuple(next(numbers) for _ in output.entries))
        for place, output in enumerate(outputs, 1)
    ]
    arguments = tuple(item.argument for item in inputs)
    if derived is not None:
        results, arguments = derived.results(build, results), (*arguments, *derived.more)
    return pruned(Program(name, arguments, build.steps, tuple(results)))


def _expanded(function: Any) -> Any:
    """In other functions; those of Bessel in sums of quotients, whose limits are looked for."""
    written = sympy.expand_func(function, deep=False)
    return written.expand() if isinstance(function, sympy.jn | sympy.yn) else written


_WAYS: tuple[Callable[[Any], Any], ...] = (
    lambda function: function.rewrite(sympy.Piecewise, deep=False),
    _expanded,
    lambda function: function.rewrite(sympy.gamma, deep=False),
    lambda function: function.rewrite(sympy.atan2, deep=False),
)


def in_known_functions(expressions: Iterable[sympy.Basic]) -> list[Any]:
    """The expressions; what SymPy writes in no other functions is left."""
    found = list(expressions)
    if sympy.I in parts_of(sympy.Tuple(*found), ()):
        found = list(map(_without_i, found))
    for _ in range(_DEPTH):
        table = dict(_rewritten(outermost(found, _is_unknown)))
        if not table:
            break
        found = list(map(Substitution(table).of, found))
    return found


def _without_i(expression: Any) -> Any:
    """The expression without the imaginary unit where it drops out, as from an exponential of a rotation."""
    parts = sympy.expand_complex(expression)
    return expression if parts.has(sympy.I) else parts


def _is_unknown(node: object) -> bool:
    if isinstance(node, sympy.Contains):
        return True
    return isinstance(node, sympy.Function) and type(node) not in _KNOWN and not isinstance(node, _LOSING)


def _rewritten(functions: Iterable[Any]) -> Iterator[tuple[Any, Any]]:
    for function in functions:
        if isinstance(function, sympy.Contains):
            number, where = function.args
            if hasattr(where, "as_relational"):
                yield function, where.as_relational(number)
        elif not function.is_number:
            found = (way(function) for way in _WAYS)
            written = next((other for other in found if not other.has(type(function))), None)
            if written is not None:
                yield function, written
