"""The book's equations against `sympy.physics`, which no one here wrote; each comparison is decided by the prover.

The right side of a statement is read into SymPy at explicit motions, with Euler angles and coordinates that are any
functions of time, and the prover is asked whether it is what SymPy says. Beside each oracle the same question is asked
of a mutant, which must be refuted: an oracle that nods at everything is none.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import reduce
from itertools import product
from operator import add, mul
from typing import Any

import pytest
import sympy
from chasles.derivations import notation as n
from sympy.physics.mechanics import (
    Point,
    ReferenceFrame,
    RigidBody,
    dynamicsymbols,
    inertia,
    inertia_of_point_mass,
)
from sympy.physics.vector import Dyadic, Vector, kinematic_equations

from chasles.prove import prove
from chasles.statements import Statement, load
from chasles.vocabulary import Integral, Negative, Node, Sum

from .sampling import sample
from .sympy_words import TIME, in_sympy

STATEMENTS = {entry.key: entry.statement for entry in load() if isinstance(entry.statement, Statement)}
AXES = tuple(sympy.eye(3).col(k) for k in range(3))
ORDERS = tuple(f"{i}{j}{k}" for i, j, k in product("123", repeat=3) if j not in (i, k))
CASES = tuple(product(("body", "space"), ORDERS))
ANGLES = dynamicsymbols("q1:4")
SPEEDS = dynamicsymbols("u1:4")
Values = Mapping[Node, sympy.Matrix]


def right(number: str, values: Values, part: int = 1) -> sympy.Matrix:
    """What an equation of the book says its left side is."""
    return in_sympy(STATEMENTS[number, part].right, values)


def mutants(number: str, values: Values, part: int = 1) -> list[sympy.Matrix]:
    """What it would say with the sign of one of its terms turned."""
    side = STATEMENTS[number, part].right
    assert isinstance(side, Sum)
    turned = [Sum((*side.terms[:k], Negative(term), *side.terms[k + 1 :])) for k, term in enumerate(side.terms)]
    return [in_sympy(each, values) for each in turned]


def equal(ours: Any, theirs: Any, **conditions: Any) -> bool:
    verdict = prove(ours, theirs, **conditions)
    assert verdict.name in ("holds", "holds-under", "fails"), verdict
    return verdict.true


def elementary(axis: str, angle: Any) -> sympy.Matrix:
    """The rotation (2.49) about an axis of the frame."""
    return right("2.49", {n.e: AXES[int(axis) - 1], n.phi: sympy.Matrix([[angle]])})


def turning(kind: str, order: str) -> sympy.Matrix:
    """The rotation of a body turned three times, about axes of its own or of the fixed frame."""
    turns = [elementary(axis, angle) for axis, angle in zip(order, ANGLES, strict=True)]
    return reduce(mul, turns if kind == "body" else turns[::-1])


def spin(Q: sympy.Matrix) -> sympy.Matrix:
    """The angular velocity (3.45) of a rotation in the fixed frame."""
    return right("3.45", {n.Omega: right("3.44", {n.Q: Q})})


def frames(kind: str, order: str) -> tuple[ReferenceFrame, ReferenceFrame]:
    fixed, moving = ReferenceFrame("F"), ReferenceFrame("M")
    (moving.orient_body_fixed if kind == "body" else moving.orient_space_fixed)(fixed, ANGLES, order)
    return fixed, moving


@pytest.mark.sampled(17)
@pytest.mark.parametrize(("kind", "order"), CASES)
def test_angular_velocities(kind: str, order: str) -> None:
    fixed, moving = frames(kind, order)
    Q = turning(kind, order)
    omega = spin(Q)
    assert equal(Q, fixed.dcm(moving))
    assert not equal(Q, moving.dcm(fixed))
    theirs = moving.ang_vel_in(fixed)
    assert equal(omega, theirs.to_matrix(fixed))
    assert equal(Q.T * omega, theirs.to_matrix(moving))
    assert not equal(omega, theirs.to_matrix(moving))


@pytest.mark.sampled(17)
@pytest.mark.parametrize(("kind", "order"), CASES)
def test_kinematic_equations(kind: str, order: str) -> None:
    Q = turning(kind, order)
    known = dict(zip(SPEEDS, Q.T * spin(Q), strict=True))
    equations = sympy.Matrix(kinematic_equations(SPEEDS, ANGLES, kind, order))
    assert equal(equations.subs(known), sympy.zeros(3, 1))
    assert not equal(equations.subs(dict(zip(SPEEDS, spin(Q), strict=True))), sympy.zeros(3, 1))


def test_kinematic_equations_of_euler_rodrigues_parameters() -> None:
    fixed, moving = ReferenceFrame("F"), ReferenceFrame("M")
    parameters = dynamicsymbols("r0:4")
    q_0, q = sympy.Matrix([parameters[0]]), sympy.Matrix(parameters[1:])
    unit = {"given": [sympy.Eq(sum(x**2 for x in parameters), 1)]}
    Q = right("text 3.4.2 f", {n.q: q, n.q_0: q_0}, part=2)
    moving.orient_quaternion(fixed, parameters)
    assert equal(Q, fixed.dcm(moving), **unit)
    # SymPy writes the half as a floating-point number.
    theirs = sympy.nsimplify(sympy.Matrix(kinematic_equations(SPEEDS, parameters, "quaternion")), rational=True)
    ours = Q.T * spin(Q)
    assert equal(theirs.subs(dict(zip(SPEEDS, ours, strict=True))), sympy.zeros(4, 1), **unit)
    assert not equal(theirs.subs(dict(zip(SPEEDS, -ours, strict=True))), sympy.zeros(4, 1), **unit)


class Moving:
    """A point P in a frame that turns and whose origin moves, in SymPy and in the book's symbols."""

    def __init__(self, *, fixed_in_frame: bool) -> None:
        self.fixed, self.frame = frames("body", "313")
        letters = dynamicsymbols("x:3"), sympy.symbols("y:3") if fixed_in_frame else dynamicsymbols("y:3")
        place, within = (sympy.Matrix(each) for each in letters)
        home, self.origin, self.point = Point("H"), Point("O"), Point("P")
        home.set_vel(self.fixed, 0)
        self.origin.set_pos(home, vector_of(place, self.fixed))
        self.origin.set_vel(self.fixed, vector_of(place.diff(TIME), self.fixed))
        self.point.set_pos(self.origin, vector_of(within, self.frame))
        self.point.set_vel(self.frame, vector_of(within.diff(TIME), self.frame))
        Q = turning("body", "313")
        self.values: dict[Node, sympy.Matrix] = {
            n.Q: Q, n.Omega: Q.diff(TIME) * Q.T, n.omega: spin(Q), n.o: place, n.a: place, n.rho_M: within,
            n.p: place + Q * within,
        }  # fmt: skip


