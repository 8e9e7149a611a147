"""Vectors, dyadics, quaternions, lists and arrays as their components; vectors of both sides in one frame."""

from __future__ import annotations

from collections.abc import Sequence
from functools import reduce
from operator import add, mul
from sys import modules
from typing import Any

import sympy
from sympy.core.function import AppliedUndef
from sympy.core.relational import Relational
from sympy.matrices import MatrixBase
from sympy.utilities.iterables import flatten

from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.opening import excerpt
from chasles.problems.variables import Untreatable

LISTS = list, tuple, sympy.Tuple
FRAMES, SYSTEMS, QUATERNIONS = "sympy.physics.vector", "sympy.vector", "sympy.algebras.quaternion"
"""The modules of SymPy's vectors in frames, of those in coordinate systems, and of quaternions."""
JOINS = sympy.And | sympy.Or | sympy.Not | sympy.Implies | sympy.Equivalent | sympy.Xor | sympy.ITE


def in_components(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """The question on scalars and matrices that one on vectors, dyadics, quaternions, lists and arrays is.

    Coordinates of a system are real symbols: N.x is N_x. Raises `Untreatable` for frames of which nothing says how
    they are turned to each other, and for coordinates of several systems.
    """
    lhs, rhs, *conditions = said
    said = (*_pair(_as_matrix(lhs), _as_matrix(rhs)), *map(_condition, conditions))
    spoken = [*expressions_in(said)]
    coordinates = {atom for e in spoken for atom in e.atoms(*_loaded("sympy.vector.scalar", "BaseScalar"))}
    if len(systems := {atom.system for atom in coordinates}) > 1:
        raise Untreatable(f"coordinates of {_listed(systems)} occur: write all in one of them, by sympy.vector.express")
    taken = {str(symbol) for e in spoken for symbol in e.free_symbols}
    values = {atom: _symbol(str(atom).replace(".", "_"), taken) for atom in coordinates}
    return with_values(said, values) if values else said


def sides_of(relation: Any) -> tuple[Any, Any]:
    """Two sides that are equal just where a relation holds: |a - b| = a - b where a >= b, sign(a - b) = 1 where a > b.

    Raises `Untreatable` for what is no relation, or was evaluated by SymPy.
    """
    if isinstance(relation, sympy.Equality):
        return relation.lhs, relation.rhs
    if isinstance(relation, sympy.Unequality) or _joins_relations(relation):
        return _truth(relation), sympy.S.One
    if isinstance(relation, Relational) and not all(isinstance(side, sympy.Expr) for side in relation.args):
        raise Untreatable(f"{excerpt(relation)} compares what is no scalar")
    if isinstance(relation, sympy.GreaterThan | sympy.LessThan):
        difference = relation.gts - relation.lts
        return sympy.Abs(difference), difference
    if isinstance(relation, sympy.StrictGreaterThan | sympy.StrictLessThan):
        difference = relation.gts - relation.lts
        # SymPy says of a tangent that it is real, also where it has no value.
        return sympy.sign(difference, evaluate=difference.is_number), sympy.S.One
    why, instead = "no equation and no inequality", "hand in two sides"
    if relation is sympy.true or relation is sympy.false:
        why = "what SymPy has made of a relation when it was written"
        instead += ", or write the relation as Le(a, b, evaluate=False)"
    raise Untreatable(f"only one side is given, {excerpt(relation)}, which is {why}: {instead}")


def _truth(claim: Any) -> Any:
    """One where a claim is true, and zero where it is not."""
    if isinstance(claim, sympy.ITE):
        condition, *choices = claim.args
        one, other = map(_truth, choices)
        return sympy.Piecewise((one, condition), (other, True), evaluate=False)
    joined = not isinstance(claim, sympy.Unequality)  # SymPy rewrites conditions that it joins
    return sympy.Piecewise((1, claim), (0, True), evaluate=not joined)


def _joins_relations(claim: Any) -> bool:
    """Whether a claim is made of equations and inequalities between scalars by and, or, not, if, and if and only if."""
    joins = isinstance(claim, JOINS)
    parts = [part for part in claim.args if not _joins_relations(part)] if joins else [claim]
    parts = [part for part in parts if part is not sympy.true and part is not sympy.false]
    return joins and all(isinstance(p, Relational) and isinstance(p.lhs - p.rhs, sympy.Expr) for p in parts)


def _is_entire(equation: Any) -> bool:
    """Whether both sides are polynomials in symbols and functions that are defined everywhere."""
    everywhere = sympy.sin | sympy.cos | sympy.exp | AppliedUndef
    sides = (e.replace(lambda part: isinstance(part, everywhere), lambda _: sympy.Dummy()) for e in equation.args)
    return not any(e.is_Matrix for e in equation.args) and all(e.is_polynomial() for e in sides)


def is_implication(claim: Any, other: Any, given: Any) -> bool:
    """Whether a claim follows from what is said to imply it, which may be given beside what is.

    What is given holds at all times: what speaks of functions of time is no such claim.
    """
    if other is not None or not isinstance(claim, sympy.Implies) or not isinstance(given, list | tuple):
        return False
    premise = claim.args[0]
    return (isinstance(premise, Relational) or _joins_relations(premise)) and not premise.has(AppliedUndef)


def without_implication(claim: Any, given: Any) -> tuple[Any, Any]:
    """The claim that follows from what is said to imply it, and what is given then; others as they are.

    From what SymPy has seen to be false everything follows.
    """
    if isinstance(claim, sympy.Implies) and claim.args[0] is sympy.false:
        return sympy.Eq(0, 0, evaluate=False), given
    return (claim.args[1], [*given, claim.args[0]]) if is_implication(claim, None, given) else (claim, given)


def relation_of(lhs: Any, rhs: Any) -> Any:
    """The relation that is claimed: two sides that are scalars are said to be equal."""
    scalars = all(isinstance(side, int | sympy.Expr) and not getattr(side, "is_Matrix", False) for side in (lhs, rhs))
    return sympy.Eq(lhs, rhs, evaluate=False) if scalars else lhs


def claimed(lhs: Any, rhs: Any, given: Any, whole: bool = False, other: Any = None) -> Any:
    """The inequality, or what joins several relations, for which two sides stand; None for an equation as it is."""
    claim = None if rhs is not None else lhs if whole else without_implication(lhs, given)[0]
    return None if isinstance(claim, sympy.Equality) and other is None else claim


class _Unknown:
    """The class of what has no instances: of what is not imported yet."""


def _loaded(module: str, *names: str) -> tuple[Any, ...]:
    """Classes of a module, as far as it is imported."""
    return tuple(getattr(modules[module], name) for name in names) if module in modules else (_Unknown,)


def _symbol(name: str, taken: set[str]) -> Any:
    return _symbol(f"{name}_", taken) if name in taken else sympy.Symbol(name, real=True)


def _listed(frames: Any, word: str = "and") -> str:
    return f" {word} ".join(sorted(map(str, frames)))


def _as_matrix(value: Any) -> Any:
    """Lists and arrays, of SymPy's or NumPy's, as matrices, and polynomials as expressions."""
    if isinstance(value, sympy.Poly):
        if value.domain.characteristic():
            raise Untreatable(f"{excerpt(value)} is a polynomial over a finite field: the variables are real numbers")
        return value.as_expr()
    is_array = isinstance(value, sympy.NDimArray) and value.rank() < 3
    if is_array or (hasattr(value, "__array__") and not isinstance(value, sympy.Basic | MatrixBase)):
        value = value.tolist()
    if not isinstance(value, LISTS) or not value:
        return value
    if any(isinstance(entry, LISTS) for row in value if isinstance(row, LISTS) for entry in row):
        return value
    try:
        entries = [sympy.sympify(entry, strict=True) for entry in flatten(value)]
        return sympy.Matrix(value) if all(isinstance(entry, sympy.Expr) for entry in entries) else value
    except (ValueError, TypeError):
        return value


def _condition(value: Any) -> Any:
    """A condition, or several, said of components; a vector by itself is zero."""
    if isinstance(value, list | tuple | set | frozenset):
        return type(value)(map(_condition, value))
    if isinstance(value, sympy.Or) and all(isinstance(e, sympy.Equality) and _is_entire(e) for e in value.args):
        value = sympy.Mul(*(e.lhs - e.rhs for e in value.args))  # one of them vanishes, and all are defined
    elif _is_compound(value):
        value = sympy.Eq(*sides_of(value), evaluate=False)
    if isinstance(value, sympy.Equality) and isinstance(value.lhs, sympy.Expr):
        return value.func(*map(sympy.sympify, _pair(*value.args)), evaluate=False)
    return _pair(value, sympy.S.Zero)[0]


def _is_compound(condition: Any) -> bool:
    """Whether relations are joined by more than a conjunction; a case may change in time, and is given at all times."""
    parts = condition.args if isinstance(condition, sympy.And) else (condition,)
    return _joins_relations(condition) and any(map(_joins_relations, parts)) and not condition.has(AppliedUndef)


def _pair(one: Any, other: Any) -> Sequence[Any]:
    """Two sides as matrices of components, if one is a vector, a dyadic or a quaternion; zero is one of each."""
    sides = [_carried_out(side) for side in (one, other)]
    quaternions = _loaded(QUATERNIONS, "Quaternion")
    if any(isinstance(side, quaternions) for side in sides):
        return [sympy.Matrix(s.args[:4] if isinstance(s, quaternions) else [s, 0, 0, 0]) for s in sides]
    for home, frames_of, written in ((FRAMES, _frames, _in_frame), (SYSTEMS, _systems, _in_system)):
        kinds = _loaded(home, "Vector", "Dyadic")
        frames = dict.fromkeys(frame for side in sides if isinstance(side, kinds) for frame in frames_of(side))
        if len(frames) > 1 and any(isinstance(side, MatrixBase) for side in sides):
            raise Untreatable(f"a matrix does not say whether it is in {_listed(frames, 'or')}: write a vector")
        if frames:
            found = [written(s, [*frames]) if isinstance(s, kinds) and frames_of(s) else s for s in sides]
            shape = next(side.shape for side in found if isinstance(side, MatrixBase))
            is_zero = [isinstance(side, kinds) or side == 0 for side in found]
            return [sympy.zeros(*shape) if zero else side for side, zero in zip(found, is_zero, strict=True)]
        if any(isinstance(side, kinds) for side in sides):
            return [sympy.S.Zero if isinstance(side, kinds) else side for side in sides]
    return sides


def _carried_out(value: Any) -> Any:
    """The expression with products and derivatives of vectors evaluated, the inner ones first."""
    if not isinstance(value, sympy.Expr):
        return value
    operations = _loaded(SYSTEMS, "Dot", "Cross", "Gradient", "Divergence", "Curl", "Laplacian")
    value = value.replace(lambda part: isinstance(part, operations), lambda part: part.doit())
    return _combined(value) if value.atoms(*_loaded(SYSTEMS, "BaseVector", "BaseDyadic")) else value


def _combined(value: Any) -> Any:
    """A sum or a product of vectors and scalars as a vector, which SymPy leaves as a sum where parts were replaced."""
    if type(value) not in (sympy.Add, sympy.Mul):
        return value
    return reduce(add if value.is_Add else mul, map(_combined, value.args))


def _frames(value: Any) -> list[Any]:
    """The frames of a vector's measure numbers, or of a dyadic's basis vectors."""
    if isinstance(value, _loaded(FRAMES, "Vector")):
        return [frame for _, frame in value.args]
    return [frame for _, one, other in value.args for vector in (one, other) for frame in _frames(vector)]


def _in_frame(value: Any, frames: Sequence[Any]) -> Any:
    try:
        return value.to_matrix(frames[0])
    except ValueError as error:
        raise Untreatable(f"{_listed(frames)} are frames that nothing turns into each other: {error}") from None


def _systems(value: Any) -> list[Any]:
    return sorted(value.atoms(*_loaded(SYSTEMS, "CoordSys3D")), key=str)


def _in_system(value: Any, systems: Sequence[Any]) -> Any:
    """Components in the first of several systems, which have to be Cartesian."""
    from sympy.vector import express

    if len(systems) == 1:
        return value.to_matrix(systems[0])
    if any(system.lame_coefficients() != (1, 1, 1) for system in systems):
        raise Untreatable(f"of {_listed(systems)} not all are Cartesian: write both sides in one of them")
    return express(value, systems[0], variables=True).to_matrix(systems[0])
