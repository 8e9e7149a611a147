"""Exercise 3.10: rotations by Euler angles, their rates and the angular velocity, for all twelve sequences of axes.

Each turn is about an axis of the body as the turns before have left it; the angles come in the order of the turns.
"""

from chasles.derivations.notation import Q, omega, one, unit_columns

from chasles.statements import Claim, Condition, Definition, Kernel, Section, Stack, nonzero
from chasles.statements.statement import Statement
from chasles.vocabulary import (
    CPM,
    FREQUENCY,
    Block,
    Node,
    column,
    cos,
    det,
    dot,
    inverse,
    matrix,
    over,
    rate,
    row,
    scalar,
    sin,
    square,
    vector,
)

exercises = Section("3.9", "Exercises")

theta_1, theta_2, theta_3 = (scalar(f"theta_{k}", rf"\theta_{k}", f"Euler angle {k}") for k in (1, 2, 3))
theta = scalar("theta", r"\theta", "angle of an elementary rotation")
rates = vector("theta_dot", r"\dot{\boldsymbol{\theta}}", "rates of the Euler angles", FREQUENCY)
W = square("W", "W", "angular velocity in the fixed frame from the rates of the Euler angles")
W_body = square("W_body", r"\mathbf{W}_{\mathcal{M}}", "angular velocity in the body frame from those rates")
second_axis = vector("k_2", r"\mathbf{k}_2", "axis of the second turn, as the first has left it")
third_axis = vector("k_3", r"\mathbf{k}_3", "unit vector at right angles to the axes of the first two turns")
angles = Stack("angles", (theta_1, theta_2, theta_3), "Euler angles, in the order of the turns")

SEQUENCES = tuple(f"{i}{j}{k}" for i in "xyz" for j in "xyz" for k in "xyz" if i != j != k)
AXES = dict(zip("xyz", unit_columns, strict=True))
SAID_OF_EACH = 12
_parts = iter(range(1, 2 + len(AXES) + SAID_OF_EACH * len(SEQUENCES)))


def _turn(axis: str, angle: Node) -> Block:
    """The elementary rotation about a coordinate axis."""
    c, s = cos(angle), sin(angle)
    rows: dict[str, tuple[tuple[Node | int, ...], ...]] = {
        "x": ((1, 0, 0), (0, c, -s), (0, s, c)),
        "y": ((c, 0, s), (0, 1, 0), (-s, 0, c)),
        "z": ((c, -s, 0), (s, c, 0), (0, 0, 1)),
    }
    return matrix(*rows[axis])


def _elementary(axis: str) -> Claim:
    u = AXES[axis]
    return Claim(
        "Ex 3.10",
        _turn(axis, theta), u @ u.T + cos(theta) * (one - u @ u.T) + sin(theta) * CPM(u),
        part=next(_parts),
        says=f"The elementary rotation about {axis} is the rotation about that axis.",
    )


rates_of_the_angles = Definition(
    "Ex 3.10",
    rates, column(rate(theta_1), rate(theta_2), rate(theta_3)),
    part=next(_parts),
    says="The rates of the Euler angles.",
)

elementary_rotations = {f"elementary_rotation_{axis}": _elementary(axis) for axis in "xyz"}


def _left_out(first: str, second: str) -> str:
    """The axis that is neither."""
    return next(axis for axis in "xyz" if axis not in (first, second))


def _signed(node: Node, *axes: str) -> Node:
    """The node, or its opposite where the three axes in this order are left-handed."""
    return node if "".join(axes) in "xyzxy" else -node


def _rotation(sequence: str) -> Definition:
    first, second, third = (_turn(axis, angle) for axis, angle in zip(sequence, angles.parts, strict=True))
    return Definition(
        "Ex 3.10",
        Q, first @ second @ third,
        part=next(_parts),
        says=f"The rotation by Euler angles about {', '.join(sequence)}.",
        sign="=",
        kernel=Kernel(of=(angles,)),
    )


def _rate_matrix(sequence: str) -> Definition:
    """The axes of the turns as the turns before have left them."""
    first, second, _ = (_turn(axis, angle) for axis, angle in zip(sequence, angles.parts, strict=True))
    i, j, k = (AXES[axis] for axis in sequence)
    return Definition(
        "Ex 3.10",
        W, row(i, first @ j, first @ second @ k),
        part=next(_parts),
        says=f"The angular velocity, in the fixed frame, from the rates of Euler angles about {', '.join(sequence)}.",
        kernel=Kernel(of=(angles,)),
    )


def _rate_matrix_in_body(sequence: str) -> Definition:
    """The axes of the turns as the body sees them, which the turns after move."""
    _, second, third = (_turn(axis, angle) for axis, angle in zip(sequence, angles.parts, strict=True))
    i, j, k = (AXES[axis] for axis in sequence)
    return Definition(
        "Ex 3.10",
        W_body, row(third.T @ second.T @ i, third.T @ j, k),
        part=next(_parts),
        says=f"The angular velocity, in the body frame, from the rates of Euler angles about {', '.join(sequence)}.",
        kernel=Kernel(of=(angles,)),
    )


