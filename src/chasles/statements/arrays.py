"""Arrays that go into a kernel or come out: name, shape and meaning, the same in every language."""

from __future__ import annotations

import re

from chasles.statements.kernel import Argument, Packed, Stack, places_of
from chasles.vocabulary import Rate, Symbol, plain


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
