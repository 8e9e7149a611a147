"""What was handed in, as it is read: by its sides and parts, without inequalities, in one or two ways.

`prove` and `recheck` read alike, and believe of a verdict only what is possible.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any

import sympy
from sympy.concrete.expr_with_limits import ExprWithLimits
from sympy.core.function import Application, AppliedUndef
from sympy.logic.boolalg import Boolean
from sympy.matrices import MatrixExpr

from chasles.checker.expressions.quantities import is_atom
from chasles.checker.sparse import Rejected
from chasles.from_sympy.bounded_symbols import COMPARED, Said
from chasles.from_sympy.calls import Calls, value_of
from chasles.from_sympy.complex_symbols import by_parts, expressions_in
from chasles.from_sympy.components import in_components, relation_of, sides_of, without_implication
from chasles.from_sympy.decimals import as_decimals, each_replaced
from chasles.from_sympy.domains import also_defined, cancelled, lost_in
from chasles.from_sympy.induction import stepwise
from chasles.from_sympy.inequalities import without_inequalities
from chasles.from_sympy.integrals import without_integrals
from chasles.from_sympy.opening import atoms_of, excerpt
from chasles.from_sympy.side_conditions import listed
from chasles.from_sympy.unknown_integrands import is_tied, without_unknown_integrands
from chasles.problems.variables import Untreatable
from chasles.verdict import Fails, Holds, HoldsUnder, Verdict

Other = Callable[[Any], Any]
"""A claim in other words."""
SMOOTH = sympy.sin | sympy.cos | sympy.exp | AppliedUndef


def as_said(exact: bool, *said: Any, whole: bool = False, other: Other | None = None) -> tuple[Any, ...]:
    """What was said: iterators written out, a relation by its sides, vectors and complex symbols by their parts.

    What an implication assumes is given, unless the `whole` of it is a claim. An inequality is said in `other` words.
    Raises `Untreatable` for a symbol that is infinite, also where it would cancel: inf + 1 > inf is false.
    """
    said = tuple(tuple(each) if isinstance(each, Iterator) else each for each in said)
    symbols = {atom for e in expressions_in(said) for atom in getattr(e, "free_symbols", ())}
    if infinite := sorted(str(atom) for atom in symbols if getattr(atom, "is_infinite", False)):
        raise Untreatable(f"{infinite[0]} is infinite: the variables are real numbers")
    lhs, rhs, *conditions = said
    stated = isinstance(lhs, Boolean) and not isinstance(lhs, sympy.Symbol)
    rhs = None if stated and (rhs is True or rhs is sympy.true) else rhs
    lhs, rhs = (relation_of(lhs, rhs), None) if other else (lhs, rhs)
    if rhs is None and not whole:
        lhs, conditions[0] = without_implication(lhs, conditions[0])
    claim = other(lhs) if other else lhs
    if other and isinstance(claim, sympy.Implies):  # that something has a name implies the claim
        conditions[0] = [item for _, item in listed(conditions[0], "given")]
        require_new(claim.free_symbols - lhs.free_symbols, conditions)
        lhs, conditions[0] = without_implication(claim, conditions[0])
        claim = lhs
    both = isinstance(lhs, COMPARED) and isinstance(claim, COMPARED)
    lost = cancelled(lhs, claim) if rhs is None and both else []
    lhs, rhs = sides_of(claim) if rhs is None else (lhs, rhs)
    lhs, *others = in_components((also_defined(lhs, lost), rhs, *conditions))
    said = without_points((also_defined(lhs, lost_in(expressions_in([lhs, *others]))), *others))
    return by_parts(without_unknown_integrands(tuple(map(as_decimals, said)) if exact else said))


def require_new(symbols: Iterable[Any], said: Any) -> None:
    """Raise `Untreatable` if something that is said speaks of symbols that are to be new."""
    spoken = {str(symbol) for e in expressions_in(said) for symbol in getattr(e, "free_symbols", ())}
    if taken := sorted(spoken & {*map(str, symbols)}):
        raise Untreatable(f"{taken[0]} is a symbol of the question")


def readings_of(said: Said, counted: bool = False) -> Iterator[Said]:
    """The question with equations for inequalities, in one to three ways; those alone with what may be `counted`."""
    plain = without_integrals(said)
    yield from _as_counted(first := without_inequalities(plain), counted)
    if first is not plain and (other := without_inequalities(plain, by_excess=True)) != first:
        yield from _as_counted(other, counted)
        if (by_sine := without_inequalities(plain, by_sine=True)) not in (first, other):
            yield from _as_counted(by_sine, counted)


def _as_counted(asked: Said, counted: bool) -> Iterator[Said]:
    said = stepwise(asked) if counted else asked
    if said is not None:
        yield said


def possible_verdict(decide: Callable[..., Verdict], asked: Said, calls: Calls) -> Verdict:
    """The verdict; a counterexample with several values of a function is looked for where its arguments differ.

    Raises `Rejected` for what is not possible.
    """
    require_no_imaginary(calls.said, asked)
    verdict = decide(*asked)
    try:
        require_possible(verdict, calls)
    except Rejected:
        apart = calls.apart() if isinstance(verdict, Fails) else []
        nonzero = [*(item for _, item in listed(asked[3], "nonzero")), *apart]
        verdict = decide(*asked[:3], nonzero) if apart else verdict
        if not apart or not isinstance(verdict, Fails):
            raise
        require_possible(verdict, calls)
    return verdict


def require_possible(verdict: Verdict, calls: Calls) -> None:
    """Raise `Rejected` unless functions may have the values that a verdict tells, and sides are real at its witness."""
    match verdict:
        case Fails(found):
            if is_tied((value.function for value in calls.read.values()), calls.given):
                raise Rejected("an integral or a sum of functions that are not known may not have any value")
            calls.require_free(found.at)
        case Holds() | HoldsUnder():
            calls.require_apart(verdict.witness or {})
            _require_real(calls.said, verdict.witness or {})


def require_no_imaginary(said: Said, asked: Said) -> None:
    """Raise `Rejected` where what is given makes what is asked imaginary: SymPy writes sqrt(-y) so, given y >= 0."""
    if any(e.has(sympy.I) for e in expressions_in(said)):
        return
    for e in expressions_in(asked[:2]):
        if e.has(sympy.I) and e.replace(sympy.Piecewise, lambda *_: sympy.S.Zero).has(sympy.I):
            raise Rejected(f"{excerpt(e)} is not real where what is given holds")


def _require_real(said: Said, witness: Mapping[str, Any]) -> None:
    """Raise `Rejected` where a side is not real at a point, though nothing that is asked is complex."""
    if not witness or any(e.has(sympy.I) for e in expressions_in(said)):
        return
    for e in expressions_in(said[:2]):
        atoms = [*atoms_of(e)]
        binds = e.has(sympy.Subs, ExprWithLimits) or any(not is_atom(rate) for rate in e.atoms(sympy.Derivative))
        if isinstance(e, MatrixExpr) or binds or any(str(atom) not in witness for atom in atoms):
            continue
        if e.xreplace({atom: sympy.sympify(str(witness[str(atom)])) for atom in atoms}).is_real is False:
            raise Rejected(f"{excerpt(e)} is not real where what is given holds")


def without_points(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """What was said, with values put in; raises `Untreatable` where SymPy might cancel what a divisor is, or a kink."""
    if not any(e.has(sympy.Subs) for e in expressions_in(said)):
        return said
    return tuple(each_replaced(each, lambda e: {part: _put(part) for part in e.atoms(sympy.Subs)}) for each in said)


def _put(e: Any) -> Any:
    """The value of what is smooth; of other expressions, the same with other names; a function's value is as it is."""
    if value_of(e) is not None:
        return e
    parts = sympy.Tuple(e.expr, *e.point).atoms(sympy.Pow, Application)
    if all(isinstance(part, SMOOTH) or (part.is_Pow and part.exp.is_Integer and part.exp > 0) for part in parts):
        return e.doit()
    if all(value.is_Symbol for value in e.point) and not {*e.point} & e.expr.free_symbols:
        named = e.expr.xreplace(dict(zip(e.variables, e.point, strict=True)))
        if named.xreplace(dict(zip(e.point, e.variables, strict=True))) == e.expr:
            return named
    raise Untreatable(f"{excerpt(e)} is not treated: what it divides by may cancel, or it may have no derivative there")
