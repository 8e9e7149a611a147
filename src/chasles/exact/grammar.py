"""The grammar of data: integers, decimals, + - * / ^ **, sqrt, pi, the trigonometric functions and their inverses.

Text is read by this parser alone and never evaluated as code. What it holds is exact: 0.1 is one tenth.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from typing import Any

import sympy as sp

from chasles.exact.enclosures import is_bounded

LONGEST = 200
MOST_EXPONENT = 64
MOST_NESTED = 100
MOST_BITS, BITS_A_CHARACTER = 4096, 7
"""Size of the largest number that a power may come to, more where a text may be long enough for the square of one:
exponents of exponents grow beyond every measure."""
_TOKEN = re.compile(r"\s*(?:([0-9]+\.[0-9]*|\.[0-9]+|[0-9]+)|([A-Za-z]+)|(\*\*|[-+*/^()]))")
_FUNCTIONS: dict[str, Callable[[Any], Any]] = {
    "sqrt": sp.sqrt,
    **{name: getattr(sp, name) for name in ("sin", "cos", "tan", "cot", "sec", "csc")},
    **{name: getattr(sp, name) for name in ("asin", "acos", "atan", "acot", "asec", "acsc")},
    **{f"arc{name}": getattr(sp, f"a{name}") for name in ("sin", "cos", "tan", "cot", "sec", "csc")},
}
_NAMES = "sqrt, pi, sin, cos, tan, cot, sec, csc, asin, acos, atan, acot, asec, acsc"


class NotANumber(ValueError):
    """Text that the grammar does not know, or that has no real value; `place` counts characters from one."""

    def __init__(self, text: str, at: int, why: str) -> None:
        self.place = at + 1
        shown = text if len(text) <= 60 else text[:57] + "..."
        super().__init__(f"{shown!r}: {why}, at character {at + 1}")


@dataclass(frozen=True, slots=True)
class _Token:
    kind: str
    text: str
    at: int


def read_number(text: str, longest: int = LONGEST) -> Any:
    """The exact real number that the text says, as a SymPy number.

    Raises NotANumber, which names the character, for text outside the grammar, of more than `longest` characters, with
    an exponent that is no integer or beyond 64, or without a real and finite value.
    """
    if len(text) > longest:
        raise NotANumber(text, longest, f"a number has at most {longest} characters")
    try:
        return _Reader(text, max(MOST_BITS, BITS_A_CHARACTER * longest)).whole()
    except RecursionError:
        raise NotANumber(text, 0, "the number is nested too deeply") from None


def _tokens(text: str) -> Iterator[_Token]:
    at = 0
    while text[at:].strip():
        found = _TOKEN.match(text, at)
        if found is None:
            at += len(text[at:]) - len(text[at:].lstrip())
            raise NotANumber(text, at, f"{text[at]!r} has no meaning in a number")
        kind = "number" if found[1] else "name" if found[2] else "sign"
        word = found[1] or found[2] or found[3]
        yield _Token(kind, word, found.end() - len(word))
        at = found.end()
    yield _Token("end", "", len(text))


class _Reader:
    """Recursive descent: sums of products of signed powers."""

    def __init__(self, text: str, most_bits: int) -> None:
        self.text, self.most_bits = text, most_bits
        self.tokens = list(_tokens(text))
        self.next = self.depth = 0

    def whole(self) -> Any:
        value = self.sum()
        if self.here.kind != "end":
            raise self.unexpected("the end, or one of + - * / ^")
        return value

    @property
    def here(self) -> _Token:
        return self.tokens[self.next]

    def take(self, *signs: str) -> _Token | None:
        token = self.here
        if token.kind == "sign" and token.text in signs:
            self.next += 1
            return token
        return None

    def unexpected(self, expected: str) -> NotANumber:
        token = self.here
        found = repr(token.text) if token.text else "nothing"
        return NotANumber(self.text, token.at, f"expected {expected}, and found {found}")

    def sum(self) -> Any:
        total = self.product()
        while sign := self.take("+", "-"):
            term = self.product()
            total = total + term if sign.text == "+" else total - term
        return total

    def product(self) -> Any:
        total = self.signed()
        while sign := self.take("*", "/"):
            factor = self.signed()
            total = total * factor if sign.text == "*" else self.quotient(total, factor, sign)
        return total

    def quotient(self, above: Any, below: Any, sign: _Token) -> Any:
        from chasles.exact.numbers import NotDecided, is_zero

        try:
            if is_zero(below):
                raise NotANumber(self.text, sign.at, "division by zero")
        except NotDecided:
            raise NotANumber(self.text, sign.at, "nothing decides whether this is a division by zero") from None
        return above / below

    def signed(self) -> Any:
        turned = False
        while sign := self.take("+", "-"):
            turned ^= sign.text == "-"
        value = self.power()
        return -value if turned else value

    def power(self) -> Any:
        self.depth += 1
        if self.depth > MOST_NESTED:
            raise NotANumber(self.text, self.here.at, f"a number is nested at most {MOST_NESTED} times")
        value = self.powered(self.operand())
        self.depth -= 1
        return value

    def powered(self, base: Any) -> Any:
        sign = self.take("^", "**")
        if sign is None:
            return base
        at = self.here.at
        exponent = self.signed()
        if not getattr(exponent, "is_Integer", False) or abs(exponent) > MOST_EXPONENT:
            raise NotANumber(self.text, at, f"an exponent is an integer of at most {MOST_EXPONENT}")
        if _bits(base) * abs(int(exponent)) > self.most_bits:
            raise NotANumber(self.text, sign.at, "the power is too large a number")
        return self.quotient(sp.Integer(1), base ** abs(exponent), sign) if exponent < 0 else base**exponent

    def operand(self) -> Any:
        token = self.here
        if token.kind == "number":
            self.next += 1
            return sp.Rational(token.text)
        if token.kind == "name":
            self.next += 1
            return self.named(token)
        if self.take("("):
            return self.closed()
        raise self.unexpected("a number, a function or '('")

    def closed(self) -> Any:
        value = self.sum()
        if not self.take(")"):
            raise self.unexpected("')'")
        return value

    def named(self, token: _Token) -> Any:
        if token.text == "pi":
            return sp.pi
        function = _FUNCTIONS.get(token.text)
        if function is None:
            raise NotANumber(self.text, token.at, f"{token.text!r} is not known here; known are {_NAMES}")
        if not self.take("("):
            raise self.unexpected(f"'(' after {token.text}")
        inside = self.closed()
        try:
            value = function(inside)
        except ValueError:  # SymPy 1.14 on the root of an integer with two large factors that are close
            raise NotANumber(self.text, token.at, f"{token.text} of so large a number is not found") from None
        if not (value.is_real or (value.is_real is None and is_bounded(value))) or value.has(sp.zoo, sp.nan, sp.oo):
            raise NotANumber(self.text, token.at, f"{token.text} has no real value there")
        return value


def _bits(value: Any) -> int:
    """A bound on the size of the numbers that powers of the value are made of."""
    if value.is_Rational:
        return 0 if abs(value) == 1 else max(int(value.p).bit_length(), int(value.q).bit_length())
    return sum(map(_bits, value.args)) + 1 if value.args else 1
