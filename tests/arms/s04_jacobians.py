"""Section 4: positions of arms, and their rates as matrices times the rates of the joints."""

from chasles.statements import Claim, Definition, Section
from chasles.vocabulary import LENGTH, array, column, cos, det, matrix, rate, row, sin, uniform

from .notation import Z, d, l1, l2, l3, p, phi, psi, q1, q2, q3, r, s, theta, z
from .s01_rotations import turn_z

jacobian_section = Section("4", "Jacobians")

s1, c1, s12, c12 = sin(q1), cos(q1), sin(q1 + q2), cos(q1 + q2)
s123, c123 = sin(q1 + q2 + q3), cos(q1 + q2 + q3)
b = array("b", "b", "the end of three links", uniform((2, 1), LENGTH))
u = array("u", "u", "a point in cylindrical coordinates", uniform((3, 1), LENGTH))
g = array("g", "g", "the end of an arm with an elbow", uniform((3, 1), LENGTH))

end_of_two_links = Definition("4.1", p, column(l1 * c1 + l2 * c12, l1 * s1 + l2 * s12))
velocity_of_two_links = Claim(
    "4.2",
    rate(p),
    matrix((-l1 * s1 - l2 * s12, -l2 * s12), (l1 * c1 + l2 * c12, l2 * c12)) @ column(rate(q1), rate(q2)),
    given=(end_of_two_links,),
)
singular_elbow = Claim(
    "4.3",
    det(matrix((-l1 * s1 - l2 * s12, -l2 * s12), (l1 * c1 + l2 * c12, l2 * c12))),
    l1 * l2 * sin(q2),
)
rates_of_joints = Claim(
    "4.4",
    matrix((l2 * c12, l2 * s12), (-l1 * c1 - l2 * c12, -l1 * s1 - l2 * s12))
    @ matrix((-l1 * s1 - l2 * s12, -l2 * s12), (l1 * c1 + l2 * c12, l2 * c12)),
    matrix((l1 * l2 * sin(q2), 0), (0, l1 * l2 * sin(q2))),
)
speed_of_two_links = Claim(
    "4.5",
    rate(p).T @ rate(p),
    l1**2 * rate(q1) ** 2
    + l2**2 * (rate(q1) + rate(q2)) ** 2
    + 2 * l1 * l2 * cos(q2) * rate(q1) * (rate(q1) + rate(q2)),
    given=(end_of_two_links,),
)
end_of_three_links = Definition("4.6", b, column(l1 * c1 + l2 * c12 + l3 * c123, l1 * s1 + l2 * s12 + l3 * s123))
velocity_of_three_links = Claim(
    "4.7",
    rate(b),
    matrix(
        (-l1 * s1 - l2 * s12 - l3 * s123, -l2 * s12 - l3 * s123, -l3 * s123),
        (l1 * c1 + l2 * c12 + l3 * c123, l2 * c12 + l3 * c123, l3 * c123),
    )
    @ column(rate(q1), rate(q2), rate(q3)),
    given=(end_of_three_links,),
)
column_of_last_joint = Claim("4.8", l3 * matrix((0, -1), (1, 0)) @ column(c123, s123), column(-l3 * s123, l3 * c123))
cylindrical_point = Definition("4.9", u, column(r * cos(phi), r * sin(phi), z))
velocity_of_cylindrical_point = Claim(
    "4.10",
    rate(u),
    matrix((cos(phi), -r * sin(phi), 0), (sin(phi), r * cos(phi), 0), (0, 0, 1)) @ column(rate(r), rate(phi), rate(z)),
    given=(cylindrical_point,),
)
spherical_point = Definition("4.11", s, column(r * sin(theta) * cos(phi), r * sin(theta) * sin(phi), r * cos(theta)))
velocity_of_spherical_point = Claim(
    "4.12",
    rate(s),
    matrix(
        (sin(theta) * cos(phi), r * cos(theta) * cos(phi), -r * sin(theta) * sin(phi)),
        (sin(theta) * sin(phi), r * cos(theta) * sin(phi), r * sin(theta) * cos(phi)),
        (cos(theta), -r * sin(theta), 0),
    )
    @ column(rate(r), rate(theta), rate(phi)),
    given=(spherical_point,),
)
volume_of_spherical_coordinates = Claim(
    "4.13",
    det(
        matrix(
            (sin(theta) * cos(phi), r * cos(theta) * cos(phi), -r * sin(theta) * sin(phi)),
            (sin(theta) * sin(phi), r * cos(theta) * sin(phi), r * sin(theta) * cos(phi)),
            (cos(theta), -r * sin(theta), 0),
        )
    ),
    r**2 * sin(theta),
)
end_of_elbow_arm = Definition(
    "4.14",
    g,
    column(
        cos(q1) * (l1 * cos(q2) + l2 * cos(q2 + q3)),
        sin(q1) * (l1 * cos(q2) + l2 * cos(q2 + q3)),
        d + l1 * sin(q2) + l2 * sin(q2 + q3),
    ),
)
velocity_of_elbow_arm = Claim(
    "4.15",
    rate(g),
    matrix(
        (
            -s1 * (l1 * cos(q2) + l2 * cos(q2 + q3)),
            -c1 * (l1 * sin(q2) + l2 * sin(q2 + q3)),
            -l2 * c1 * sin(q2 + q3),
        ),
        (
            c1 * (l1 * cos(q2) + l2 * cos(q2 + q3)),
            -s1 * (l1 * sin(q2) + l2 * sin(q2 + q3)),
            -l2 * s1 * sin(q2 + q3),
        ),
        (0, l1 * cos(q2) + l2 * cos(q2 + q3), l2 * cos(q2 + q3)),
    )
    @ column(rate(q1), rate(q2), rate(q3)),
    given=(end_of_elbow_arm,),
)
velocity_on_a_turntable = Claim(
    "4.16",
    rate(Z @ column(r, 0, z)),
    column(
        rate(r) * cos(psi) - r * rate(psi) * sin(psi),
        rate(r) * sin(psi) + r * rate(psi) * cos(psi),
        rate(z),
    ),
    given=(turn_z,),
)
acceleration_on_a_circle = Claim(
    "4.17",
    rate(rate(column(l1 * c1, l1 * s1))),
    column(-l1 * rate(q1) ** 2 * c1 - l1 * rate(rate(q1)) * s1, -l1 * rate(q1) ** 2 * s1 + l1 * rate(rate(q1)) * c1),
)
moment_of_a_force = Claim(
    "4.18",
    row(-s1, c1) @ matrix((-l1 * s1 - l2 * s12, -l2 * s12), (l1 * c1 + l2 * c12, l2 * c12)),
    row(l1 + l2 * cos(q2), l2 * cos(q2)),
)