def _rates_of_rotation(sequence: str, rotation: Definition, fixed: Definition, body: Definition) -> tuple[Claim, Claim]:
    """The matrices give the angular velocity of the rotation, in either frame."""
    said = f"for Euler angles about {', '.join(sequence)}"
    return (
        Claim(
            "Ex 3.10",
            rate(Q), CPM(W @ rates) @ Q,
            part=next(_parts),
            says=f"The rate of the rotation by the angular velocity in the fixed frame, {said}.",
            given=(rotation, fixed, rates_of_the_angles),
        ),
        Claim(
            "Ex 3.10",
            Q.T @ rate(Q), CPM(W_body @ rates),
            part=next(_parts),
            says=f"The rate of the rotation by the angular velocity in the body frame, {said}.",
            given=(rotation, body, rates_of_the_angles),
        ),
    )


def _determinants(sequence: str, fixed: Definition, body: Definition) -> tuple[Claim, Claim]:
    """Where either matrix is singular."""
    i, j, k = tuple(sequence)
    value = -sin(theta_2) if i == k else _signed(cos(theta_2), i, j, k)
    said = f"for Euler angles about {i}, {j}, {k}"
    return (
        Claim(
            "Ex 3.10",
            det(W), value,
            part=next(_parts),
            says=f"The matrix of the fixed frame is singular where this vanishes, and only there, {said}.",
            given=(fixed,),
        ),
        Claim(
            "Ex 3.10",
            det(W_body), value,
            part=next(_parts),
            says=f"The matrix of the body frame is singular where this vanishes, and only there, {said}.",
            given=(body,),
        ),
    )


def _axes(sequence: str) -> tuple[Definition, Definition]:
    """Two axes that the first turn moves."""
    i, j, _ = tuple(sequence)
    turned = _turn(i, theta_1)
    return (
        Definition(
            "Ex 3.10",
            second_axis, turned @ AXES[j],
            part=next(_parts),
            says=f"The axis {j}, turned about {i}.",
        ),
        Definition(
            "Ex 3.10",
            third_axis, turned @ AXES[_left_out(i, j)],
            part=next(_parts),
            says=f"The axis that is neither {i} nor {j}, turned about {i}.",
        ),
    )


def _solved(
    sequence: str, fixed: Definition, second: Definition, third: Definition
) -> tuple[Condition, Claim, Claim]:
    """The rates are components along the first axis and along two more, at right angles, that the first turn moves."""
    i, j, k = tuple(sequence)
    first, across = AXES[i], _signed(third_axis, i, _left_out(i, j), j) if i == k else third_axis
    lever, share = (sin(theta_2), cos(theta_2)) if i == k else (cos(theta_2), _signed(sin(theta_2), i, j, k))
    third_rate, third_row = dot(across, omega) / lever, over(1, lever) * across.T
    said = f"Euler angles about {i}, {j}, {k}"
    equations = Condition(
        "Ex 3.10",
        omega, W @ rates,
        part=next(_parts),
        says=f"The rates of {said} that go with an angular velocity.",
        given=(fixed,),
        on=(rates,),
    )
    return (
        equations,
        Claim(
            "Ex 3.10",
            inverse(W), column(first.T - share * third_row, second_axis.T, third_row),
            part=next(_parts),
            says=f"The inverse of the matrix for {said}.",
            given=(fixed, second, third),
            assuming=(nonzero(lever),),
        ),
        Claim(
            "Ex 3.10",
            rates, column(dot(first, omega) - share * third_rate, dot(second_axis, omega), third_rate),
            part=next(_parts),
            says=f"The rates of {said} from the angular velocity in the fixed frame.",
            given=(equations, fixed, second, third),
            assuming=(nonzero(lever),),
            kernel=Kernel(of=(angles, omega)),
        ),
    )


def _statements(sequence: str) -> dict[str, Statement]:
    """What is said of one sequence of axes, by name."""
    rotation, fixed, body = _rotation(sequence), _rate_matrix(sequence), _rate_matrix_in_body(sequence)
    in_fixed, in_body = _rates_of_rotation(sequence, rotation, fixed, body)
    determinant, determinant_in_body = _determinants(sequence, fixed, body)
    second, third = _axes(sequence)
    equations, inverted, rates_of_sequence = _solved(sequence, fixed, second, third)
    return {
        f"rotation_from_euler_{sequence}": rotation,
        f"euler_rate_matrix_{sequence}": fixed,
        f"euler_rate_matrix_body_{sequence}": body,
        f"rate_of_rotation_by_euler_{sequence}": in_fixed,
        f"rate_of_rotation_by_euler_{sequence}_in_body_frame": in_body,
        f"determinant_of_euler_rate_matrix_{sequence}": determinant,
        f"determinant_of_euler_rate_matrix_body_{sequence}": determinant_in_body,
        f"second_axis_of_euler_{sequence}": second,
        f"third_axis_of_euler_{sequence}": third,
        f"angular_velocity_from_euler_rates_{sequence}": equations,
        f"inverse_of_euler_rate_matrix_{sequence}": inverted,
        f"euler_rates_{sequence}": rates_of_sequence,
    }


euler_angles = {name: said for sequence in SEQUENCES for name, said in _statements(sequence).items()}
