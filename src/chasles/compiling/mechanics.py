"""What do methods of `sympy.physics.mechanics` compute? Mass matrix and forcing, and the accelerations they come to.

The matrix M of M a = f is symmetric, and positive definite where every motion has kinetic energy, as long as there are
no constraints: of Lagrange's equations as a matrix of second derivatives, of Kane's by partial velocities (Kane and
Levinson, Dynamics, 1985, section 4.11). With constraints it is neither, and rows are exchanged where that is needed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import count
from math import prod
from typing import Any

import sympy
from sympy.physics.mechanics import KanesMethod, LagrangesMethod, dynamicsymbols

from chasles.compiling.derived import derived_from
from chasles.compiling.elimination import solved, solved_definite
from chasles.compiling.inputs import inputs_of
from chasles.compiling.program_of import program_of
from chasles.compiling.recall import key_of
from chasles.compiling.results import outputs_of
from chasles.compiling.variables import Substitution, variables_of
from chasles.lowering.arithmetic import decimals, run
from chasles.lowering.builder import Builder
from chasles.lowering.passes.prune import pruned
from chasles.lowering.program import Program, Result
from chasles.lowering.refusal import LoweringError

OFFERED = {
    "mass_matrix": "M of M a = f, as SymPy has it",
    "forcing": "f of M a = f",
    "accelerations": "the rates of the speeds, or of the rates of the coordinates",
    "state_rates": "the rates of the coordinates, then the accelerations",
    "multipliers": "Lagrange's multipliers, as SymPy signs them",
}
USUAL = ("mass_matrix", "forcing", "accelerations")
DIGITS, AGREEING = 60, Fraction(1, 10**40)
"""Entries are taken for the same where so much of them agrees at a point without a pattern."""


@dataclass(frozen=True, slots=True)
class EquationsOfMotion:
    """The rates of the coordinates, and linear equations for the accelerations and multipliers."""

    coordinates: tuple[sympy.Expr, ...]
    speeds: tuple[sympy.Expr, ...]
    rates: tuple[sympy.Expr, ...]
    matrix: sympy.MatrixBase
    right: sympy.MatrixBase
    rows: int
    """So many of the equations are dynamic ones; what follows are constraints of Lagrange's method."""
    constrained: bool


def program_of_method(
    name: str, method: Any, inputs: Any, outputs: Any, **options: Any
) -> tuple[str, Callable[[], Program]]:
    """The program of a method whose equations are formed, for the results that `outputs` names, and their derivatives.

    It is made when it is called for; all that it depends on is in the key. The options are those of `derived_from`.
    Raises `LoweringError` where there are no equations yet, and for results that are not offered.
    """
    equations = _equations(method)
    wanted = (outputs,) if isinstance(outputs, str) else USUAL if outputs is None else tuple(outputs)
    offered = [each for each in OFFERED if each != "multipliers" or len(equations.right) > len(equations.speeds)]
    if not wanted or len(set(wanted)) < len(wanted) or not set(wanted) <= set(offered):
        raise LoweringError(f"outputs of {type(method).__name__} are some of {', '.join(offered)}; not {outputs!r}")
    parts = [equations.matrix, equations.right, sympy.Matrix(equations.rates)]
    given = inputs_of(dict(_groups(equations, parts)) if inputs is None else inputs)
    stated_results = outputs_of(parts, given, None)

    def made() -> Program:
        stated = program_of(name, given, stated_results)
        build, results = _finished(stated, equations, wanted)
        derived = derived_from(given, results, **options)
        results = derived.results(build, results)
        return pruned(Program(name, (*stated.arguments, *derived.more), build.steps, tuple(results)))

    entries = (entry for result in stated_results for entry in result.entries)
    sizes = equations.rows, len(equations.speeds), equations.constrained
    return key_of(entries, name, [item.identity for item in given], wanted, sizes, sorted(options.items())), made


