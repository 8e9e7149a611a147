"""Section 3: steps from frame to frame in homogeneous coordinates."""

from chasles.statements import Claim, Definition, Section
from chasles.vocabulary import Node, array, column, cos, matrix, sin

from .notation import a, alpha, d, l1, l2, one4, q1, q2, q3, r, theta

frame_section = Section("3", "Frames")

ca, sa, ct, st = cos(alpha), sin(alpha), cos(theta), sin(theta)
screw_z = matrix((ct, -st, 0, 0), (st, ct, 0, 0), (0, 0, 1, d), (0, 0, 0, 1))
screw_x = matrix((1, 0, 0, a), (0, ca, -sa, 0), (0, sa, ca, 0), (0, 0, 0, 1))
link = matrix((ct, -st * ca, st * sa, a * ct), (st, ct * ca, -ct * sa, a * st), (0, sa, ca, d), (0, 0, 0, 1))
back = matrix((ct, st, 0, -a), (-st * ca, ct * ca, sa, -d * sa), (st * sa, -ct * sa, ca, -d * ca), (0, 0, 0, 1))
A = array("A", "A", "the step along a link", link)
S = array("S", "S", "a screw along z", screw_z)
U = array("U", "U", "a screw along x", screw_x)

along_z = Definition("3.1", S, screw_z)
along_x = Definition("3.2", U, screw_x)
steps = (along_z, along_x)
step = Claim("3.3", S @ U, link, given=steps)
step_along_link = Definition("3.4", A, link)
step_back = Claim("3.5", A @ back, one4, given=(step_along_link,))
modified_step = Claim(
    "3.6",
    U @ S,
    matrix((ct, -st, 0, a), (st * ca, ct * ca, -sa, -d * sa), (st * sa, ct * sa, ca, d * ca), (0, 0, 0, 1)),
    given=steps,
)
screw_back = Claim("3.7", matrix((ct, st, 0, 0), (-st, ct, 0, 0), (0, 0, 1, -d), (0, 0, 0, 1)) @ S, one4, given=steps)


def _plane(angle: Node, length: Node) -> Node:
    return matrix(
        (cos(angle), -sin(angle), length * cos(angle)), (sin(angle), cos(angle), length * sin(angle)), (0, 0, 1)
    )


two_links = Claim(
    "3.8",
    _plane(q1, l1) @ _plane(q2, l2),
    matrix(
        (cos(q1 + q2), -sin(q1 + q2), l1 * cos(q1) + l2 * cos(q1 + q2)),
        (sin(q1 + q2), cos(q1 + q2), l1 * sin(q1) + l2 * sin(q1 + q2)),
        (0, 0, 1),
    ),
)
slider_on_a_turntable = Claim(
    "3.9",
    _plane(q1, l1) @ matrix((1, 0, r), (0, 1, l2), (0, 0, 1)),
    matrix(
        (cos(q1), -sin(q1), (l1 + r) * cos(q1) - l2 * sin(q1)),
        (sin(q1), cos(q1), (l1 + r) * sin(q1) + l2 * cos(q1)),
        (0, 0, 1),
    ),
)
arm_with_a_wrist = Claim(
    "3.10",
    matrix((cos(q1), 0, sin(q1), 0), (sin(q1), 0, -cos(q1), 0), (0, 1, 0, d), (0, 0, 0, 1))
    @ column(l1 * cos(q2), l1 * sin(q2), 0, 1),
    column(l1 * cos(q1) * cos(q2), l1 * sin(q1) * cos(q2), d + l1 * sin(q2), 1),
)
elbow = Claim(
    "3.11",
    matrix((cos(q1), 0, sin(q1), 0), (sin(q1), 0, -cos(q1), 0), (0, 1, 0, d), (0, 0, 0, 1))
    @ matrix((cos(q2), -sin(q2), 0, l1 * cos(q2)), (sin(q2), cos(q2), 0, l1 * sin(q2)), (0, 0, 1, 0), (0, 0, 0, 1)),
    matrix(
        (cos(q1) * cos(q2), -cos(q1) * sin(q2), sin(q1), l1 * cos(q1) * cos(q2)),
        (sin(q1) * cos(q2), -sin(q1) * sin(q2), -cos(q1), l1 * sin(q1) * cos(q2)),
        (sin(q2), cos(q2), 0, d + l1 * sin(q2)),
        (0, 0, 0, 1),
    ),
)
wrist = Claim(
    "3.12",
    matrix((cos(q1), 0, -sin(q1)), (sin(q1), 0, cos(q1)), (0, -1, 0))
    @ matrix((cos(q2), 0, sin(q2)), (sin(q2), 0, -cos(q2)), (0, 1, 0))
    @ matrix((cos(q3), -sin(q3), 0), (sin(q3), cos(q3), 0), (0, 0, 1)),
    matrix(
        (
            cos(q1) * cos(q2) * cos(q3) - sin(q1) * sin(q3),
            -cos(q1) * cos(q2) * sin(q3) - sin(q1) * cos(q3),
            cos(q1) * sin(q2),
        ),
        (
            sin(q1) * cos(q2) * cos(q3) + cos(q1) * sin(q3),
            -sin(q1) * cos(q2) * sin(q3) + cos(q1) * cos(q3),
            sin(q1) * sin(q2),
        ),
        (-sin(q2) * cos(q3), sin(q2) * sin(q3), cos(q2)),
    ),
)
