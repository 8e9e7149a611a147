"""Models of mechanics, robotics and vision as SymPy expressions in plain symbols; entries of arrays go in.

Written from the textbooks' and makers' figures, or taken from SymPy as its own functions and tests build them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from importlib import import_module
from typing import Any
from unittest.mock import patch

import sympy as sp
from sympy.core.function import AppliedUndef
from sympy.physics.mechanics import KanesMethod
from sympy.physics.mechanics.models import multi_mass_spring_damper, n_link_pendulum_on_cart

__all__ = ["METHODS", "MODELS", "Model", "chain_in_the_plane", "of_method"]


@dataclass(frozen=True)
class Model:
    """Expressions in the symbols of the inputs, each input an array of symbols."""

    name: str
    says: str
    inputs: Mapping[str, Sequence[sp.Symbol]]
    entries: tuple[sp.Expr, ...]


def model(name: str, says: str, inputs: Mapping[str, Iterable[Any]], *results: Any) -> Model:
    """The model of results that are scalars or matrices; zeros of structure are left out."""
    flat = [entry for result in results for entry in (sp.Matrix([result]) if not hasattr(result, "shape") else result)]
    given = {key: tuple(values) for key, values in inputs.items() if tuple(values)}
    return Model(name, says, given, tuple(sp.sympify(entry) for entry in flat if entry != 0))


def symbols(name: str, many: int) -> tuple[sp.Symbol, ...]:
    """Real symbols of one letter."""
    return tuple(sp.symbols(f"{name}:{many}", real=True))


def of_method(name: str, says: str, method: Any, whole: bool = False) -> Model:
    """Mass matrix and forcing of a method of SymPy, in plain symbols, without the zeros unless they are to be whole."""
    known = method.kindiffdict() if isinstance(method, KanesMethod) else {}
    results = [matrix.xreplace(known) for matrix in (method.mass_matrix, method.forcing)]
    fixed = sorted(
        {each for matrix in results for each in matrix.free_symbols if str(each) != "t"},
        key=str,
    )
    moving = {each for matrix in results for entry in matrix for each in entry.atoms(AppliedUndef)}
    moving -= {*method.q, *method.u}
    groups = {"q": [*method.q], "u": [*method.u], "F": sorted(moving, key=str), "p": fixed}
    table = {each: sp.Symbol(f"{key}{i}", real=True) for key, group in groups.items() for i, each in enumerate(group)}
    plain = [matrix.xreplace(table) for matrix in results]
    given = {key: tuple(table[each] for each in group) for key, group in groups.items() if group}
    if whole:
        return Model(name, says, given, tuple(entry for matrix in plain for entry in matrix))
    return model(name, says, given, *plain)


def cart_pendulum(links: int) -> Model:
    """SymPy's pendulum of so many links on a cart."""
    method = n_link_pendulum_on_cart(links, cart_force=True, joint_torques=True)
    return of_method(f"cart pendulum {links}", "mass matrix and forcing", method)


def cart_pendulum_jacobian() -> Model:
    """The rates of a cart with a pole, linearised."""
    (x, v, a, w), (F, M, m, l, g) = symbols("s", 4), symbols("p", 5)
    below = M + m * sp.sin(a) ** 2
    force = F + m * sp.sin(a) * (l * w**2 - g * sp.cos(a))
    turning = -F * sp.cos(a) - m * l * w**2 * sp.sin(a) * sp.cos(a) + (M + m) * g * sp.sin(a)
    rates = sp.Matrix([v, force / below, w, turning / (l * below)])
    return model(
        "cart pole Jacobian",
        "state rates and their derivatives",
        {"s": (x, v, a, w), "p": (F, M, m, l, g)},
        rates,
        rates.jacobian([x, v, a, w, F]),
    )


def springs(many: int) -> Model:
    """SymPy's chain of springs and dampers between masses."""
    return of_method("springs 10", "mass matrix and forcing", multi_mass_spring_damper(many, True, True))


