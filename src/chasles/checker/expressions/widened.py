"""Does a certificate by cases, or of a more general question, prove what was asked?

A case puts a value in the place of a symbol: x is y + d for a positive d where x - y is positive. In a more general
question, what stands in the arguments of cosines and sines is a symbol, and so is cos(pi/n).
"""

from __future__ import annotations

import ast
import re
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial
from itertools import product
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.cases import CheckedCase
from chasles.checker.expressions.complexes import Parts
from chasles.checker.expressions.defined_functions import VALUED
from chasles.checker.expressions.enclosed import BITS, HOLDING, LARGEST_EXPONENT, EnclosedValues, vanishes
from chasles.checker.expressions.generalised import Generalised
from chasles.checker.expressions.intervals import Enclosure
from chasles.checker.expressions.needs import RELATIONS
from chasles.checker.expressions.quantities import NUMBERS, SIGNS, atoms_of, require_independent
from chasles.checker.expressions.readings import READINGS, Floor, at_integer
from chasles.checker.expressions.switches import SWITCHES, deciding
from chasles.checker.sparse import Rejected

PLAIN = re.compile(r"[A-Za-z0-9_+\-*/(), .\[\]]*")
PARTS = {
    "on", "size", "named", "remainders", "cases", "proof", "needs", "parts", "facts", "equal", "impossible", "witness",
    "defined",
}  # fmt: skip
"""What a certificate by cases, or of a more general question, may say."""
Standard = Callable[[Mapping[str, Any], Sequence[str], tuple[Any, ...]], None]
"""Checks a certificate, with what it needs, of both sides, what is given and what does not vanish."""


def check_widened(
    verdict: Any, sides: Sequence[Sequence[Any]], given: Any, nonzero: Sequence[Any], check: Standard
) -> None:
    """Raises `Rejected` unless the certificate proves the entries of both sides equal; `given` are texts and pairs."""
    needs = _Stated(verdict.needs)
    for text, _ in given:
        needs.require("the proof may use", text)
    parts = Parts()
    real, declared = parts.sides(*sides), tuple(map(parts.nonzero, nonzero))
    real = [[*side, *parts.met] for side in real]
    pairs = tuple(found for _, item in given for pair in item for found in parts.pairs(*pair))
    whole = CheckedCase(tuple(map(tuple, real)), pairs, declared)
    for ways in whole.required():
        needs.require("the question needs", *ways)
    said = tuple((symbol, symbol) for symbol in whole.named.values())  # their names are taken in all cases
    _Widened(needs, check).tree(replace(whole.each(partial(at_integer, put={})), values=said), verdict.certificate)
    if unused := needs.texts - needs.used:
        raise Rejected(f"the verdict needs {min(unused)}, of which the proof does not speak")
    _require_witness(verdict, whole)


class _Stated:
    """What a verdict says that it needs, and what of it is `used`."""

    def __init__(self, texts: Sequence[str]) -> None:
        self.texts, self.used = set(texts), set[str]()

    def __contains__(self, text: str) -> bool:
        """Whether it says this, which is used then."""
        self.used |= {text} & self.texts
        return text in self.texts

    def require(self, why: str, *ways: str) -> None:
        """Raise `Rejected` unless it says this in one of some ways."""
        found = {*ways} & self.texts
        self.used |= found
        if not found:
            raise Rejected(f"{why} {ways[0]}, and the verdict does not say so")


