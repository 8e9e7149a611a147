"""What goes in and what comes out? Arrays of real numbers, each entry of an input a symbol of its own."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from keyword import iskeyword
from typing import Any

import sympy
from sympy.matrices.expressions.matexpr import MatrixElement

from chasles.compiling.scalars import shown
from chasles.lowering.program import Argument
from chasles.lowering.refusal import LoweringError

__all__ = ["Input", "ResultEntries", "inputs_of", "outputs_of", "require_kernel_name"]

TAKEN = ("best_level", "block", "data", "entry", "loop", "run", "shape")


@dataclass(frozen=True, slots=True)
class Input:
    """An input: how it is called, its core shape, and the user's symbols for its entries, row-major."""

    argument: Argument
    entries: tuple[sympy.Expr, ...]
    whole: sympy.MatrixSymbol | None = None

    @property
    def symbols(self) -> tuple[sympy.Symbol, ...]:
        """The real symbols that stand for the entries, by their names."""
        return tuple(sympy.Symbol(str(entry), real=True) for entry in self.entries)


@dataclass(frozen=True, slots=True)
class ResultEntries:
    """A result: its name, its core shape and its entries, row-major."""

    name: str
    shape: tuple[int, ...]
    entries: tuple[sympy.Expr, ...]


def inputs_of(given: Any) -> tuple[Input, ...]:
    """The inputs, in the order given.

    Raises `LoweringError` for what is no symbol, and for a symbol that comes twice.
    """
    if isinstance(given, sympy.Basic | sympy.MatrixBase):
        given = (given,)
    if isinstance(given, str) or not isinstance(given, Iterable):
        raise LoweringError(f"inputs must be symbols, not {given!r}")
    names: list[str] = []
    found = [_input(item, names) for item in (given.items() if isinstance(given, Mapping) else given)]
    if not found:
        raise LoweringError("inputs is empty: name at least one symbol")
    entries = [str(entry) for item in found for entry in item.entries]
    twice = next((entry for entry in entries if entries.count(entry) > 1), None)
    if twice is not None:
        raise LoweringError(f"{twice} comes twice among the inputs: every entry of an input needs a symbol of its own")
    return tuple(found)


def outputs_of(expression: Any, given: Sequence[Input], names: Any) -> tuple[ResultEntries, ...]:
    """The results, in symbols that stand for entries of inputs; one for each item of a list or tuple.

    Raises `LoweringError` for a free symbol that is no input, and where the names are not as many as the results.
    """
    several = isinstance(expression, list | tuple)
    values = [_value(item) for item in (expression if several else (expression,))]
    if not values:
        raise LoweringError("there is nothing to compile: the list of expressions is empty")
    called = _names(names, len(values))
    table: dict[sympy.Basic, sympy.Basic] = {}
    for item in given:
        table |= dict(zip(item.entries, item.symbols, strict=True))
        if item.whole is not None:
            table[item.whole] = sympy.ImmutableDenseMatrix(*item.whole.shape, item.symbols)
    return tuple(_output(name, value, table) for name, value in zip(called, values, strict=True))


def require_name(name: Any, what: str) -> str:
    """The name, if it can be one in every language. Raises `LoweringError` if not."""
    if not isinstance(name, str) or not name.isidentifier() or not name.isascii() or iskeyword(name):
        raise LoweringError(f"{what} {name!r} cannot be a name in a program: use letters, digits and underscores")
    return name


def require_kernel_name(name: Any) -> str:
    """The kernel's name; one that the C files need for themselves is refused too."""
    if name in TAKEN:
        raise LoweringError(f"the kernel cannot be called {name!r}: what it is compiled with has that name")
    return require_name(name, "the kernel")


def _input(item: Any, taken: list[str]) -> Input:
    wanted = None
    if isinstance(item, tuple) and len(item) == 2 and isinstance(item[0], str):
        wanted, item = require_name(item[0], "the input"), item[1]
    if isinstance(item, list | tuple):
        item = sympy.Matrix(list(item))
    whole: sympy.MatrixSymbol | None = None
    if isinstance(item, sympy.MatrixSymbol):
        whole, item = item, _explicit(item)
    if isinstance(item, sympy.MatrixBase):
        shape, entries = _core(item.shape), tuple(item)
    else:
        shape, entries = (), (item,)
    for entry in entries:
        if not isinstance(entry, sympy.Symbol | sympy.Indexed | MatrixElement):
            raise LoweringError(f"an input must be a symbol or hold symbols; {shown(entry)} is none")
    name = wanted or _name(whole.name if whole else "", [str(getattr(entry, "name", entry)) for entry in entries])
    name = name if name and not iskeyword(name) else f"input_{len(taken) + 1}"
    while name in taken:
        name += "_"
    taken.append(name)
    return Input(Argument(name, shape, _meaning(shape)), entries, whole)