def chain_in_the_plane(many: int) -> Model:
    """Forces on masses in a row, each held by two springs with a length at rest."""
    place, speed, fixed = symbols("x", 2 * many), symbols("v", 2 * many), symbols("p", 3)
    stiffness, damping, rest = fixed
    forces = [sp.Integer(0)] * (2 * many)
    for i in range(many):
        at, before = place[2 * i : 2 * i + 2], place[2 * i - 2 : 2 * i] if i else (0, 0)
        away = [one - other for one, other in zip(at, before, strict=True)]
        length = sp.sqrt(away[0] ** 2 + away[1] ** 2)
        for k in range(2):
            pull = stiffness * (1 - rest / length) * away[k]
            forces[2 * i + k] += -pull - damping * speed[2 * i + k]
            if i:
                forces[2 * i - 2 + k] += pull
    return model(f"chain {many}", "forces of springs", {"x": place, "v": speed, "p": fixed}, sp.Matrix(forces))


def two_links() -> Model:
    """The planar arm of two links (Spong, Hutchinson and Vidyasagar, section 7.4): accelerations for torques."""
    (q, p), (u, v), (t1, t2) = symbols("q", 2), symbols("u", 2), symbols("T", 2)
    l1, c1, c2, m1, m2, I1, I2, g = fixed = symbols("p", 8)
    h = m2 * l1 * c2
    a = m1 * c1**2 + m2 * (l1**2 + c2**2) + 2 * h * sp.cos(p) + I1 + I2
    b, d = m2 * c2**2 + h * sp.cos(p) + I2, m2 * c2**2 + I2
    falling = m2 * c2 * g * sp.cos(q + p)
    f1 = t1 + h * sp.sin(p) * (2 * u * v + v**2) - (m1 * c1 + m2 * l1) * g * sp.cos(q) - falling
    f2 = t2 - h * sp.sin(p) * u**2 - falling
    below = a * d - b**2
    inputs = {"q": (q, p), "u": (u, v), "T": (t1, t2), "p": fixed}
    return model("2R arm", "accelerations", inputs, (d * f1 - b * f2) / below, (a * f2 - b * f1) / below)


def three_links() -> Model:
    """The planar arm of three rods, Lagrange's equations solved by Cramer's rule."""
    q, u, torques, fixed = symbols("q", 3), symbols("u", 3), symbols("T", 3), symbols("p", 7)
    lengths, masses, g = fixed[:3], fixed[3:6], fixed[6]
    angles = [sum(q[: i + 1]) for i in range(3)]
    energy = potential = sp.Integer(0)
    corner = sp.zeros(2, 1)
    for i, angle in enumerate(angles):
        along = lengths[i] * sp.Matrix([sp.cos(angle), sp.sin(angle)])
        centre = corner + along / 2
        speed = centre.jacobian(q) * sp.Matrix(u)
        turning = sum(u[: i + 1])
        energy += masses[i] * speed.dot(speed) / 2 + masses[i] * lengths[i] ** 2 / 24 * turning**2
        potential += masses[i] * g * centre[1]
        corner += along
    momentum = sp.Matrix([energy]).jacobian(u).T
    mass = momentum.jacobian(u)
    force = sp.Matrix(torques) + sp.Matrix([energy - potential]).jacobian(q).T - momentum.jacobian(q) * sp.Matrix(u)
    below = mass.det(method="berkowitz")
    found = mass.adjugate(method="berkowitz") * force / below
    return model("3R arm", "accelerations", {"q": q, "u": u, "T": torques, "p": fixed}, found)


UR5 = (
    # a, d, alpha of Denavit and Hartenberg in quarters of a turn, mass, centre of mass in the link's frame
    ("0", "0.089159", 1, "3.7", "0 -0.02561 0.00193"),
    ("-0.425", "0", 0, "8.393", "0.2125 0 0.11336"),
    ("-0.39225", "0", 0, "2.275", "0.15 0 0.0265"),
    ("0", "0.10915", 1, "1.219", "0 -0.0018 0.01634"),
    ("0", "0.09465", -1, "1.219", "0 0.0018 0.01634"),
    ("0", "0.0823", 0, "0.1879", "0 0 -0.001159"),
)
"""As Universal Robots publishes them."""
RADIUS = sp.Rational(3, 50)
"""Of the cylinders that links are taken for, where only inertia is asked."""


