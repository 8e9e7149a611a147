"""Questions with inequalities as they were asked, and theorems that say them so.

What stands for inequalities in a question of `prove` has values, which a proof puts in.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.asked import Asked, listed
from chasles.checker.expressions.quantities import is_atom
from chasles.coq.expressions import Unsaid
from chasles.coq.of_sympy import ScalarStatement, SympyStatement, in_entries, in_parts, term_by_term
from chasles.coq.sentences import asserted, introduced
from chasles.coq.sympy_words import SAID, SympyWords
from chasles.from_sympy.bounded_symbols import COMPARED, STRICT, Said
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.inequalities import signed, without_inequalities
from chasles.statements import Hypothesis, Problem

Values = dict[Any, Any]
"""What atoms of a question are said by."""
SETTLED = (
    "first [assumption | lra | repeat match goal with H : context [Rabs ?x] |- _ => revert H; unfold Rabs; "
    "destruct (Rcase_abs x); intros end; "
    "first [lra | above | nonnegative | not_zero_known | field; repeat split; intro; lra]]"
)
"""The step by which what is put in is what is assumed of it."""


@dataclass(frozen=True, slots=True)
class OwnQuestion:
    """A question with its own sides and equations, beside those that `stand` for its inequalities `compared`.

    The former are first, as `prove` has them. By `values` its symbols and functions are said; `spelled` are the
    equations as the verdict spells them.
    """

    asked: Asked
    values: Values = field(default_factory=dict)
    spelled: frozenset[str] = frozenset()
    compared: tuple[Any, ...] = ()
    stand: tuple[Any, ...] = ()


def as_asked(said: Said) -> OwnQuestion:
    """The question as it was asked. Raises `Unsaid` for functions that are said by others, or by none."""
    for e in expressions_in(said):
        functions = {part.func for part in e.atoms(sympy.Function) if not isinstance(part, AppliedUndef)}
        if unsaid := sorted(functions - SAID, key=str):
            raise Unsaid(f"{unsaid[0]} is no word of the theories")
    said = tuple(map(term_by_term, said))
    told = without_inequalities(said)
    if told is said:
        return OwnQuestion(in_parts(Asked(*map(in_entries, said))))
    items = [item for _, item in listed(said[2], "given")]
    stated = [item for item in items if not isinstance(item, (*COMPARED, sympy.Ne)) and item is not sympy.true]
    new = told[2][: max(0, len(told[2]) - len(stated))]
    asked = Asked(*map(in_entries, (*said[:2], [*new, *stated], told[3])))
    spelled = frozenset(item.text for item in Asked(*map(in_entries, told)).given)
    compared = tuple(item for item in items if isinstance(item, COMPARED))
    return OwnQuestion(in_parts(asked), _values(said, told, new, compared), spelled, compared, tuple(new))


def _values(said: Said, told: Said, new: list[Any], compared: Iterable[Any]) -> Values:
    """By what each atom is said, if not by itself: its definition, or one of the same name that has a sign."""
    rest = set(_atoms((*told[:2], told[2][len(new) :], told[3])))
    equations = (item for item in new if isinstance(item, sympy.Equality))
    defined = {item.lhs: item.rhs for item in equations if is_atom(item.lhs) and item.lhs not in rest}
    # SymPy may have evaluated what is told, so that no symbol is left of it.
    named = {str(atom): other for item in compared for atom, other in signed(item).items()}
    named |= {str(atom): atom for atom in _atoms(told)}
    apart = {atom: named[str(atom)] for atom in _atoms(said) if named.get(str(atom), atom) != atom}
    return {**defined, **{atom: defined.get(other, other) for atom, other in apart.items()}}


def _atoms(said: Any) -> Iterator[Any]:
    for e in expressions_in(said):
        yield from e.atoms(sympy.Symbol, AppliedUndef)


class OwnInequalities(SympyStatement):
    """A statement with the inequalities of the question, in place of the symbols and equations that stand for them.

    Raises ValueError where the symbols are not seen to be said by the question's, and for what moves.
    """

    def __init__(self, plain: ScalarStatement, compared: Iterable[Any], stand: Sequence[Any]) -> None:
        if plain.timed or any(atom.is_integer for item in compared for atom in item.free_symbols):
            raise ValueError("what is compared moves, or is a whole number")
        self._plain = plain
        spoken = {str(s) for item in compared for s in item.free_symbols}
        self._values = _solved(stand, {s for e in stand for s in e.free_symbols if str(s) not in spoken})
        words = plain.words
        new = {words.atoms[symbol] for symbol in self._values}
        of_given = zip(plain.given, plain.problem.conditions, strict=True)
        hypotheses = [_assumed(words, each) for each in compared]
        hypotheses += [each for each in plain.problem.hypotheses if each.subjects[0] not in new and self._stays(each)]
        conditions = tuple(goal for ((count, *_), _), goal in of_given if count >= len(stand))
        problem = Problem(plain.problem.goals, conditions=conditions, hypotheses=tuple(dict.fromkeys(hypotheses)))
        super().__init__(words, problem, plain)

    def _stays(self, assumed: Hypothesis) -> bool:
        """Whether something is still assumed: what is seen of the signs of new symbols is not."""
        value = self._plain.assumed.get(assumed, sympy.S.One)
        if not value.free_symbols & self._values.keys():
            return True
        if not value.is_nonzero:
            raise ValueError(f"{value} is not seen to be other than zero")
        return False

    def steps(self, plain: Iterable[str]) -> Iterator[str]:
        """The steps, with those that show it of what stands for the inequalities."""
        yield from asserted("plain'", self._plain, plain)
        yield f"intros {introduced(self)}."
        values = {self._plain.names.symbols[self._plain.words.atoms[d]]: v for d, v in self._values.items()}  # type: ignore[index]
        given = (f"({self._plain.side(values[name])})" if name in values else name for name, _ in self._plain.binders)
        yield f"repeat apply conj; apply (plain' {' '.join(given)}); {SETTLED}."


def _assumed(words: SympyWords, item: Any) -> Hypothesis:
    """An inequality; of what is compared with zero, the sign."""
    strict = isinstance(item, STRICT)
    if item.lts.is_zero:
        return Hypothesis("positive" if strict else "nonnegative", (words(item.gts),))
    if item.gts.is_zero:
        return Hypothesis("negative" if strict else "nonpositive", (words(item.lts),))
    return Hypothesis("less" if strict else "at most", (words(item.lts), words(item.gts)))


def _solved(stand: Sequence[Any], new: set[Any]) -> dict[Any, Any]:
    """The new symbols, each said by what is not new, one equation after the other: by one that is of degree 1."""
    values: dict[Any, Any] = {}
    waiting = list(stand)
    while waiting:
        for equation in waiting:
            above = sympy.fraction(sympy.together((equation.lhs - equation.rhs).subs(values)))[0]
            unknown = above.free_symbols & new
            if len(unknown) == 1 and above.is_polynomial(*unknown) and sympy.degree(above, *unknown) == 1:
                break
        else:
            raise ValueError("a symbol stands for an inequality by an equation of a higher degree")
        (symbol,) = unknown
        slope, rest = sympy.Poly(above, symbol).all_coeffs()
        below = sympy.factor(sympy.together(slope.subs(equation.lhs, equation.rhs)))
        values[symbol] = -rest / slope if below.is_positive else sympy.expand(rest) / sympy.expand(-slope)
        waiting.remove(equation)
    if missing := new - values.keys():
        raise ValueError(f"nothing says {missing.pop()}")
    return values
