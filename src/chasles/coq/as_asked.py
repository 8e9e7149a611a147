"""Questions with inequalities as they were asked, and what `prove` says their symbols by."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from typing import Any

import sympy
from sympy.core.function import AppliedUndef

from chasles.checker.expressions.asked import Asked, listed
from chasles.checker.expressions.quantities import is_atom
from chasles.coq.of_sympy import in_entries, in_parts
from chasles.from_sympy.complex_symbols import expressions_in
from chasles.from_sympy.inequalities import COMPARED, Said, without_inequalities

Values = dict[Any, Any]
"""What atoms of a question are said by."""


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
    """The question as it was asked."""
    told = without_inequalities(said)
    if told is said:
        return OwnQuestion(in_parts(Asked(*map(in_entries, said))))
    items = [item for _, item in listed(said[2], "given")]
    stated = [item for item in items if not isinstance(item, (*COMPARED, sympy.Ne)) and item is not sympy.true]
    new = told[2][: max(0, len(told[2]) - len(stated))]
    asked = Asked(*map(in_entries, (*said[:2], [*new, *stated], told[3])))
    spelled = frozenset(item.text for item in Asked(*map(in_entries, told)).given)
    compared = tuple(item for item in items if isinstance(item, COMPARED))
    return OwnQuestion(in_parts(asked), _values(said, told, new), spelled, compared, tuple(new))


def _values(said: Said, told: Said, new: list[Any]) -> Values:
    """By what each atom is said, if not by itself: its definition, or one of the same name that has a sign."""
    rest = set(_atoms((*told[:2], told[2][len(new) :], told[3])))
    equations = (item for item in new if isinstance(item, sympy.Equality))
    defined = {item.lhs: item.rhs for item in equations if is_atom(item.lhs) and item.lhs not in rest}
    named = {str(atom): atom for atom in _atoms(told)}
    signed = {atom: named[str(atom)] for atom in _atoms(said) if named.get(str(atom), atom) != atom}
    return {**defined, **{atom: defined.get(other, other) for atom, other in signed.items()}}


def _atoms(said: Any) -> Iterator[Any]:
    for e in expressions_in(said):
        yield from e.atoms(sympy.Symbol, AppliedUndef)