def ur5_frames(q: Sequence[sp.Expr]) -> list[sp.Matrix]:
    """The frames of the links of a UR5 in its base."""
    found = [sp.eye(4)]
    for angle, (length, offset, turn, _, _) in zip(q, UR5, strict=True):
        a, d = sp.Rational(length), sp.Rational(offset)
        c, s = sp.cos(angle), sp.sin(angle)
        step = [[c, 0, turn * s, a * c], [s, 0, -turn * c, a * s], [0, turn, 0, d], [0, 0, 0, 1]]
        flat = [[c, -s, 0, a * c], [s, c, 0, a * s], [0, 0, 1, d], [0, 0, 0, 1]]
        found.append(found[-1] * sp.Matrix(step if turn else flat))
    return found


def jacobian(frames: Sequence[sp.Matrix], point: sp.Matrix, last: int) -> sp.Matrix:
    """The velocity of a point of a link, and the link's rotation, by the joints' rates."""
    columns = []
    for i in range(6):
        axis = frames[i][:3, 2]
        columns.append(axis.cross(point - frames[i][:3, 3]).col_join(axis) if i <= last else sp.zeros(6, 1))
    return sp.Matrix.hstack(*columns)


def ur5_kinematics() -> Model:
    """Where the flange is."""
    q = symbols("q", 6)
    return model("UR5 kinematics", "pose of the flange", {"q": q}, ur5_frames(q)[-1][:3, :])


def ur5_jacobian() -> Model:
    """How the flange moves."""
    q = symbols("q", 6)
    frames = ur5_frames(q)
    return model("UR5 Jacobian", "6 x 6", {"q": q}, jacobian(frames, frames[-1][:3, 3], 5))


def ur5_mass_matrix() -> Model:
    """The mass matrix by the Jacobians of the links' centres."""
    q = symbols("q", 6)
    frames = ur5_frames(q)
    mass = sp.zeros(6, 6)
    for i, (a, d, _, weight, centre) in enumerate(UR5):
        frame, m = frames[i + 1], sp.Rational(weight)
        point = frame[:3, :3] * sp.Matrix([sp.Rational(x) for x in centre.split()]) + frame[:3, 3]
        moving = jacobian(frames, point, i)
        across = m * (3 * RADIUS**2 + (sp.Rational(a) + sp.Rational(d)) ** 2) / 12
        inertia = frame[:3, :3] * sp.diag(across, across, m * RADIUS**2 / 2) * frame[:3, :3].T
        mass += m * moving[:3, :].T * moving[:3, :] + moving[3:, :].T * inertia * moving[3:, :]
    return model("UR5 mass matrix", "6 x 6", {"q": q}, mass)


def quadrotor() -> Model:
    """Rates of position, velocity, quaternion and turning rate for four rotors with drag."""
    p, v, h, w, n = symbols("r", 3), symbols("v", 3), symbols("h", 4), symbols("w", 3), symbols("n", 4)
    m, Ix, Iy, Iz, arm, lift, yaw, drag, g = fixed = symbols("p", 9)
    a, b, c, d = h
    turn = sp.Matrix(
        [
            [a * a + b * b - c * c - d * d, 2 * (b * c - a * d), 2 * (b * d + a * c)],
            [2 * (b * c + a * d), a * a - b * b + c * c - d * d, 2 * (c * d - a * b)],
            [2 * (b * d - a * c), 2 * (c * d + a * b), a * a - b * b - c * c + d * d],
        ]
    )
    thrust = [lift * each**2 for each in n]
    speed = sp.sqrt(sum(each**2 for each in v))
    falling = sp.Matrix([0, 0, -g])
    acceleration = turn * sp.Matrix([0, 0, sum(thrust)]) / m - drag * speed * sp.Matrix(v) / m + falling
    torque = sp.Matrix(
        [
            arm * (thrust[1] - thrust[3]),
            arm * (thrust[2] - thrust[0]),
            yaw * (n[0] ** 2 - n[1] ** 2 + n[2] ** 2 - n[3] ** 2),
        ]
    )
    spin = [Ix, Iy, Iz]
    momentum = sp.Matrix([spin[i] * w[i] for i in range(3)])
    turning = (torque - sp.Matrix(w).cross(momentum)).multiply_elementwise(sp.Matrix([1 / each for each in spin]))
    x, y, z = w
    quaternion = sp.Matrix(
        [-b * x - c * y - d * z, a * x + c * z - d * y, a * y - b * z + d * x, a * z + b * y - c * x]
    )
    inputs = {"r": p, "v": v, "h": h, "w": w, "n": n, "p": fixed}
    return model("quadrotor", "state rates", inputs, sp.Matrix(v), acceleration, quaternion / 2, turning)


