"""Section 4: Rodrigues parameters, Cayley's transform, modified Rodrigues parameters, composition."""

from chasles.rotations.notation import *
from chasles.rotations.s1_rotations import (
    Q_is_a_rotation,
    angular_velocity,
    angular_velocity_in_body,
    e_is_unit,
    rotation_about_axis,
)

from chasles.statements import Claim, Definition, Kernel, Section, nonzero
from chasles.vocabulary import CPM, Node, cos, cross, det, dot, inverse, number, over, paren, rate, sin, tan, tr, vect
from chasles.vocabulary.rotation_vectors import cayley

rodrigues_parameters_and_cayley = Section("4", "Rodrigues Parameters and Cayley's Transform")

G = CPM(g)
_square = 1 + dot(g, g)
g_square_is_no_pole, m_square_is_no_pole = nonzero(_square), nonzero(1 + dot(m, m))
no_half_turn = nonzero(cos(phi / 2))


def _modified(of: Node) -> Node:
    """The rotation by modified Rodrigues parameters."""
    return one + (4 * paren(1 - dot(of, of)) * CPM(of) + 8 * CPM(of) ** 2) / paren(1 + dot(of, of)) ** 2


rodrigues_parameters = Definition(
    "4.1",
    g, tan(phi / 2) * e,
    says="Rodrigues parameters, which a half-turn has not.",
    sign="=",
    assuming=(e_is_unit, no_half_turn),
    kernel=Kernel(of=(e, phi)),
)

rodrigues_parameters_by_euler_rodrigues_parameters = Claim(
    "4.2",
    g, paren(sin(phi / 2) * e) / cos(phi / 2),
    says="They are the ratios of the Euler-Rodrigues parameters.",
    given=(rodrigues_parameters,),
)

rotation_by_cayley = Claim(
    "4.3",
    (one - G) @ Q, one + G,
    says="The rotation is Cayley's transform of the cross-product matrix of the Rodrigues parameters.",
    given=(rotation_about_axis, rodrigues_parameters),
)

resolvent_of_cross_product_matrix = Claim(
    "4.4",
    inverse(one - G), (one + g @ g.T + G) / _square,
    says="The inverse in Cayley's transform; it exists for every vector.",
    assuming=(g_square_is_no_pole,),
)

determinant_in_cayley = Claim(
    "4.5",
    det(one - G), 1 + dot(g, g),
    says="The determinant of what is inverted is never less than one.",
)

cayley_in_closed_form = Claim(
    "4.6",
    cayley(CPM(g)), (paren(1 - dot(g, g)) * one + 2 * g @ g.T + 2 * G) / _square,
    says="Cayley's transform of a cross-product matrix, without an inverse.",
)

rotation_by_rodrigues_parameters = Definition(
    "4.7",
    Q, (paren(1 - dot(g, g)) * one + 2 * g @ g.T + 2 * G) / _square,
    says="The rotation by Rodrigues parameters, which are any three numbers.",
    sign="=",
    assuming=(g_square_is_no_pole,),
    kernel=Kernel(of=(g,)),
)

rotation_by_rodrigues_parameters_is_orthogonal = Claim(
    "4.8",
    Q.T @ Q, one,
    says="It is orthogonal.",
    given=(rotation_by_rodrigues_parameters,),
)

rotation_by_rodrigues_parameters_is_proper = Claim(
    "4.9",
    det(Q), number(1),
    says="And proper.",
    given=(rotation_by_rodrigues_parameters,),
)

rodrigues_parameters_stay = Claim(
    "4.10",
    Q @ g, g,
    says="The Rodrigues parameters lie along the axis.",
    given=(rotation_by_rodrigues_parameters,),
)

trace_by_rodrigues_parameters = Claim(
    "4.11",
    tr(Q), (3 - dot(g, g)) / _square,
    says="The trace by the Rodrigues parameters.",
    given=(rotation_by_rodrigues_parameters,),
)

axial_vector_by_rodrigues_parameters = Claim(
    "4.12",
    vect(Q), 2 * g / _square,
    says="The axial vector by the Rodrigues parameters.",
    given=(rotation_by_rodrigues_parameters,),
)

determinant_of_rotation_plus_one = Claim(
    "4.13",
    det(Q + one), 2 * (1 + tr(Q)),
    says="It vanishes at half-turns, and only there.",
    assuming=(Q_is_a_rotation,),
)

rodrigues_parameters_from_rotation = Claim(
    "4.14",
    g, 2 * vect(Q) / (1 + tr(Q)),
    says="The Rodrigues parameters from a rotation that is no half-turn.",
    given=(rotation_about_axis, rodrigues_parameters),
    assuming=(nonzero(1 + tr(Q)),),
    kernel=Kernel(of=(Q,), expected=(Q_is_a_rotation,)),
)

cayley_backwards = Claim(
    "4.15",
    G @ (Q + one), Q - one,
    says="Cayley's transform, solved for the cross-product matrix.",
    given=(rotation_by_rodrigues_parameters,),
)

