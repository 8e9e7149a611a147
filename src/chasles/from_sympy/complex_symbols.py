"""Symbols that are complex numbers, by real ones for their parts: z is re_z + I*im_z."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import pairwise
from typing import Any

import sympy
from sympy.combinatorics import Permutation
from sympy.matrices import MatrixBase

from chasles.checker.expressions.complexes import OF_COMPLEX
from chasles.from_sympy.decimals import with_values
from chasles.from_sympy.opening import atoms_of
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
