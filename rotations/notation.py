"""Every symbol once: name, letter, meaning and dimension, before any equation uses it.

Conventions: rotations are active and multiply columns from the left; quaternions follow Hamilton, with the scalar last;
a twist has the angular velocity on top, a wrench the moment; angles are in radians; quantities are in SI units.
"""

from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Identity,
    Node,
    Zero,
    abbreviation,
    array,
    column,
    norm,
    scalar,
    square,
    uniform,
    vector,
)
from chasles.vocabulary.quaternions import (
    product_from_left,
    product_from_right,
    quaternion_conjugate,
    quaternion_product,
    rotation_of_quaternion,
)

one = Identity(3)
zero = Zero(3, 1, r"\mathbf{0}")
x_axis, y_axis, z_axis = column(1, 0, 0), column(0, 1, 0), column(0, 0, 1)

# Rotations
e = vector("e", "e", "unit vector along the axis of rotation")
phi = scalar("phi", r"\phi", "angle of rotation")
phi_1 = scalar("phi_1", r"\phi_1", "angle of the first of two rotations about one axis")
phi_2 = scalar("phi_2", r"\phi_2", "angle of the second of two rotations about one axis")
Q = square("Q", "Q", "rotation")
Q_1 = square("Q_1", "Q_1", "the first of two rotations about one axis")
Q_2 = square("Q_2", "Q_2", "the second of two rotations about one axis")
R = square("R", "R", "another rotation")
E = abbreviation("E", "E", CPM(e), "cross-product matrix of e")
a = vector("a", "a", "any vector")
b = vector("b", "b", "any other vector")
A = square("A", "A", "any matrix")
omega = vector("omega", r"\omega", "angular velocity, in the fixed frame", FREQUENCY)
omega_body = vector("omega_B", r"\boldsymbol{\omega}_{\mathcal{B}}", "angular velocity, in the body frame", FREQUENCY)

# Quaternions
r = vector("r", "r", "vector of the Euler-Rodrigues parameters")
r_0 = scalar("r_0", "r_0", "scalar of the Euler-Rodrigues parameters")
p = array("p", "p", "quaternion", uniform((4, 1)))
q = array("q", "q", "another quaternion", uniform((4, 1)))
h = array("h", "h", "a third quaternion", uniform((4, 1)))
n = array("n", "n", "direction on the unit sphere of quaternions", uniform((4, 1)))
s = scalar("s", "s", "scalar of a quaternion")
t = scalar("t", "t", "scalar of another quaternion")
one_4 = Identity(4)
neutral = column(zero, 1)


# Rotation vectors
v = vector("v", "v", "rotation vector: the angle along the axis")
v_length = norm(v)
J = square("J", "J", "left Jacobian of rotations")
e_fixed = vector("e", "e", "unit vector along an axis that stays", constant=True)

# Rodrigues parameters
g = vector("g", "g", "Rodrigues parameters: the tangent of half the angle along the axis")
g_1 = vector("g_1", "g_1", "Rodrigues parameters of a first rotation")
g_2 = vector("g_2", "g_2", "Rodrigues parameters of a second rotation")
g_3 = vector("g_3", "g_3", "Rodrigues parameters of the first rotation and then the second")
m = vector("m", "m", "modified Rodrigues parameters: the tangent of a quarter of the angle along the axis")
m_2 = vector("m'", "m'", "the other modified Rodrigues parameters of the same rotation")


def times(left: Node, right: Node) -> Node:
    """Hamilton's product of two quaternions."""
    return quaternion_product(left, right, scalar_last=True)


def conjugate(of: Node) -> Node:
    """The quaternion with the opposite vector."""
    return quaternion_conjugate(of, scalar_last=True)


def from_left(of: Node) -> Node:
    """The matrix by which a quaternion multiplies others from the left."""
    return product_from_left(of, scalar_last=True)


def from_right(of: Node) -> Node:
    """The matrix by which a quaternion multiplies others from the right."""
    return product_from_right(of, scalar_last=True)


def rotation_by(of: Node) -> Node:
    """The rotation by a unit quaternion."""
    return rotation_of_quaternion(of, scalar_last=True)
