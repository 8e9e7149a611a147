"""Questions on scalars and matrices in SymPy: what `prove` says that it treats."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import sympy as sp
from sympy import Abs, Eq, Matrix, Rational, cos, sign, sin, sqrt, tan

from .equations import Equation
from .functions import elementary, imaginary
from .rewriting import distorted, rewritten

__all__ = ["FAMILIES", "expression", "question", "symbols_of"]

FREE = sp.symbols("x y z")
ANGLES = sp.symbols("phi psi")
ASSUMED = (
    sp.Symbol("p", positive=True),
    sp.Symbol("q", positive=True),
    sp.Symbol("k", negative=True),
    sp.Symbol("n", integer=True),
    sp.Symbol("o", zero=True),
    sp.Symbol("r", nonnegative=True),
)
Family = Callable[[Random], Equation]


def number(draw: Random) -> Any:
    """A small rational number."""
    return Rational(draw.choice((-3, -2, -1, 1, 1, 2, 3, 5)), draw.choice((1, 1, 1, 2, 3)))


def symbols_of(draw: Random, assumed: float = 0.35) -> list[Any]:
    """A few symbols, some with assumptions."""
    return [draw.choice(ASSUMED) if draw.random() < assumed else draw.choice(FREE) for _ in range(draw.randint(1, 3))]


def angle(draw: Random) -> Any:
    """A sum of multiples of angles, and of pi."""
    total = draw.choice((1, 1, 1, 2, Rational(1, 2), 3)) * draw.choice(ANGLES)
    if draw.random() < 0.3:
        total += draw.choice((1, -1, 2)) * draw.choice(ANGLES)
    if draw.random() < 0.25:
        total += sp.pi * draw.choice((1, Rational(1, 2), Rational(1, 3), Rational(1, 4), Rational(1, 6)))
    return total


def expression(draw: Random, depth: int, atoms: Sequence[Any]) -> Any:
    """An expression of rational functions, angles, roots, absolute values and signs."""
    if depth <= 0 or draw.random() < 0.1:
        return draw.choice(atoms) if draw.random() < 0.75 else number(draw)
    one = expression(draw, depth - 1, atoms)
    kind = draw.random()
    if kind < 0.3:
        return one + expression(draw, depth - 1, atoms)
    if kind < 0.55:
        return one * expression(draw, depth - 1, atoms)
    if kind < 0.63:
        other = expression(draw, depth - 2, atoms)
        return one / other if other != 0 else one
    if kind < 0.7:
        return one ** draw.choice((2, 2, 3))
    if kind < 0.82:
        return draw.choice((sin, cos, sin, cos, tan))(angle(draw)) * one
    if kind < 0.9:
        inside = draw.choice((one**2, one**2 + 1, one, one + sp.pi, sp.Integer(2), sp.Integer(3)))
        return sqrt(inside)
    if kind < 0.96:
        return Abs(one if draw.random() < 0.8 else one + sp.pi)
    return sign(one) if draw.random() < 0.6 else sp.pi * one


def finite(draw: Random, depth: int, atoms: Sequence[Any]) -> Any:
    """An expression of moderate size, without a division by zero."""
    while True:
        e = sp.sympify(expression(draw, depth, atoms))
        if not e.has(sp.nan, sp.zoo, sp.oo, sp.I) and 0 < sp.count_ops(e) < 30:
            return e


def twins(draw: Random) -> Equation:
    """An expression and the same in other words, sometimes with a slip."""
    left = finite(draw, draw.randint(2, 3), symbols_of(draw))
    right = rewritten(left, draw, draw.randint(1, 3))
    if draw.random() < 0.35:
        return Equation(left, distorted(right, draw), kind="slip", lenient=True)
    return Equation(left, right, kind="twins", truth=True, lenient=left.has(sign))


def given_values(draw: Random) -> Equation:
    """Twins to which multiples of the sides of given equations are added."""
    atoms = [*symbols_of(draw), draw.choice(FREE), draw.choice(FREE)]
    left = finite(draw, 2, atoms)
    given = []
    right = rewritten(left, draw, 1)
    for _ in range(draw.randint(1, 2)):
        equation = _condition(draw, atoms)
        given.append(equation if draw.random() < 0.7 else equation.lhs - equation.rhs)
        right += draw.choice((1, -2, draw.choice(atoms))) * (equation.lhs - equation.rhs)
    truth: bool | None = True
    if draw.random() < 0.4:
        right, truth = distorted(right, draw), None
    return Equation(left, right, tuple(given), kind="given", truth=truth, lenient=True)


def _condition(draw: Random, atoms: Sequence[Any]) -> Any:
    """An equation that some point satisfies, more often than not."""
    x, y = draw.choice(atoms), draw.choice(FREE)
    value = number(draw)
    phi = draw.choice(ANGLES)
    return draw.choice(
        (
            Eq(x + y, value, evaluate=False),
            Eq(x * y, value, evaluate=False),
            Eq(x**2 + y**2, Abs(value), evaluate=False),
            Eq(x**2, Abs(value), evaluate=False),
            Eq(y, value, evaluate=False),
            Eq(cos(phi), Rational(draw.choice((3, -4, 0, 5)), 5), evaluate=False),
            Eq(x * cos(phi) + y * sin(phi), value, evaluate=False),
            Eq(y * (y - 1), 0, evaluate=False),
            Eq(sqrt(y**2 + x**2), Abs(value), evaluate=False),
            Eq(y * x**2, x, evaluate=False),
        )
    )


def contradictory(draw: Random) -> Equation:
    """Given equations that no real point satisfies."""
    x, y = draw.sample(FREE, 2)
    p, k = ASSUMED[0], ASSUMED[2]
    a, b = number(draw), Abs(number(draw))
    given = draw.choice(
        (
            (Eq(x, a), Eq(x, a + b)),
            (Eq(x**2, -b),),
            (Eq(x**2 + y**2, -b),),
            (Eq(x + y, a), Eq(2 * x + 2 * y, 2 * a + b)),
            (Eq(x * y, 1), Eq(x, 0)),
            (Eq(p, -b),),
            (Eq(p * x**2, -b),),
            (Eq(p, k),),
            (Eq(sin(x), 1 + b),),
            (Eq(sin(x), 1), Eq(cos(x), 1)),
            (Eq(sqrt(x), -b),),
            (Eq(Abs(x), -b),),
            (Eq(x**2, y), Eq(y, -b)),
            (Eq(x**2 + b, 0), Eq(y, x)),
        )
    )
    given = tuple(e for e in given if e not in (sp.true, sp.false))
    left = finite(draw, 2, (x, y))
    if not given or draw.random() < 0.1:
        given = (Eq(x**2, -1), Eq(x, a))
    right = left + draw.choice((sp.Integer(0), sp.Integer(1), x, x**2 + b, y))
    return Equation(left, right, given, kind="contradictory", satisfiable=False, lenient=True)


def matrices(draw: Random) -> Equation:
    """Matrices of small expressions: products, inverses, determinants, transposes."""
    n = draw.choice((2, 2, 3))
    atoms = symbols_of(draw, 0.2)

    def matrix() -> Any:
        return Matrix(n, n, lambda i, j: draw.choice((*atoms, number(draw), sp.Integer(0), cos(angle(draw)))))

    A, B = matrix(), matrix()
    pairs = [
        ((A * B).T, B.T * A.T),
        (A.det(), A.T.det()),
        ((A * B).det(), A.det() * B.det()),
        (A * B, B * A),
        ((A + B) ** 2, A**2 + A * B + B * A + B**2),
        ((A + B) ** 2, A**2 + 2 * A * B + B**2),
        ((A * B).trace(), (B * A).trace()),
        (A * A.adjugate(), A.det() * sp.eye(n)),
    ]
    left, right = draw.choice(pairs)
    given = () if draw.random() < 0.7 else (Eq(A.det(), 1, evaluate=False),)
    if draw.random() < 0.3:
        right = right * 2 if draw.random() < 0.5 else right + left
    return Equation(left, right, given, kind="matrices", lenient=True)


def divisors(draw: Random) -> Equation:
    """Fractions, with what does not vanish declared or not."""
    atoms = symbols_of(draw)
    below = finite(draw, 2, (*atoms, draw.choice(FREE)))
    above = finite(draw, 2, atoms)
    left = above / below if below != 0 else above
    right = rewritten(left, draw, 2)
    if draw.random() < 0.3:
        right = distorted(right, draw)
    nonzero = (below,) if draw.random() < 0.5 and below.free_symbols else ()
    return Equation(left, right, (), nonzero, kind="divisors", lenient=True)


def roots(draw: Random) -> Equation:
    """Square roots, absolute values and signs against each other."""
    x, y = (draw.choice((*FREE, *ASSUMED[:3], ASSUMED[5])) for _ in range(2))
    a, b = draw.choice((x, x + sp.pi, x - y, x * y)), draw.choice((y, y + 1, x))
    pairs = [
        (sqrt(a**2), Abs(a)),
        (sqrt(a**2), a),
        (sqrt(a) * sqrt(b), sqrt(a * b)),
        (sqrt(a / b), sqrt(a) / sqrt(b)) if b != 0 else (a, a),
        (sign(a) * Abs(a), a),
        (sign(a * b), sign(a) * sign(b)),
        (sqrt(a**2 * b), Abs(a) * sqrt(b)),
        (Abs(a + b), Abs(a) + Abs(b)),
        (Abs(a * b), Abs(a) * Abs(b)),
        (sqrt(a**2 + b**2) ** 2, a**2 + b**2),
        (Abs(a) ** 2, a**2),
        (sqrt(a**4), a**2),
        (sqrt(sp.pi) * sqrt(a), sqrt(sp.pi * a)),
        (sign(a) ** 2, 1),
        (sqrt(sin(x) ** 2), sin(x)),
        (sqrt(1 - sin(x) ** 2), Abs(cos(x))),
    ]
    left, right = draw.choice(pairs)
    c = draw.choice((sp.Integer(1), number(draw), x))
    given = () if draw.random() < 0.75 else (draw.choice((Eq(cos(a), 0), Eq(x, y), Eq(x**2, 2), Eq(x * y, 1))),)
    given = tuple(e for e in given if e not in (sp.true, sp.false))
    return Equation(sp.sympify(left * c), sp.sympify(right * c), given, kind="roots", lenient=True)


FAMILIES: tuple[tuple[Family, int], ...] = (
    (twins, 4), (given_values, 3), (divisors, 2), (roots, 3), (matrices, 1), (contradictory, 2), (elementary, 4),
    (imaginary, 2),
)  # fmt: skip


def question(draw: Random) -> Equation:
    """A question of one of the families."""
    families, weights = zip(*FAMILIES, strict=True)
    return draw.choices(families, weights)[0](draw)  # type: ignore[no-any-return]
