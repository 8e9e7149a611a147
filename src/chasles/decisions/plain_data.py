"""Verdicts and repairs as plain data that JSON can hold, and back.

Each class stands by its name with what its fields hold, in order; nothing but the classes listed here is ever made.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, Field, fields, is_dataclass
from fractions import Fraction
from typing import Any

from chasles import vocabulary
from chasles.algebra.values import InPi
from chasles.checker.sparse import well_formed
from chasles.repairs.repair import Repair
from chasles.statements.fingerprint import is_said
from chasles.verdict import Contradictory, Counterexample, Fails, Holds, HoldsUnder, IllFormed, Posed
from chasles.vocabulary.dimension import Dimension
from chasles.vocabulary.families import Family, Index
from chasles.vocabulary.functions import Cases, FunctionOf
from chasles.vocabulary.measure import Measure
from chasles.vocabulary.parts import Submatrix

VERDICTS = (Holds, HoldsUnder, Fails, IllFormed, Contradictory, Posed, Counterexample, Repair)
NODES = tuple(
    each for each in vars(vocabulary).values() if isinstance(each, type) and issubclass(each, vocabulary.Node)
)
WORDS = (Dimension, Measure, Family, Index, Submatrix, FunctionOf, Cases, *NODES)
CLASSES: dict[str, type] = {each.__name__: each for each in (*VERDICTS, *WORDS)}
IN_PI = " pi"
"""Behind a coordinate of a point that pi measures."""
VERBATIM = ("certificate",)
"""Fields that hold plain data already."""


def to_data(value: Any) -> Any:
    """The value as lists, strings and numbers, without the last fields that hold their defaults.

    Raises TypeError for what is not among the classes listed here.
    """
    match value:
        case None | bool() | int() | str():
            return value
        case Fraction():
            return ["Fraction", str(value)]
        case tuple():
            return ["tuple", *map(to_data, value)]
        case Mapping():
            return {key: _number(held) for key, held in value.items()}
        case _ if is_dataclass(value) and CLASSES.get(type(value).__name__) is type(value):
            told = _told(value)
            while told and not is_said(value, told[-1]):
                told.pop()
            held = ((each.name, getattr(value, each.name)) for each in told)
            return [type(value).__name__, *(one if name in VERBATIM else to_data(one) for name, one in held)]
        case _:
            raise TypeError(f"{type(value).__name__} is not kept as plain data")


def from_data(data: Any) -> Any:
    """The value that `to_data` made this of; raises ValueError for anything else."""
    match data:
        case None | bool() | int() | str():
            return data
        case ["Fraction", str() as text]:
            return Fraction(text)
        case ["tuple", *parts]:
            return tuple(map(from_data, parts))
        case dict():
            return {key: _read_number(held) for key, held in data.items()}
        case [str() as name, *held] if name in CLASSES:
            made = CLASSES[name]
            assert is_dataclass(made)
            told = _told(made)
            least = sum(each.default is MISSING and each.default_factory is MISSING for each in told)
            if not least <= len(held) <= len(told):
                raise ValueError(f"{name} has {least} to {len(told)} fields: {data!r:.60}")
            named = zip(told, held, strict=False)
            # By name: what tells no value from others may stand before what does.
            return made(**{each.name: one if each.name in VERBATIM else from_data(one) for each, one in named})
        case _:
            raise ValueError(f"no verdict and no repair: {data!r:.60}")


def _number(value: Any) -> str:
    """A coordinate of a point as a text; raises TypeError for anything else."""
    if isinstance(value, int | Fraction):
        return f"{Fraction(value)}{IN_PI * isinstance(value, InPi)}"
    if not getattr(value, "is_number", False):
        raise TypeError(f"{type(value).__name__} is no coordinate of a point")
    return str(value)


def _read_number(text: str) -> Any:
    """The coordinate of a point that a text says; raises ValueError for anything else."""
    try:
        return (InPi if IN_PI in text else Fraction)(text.removesuffix(IN_PI))
    except ValueError:
        from chasles.checker.expressions.widened import plain_expression  # loads SymPy
    with well_formed("coordinate"):
        value = plain_expression(text, {})
        if not value.is_number:
            raise ValueError(f"no number: {text!r:.60}")
    return value


def _told(made: Any) -> list[Field[Any]]:
    """The fields that tell a value from others."""
    return [each for each in fields(made) if each.compare]
