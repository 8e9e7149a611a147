"""Arrays that go into a kernel or come out: name, shape and meaning, the same in every language."""

from __future__ import annotations

import re
from dataclasses import replace as with_fields

from chasles.statements.kernel import Argument, Kernel, Packed, Stack
from chasles.vocabulary import Node, Rate, Symbol, plain

SIX = "_sym6"
"""What the name of a kernel ends in that takes or gives symmetric matrices as six numbers."""

Place = tuple[Node, int, int]
"""An entry of a symbol, or of its rate: its row and its column, counted from zero."""


def variants(kernel: Kernel, name: str) -> tuple[Kernel, ...]:
    """What is emitted: a kernel of the name with all entries, and one that packs what is symmetric, if any is."""
    name = kernel.name or name
    whole = with_fields(kernel, name=name, symmetric=())
    if not kernel.symmetric:
        return (whole,)
    of = tuple(Packed(of) if isinstance(of, Node) and of in kernel.symmetric else of for of in kernel.of)
    return whole, with_fields(kernel, name=f"{name}{SIX}", of=of)


def places_of(argument: Argument) -> tuple[Place, ...]:
    """The entries that an argument holds, in their order: row by row."""
    match argument:
        case Stack(parts=parts):
            return tuple((part, 0, 0) for part in parts)
        case Packed(matrix):
            return tuple((matrix, i, j) for i in range(3) for j in range(i, 3))
        case _:
            rows, columns = argument.shape
            return tuple((argument, i, j) for i in range(rows) for j in range(columns))


def argument_name(argument: Argument) -> str:
    """An argument's name as an identifier: a_prime for a', a_dot for its rate."""
    match argument:
        case Stack(name):
            return name
        case Packed(matrix):
            return argument_name(matrix)
    text = plain(argument).replace("'", "_prime").replace("~", "_tilde").replace("*", "_star")
    return re.sub(r"[^A-Za-z0-9]+", "_", text).strip("_")


def core_shape(argument: Argument) -> tuple[int, ...]:
    """The shape of an array: () for a scalar, one axis for a column, a row or what is packed or stacked."""
    if isinstance(argument, Stack | Packed):
        return (len(places_of(argument)),)
    return argument.shape if 1 not in argument.shape else tuple(extent for extent in argument.shape if extent > 1)


def meaning_of(argument: Argument) -> str:
    """What an argument means, in plain text; for an expression that is no symbol or rate, the expression itself."""
    match argument:
        case Stack(meaning=text):
            return text
        case Packed(matrix):
            return f"{meaning_of(matrix)}, symmetric, as (xx, xy, xz, yy, yz, zz)"
        case Symbol(meaning=str(text)) if text:
            return text
        case Rate(Rate(of)):
            return f"second time derivative of: {meaning_of(of)}"
        case Rate(of):
            return f"time derivative of: {meaning_of(of)}"
        case _:
            return plain(argument)
