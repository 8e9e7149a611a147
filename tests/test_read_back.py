"""What is written can be read in one way only: random expressions are spelled, read by an independent reader of plain
text and of LaTeX, and have the value that they have themselves.

The reader knows precedence, brackets and bars, and nothing of how the speller decides. A product is read with its
factors grouped in every way that fits; all must agree. Identity and zero are read as the numbers 1 and 0, which stand
for multiples of the identity wherever a matrix is.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from fractions import Fraction
from typing import Any

import mpmath
import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from latex2mathml.converter import convert

from chasles.numerics.reference import Singular, evaluate
from chasles.vocabulary import (
    CPM,
    TIME,
    Contract,
    Group,
    Identity,
    Negative,
    Node,
    Norm,
    Number,
    Power,
    Quotient,
    Scale,
    Sum,
    Zero,
    at,
    column,
    cos,
    cross,
    det,
    dot,
    inverse,
    latex,
    plain,
    rate,
    scalar,
    sin,
    square,
    tr,
    vect,
    vector,
)

from .sampling import WHOLE

mpmath.mp.dps = 60
Value = Any  # an array of mpmath numbers, or a number that stands for a multiple of the identity

s, t = scalar("s", "s", ""), scalar("t_1", "t_1", "")
phi = scalar("phi", r"\phi", "")
a, b = vector("a'", "a'", ""), vector("b", "b", "")
p_0 = vector("p_0'", r"\mathbf{p}'_0", "")
Q, R = square("Q", "Q", ""), square("R*", r"\mathbf{R}^*", "")
# Quantities whose rates have no dimension, so that any two can be added.
k_1, p_1 = scalar("k_1", "k_1", "", TIME), vector("p_1", "p_1", "", TIME)
p_2_ = vector("p_2'", r"\mathbf{p}'_2", "", TIME**2)
RATES: tuple[Node, ...] = (rate(k_1), rate(p_1), rate(rate(p_2_)))
LETTERS: tuple[Node, ...] = (s, t, phi, a, b, p_0, Q, R, at(b), *RATES)


def _numbers() -> dict[Node, list[Fraction]]:
    draw = np.random.default_rng(3)
    return {
        letter: [Fraction(int(n), 7) for n in draw.integers(3, 20, letter.shape[0] * letter.shape[1])]
        for letter in LETTERS
        if letter != at(b)
    }


VALUES = _numbers()
FUNCTIONS = ("sin", "cos", "tr", "det", "vect", "CPM")


# Random expressions, of a scalar, a vector or a square matrix.


def _leaves(kind: str) -> st.SearchStrategy[Node]:
    numbers = st.fractions(-3, 4, max_denominator=3).map(Number)
    return {
        "scalar": st.one_of(st.sampled_from((s, t, phi, RATES[0])), numbers),
        "vector": st.sampled_from((a, b, p_0, at(b), *RATES[1:])),
        "matrix": st.sampled_from((Q, R, Identity(3), Zero(3, 3))),
    }[kind]


def _products(kind: str, depth: int) -> list[st.SearchStrategy[Node]]:
    n, v, m = (expressions(each, depth - 1) for each in ("scalar", "vector", "matrix"))
    divisors = st.sampled_from((s, t, s * t, t**2, Number(Fraction(2)), 3 * s, 1 + t, s / t))
    same = expressions(kind, depth - 1)
    every: list[st.SearchStrategy[Node]] = [
        st.lists(st.one_of(same, same.map(Negative)), min_size=2, max_size=3).map(lambda terms: Sum(tuple(terms))),
        same.map(Negative),
        st.builds(Scale, n, same, st.booleans()),
        st.builds(Quotient, same, divisors, st.booleans()),
        st.builds(Group, same, st.sampled_from(("()", "[]", "{}"))),
    ]
    own: dict[str, list[st.SearchStrategy[Node]]] = {
        "scalar": [
            st.builds(dot, v, v),
            st.builds(Power, n, st.integers(2, 3)),
            st.builds(Norm, v),
            st.builds(lambda x, y: x.T @ y, v, v),
            n.map(sin),
            n.map(cos),
            m.map(tr),
            m.map(det),
            st.builds(lambda x, y, k: column(x, k).T @ column(y, k), v, v, n),
        ],
        "vector": [
            st.builds(cross, v, v),
            st.builds(lambda x, y: x @ y, m, v),
            st.builds(lambda x, y: Contract((x, y)), m, v),
            m.map(vect),
        ],
        "matrix": [
            st.builds(lambda x, y: x @ y, m, m),
            st.builds(lambda x, y: x @ y.T, v, v),
            m.map(lambda x: x.T),
            v.map(CPM),
            m.map(lambda x: x**2),
            st.sampled_from((inverse(Q), inverse(R))),
        ],
    }
    return every + own[kind]


@st.composite
def expressions(draw: st.DrawFn, kind: str, depth: int) -> Node:
    ways = [_leaves(kind), *(_products(kind, depth) if depth else [])]
    return draw(ways[draw(st.integers(0, len(ways) - 1))])


# The reader.


def _array(value: Value, shape: tuple[int, int]) -> Value:
    """The value as an array: a number stands for a multiple of the identity, and zero for any zero."""
    if isinstance(value, np.ndarray):
        return value
    if shape[0] != shape[1]:
        assert value == 0
    return value * np.array([[mpmath.mpf(int(i == j)) for j in range(shape[1])] for i in range(shape[0])])


def _plus(left: Value, right: Value) -> Value:
    if isinstance(left, np.ndarray) and left.size > 1:
        return left + _array(right, left.shape)
    if isinstance(right, np.ndarray) and right.size > 1:
        return _array(left, right.shape) + right
    return _number(left) + _number(right)


def _number(value: Value) -> Value:
    return value[0, 0] if isinstance(value, np.ndarray) and value.size == 1 else value


def _times(left: Value, right: Value) -> Value:
    """The product of two factors, or None if they do not fit."""
    left, right = _number(left), _number(right)
    if isinstance(left, np.ndarray) and isinstance(right, np.ndarray):
        return _number(left @ right) if left.shape[1] == right.shape[0] else None
    return left * right


def _product(factors: list[Value]) -> Value:
    """The product, whichever way the factors are grouped."""
    if len(factors) == 1:
        return factors[0]
    found: list[Value] = []
    for cut in range(1, len(factors)):
        sides = _product(factors[:cut]), _product(factors[cut:])
        if sides[0] is not None and sides[1] is not None and (value := _times(*sides)) is not None:
            found.append(value)
    for other in found[1:]:
        assert _close(found[0], other), "two ways of grouping a product disagree"
    return found[0] if found else None


def _close(one: Value, other: Value) -> bool:
    difference = np.abs(np.asarray(_plus(one, -other)))
    return bool(np.max(difference) <= mpmath.mpf(10) ** -25 * (1 + np.max(np.abs(np.asarray(one)))))


def _function(name: str, value: Value) -> Value:
    if name in ("sin", "cos"):
        return getattr(mpmath, name)(_number(value))
    if name == "CPM":
        (x,), (y,), (z,) = _array(value, (3, 1))
        nothing = mpmath.mpf(0)
        return np.array([[nothing, -z, y], [z, nothing, -x], [-y, x, nothing]])
    m = _array(value, (3, 3))
    if name == "tr":
        return m[0, 0] + m[1, 1] + m[2, 2]
    if name == "vect":
        return np.array([[m[2, 1] - m[1, 2]], [m[0, 2] - m[2, 0]], [m[1, 0] - m[0, 1]]]) / 2
    return m[0] @ np.array(
        [m[1, (k + 1) % 3] * m[2, (k + 2) % 3] - m[1, (k + 2) % 3] * m[2, (k + 1) % 3] for k in range(3)]
    )


class Reader:
    """Reads sums of dots and quotients of products of powers of atoms; bars close where they can."""

    def __init__(self, tokens: list[str], letters: dict[str, Value]) -> None:
        self.tokens = [*tokens, "end"]
        self.letters = letters
        self.bars: list[bool] = [False]

    def read(self) -> Value:
        value = self.sum()
        assert self.tokens == ["end"], f"left over: {self.tokens}"
        return value

    def take(self, *expected: str) -> str:
        token = self.tokens.pop(0)
        assert not expected or token in expected, f"{token} where {expected} is expected"
        return token

    def sum(self) -> Value:
        negative = self.tokens[0] == "-" and bool(self.take())
        total = self.term()
        total = -total if negative else total
        while self.tokens[0] in "+-":
            sign = 1 if self.take() == "+" else -1
            total = _plus(total, sign * self.term())
        return total

    def term(self) -> Value:
        value = self.product()
        if self.tokens[0] == "/":
            self.take()
            return value / _number(self.power())
        if self.tokens[0] == ".":
            self.take()
            left, right = _array(value, (3, 1)), _array(self.product(), (3, 1))
            return _number(left.T @ right)
        if self.tokens[0] == "x":
            self.take()
            return _function("CPM", value) @ _array(self.product(), (3, 1))
        return value

    def product(self) -> Value:
        factors = [self.power()]
        while self.tokens[0] not in ("+", "-", "/", ".", "x", ",", ";", ")", "]", "}", "close", "end"):
            if self.tokens[0] == "|" and self.bars[-1]:
                break
            factors.append(self.power())
        value = _product(factors)
        assert value is not None, "no way of grouping a product fits"
        return value

    def power(self) -> Value:
        value = self.atom()
        if self.tokens[0] != "^":
            return value
        self.take()
        grouped = self.tokens[0] == "{" and bool(self.take())
        exponent = self.take()
        if exponent == "-":
            exponent += self.take()
        if grouped:
            self.take("}")
        if exponent == "T":
            return value.T if isinstance(value, np.ndarray) else value
        if exponent == "-1":
            return np.array(mpmath.inverse(mpmath.matrix(value.tolist())).tolist())
        return _product([value] * int(exponent))

    def atom(self) -> Value:
        token = self.take()
        if token in self.letters:
            return self.letters[token]
        if token.isdigit():
            return mpmath.mpf(int(token))
        if token in FUNCTIONS:
            return _function(token, self.atom())
        if token == r"\frac":
            above = self.inside("{", "}")
            return above / _number(self.inside("{", "}"))
        if token == "|":
            self.bars.append(True)
            value = self.sum()
            self.bars.pop()
            self.take("|")
            return mpmath.sqrt(sum(x * x for x in np.asarray(value).ravel()))
        closing = {"(": ")", "[": "]", "{": "}", "open": "close"}[token]
        self.tokens.insert(0, token)
        return self.inside(token, closing)

    def inside(self, opening: str, closing: str) -> Value:
        """A bracket, or a matrix of blocks."""
        self.take(opening)
        self.bars.append(False)
        rows = [[self.sum()]]
        while self.tokens[0] in (",", ";"):
            if self.take() == ",":
                rows[-1].append(self.sum())
            else:
                rows.append([self.sum()])
        self.bars.pop()
        self.take(closing)
        if len(rows) == len(rows[0]) == 1:
            return rows[0][0]
        tall = [[part if isinstance(part, np.ndarray) else _array(part, (1, 1)) for part in row] for row in rows]
        return np.block(tall)


def _letters(spell: Callable[[Node], str]) -> dict[str, Value]:
    letters = {}
    for letter in LETTERS:
        rows, columns = letter.shape
        flat = [mpmath.mpf(x.numerator) / x.denominator for x in VALUES[b if letter == at(b) else letter]]
        letters[spell(letter)] = flat[0] if rows == columns == 1 else np.array(flat).reshape(rows, columns)
    return letters


def read_plain(text: str) -> Value:
    letters = _letters(plain)
    words = "|".join(re.escape(word) for word in sorted((*letters, *FUNCTIONS), key=len, reverse=True))
    tokens = re.findall(rf"{words}|\d+|[A-Za-z]+|\S", text)
    return Reader(tokens, letters).read()


LATEX_WORDS = {
    r"\left(": "(", r"\right)": ")", r"\left[": "[", r"\right]": "]", r"\left\{": "open", r"\right\}": "close",
    r"\begin{bmatrix}": "[", r"\end{bmatrix}": "]", "&": ",", r"\\": ";", r"\|": "|", r"\cdot": ".", r"\times": "x",
    r"\mathbf{1}": "1", r"\mathbf{O}": "0", r"\sin": "sin", r"\cos": "cos", r"\det": "det", r"\text{tr}": "tr",
    r"\text{vect}": "vect", r"\text{CPM}": "CPM", r"\frac": r"\frac",
}  # fmt: skip


def read_latex(text: str) -> Value:
    letters = _letters(latex)
    words = "|".join(re.escape(word) for word in sorted((*letters, *LATEX_WORDS), key=len, reverse=True))
    tokens = [LATEX_WORDS.get(token, token) for token in re.findall(rf"{words}|\d+|[A-Za-z]+|\S", text)]
    return Reader(tokens, letters).read()


# The tests.


def value_of(node: Node) -> Value:
    try:
        rows = evaluate(node, VALUES)
    except Singular:
        assume(False)
    return np.array([[mpmath.mpf(x) for x in row] for row in rows])


@pytest.mark.sampled(2)
@pytest.mark.parametrize("kind", ["scalar", "vector", "matrix"])
@settings(max_examples=150 if WHOLE else 25, deadline=None)
@given(data=st.data())
def test_what_is_written_reads_back_as_it_was_meant(kind: str, data: st.DataObject) -> None:
    node = data.draw(expressions(kind, 3))
    expected = value_of(node)
    assert _close(_array(read_plain(plain(node)), node.shape), expected), plain(node)
    assert _close(_array(read_latex(latex(node)), node.shape), expected), latex(node)
    assert "<math" in convert(latex(node))


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("2 s", 2),
        ("-s + 1/2", "-1 + 1/2"),
        ("s/t_1", "1/3"),
        ("(s - t_1)^2", 4),
        ("a' . b", 2),
        ("|a' x b| s", "sqrt(5)"),
    ],
)
def test_the_reader_reads(text: str, expected: object) -> None:
    known: dict[str, Value] = {"s": mpmath.mpf(1), "t_1": mpmath.mpf(3)}
    known |= {"a'": np.array([[1], [0], [0]]) * mpmath.mpf(1), "b": np.array([[2], [1], [2]]) * mpmath.mpf(1)}
    tokens = re.findall(r"a'|t_1|\d+|[A-Za-z]+|\S", text)
    numbers = {"-1 + 1/2": -0.5, "1/3": mpmath.mpf(1) / 3, "sqrt(5)": mpmath.sqrt(5)}
    assert abs(Reader(tokens, known).read() - numbers.get(str(expected), expected)) < 1e-50
