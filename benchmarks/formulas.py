"""The timed formulas as the book prints them, typed once over scalars of any algebra.

Every generator is handed the same expression and keeps its own sharing, ordering and printing. Matrix products are
taken from left to right, as typed. The rate of N, whose printed form (3.96a) is wrong, is N's derivative by the chain
rule with (3.76a) in place of the rates of e and phi.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import prod
from typing import Any

Shape = tuple[int, ...]


class Matrix:
    """A matrix of scalars, row by row; a scalar factor or divisor stands on the right."""

    def __init__(self, rows: Sequence[Sequence[Any]]) -> None:
        self.rows = [list(row) for row in rows]

    def __add__(self, other: Matrix) -> Matrix:
        return Matrix([[x + y for x, y in zip(*pair, strict=True)] for pair in zip(self.rows, other.rows, strict=True)])

    def __sub__(self, other: Matrix) -> Matrix:
        return Matrix([[x - y for x, y in zip(*pair, strict=True)] for pair in zip(self.rows, other.rows, strict=True)])

    def __mul__(self, scalar: Any) -> Matrix:
        return Matrix([[x * scalar for x in row] for row in self.rows])

    def __truediv__(self, scalar: Any) -> Matrix:
        return Matrix([[x / scalar for x in row] for row in self.rows])

    def __matmul__(self, other: Matrix) -> Matrix:
        columns = list(zip(*other.rows, strict=True))
        return Matrix([[dot(row, column) for column in columns] for row in self.rows])

    @property
    def T(self) -> Matrix:
        """The transpose."""
        return Matrix(list(zip(*self.rows, strict=True)))

    @property
    def flat(self) -> list[Any]:
        """The entries, row by row."""
        return [x for row in self.rows for x in row]


def dot(one: Sequence[Any], other: Sequence[Any]) -> Any:
    """The sum of the products, without the products with a zero that stands in a matrix."""
    terms = [x * y for x, y in zip(one, other, strict=True) if not (is_zero(x) or is_zero(y))]
    return sum(terms[1:], terms[0]) if terms else 0


def is_zero(entry: Any) -> bool:
    """Whether the entry is the number 0 of a pattern, not an expression."""
    return isinstance(entry, int) and entry == 0


ONE = Matrix([[1, 0, 0], [0, 1, 0], [0, 0, 1]])


def cross_matrix(v: Matrix) -> Matrix:
    """CPM(v), (2.38)."""
    x, y, z = v.flat
    return Matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def rotation(f: Any, e: Matrix, phi: Any) -> Matrix:
    """Q, (2.49)."""
    return e @ e.T + (ONE - e @ e.T) * f.cos(phi) + cross_matrix(e) * f.sin(phi)


def rate_matrix(f: Any, e: Matrix, phi: Any) -> Matrix:
    """N, (3.76b)."""
    upper = (ONE - e @ e.T) * (f.sin(phi) / (2 * (1 - f.cos(phi)))) - cross_matrix(e) / 2
    return Matrix([*upper.rows, *e.T.rows])


def rate_matrix_dot(f: Any, e: Matrix, phi: Any, omega: Matrix) -> Matrix:
    """The derivative of (3.76b), with (3.76a) for the rates of e and phi."""
    k = f.sin(phi) / (2 * (1 - f.cos(phi)))
    *upper, last = (rate_matrix(f, e, phi) @ omega).rows
    e_dot, phi_dot = Matrix(upper), last[0]
    k_dot = -phi_dot / (2 * (1 - f.cos(phi)))
    block = (ONE - e @ e.T) * k_dot - (e_dot @ e.T + e @ e_dot.T) * k - cross_matrix(e_dot) / 2
    return Matrix([*block.rows, *e_dot.T.rows])


def axis_point(f: Any, e: Matrix, phi: Any, a: Matrix, a_moved: Matrix) -> Matrix:
    """The screw axis's point, (3.18)."""
    Q = rotation(f, e, phi)
    return (Q - ONE).T @ (Q @ a - a_moved) / (2 * (1 - f.cos(phi)))


def steiner(f: Any, I_C: Matrix, m: Any, c: Matrix, a: Matrix) -> Matrix:
    """I_A, (3.133)."""
    d = c - a
    return I_C + (ONE * (d.T @ d).rows[0][0] - d @ d.T) * m