class _Widened:
    def __init__(self, needs: _Stated, check: Standard) -> None:
        self.needs, self.check = needs, check

    def tree(self, case: CheckedCase, node: Mapping[str, Any]) -> None:
        """A certificate of one case."""
        if unknown := node.keys() - PARTS:
            raise Rejected(f"the certificate has a part {min(unknown)!r}, which says nothing")
        if case.lost:
            self.needs.require("one of the cases is excluded by", case.lost)
            return
        if case.impossible or (case := case.settled()).impossible:
            return
        if case.undefined:
            if not any(f"{zero} != 0" in self.needs for zero in case.zeros):
                raise Rejected("something is divided by zero in one of the cases")
            return
        if "cases" not in node:
            self._leaf(case, node)
            return
        if "remainders" in node:
            parts = case.split_by_remainder(*node["remainders"])
        else:
            factors = (factor for factor in deciding(case.switches()) if str(factor) == node["on"])
            factor = next(factors, None) or plain_expression(node["on"], case.named)
            parts = case.split(factor, node["size"], "named" in node)
        for name, part in parts.items():
            self.tree(part, node["cases"][name])

    def _leaf(self, case: CheckedCase, node: Mapping[str, Any]) -> None:
        if "proof" not in node:
            raise Rejected("one of the cases is not proved")
        for ways in case.required_inside():
            self.needs.require("one of the cases needs", *ways)
        case = replace(case, pairs=(*case.pairs, *((e, sympy.S.Zero) for e in case.equations)), equations=())
        for place, side in node.get("defined", ()):
            case = without_defined(case, case.pairs[place], side)
        case = replace(case, pairs=tuple(pair for pair in case.pairs if pair))
        more = Generalised(case.spoken, int(node.get("parts", 0)), case.names)
        sides = [list(map(more, side)) for side in case.sides]
        given = [sympy.Eq(more(one), more(other), evaluate=False) for one, other in case.pairs]
        nonzero = list(map(more, case.nonzero))
        met: list[Any] = []
        while len(met) < len(more.met):
            met.append(more(more.met[len(met)]))
        moving = any(e.has(AppliedUndef) for pair in case.pairs for e in pair)
        if met and moving:
            raise Rejected("functions that are given are angles inside others")
        put = self._equal(case, more, node.get("equal", ()))
        given += [sympy.Eq(one, other, evaluate=False) for one, other in more.roots]
        for text in node.get("facts", ()):
            fact = plain_expression(text, {})
            if not vanishes(fact):
                raise Rejected(f"{text} is not known to be zero")
            given.append(sympy.Eq(more(fact), 0, evaluate=False))
        stated = list(node["needs"])
        whole = [sympy.Matrix([*side, *met]).xreplace(put) for side in sides]
        given, nonzero = ([e.xreplace(put) for e in said] for said in (given, nonzero))
        self.check(node["proof"], stated, (*whole, given, nonzero))
        own = {f"{e.lhs} = {e.rhs}" for e in given}
        for text in stated:
            if text not in own and text not in self.needs and not self._holds(case, text):
                self.needs.require("one of the cases needs", text)

    def _equal(self, case: CheckedCase, more: Generalised, said: Sequence[Any]) -> dict[Any, Any]:
        """Multiples of others that symbols are, as it is proved of what they stand for."""
        named = {str(symbol): (symbol, meaning) for meaning, symbol in more.symbols.items()}
        put = {}
        for one, multiple, other, node in said:
            (symbol, meaning), (first, known) = named[one], named[other]
            self._leaf(replace(case, sides=((meaning,), (sympy.Rational(multiple) * known,))), node)
            put[symbol] = sympy.Rational(multiple) * first
        return put

    def _holds(self, case: CheckedCase, text: str) -> bool:
        """Whether something holds throughout a case, or the verdict says it in the symbols of the question."""
        if (need := said_need(text, case.named)) is None:
            return False
        if f"{case.back(need[0])} {need[1]} 0" in self.needs:
            return True
        used = holds_throughout(case, *need, self.needs.texts)
        self.needs.used |= used or set()
        return used is not None


def said_need(text: str, names: Mapping[str, Any]) -> tuple[Any, str] | None:
    """What a need speaks of, and whether that is !=, > or >= 0; None for another."""
    relation = next((end for end in RELATIONS if text.endswith(end)), None)
    return (plain_expression(text.removesuffix(relation), names), relation.split()[0]) if relation else None


