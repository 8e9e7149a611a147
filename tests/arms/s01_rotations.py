"""Section 1: turns about the coordinate axes, Euler angles, axis and angle."""

from chasles.statements import Claim, Definition, Section, nonzero, unit_column
from chasles.vocabulary import CPM, column, cos, det, matrix, number, paren, rate, sin, tr, vect

from .notation import (
    R,
    V,
    X,
    Y,
    Z,
    alpha,
    beta,
    cf,
    cp,
    ct,
    n,
    n1,
    n2,
    n3,
    one,
    phi,
    psi,
    sf,
    sp,
    st,
    theta,
)

rotation_section = Section("1", "Rotations")

turn_x = Definition("1.1", X, matrix((1, 0, 0), (0, cf, -sf), (0, sf, cf)))
turn_y = Definition("1.2", Y, matrix((ct, 0, st), (0, 1, 0), (-st, 0, ct)))
turn_z = Definition("1.3", Z, matrix((cp, -sp, 0), (sp, cp, 0), (0, 0, 1)))
turns = (turn_x, turn_y, turn_z)

transposed_turn = Claim("1.4", X.T, matrix((1, 0, 0), (0, cf, sf), (0, -sf, cf)), given=turns)
sum_of_angles = Claim(
    "1.5",
    matrix((cos(alpha), -sin(alpha)), (sin(alpha), cos(alpha)))
    @ matrix((cos(beta), -sin(beta)), (sin(beta), cos(beta))),
    matrix((cos(alpha + beta), -sin(alpha + beta)), (sin(alpha + beta), cos(alpha + beta))),
)
roll_pitch_yaw = Claim(
    "1.6",
    Z @ Y @ X,
    matrix(
        (cp * ct, cp * st * sf - sp * cf, cp * st * cf + sp * sf),
        (sp * ct, sp * st * sf + cp * cf, sp * st * cf - cp * sf),
        (-st, ct * sf, ct * cf),
    ),
    given=turns,
)
fixed_axes = Claim(
    "1.7",
    X @ Y @ Z,
    matrix(
        (ct * cp, -ct * sp, st),
        (cf * sp + sf * st * cp, cf * cp - sf * st * sp, -sf * ct),
        (sf * sp - cf * st * cp, sf * cp + cf * st * sp, cf * ct),
    ),
    given=turns,
)
turned_about_z_x_z = Claim(
    "1.8",
    matrix((cf, -sf, 0), (sf, cf, 0), (0, 0, 1)) @ matrix((1, 0, 0), (0, ct, -st), (0, st, ct)) @ Z,
    matrix(
        (cf * cp - sf * ct * sp, -cf * sp - sf * ct * cp, sf * st),
        (sf * cp + cf * ct * sp, -sf * sp + cf * ct * cp, -cf * st),
        (st * sp, st * cp, ct),
    ),
    given=turns,
)
turned_about_z_y_z = Claim(
    "1.9",
    matrix((cf, -sf, 0), (sf, cf, 0), (0, 0, 1)) @ Y @ Z,
    matrix(
        (cf * ct * cp - sf * sp, -cf * ct * sp - sf * cp, cf * st),
        (sf * ct * cp + cf * sp, -sf * ct * sp + cf * cp, sf * st),
        (-st * cp, st * sp, ct),
    ),
    given=turns,
)
euler_angles = Definition("1.10", V, Z @ Y @ X, given=turns)
trace_of_euler_angles = Claim("1.11", tr(V), cp * ct + sp * st * sf + cp * cf + ct * cf, given=(*turns, euler_angles))
rate_of_turn = Claim(
    "1.12",
    rate(Z),
    rate(psi) * matrix((-sp, -cp, 0), (cp, -sp, 0), (0, 0, 0)),
    given=turns,
)
rate_of_turn_x = Claim("1.13", rate(X), CPM(column(rate(phi), 0, 0)) @ X, given=turns)
angular_velocity_in_the_base = Claim(
    "1.14",
    rate(V) @ V.T,
    CPM(matrix((cp * ct, -sp, 0), (sp * ct, cp, 0), (-st, 0, 1)) @ column(rate(phi), rate(theta), rate(psi))),
    given=(*turns, euler_angles),
)
angular_velocity_in_the_body = Claim(
    "1.15",
    V.T @ rate(V),
    CPM(
        column(
            rate(phi) - st * rate(psi), cf * rate(theta) + sf * ct * rate(psi), cf * ct * rate(psi) - sf * rate(theta)
        )
    ),
    given=(*turns, euler_angles),
)
rates_of_euler_angles = Claim(
    "1.16",
    matrix((1, sf * st / ct, cf * st / ct), (0, cf, -sf), (0, sf / ct, cf / ct))
    @ matrix((1, 0, -st), (0, cf, sf * ct), (0, -sf, cf * ct)),
    one,
    assuming=(nonzero(ct),),
)
axis = Definition("1.17", n, column(n1, n2, n3))
is_unit = (unit_column(n1, n2, n3),)
vers = paren(1 - cf)
turn_about_an_axis = Definition(
    "1.18",
    R,
    matrix(
        (cf + n1**2 * vers, n1 * n2 * vers - n3 * sf, n1 * n3 * vers + n2 * sf),
        (n2 * n1 * vers + n3 * sf, cf + n2**2 * vers, n2 * n3 * vers - n1 * sf),
        (n3 * n1 * vers - n2 * sf, n3 * n2 * vers + n1 * sf, cf + n3**2 * vers),
    ),
    assuming=is_unit,
)
about = (axis, turn_about_an_axis)
entries_of_a_rotation = Claim(
    "1.19",
    cf * one + sf * CPM(n) + vers * n @ n.T,
    matrix(
        (cf + n1**2 * vers, n1 * n2 * vers - n3 * sf, n1 * n3 * vers + n2 * sf),
        (n2 * n1 * vers + n3 * sf, cf + n2**2 * vers, n2 * n3 * vers - n1 * sf),
        (n3 * n1 * vers - n2 * sf, n3 * n2 * vers + n1 * sf, cf + n3**2 * vers),
    ),
    given=(axis,),
)
axis_of_the_matrix = Claim("1.20", vect(R), sf * column(n1, n2, n3), given=about)
trace_of_a_rotation = Claim("1.21", tr(R), 1 + 2 * cf, given=about, assuming=is_unit)
cross_product_matrix = Claim("1.22", CPM(n), matrix((0, -n3, n2), (n3, 0, -n1), (-n2, n1, 0)), given=(axis,))
square_of_cross_product_matrix = Claim(
    "1.23",
    CPM(n) @ CPM(n),
    matrix(
        (-(n2**2) - n3**2, n1 * n2, n1 * n3), (n1 * n2, -(n1**2) - n3**2, n2 * n3), (n1 * n3, n2 * n3, -(n1**2) - n2**2)
    ),
    given=(axis,),
)
mirror = Claim(
    "1.24",
    det(
        matrix(
            (1 - 2 * n1**2, -2 * n1 * n2, -2 * n1 * n3),
            (-2 * n1 * n2, 1 - 2 * n2**2, -2 * n2 * n3),
            (-2 * n1 * n3, -2 * n2 * n3, 1 - 2 * n3**2),
        )
    ),
    number(-1),
    assuming=is_unit,
)