def of_test(module: str, test: str) -> KanesMethod:
    """The method that a test of SymPy forms first; the test goes no further."""
    found: list[KanesMethod] = []
    forming = KanesMethod.kanes_equations

    def formed(self: KanesMethod, *arguments: Any, **named: Any) -> Any:
        forming(self, *arguments, **named)
        found.append(self)
        raise InterruptedError

    with patch.object(KanesMethod, "kanes_equations", formed), suppress(InterruptedError):
        getattr(import_module(f"sympy.physics.mechanics.tests.{module}"), test)()
    return found[0]


def whipple_bicycle() -> Model:
    """The bicycle of SymPy's test."""
    return of_method("Whipple bicycle", "mass matrix and forcing", of_test("test_kane3", "test_bicycle"))


def reprojection() -> Model:
    """The error of a point in a picture with radial distortion, and its derivatives, as in bundle adjustment."""
    camera, point, seen = symbols("c", 9), symbols("x", 3), symbols("z", 2)
    axis, at = sp.Matrix(camera[:3]), sp.Matrix(point)
    angle = sp.sqrt(axis.dot(axis))
    e = axis / angle
    turned = sp.cos(angle) * at + sp.sin(angle) * e.cross(at) + (1 - sp.cos(angle)) * e.dot(at) * e
    x, y, z = turned + sp.Matrix(camera[3:6])
    u, v = -x / z, -y / z
    square = u**2 + v**2
    scale = camera[6] * (1 + square * (camera[7] + square * camera[8]))
    error = sp.Matrix([scale * u - seen[0], scale * v - seen[1]])
    by = error.jacobian([*camera, *point])
    return model("reprojection", "error and Jacobian", {"c": camera, "x": point, "z": seen}, error, by)


def inertial_step() -> Model:
    """A step of preintegration of an inertial measurement unit: quaternion, velocity and place."""
    h, v, p, w, a, b = (symbols(*each) for each in zip("hvpwab", (4, 3, 3, 3, 3, 7), strict=True))
    bias, dt = b[:6], b[6]
    turning = (sp.Matrix(w) - sp.Matrix(bias[:3])) * dt
    angle = sp.sqrt(turning.dot(turning))
    s, c = sp.sin(angle / 2) / angle, sp.cos(angle / 2)
    x, y, z = s * turning
    q0, q1, q2, q3 = h
    after = [q0 * c - q1 * x - q2 * y - q3 * z, q0 * x + q1 * c + q2 * z - q3 * y]
    after += [q0 * y - q1 * z + q2 * c + q3 * x, q0 * z + q1 * y - q2 * x + q3 * c]
    axis, felt = sp.Matrix([q1, q2, q3]), sp.Matrix(a) - sp.Matrix(bias[3:])
    double = 2 * axis.cross(felt)
    pushed = felt + q0 * double + axis.cross(double)
    place = sp.Matrix(p) + sp.Matrix(v) * dt + pushed * dt**2 / 2
    inputs = {"h": h, "v": v, "p": p, "w": w, "a": a, "b": b}
    return model("inertial step", "preintegration", inputs, sp.Matrix(after), sp.Matrix(v) + pushed * dt, place)


