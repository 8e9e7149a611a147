"""Every symbol once: name, letter, meaning and dimension, before any equation uses it.

Conventions: a rotation Q is active and multiplies columns from the left; a twist has the angular velocity on top, a
wrench the moment; angles are in radians; quantities are in SI units. In Python a trailing underscore stands for the
book's prime; a quantity whose letter is taken has a longer name.
"""

from chasles.vocabulary import (
    CPM,
    FORCE,
    FREQUENCY,
    LENGTH,
    MASS,
    MOMENT,
    TIME,
    VELOCITY,
    Family,
    Identity,
    Index,
    Integral,
    Node,
    Zero,
    abbreviation,
    array,
    column,
    cross,
    integral,
    inverse,
    matrix,
    number,
    scalar,
    square,
    uniform,
    vector,
)

one = Identity(3)
O = Zero(3, 3)
O_43 = Zero(4, 3, r"\mathbf{O}_{43}")
O_34 = Zero(3, 4, r"\mathbf{O}_{34}")
unit_columns = (column(1, 0, 0), column(0, 1, 0), column(0, 0, 1))
zero = Zero(3, 1, r"\mathbf{0}")

# Rotation
e = vector("e", "e", "unit vector along the axis of rotation, or along a line")
phi = scalar("phi", r"\phi", "angle of rotation")
Q = square("Q", "Q", "rotation")
E = abbreviation("E", "E", CPM(e), "cross-product matrix of e")
v_any = vector("v", "v", "any vector")
V_any = square("V", "V", "cross-product matrix of a vector")

# Points and displacements
a = vector("a", "a", "position of the landmark point A", LENGTH)
a_ = vector("a'", "a'", "position of A after the displacement", LENGTH)
p = vector("p", "p", "position of any point P", LENGTH)
p_ = vector("p'", "p'", "position of P after the displacement", LENGTH)
b = vector("b", "b", "position of point B", LENGTH)
d_A = vector("d_A", "d_A", "displacement of A", LENGTH)
d_P = vector("d_P", "d_P", "displacement of P", LENGTH)
d_PA = vector("d_P/A", "d_{P/A}", "displacement of P relative to A", LENGTH)
d_par = vector("d_par", r"d_{\parallel}", "component of the displacement along the axis", LENGTH)
d_perp = vector("d_perp", r"d_{\perp}", "component of the displacement normal to the axis", LENGTH)
d0 = scalar("d0", "d_0", "component along e that all displacements share", LENGTH)
d_0 = vector("d_0", "d_0", "displacement of the points of the screw axis", LENGTH)

# The screw of a motion
pitch = scalar("p", "p", "pitch, in metres per radian", LENGTH)
pitch_per_turn = scalar("p", "p", "pitch, in metres per turn", LENGTH)
p_0 = vector("p_0", "p_0", "position of the point of the screw axis nearest the origin", LENGTH)
lam = scalar("lambda", r"\lambda", "parameter along a line, in units of a segment of it")
arc = scalar("lambda", r"\lambda", "signed distance along a line", LENGTH)
arc_by_omega = scalar(
    "lambda", r"\lambda", "signed distance along an axis, per unit of angular velocity", LENGTH * TIME
)
alpha = scalar("alpha", r"\alpha", "coefficient of the identity")
beta = scalar("beta", r"\beta", "coefficient of e e^T")
A_screw = array("A", "A", "coefficients of the equations of p_0", column(Q - one, e.T))
b_screw = array("b", "b", "right side of the equations of p_0", column(p_0, Zero(1, 1)))

# Lines
p_1 = vector("p_1", "p_1", "position of point P_1", LENGTH)
p_2 = vector("p_2", "p_2", "position of point P_2", LENGTH)
P_1 = abbreviation("P_1", "P_1", CPM(p_1), "cross-product matrix of p_1")
P_2 = abbreviation("P_2", "P_2", CPM(p_2), "cross-product matrix of p_2")
n = vector("n", "n", "moment of a line about the origin", LENGTH)
n_A = vector("n_A", "n_A", "moment of a line about A", LENGTH)
n_B = vector("n_B", "n_B", "moment of a line about B", LENGTH)
gamma = array("gamma", r"\boldsymbol{\gamma}_{\mathcal{L}}", "Pluecker coordinates", column(p_1, cross(p_1, p_1)))
kappa = array("kappa", r"\kappa", "Pluecker array: direction and moment", column(e, n))
kappa_A = array("kappa_A", r"\kappa_A", "Pluecker array with the moment about A", column(e, n))
kappa_B = array("kappa_B", r"\kappa_B", "Pluecker array with the moment about B", column(e, n))
A = abbreviation("A", "A", CPM(a), "cross-product matrix of a")
B = abbreviation("B", "B", CPM(b), "cross-product matrix of b")
P = abbreviation("P", "P", CPM(p), "cross-product matrix of p")
U = array("U", "U", "transfer of Pluecker coordinates, or of twists, to another point", matrix((one, O), (A, one)))
f = vector("f", "f", "unit moment of a line at infinity")
kappa_inf = array("kappa_inf", r"\kappa_\infty", "Pluecker array of a line at infinity", column(zero, f))

