"""Every symbol once: name, letter, meaning and dimension, before any equation uses it.

Conventions: rotations are active and multiply columns from the left; quaternions follow Hamilton, with the scalar last;
a twist has the angular velocity on top, a wrench the moment; angles are in radians; quantities are in SI units.
"""

from chasles.vocabulary import (
    CPM,
    FORCE,
    FREQUENCY,
    LENGTH,
    MOMENT,
    VELOCITY,
    Identity,
    Node,
    Zero,
    abbreviation,
    array,
    column,
    cos,
    matrix,
    norm,
    scalar,
    sin,
    square,
    uniform,
    vector,
)
from chasles.vocabulary.motions import homogeneous
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

# Euler angles
alpha = scalar("alpha", r"\alpha", "yaw: angle of the turn about z")
beta = scalar("beta", r"\beta", "pitch: angle of the turn about y")
gamma = scalar("gamma", r"\gamma", "roll: angle of the turn about x")
theta = scalar("theta", r"\theta", "nutation: angle of the turn about x, between two turns about z")
psi = scalar("psi", r"\psi", "precession: angle of the first turn about z")
chi = scalar("chi", r"\chi", "spin: angle of the last turn about z")
angle_rates = vector("angle_rates", r"\dot{\boldsymbol{\alpha}}", "rates of yaw, pitch and roll", FREQUENCY)
W = square("W", "W", "angular velocity in the fixed frame from the rates of yaw, pitch and roll")
W_body = square("W_B", r"\mathbf{W}_{\mathcal{B}}", "angular velocity in the body frame from those rates")

# Motions
x = vector("x", "x", "position of a point", LENGTH)
c = vector("c", "c", "position of a point on an axis", LENGTH)
d = scalar("d", "d", "advance along an axis", LENGTH)
d_1 = scalar("d_1", "d_1", "advance of the first of two screws about one axis", LENGTH)
d_2 = scalar("d_2", "d_2", "advance of the second of two screws about one axis", LENGTH)
p_T = vector("p_T", "p", "position of the origin of the moving frame", LENGTH)
p_S = vector("p_S", "s", "position of the origin of another moving frame", LENGTH)
T = array("T", "T", "motion", matrix((Q, p_T), (Zero(1, 3), 1)))
S = array("S", "S", "another motion", matrix((R, p_S), (Zero(1, 3), 1)))
H = array("H", "H", "the first of two screws about one axis", matrix((Q, p_T), (Zero(1, 3), 1)))
K = array("K", "K", "the second of two screws about one axis", matrix((Q, p_T), (Zero(1, 3), 1)))
A_DH = array("A", "A", "from a link to the one before it", matrix((Q, p_T), (Zero(1, 3), 1)))
x_1 = vector("x_1", "x_1", "position of a point in the moving frame", LENGTH)
x_rest = vector("x_1", "x_1", "position of a point in the moving frame, in which it stays", LENGTH, constant=True)
link = scalar("a", "a", "length of a link", LENGTH, constant=True)
offset = scalar("b", "b", "offset of a joint", LENGTH, constant=True)
twist_of_link = scalar("alpha", r"\alpha", "twist of a link: angle between the axes of its joints", constant=True)
zero_row = Zero(1, 3, r"\mathbf{0}^T")

# Twists and wrenches
velocity = vector("v", "v", "velocity of the point at the origin", VELOCITY)
omega_u = vector("omega_u", r"\omega_u", "angular velocity of another twist", FREQUENCY)
velocity_u = vector("v_u", "v_u", "velocity of the other twist", VELOCITY)
moment = vector("n", "n", "moment about the origin", MOMENT)
force = vector("f", "f", "force", FORCE)
t_a = array("t", "t", "twist: angular velocity, velocity of the point at the origin", column(omega, velocity))
t_b = array("u", "u", "another twist", column(omega, velocity))
t_c = array("s", "s", "a third twist", column(omega, velocity))
t_space = array("t_S", r"\mathbf{t}_{\mathcal{S}}", "twist of the body in the fixed frame", column(omega, velocity))
t_body = array("t_B", r"\mathbf{t}_{\mathcal{B}}", "twist of the body in its own frame", column(omega, velocity))
w_a = array("w", "w", "wrench: moment about the origin, force", column(moment, force))
zero_block = Zero(3, 3)
zero_6 = Zero(6, 1, r"\mathbf{0}")
one_6 = Identity(6)

# The exponential of a twist
rho = vector("rho", r"\rho", "translation of an exponential, before the Jacobian", LENGTH)

# Arms
theta_1, theta_2, theta_3, theta_4 = (scalar(f"theta_{k}", rf"\theta_{k}", f"angle of joint {k}") for k in range(1, 5))
a_1, a_2, a_3 = (scalar(f"a_{k}", f"a_{k}", f"length of link {k}", LENGTH, constant=True) for k in range(1, 4))
h_1 = scalar("h", "h", "height of the shoulder", LENGTH, constant=True)
b_3 = scalar("b_3", "b_3", "stroke of the sliding joint", LENGTH)
e_1, e_2, e_3 = (vector(f"e_{k}", f"e_{k}", f"unit vector along the axis of joint {k}") for k in range(1, 4))
r_1, r_2, r_3 = (
    vector(f"r_{k}", f"r_{k}", f"from the axis of joint {k} to the end of the arm", LENGTH) for k in range(1, 4)
)
f_x = scalar("f_x", "f_x", "component x of a force at the end of the arm", FORCE)
f_y = scalar("f_y", "f_y", "component y of that force", FORCE)
p_2R = array("p_2", "p", "end of the planar arm with two joints", uniform((2, 1), LENGTH))
J_2R = array("J_2", "J", "Jacobian of the planar arm with two joints", uniform((2, 2), LENGTH))
p_3R = array("p_3", "p", "end of the planar arm with three joints, and its direction", column(a_1, a_1, 1))
p_RRR = vector("p", "p", "end of the arm with waist, shoulder and elbow", LENGTH)
J_RRR = square("J", "J", "Jacobian of the arm with waist, shoulder and elbow", LENGTH)


def along(of: Node) -> Node:
    """The translation by a vector."""
    return homogeneous(one, of)


def turned(by: Node) -> Node:
    """The motion that is a rotation about the origin."""
    return homogeneous(by, zero)


def about_x(angle: Node) -> Node:
    """The turn about the axis x."""
    return matrix((1, 0, 0), (0, cos(angle), -sin(angle)), (0, sin(angle), cos(angle)))


def about_y(angle: Node) -> Node:
    """The turn about the axis y."""
    return matrix((cos(angle), 0, sin(angle)), (0, 1, 0), (-sin(angle), 0, cos(angle)))


def about_z(angle: Node) -> Node:
    """The turn about the axis z."""
    return matrix((cos(angle), -sin(angle), 0), (sin(angle), cos(angle), 0), (0, 0, 1))


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