def newton_euler(f: Any, I_C: Matrix, m: Any, t: Matrix, t_dot: Matrix) -> Matrix:
    """The wrench, (3.139)."""
    M = Matrix([[*row, 0, 0, 0] for row in I_C.rows] + [[0] * k + [m] + [0] * (5 - k) for k in (3, 4, 5)])
    W = Matrix([[*row, 0, 0, 0] for row in cross_matrix(Matrix(t.rows[:3])).rows] + [[0] * 6] * 3)
    return M @ t_dot + W @ M @ t


def full(six: Matrix) -> Matrix:
    """The symmetric matrix of (xx, xy, xz, yy, yz, zz)."""
    xx, xy, xz, yy, yz, zz = six.flat
    return Matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def steiner_sym6(f: Any, I_C: Matrix, m: Any, c: Matrix, a: Matrix) -> Matrix:
    """I_A in six numbers, (3.133)."""
    (xx, xy, xz), (_, yy, yz), (_, _, zz) = steiner(f, full(I_C), m, c, a).rows
    return Matrix([[xx], [xy], [xz], [yy], [yz], [zz]])


def newton_euler_sym6(f: Any, I_C: Matrix, m: Any, t: Matrix, t_dot: Matrix) -> Matrix:
    """The wrench of an inertia in six numbers, (3.139)."""
    return newton_euler(f, full(I_C), m, t, t_dot)


@dataclass(frozen=True)
class Kernel:
    """A formula, the kernel of chasles that computes it, and the shapes of what goes in and comes out."""

    name: str
    title: str
    formula: Callable[..., Matrix]
    inputs: dict[str, Shape]
    output: Shape
    singular: bool = False

    @property
    def signature(self) -> str:
        """The generalised ufunc's signature."""
        spelled = ["(" + ",".join(map(str, shape)) + ")" for shape in (*self.inputs.values(), self.output)]
        return ",".join(spelled[:-1]) + "->" + spelled[-1]

    @property
    def size(self) -> int:
        """How many entries the result has."""
        return prod(self.output)

    def of(self, functions: Any, *values: Sequence[Any]) -> list[Any]:
        """The entries of the result, row by row, for the entries of each input, with the functions sin and cos."""
        shaped = [
            Matrix([flat[3 * i : 3 * i + 3] for i in range(3)])
            if len(shape) == 2
            else Matrix([[x] for x in flat])
            if shape
            else flat[0]
            for flat, shape in zip(values, self.inputs.values(), strict=True)
        ]
        return self.formula(functions, *shaped).flat

    def symbols(self, make: Callable[[str], Any]) -> list[list[Any]]:
        """A scalar for each entry of each input: `e_0`, `e_1`, ..., `phi`."""
        return [
            [make(f"{name}_{i}") for i in range(prod(shape))] if shape else [make(name)]
            for name, shape in self.inputs.items()
        ]


AXIS = {"e": (3,), "phi": ()}
BODY = {"I": (3, 3), "m": ()}
BODY6 = {"I": (6,), "m": ()}
POINTS: dict[str, Shape] = {"c": (3,), "a": (3,)}
TWIST: dict[str, Shape] = {"t": (6,), "td": (6,)}

KERNELS = (
    Kernel("rotation_from_axis_angle", "Q", rotation, AXIS, (3, 3), True),
    Kernel("natural_rate_matrix", "N", rate_matrix, AXIS, (4, 3), True),
    Kernel("natural_rate_matrix_dot", "dN/dt", rate_matrix_dot, {**AXIS, "w": (3,)}, (4, 3), True),
    Kernel("screw_axis_point", "p0", axis_point, {**AXIS, "a": (3,), "b": (3,)}, (3,), True),
    Kernel("inertia_about_point", "Steiner", steiner, {**BODY, **POINTS}, (3, 3)),
    Kernel("newton_euler_wrench", "Newton-Euler", newton_euler, {**BODY, **TWIST}, (6,)),
    Kernel("inertia_about_point_sym6", "Steiner sym6", steiner_sym6, {**BODY6, **POINTS}, (6,)),
    Kernel("newton_euler_wrench_sym6", "Newton-Euler sym6", newton_euler_sym6, {**BODY6, **TWIST}, (6,)),
)
