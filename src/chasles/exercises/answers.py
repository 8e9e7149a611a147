"""From what a student gives to exact answers, in the shapes that an exercise declares for the names of its answers."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import sympy as sp

from chasles.exact.grammar import NotANumber, read_number
from chasles.exact.polynomial_roots import Root, X
from chasles.exercises.data import DataError, exact_number, read_as
from chasles.nearest import nearest
from chasles.statements.exercise import Answer, Array, Else, Exercise, ListOf, Record, Scalar, Shape, Truth, Tuple, Word

MOST_COEFFICIENTS = 13
LONGEST_ANSWER = 2000
"""Characters; what is printed as an answer can be given back as one."""


def status_of(exercise: Exercise) -> Answer:
    """The status as an answer: what is the case for these data."""
    return Answer("status", Word(exercise.statuses), "what is the case for these data")


def asked_for(exercise: Exercise, data: Mapping[str, Any], status: str) -> frozenset[str]:
    """The names of what is to be answered where that is the status."""
    return frozenset(
        answer.name
        for answer in exercise.answers
        if status in (answer.only or exercise.statuses) and (not answer.given or data.get(answer.given) is not None)
    )


def read_answers(exercise: Exercise, given: Mapping[str, Any]) -> dict[str, Any]:
    """The answers, exact, in the form in which they are written, without places of the template that are left blank.

    Raises DataError for one that is malformed or no answer.
    """
    declared = {answer.name: answer for answer in (status_of(exercise), *exercise.answers)}
    found = {}
    for name, raw in given.items():
        if name not in declared:
            hint = nearest(name, list(declared))
            raise DataError(
                f"{name!r} is no answer of exercise {exercise.number}{hint}; these are: {', '.join(declared)}"
            )
        shape = declared[name].shape
        if raw == _blank(shape):
            continue
        known = exercise.synonyms.get(raw.lower(), raw) if isinstance(raw, str) and isinstance(shape, Word) else raw
        found[name] = read_as(shape, _as_column(shape, known), name, _number)
    return found


def template_of(exercise: Exercise) -> dict[str, Any]:
    """All names with places for what is to be written there."""
    return {answer.name: _blank(answer.shape) for answer in (status_of(exercise), *exercise.answers)}


def shape_in_words(shape: Shape) -> str:
    """What is expected, as a person reads it."""
    match shape:
        case Scalar():
            return "an integer" if shape.integer else "a number"
        case Array(rows, 1):
            return f"{rows} numbers"
        case Array(rows, columns):
            return f"{rows} rows of {columns} numbers"
        case Word(among):
            return " | ".join(among)
        case Truth():
            return "true | false"
        case Else(of, words):
            return " | ".join([shape_in_words(of), *("null" if word is None else word for word in words)])
        case ListOf(of):
            return f"a list of {shape_in_words(of)} each"
        case Tuple(parts):
            return f"[{', '.join(name for name, _ in parts)}]"
        case Record(names, of):
            return f"{', '.join(names)}: each {shape_in_words(of)}"


def _blank(shape: Shape) -> Any:
    match shape:
        case Array(rows, columns):
            return [_blank(Array(columns)) if columns > 1 else "?" for _ in range(rows)]
        case ListOf(of):
            return [_blank(of)]
        case Else(of):
            return _blank(of)
        case Record(names, of):
            return dict.fromkeys(names, _blank(of))
        case _:
            return shape_in_words(shape) if isinstance(shape, Word | Truth) else "?"


def _as_column(shape: Shape, raw: Any) -> Any:
    """A column, also as rows of one number."""
    of = shape.of if isinstance(shape, Else) else shape
    if isinstance(of, Array) and of.columns == 1 and isinstance(raw, list):
        return [row[0] if isinstance(row, list) and len(row) == 1 else row for row in raw]
    return raw


def _number(raw: Any, where: str) -> Any:
    match raw:
        case Mapping() if "root_of" in raw:
            return _root(raw, where)
        case Root():
            return raw.value
        case sp.Expr() if raw.is_real and not raw.has(sp.Float):
            return raw
        case str():
            try:
                return read_number(raw, LONGEST_ANSWER)
            except NotANumber as error:
                raise DataError(f"{where}: {error}") from None
        case _:
            return exact_number(raw, where)


def _root(raw: Mapping[str, Any], where: str) -> Any:
    """A real root of an integer polynomial."""
    coefficients, index = raw["root_of"], raw.get("index", -1)
    if not (
        isinstance(coefficients, list)
        and 2 <= len(coefficients) <= MOST_COEFFICIENTS
        and all(isinstance(c, int) and not isinstance(c, bool) for c in (*coefficients, index))
        and coefficients[0]
    ):
        raise DataError(f'{where}: expected {{"root_of": [integers, highest first], "index": from 0}}')
    polynomial = sp.Poly(coefficients, X).sqf_part()
    count = polynomial.count_roots()
    if not 0 <= index < count:
        has = f"expected 0 to {count - 1}, and got {index}" if count else "the polynomial has no real root"
        raise DataError(f"{where}: index: {has}")
    return sp.CRootOf(polynomial, index)
