"""Symbols that are complex numbers, by real ones for their parts: z is re_z + I*im_z."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from itertools import pairwise
from typing import Any

import sympy
from sympy.combinatorics import Permutation
from sympy.matrices import MatrixBase

from chasles.checker.expressions.asked import valued
from chasles.checker.expressions.complexes import OF_COMPLEX, Pair, Parts
from chasles.checker.expressions.unevaluated import hidden_in
from chasles.checker.sparse import Rejected
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.opening import Entries, atoms_of, written
from chasles.problems.variables import Untreatable

ANY_COMPLEX = sympy.Symbol("z", complex=True).assumptions0
"""What SymPy knows of a symbol that may have any complex value; of others, parts do not keep all that it knows."""


def by_parts(said: tuple[Any, ...]) -> tuple[Any, ...]:
    """What is said, with the parts of complex symbols as real symbols.

    Raises `Untreatable` for two symbols that are called the same, whose parts would be.
    """
    spoken = list(expressions_in(said))
    found = {z for e in spoken for z in e.atoms(sympy.Symbol) if z.assumptions0 == ANY_COMPLEX}
    if not found:
        return said
    names = sorted(map(str, found))
    if same := next((one for one, other in pairwise(names) if one == other), None):
        raise Untreatable(f"two different symbols are both called {same}: rename one")
    taken = {str(z) for e in spoken for z in e.free_symbols}
    values = {z: _parts(z, taken) for z in found}
    return with_values(said, values)


def taken_as_real(said: tuple[Any, ...]) -> tuple[str, ...]:
    """What is read as real though nothing says so, where a conjugate or a part of it is taken."""
    calls = {call for e in expressions_in(said) for call in e.atoms(*OF_COMPLEX)}
    return tuple(sorted({f"{atom} is real" for call in calls for atom in atoms_of(call) if atom.is_real is None}))


def _parts(z: Any, taken: set[str]) -> Any:
    names = [f"{part}_{z}" for part in ("re", "im")]
    while taken & {*names}:
        names = [f"{name}_" for name in names]
    re, im = (sympy.Symbol(name, real=True) for name in names)
    return re + sympy.I * im


def expressions_in(value: Any) -> Iterator[Any]:
    """All SymPy expressions in lists, mappings and matrices."""
    if isinstance(value, list | tuple | MatrixBase):
        for item in value:
            yield from expressions_in(item)
    elif isinstance(value, Mapping):
        yield from expressions_in([*value.keys(), *value.values()])
    elif isinstance(value, sympy.Basic) and not isinstance(value, Permutation):  # its `atoms` are integers
        yield value


class RealParts(Parts):
    """Splits what a question speaks of into real and imaginary parts; raises `Untreatable` where it cannot."""

    def equal(self, left: Entries, right: Entries) -> tuple[Entries, Entries]:
        """Two sides that are equal where the given ones are: imaginary parts, if there are any, are further rows."""
        found = self.sides(*([e for row in side.rows for e in row] for side in (left, right)))
        one, other = (in_rows(entries, side) for entries, side in zip(found, (left, right), strict=True))
        return one, other

    def require(self, said: Any) -> None:
        """What is cancelled where something is written out has to be defined, too."""
        for e in expressions_in(said):
            self.met |= {part: None for hidden in written(hidden_in, e) for part in self.of(written(valued, hidden))}

    def of(self, expression: Any) -> Pair:
        """The parts of what is read as a whole."""
        try:
            return super().of(expression)
        except Rejected as reason:
            raise Untreatable(str(reason)) from None


def in_rows(entries: Sequence[Any], like: Entries) -> Entries:
    """The entries row by row, in as many columns as others."""
    width = like.shape[1]
    return Entries(tuple(tuple(entries[k : k + width]) for k in range(0, len(entries), width)), like.is_matrix)
