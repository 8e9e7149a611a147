"""A small book of our own: statements that ask for kernels, and the judge who decides them."""

from __future__ import annotations

from dataclasses import replace

import pytest

from chasles.decisions.session import Session
from chasles.lowering.declaration import requested
from chasles.lowering.lower import program_of
from chasles.statements import (
    Branch,
    Claim,
    Condition,
    Definition,
    Inverse,
    Kernel,
    nonzero,
    rotation,
    unit,
)
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    LENGTH,
    VELOCITY,
    Identity,
    Zero,
    abbreviation,
    array,
    column,
    cos,
    cot,
    cross,
    dot,
    inverse,
    matrix,
    norm,
    over,
    rate,
    row,
    scalar,
    sin,
    square,
    tr,
    uniform,
    vect,
    vector,
)

one, O, O_43 = Identity(3), Zero(3, 3), Zero(4, 3)
e = vector("e", "e", "unit vector along the axis")
phi = scalar("phi", r"\phi", "angle of rotation")
E = abbreviation("E", "E", CPM(e), "cross-product matrix of e")
Q = square("Q", "Q", "rotation")
a, a_, b, p = (vector(name, name, f"position {name}", LENGTH) for name in ("a", "a'", "b", "p"))
p_0, p_0_, n = (vector(name, name, f"position {name}", LENGTH) for name in ("p_0", "p_0'", "n"))
d_A, d_0 = (vector(name, name, "a displacement", LENGTH) for name in ("d_A", "d_0"))
A, B, P = (abbreviation(s.name.upper(), s.name.upper(), CPM(s), "its cross-product matrix") for s in (a, b, p))
omega = vector("omega", r"\omega", "angular velocity", FREQUENCY)
Omega = abbreviation("Omega", r"\Omega", CPM(omega), "cross-product matrix of omega")
v = vector("v", "v", "velocity", VELOCITY)
kappa = array("kappa", r"\kappa", "Pluecker array", column(e, n))
kappa_A = array("kappa_A", r"\kappa_A", "Pluecker array with the moment about A", column(e, n))
kappa_B = array("kappa_B", r"\kappa_B", "Pluecker array with the moment about B", column(e, n))
t = array("t", "t", "twist", column(omega, v))
t_A = array("t_A", "t_A", "twist at A", column(omega, v))
t_P = array("t_P", "t_P", "twist at P", column(omega, v))
U = array("U", "U", "transfer", matrix((one, O), (A, one)))
N, L, H, F = (array(name, name, "rates of invariants", uniform((4, 3))) for name in "NLHF")
T = array("T", "T", "rate of the pose from the twist", matrix((F, O_43), (O, one)))
s = array("s", "s", "pose", column(e, phi, a))
pitch = scalar("p'", "p'", "pitch of the instant screw", LENGTH)