def rotation_error() -> Model:
    """The rotation vector between two quaternions, and its derivatives by the first (as wrenfold's and SymForce's)."""
    a, b = symbols("a", 4), symbols("b", 4)
    w = sum(x * y for x, y in zip(a, b, strict=True))
    one, other = sp.Matrix(a[1:]), sp.Matrix(b[1:])
    axis = a[0] * other - b[0] * one - one.cross(other)
    length = sp.sqrt(axis.dot(axis))
    error = axis * (2 * sp.atan2(length, w) / length)
    return model("rotation error", "vector and Jacobian", {"a": a, "b": b}, error, error.jacobian(a))


def vehicle() -> Model:
    """A car with linear tyres and its linearisation, as for predictive control."""
    (x, y, yaw, vx, vy, r), (accel, steer), fixed = symbols("s", 6), symbols("u", 2), symbols("p", 6)
    m, I, lf, lr, cf, cr = fixed
    front = cf * (steer - sp.atan2(vy + lf * r, vx))
    rear = -cr * sp.atan2(vy - lr * r, vx)
    rates = sp.Matrix(
        [
            vx * sp.cos(yaw) - vy * sp.sin(yaw),
            vx * sp.sin(yaw) + vy * sp.cos(yaw),
            r,
            accel - front * sp.sin(steer) / m + vy * r,
            (front * sp.cos(steer) + rear) / m - vx * r,
            (lf * front * sp.cos(steer) - lr * rear) / I,
        ]
    )
    state = (x, y, yaw, vx, vy, r)
    by = rates.jacobian([*state, accel, steer])
    return model("vehicle", "state rates and Jacobian", {"s": state, "u": (accel, steer), "p": fixed}, rates, by)


def satellite() -> Model:
    """Acceleration in orbit with J2 and drag, and its gradient by the place."""
    place, speed, fixed = symbols("x", 3), symbols("v", 3), symbols("p", 4)
    mu, radius, j2, drag = fixed
    x, y, z = place
    r = sp.sqrt(x**2 + y**2 + z**2)
    k = sp.Rational(3, 2) * j2 * mu * radius**2 / r**5
    pull = [-mu * each / r**3 for each in place]
    flat = [k * x * (5 * z**2 / r**2 - 1), k * y * (5 * z**2 / r**2 - 1), k * z * (5 * z**2 / r**2 - 3)]
    fast = sp.sqrt(sum(each**2 for each in speed))
    felt = sp.Matrix([a + b - drag * fast * c for a, b, c in zip(pull, flat, speed, strict=True)])
    inputs = {"x": place, "v": speed, "p": fixed}
    return model("satellite", "acceleration and gradient", inputs, felt, felt.jacobian(place))


MODELS: Mapping[str, Callable[[], Model]] = {
    "cart_pendulum_2": lambda: cart_pendulum(2),
    "cart_pendulum_4": lambda: cart_pendulum(4),
    "cart_pendulum_6": lambda: cart_pendulum(6),
    "cart_pole_jacobian": cart_pendulum_jacobian,
    "arm_2r": two_links,
    "arm_3r": three_links,
    "ur5_kinematics": ur5_kinematics,
    "ur5_jacobian": ur5_jacobian,
    "ur5_mass_matrix": ur5_mass_matrix,
    "quadrotor": quadrotor,
    "springs": lambda: springs(10),
    "chain": lambda: chain_in_the_plane(30),
    "reprojection": reprojection,
    "inertial_step": inertial_step,
    "rotation_error": rotation_error,
    "vehicle": vehicle,
    "satellite": satellite,
    "whipple_bicycle": whipple_bicycle,
}

METHODS: Mapping[str, Callable[[], Any]] = {
    "cart_pendulum_2": lambda: n_link_pendulum_on_cart(2),
    "cart_pendulum_4": lambda: n_link_pendulum_on_cart(4),
    "cart_pendulum_6": lambda: n_link_pendulum_on_cart(6),
    "springs": lambda: multi_mass_spring_damper(6, True),
    "rolling_disc": lambda: of_test("test_kane", "test_rolling_disc"),
    "rolling_disc_constrained": lambda: of_test("test_kane5", "test_kane_rolling_disc_lu"),
}