def holds_throughout(case: CheckedCase, e: Any, relation: str, needs: Iterable[str]) -> set[str] | None:
    """The need because of which it holds throughout a case, said of a positive multiple; None if that is open."""
    if case.sign(e) in HOLDING[relation]:
        return set()
    names = {**case.named, **{str(symbol): symbol for symbol, _ in case.values}}
    for text in sorted(needs):
        known = said_need(text, names)
        if known and known[1] == relation and case.sign(sympy.cancel(case.here(known[0]) / e)) == 1:
            return {text}
    return None


def without_defined(case: CheckedCase, pair: tuple[Any, Any], side: int) -> CheckedCase:
    """The case with the other side of an equation for a quantity that may have any value, and without the equation.

    Raises `Rejected` where one side of the pair is no such quantity.
    """
    atom, value = pair[side], pair[1 - side]
    if not isinstance(atom, sympy.Symbol | AppliedUndef) or len(atom.args) > 1:
        raise Rejected(f"{atom} is no quantity that an equation defines")
    moving = isinstance(atom, AppliedUndef)
    calls = () if moving else {call for e in case.spoken for call in e.atoms(AppliedUndef)}
    if value.has(type(atom) if moving else atom) or any(call.has(atom) for call in calls):
        raise Rejected(f"{atom} is not defined by {value}")
    if any(getattr(atom, f"is_{kind}") is not None for kind in (*SIGNS, *NUMBERS)):
        raise Rejected(f"{atom} may not have any value")
    pairs = tuple(() if other is pair else tuple(put(e, atom, value) for e in other) for other in case.pairs)
    sides = tuple(tuple(put(e, atom, value) for e in entries) for entries in case.sides)
    return replace(case, sides=sides, pairs=pairs, nonzero=tuple(put(e, atom, value) for e in case.nonzero))


def _without_motions(case: CheckedCase, times: set[Any]) -> CheckedCase:
    """The case with the value of every function of which something is given; raises `Rejected` if one has none."""
    require_independent(atom for e in case.spoken for atom in atoms_of(e))
    for place, side in product(range(len(case.pairs)), (0, 1)):
        pair = case.pairs[place]
        if pair and isinstance(pair[side], AppliedUndef):
            with suppress(Rejected):
                case = without_defined(case, pair, side)
    pairs = tuple(filter(None, case.pairs))
    if any(e.has(AppliedUndef) or e.free_symbols & times for pair in pairs for e in pair):
        raise Rejected("a function is given that has no value")
    return replace(case, pairs=pairs)


def put(e: Any, atom: Any, value: Any) -> Any:
    """An expression with a value for a quantity and its rates."""
    e = at_integer(e, {atom: value})
    if e.has(sympy.Derivative) and value.has(*SWITCHES, Floor, sympy.Mod):
        raise Rejected(f"{value} may have no derivative")
    return e.doit() if e.has(sympy.Derivative) else e


def plain_expression(text: str, names: Mapping[str, Any]) -> Any:
    """The expression that a text says in these names; raises `Rejected` for a text that says anything else."""
    if not PLAIN.fullmatch(text) or "__" in text or _highest(ast.parse(text.strip(), mode="eval")) > LARGEST_EXPONENT:
        raise Rejected(f"{text!r} is no plain expression")
    plain = {"floor": Floor, "gamma": lambda x: sympy.gamma(x, evaluate=not x.is_Integer)}  # nothing to work out
    return sympy.sympify(text, locals={**plain, **names})