turning = nonzero(1 - cos(phi), r"\phi \neq 0")
spinning = nonzero(norm(omega), r"\boldsymbol{\omega} \neq 0")
rotation_from_axis_angle = Definition(
    "2.49", Q, e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E, assuming=(unit(e),), kernel=Kernel(of=(e, phi))
)
normal_matrix_inverse = Claim(
    "3.16",
    inverse(column(Q - one, e.T).T @ column(Q - one, e.T)),
    1 / (2 * (1 - cos(phi))) * one + (1 - 2 * cos(phi)) / (2 * (1 - cos(phi))) * e @ e.T,
    given=(rotation_from_axis_angle,),
    assuming=(turning,),
    kernel=Kernel(of=(e, phi)),
)
displacement = Definition("3.3", d_A, a_ - a)
along_the_axis = Definition("3.6b", d_0, dot(e, d_A) * e)
screw_axis_point = Claim(
    "3.18",
    p_0,
    (Q - one).T @ (Q @ a - a_) / (2 * (1 - cos(phi))),
    given=(
        rotation_from_axis_angle,
        displacement,
        along_the_axis,
        Condition("3.8", dot(e, p_0), Zero(1, 1), on=(p_0,)),
        Condition("3.9a", d_0, d_A + (Q - one) @ (p_0 - a), on=(p_0,)),
    ),
    assuming=(turning,),
    kernel=Kernel(
        of=(e, phi, a, a_),
        form=over(1, 2) * ((one - e @ e.T) @ (a + a_) + cot(phi / 2) * cross(e, a_ - a)),
    ),
)
plucker_transfer = Definition(
    "3.29",
    kappa_B,
    U @ kappa_A,
    given=(Definition("3.29b", U, matrix((one, O), (A - B, one))),),
    kernel=Kernel(of=(kappa_A, a, b)),
)
velocity_of_point = Definition("3.50", rate(p), rate(a) + cross(omega, p - a), kernel=Kernel(of=(omega, rate(a), a, p)))
instant_screw_point = Definition(
    "3.70",
    p_0_,
    Omega @ (rate(a) - Omega @ a) / norm(omega) ** 2,
    assuming=(spinning,),
    kernel=Kernel(of=(omega, rate(a), a)),
)
instant_screw = Definition(
    "3.54",
    column(column(e, n), pitch),
    column(column(omega / norm(omega), cross(p_0_, omega / norm(omega))), dot(rate(a), omega) / norm(omega) ** 2),
    given=(instant_screw_point,),
    assuming=(spinning,),
    kernel=Kernel(of=(omega, rate(a), a), results=("axis", "pitch")),
)
natural_rate_matrix = Definition(
    "3.76b",
    N,
    column((sin(phi) / (2 * (1 - cos(phi)))) * (one - e @ e.T) - over(1, 2) * E, e.T),
    assuming=(unit(e), turning),
    kernel=Kernel(of=(e, phi)),
)
linear_rate_matrix = Definition(
    "3.76c",
    L,
    column(over(1, 2) * (tr(Q) * one - Q), -sin(phi) * e.T),
    given=(rotation_from_axis_angle,),
    kernel=Kernel(of=(e, phi)),
)
euler_rodrigues_rate_matrix = Definition(
    "3.76d",
    H,
    over(1, 2) * column(cos(phi / 2) * one - sin(phi / 2) * E, -sin(phi / 2) * e.T),
    kernel=Kernel(of=(e, phi)),
)
linear_velocity_matrix = Definition(
    "3.77c",
    L.T,
    row(one + sin(phi) / (1 + cos(phi)) * E, -sin(phi) / (1 + cos(phi)) * e),
    assuming=(nonzero(1 + cos(phi)),),
    kernel=Kernel(of=(e, phi), results=("L_tilde",)),
)
pose_rate_natural = Definition(
    "3.78",
    rate(s),
    T @ t,
    given=(Definition("3.79", T, matrix((F, O_43), (O, one))), Definition("3.79F", F, N), natural_rate_matrix),
    kernel=Kernel(of=(e, phi, t)),
)
twist_transfer = Definition(
    "3.83",
    t_P,
    U @ t_A,
    given=(Definition("3.83b", U, matrix((one, O), (A - P, one))),),
    kernel=Kernel(of=(t_A, a, p)),
)
axial_velocity_leaves = Definition(
    "3.57", v, -(1 / norm(omega) ** 2 * Omega**2 @ rate(a)), assuming=(spinning,), kernel=Kernel(of=(omega, rate(a)))
)
squared_spin = Definition("3.58", square("W", "W", "", FREQUENCY * FREQUENCY), Omega**2, kernel=Kernel(of=(omega,)))

KERNELS = {
    name: value
    for name, value in list(globals().items())
    if isinstance(value, Claim | Definition) and value.kernel is not None
}

# Column k of the matrix 4 q_k [q; q_0] of a rotation: whichever is longest is far from zero.
_units = (column(1, 0, 0), column(0, 1, 0), column(0, 0, 1))


def _of_rotation(k):
    if k == 3:
        return 2 * vect(Q), 1 + tr(Q)
    entry = [[i.T @ Q @ j for j in _units] for i in _units]
    vector_part = [1 + 2 * entry[k][k] - tr(Q) if i == k else entry[i][k] + entry[k][i] for i in range(3)]
    return column(*vector_part), 2 * dot(_units[k], vect(Q))


def _branch(k):
    along, beside = _of_rotation(k)
    length = norm(column(along, beside))
    values = ((e, along / norm(along)), (cos(phi / 2), beside / length), (sin(phi / 2), norm(along) / length))
    return Branch(f"q_{k} is not zero", where=length, values=values)


natural_invariants = Inverse(
    "3.75",
    of=rotation_from_axis_angle,
    branches=tuple(map(_branch, (3, 0, 1, 2))),
    gives=(e, phi),
    assuming=(rotation(Q),),
    kernel=Kernel(of=(Q,)),
)


class Book:
    """The statements above, what they ask for and what is made of them."""

    statements = KERNELS
    natural_invariants = natural_invariants

    def __init__(self):
        self.judge = Session()
        self._made = {}

    def request(self, name):
        statement = KERNELS[name]
        asked = replace(statement.kernel, name=name)
        return requested(statement, self.judge.decide, asked)

    def program(self, name):
        if name not in self._made:
            self._made[name] = program_of(self.request(name))
        return self._made[name]


def pytest_generate_tests(metafunc):
    if "name" in metafunc.fixturenames:
        metafunc.parametrize("name", KERNELS)


@pytest.fixture(scope="session")
def book():
    return Book()