def _meaning(shape: tuple[int, ...]) -> str:
    return f"{' x '.join(map(str, shape))} numbers" if shape else "a number"


def _name(whole: str, entries: Sequence[str]) -> str:
    """What an input is called: as it is, or by what the names of its entries begin with."""
    text = whole or entries[0]
    if not whole and len(entries) > 1:
        while text and not all(entry.startswith(text) for entry in entries):
            text = text[:-1]
        text = text.rstrip("0123456789")
    text = re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")
    return text if text.isidentifier() else ""


def _names(names: Any, count: int) -> tuple[str, ...]:
    if names is None:
        return ("result",) if count == 1 else tuple(f"result_{k}" for k in range(1, count + 1))
    found = (names,) if isinstance(names, str) else tuple(names)
    if len(found) != count:
        raise LoweringError(f"outputs names {len(found)} results, and there are {count} expressions")
    if len(set(found)) != count:
        raise LoweringError("two results have one name: give each its own in outputs")
    return tuple(require_name(name, "the output") for name in found)


def _value(item: Any) -> Any:
    """The expression as SymPy holds it: a scalar, or a matrix."""
    if isinstance(item, str):
        raise LoweringError(f"the expression {item!r} is a text; give it as SymPy expression")
    if isinstance(item, sympy.NDimArray):
        if item.rank() > 2:
            raise LoweringError(f"an output has {item.rank()} axes; scalars, vectors and matrices are computed")
        return sympy.Matrix(item) if item.rank() else item[()]
    try:
        value = sympy.sympify(item, strict=True)
    except sympy.SympifyError:
        raise LoweringError(f"{item!r} is no SymPy expression") from None
    if not isinstance(value, sympy.Expr | sympy.MatrixBase | sympy.MatrixExpr):
        raise LoweringError(f"{shown(value)} is no scalar and no matrix ({type(value).__name__})")
    return value


def _output(name: str, value: Any, table: Mapping[sympy.Basic, sympy.Basic]) -> ResultEntries:
    shape: tuple[int, ...] = ()
    entries: Iterator[Any] = iter((value,))
    if isinstance(value, sympy.MatrixBase | sympy.MatrixExpr):
        value = _explicit(value) if isinstance(value, sympy.MatrixExpr) else value
        shape, entries = _core(value.shape), iter(value)
    return ResultEntries(name, shape, tuple(_closed(sympy.sympify(entry), table) for entry in entries))


def _closed(entry: sympy.Expr, table: Mapping[sympy.Basic, sympy.Basic]) -> sympy.Expr:
    """The entry in symbols of inputs alone."""
    known = {symbol for key in table for symbol in key.free_symbols}
    try:
        closed = entry.xreplace(table)
    except (TypeError, ValueError) as error:
        raise LoweringError(f"{shown(entry)} has no value for real inputs: {error}") from None
    if closed.has(sympy.MatrixExpr, sympy.MatrixBase):
        closed = closed.doit()
    stray = (entry.free_symbols - known) | (closed.free_symbols - set(table.values()))
    if stray:
        said = ", ".join(sorted(map(str, stray)))
        raise LoweringError(f"{said} in {shown(entry)} is not among the inputs")
    return closed


def _explicit(value: Any) -> Any:
    """The matrix in its entries."""
    if not all(getattr(extent, "is_Integer", False) or isinstance(extent, int) for extent in value.shape):
        raise LoweringError(f"{shown(value)} has the shape {value.shape}: extents must be numbers")
    return value.as_explicit()


def _core(shape: tuple[Any, ...]) -> tuple[int, ...]:
    """() for one entry, one axis for a row or a column, else two."""
    rows, columns = map(int, shape)
    if rows * columns == 0:
        raise LoweringError(f"a matrix of {rows} rows and {columns} columns has no entries")
    return tuple(extent for extent in (rows, columns) if extent > 1)
