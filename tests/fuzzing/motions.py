"""Questions on functions of time, of which differential equations or constraints are given at all times."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from random import Random
from typing import Any

import sympy as sp
from sympy import Eq, Rational, cos, sin

from .equations import Equation, pairs

__all__ = ["FAMILIES", "SYSTEMS", "question"]

t = sp.Symbol("t")
f, g, h, th, ps = (sp.Function(name)(t) for name in ("f", "g", "h", "theta", "psi"))
a, b = sp.symbols("a b")
J1, J2, J3 = (sp.Symbol(f"J{i}", positive=True) for i in (1, 2, 3))

System = tuple[tuple[Any, ...], tuple[Any, ...]]
"""Given equations, and the functions of which they speak."""


def d(e: Any, times: int = 1) -> Any:
    """The time derivative."""
    return sp.diff(e, t, times)


EULER = (
    Eq(J1 * d(f), (J2 - J3) * g * h),
    Eq(J2 * d(g), (J3 - J1) * h * f),
    Eq(J3 * d(h), (J1 - J2) * f * g),
)

# Equations of which motions through almost every point satisfy all: derivatives alone are determined.
SYSTEMS: dict[str, System] = {
    "growth": ((Eq(d(th), th),), (th,)),
    "decay": ((Eq(d(th), -2 * th),), (th,)),
    "oscillator": ((Eq(d(th, 2), -th),), (th,)),
    "damped": ((Eq(d(th, 2), -d(th) - th),), (th,)),
    "driven by its rate": ((Eq(d(f), d(g) + g),), (f, g)),
    "each other's rate": ((Eq(d(g), f), Eq(d(f), g)), (f, g)),
    "turning": ((Eq(d(f), g), Eq(d(g), -f)), (f, g)),
    "chain": ((Eq(d(f), g), Eq(d(g), h), Eq(d(h), f)), (f, g, h)),
    "second of the other": ((Eq(d(f, 2), g), Eq(d(g), -f)), (f, g)),
    "third": ((Eq(d(f, 3), f),), (f,)),
    "pendulum": ((Eq(d(th, 2), -sin(th)),), (th,)),
    "pendulum with friction": ((Eq(d(th, 2), -a * sin(th) - b * d(th)),), (th,)),
    "logistic": ((Eq(d(f), f - f**2),), (f,)),
    "riccati": ((Eq(d(f), f**2 + 1),), (f,)),
    "lotka": ((Eq(d(f), f * (1 - g)), Eq(d(g), g * (f - 1))), (f, g)),
    "duffing": ((Eq(d(f, 2), -f - f**3),), (f,)),
    "van der pol": ((Eq(d(f, 2), (1 - f**2) * d(f) - f),), (f,)),
    "lorenz": ((Eq(d(f), 3 * (g - f)), Eq(d(g), f * (2 - h) - g), Eq(d(h), f * g - h)), (f, g, h)),
    "euler": (EULER, (f, g, h)),
    "kinematics": ((Eq(d(th), f), Eq(d(f), -sin(th))), (th, f)),
    "rolling": ((Eq(d(f), a * d(th)), Eq(d(th, 2), -b * f)), (f, th)),
    "angles that follow": ((Eq(d(th), d(ps)), Eq(d(ps, 2), -ps)), (th, ps)),
    "steady turn": ((Eq(d(th), a),), (th,)),
    "angle from angle": ((Eq(d(th), 2 * ps), Eq(d(ps), -th)), (th, ps)),
    "free fall": ((Eq(d(f, 2), -a),), (f,)),
    "constant rate of an angle": ((Eq(d(th, 2), 0),), (th,)),
}  # fmt: skip

# Constraints between positions, which motions keep.
CONSTRAINTS: dict[str, System] = {
    "circle": ((Eq(f**2 + g**2, 1),), (f, g)),
    "sphere": ((Eq(f**2 + g**2 + h**2, 4),), (f, g, h)),
    "line": ((Eq(f + 2 * g, 3),), (f, g)),
    "hyperbola": ((Eq(f * g, 1),), (f, g)),
    "circle run through": ((Eq(f**2 + g**2, 1), Eq(d(f), -g)), (f, g)),
    "circle by an angle": ((Eq(f, cos(th)), Eq(g, sin(th))), (f, g, th)),
    "angles in balance": ((Eq(th + ps, sp.pi / 2),), (th, ps)),
    "equal angles": ((Eq(th, ps),), (th, ps)),
    "parabola": ((Eq(g, f**2), Eq(d(f), 1)), (f, g)),
    "closing chain": ((Eq(cos(th) + cos(ps), 1), Eq(f, sin(th))), (th, ps, f)),
    "product": ((Eq(f * g, h),), (f, g, h)),
}

# Given equations that no motion satisfies.
CONTRADICTIONS: dict[str, System] = {
    "circle with a radial rate": ((Eq(f**2 + g**2, 1), Eq(f * d(f) + g * d(g), 1)), (f, g)),
    "constant with a rate": ((Eq(f, 1), Eq(d(f), 1)), (f,)),
    "growth of a constant": ((Eq(d(f), f), Eq(f, a), Eq(a, 1)), (f,)),
    "oscillator held": ((Eq(d(th, 2), -th), Eq(th, 1)), (th,)),
    "two rates": ((Eq(d(f), g), Eq(d(f), g + 1)), (f, g)),
    "square below zero": ((Eq(f**2, -1), Eq(d(f), g)), (f, g)),
    "late contradiction": ((Eq(d(f), g), Eq(d(g), 0), Eq(d(f, 2), 1)), (f, g)),
}


def vocabulary(draw: Random, functions: Sequence[Any], depth: int) -> list[Any]:
    """The functions, some of their rates, and cosines and sines of those that are angles."""
    words: list[Any] = []
    for function in functions:
        words += [function, *(d(function, k) for k in range(1, depth + 1))]
        if function in (th, ps) or draw.random() < 0.15:
            words += [cos(function), sin(function)]
    return words


def polynomial(draw: Random, words: Sequence[Any], terms: int = 3) -> Any:
    """A small polynomial in the words."""
    total = sp.Integer(0)
    for _ in range(draw.randint(1, terms)):
        term = sp.Integer(draw.choice((-2, -1, 1, 1, 2, 3)))
        for _ in range(draw.randint(1, 2)):
            term *= draw.choice(words)
        total += term
    return total


def consequence(draw: Random) -> Equation:
    """A true one: an expression, and the same with multiples of the given equations and of their rates added."""
    kind, (given, functions) = draw.choice(sorted((SYSTEMS if draw.random() < 0.7 else CONSTRAINTS).items()))
    words = vocabulary(draw, functions, draw.randint(1, 2))
    left = polynomial(draw, words)
    right = left
    for _ in range(draw.randint(1, 2)):
        ((one, other),) = pairs(draw.choice(given))
        factor = draw.choice((sp.Integer(1), sp.Integer(-1), draw.choice(words)))
        right += d(factor * (one - other), draw.choice((0, 0, 1, 1, 2)))
    right = sp.expand(right) if draw.random() < 0.6 else right
    if draw.random() < 0.4:
        left, right = d(left), d(right)
    return Equation(left, right, given, kind=kind, truth=True)


def solved_for(draw: Random) -> Equation:
    """A true one: rates that the given equations determine are put in, as often as there are any."""
    kind, (given, functions) = draw.choice(sorted(SYSTEMS.items()))
    left = polynomial(draw, vocabulary(draw, functions, 2), 2)
    left = d(left, draw.choice((0, 1, 1)))
    right = left
    for _ in range(8):
        put = _put_in(right, given)
        if put == right:
            break
        right = put
    return Equation(left, sp.expand(right), given, kind=kind, truth=True)


def _put_in(e: Any, given: Sequence[Any]) -> Any:
    """The expression with the highest rates that are given, or rates of them, replaced once."""
    rules: dict[Any, Any] = {}
    for item in given:
        one, other = item.lhs, item.rhs
        factor, rate = one.as_independent(sp.Derivative, as_Add=False)
        if not isinstance(rate, sp.Derivative):
            continue
        for found in sorted(e.atoms(sp.Derivative), key=str):
            extra = found.derivative_count - rate.derivative_count
            if found.expr == rate.expr and extra >= 0:
                rules[found] = d(other / factor, extra) if extra else other / factor
    return e.xreplace(rules).doit()


def guess(draw: Random) -> Equation:
    """Anything: nobody knows whether it is true."""
    kind, (given, functions) = draw.choice(sorted((SYSTEMS if draw.random() < 0.6 else CONSTRAINTS).items()))
    words = vocabulary(draw, functions, draw.randint(0, 3))
    left, right = polynomial(draw, words, 2), polynomial(draw, words, 2)
    if draw.random() < 0.5:
        ((one, other),) = pairs(draw.choice(given))
        left, right = d(one, draw.randint(0, 2)), d(other, draw.randint(0, 1)) * draw.choice((1, 1, -1, 2))
    return Equation(left, right, given, kind=kind)


def with_a_function(draw: Random) -> Equation:
    """A true one in which sines or cosines of what is given, or of its rates, stand on both sides."""
    kind, (given, functions) = draw.choice(sorted((SYSTEMS if draw.random() < 0.7 else CONSTRAINTS).items()))
    ((one, other),) = pairs(draw.choice(given))
    outer = draw.choice((sin(draw.choice(functions)), cos(draw.choice(functions)), sin(2 * draw.choice(functions))))
    left = one * draw.choice((1, 2)) + outer
    right = other * draw.choice((1, 1, 2)) + outer
    truth = None
    if draw.random() < 0.6:
        left, right, truth = one - other + outer, outer, True
    return Equation(left, right, given, kind=kind, truth=truth)


def contradictory(draw: Random) -> Equation:
    """Given equations that no motion satisfies, and any claim."""
    kind, (given, functions) = draw.choice(sorted(CONTRADICTIONS.items()))
    words = vocabulary(draw, functions, 1)
    left = polynomial(draw, words, 2)
    right = left if draw.random() < 0.3 else polynomial(draw, words, 2)
    return Equation(left, right, given, kind=f"contradictory: {kind}", satisfiable=False, lenient=True)


def conserved(draw: Random) -> Equation:
    """Known first integrals, whole or with a slip."""
    energy = J1 * f**2 + J2 * g**2 + J3 * h**2
    momentum = J1**2 * f**2 + J2**2 * g**2 + J3**2 * h**2
    kind, quantity = draw.choice((
        ("euler", energy),
        ("euler", momentum),
        ("oscillator", d(th) ** 2 + th**2),
        ("pendulum", d(th) ** 2 / 2 - cos(th)),
        ("turning", f**2 + g**2),
        ("each other's rate", f**2 - g**2),
        ("duffing", d(f) ** 2 / 2 + f**2 / 2 + f**4 / 4),
        ("kinematics", f**2 / 2 - cos(th)),
        ("free fall", d(f) ** 2 / 2 + a * f),
        ("angles that follow", th - ps),
    ))  # fmt: skip
    truth: bool | None = True
    if draw.random() < 0.4:
        quantity, truth = quantity + Rational(1, 2) * polynomial(draw, vocabulary(draw, SYSTEMS[kind][1], 0), 1), None
    return Equation(d(quantity), sp.Integer(0), SYSTEMS[kind][0], kind=f"conserved: {kind}", truth=truth)


Family = Callable[[Random], Equation]
FAMILIES: tuple[tuple[Family, int], ...] = (
    (consequence, 3), (solved_for, 3), (guess, 3), (with_a_function, 3), (conserved, 1), (contradictory, 1),
)  # fmt: skip


def question(draw: Random) -> Equation:
    """A question of one of the families."""
    families, weights = zip(*FAMILIES, strict=True)
    return draw.choices(families, weights)[0](draw)  # type: ignore[no-any-return]
