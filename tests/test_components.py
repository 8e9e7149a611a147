"""Questions on vectors, dyadics, quaternions, arrays and relations of SymPy's are decided by their components."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
import sympy as sp
from sympy import Abs, Eq, Function, Matrix, Ne, Rational, cos, sin, sqrt
from sympy.algebras.quaternion import Quaternion
from sympy.physics.mechanics import inertia
from sympy.physics.vector import ReferenceFrame, dynamicsymbols, outer
from sympy.vector import CoordSys3D, Cross, Curl, Divergence, Dot, Gradient, Laplacian, curl

from chasles.prove import Rejected, Untreatable, prove, recheck
from chasles.verdict import Fails

x, y, z, a, b, c = sp.symbols("x y z a b c", real=True)
p, q = sp.symbols("p q", positive=True)
X = sp.Symbol("X")
angle, other = dynamicsymbols("theta phi")
A = ReferenceFrame("A")
B = A.orientnew("B", "Axis", (angle, A.z))
C = B.orientnew("C", "Axis", (other, B.x))
u = a * B.x + b * C.y + c * angle * A.z
N = CoordSys3D("N")
M = N.orient_new_axis("M", a, N.k)
S = N.create_new("S", transformation="spherical")
v, w = a * N.i + N.x * N.j, y * N.i + z * N.k
f = Function("f")(N.x, N.y)
one, two = Quaternion(a, b, c, x), Quaternion(y, z, 1, 2)

TRUE: list[tuple[Any, Any, dict[str, Any]]] = [
    (u.dt(A), u.dt(C) + (C.ang_vel_in(A) ^ u), {}),
    (C.ang_vel_in(A), angle.diff() * A.z + other.diff() * C.x, {}),
    (C.ang_acc_in(A), angle.diff().diff() * A.z + other.diff().diff() * C.x + angle.diff() * other.diff() * B.y, {}),
    (inertia(B, 1, 2, 3).dot(u), inertia(B, 1, 2, 3) & u, {}),
    (outer(u, B.x).dot(B.x), u, {}),
    (u - u, 0, {}),
    (u.dot(u), 0, {"given": [u]}),
    (M.i, cos(a) * N.i + sin(a) * N.j, {}),
    (Dot(v, Cross(v, w)), 0, {}),
    (Cross(v, w), -Cross(w, v), {}),
    (Curl(Gradient(f)), 0, {}),
    (Divergence(S.r**2 * S.i), 4 * S.r, {}),
    (Laplacian(N.x**3), 6 * N.x, {}),
    (v | w, a * (N.i | w) + N.x * (N.j | w), {}),
    (v.dot(v), w.dot(w), {"given": Eq(v, w)}),
    ((one * two).norm(), one.norm() * two.norm(), {}),
    (one * one.conjugate(), a**2 + b**2 + c**2 + x**2, {}),
    ([x + x, y], (2 * x, y), {}),
    (sp.Array([[x, 1], [2, y]]), Matrix([[x, 1], [2, y]]), {}),
    (np.array([1, 2]), Matrix([1, 2]), {}),
    (sp.Poly(x**2 - 1, x), (x - 1) * (x + 1), {}),
]
RELATIONS = [
    Eq(sin(x) ** 2, 1 - cos(x) ** 2), x**2 + y**2 + z**2 >= x * y + y * z + z * x, 2 * x * y <= x**2 + y**2,
    X**2 + 1 > 0, x**2 - x * y + y**2 > -1, Ne(X**2 + 1, 0), (p + q) / 2 >= sqrt(p * q), Abs(x) + Abs(y) >= Abs(x + y),
    (a**2 + b**2 + c**2) * (x**2 + y**2 + z**2) >= (a * x + b * y + c * z) ** 2, sin(x) + cos(y) <= 2,
    sqrt(a**2 + b**2 + c**2) * sqrt(x**2 + y**2 + z**2) >= a * x + b * y + c * z, sqrt(p + q) <= sqrt(p) + sqrt(q),
    sqrt(a**2 + b**2) + sqrt(x**2 + y**2) >= sqrt((a + x) ** 2 + (b + y) ** 2), sqrt(p * q) >= 2 / (1 / p + 1 / q),
    a * cos(x) + b * sin(x) <= sqrt(a**2 + b**2), sin(x) * cos(x) <= Rational(1, 2), sin(x) + cos(x) <= sqrt(2),
]  # fmt: skip
FALSE = [
    (u.dt(A), u.dt(C) - (C.ang_vel_in(A) ^ u)), (M.i, cos(a) * N.i - sin(a) * N.j), (curl(v), 2 * N.k),
    (one * two, two * one), (3 * Cross(w, v), Cross(v, w)), (x**2 >= x, None), (x > x**2 - 1, None), (Ne(x, y), None),
    (Abs(x + y) >= Abs(x) + Abs(y), None), (sqrt(p + q) >= sqrt(p) + sqrt(q), None),
    (a * cos(x) + b * sin(x) <= Abs(a), None), (sin(x) * cos(x) <= Rational(1, 3), None), ([x, y], [y, x]),
]  # fmt: skip


@pytest.mark.parametrize(("left", "right", "more"), TRUE)
def test_what_is_true_of_components_holds(left: Any, right: Any, more: dict[str, Any]) -> None:
    verdict = prove(left, right, **more)
    assert verdict.true
    recheck(verdict, left, right, **more)


@pytest.mark.parametrize("relation", RELATIONS)
def test_a_true_relation_holds(relation: Any) -> None:
    verdict = prove(relation)
    assert verdict.true
    recheck(verdict, relation)


@pytest.mark.parametrize(("left", "right"), FALSE)
def test_what_is_false_of_components_has_a_counterexample(left: Any, right: Any) -> None:
    verdict = prove(left, right)
    assert isinstance(verdict, Fails)
    recheck(verdict, left, right)


@pytest.mark.parametrize(
    ("left", "right", "why"),
    [
        (A.x, ReferenceFrame("D").x, "nothing turns into each other"),
        (A.x + B.x, Matrix([1, 0, 0]), "does not say whether it is in A or B"),
        (N.x, M.x, "coordinates of M and N"),
        (S.i + N.i, N.i, "not all are Cartesian"),
        (x**2, None, "no equation and no inequality"),
        (Eq(x, x), None, "SymPy has made of a relation"),
    ],
)
def test_what_has_no_common_components_is_refused(left: Any, right: Any, why: str) -> None:
    with pytest.raises(Untreatable, match=why):
        prove(left, right)


def test_a_proof_of_one_equation_of_vectors_is_none_of_another() -> None:
    verdict = prove(M.i, cos(a) * N.i + sin(a) * N.j)
    for right in (cos(a) * N.i - sin(a) * N.j, N.i, 0 * N.i):
        with pytest.raises(Rejected):
            recheck(verdict, M.i, right)
    with pytest.raises(Rejected):
        recheck(prove(X**2 >= 2 * X - 1), X**2 >= 2 * X)


def test_coordinates_do_not_take_the_name_of_a_symbol() -> None:
    assert isinstance(prove(N.x, sp.Symbol("N_x")), Fails)
    assert prove(N.x * Rational(1, 2), N.x / 2).true
