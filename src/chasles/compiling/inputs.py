"""What goes in? Arrays of real numbers, each entry a symbol of its own."""

from __future__ import annotations

import re
from collections.abc import Iterable, KeysView, Mapping, Sequence, Set
from dataclasses import dataclass
from itertools import product
from keyword import iskeyword
from math import prod
from typing import Any

import sympy
from sympy.core.function import UndefinedFunction

from chasles.compiling.identifiers import name_of_group
from chasles.compiling.inverses import explicit
from chasles.compiling.scalars import shown
from chasles.compiling.variables import is_variable
from chasles.kernels.signatures import OPTIONS
from chasles.lowering.names import Names
from chasles.lowering.program import MOST_ENTRIES, Argument
from chasles.lowering.refusal import LoweringError

PLAIN = re.compile(r"[\w\[\](), .+-]+", re.ASCII)
"""What may be written in a comment of any language."""
TAKEN = ("best_level", "block", "data", "entry", "loop", "run", "shape")


@dataclass(frozen=True, slots=True)
class Input:
    """An input: its name and core shape, the user's variables for its entries, row-major, and real symbols for them."""

    argument: Argument
    entries: tuple[sympy.Expr, ...]
    symbols: tuple[sympy.Symbol, ...]
    whole: sympy.MatrixSymbol | None = None

    @property
    def identity(self) -> tuple[Argument, list[str]]:
        """What a program depends on: the argument, and the names of the symbols."""
        return self.argument, [symbol.name for symbol in self.symbols]


def inputs_of(given: Any) -> tuple[Input, ...]:
    """The inputs, in the order given.

    Raises `LoweringError` for what is no variable, and for a variable that comes twice.
    """
    if isinstance(given, sympy.Basic | sympy.MatrixBase):
        given = (given,)
    if given is None:
        raise LoweringError("inputs is missing: name the symbols that go in, as in compile(x*y, [x, y])")
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise LoweringError(f"inputs must be symbols, not {given!r}")
    require_order(given, "inputs")
    names, symbols = Names(OPTIONS), Names(())
    met: set[sympy.Basic] = set()
    found: list[Input] = []
    if isinstance(given, Mapping) and not all(isinstance(name, str) for name in given):
        raise LoweringError(
            f"inputs maps {next(name for name in given if not isinstance(name, str))}, which is no name"
        )
    for number, item in enumerate(given.items() if isinstance(given, Mapping) else given, 1):
        wanted, entries, shape, whole = _read(item)
        require_room(len(met) + len(entries))
        for entry in entries:
            if entry in met:
                raise LoweringError(f"{entry} comes twice among the inputs: every entry needs a symbol of its own")
            met.add(entry)
        name = names.take(wanted or (str(whole.name) if whole else "") or name_of_group(entries) or f"input_{number}")
        standing = tuple(sympy.Symbol(symbols.take(str(entry)), real=True) for entry in entries)
        found.append(Input(Argument(name, shape, _meaning(name, shape, entries, whole)), entries, standing, whole))
    if not found:
        raise LoweringError("inputs is empty: name at least one symbol")
    return tuple(found)


def require_order(given: Any, what: str) -> None:
    """Raises `LoweringError` for a set: Python gives what is in it in another order each time."""
    if isinstance(given, Set) and not isinstance(given, KeysView):
        raise LoweringError(f"{what} is a set, which has no order: give a list, as sorted({what}, key=str)")


def require_room(numbers: int) -> None:
    """Raises `LoweringError` for more numbers than a kernel can have."""
    if numbers > MOST_ENTRIES:
        raise LoweringError(f"{numbers} numbers go in and come out, and a kernel has at most {MOST_ENTRIES}: split it")


def variables_in(item: Any) -> tuple[Any, ...]:
    """What is in an input, entry by entry; what is none is left as it is."""
    try:
        return _read(item)[1]
    except LoweringError:
        return (item,)


def require_name(name: Any, what: str) -> str:
    """The name, if it can be one in every language. Raises `LoweringError` if not."""
    if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or iskeyword(name):
        raise LoweringError(f"{what} {name!r} cannot be a name in a program: use letters, digits and underscores")
    return name


def require_kernel_name(name: Any) -> str:
    """The kernel's name; one that the C files need for themselves is refused too."""
    if name in TAKEN:
        raise LoweringError(f"the kernel cannot be called {name!r}: the C code around it uses that name")
    return require_name(name, "the kernel")


def _read(item: Any) -> tuple[str, tuple[sympy.Expr, ...], tuple[int, ...], sympy.MatrixSymbol | None]:
    """The name that an input is given, its entries, its core shape, and the matrix symbol that it is, if any."""
    wanted = ""
    if isinstance(item, tuple) and len(item) == 2 and isinstance(item[0], str):
        wanted, item = require_name(item[0], "the input"), item[1]
    if isinstance(item, list | tuple | sympy.NDimArray):
        item = sympy.Matrix(item if isinstance(item, sympy.NDimArray) else list(item))
    whole = item if isinstance(item, sympy.MatrixSymbol) else None
    if isinstance(item, sympy.IndexedBase):
        item = _entries_of(item)
    elif whole is not None:
        item = entries_of_matrix(whole)
    shape, entries = (core_shape(item.shape), tuple(item)) if isinstance(item, sympy.MatrixBase) else ((), (item,))
    for entry in entries:
        if isinstance(entry, UndefinedFunction):
            raise LoweringError(f"the function {entry} is no input: give its value, as {entry}(t)")
        if not is_variable(entry):
            raise LoweringError(
                f"an input must be a symbol or hold symbols, values of functions or their derivatives; {shown(entry)} "
                "is none"
            )
    return wanted, entries, shape, whole


def _entries_of(array: sympy.IndexedBase) -> sympy.Matrix:
    """The entries of an indexed array, in one row or as a matrix."""
    shape = array.shape or ()
    if len(shape) not in (1, 2) or not all(extent.is_Integer for extent in shape):
        raise LoweringError(
            f"{array} has no shape of one or two numbers: write IndexedBase({str(array)!r}, shape=(3,)), or name the "
            "entries that go in"
        )
    require_room(prod(map(int, shape)))
    places = product(*(range(int(extent)) for extent in shape))
    return sympy.Matrix(*(1, *map(int, shape))[-2:], [array[place] for place in places])


def _meaning(name: str, shape: tuple[int, ...], entries: Sequence[sympy.Expr], whole: sympy.MatrixSymbol | None) -> str:
    """The extents, and what the entries are where the name does not tell."""
    extents = f"{' x '.join(map(str, shape))} numbers" if shape else "a number"
    said = ", ".join(map(str, entries))
    return f"{extents}: {said}" if whole is None and said != name and PLAIN.fullmatch(said) else extents


def entries_of_matrix(value: Any) -> Any:
    """The matrix in its entries."""
    if not all(getattr(extent, "is_Integer", False) or isinstance(extent, int) for extent in value.shape):
        raise LoweringError(f"{shown(value)} has the shape {value.shape}: extents must be numbers")
    require_room(prod(map(int, value.shape)))
    return explicit(value)


def core_shape(shape: tuple[Any, ...]) -> tuple[int, ...]:
    """() for one entry, one axis for a row or a column, else two."""
    rows, columns = map(int, shape)
    if rows * columns == 0:
        raise LoweringError(f"a matrix of {rows} rows and {columns} columns has no entries")
    return tuple(extent for extent in (rows, columns) if extent > 1)
