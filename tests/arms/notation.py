"""Every symbol once; matrices are given by their entries."""

from chasles.vocabulary import (
    LENGTH,
    Identity,
    Symbol,
    array,
    cos,
    scalar,
    sin,
    square,
    uniform,
    vector,
)

phi, theta, psi = (scalar(name, rf"\{name}", "an angle about a coordinate axis") for name in ("phi", "theta", "psi"))
alpha, beta = (scalar(name, rf"\{name}", "an angle") for name in ("alpha", "beta"))
q1, q2, q3 = (scalar(f"q{k}", f"q_{k}", "the angle of a joint") for k in (1, 2, 3))
l1, l2, l3, a, d = (
    scalar(name, letter, "a length of a link", LENGTH, constant=True)
    for name, letter in (("l1", "l_1"), ("l2", "l_2"), ("l3", "l_3"), ("a", "a"), ("d", "d"))
)
r, z = (scalar(name, name, "a sliding joint", LENGTH) for name in "rz")
n1, n2, n3 = (scalar(f"n{k}", f"n_{k}", "a component of the axis", constant=True) for k in (1, 2, 3))
e0, e1, e2, e3 = (scalar(f"e{k}", f"e_{k}", "a part of a quaternion") for k in range(4))
f0, f1, f2, f3 = (scalar(f"f{k}", f"f_{k}", "a part of a second quaternion") for k in range(4))
X, Y, Z = (square(name, name, "a turn about a coordinate axis") for name in "XYZ")
R = square("R", "R", "a rotation")
V = square("V", "V", "a rotation by Euler angles")
one, one4 = Identity(3), Identity(4)
n = vector("n", "n", "the axis", constant=True)
v = vector("v", "v", "a vector")
w = vector("w", "w", "an angular velocity")


def _four(name: str, letter: str, meaning: str) -> Symbol:
    return array(name, letter, meaning, uniform((4, 4)))


A, B, C, D = (_four(name, name, "a frame's step") for name in "ABCD")
L, M = (_four(name, name, "a matrix of a quaternion") for name in "LM")
e, f = (array(name, name, "a quaternion", uniform((4, 1))) for name in "ef")
p, s, b = (
    array(name, name, "a point of the arm", uniform(shape, LENGTH))
    for name, shape in (("p", (2, 1)), ("s", (3, 1)), ("b", (2, 1)))
)

cf, sf, ct, st, cp, sp = cos(phi), sin(phi), cos(theta), sin(theta), cos(psi), sin(psi)