cayley_of_transpose = Claim(
    "4.16",
    cayley(-G), cayley(G).T,
    says="The opposite parameters turn back.",
)

composed_rodrigues_parameters = Definition(
    "4.17",
    g_3, (g_1 + g_2 + cross(g_2, g_1)) / (1 - dot(g_1, g_2)),
    says="Rodrigues' composition: the parameters of a first rotation and then a second.",
    sign="=",
    assuming=(nonzero(1 - dot(g_1, g_2)),),
    kernel=Kernel(of=(g_1, g_2)),
)

rotation_by_composed_parameters = Claim(
    "4.18",
    paren(paren(1 - dot(g_2, g_2)) * one + 2 * g_2 @ g_2.T + 2 * CPM(g_2))
    @ paren(paren(1 - dot(g_1, g_1)) * one + 2 * g_1 @ g_1.T + 2 * CPM(g_1)),
    paren(1 - dot(g_1, g_2)) ** 2
    * paren(paren(1 - dot(g_3, g_3)) * one + 2 * g_3 @ g_3.T + 2 * CPM(g_3)),
    says="The rotations by the parameters multiply as Rodrigues' composition says, but for common factors.",
    given=(composed_rodrigues_parameters,),
)

length_of_composed_parameters = Claim(
    "4.19",
    (1 + dot(g_1, g_1)) * (1 + dot(g_2, g_2)), (1 - dot(g_1, g_2)) ** 2 * (1 + dot(g_3, g_3)),
    says="The common factors agree.",
    given=(composed_rodrigues_parameters,),
)

rate_of_rodrigues_parameters = Claim(
    "4.20",
    rate(g), over(1, 2) * (one - G + g @ g.T) @ omega,
    says="The rate of the Rodrigues parameters by the angular velocity in the fixed frame.",
    given=(angular_velocity, rotation_by_rodrigues_parameters),
    kernel=Kernel(of=(g, omega)),
)

rate_of_rodrigues_parameters_in_body = Claim(
    "4.21",
    rate(g), over(1, 2) * (one + G + g @ g.T) @ omega_body,
    says="The rate of the Rodrigues parameters by the angular velocity in the frame of the body.",
    given=(angular_velocity_in_body, rotation_by_rodrigues_parameters),
    kernel=Kernel(of=(g, omega_body)),
)

angular_velocity_by_rodrigues_parameters = Claim(
    "4.22",
    omega, 2 / _square * (rate(g) + cross(g, rate(g))),
    says="The angular velocity in the fixed frame from the rate of the Rodrigues parameters.",
    given=(angular_velocity, rotation_by_rodrigues_parameters),
    kernel=Kernel(of=(g, rate(g))),
)

modified_rodrigues_parameters = Definition(
    "4.23",
    m, tan(phi / 4) * e,
    says="Modified Rodrigues parameters, which whole turns have not.",
    sign="=",
    assuming=(e_is_unit, nonzero(cos(phi / 4))),
    kernel=Kernel(of=(e, phi)),
)

rotation_by_modified_rodrigues_parameters = Definition(
    "4.24",
    Q, _modified(m),
    says="The rotation by the modified parameters.",
    sign="=",
    assuming=(m_square_is_no_pole,),
    kernel=Kernel(of=(m,)),
)

modified_rodrigues_parameters_of_axis_and_angle = Claim(
    "4.24",
    _modified(m), e @ e.T + cos(phi) * (one - e @ e.T) + sin(phi) * E,
    part=2,
    says="It is the rotation about the axis through the angle.",
    given=(modified_rodrigues_parameters,),
    assuming=(nonzero(cos(phi / 4)), m_square_is_no_pole),
)

shadow_of_modified_rodrigues_parameters = Definition(
    "4.25",
    m_2, -m / dot(m, m),
    says="The other modified parameters of the same rotation.",
    sign="=",
    assuming=(nonzero(dot(m, m)),),
    kernel=Kernel(of=(m,)),
)

rotation_by_shadow_parameters = Claim(
    "4.25",
    _modified(m_2), _modified(m),
    part=2,
    says="Each rotation has two sets of modified parameters, a whole turn apart.",
    given=(shadow_of_modified_rodrigues_parameters,),
    assuming=(nonzero(dot(m, m)), m_square_is_no_pole, nonzero(1 + dot(m_2, m_2))),
)

square_of_cayley = Claim(
    "4.26",
    _modified(m), cayley(CPM(m)) @ cayley(CPM(m)),
    says="The modified parameters are those of half the rotation, applied twice.",
)

rate_of_modified_rodrigues_parameters = Claim(
    "4.27",
    rate(m), over(1, 4) * (paren(1 - dot(m, m)) * one - 2 * CPM(m) + 2 * m @ m.T) @ omega,
    says="The rate of the modified parameters by the angular velocity in the fixed frame.",
    given=(angular_velocity, rotation_by_modified_rodrigues_parameters),
    kernel=Kernel(of=(m, omega)),
)