# Pose
q = vector("q", "q", "vector part of four invariants of the rotation")
q_0 = scalar("q_0", "q_0", "scalar part of four invariants of the rotation")
s = array("s", "s", "pose array", column(q, q_0, d_A))
i, j = Index("i"), Index("j")
AP_1 = vector("AP_1", r"\overrightarrow{AP_1}", "vector from A to P_1, in units of its own length")
AP_2 = vector("AP_2", r"\overrightarrow{AP_2}", "vector from A to P_2, in units of its own length")
AP_3 = vector("AP_3", r"\overrightarrow{AP_3}", "vector from A to P_3, in units of its own length")
e_1, e_2, e_3 = (vector(f"e_{k}", f"e_{k}", f"vector {k} of the triad") for k in (1, 2, 3))
e_1_, e_2_, e_3_ = (vector(f"e_{k}'", f"e'_{k}", f"vector {k} of the displaced triad") for k in (1, 2, 3))
e_of = Family(r"\mathbf{e}", (e_1, e_2, e_3))
e_of_ = Family(r"\mathbf{e}'", (e_1_, e_2_, e_3_))
triad = square("triad", r"[\mathbf{e}_1\,\mathbf{e}_2\,\mathbf{e}_3]", "the triad as columns")
triad_ = square("triad'", r"[\mathbf{e}'_1\,\mathbf{e}'_2\,\mathbf{e}'_3]", "the displaced triad as columns")
Q_in_axes = square("[Q]", r"[\mathbf{Q}]", "components of the rotation in the axes of the triad")

# Motion
p_ref = vector("p_0", r"\mathbf{p}_0", "position of P in the reference configuration", LENGTH, constant=True)
a_ref = vector("a_0", r"\mathbf{a}_0", "position of A in the reference configuration", LENGTH, constant=True)
Omega = square("Omega", r"\Omega", "angular-velocity matrix", FREQUENCY)
omega = vector("omega", r"\omega", "angular velocity", FREQUENCY)

# The instant screw
v_0 = vector("v_0", "v_0", "velocity of the points of the instant screw axis", VELOCITY)
v0 = scalar("v0", "v_0", "signed magnitude of that velocity", VELOCITY)
pitch_ = scalar("p'", "p'", "pitch of the instant screw, in metres per radian", LENGTH)
pitch_per_turn_ = scalar("p'", "p'", "pitch of the instant screw, in metres per turn", LENGTH)
e_ = vector("e'", "e'", "unit vector along the instant screw axis")
n_ = vector("n'", "n'", "moment of the instant screw axis about the origin", LENGTH)
axis_ = array("p_L'", r"\mathbf{p}_{\mathcal{L}'}", "Pluecker array of the instant screw axis", column(e_, n_))
adot_par = vector("a_dot_par", r"\dot{\mathbf{a}}_{\parallel}", "component of the velocity of A along omega", VELOCITY)
adot_perp = vector("a_dot_perp", r"\dot{\mathbf{a}}_{\perp}", "component of that velocity normal to omega", VELOCITY)
pdot_par = vector("p_dot_par", r"\dot{\mathbf{p}}_{\parallel}", "component of the velocity of P along omega", VELOCITY)
pdot_perp = vector("p_dot_perp", r"\dot{\mathbf{p}}_{\perp}", "component of that velocity normal to omega", VELOCITY)
r = vector("r", "r", "position of one point of the instant screw axis", LENGTH)
p_0_ = vector("p_0'", r"\mathbf{p}'_0", "position of the point of the instant screw axis nearest the origin", LENGTH)
A_isa = array("A", "A", "coefficients of the equations of p_0'", column(CPM(omega), omega.T))
b_isa = array("b", "b", "right side of the equations of p_0'", column(CPM(omega) @ a, Zero(1, 1)))