def vector_of(components: sympy.Matrix, frame: ReferenceFrame) -> Vector:
    return sum((x * axis for x, axis in zip(components, frame, strict=True)), Vector(0))


def check(number: str, moving: Moving, theirs: Vector) -> None:
    said = theirs.to_matrix(moving.fixed)
    assert equal(right(number, moving.values), said)
    assert not any(equal(mutant, said) for mutant in sample(mutants(number, moving.values), 11))


def test_velocity_of_two_points_of_a_body() -> None:
    body = Moving(fixed_in_frame=True)
    check("3.50", body, body.point.v2pt_theory(body.origin, body.fixed, body.frame))


def test_acceleration_of_two_points_of_a_body() -> None:
    body = Moving(fixed_in_frame=True)
    check("3.89", body, body.point.a2pt_theory(body.origin, body.fixed, body.frame))


def test_velocity_in_a_moving_frame() -> None:
    moving = Moving(fixed_in_frame=False)
    check("3.103", moving, moving.point.v1pt_theory(moving.origin, moving.fixed, moving.frame))


@pytest.mark.slow
def test_acceleration_in_a_moving_frame() -> None:
    moving = Moving(fixed_in_frame=False)
    check("3.105", moving, moving.point.a1pt_theory(moving.origin, moving.fixed, moving.frame))


