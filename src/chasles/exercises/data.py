"""From what a user gives to exact values: numbers by the grammar, in the shapes that an exercise declares."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from decimal import Decimal
from fractions import Fraction
from typing import Any

import sympy as sp

from chasles.exact.grammar import LONGEST, NotANumber, read_number
from chasles.exact.numbers import normal, sign
from chasles.nearest import nearest
from chasles.statements.exercise import Array, Else, Exercise, ListOf, Record, Scalar, Shape, Truth, Tuple, Word

MOST_CHARACTERS = 1_000_000
MOST_DIGITS = 64
Reader = Callable[[Any, str], Any]


class DataError(ValueError):
    """Data that the exercise cannot be solved with; the message names the key, what was expected and what was given."""


def read_json(text: str) -> dict[str, Any]:
    """The keys of a data file; decimals stay as they are written. Raises DataError."""
    if len(text) > MOST_CHARACTERS:
        raise DataError(f"the data have more than {MOST_CHARACTERS} characters")
    try:
        found = json.loads(
            text, parse_float=Decimal, parse_int=_integer, parse_constant=_constant, object_pairs_hook=_once
        )
    except json.JSONDecodeError as error:
        raise DataError(f"the data are not JSON: {error.msg} in line {error.lineno}, column {error.colno}") from None
    except RecursionError:
        raise DataError("the data are nested too deeply") from None
    if not isinstance(found, dict):
        raise DataError('the data are an object with keys, as in {"a": [1, 0, 0]}')
    return found


def read_data(exercise: Exercise, given: Mapping[str, Any]) -> dict[str, Any]:
    """All data of the exercise, exact: those given, and the defaults of the others. Raises DataError."""
    for key in given:
        if key not in exercise.keys:
            takes = f"it takes {', '.join(exercise.keys)}" if exercise.keys else "it takes none"
            raise DataError(
                f"exercise {exercise.number} has no datum {_shown(key)}{nearest(key, exercise.keys)}; {takes}"
            )
    values = {}
    for datum in exercise.data:
        raw = given.get(datum.key, datum.default)
        values[datum.key] = (
            None if raw is None and datum.default is None else read_as(datum.shape, raw, datum.key, exact_number)
        )
    return values


def read_as(shape: Shape, raw: Any, where: str, number: Reader) -> Any:
    """A thing of that shape, each number in it by `number`; DataError says `where` it is not."""
    raw = raw.tolist() if hasattr(raw, "tolist") else raw
    match shape:
        case Scalar():
            return _scalar(shape, raw, where, number)
        case Array(rows, 1):
            entries = _items(raw, where, f"a list of {rows} numbers", rows)
            return _array([[number(entry, f"{where}[{i}]")] for i, entry in enumerate(entries, 1)])
        case Array(rows, columns):
            listed = _items(raw, where, f"{rows} rows of {columns} numbers", rows)
            return _array(
                [list(read_as(Array(columns), row, f"{where}[{i}]", number)) for i, row in enumerate(listed, 1)]
            )
        case Word(among):
            return _word(among, raw, where)
        case Truth():
            if not isinstance(raw, bool):
                raise DataError(f"{where}: expected true or false, and got {_shown(raw)}")
            return raw
        case Else(of, words):
            if raw is None and None in words:
                return None
            spelled = tuple(word for word in words if word is not None)
            is_word = isinstance(raw, str) and spelled and not isinstance(of, Scalar)
            return _word(spelled, raw, where) if is_word or raw in spelled else read_as(of, raw, where, number)
        case ListOf(of, least, most):
            entries = _items(raw, where, "a list")
            if len(entries) < least or (most is not None and len(entries) > most):
                wanted = f"{least}" if most == least else f"at least {least}" if most is None else f"{least} to {most}"
                raise DataError(f"{where}: expected {wanted} entries, and got {len(entries)}")
            return [read_as(of, entry, f"{where}[{i}]", number) for i, entry in enumerate(entries, 1)]
        case Tuple(parts):
            entries = _items(raw, where, f"[{', '.join(name for name, _ in parts)}]", len(parts))
            named = zip(parts, entries, strict=True)
            return tuple(read_as(part, entry, f"{where}, {name}", number) for (name, part), entry in named)
        case Record(names, of):
            return {name: read_as(of, entry, f"{where}.{name}", number) for name, entry in _fields(names, raw, where)}


def _array(rows: list[list[Any]]) -> Any:
    """A matrix, or lists where an entry is no expression of SymPy."""
    if all(isinstance(entry, sp.Expr) for row in rows for entry in row):
        return sp.ImmutableMatrix(rows)
    return [row[0] for row in rows] if len(rows[0]) == 1 else rows


def _word(among: Sequence[str], raw: Any, where: str) -> str:
    words = {word.lower(): word for word in among}
    if not isinstance(raw, str) or raw.lower() not in words:
        raise DataError(f"{where}: expected one of {', '.join(among)}, and got {_shown(raw)}")
    return words[raw.lower()]


def _fields(names: Sequence[str], raw: Any, where: str) -> list[tuple[str, Any]]:
    if not isinstance(raw, Mapping):
        raise DataError(f"{where}: expected an object with {', '.join(names)}, and got {_shown(raw)}")
    for name in names:
        if name not in raw:
            raise DataError(f"{where}: {name} is missing; expected {', '.join(names)}")
    for name in raw:
        if name not in names:
            raise DataError(f"{where}: {_shown(name)} is not known; expected {', '.join(names)}")
    return [(name, raw[name]) for name in names]


def _scalar(shape: Scalar, raw: Any, where: str, number: Reader) -> Any:
    value = number(raw, where)
    if shape.integer and not value.is_Integer:
        raise DataError(f"{where}: expected an integer, and got {_shown(raw)}")
    if shape.positive and sign(value) <= 0:
        raise DataError(f"{where}: expected a number greater than zero, and got {_shown(raw)}")
    if (shape.least is not None and value < shape.least) or (shape.most is not None and value > shape.most):
        raise DataError(f"{where}: expected {shape.least} to {shape.most}, and got {_shown(raw)}")
    return value


def _items(raw: Any, where: str, expected: str, size: int | None = None) -> Sequence[Any]:
    if not isinstance(raw, Sequence) or isinstance(raw, str | bytes):
        raise DataError(f"{where}: expected {expected}, and got {_shown(raw)}")
    if size is not None and len(raw) != size:
        raise DataError(f"{where}: expected {expected}, and got {len(raw)} of them")
    return raw


def exact_number(raw: Any, where: str) -> Any:
    """An exact number from an integer, a decimal as it is written, or text; raises DataError."""
    match raw:
        case bool():
            raise DataError(f"{where}: expected a number, and got {_shown(raw)}")
        case int():
            return sp.Integer(raw)
        case Fraction():
            return sp.Rational(raw.numerator, raw.denominator)
        case float() | Decimal():
            return _decimal(Decimal(repr(raw)) if isinstance(raw, float) else raw, where)
        case str() | sp.Expr():
            try:
                return normal(read_number(str(raw)))
            except NotANumber as error:
                raise DataError(f"{where}: {error}") from None
        case _:
            raise DataError(f"{where}: expected a number, and got {_shown(raw)}")


def _decimal(value: Decimal, where: str) -> Any:
    exponent = value.as_tuple().exponent
    if not isinstance(exponent, int) or abs(exponent) > MOST_DIGITS:
        raise DataError(f"{where}: expected a number, and got {_shown(str(value))}")
    exact = Fraction(value)
    return sp.Rational(exact.numerator, exact.denominator)


def _integer(text: str) -> int:
    if len(text) > LONGEST:
        raise DataError(f"a number has at most {LONGEST} characters, and one has {len(text)}")
    return int(text)


def _constant(text: str) -> Any:
    raise DataError(f"{text} is not a number here")


def _once(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for key, value in pairs:
        if key in found:
            raise DataError(f"{_shown(key)} is given twice")
        found[key] = value
    return found


def _shown(raw: Any) -> str:
    spell: Callable[[Any], str] = repr
    text = spell(raw)
    return text if len(text) <= 60 else f"{text[:57]}..."