# Twists
v = vector("v", "v", "velocity of a landmark point", VELOCITY)
v_A = vector("v_A", "v_A", "velocity of A", VELOCITY)
v_P = vector("v_P", "v_P", "velocity of P", VELOCITY)
screw = array("s", "s", "screw: direction, and moment with the pitch", column(e, n))
screw_inf = array("s_inf", r"\mathbf{s}_\infty", "screw of infinite pitch", column(zero, e))
t = array("t", "t", "twist: angular velocity, velocity of a landmark point", column(omega, v))
t_A = array("t_A", "t_A", "twist at A", column(omega, v_A))
t_P = array("t_P", "t_P", "twist at P", column(omega, v_P))
nu = array("nu", r"\nu", "natural invariants of the rotation", column(e, phi))
lambda_ = array("lambda", r"\lambda", "linear invariants of the rotation", column(e, phi))
eta = array("eta", r"\eta", "Euler-Rodrigues parameters of the rotation", column(e, phi))
N = array("N", "N", "natural invariants' rates from the angular velocity", uniform((4, 3)))
L = array("L", "L", "linear invariants' rates from the angular velocity", uniform((4, 3)))
H = array("H", "H", "Euler-Rodrigues parameters' rates from the angular velocity", uniform((4, 3)))
N_tilde = array("N~", r"\tilde{\mathbf{N}}", "angular velocity from the natural invariants' rates", uniform((3, 4)))
L_tilde = array("L~", r"\tilde{\mathbf{L}}", "angular velocity from the linear invariants' rates", uniform((3, 4)))
H_tilde = array(
    "H~", r"\tilde{\mathbf{H}}", "angular velocity from the Euler-Rodrigues parameters' rates", uniform((3, 4))
)
F = array("F", "F", "N, L or H", uniform((4, 3)))
F_tilde = array("F~", r"\tilde{\mathbf{F}}", "the left inverse of N, L or H", uniform((3, 4)))
T = array("T", "T", "rate of the pose from the twist", matrix((F, O_43), (O, one)))
S = array("S", "S", "twist from the rate of the pose", matrix((F_tilde, O), (O_34, one)))

# Accelerations
W_acc = square("W", "W", "angular-acceleration matrix", FREQUENCY * FREQUENCY)
u = vector("u", "u", "linear invariants: the vector")
u_0 = scalar("u_0", "u_0", "linear invariants: the scalar")
r_er = vector("r", "r", "Euler-Rodrigues parameters: the vector")
r_0 = scalar("r_0", "r_0", "Euler-Rodrigues parameters: the scalar")
R_er = abbreviation("R", "R", CPM(r_er), "cross-product matrix of r")
U_lin = abbreviation("U", "U", CPM(u), "cross-product matrix of u")
N_upper = square("N_u", r"\mathbf{N}_u", "the upper block of N")
B_N = square("B", "B", "the upper block of the rate of N, times 4 (1 - cos(phi))", FREQUENCY)
V_lin = square("V", "V", "the left block of the rate of L~, times D", FREQUENCY)
D = scalar("D", "D", "one plus the scalar linear invariant")
theta = scalar("theta", r"\theta", "an angle that the text does not introduce")

# Moving frames
o = vector("o", "o", "position of the origin of the moving frame", LENGTH)
rho_F = vector("rho_F", r"\rho", "position of P from the origin of the moving frame, in the fixed frame", LENGTH)
rho_M = vector("rho", r"\rho", "position of P in the moving frame", LENGTH)