def _highest(node: ast.AST) -> int:
    """A bound of the power to which something is raised, (x**2)**3 a sixth power; of what is not read here, none."""
    called = getattr(sympy, getattr(node.func, "id", ""), None) if isinstance(node, ast.Call) else None
    if called not in (None, sympy.sqrt, sympy.floor, *READINGS, *VALUED, *SWITCHES):
        return LARGEST_EXPONENT + 1
    if not isinstance(node, ast.BinOp) or not isinstance(node.op, ast.Pow):
        return max(map(_highest, ast.iter_child_nodes(node)), default=1)
    numbers = (int(part.value) for part in ast.walk(node.right) if isinstance(part, ast.Constant))  # type: ignore[arg-type]
    return int(_highest(node.left) * max(numbers, default=1) ** min(_highest(node.right), BITS))


def _require_witness(verdict: Any, case: CheckedCase) -> None:
    """At the witness everything has a value, what is given holds, and nothing vanishes that must not."""
    if verdict.certificate["witness"] != {name: str(value) for name, value in verdict.witness.items()}:
        raise Rejected("the verdict and its certificate have different witnesses")
    values = _values(case, verdict.witness)
    for one, other in zip(*case.sides, strict=True):
        if not values(one).meets(values(other)):
            raise Rejected("the two sides differ at the witness")
    names = case.named | {type(call).__name__: type(call) for e in case.spoken for call in e.atoms(sympy.Function)}
    for text in verdict.needs:
        if (need := said_need(text, names)) and values(need[0]).sign not in (None, *HOLDING[need[1]]):
            raise Rejected(f"{text} is needed, and not so at the witness")


def check_enclosed(
    at: Mapping[str, Any], place: int, said: Sequence[str], sides: Any, given: Any, nonzero: Sequence[Any]
) -> None:
    """Raises `Rejected` unless the point satisfies everything, and the entries in a place differ and are as said."""
    pairs = tuple(pair for _, item in given for pair in item)
    case = CheckedCase(tuple(map(tuple, sides)), pairs, tuple(nonzero))
    if times := {t for pair in pairs for e in pair for call in e.atoms(AppliedUndef) for t in call.args}:
        case = _without_motions(case, times)
        if unknown := at.keys() - {str(atom) for e in case.spoken for atom in atoms_of(e)}:
            raise Rejected(f"a value is told for {min(unknown)}, which follows from others")
    values = _values(case, at)
    spoken = {e: _parts(values, e) for e in case.spoken}
    one, other = (spoken[side[place]] for side in case.sides)
    for text, value in zip(said, (one, other), strict=True):
        if not all(map(Enclosure.meets, value, _parts(values, plain_expression(text, {})))):
            raise Rejected(f"a side is not {text} at the point")
    if all(map(Enclosure.meets, one, other)):
        raise Rejected("the two sides are not seen to differ at the point")


def _parts(values: EnclosedValues, e: Any) -> tuple[Enclosure, Enclosure]:
    """What holds the real and the imaginary part."""
    real, imaginary = e.xreplace(values.point).expand().as_real_imag() if e.has(sympy.I) else (e, sympy.S.Zero)
    return values(real), values(imaginary)


def _values(case: CheckedCase, at: Mapping[str, Any]) -> EnclosedValues:
    """The values at a point that the symbols may have, and at which what is given holds."""
    point: dict[Any, Any] = {}
    atoms = {atom for e in case.spoken for atom in atoms_of(e)}
    require_independent(atoms)
    for atom in atoms:
        if str(atom) not in at:
            raise Rejected(f"no value is given for {atom}")
        point[atom] = sympy.sympify(at[str(atom)], strict=True)
    values = EnclosedValues(point)
    for atom, value in point.items():
        sign = value if value.is_Rational else sympy.Integer(values.sign(value))
        kinds = {**dict.fromkeys(SIGNS, sign), **dict.fromkeys(NUMBERS, value)}
        if any(getattr(atom, f"is_{kind}") not in (None, getattr(e, f"is_{kind}")) for kind, e in kinds.items()):
            raise Rejected(f"{atom} cannot be {value}")
    if any(values.sign(one - other) for one, other in case.pairs) or any(values.sign(e) == 0 for e in case.nonzero):
        raise Rejected("the point does not satisfy the side conditions")
    return values