def _equations(method: Any) -> EquationsOfMotion:
    formed = method
    if not isinstance(formed, KanesMethod | LagrangesMethod):
        formed = getattr(method, "eom_method", None) or getattr(method, "method", None)
    if not isinstance(formed, KanesMethod | LagrangesMethod):
        said = "yet: call its form_eoms() first" if hasattr(method, "form_eoms") else "to compile"
        raise LoweringError(f"{type(method).__name__} has no equations of motion {said}")
    try:
        mass, matrix, right = formed.mass_matrix, formed.mass_matrix, formed.forcing
    except ValueError:
        how = "kanes_equations(...)" if isinstance(formed, KanesMethod) else "form_lagranges_equations()"
        raise LoweringError(f"{type(method).__name__} has no equations of motion yet: call its {how} first") from None
    coordinates, speeds = tuple(formed.q), tuple(formed.u)
    if isinstance(formed, LagrangesMethod):
        size, rates, known = len(coordinates), speeds, {}
        matrix, right = formed.mass_matrix_full[size:, size:], formed.forcing_full[size:, :]
        constrained = len(right) > size
    else:
        known = formed.kindiffdict()
        rates = tuple(known.get(each.diff(dynamicsymbols._t), each.diff(dynamicsymbols._t)) for each in coordinates)
        constrained = len(formed._k_dnh) > 0
    standing = Substitution(known)
    matrix, right = (each.applyfunc(standing.of) if _occurs(known, each) else each for each in (matrix, right))
    return EquationsOfMotion(coordinates, speeds, rates, matrix, right, mass.rows, constrained)


def _occurs(known: Mapping[sympy.Expr, sympy.Expr], matrix: sympy.MatrixBase) -> bool:
    seen: set[sympy.Basic] = set()
    return any(variable in known for entry in matrix for variable in variables_of(entry, (), seen))


def _groups(
    equations: EquationsOfMotion, parts: Sequence[sympy.MatrixBase]
) -> Iterator[tuple[str, Sequence[sympy.Expr]]]:
    """The inputs, by name: coordinates, speeds, the other functions of time, and what does not change, by name."""
    yield "q", equations.coordinates
    yield "u", equations.speeds
    own = {*equations.coordinates, *equations.speeds}
    seen: set[sympy.Basic] = set()
    found = [variable for part in parts for entry in part for variable in variables_of(entry, own, seen)]
    others = sorted(set(found) - own, key=str)
    moving = [each for each in others if not isinstance(each, sympy.Symbol)]
    fixed = [each for each in others if isinstance(each, sympy.Symbol) and each != dynamicsymbols._t]
    yield from ((name, group) for name, group in (("specified", moving), ("parameters", fixed)) if group)
    if dynamicsymbols._t in found:
        yield "t", (dynamicsymbols._t,)


def _finished(stated: Program, equations: EquationsOfMotion, wanted: Sequence[str]) -> tuple[Builder, list[Result]]:
    """The steps of a program, the equations solved after what it computes, and the results."""
    build = Builder()
    place: list[int] = []
    for step in stated.steps:
        place.append(build.like(step, [place[k] for k in step.operands]))
    matrix, right, rates = ([place[k] for k in result.entries] for result in stated.results)
    size = len(right)
    rows = [matrix[k * size : (k + 1) * size] for k in range(size)]
    moving = len(equations.speeds)
    results = {"mass_matrix": matrix[: equations.rows * size], "forcing": right[: equations.rows]}
    if not set(wanted) <= set(results):
        definite = not equations.constrained and _is_symmetric(stated, size)
        columns = [[each] for each in right]
        unknowns = solved_definite(build, rows, right) if definite else [x for [x] in solved(build, rows, columns)]
        results["accelerations"] = unknowns[:moving]
        results["state_rates"] = [*rates, *unknowns[:moving]]
        results["multipliers"] = [build.negate(each) for each in unknowns[moving:]]
    shapes = {"mass_matrix": (equations.rows, size)}
    return build, [
        Result(
            each,
            tuple(extent for extent in shapes.get(each, (len(results[each]),)) if extent > 1),
            OFFERED[each],
            tuple(results[each]),
        )
        for each in wanted
    ]


def _is_symmetric(program: Program, size: int) -> bool:
    """Whether the matrix, the program's first result, agrees with its transpose in many digits at a point."""
    arithmetic = decimals(DIGITS)
    values = (arithmetic.sine(arithmetic.constant(Fraction(place**2))) + 2 for place in count(1))
    point = [[next(values) for _ in range(prod(argument.shape))] for argument in program.arguments]
    entries = run(program, point, arithmetic)[0]
    largest = arithmetic.constant(AGREEING) * max(map(abs, entries))
    pairs = ((entries[i * size + j], entries[j * size + i]) for i in range(size) for j in range(i))
    # A comparison with NaN does not hold.
    return all(abs(one - other) <= largest for one, other in pairs)