# Statics
force = vector("f", "f", "resultant force", FORCE)
moment = vector("n", "n", "resultant moment about the point at which the force acts", MOMENT)
moment_A = vector("n_A", "n_A", "resultant moment about A", MOMENT)
moment_P = vector("n_P", "n_P", "resultant moment about P", MOMENT)
n_0 = vector("n_0", "n_0", "resultant moment of least magnitude", MOMENT)
n0 = scalar("n0", "n_0", "signed magnitude of that moment", MOMENT)
pitch__ = scalar("p''", "p''", "pitch of the wrench, in metres per radian", LENGTH)
pitch_per_turn__ = scalar("p''", "p''", "pitch of the wrench, in metres per turn", LENGTH)
e__ = vector("e''", "e''", "unit vector along the axis of the wrench")
n__ = vector("n''", "n''", "moment of the axis of the wrench about the origin", LENGTH)
axis__ = array("p_L''", r"\mathbf{p}_{\mathcal{L}''}", "Pluecker array of the axis of the wrench", column(e__, n__))
p_0__ = vector("p_0''", "p_0''", "position of the point of the axis of the wrench nearest the origin", LENGTH)
arc_by_force = scalar("lambda", r"\lambda", "signed distance along an axis, per unit of force", LENGTH / FORCE)
Gamma = array("Gamma", r"\Gamma", "exchanges the halves of a six-dimensional array", matrix((O, one), (one, O)))
amplitude = scalar("A", "A", "amplitude of a screw", FORCE)
amplitude_of_wrench = scalar("W", "W", "amplitude of a wrench", FORCE)
amplitude_of_twist = scalar("T", "T", "amplitude of a twist", FREQUENCY)
w = array("w", "w", "wrench: moment, force", column(moment, force))
w_A = array("w_A", "w_A", "wrench at A", column(moment, force))
w_P = array("w_P", "w_P", "wrench at P", column(moment, force))
power_ = scalar("Pi", r"\Pi", "power developed by a wrench on a moving body", MOMENT / TIME)
s_w = array("s_w", "s_w", "screw of a wrench", column(e, n))
s_t = array("s_t", "s_t", "screw of a twist", column(e, n))
V = array("V", "V", "transfer of wrenches to another point", matrix((one, A - P), (O, one)))
O_in_V = Zero(3, 3, r"\mathbf{0}")
one_6 = Identity(6, r"\mathbf{1}_{6 \times 6}")

# Mass
half = number(1) / 2
m = scalar("m", "m", "mass", MASS, constant=True)
rho = scalar("rho", r"\rho", "mass density", MASS / LENGTH**3, constant=True)
q_O = vector("q_O", "q_O", "mass first moment with respect to the origin", MASS * LENGTH)
c = vector("c", "c", "position of the center of mass", LENGTH)
r_C = vector("r", "r", "position of P from the center of mass", LENGTH)
r_1 = vector("r_1", "r_1", "position of one element of the body from the center of mass", LENGTH)
r_2 = vector("r_2", "r_2", "position of another element of the body from the center of mass", LENGTH)
normal = vector("n", "n", "normal to the plane of the center of mass and two elements", LENGTH**2)
R_C = abbreviation("R", "R", CPM(r_C), "cross-product matrix of r")
C = abbreviation("C", "C", CPM(c), "cross-product matrix of c")
arc_of_element = scalar("lambda", r"\lambda", "signed distance of an element of a rod from the center of mass", LENGTH)
x_any = vector("x", "x", "any vector")
energy = scalar("T", "T", "kinetic energy", MOMENT)
I_C = square("I_C", "I_C", "moment of inertia at the center of mass", MASS * LENGTH**2)
I_A = square("I_A", "I_A", "moment of inertia with respect to A", MASS * LENGTH**2)


def over_body(of: Node) -> Integral:
    """The integral over the body; density and position differ from element to element."""
    return integral(of, rho, p, r_C, arc_of_element)


# Dynamics
zero_6 = Zero(6, 1, r"\mathbf{0}")
c_ref = vector("c_0", r"\mathbf{c}_0", "reference position of the center of mass", LENGTH, constant=True)
moment_C = vector("n_C", "n_C", "resultant moment about the center of mass", MOMENT)
momentum = vector("m", "m", "momentum", MASS * VELOCITY)
h_C = vector("h_C", "h_C", "angular momentum with respect to the center of mass", MOMENT * TIME)
M = array("M", "M", "inertia dyad", matrix((I_C, O), (O, m * one)))
M_C = array("M_C", "M_C", "inertia dyad at the center of mass", matrix((I_C, O), (O, m * one)))
M_A = array("M_A", "M_A", "inertia dyad at A", matrix((I_C, m * C), (m * C, m * one)))
M_inv = array("M_inv", r"\mathbf{M}^{-1}", "inverse of the inertia dyad", inverse(M))
P_dyad = array("P", "P", "what Steiner's theorem in dyad form asks for", column(a, e) @ column(e, e).T)
W_dyad = array("W", "W", "angular-velocity dyad", matrix((Omega, O), (O, O)))
mu = array("mu", r"\mu", "momentum screw about the center of mass", column(h_C, momentum))
