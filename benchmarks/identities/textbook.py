"""Textbook identities: `textbook.txt` as SymPy's expressions."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import sympy
from sympy import Function, MatrixSymbol, eye, symbols

__all__ = ["Identity", "identities"]

HERE = Path(__file__).parent
t, n, i = symbols("t"), sympy.Symbol("n", integer=True, positive=True), sympy.Symbol("i", integer=True)
REAL = symbols("a b c d x y z alpha beta phi psi omega omega_0 v1 v2 v_x A_0", real=True)
POSITIVE = symbols("m m1 m2 k k_2 g l r mu J1 J2 J3 v_0 zeta omega_p m_0 c_e", positive=True)


class Identity(NamedTuple):
    """Two sides, what is given, and the line of the file."""

    text: str
    left: Any
    right: Any
    given: tuple[Any, ...]


def _skew(vector: Any) -> Any:
    return sympy.Matrix([[0, -vector[2], vector[1]], [vector[2], 0, -vector[0]], [-vector[1], vector[0], 0]])


def _rodrigues(e: Any, angle: Any) -> Any:
    return e * e.T + sympy.cos(angle) * (eye(3) - e * e.T) + sympy.sin(angle) * _skew(e)


NAMES: dict[str, Any] = {
    **vars(sympy),
    **{str(symbol): symbol for symbol in (*REAL, *POSITIVE, t, n, i)},
    **{name: Function(name)(t) for name in ("q", "th", "w1", "w2", "w3")},
    **{name: sympy.Matrix(symbols(f"{name}_1:4", real=True)) for name in "uvw"},
    "M": sympy.Matrix(3, 3, symbols("M_1:4(1:4)", real=True)),
    "A": MatrixSymbol("A", 2, 2),
    "B": MatrixSymbol("B", 2, 2),
    "r1": sympy.Matrix([Function(f"r_{k}")(t) for k in (1, 2, 3)]),
    "skew": _skew,
    "rodrigues": _rodrigues,
    "Rz": lambda x: sympy.Matrix([[sympy.cos(x), -sympy.sin(x), 0], [sympy.sin(x), sympy.cos(x), 0], [0, 0, 1]]),
    "Rx": lambda x: sympy.Matrix([[1, 0, 0], [0, sympy.cos(x), -sympy.sin(x)], [0, sympy.sin(x), sympy.cos(x)]]),
}


def _sides(text: str) -> tuple[Any, Any]:
    left, right = (sympy.sympify(eval(side, dict(NAMES))) for side in text.split(" == "))
    return left, right


def identities() -> Iterator[Identity]:
    """All of them, in the order of the file."""
    for line in (HERE / "textbook.txt").read_text("utf-8").splitlines():
        if line and not line.startswith("#"):
            claim, *given = line.split(" | given ")
            left, right = _sides(claim)
            equations = tuple(_equation(*_sides(one)) for one in given)
            yield Identity(line, left, right, equations)


def _equation(left: Any, right: Any) -> Any:
    return left - right if isinstance(left, sympy.MatrixBase) else sympy.Eq(left, right, evaluate=False)