class Body:
    """A few point masses, in SymPy's dyadics and in the book's integrals."""

    def __init__(self) -> None:
        self.frame, self.about = ReferenceFrame("F"), Point("A")
        self.masses = sympy.symbols("m1:4", positive=True)
        self.places = [sympy.Matrix(sympy.symbols(f"{letter}1:4")) for letter in "xyz"]
        self.whole = sum(self.masses)
        self.center = sum((m * place for m, place in zip(self.masses, self.places, strict=True)), sympy.zeros(3, 1))
        self.center = self.center / self.whole
        self.a = sympy.Matrix(sympy.symbols("a1:4"))

    def integrated(self, node: Node, values: Values) -> sympy.Matrix:
        """The integral as the sum over the elements."""
        assert isinstance(node, Integral)
        here = zip(self.masses, self.places, strict=True)
        inside = ({n.rho: sympy.Matrix([m]), n.p: p, n.r_C: p - self.center} for m, p in here)
        return reduce(add, (in_sympy(node.of, {**values, **element}) for element in inside))

    def dyadic(self, point: sympy.Matrix) -> sympy.Matrix:
        """SymPy's moment of inertia with respect to a point."""
        parts = (
            inertia_of_point_mass(m, vector_of(place - point, self.frame), self.frame)
            for m, place in zip(self.masses, self.places, strict=True)
        )
        return sum(parts, Dyadic(0)).to_matrix(self.frame)


def test_moment_of_inertia_of_point_masses() -> None:
    body = Body()
    I_A = body.integrated(STATEMENTS["3.131", 1].right, {n.a: body.a})
    I_C = body.integrated(STATEMENTS["text 3.8 h", 1].right, {})
    assert equal(I_A, body.dyadic(body.a))
    assert equal(I_C, body.dyadic(body.center))
    assert not equal(I_A, body.dyadic(-body.a))
    assert not equal(I_A, -body.dyadic(body.a))


@pytest.mark.parametrize("number", ["3.133a", "3.133b"])
def test_parallel_axes(number: str) -> None:
    frame, center, about = ReferenceFrame("F"), Point("C"), Point("A")
    I = sympy.Matrix(3, 3, lambda i, j: sympy.Symbol(f"I{min(i, j)}{max(i, j)}"))
    m = sympy.Symbol("m")
    a, c = (sympy.Matrix(sympy.symbols(f"{letter}1:4")) for letter in "ac")
    about.set_pos(center, vector_of(a - c, frame))
    central = inertia(frame, I[0, 0], I[1, 1], I[2, 2], I[0, 1], I[1, 2], I[0, 2])
    theirs = RigidBody("B", center, frame, m, (central, center)).parallel_axis(about).to_matrix(frame)
    values = {n.I_C: I, n.m: sympy.Matrix([m]), n.a: a, n.c: c}
    assert equal(right(number, values), theirs)
    assert not any(equal(mutant, theirs) for mutant in mutants(number, values))


class Flying:
    """A rigid body in flight, with a constant inertia in its own axes."""

    def __init__(self) -> None:
        self.fixed, self.frame = frames("body", "321")
        self.center, home = Point("C"), Point("H")
        c = sympy.Matrix(dynamicsymbols("c1:4"))
        self.center.set_pos(home, vector_of(c, self.fixed))
        self.center.set_vel(self.fixed, vector_of(c.diff(TIME), self.fixed))
        main, m = sympy.symbols("J1:4"), sympy.Symbol("m")
        self.body = RigidBody("B", self.center, self.frame, m, (inertia(self.frame, *main), self.center))
        Q = turning("body", "321")
        self.values: dict[Node, sympy.Matrix] = {
            n.Omega: Q.diff(TIME) * Q.T, n.omega: spin(Q), n.c: c, n.m: sympy.Matrix([m]),
            n.I_C: Q * sympy.diag(*main) * Q.T,
        }  # fmt: skip


def test_kinetic_energy() -> None:
    flying = Flying()
    theirs = sympy.Matrix([[flying.body.kinetic_energy(flying.fixed)]])
    assert equal(right("3.144", flying.values), theirs)
    assert not any(equal(mutant, theirs) for mutant in mutants("3.144", flying.values))


def test_momenta() -> None:
    flying = Flying()
    linear = flying.body.linear_momentum(flying.fixed).to_matrix(flying.fixed)
    angular = flying.body.angular_momentum(flying.center, flying.fixed)
    assert equal(right("3.135", flying.values), linear)
    assert equal(right("3.135", flying.values, part=2), angular.to_matrix(flying.fixed))
    assert not equal(right("3.135", flying.values, part=2), angular.to_matrix(flying.frame))


def test_rate_of_angular_momentum() -> None:
    flying = Flying()
    theirs = flying.body.angular_momentum(flying.center, flying.fixed).dt(flying.fixed).to_matrix(flying.fixed)
    assert equal(right("3.136", flying.values, part=2), theirs)
    assert not any(equal(mutant, theirs) for mutant in sample(mutants("3.136", flying.values, part=2), 3))
